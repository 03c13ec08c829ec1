//! The keys of the workshop. They hold wherever nothing is typed.

use antipode_language::Texts;
use egui::{Key, Modifiers, Ui};

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
    said.push_str(known.key.name());
    Some(said)
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
            takes |= matches!(event, egui::Event::Copy | egui::Event::Cut);
            match event {
                egui::Event::Copy => wishes.push(WorkshopWish::Copy),
                egui::Event::Cut => wishes.push(WorkshopWish::Cut),
                egui::Event::Paste(_) => wishes.push(WorkshopWish::Paste),
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
        || context.input(|input| input.pointer.button_down(egui::PointerButton::Secondary));
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
        "array" => WorkshopWish::Array,
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
        "flies" => WorkshopWish::Flies(!bar.flies),
        "raster" => WorkshopWish::Raster(!bar.raster),
        "delete" => WorkshopWish::Delete,
        _ => return None,
    })
}
