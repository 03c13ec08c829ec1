//! The photo mode: a panel at the right with what the picture is taken with, and lines over the picture.

use std::ops::RangeInclusive;

use antipode_language::{Texts, Value};
use egui::{
    Area, Button, Checkbox, Context, Id, Label, LayerId, Order, Painter, Rect, Response, RichText,
    Role, Slider, Stroke, Ui, Vec2, WidgetInfo, pos2, vec2,
};

use crate::dialog::percent;
use crate::hud::DialKind;
use crate::layout::{Stops, inset, pane};
use crate::theme::{GRID, WEAK, small};
use crate::widgets::{button, focus_ring, primary_button};

/// Widest the panel gets, in points.
const WIDTH: f32 = 340.0;
/// Room for the number beside a slider, in points.
const NUMBER_WIDTH: f32 = 72.0;
/// Narrowest and widest field of view from top to bottom, degrees.
pub const FIELD_OF_VIEW_DEG: (f64, f64) = (10.0, 120.0);

/// What the player can change of the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PhotoValues {
    /// Vertical field of view, degrees.
    pub field_of_view_deg: f64,
    /// Time of day, seconds.
    pub time_of_day_s: f64,
    /// The picture's dial, where it has one.
    pub dial: f64,
    /// Whether figures are left out.
    pub hide_figures: bool,
    /// Whether lines cut the picture in thirds; they are never in the file.
    pub thirds: bool,
    /// How many times as large as the window the file is, along each side.
    pub times: u32,
}

/// What else the panel shows.
pub struct PhotoModel<'a> {
    /// The words of the player's language.
    pub texts: &'a Texts,
    /// The dial's kind and range, where the picture has one.
    pub dial: Option<(DialKind, f64, f64)>,
    /// Length of a day, where there is a sky that tells the time, seconds.
    pub day_s: Option<f64>,
    /// A time of day in words.
    pub clock: &'a dyn Fn(f64) -> String,
    /// Size of the window, pixels.
    pub size: (u32, u32),
    /// How many times that the file may have at most.
    pub most_times: u32,
    /// The keys that fly, in words.
    pub keys: String,
    /// How much of a picture is done that is being made, 0 to 1.
    pub saving: Option<f32>,
}

/// What the player asked for.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PhotoWishes {
    /// To keep the picture.
    pub save: bool,
    /// To go back into the world.
    pub leave: bool,
    /// How far the mouse was dragged over the picture, points to the right and down.
    pub look: Vec2,
}

/// What the panel covers of a screen.
pub fn photo_panel(screen: Rect) -> Rect {
    let width = WIDTH.min(screen.width() * 0.6);
    let rect = inset(screen, GRID);
    rect.with_min_x(rect.max.x - width)
}

/// Draws panel and lines, and takes over what was changed. `fresh`: the mode has just been entered.
pub fn show_photo(
    ctx: &Context,
    model: &PhotoModel<'_>,
    values: &mut PhotoValues,
    fresh: bool,
) -> PhotoWishes {
    let screen = ctx.content_rect();
    if values.thirds {
        thirds(&ctx.layer_painter(LayerId::background()), screen);
    }
    let mut wishes = PhotoWishes::default();
    let rect = photo_panel(screen);
    let area = Area::new(Id::unique("antipode-photo"))
        .order(Order::Middle)
        .fixed_pos(rect.min)
        .constrain(false)
        .show(ctx, |ui| {
            ui.set_min_size(rect.size());
            panel(ui, rect, model, values, fresh, &mut wishes);
        });
    wishes.look = ctx.input(|input| {
        let pointer = &input.pointer;
        let began = pointer.press_origin();
        let over_panel = began.is_none_or(|at| area.response.rect.contains(at));
        if pointer.any_down() && !over_panel && model.saving.is_none() {
            pointer.delta()
        } else {
            Vec2::ZERO
        }
    });
    wishes
}

/// The lines that cut the picture in thirds: light with a dark edge, readable over snow and night.
fn thirds(painter: &Painter, rect: Rect) {
    for part in [1.0 / 3.0, 2.0 / 3.0] {
        let x = rect.min.x + part * rect.width();
        let y = rect.min.y + part * rect.height();
        for (width, colour) in [
            (3.0, egui::Color32::from_black_alpha(90)),
            (1.0, egui::Color32::from_white_alpha(180)),
        ] {
            let stroke = Stroke::new(width, colour);
            painter.line_segment([pos2(x, rect.min.y), pos2(x, rect.max.y)], stroke);
            painter.line_segment([pos2(rect.min.x, y), pos2(rect.max.x, y)], stroke);
        }
    }
}

