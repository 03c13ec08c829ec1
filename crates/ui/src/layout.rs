//! Lays out screens of any size. Its rectangles never turn inside out, and every sub-screen is drawn in its pane.

use std::cmp::Ordering;
use std::sync::Arc;

use egui::scroll_area::ScrollBarVisibility;
use egui::{Context, Id, Key, Rect, Response, RichText, ScrollArea, Ui, UiBuilder, pos2, vec2};

use crate::theme::{GRID, WEAK, panel};

/// Under this width the column and the pane take turns instead of standing
/// side by side, in points.
const TWO_PANE_WIDTH: f32 = 600.0;
/// A pane is not drawn wider than this: lines of text get hard to follow.
const PANE_WIDTH: f32 = 720.0;
/// Room for the focus ring, which stands outside a widget, in points.
const RING: f32 = 4.0;

/// The rectangles of one frame of the menu.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Regions {
    pub whole: Rect,
    pub column: Rect,
    pub pane: Rect,
    /// Whether column and pane stand side by side.
    pub wide: bool,
    /// Whether height is scarce: smaller buttons, smaller gaps.
    pub compact: bool,
}

impl Regions {
    pub(crate) fn of(ctx: &Context) -> Self {
        Self::new(ctx.content_rect())
    }

    /// The same without a strip of that height at the lower end of what a pane is drawn in, and the strip.
    pub(crate) fn without_strip(mut self, height: f32) -> (Self, Rect) {
        let edge = (self.pane.max.y - height).max(self.pane.min.y);
        let strip = self.pane.with_min_y((edge + GRID).min(self.pane.max.y));
        self.pane.max.y = edge;
        if !self.wide {
            self.column.max.y = edge;
        }
        (self, strip)
    }

    fn new(whole: Rect) -> Self {
        let wide = whole.width() >= TWO_PANE_WIDTH;
        let compact = whole.height() < 520.0;
        let margin = if compact { GRID } else { 2.0 * GRID };
        if !wide {
            let pane = inset(whole, margin.min(GRID));
            return Self {
                whole,
                column: whole,
                pane,
                wide,
                compact,
            };
        }
        let width = if whole.width() < 900.0 { 216.0 } else { 264.0 };
        let mut column = whole;
        column.set_width(width);
        let mut pane = inset(whole.with_min_x(column.max.x), margin);
        pane.set_width(pane.width().min(PANE_WIDTH));
        Self {
            whole,
            column,
            pane,
            wide,
            compact,
        }
    }
}

/// `rect` made smaller on all sides, but never inside out.
pub(crate) fn inset(rect: Rect, margin: f32) -> Rect {
    let x = margin.min(rect.width() * 0.5).max(0.0);
    let y = margin.min(rect.height() * 0.5).max(0.0);
    Rect::from_min_max(
        pos2(rect.min.x + x, rect.min.y + y),
        pos2(rect.max.x - x, rect.max.y - y),
    )
}

/// What in a pane's body can hold the focus. egui looks for the next widget by
/// where it lies, scrolled out of sight or not, and so would step from the last
/// visible row to the footer, and it stops at both ends; the arrows go through
/// here first.
#[derive(Clone, Default)]
pub(crate) struct Stops(Vec<(Id, Rect)>);

impl Stops {
    pub(crate) fn add(&mut self, response: &Response) {
        self.0.push((response.id, response.rect));
    }

    /// Everything that can hold the focus within `rect`.
    pub(crate) fn within(ui: &Ui, rect: Rect) -> Self {
        let layer = ui.layer_id();
        Self(ui.ctx().viewport(|viewport| {
            let widgets = viewport.this_pass.widgets.get_layer(layer);
            let stops = widgets.filter(|widget| widget.enabled && widget.sense.is_focusable());
            let stops = stops.map(|widget| (widget.id, widget.rect));
            stops.filter(|stop| rect.contains_rect(stop.1)).collect()
        }))
    }

    /// Moves the focus up or down if an arrow asks for it: to the next stop, from the last one on into `footer`, and
    /// from the end to the beginning.
    pub(crate) fn step(&self, ui: &Ui, footer: &Self) {
        let Some((from, down)) = self.asked(ui).or_else(|| footer.asked(ui)) else {
            return;
        };
        let below = || footer.nearest(from, down).filter(|_| down);
        let next = self
            .nearest(from, down)
            .or_else(below)
            .or_else(|| self.outermost(from, !down));
        if let Some((id, _)) = next {
            let ctx = ui.ctx();
            ctx.memory_mut(|memory| memory.move_focus(egui::FocusDirection::None));
            let asked: NextFocus = Some((id, ctx.cumulative_pass_nr()));
            ctx.data_mut(|data| data.insert_temp(Id::unique(NEXT_FOCUS), asked));
            ctx.request_repaint();
        }
    }

