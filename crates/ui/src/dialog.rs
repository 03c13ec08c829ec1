//! Dialogs in the middle of the screen: work in progress, messages, and the
//! question before something is lost.

use antipode_language::Value;
use egui::{FontId, Rect, RichText, Role, Sense, Ui, UiBuilder, WidgetInfo, vec2};

use crate::layout::{inset, scroll};
use crate::model::Intent;
use crate::shell::Pass;
use crate::theme::{ACCENT, BAD, GRID, LINE, TEXT, WEAK, panel, small};
use crate::widgets::{button, focus_ring, primary_button};

/// Width of a dialog where there is room, in points.
const WIDTH: f32 = 480.0;
const MARGIN: f32 = 16.0;

/// Work in progress. `progress` of `None` draws a light that wanders.
pub(crate) fn busy(ui: &mut Ui, pass: &Pass<'_>, title: &str, progress: Option<f32>, detail: &str) {
    let below = 3.0 * GRID + ui.fonts_mut(|fonts| fonts.row_height(&small()));
    dialog(ui, pass, title, "", below, |ui| {
        progress_bar(ui, title, progress);
        let texts = pass.model.texts;
        let percent = progress.map(|part| texts.say_with("percent", &[("percent", percent(part))]));
        let words = match (percent, detail.is_empty()) {
            (Some(percent), true) => percent,
            (Some(percent), false) => format!("{percent}  ·  {detail}"),
            (None, _) => detail.to_owned(),
        };
        ui.add(egui::Label::new(RichText::new(words).font(small()).color(WEAK)).truncate());
    });
}

/// A share of the whole as percent to put into a message.
pub(crate) fn percent(part: f32) -> Value<'static> {
    Value::decimals(f64::from(part.clamp(0.0, 1.0)) * 100.0, 0)
}

/// Something to read; OK dismisses it.
pub(crate) fn message(ui: &mut Ui, pass: &mut Pass<'_>, title: &str, text: &str) {
    let mut done = false;
    let below = ui.spacing().interact_size.y + GRID;
    let mut ok = None;
    dialog(ui, pass, title, text, below, |ui| {
        let response = primary_button(ui, &pass.model.texts.say("ok"), true);
        done = response.clicked();
        ok = Some(response);
    });
    if let Some(ok) = ok {
        pass.offer_focus(&ok);
    }
    if done {
        pass.intents.push(Intent::DismissMessage);
    }
}

/// Asks what to do about a world that could not be saved before leaving it.
pub(crate) fn unsaved(ui: &mut Ui, pass: &mut Pass<'_>, text: &str) {
    let mut asked = None;
    let mut first = None;
    // Where they do not fit side by side, the buttons stand one under another.
    let texts = pass.model.texts;
    let labels = [
        texts.say("unsaved-again"),
        texts.say("unsaved-stay"),
        texts.say("unsaved-leave"),
    ];
    let narrow = side_by_side_width(ui, &labels) > inner_width(pass);
    let rows = if narrow { 3.0 } else { 1.0 };
    let below = rows * (ui.spacing().interact_size.y + GRID);
    let [again, stay, leave] = &labels;
    dialog(ui, pass, &texts.say("unsaved-title"), text, below, |ui| {
        let buttons = |ui: &mut Ui| {
            let again = primary_button(ui, again, true);
            let stay = button(ui, stay);
            let lose = ui.add(egui::Button::new(RichText::new(leave).color(BAD)));
            focus_ring(ui, &lose);
            asked = [
                (again.clicked(), Intent::TrySavingAgain),
                (stay.clicked(), Intent::DismissMessage),
                (lose.clicked(), Intent::LeaveUnsaved),
            ]
            .into_iter()
            .find_map(|(clicked, intent)| clicked.then_some(intent));
            first = Some(again);
        };
        if narrow {
            ui.vertical(buttons);
        } else {
            ui.horizontal(buttons);
        }
    });
    if let Some(again) = first {
        pass.offer_focus(&again);
    }
    pass.intents.extend(asked);
}

/// The width that buttons of these labels take beside one another.
fn side_by_side_width(ui: &Ui, labels: &[String]) -> f32 {
    let spacing = ui.spacing();
    let width = |label: &String| {
        let font = FontId::proportional(16.0);
        let words = ui.painter().layout_no_wrap(label.clone(), font, TEXT);
        words.size().x + 2.0 * spacing.button_padding.x
    };
    let gaps = labels.len().saturating_sub(1) as f32 * spacing.item_spacing.x;
    labels.iter().map(width).sum::<f32>() + gaps
}

/// Width inside a dialog, in points.
fn inner_width(pass: &Pass<'_>) -> f32 {
    let screen = inset(pass.regions.whole, GRID);
    WIDTH.min(screen.width()) - 2.0 * margin(pass)
}

/// Between a dialog's edge and its words, in points.
fn margin(pass: &Pass<'_>) -> f32 {
    if pass.regions.compact { GRID } else { MARGIN }
}

/// A panel just high enough for its words, which scroll if the screen is not,
/// and `below` points of something under them.
pub(crate) fn dialog(
    ui: &mut Ui,
    pass: &Pass<'_>,
    title: &str,
    text: &str,
    below: f32,
    contents: impl FnOnce(&mut Ui),
) {
    let screen = inset(pass.regions.whole, GRID);
    let margin = margin(pass);
    let width = WIDTH.min(screen.width());
    let wrap = (width - 2.0 * margin - GRID).max(1.0);
    let heading = FontId::proportional(24.0);
    let height_of = |text: &str, font: FontId| {
        if text.is_empty() {
            return 0.0;
        }
        ui.painter()
            .layout(text.to_owned(), font, TEXT, wrap)
            .size()
            .y
            + GRID
    };
    let words =
        height_of(title, heading.clone()) + height_of(text, FontId::proportional(16.0)) + GRID;
    let height = (words + below + 2.0 * margin).min(screen.height());
    let rect = Rect::from_center_size(screen.center(), vec2(width, height));
    let inner = inset(rect, margin);
    ui.painter().add(panel(rect));
    pass.dialog.set(Some(rect));
    let mut ui = ui.new_child(UiBuilder::new().id_salt("dialog").max_rect(inner));
    ui.set_clip_rect(rect);
    scroll(&mut ui, (inner.height() - below).max(0.0), |ui| {
        ui.label(RichText::new(title).font(heading));
        if !text.is_empty() {
            ui.label(text);
        }
    });
    contents(&mut ui);
}

fn progress_bar(ui: &mut Ui, title: &str, progress: Option<f32>) {
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), GRID), Sense::hover());
    response.widget_info(|| {
        let mut info = WidgetInfo::labeled(Role::ProgressIndicator, true, title);
        info.value = progress.map(|part| f64::from(part * 100.0).floor());
        info
    });
    let (from, to) = if let Some(part) = progress {
        (0.0, part.clamp(0.0, 1.0))
    } else {
        ui.ctx().request_repaint();
        let phase = ui.input(|input| input.time) * 0.6;
        let middle = 0.5 - 0.5 * (phase * std::f64::consts::TAU).cos() as f32;
        (0.75 * middle, 0.75 * middle + 0.25)
    };
    ui.painter().rect_filled(rect, 4, LINE);
    let lit = Rect::from_x_y_ranges(
        rect.min.x + from * rect.width()..=rect.min.x + to * rect.width(),
        rect.y_range(),
    );
    ui.painter().rect_filled(lit, 4, ACCENT);
}
