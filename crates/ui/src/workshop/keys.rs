//! The keys of the workshop. They hold wherever nothing is typed.

use antipode_language::Texts;
use egui::{Event, Key, Modifiers, PointerButton, Ui};

use super::model::{ToolChoice, ViewSide, WorkshopModel, WorkshopWish};

/// A key and what it does.
#[derive(Clone, Copy, Debug)]
pub struct Shortcut {
    /// What it does, as buttons call it.
    pub id: &'static str,
    /// What is held with it.
    pub held: Modifiers,
    /// The key.
    pub key: Key,
}

const fn plain(id: &'static str, key: Key) -> Shortcut {
    Shortcut {
        id,
        held: Modifiers::NONE,
        key,
    }
}

const fn with_ctrl(id: &'static str, key: Key) -> Shortcut {
    Shortcut {
        id,
        held: Modifiers::COMMAND,
        key,
    }
}

/// All of them. Those with more held come first, since a key by itself is met by any.
pub const SHORTCUTS: &[Shortcut] = &[
    Shortcut {
        id: "redo",
        held: Modifiers {
            shift: true,
            ..Modifiers::COMMAND
        },
        key: Key::Z,
    },
    Shortcut {
        id: "ungroup",
        held: Modifiers {
            shift: true,
            ..Modifiers::COMMAND
        },
        key: Key::G,
    },
    with_ctrl("undo", Key::Z),
    with_ctrl("redo", Key::Y),
    with_ctrl("duplicate", Key::D),
    with_ctrl("group", Key::G),
    with_ctrl("choose-all", Key::A),
    with_ctrl("array", Key::R),
    with_ctrl("from-file", Key::O),
    with_ctrl("keep", Key::S),
    plain("move", Key::Num1),
    plain("turn", Key::Num2),
    plain("scale", Key::Num3),
    plain("own-axes", Key::X),
    plain("snaps", Key::N),
    plain("on-surfaces", Key::G),
    plain("focus", Key::F),
    plain("top", Key::Num7),
    plain("front", Key::Num8),
    plain("side", Key::Num9),
    plain("parallel", Key::Num0),
    plain("walls", Key::H),
    plain("flies", Key::V),
    plain("raster", Key::B),
    plain("delete", Key::Delete),
];

/// The key that does something, in words.
pub(super) fn shortcut_label(texts: &Texts, id: &str) -> Option<String> {
    let event = match id {
        "copy" => Some(Key::C),
        "cut" => Some(Key::X),
        "paste" => Some(Key::V),
        _ => None,
    };
    let known = match event {
        Some(key) => with_ctrl("", key),
        None => *SHORTCUTS.iter().find(|it| it.id == id)?,
    };
    let mut said = String::new();
    for (held, word) in [
        (known.held.command, "workshop-key-ctrl"),
        (known.held.shift, "workshop-key-shift"),
    ] {
        if held {
            said.push_str(&texts.say(word));
            said.push_str(" + ");
        }
    }
    said.push_str(&name_of(texts, known.key));
    Some(said)
}

/// What stands on a key, in the language of the keyboard where that has words.
fn name_of(texts: &Texts, key: Key) -> String {
    match key {
        Key::Delete => texts.say("key-Delete"),
        Key::PageUp => texts.say("key-PageUp"),
        Key::PageDown => texts.say("key-PageDown"),
        other => other.name().to_owned(),
    }
}

/// All that keys do in the workshop, a line for each.
pub(crate) fn told_keys(texts: &Texts) -> Vec<String> {
    let mut ids = vec!["copy", "cut", "paste"];
    for shortcut in SHORTCUTS {
        if !ids.contains(&shortcut.id) {
            ids.push(shortcut.id);
        }
    }
    let line = |id: &str| {
        let label = texts.say(&format!("workshop-do-{id}"));
        Some(format!("{label}: {}", shortcut_label(texts, id)?))
    };
    ids.into_iter().filter_map(line).collect()
}

