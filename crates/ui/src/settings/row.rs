//! One setting: its name, its value to change, a button back to the default, and what it means.

use antipode_settings::{Field, Kind, Value};
use egui::{Button, Label, Response, RichText, Role, Ui, Widget as _, WidgetInfo, vec2};

use super::control;
use crate::layout::{Stops, steady};
use crate::model::Intent;
use crate::shell::Pass;
use crate::theme::{GRID, WEAK, small};
use crate::widgets::focus_ring;

/// Room that the button back to the default takes where there is enough, in points.
const RESET_WIDTH: f32 = 128.0;

/// Draws the row; what the player changes becomes an intent.
pub(super) fn show(
    ui: &mut Ui,
    pass: &mut Pass<'_>,
    stops: &mut Stops,
    field: &'static Field,
    held: &mut Option<(&'static str, f64)>,
) {
    let texts = pass.model.texts;
    let id = field.id;
    let label = texts.say(&format!("setting-{id}"));
    let about = texts.say(&format!("setting-{id}-about"));
    let value = pass.model.config.settings.get(field);
    let mut chosen = None;
    steady(ui, id, |ui| {
        // Close together what belongs together.
        ui.spacing_mut().item_spacing.y = 2.0;
        let whole = ui.available_width();
        let reset = RESET_WIDTH.min(0.4 * whole);
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = GRID;
            let width = (whole - reset - GRID).max(1.0);
            ui.allocate_ui(vec2(width, ui.spacing().interact_size.y), |ui| {
                ui.set_width(width);
                if let (Kind::Toggle, Value::Switch(on)) = (field.kind, value) {
                    let (response, on) = control::toggle(ui, &label, on);
                    stops.add(&response);
                    chosen = on.map(Value::Switch);
                } else {
                    Label::new(&label).wrap().ui(ui);
                }
            });
            let response = reset_button(ui, pass, field, &label, reset);
            if response.enabled() {
                stops.add(&response);
            }
            if response.clicked() {
                *held = None;
                pass.intents.push(Intent::ResetSetting(id));
            }
        });
        match (field.kind, value) {
            (Kind::Slider { .. }, Value::Number(number)) => {
                let (response, set) = control::slider(ui, texts, field, &label, number, held);
                stops.add(&response);
                chosen = set.map(Value::Number);
            }
            (Kind::Choice { options }, Value::Choice(word)) => {
                let set = control::choice(ui, texts, stops, id, &label, options, word);
                chosen = set.map(Value::Choice);
            }
            _ => {}
        }
        let about = RichText::new(about).font(small()).color(WEAK);
        Label::new(about).wrap().ui(ui);
        ui.add_space(GRID);
    });
    pass.intents
        .extend(chosen.map(|value| Intent::Set { id, value }));
}

fn reset_button(ui: &mut Ui, pass: &Pass<'_>, field: &Field, label: &str, width: f32) -> Response {
    let texts = pass.model.texts;
    let enabled = !pass.model.config.settings.is_default(field);
    let words = RichText::new(texts.say("settings-reset")).font(small());
    let button = Button::new(words).wrap().min_size(vec2(width, 0.0));
    let response = ui
        .add_enabled_ui(enabled, |ui| {
            ui.set_max_width(width);
            ui.add(button)
        })
        .inner;
    let name = texts.say_with("settings-reset-named", &[("name", label.into())]);
    response.widget_info(|| WidgetInfo::labeled(Role::Button, enabled, &name));
    focus_ring(ui, &response);
    response
}
