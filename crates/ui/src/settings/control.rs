//! The controls that change a value: a box to tick, a slider, or a few words to choose from.

use antipode_language::{Texts, Value};
use antipode_settings::{Field, Kind};
use egui::{Button, Checkbox, Response, Role, Slider, TextStyle, TextWrapMode, Ui, WidgetInfo};

use crate::entry::parse_number;
use crate::layout::Stops;
use crate::theme::TEXT;
use crate::widgets::focus_ring;

/// Settings that are applied when the slider is let go: while they change, the slider itself moves under the
/// pointer, or land is made only to be thrown away.
const APPLIED_ON_RELEASE: [&str; 2] = ["ui-scale", "view-distance"];

/// A box to tick; what it was changed to.
pub(super) fn toggle(ui: &mut Ui, label: &str, on: bool) -> (Response, Option<bool>) {
    let mut now = on;
    ui.style_mut().wrap_mode = Some(TextWrapMode::Wrap);
    let response = ui.add(Checkbox::new(&mut now, label));
    focus_ring(ui, &response);
    (response, (now != on).then_some(now))
}

/// A slider with its number; what it was changed to.
pub(super) fn slider(
    ui: &mut Ui,
    texts: &Texts,
    field: &Field,
    label: &str,
    value: f64,
    held: &mut Option<(&'static str, f64)>,
) -> (Response, Option<f64>) {
    let Kind::Slider {
        min,
        max,
        step,
        unit_key,
        whole,
    } = field.kind
    else {
        return (ui.label(label), None);
    };
    let of_this = held.filter(|(id, _)| *id == field.id);
    let mut number = of_this.map_or(value, |(_, number)| number);
    let digits = digits(step);
    let say = |number: f64| {
        let values = [("value", Value::decimals(number, digits))];
        texts.say_with(unit_key, &values)
    };
    let number_width = number_width(ui, &[say(min), say(max), say(number)]);
    ui.spacing_mut().slider_width = (ui.available_width() - number_width).clamp(16.0, 320.0);
    let slider = Slider::new(&mut number, min..=max)
        .step_by(step)
        .custom_formatter(|number, _| say(number))
        .custom_parser(parse_number);
    let response = ui.add(slider);
    let words = say(number);
    response.widget_info(|| WidgetInfo {
        value: Some(number),
        ..WidgetInfo::labeled(Role::Slider, true, format!("{label}: {words}"))
    });
    focus_ring(ui, &response);
    let number = if whole { number.round() } else { tidy(number) };
    if response.drag_stopped() && of_this.is_some() {
        *held = None;
        return (response, Some(number));
    }
    if !response.changed() || number == value {
        return (response, None);
    }
    if response.dragged() && APPLIED_ON_RELEASE.contains(&field.id) {
        *held = Some((field.id, number));
        return (response, None);
    }
    *held = None;
    (response, Some(number))
}

/// Room for the number beside a slider that may be any of these, in points.
fn number_width(ui: &Ui, words: &[String]) -> f32 {
    let font = TextStyle::Button.resolve(ui.style());
    let width = |words: &String| {
        let words = ui
            .painter()
            .layout_no_wrap(words.clone(), font.clone(), TEXT);
        words.size().x
    };
    let spacing = ui.spacing();
    let widest = words.iter().map(width).fold(0.0, f32::max);
    widest + 2.0 * spacing.button_padding.x + spacing.item_spacing.x + 1.0
}

/// Words side by side of which one holds; which was pressed.
pub(super) fn choice(
    ui: &mut Ui,
    texts: &Texts,
    stops: &mut Stops,
    id: &str,
    label: &str,
    options: &'static [&'static str],
    held: &str,
) -> Option<&'static str> {
    let mut pressed = None;
    ui.horizontal_wrapped(|ui| {
        ui.style_mut().wrap_mode = Some(TextWrapMode::Extend);
        for option in options {
            let words = texts.say(&format!("setting-{id}-{option}"));
            let holds = *option == held;
            let response = ui.add(Button::new(&words).selected(holds));
            let name = format!("{label}: {words}");
            response.widget_info(|| WidgetInfo::selected(Role::RadioButton, true, holds, &name));
            focus_ring(ui, &response);
            stops.add(&response);
            if response.clicked() {
                pressed = Some(*option);
            }
        }
    });
    pressed
}

/// Digits behind the decimal mark that a step needs.
fn digits(step: f64) -> usize {
    (0..6)
        .find(|digits| {
            let steps = step * 10_f64.powi(*digits);
            (steps - steps.round()).abs() < 1e-6 && steps >= 0.5
        })
        .map_or(6, |digits| digits as usize)
}

/// Without the crumbs that adding up steps leaves.
fn tidy(number: f64) -> f64 {
    (number * 1e6).round() / 1e6
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_step_shows_as_many_digits_as_it_needs() {
        assert_eq!([1.0, 0.1, 0.01, 0.25].map(digits), [0, 1, 2, 2]);
    }
}
