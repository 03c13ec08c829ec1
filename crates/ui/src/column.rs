//! The left column: the title and the buttons that lead everywhere.

use antipode_settings::Value;
use egui::{FontId, Response, RichText, Ui, UiBuilder};

use crate::layout::{Stops, inset, scroll, steady};
use crate::model::{Intent, OwnRoom, Screen};
use crate::shell::Pass;
use crate::theme::{ACCENT, GRID, PANEL, WEAK, small};
use crate::widgets::column_button;

/// From this height of the window on the buttons are as high as they get, in points: below it they would push the note
/// on the adapter out of sight.
const ROOMY: f32 = 680.0;

/// Draws the column; `current` is marked.
pub(crate) fn show(ui: &mut Ui, pass: &mut Pass<'_>, current: &Screen) {
    let regions = pass.regions;
    let painter = ui.painter().clone();
    painter.rect_filled(regions.column, 0, PANEL);
    let inner = inset(
        regions.column,
        if regions.compact { GRID } else { 2.0 * GRID },
    );
    let mut ui = ui.new_child(UiBuilder::new().id_salt("column").max_rect(inner));
    ui.set_clip_rect(regions.column);
    let spacing = ui.spacing_mut();
    if regions.compact {
        // Nine buttons under the title need no scrolling at 360 points, nor do ten lower ones.
        let is_tenth = may_skip_hints(pass) || pass.model.in_room;
        let lower = if is_tenth { 3.0 } else { 0.0 };
        spacing.interact_size.y = 28.0 - lower;
        spacing.button_padding.y = 4.0 - lower / 2.0;
        spacing.item_spacing.y = 2.0;
    } else if regions.whole.height() < ROOMY {
        spacing.interact_size.y = 30.0;
        spacing.button_padding.y = 4.0;
        spacing.item_spacing.y = 4.0;
    } else {
        spacing.interact_size.y = 40.0;
    }
    Stops::take_step(ui.ctx());
    scroll(&mut ui, inner.height(), |ui| {
        title(ui, pass);
        let mut stops = Stops::default();
        buttons(ui, pass, &mut stops, current);
        stops.step(ui, &Stops::default());
        notes(ui, pass);
    });
}

fn title(ui: &mut Ui, pass: &Pass<'_>) {
    let size = if pass.regions.compact { 28.0 } else { 40.0 };
    let title = RichText::new("Antipode")
        .font(FontId::proportional(size))
        .color(ACCENT);
    ui.label(title);
    if let Some(world) = pass.model.running_world {
        ui.add(egui::Label::new(RichText::new(world).font(small()).color(WEAK)).truncate());
    }
    if !pass.regions.compact {
        ui.add_space(GRID);
    }
}

fn buttons(ui: &mut Ui, pass: &mut Pass<'_>, stops: &mut Stops, current: &Screen) {
    let running = pass.model.running_world.is_some();
    let texts = pass.model.texts;
    if running {
        of_running(ui, pass, stops, current);
    }
    if may_skip_hints(pass) {
        let response = entry(ui, &texts.say("menu-skip-hints"), false);
        stops.add(&response);
        if response.clicked() {
            let value = Value::Switch(false);
            pass.intents.push(Intent::Set { id: "hints", value });
        }
    }
    let screens = [
        (texts.say("menu-new-game"), Screen::NewGame),
        (texts.say("menu-load"), Screen::Load),
        (texts.say("menu-delete"), Screen::Delete),
        (texts.say("menu-rooms"), Screen::Rooms),
        (texts.say("menu-workshop"), Screen::Workshop),
        (texts.say("menu-settings"), Screen::Settings),
        (texts.say("menu-controls"), Screen::Controls),
        (texts.say("menu-about"), Screen::About),
    ];
    // A pause menu has room for so many.
    let is_shown = |screen: &Screen| match screen {
        Screen::About | Screen::Workshop => !running,
        // In its place one builds.
        Screen::Delete => pass.model.own_room != OwnRoom::Walked,
        Screen::Rooms => !running || pass.model.in_room,
        _ => true,
    };
    let shown: Vec<_> = screens.into_iter().filter(|(_, it)| is_shown(it)).collect();
    for (label, screen) in shown {
        let response = entry(ui, &label, *current == screen);
        stops.add(&response);
        offer(pass, current, &response);
        if response.clicked() {
            pass.go = Some(screen);
        }
    }
    let quit = entry(ui, &texts.say("menu-quit"), false);
    stops.add(&quit);
    if quit.clicked() {
        pass.intents.push(Intent::Quit);
    }
}

/// The buttons of a menu over a world or room that is open.
fn of_running(ui: &mut Ui, pass: &mut Pass<'_>, stops: &mut Stops, current: &Screen) {
    let (texts, in_room) = (pass.model.texts, pass.model.in_room);
    let entries: &[(&str, Intent)] = if pass.model.own_room == OwnRoom::Built {
        &[
            ("menu-resume", Intent::Resume),
            ("menu-leave-room", Intent::SaveAndQuitToMenu),
        ]
    } else if pass.model.own_room == OwnRoom::Walked {
        &[
            ("menu-resume", Intent::Resume),
            ("menu-build-here", Intent::BuildHere),
            ("menu-begin-anew", Intent::BeginAnew),
            ("menu-leave-room", Intent::SaveAndQuitToMenu),
        ]
    } else if in_room {
        &[
            ("menu-resume", Intent::Resume),
            ("menu-begin-anew", Intent::BeginAnew),
            ("menu-leave-room", Intent::SaveAndQuitToMenu),
        ]
    } else {
        &[
            ("menu-resume", Intent::Resume),
            ("menu-save", Intent::Save),
            ("menu-save-and-quit", Intent::SaveAndQuitToMenu),
        ]
    };
    for (key, intent) in entries {
        let response = entry(ui, &texts.say(key), false);
        stops.add(&response);
        offer(pass, current, &response);
        if response.clicked() {
            pass.intents.push(intent.clone());
        }
    }
}

/// A button that stays the same one whatever comes or goes above it.
fn entry(ui: &mut Ui, label: &str, chosen: bool) -> Response {
    steady(ui, label, |ui| column_button(ui, label, chosen))
}

/// Whether hints for newcomers are shown in the world behind the menu.
fn may_skip_hints(pass: &Pass<'_>) -> bool {
    pass.model.running_world.is_some() && !pass.model.in_room && pass.model.config.settings.hints
}

/// With another screen beside the column, the focus belongs there.
fn offer(pass: &mut Pass<'_>, current: &Screen, response: &Response) {
    if *current == Screen::Main {
        pass.offer_focus(response);
    }
}

/// The version, and what there is to know about the graphics device.
fn notes(ui: &mut Ui, pass: &Pass<'_>) {
    let values = [("version", pass.model.version.into())];
    let version = pass.model.texts.say_with("version", &values);
    ui.label(RichText::new(version).font(small()).color(WEAK));
    if let Some(notice) = pass.model.adapter_notice {
        ui.label(RichText::new(notice).font(small()).color(WEAK));
    }
}