/// What was held when the first button was pressed or let go in this pass, since a slow frame is late; what is held now where it
/// was not.
pub(super) fn held_with_button(ui: &Ui) -> Modifiers {
    ui.input(|input| {
        let events = input.events.iter().rev();
        let mut of_button = events.filter_map(|event| match event {
            Event::PointerButton {
                button: PointerButton::Primary,
                modifiers,
                ..
            } => Some(*modifiers),
            _ => None,
        });
        of_button.next().unwrap_or(input.modifiers)
    })
}

/// Whether what keys ask for in this pass comes after what a button of the pointer does.
pub(super) fn come_after_button(ui: &Ui) -> bool {
    let is_key = |event: &Event| {
        let is_pressed = matches!(event, Event::Key { pressed: true, .. });
        is_pressed || matches!(event, Event::Copy | Event::Cut | Event::Paste(_))
    };
    ui.input(|input| {
        let key = input.events.iter().position(is_key);
        let is_button = |it: &Event| matches!(it, Event::PointerButton { .. });
        let button = input.events.iter().position(is_button);
        matches!((button, key), (Some(button), Some(key)) if button < key)
    })
}

/// What keys ask for in this pass.
pub(super) fn read(
    ui: &Ui,
    model: &WorkshopModel<'_>,
    is_naming: bool,
    wishes: &mut Vec<WorkshopWish>,
) {
    let context = ui.ctx();
    if is_naming || context.text_edit_focused() {
        return;
    }
    let mut takes = false;
    context.input(|input| {
        for event in &input.events {
            takes |= matches!(event, Event::Copy | Event::Cut);
            match event {
                Event::Copy => wishes.push(WorkshopWish::Copy),
                Event::Cut => wishes.push(WorkshopWish::Cut),
                Event::Paste(_) => wishes.push(WorkshopWish::Paste),
                _ => {}
            }
        }
    });
    // Ctrl+V is told only while the system's clipboard holds some text: it gets the names of what is taken.
    let chosen = model.objects.iter().filter(|it| it.selected);
    let names: Vec<_> = chosen.map(|it| it.name.as_str()).collect();
    if takes && !names.is_empty() {
        context.copy_text(names.join("\n"));
    }
    let is_flying = model.bar.flies
        || context.input(|input| input.pointer.button_down(PointerButton::Secondary));
    for shortcut in SHORTCUTS {
        let is_letter = shortcut.held == Modifiers::NONE && shortcut.id != "flies";
        if is_flying && is_letter {
            continue;
        }
        let pressed = context.input_mut(|input| input.consume_key(shortcut.held, shortcut.key));
        if pressed && let Some(wish) = wish_of(shortcut.id, model) {
            wishes.push(wish);
        }
    }
}

fn wish_of(id: &str, model: &WorkshopModel<'_>) -> Option<WorkshopWish> {
    let bar = model.bar;
    Some(match id {
        "undo" => WorkshopWish::Undo,
        "redo" => WorkshopWish::Redo,
        "duplicate" => WorkshopWish::Duplicate,
        "group" => WorkshopWish::Group,
        "ungroup" => WorkshopWish::Ungroup,
        "choose-all" => WorkshopWish::ChooseAll(true),
        "array" if bar.has_chosen => WorkshopWish::AskArray,
        "from-file" => WorkshopWish::ChooseFile,
        "keep" => WorkshopWish::Keep,
        "move" => WorkshopWish::Tool(ToolChoice::Move),
        "turn" => WorkshopWish::Tool(ToolChoice::Turn),
        "scale" => WorkshopWish::Tool(ToolChoice::Scale),
        "own-axes" => WorkshopWish::OwnAxes(!bar.own_axes),
        "snaps" => WorkshopWish::Snaps(!bar.snaps),
        "on-surfaces" => WorkshopWish::OnSurfaces(!bar.on_surfaces),
        "focus" => WorkshopWish::Focus,
        "top" => WorkshopWish::Face(ViewSide::Top),
        "front" => WorkshopWish::Face(ViewSide::Front),
        "side" => WorkshopWish::Face(ViewSide::Side),
        "parallel" => WorkshopWish::Parallel(!bar.parallel),
        "walls" => WorkshopWish::HideWalls(!bar.hides_walls),
        "flies" => WorkshopWish::Flies(!bar.flies),
        "raster" => WorkshopWish::Raster(!bar.raster),
        "delete" => WorkshopWish::Delete,
        _ => return None,
    })
}
