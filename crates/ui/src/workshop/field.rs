//! Fields of the inspector: numbers with their units that are dragged or typed, words that are chosen, colours.

use antipode_language::{Texts, Value};
use egui::{ComboBox, DragValue, Response, Slider, SliderClamping, Ui, WidgetInfo, vec2};

use super::model::{Amount, FieldKind, FieldRow, FieldValue, Unit, WorkshopWish};
use crate::entry::{entry, parse_number};
use crate::widgets::focus_ring;

/// The least and greatest stretch of space.
const STRETCHES: (f64, f64) = (1.0 / 32.0, 32.0);
/// The same as powers of two, and what an arrow key changes.
const OCTAVES: (f64, f64) = (-5.0, 5.0);
const OCTAVE_STEP: f64 = 0.0625;
/// How many digits the slider sets, and how many with Shift, which goes so much slower.
const DIGITS: i32 = 2;
const FINE_DIGITS: i32 = 3;
const FINE: f64 = 0.1;
/// Numbers stand below each other where there is less room for each, points: what they say would be cut off.
const NARROWEST: f32 = 66.0;
/// What is shown where those that are chosen differ.
const DIFFER: &str = "…";

/// Draws a field.
pub(super) fn show(ui: &mut Ui, texts: &Texts, row: &FieldRow, wishes: &mut Vec<WorkshopWish>) {
    let mut set = |value: FieldValue, done: bool| {
        wishes.push(WorkshopWish::Set {
            key: row.key.clone(),
            value,
            done,
        });
    };
    match &row.kind {
        FieldKind::Numbers(amounts, unit) => {
            let gaps = ui.spacing().item_spacing.x * amounts.len().saturating_sub(1) as f32;
            let width = (ui.available_width() - gaps) / amounts.len().max(1) as f32;
            let mut all = |ui: &mut Ui, width: f32| {
                for (place, amount) in amounts.iter().enumerate() {
                    number(ui, texts, row, (place, *amount, *unit), width, &mut set);
                }
            };
            if width < NARROWEST {
                let width = ui.available_width();
                all(ui, width);
            } else {
                ui.horizontal_top(|ui| all(ui, width));
            }
        }
        FieldKind::Stretch(value) => stretch(ui, texts, row, *value, &mut set),
        FieldKind::Colour(colour) => {
            let mut rgb = colour.unwrap_or([128; 3]);
            if let Some(done) = super::colour::button(ui, &row.label, &mut rgb) {
                set(FieldValue::Colour(rgb), done);
            }
        }
        FieldKind::Text(text) => line(ui, row, text.as_deref(), &mut set),
        FieldKind::Choice(options, chosen) => choice(ui, row, (options, *chosen), &mut set),
        FieldKind::Switch(on) => {
            let mut value = on.unwrap_or(false);
            let mut checkbox = egui::Checkbox::new(&mut value, "");
            checkbox = checkbox.indeterminate(on.is_none());
            let response = ui.add(checkbox);
            name(&response, &row.label);
            focus_ring(ui, &response);
            if response.changed() {
                set(FieldValue::Switch(value), true);
            }
        }
        FieldKind::Words(..) => {}
    }
}

fn name(response: &Response, label: &str) {
    response.widget_info(|| WidgetInfo::labeled(egui::Role::TextInput, true, label));
}

/// A number with its unit, in words.
pub(super) fn said(texts: &Texts, value: f64, unit: Unit) -> String {
    let decimals = if value.fract().abs() < 1e-9 {
        0
    } else if value.abs() < 0.1 {
        4
    } else {
        3
    };
    // As many as say something.
    let digits = format!("{value:.decimals$}");
    let after = digits.split_once('.').map_or("", |(_, after)| after);
    let decimals = after.trim_end_matches('0').len();
    let values = [("value", Value::decimals(value, decimals))];
    match unit {
        Unit::Metres => texts.say_with("workshop-unit-metres", &values),
        Unit::Degrees => texts.say_with("workshop-unit-degrees", &values),
        Unit::Times => texts.say_with("workshop-unit-times", &values),
        Unit::Plain => texts.say_with("workshop-unit-plain", &values),
    }
}

fn number(
    ui: &mut Ui,
    texts: &Texts,
    row: &FieldRow,
    (place, amount, unit): (usize, Amount, Unit),
    width: f32,
    set: &mut impl FnMut(FieldValue, bool),
) {
    let mut value = amount.value.unwrap_or(0.0);
    let speed = match unit {
        Unit::Degrees => 1.0,
        _ => 0.02,
    };
    let is_mixed = amount.value.is_none();
    let misread = std::cell::RefCell::new(None);
    let drag = DragValue::new(&mut value)
        .speed(speed)
        .range(amount.range.0..=amount.range.1)
        // What stands for values that differ would be brought into the range, and set.
        .clamp_existing_to_range(false)
        .update_while_editing(false)
        .custom_formatter(|value, _| {
            if is_mixed {
                DIFFER.to_owned()
            } else {
                said(texts, value, unit)
            }
        })
        .custom_parser(|text| {
            let number = parse_number(text);
            if number.is_none() && text != DIFFER {
                misread.replace(Some(text.to_owned()));
            }
            number
        });
    let response = ui.add_sized(vec2(width.max(30.0), 24.0), drag);
    if let Some(text) = misread.take() {
        set(FieldValue::Misread(text), true);
    }
    match &row.kind {
        FieldKind::Numbers(all, _) if all.len() > 1 => {
            let axis = ["x", "y", "z"].get(place).copied().unwrap_or_default();
            name(&response, &format!("{} {axis}", row.label));
        }
        _ => name(&response, &row.label),
    }
    focus_ring(ui, &response);
    if response.changed() {
        set(FieldValue::Number(place, value), !response.dragged());
    } else if response.drag_stopped() {
        set(FieldValue::Number(place, value), true);
    }
}

