//! A colour that is chosen: from a few that go well together, or by its red, green and blue. egui's own picker has words in one
//! language only.

use egui::ecolor::Hsva;
use egui::{
    Color32, Popup, PopupCloseBehavior, Response, Role, Sense, Slider, Ui, WidgetInfo, vec2,
};

use crate::theme::LINE;
use crate::widgets::focus_ring;

/// Sides of the button and of a swatch, points.
const BUTTON: egui::Vec2 = vec2(44.0, 20.0);
const SWATCH: egui::Vec2 = vec2(24.0, 20.0);
/// How many swatches stand in a row.
const COLUMNS: usize = 8;
/// Saturation and value of the rows of swatches that have a hue.
const ROWS: [(f32, f32); 3] = [(0.35, 0.95), (0.7, 0.85), (0.8, 0.5)];

/// The button, and the page that it opens. Returns whether the colour was changed, and then whether the hand has let go.
pub(super) fn button(ui: &mut Ui, label: &str, rgb: &mut [u8; 3]) -> Option<bool> {
    let [r, g, b] = *rgb;
    let said = format!("{label}: #{r:02x}{g:02x}{b:02x}");
    let response = swatch(ui, BUTTON, *rgb, &said);
    Popup::menu(&response)
        .close_behavior(PopupCloseBehavior::CloseOnClickOutside)
        .show(|ui| page(ui, rgb))?
        .inner
}

fn page(ui: &mut Ui, rgb: &mut [u8; 3]) -> Option<bool> {
    let mut changed = None;
    ui.spacing_mut().item_spacing = vec2(4.0, 4.0);
    for row in swatches().chunks(COLUMNS) {
        ui.horizontal(|ui| {
            for colour in row {
                let [r, g, b] = *colour;
                let said = format!("#{r:02x}{g:02x}{b:02x}");
                if swatch(ui, SWATCH, *colour, &said).clicked() {
                    *rgb = *colour;
                    changed = Some(true);
                }
            }
        });
    }
    for (name, part) in ["R", "G", "B"].into_iter().zip(rgb) {
        let response = ui.add(Slider::new(part, 0..=255).text(name));
        focus_ring(ui, &response);
        if response.changed() || response.drag_stopped() {
            changed = Some(!response.dragged());
        }
    }
    changed
}

/// From black to white, then each hue light, strong and dark.
fn swatches() -> Vec<[u8; 3]> {
    let share = |it: usize, of: usize| it as f32 / of as f32;
    let grey = |it: usize| [(255.0 * share(it, COLUMNS - 1)).round() as u8; 3];
    let hue = |(s, v): (f32, f32)| {
        (0..COLUMNS).map(move |it| Hsva::new(share(it, COLUMNS), s, v, 1.0).to_srgb())
    };
    (0..COLUMNS)
        .map(grey)
        .chain(ROWS.into_iter().flat_map(hue))
        .collect()
}

fn swatch(ui: &mut Ui, size: egui::Vec2, [r, g, b]: [u8; 3], said: &str) -> Response {
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    response.widget_info(|| WidgetInfo::labeled(Role::ColorWell, true, said));
    ui.painter().rect(
        rect,
        4,
        Color32::from_rgb(r, g, b),
        egui::Stroke::new(1.0, LINE),
        egui::StrokeKind::Inside,
    );
    focus_ring(ui, &response);
    response
}