    /// Moves the focus where the last frame wanted it: a widget sees that it has got the focus, and comes into view,
    /// only if that was before it was drawn.
    pub(crate) fn take_step(ctx: &Context) {
        let id = Id::unique(NEXT_FOCUS);
        let asked = ctx.data_mut(|data| data.remove_temp::<NextFocus>(id));
        if let Some((id, pass)) = asked.flatten()
            && pass + 1 == ctx.cumulative_pass_nr()
        {
            ctx.memory_mut(|memory| memory.request_focus(id));
        }
    }

    /// Where the focus is, if it is on one of these, and whether an arrow asks for it to go down rather than up.
    fn asked(&self, ui: &Ui) -> Option<(Rect, bool)> {
        let pressed = |key| ui.input(|input| input.key_pressed(key));
        let down = pressed(Key::ArrowDown);
        let focused = ui.ctx().memory(egui::Memory::focused);
        let from = self.0.iter().find(|(id, _)| Some(*id) == focused);
        let (_, from) = from.filter(|_| down != pressed(Key::ArrowUp))?;
        Some((*from, down))
    }

    /// The stop that is next below (or above) `from`, and nearest sideways.
    fn nearest(&self, from: Rect, down: bool) -> Option<(Id, Rect)> {
        let along = |rect: &Rect| {
            if down {
                rect.min.y - from.max.y
            } else {
                from.min.y - rect.max.y
            }
        };
        let ahead = self.0.iter().filter(|(_, rect)| along(rect) >= 0.0);
        least(ahead, |rect| (along(rect), sideways(rect, from)))
    }

    /// The lowest (or highest) stop, and of those the nearest sideways to `from`.
    fn outermost(&self, from: Rect, down: bool) -> Option<(Id, Rect)> {
        let height = |rect: &Rect| if down { -rect.max.y } else { rect.min.y };
        least(self.0.iter(), |rect| (height(rect), sideways(rect, from)))
    }
}

/// How far a stop is from the middle of `from` sideways, in points.
fn sideways(rect: &Rect, from: Rect) -> f32 {
    (rect.center().x - from.center().x).abs()
}

/// The stop of which `measure` is least.
fn least<'a>(
    stops: impl Iterator<Item = &'a (Id, Rect)>,
    measure: impl Fn(&Rect) -> (f32, f32),
) -> Option<(Id, Rect)> {
    let order = |a: &Rect, b: &Rect| {
        let order = measure(a).partial_cmp(&measure(b));
        order.unwrap_or(Ordering::Equal)
    };
    stops.min_by(|(_, a), (_, b)| order(a, b)).copied()
}

/// The widget that is to have the focus in the next frame, and the pass that wanted it.
type NextFocus = Option<(Id, u64)>;

/// Where it is kept meanwhile.
const NEXT_FOCUS: &str = "antipode-next-focus";

/// A part of a screen whose widgets keep the focus whatever comes up or goes before it: egui counts widgets to tell
/// them apart, so that one line more above would make every button below another one. `name` is unlike any other on the
/// same level.
pub(crate) fn steady<R>(ui: &mut Ui, name: &str, add: impl FnOnce(&mut Ui) -> R) -> R {
    let id = ui.scope_id().with(egui::IdSalt::new(name));
    ui.scope_builder(UiBuilder::new().scope_id(id), add).inner
}

/// A panel filling `rect`: title, a body that scrolls, and a footer that always
/// stays in view.
pub(crate) fn pane<R>(
    ui: &mut Ui,
    rect: Rect,
    title: &str,
    body: impl FnOnce(&mut Ui, &mut Stops) -> R,
    footer: impl FnOnce(&mut Ui),
) -> R {
    pane_with(
        ui,
        rect,
        title,
        ScrollBarVisibility::VisibleWhenNeeded,
        body,
        footer,
    )
}

/// The same for a body that is longer than any usual window: its scroll bar is there from the first frame, whereas
/// whether another needs one is known only after it was laid out.
pub(crate) fn long_pane<R>(
    ui: &mut Ui,
    rect: Rect,
    title: &str,
    body: impl FnOnce(&mut Ui, &mut Stops) -> R,
    footer: impl FnOnce(&mut Ui),
) -> R {
    pane_with(
        ui,
        rect,
        title,
        ScrollBarVisibility::AlwaysVisible,
        body,
        footer,
    )
}

