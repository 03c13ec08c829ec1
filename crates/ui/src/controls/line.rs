//! One action of the controls screen: its name, the inputs that do it, and what else they do.

use antipode_language::Texts;
use antipode_settings::{Action, Conflict, Input, MAX_INPUTS, Profile};
use egui::{Button, Label, Response, RichText, Role, TextWrapMode, Ui, Widget as _, WidgetInfo};

use super::{Wish, action_label, input_label};
use crate::layout::{Stops, steady};
use crate::shell::Pass;
use crate::theme::{BAD, WEAK, small};
use crate::widgets::focus_ring;

/// Share of a line that its name takes from so many points of width on: two inputs with their buttons fit beside it.
const NAME_SHARES: [(f32, f32); 2] = [(400.0, 0.28), (0.0, 0.5)];

/// Draws the line; what is asked for there.
pub(super) fn show(
    ui: &mut Ui,
    pass: &mut Pass<'_>,
    stops: &mut Stops,
    profile: &Profile,
    action: Action,
) -> Option<Wish> {
    let texts = pass.model.texts;
    let label = action_label(texts, action);
    steady(ui, action.info().id, |ui| {
        let whole = ui.available_width();
        let share = NAME_SHARES.iter().find(|(from, _)| whole >= *from);
        let name = whole * share.map_or(0.5, |(_, share)| *share);
        ui.horizontal_top(|ui| {
            ui.vertical(|ui| {
                // In line with the words on the buttons.
                ui.add_space(ui.spacing().button_padding.y);
                ui.set_width((name - ui.spacing().item_spacing.x).max(1.0));
                Label::new(&label).wrap().ui(ui);
            });
            ui.horizontal_wrapped(|ui| {
                ui.style_mut().wrap_mode = Some(TextWrapMode::Extend);
                inputs(ui, pass, stops, profile, action, &label)
            })
            .inner
        })
        .inner
    })
}

fn inputs(
    ui: &mut Ui,
    pass: &mut Pass<'_>,
    stops: &mut Stops,
    profile: &Profile,
    action: Action,
    label: &str,
) -> Option<Wish> {
    let texts = pass.model.texts;
    let mut wish = None;
    let mut press = |ui: &mut Ui, words: &str, name: String, asked: Wish| {
        let response = named_button(ui, words, &name);
        stops.add(&response);
        pass.offer_focus(&response);
        if response.clicked() {
            wish = Some(asked);
        }
    };
    for input in profile.inputs(action) {
        let key = input_label(texts, *input);
        if is_fixed(action, *input) {
            ui.label(key);
            continue;
        }
        let values = [("action", label.into()), ("key", key.as_str().into())];
        let change = Wish::Wait(action, Some(*input));
        press(ui, &key, format!("{label}: {key}"), change);
        let remove = texts.say_with("controls-remove", &values);
        press(ui, "×", remove, Wish::Unbind(action, *input));
    }
    if profile.inputs(action).is_empty() {
        ui.label(RichText::new(texts.say("key-none")).color(WEAK));
    }
    let values = [("action", label.into())];
    if profile.inputs(action).len() < MAX_INPUTS {
        let add = texts.say_with("controls-add", &values);
        press(ui, "+", add, Wish::Wait(action, None));
    }
    if !profile.is_default(action) {
        let reset = texts.say_with("settings-reset-named", &[("name", label.into())]);
        press(ui, &texts.say("settings-reset"), reset, Wish::Reset(action));
    }
    wish
}

/// Escape leads to the menu, whatever else does.
fn is_fixed(action: Action, input: Input) -> bool {
    action == Action::Menu && Input::key("Escape") == Some(input)
}

fn named_button(ui: &mut Ui, words: &str, name: &str) -> Response {
    let response = ui.add(Button::new(words));
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, name));
    focus_ring(ui, &response);
    response
}

/// Says under an action what else one of its inputs does.
pub(super) fn tell(ui: &mut Ui, texts: &Texts, conflict: &Conflict, action: Action) {
    if !conflict.actions.contains(&action) {
        return;
    }
    let others: Vec<_> = conflict
        .actions
        .iter()
        .filter(|other| **other != action)
        .map(|other| {
            texts.say_with(
                "controls-quoted",
                &[("name", action_label(texts, *other).into())],
            )
        })
        .collect();
    let values = [
        ("key", input_label(texts, conflict.input).into()),
        ("actions", others.join(", ").into()),
    ];
    let words = texts.say_with("controls-conflict", &values);
    let words = RichText::new(words).font(small()).color(BAD);
    Label::new(words).wrap().ui(ui);
}
