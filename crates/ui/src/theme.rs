//! Colours, sizes and the one egui style that everything is drawn in.

use egui::epaint::RectShape;
use egui::style::ScrollStyle;
use egui::{
    Color32, Context, CornerRadius, FontFamily, FontId, Rect, Shape, Stroke, StrokeKind, Style,
    TextStyle, Theme, vec2,
};

use crate::fonts;

/// The one accent: warm orange, as the lamps.
pub(crate) const ACCENT: Color32 = Color32::from_rgb(0xF2, 0x99, 0x4A);
/// The accent where it lies behind text.
pub(crate) const ACCENT_DIM: Color32 = Color32::from_rgba_unmultiplied_const(0xF2, 0x99, 0x4A, 70);
/// The focus ring: lighter than the accent, so it shows round an accent button too.
pub(crate) const FOCUS: Color32 = Color32::from_rgb(0xFF, 0xDD, 0xB5);
/// Text on the accent.
pub(crate) const ON_ACCENT: Color32 = Color32::from_rgb(0x1C, 0x12, 0x08);
/// Body text.
pub(crate) const TEXT: Color32 = Color32::from_rgb(0xED, 0xEF, 0xF4);
/// Secondary text.
pub(crate) const WEAK: Color32 = Color32::from_rgb(0xB2, 0xB9, 0xC9);
/// Something is valid.
pub(crate) const GOOD: Color32 = Color32::from_rgb(0x7E, 0xD9, 0x9B);
/// Something is wrong.
pub(crate) const BAD: Color32 = Color32::from_rgb(0xFF, 0x85, 0x7A);
/// Panels: dark, the world shining through a little.
pub(crate) const PANEL: Color32 = Color32::from_rgba_unmultiplied_const(0x0F, 0x13, 0x1E, 236);
/// Small plates on the display, over any background.
pub(crate) const PLATE: Color32 = Color32::from_rgba_unmultiplied_const(0x08, 0x0B, 0x13, 150);
/// Over the world behind the pause menu.
pub(crate) const SCRIM: Color32 = Color32::from_rgba_unmultiplied_const(0x06, 0x08, 0x10, 150);
/// Outline of what the pointer is on: plain light, since the accent and the ring are the keyboard's focus.
pub(crate) const HOVER: Color32 = Color32::from_rgba_unmultiplied_const(0xFF, 0xFF, 0xFF, 160);
/// Outlines of panels and rows.
pub(crate) const LINE: Color32 = Color32::from_rgba_unmultiplied_const(0xFF, 0xFF, 0xFF, 28);

/// The grid that distances are multiples of, in points.
pub(crate) const GRID: f32 = 8.0;
/// Rounding of every corner, in points.
pub(crate) const ROUNDING: u8 = 8;

/// Time in which buttons and scrolling come to rest, in seconds.
pub(crate) const ANIMATION_S: f32 = 0.08;

/// Gives `ctx` the game's look; call once, before the first frame.
pub fn apply_theme(ctx: &Context) {
    fonts::add(ctx);
    ctx.set_theme(Theme::Dark);
    ctx.all_styles_mut(style);
    // A button acts on release however long it was held; at ten frames a second a click is easily long.
    ctx.options_mut(|options| options.input_options.max_click_duration = f64::INFINITY);
}

/// A dark translucent panel that fills `rect`.
pub(crate) fn panel(rect: Rect) -> Shape {
    let line = Stroke::new(1.0, LINE);
    RectShape::new(rect, ROUNDING, PANEL, line, StrokeKind::Inside).into()
}

/// The font of secondary text.
pub(crate) fn small() -> FontId {
    FontId::proportional(13.0)
}

/// The font of figures that must not dance.
pub(crate) fn mono() -> FontId {
    FontId::monospace(13.0)
}

fn style(style: &mut Style) {
    style.text_styles = [
        (TextStyle::Heading, FontId::proportional(24.0)),
        (TextStyle::Body, FontId::proportional(16.0)),
        (TextStyle::Button, FontId::proportional(16.0)),
        (
            TextStyle::Monospace,
            FontId::new(14.0, FontFamily::Monospace),
        ),
        (TextStyle::Small, small()),
    ]
    .into();
    style.spacing.item_spacing = vec2(GRID, GRID);
    style.spacing.button_padding = vec2(12.0, 6.0);
    style.spacing.interact_size = vec2(40.0, 32.0);
    style.spacing.slider_rail_height = 6.0;
    style.spacing.scroll = scroll_bars();
    style.interaction.selectable_labels = false;
    style.animation_time = ANIMATION_S;
    visuals(&mut style.visuals);
}

/// Bars beside what they scroll: a light handle that stands out from its dark track. egui would paint it in the fill of
/// a button, which on a panel can hardly be told from the panel, so that the bare track looks like the handle.
fn scroll_bars() -> ScrollStyle {
    ScrollStyle {
        bar_width: 10.0,
        handle_min_length: 32.0,
        foreground_color: true,
        ..ScrollStyle::solid()
    }
}

fn visuals(visuals: &mut egui::Visuals) {
    visuals.dark_mode = true;
    visuals.weak_text_color = Some(WEAK);
    // Menus and pages lie over words.
    visuals.window_fill = PANEL.to_opaque();
    visuals.panel_fill = PANEL;
    visuals.extreme_bg_color = Color32::from_rgba_unmultiplied_const(0, 0, 0, 130);
    visuals.error_fg_color = BAD;
    visuals.warn_fg_color = ACCENT;
    visuals.hyperlink_color = ACCENT;
    visuals.selection.bg_fill = ACCENT_DIM;
    visuals.selection.stroke = Stroke::new(2.0, FOCUS);
    visuals.slider_trailing_fill = true;
    // Steady: each blink would have the world behind a paused menu drawn anew.
    visuals.text_cursor.blink = false;
    visuals.text_cursor.stroke = Stroke::new(2.0, ACCENT);
    visuals.window_corner_radius = CornerRadius::same(ROUNDING);
    visuals.menu_corner_radius = CornerRadius::same(ROUNDING);
    let widgets = &mut visuals.widgets;
    for (state, fill, line, text) in [
        (&mut widgets.noninteractive, 14, LINE, TEXT),
        (&mut widgets.inactive, 22, LINE, TEXT),
        (&mut widgets.hovered, 44, HOVER, Color32::WHITE),
        (&mut widgets.active, 40, ACCENT, Color32::WHITE),
        (&mut widgets.open, 40, ACCENT, Color32::WHITE),
    ] {
        let fill = Color32::from_rgba_unmultiplied(255, 255, 255, fill);
        state.weak_bg_fill = fill;
        state.bg_fill = fill;
        state.bg_stroke = Stroke::new(1.0, line);
        state.fg_stroke = Stroke::new(1.5, text);
        state.corner_radius = CornerRadius::same(ROUNDING);
        state.expansion = 0.0;
    }
}
