//! What a value is changed with: a box to tick, a slider, or a few words to choose from.

use antipode_language::{Texts, Value};
use antipode_settings::{Field, Kind};
use egui::{Button, Checkbox, Response, Role, Slider, TextWrapMode, Ui, WidgetInfo};

use crate::layout::Stops;
use crate::widgets::focus_ring;

/// Settings that are applied when the slider is let go: while they change, the slider itself moves under the
/// pointer, or land is made only to be thrown away.
const APPLIED_ON_RELEASE: [&str; 2] = ["ui-scale", "view-distance"];
/// Room for the number beside a slider, in points.
const NUMBER_WIDTH: f32 = 120.0;

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
    ui.spacing_mut().slider_width = (ui.available_width() - NUMBER_WIDTH).clamp(16.0, 320.0);
    let say = |number: f64| {
        let values = [("value", Value::decimals(number, digits))];
        texts.say_with(unit_key, &values)
    };
    let slider = Slider::new(&mut number, min..=max)
        .step_by(step)
        .custom_formatter(|number, _| say(number))
        .custom_parser(parse);
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

/// What somebody types as a number, with its unit or without, with a point or a comma.
fn parse(text: &str) -> Option<f64> {
    let digits = text.trim_start_matches(|c: char| !c.is_ascii_digit() && c != '-');
    let end = digits
        .find(|c: char| !c.is_ascii_digit() && !"-.,".contains(c))
        .unwrap_or(digits.len());
    digits[..end].replace(',', ".").parse().ok()
}

/// Without the crumbs that adding up steps leaves.
fn tidy(number: f64) -> f64 {
    (number * 1e6).round() / 1e6
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_with_their_units_and_in_every_manner() {
        for (text, number) in [
            ("75", Some(75.0)),
            ("75°", Some(75.0)),
            (" 0,12 ° na piksel", Some(0.12)),
            ("× 1.5", Some(1.5)),
            ("-3", Some(-3.0)),
            ("4 chunks", Some(4.0)),
            ("", None),
            ("wide", None),
        ] {
            assert_eq!(parse(text), number, "{text}");
        }
    }

    #[test]
    fn a_step_shows_as_many_digits_as_it_needs() {
        assert_eq!([1.0, 0.1, 0.01, 0.25].map(digits), [0, 1, 2, 2]);
    }
}