fn pane_with<R>(
    ui: &mut Ui,
    rect: Rect,
    title: &str,
    bar: ScrollBarVisibility,
    body: impl FnOnce(&mut Ui, &mut Stops) -> R,
    footer: impl FnOnce(&mut Ui),
) -> R {
    let margin = if rect.height() < 480.0 { 12.0 } else { 16.0 };
    ui.painter().add(panel(rect));
    let inner = inset(rect, margin);
    let mut ui = ui.new_child(UiBuilder::new().id_salt(title).max_rect(inner));
    ui.set_clip_rect(rect);
    ui.label(RichText::new(title).heading());
    let footer_height = ui.spacing().interact_size.y + GRID;
    let body_height = (inner.max.y - ui.cursor().min.y - footer_height).max(24.0);
    Stops::take_step(ui.ctx());
    let mut stops = Stops::default();
    let result = scroll_with(&mut ui, body_height, bar, |ui| body(ui, &mut stops));
    let footer = ui.horizontal(footer).response.rect;
    stops.step(&ui, &Stops::within(&ui, footer));
    result
}

/// A vertical scroll area of that height, which PageUp, PageDown, Home and End
/// move as well: not everything worth reading can hold the focus.
pub(crate) fn scroll<R>(ui: &mut Ui, height: f32, contents: impl FnOnce(&mut Ui) -> R) -> R {
    scroll_with(ui, height, ScrollBarVisibility::VisibleWhenNeeded, contents)
}

fn scroll_with<R>(
    ui: &mut Ui,
    height: f32,
    bar: ScrollBarVisibility,
    contents: impl FnOnce(&mut Ui) -> R,
) -> R {
    // Home and End belong to a text field while one is being edited.
    let editing = ui.ctx().text_edit_focused();
    let pages = ui.input(|input| {
        let pressed = |key, amount: f32| if input.key_pressed(key) { amount } else { 0.0 };
        let page = pressed(Key::PageUp, 1.0) + pressed(Key::PageDown, -1.0);
        let all = pressed(Key::Home, 1e5) + pressed(Key::End, -1e5);
        if editing { page } else { page + all }
    });
    let mut rect = ui.available_rect_before_wrap();
    rect.set_height(height.max(0.0));
    // The margin that holds focus rings hangs over the edge: the text in it
    // lines up with the text outside.
    let area = rect.expand2(vec2(RING, 0.0));
    let mut child = ui.new_child(UiBuilder::new().id_salt("scroll").max_rect(area));
    // The bar is painted in what words on buttons are; a little weaker, it does not outshine them.
    let style = Arc::clone(child.style());
    child.visuals_mut().widgets.inactive.fg_stroke.color = WEAK;
    let result = ScrollArea::vertical()
        .max_height(rect.height())
        .min_scrolled_height(rect.height())
        .auto_shrink(false)
        .scroll_bar_visibility(bar)
        .content_margin(RING)
        .show(&mut child, |ui| {
            ui.set_style(style);
            if pages != 0.0 {
                ui.scroll_with_delta(vec2(0.0, pages * (height - 4.0 * GRID).max(GRID)));
            }
            within_width(ui, contents)
        })
        .inner;
    ui.advance_cursor_after_rect(rect);
    result
}

/// Contents that take no more than the width there is, however wide they come out: a scroll area makes room for what is
/// wider, and its bar would leave the pane.
fn within_width<R>(ui: &mut Ui, contents: impl FnOnce(&mut Ui) -> R) -> R {
    let room = ui.available_rect_before_wrap();
    let mut child = ui.new_child(UiBuilder::new().max_rect(room));
    let result = contents(&mut child);
    ui.advance_cursor_after_rect(room.with_max_y(child.min_rect().max.y));
    result
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_region_is_ever_inside_out() {
        for (width, height) in [
            (0.0, 0.0),
            (1.0, 1.0),
            (320.0, 200.0),
            (600.0, 3.0),
            (2560.0, 1440.0),
        ] {
            let regions = Regions::new(Rect::from_min_size(pos2(0.0, 0.0), vec2(width, height)));
            for rect in [regions.column, regions.pane] {
                assert!(rect.width() >= 0.0 && rect.height() >= 0.0, "{regions:?}");
                assert!(regions.whole.contains_rect(rect), "{regions:?}");
            }
        }
    }

    #[test]
    fn column_and_pane_stand_side_by_side_where_there_is_room() {
        let regions = Regions::new(Rect::from_min_size(pos2(0.0, 0.0), vec2(640.0, 360.0)));
        assert!(regions.wide && regions.compact);
        assert!(!regions.column.intersects(regions.pane));
    }
}