/// How many times as long something feels, by a slider as wide as the pane: as far for twice as much everywhere. With Shift it
/// goes a tenth as fast.
fn stretch(
    ui: &mut Ui,
    texts: &Texts,
    row: &FieldRow,
    value: Option<f64>,
    set: &mut impl FnMut(FieldValue, bool),
) {
    let mut octaves = value.unwrap_or(1.0).log2();
    let width = ui.available_width();
    ui.spacing_mut().slider_width = width;
    let (is_fine, is_held) = ui.input(|it| (it.modifiers.shift, it.pointer.primary_down()));
    // How far it is from the pointer since it went finer than that.
    let id = ui.scope_id().with("aside");
    let aside = ui.data(|data| data.get_temp::<f64>(id)).unwrap_or(0.0);
    let mut pointed = None;
    let slider = Slider::from_get_set(OCTAVES.0..=OCTAVES.1, |new| {
        if let Some(new) = new {
            if is_held {
                pointed = Some(new);
            }
            if !(is_held && is_fine) {
                octaves = rounded((new + aside).exp2(), DIGITS).log2();
            }
        }
        octaves
    });
    // Only what is dragged goes by steps: a number that was typed stays.
    let slider = slider.clamping(SliderClamping::Edits);
    let response = ui.add(slider.step_by(OCTAVE_STEP).show_value(false));
    response.widget_info(|| {
        let label = format!(
            "{}: {}",
            row.label,
            said(texts, octaves.exp2(), Unit::Times)
        );
        WidgetInfo::labeled(egui::Role::Slider, true, label)
    });
    focus_ring(ui, &response);
    let mut has_changed = response.changed();
    if response.dragged() && is_fine {
        let way = f64::from(response.drag_delta().x / width) * (OCTAVES.1 - OCTAVES.0);
        let new = (octaves + way * FINE).clamp(OCTAVES.0, OCTAVES.1);
        has_changed = way != 0.0;
        octaves = new;
        let aside = pointed.map_or(0.0, |pointed| new - pointed);
        ui.data_mut(|data| data.insert_temp(id, aside));
    }
    let times = octaves.exp2().clamp(STRETCHES.0, STRETCHES.1);
    let times = rounded(times, if is_fine { FINE_DIGITS } else { DIGITS });
    if has_changed {
        set(FieldValue::Number(0, times), !response.dragged());
    } else if response.drag_stopped() {
        set(FieldValue::Number(0, value.unwrap_or(times)), true);
    }
    if response.drag_stopped() {
        ui.data_mut(|data| data.remove::<f64>(id));
    }
}

/// The same as a number that is typed, or dragged for fine steps: beside its name.
pub(super) fn times(
    ui: &mut Ui,
    texts: &Texts,
    row: &FieldRow,
    value: Option<f64>,
    (width, wishes): (f32, &mut Vec<WorkshopWish>),
) {
    let amount = Amount {
        value,
        range: STRETCHES,
    };
    let mut set = |value: FieldValue, done: bool| {
        wishes.push(WorkshopWish::Set {
            key: row.key.clone(),
            value,
            done,
        });
    };
    number(ui, texts, row, (0, amount, Unit::Times), width, &mut set);
}

/// A number of so many digits.
fn rounded(value: f64, digits: i32) -> f64 {
    let unit = 10f64.powi(value.abs().log10().floor() as i32 + 1 - digits);
    if unit.is_finite() && unit > 0.0 {
        (value / unit).round() * unit
    } else {
        value
    }
}

fn line(ui: &mut Ui, row: &FieldRow, text: Option<&str>, set: &mut impl FnMut(FieldValue, bool)) {
    let id = ui.scope_id().with("text");
    let kept = ui.data(|data| data.get_temp::<String>(id));
    let mut typed = kept
        .clone()
        .unwrap_or_else(|| text.unwrap_or(DIFFER).to_owned());
    let response = entry(ui, &mut typed, &row.label, "");
    if response.has_focus() {
        ui.data_mut(|data| data.insert_temp(id, typed));
    } else if kept.is_some() || response.changed() {
        ui.data_mut(|data| data.remove::<String>(id));
        let is_given_up = ui.input(|input| input.key_pressed(egui::Key::Escape));
        // Letters and the key that ends them may come in one slow pass.
        if !is_given_up && typed != text.unwrap_or(DIFFER) {
            set(FieldValue::Text(typed), true);
        }
    }
}

fn choice(
    ui: &mut Ui,
    row: &FieldRow,
    (options, chosen): (&[(String, String)], Option<usize>),
    set: &mut impl FnMut(FieldValue, bool),
) {
    let label = chosen.and_then(|it| options.get(it));
    let shown = label.map_or(DIFFER, |(_, label)| label);
    let response = ComboBox::from_id_salt("choice")
        .width(ui.available_width())
        .selected_text(shown)
        .truncate()
        .show_ui(ui, |ui| {
            for (number, (word, label)) in options.iter().enumerate() {
                let is_chosen = chosen == Some(number);
                if ui.selectable_label(is_chosen, label).clicked() && !is_chosen {
                    set(FieldValue::Text(word.clone()), true);
                }
            }
        })
        .response;
    name(&response, &row.label);
    focus_ring(ui, &response);
}
