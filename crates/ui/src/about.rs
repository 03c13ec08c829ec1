//! The screen that tells what the game is, what it draws with, and whose work is in it.

use egui::{Key, Label, RichText, Ui, Widget as _, vec2};

use crate::layout::{Stops, long_pane};
use crate::model::Screen;
use crate::shell::Pass;
use crate::theme::{ACCENT, GRID, WEAK, small};
use crate::widgets::button;

/// How far an arrow key scrolls, in points.
const STEP: f32 = 48.0;

/// What the screen tells beside the version.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AboutModel {
    /// The graphics adapter and the interface to it, e.g. "llvmpipe (Vulkan)".
    pub adapter: String,
    /// The adapter's driver with its version; may be empty.
    pub driver: String,
    /// The system and the processor's kind, e.g. "linux, x86_64".
    pub system: String,
    /// The libraries that carry the game, with versions.
    pub built_with: String,
    /// Everything built in that is not ours: a line each of name, version and licence.
    pub components: &'static str,
}

/// Draws the screen.
pub(crate) fn show(ui: &mut Ui, pass: &mut Pass<'_>) {
    let texts = pass.model.texts;
    let mut back = None;
    let body = |ui: &mut Ui, _: &mut Stops| {
        // Nothing here can hold the focus, so the arrows scroll.
        let pressed =
            |key, by: f32| ui.input(|input| if input.key_pressed(key) { by } else { 0.0 });
        let by = pressed(Key::ArrowUp, STEP) + pressed(Key::ArrowDown, -STEP);
        if by != 0.0 {
            ui.scroll_with_delta(vec2(0.0, by));
        }
        facts(ui, pass);
        licences(ui, pass);
    };
    long_pane(
        ui,
        pass.regions.pane,
        &texts.say("menu-about"),
        body,
        |ui| {
            back = Some(button(ui, &texts.say("back")));
        },
    );
    if let Some(back) = back {
        pass.offer_focus(&back);
        // The arrows would carry the focus off to the column.
        let lock = egui::EventFilter {
            vertical_arrows: true,
            ..Default::default()
        };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(back.id, lock));
        if back.clicked() {
            pass.go = Some(Screen::Main);
        }
    }
}

fn facts(ui: &mut Ui, pass: &Pass<'_>) {
    let texts = pass.model.texts;
    let about = pass.model.about;
    Label::new(texts.say("about-game")).wrap().ui(ui);
    ui.add_space(GRID);
    let version = pass.model.version.to_owned();
    for (name, value) in [
        ("about-version", &version),
        ("about-adapter", &about.adapter),
        ("about-driver", &about.driver),
        ("about-system", &about.system),
        ("about-built-with", &about.built_with),
    ] {
        if !value.is_empty() {
            let line = texts.say_with(name, &[("value", value.into())]);
            Label::new(line).wrap().ui(ui);
        }
    }
    if let Some(notice) = pass.model.adapter_notice {
        ui.add(Label::new(RichText::new(notice).color(WEAK)).wrap());
    }
}

fn licences(ui: &mut Ui, pass: &Pass<'_>) {
    let texts = pass.model.texts;
    ui.add_space(GRID);
    ui.label(RichText::new(texts.say("about-licences")).color(ACCENT));
    for key in ["about-licence-own", "about-licence-fonts"] {
        Label::new(texts.say(key)).wrap().ui(ui);
    }
    let components = pass.model.about.components.trim_end();
    let count = components.lines().count();
    let words = texts.say_with("about-licence-parts", &[("count", count.into())]);
    Label::new(words).wrap().ui(ui);
    ui.add(Label::new(RichText::new(components).font(small()).color(WEAK)).wrap());
}