fn panel(
    ui: &mut Ui,
    rect: Rect,
    model: &PhotoModel<'_>,
    values: &mut PhotoValues,
    fresh: bool,
    wishes: &mut PhotoWishes,
) {
    let texts = model.texts;
    let free = model.saving.is_none();
    let body = |ui: &mut Ui, stops: &mut Stops| {
        // First, since in a low window the rest scrolls.
        let hint = texts.say_with("photo-fly", &[("keys", model.keys.as_str().into())]);
        ui.add(Label::new(RichText::new(hint).font(small()).color(WEAK)).wrap());
        ui.add_enabled_ui(free, |ui| {
            sliders(ui, stops, model, values, fresh);
            ticks(ui, stops, texts, values);
            sizes(ui, stops, model, values);
        });
    };
    pane(ui, rect, &texts.say("photo-title"), body, |ui| {
        match model.saving {
            Some(part) => {
                let values = [("percent", percent(part))];
                ui.label(texts.say_with("photo-saving", &values));
            }
            None => wishes.save = primary_button(ui, &texts.say("photo-save"), true).clicked(),
        }
        wishes.leave = button(ui, &texts.say("photo-leave")).clicked();
    });
}

fn sliders(
    ui: &mut Ui,
    stops: &mut Stops,
    model: &PhotoModel<'_>,
    values: &mut PhotoValues,
    fresh: bool,
) {
    let texts = model.texts;
    let degrees = |value: f64| {
        let values = [("value", Value::decimals(value, 0))];
        texts.say_with("unit-degrees", &values)
    };
    let (least, most) = FIELD_OF_VIEW_DEG;
    let response = slider(
        ui,
        &texts.say("photo-field-of-view"),
        &mut values.field_of_view_deg,
        least..=most,
        1.0,
        &degrees,
    );
    stops.add(&response);
    if fresh {
        response.request_focus();
    }
    if let Some(day_s) = model.day_s {
        let label = texts.say("photo-time");
        stops.add(&slider(
            ui,
            &label,
            &mut values.time_of_day_s,
            0.0..=day_s,
            day_s / 144.0,
            model.clock,
        ));
    }
    if let Some((kind, min, max)) = model.dial {
        let label = texts.say(match kind {
            DialKind::Raised | DialKind::Horizon => "photo-curvature",
            DialKind::Bend => "photo-bend",
        });
        let number = |value: f64| {
            let values = [("value", Value::decimals(value, 1))];
            texts.say_with("photo-dial", &values)
        };
        stops.add(&slider(
            ui,
            &label,
            &mut values.dial,
            min..=max,
            0.1,
            &number,
        ));
    }
}

/// A slider below its name, which stops at multiples of `step`.
fn slider(
    ui: &mut Ui,
    label: &str,
    value: &mut f64,
    range: RangeInclusive<f64>,
    step: f64,
    say: &dyn Fn(f64) -> String,
) -> Response {
    ui.label(label);
    // The number beside it is no second thing to focus: keys would be typed into it.
    let row = ui.horizontal(|ui| {
        ui.spacing_mut().slider_width = (ui.available_width() - NUMBER_WIDTH).clamp(16.0, 320.0);
        let slider = Slider::new(value, range).step_by(step).show_value(false);
        let response = ui.add(slider);
        ui.label(RichText::new(say(*value)).color(WEAK));
        response
    });
    let response = row.inner;
    let words = say(*value);
    response.widget_info(|| WidgetInfo {
        value: Some(*value),
        ..WidgetInfo::labeled(Role::Slider, true, format!("{label}: {words}"))
    });
    focus_ring(ui, &response);
    response
}

fn ticks(ui: &mut Ui, stops: &mut Stops, texts: &Texts, values: &mut PhotoValues) {
    let boxes = [
        (texts.say("photo-figures"), &mut values.hide_figures),
        (texts.say("photo-thirds"), &mut values.thirds),
    ];
    for (label, on) in boxes {
        let response = ui.add(Checkbox::new(on, label));
        focus_ring(ui, &response);
        stops.add(&response);
    }
}

fn sizes(ui: &mut Ui, stops: &mut Stops, model: &PhotoModel<'_>, values: &mut PhotoValues) {
    let texts = model.texts;
    ui.label(texts.say("photo-size"));
    for times in 1..=model.most_times {
        let (width, height) = (model.size.0 * times, model.size.1 * times);
        let known = [
            ("times", times.into()),
            ("width", width.to_string().into()),
            ("height", height.to_string().into()),
        ];
        let words = texts.say_with("photo-size-times", &known);
        let holds = values.times == times;
        let size = vec2(ui.available_width(), 0.0);
        let response = ui.add(Button::new(&words).min_size(size).selected(holds));
        response.widget_info(|| WidgetInfo::selected(Role::RadioButton, true, holds, &words));
        focus_ring(ui, &response);
        stops.add(&response);
        if response.clicked() {
            values.times = times;
        }
    }
}
