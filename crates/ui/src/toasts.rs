//! Lines that come and go: something was done, or went wrong. They lie on nothing that can be pressed or read.

use egui::{
    Context, FontId, Id, Label, LayerId, Order, Rect, RichText, Ui, UiBuilder, Vec2, pos2, vec2,
};

use crate::layout::inset;
use crate::model::ToastKind;
use crate::theme::{BAD, GRID, TEXT, panel};

/// How many are shown at once; older ones give way.
const MOST: usize = 4;
/// Widest a toast gets beside something, in points.
const WIDTH: f32 = 400.0;
/// Least height above or below something, and least width at its right, that toasts are put into, in points.
const HEIGHT_LEAST: f32 = 48.0;
const WIDTH_LEAST: f32 = 200.0;
/// Least width at its left: there they stand only where all other sides are taken.
const WIDTH_LAST: f32 = 100.0;
/// Most of the window's height that screens give way by.
const SHARE_MOST: f32 = 0.4;
/// Sizes of its words, in points: the largest that has room is taken.
const SIZES: [f32; 3] = [16.0, 13.0, 11.0];

/// Where toasts may be.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Room {
    pub rect: Rect,
    /// Whether those that do not fit wait until something goes.
    pub waits: bool,
}

impl Room {
    /// Of a world on which no screen lies: right of the crosshair, above the `instruments` that the display shows there.
    pub(crate) fn in_world(screen: Rect, instruments: Rect) -> Self {
        let width = WIDTH.min(0.5 * screen.width() - 4.0 * GRID).max(1.0);
        let rect = inset(screen, GRID);
        let bottom = rect.max.y.min(instruments.min.y - GRID);
        Self {
            rect: rect.with_min_x(rect.max.x - width).with_max_y(bottom),
            waits: false,
        }
    }

    /// Of a part of the window in which a world is seen: at its lower right.
    pub(crate) fn in_tile(tile: Rect) -> Self {
        let rect = inset(tile, GRID);
        let width = WIDTH.min(rect.width()).max(1.0);
        let top = rect.center().y.min(rect.max.y - 1.0);
        let rect = rect.with_min_x(rect.max.x - width).with_min_y(top);
        Self { rect, waits: false }
    }

    /// Above a dialog, if there is room.
    pub(crate) fn above(screen: Rect, dialog: Rect) -> Self {
        let rect = Self::in_world(screen, Rect::NOTHING).rect;
        let rect = rect.with_max_y(dialog.min.y - GRID);
        Self { rect, waits: true }
    }

    /// Right of everything that is left of `x`, if there is room.
    pub(crate) fn right_of(screen: Rect, x: f32) -> Option<Self> {
        let rect = inset(screen, GRID);
        let rect = rect.with_min_x((x + GRID).max(rect.max.x - WIDTH));
        (rect.width() >= WIDTH_LEAST).then_some(Self { rect, waits: false })
    }

    /// Beside something that covers a part of the world; they wait where there is no room.
    pub(crate) fn beside(screen: Rect, taken: Rect) -> Self {
        let whole = inset(screen, GRID);
        let across = whole.with_min_x(whole.max.x - WIDTH.min(whole.width()));
        let above = across.with_max_y(taken.min.y - GRID);
        let below = across.with_min_y(taken.max.y + GRID);
        let right = whole.with_min_x((taken.max.x + GRID).max(whole.max.x - WIDTH));
        let left = whole.with_max_x(taken.min.x - GRID);
        let left = left.with_min_x(left.min.x.max(left.max.x - WIDTH));
        let sides = [
            (above, above.height() >= HEIGHT_LEAST),
            (right, right.width() >= WIDTH_LEAST),
            (below, below.height() >= HEIGHT_LEAST),
            (left, left.width() >= WIDTH_LAST),
        ];
        let found = sides
            .into_iter()
            .find_map(|(side, fits)| fits.then_some(side));
        Self {
            rect: found.unwrap_or(Rect::NOTHING),
            waits: true,
        }
    }
}

/// The toasts that are up, oldest first.
#[derive(Default)]
pub(crate) struct Toasts {
    up: Vec<Toast>,
}

struct Toast {
    text: String,
    kind: ToastKind,
    /// When it goes, in egui's seconds; set when it is first drawn, so that a
    /// long load does not swallow it.
    until_s: Option<f64>,
}

impl Toasts {
    pub(crate) fn push(&mut self, text: String, kind: ToastKind) {
        let replaced = |toast: &Toast| {
            toast.text == text || (kind == ToastKind::State && toast.kind == ToastKind::State)
        };
        self.up.retain(|toast| !replaced(toast));
        self.up.push(Toast {
            text,
            kind,
            until_s: None,
        });
        let over = self.up.len().saturating_sub(MOST);
        self.up.drain(..over);
    }

    /// How high a strip of that width has to be for them, in points: the last one whole, and as many of the others as
    /// leave most of the window alone.
    pub(crate) fn strip(&mut self, ctx: &Context, width: f32) -> f32 {
        self.drop_old(ctx);
        let most = SHARE_MOST * ctx.content_rect().height();
        let mut strip = 0.0;
        for toast in self.up.iter().rev() {
            let (_, size) = fitting(ctx, &toast.text, vec2(width, f32::INFINITY));
            let height = strip + size.y + GRID;
            if strip > 0.0 && height > most {
                break;
            }
            strip = height;
        }
        strip
    }

    /// Draws them at the right of their room, the last one lowest, and that where the middle of the window is if it
    /// can be. The time of one for which there is no room begins when there is.
    pub(crate) fn show(&mut self, ctx: &Context, room: Room) {
        self.drop_old(ctx);
        let now_s = ctx.input(|input| input.time);
        let Room { rect: room, waits } = room;
        let words: Vec<_> = self
            .up
            .iter()
            .map(|toast| fitting(ctx, &toast.text, room.size()))
            .collect();
        let mut fitting = 0;
        let mut height = 0.0;
        for (_, size) in words.iter().rev() {
            let with_it = height + size.y;
            let must = fitting == 0 && !waits;
            if with_it > room.height() + 0.5 && !must {
                break;
            }
            fitting += 1;
            height = with_it + GRID;
        }
        let middle = ctx.content_rect().center().y;
        let mut bottom = middle.max(room.min.y + height - GRID).min(room.max.y);
        let first = self.up.len() - fitting;
        for (index, (toast, (font, size))) in self.up.iter_mut().zip(words).enumerate().rev() {
            if index < first {
                toast.until_s = None;
                continue;
            }
            let corner = pos2(room.max.x - size.x, bottom - size.y);
            let rect = Rect::from_min_size(corner, size);
            bottom = rect.min.y - GRID;
            let until = *toast.until_s.get_or_insert(now_s + stay_s(toast.kind));
            ctx.request_repaint_after_secs((until - now_s) as f32);
            paint(ctx, index, rect, toast, font);
        }
    }

    fn drop_old(&mut self, ctx: &Context) {
        let now_s = ctx.input(|input| input.time);
        self.up
            .retain(|toast| toast.until_s.is_none_or(|until| now_s < until));
    }
}

/// The font of a toast of these words and what it covers, in points: the largest that fits into the `room`, else the
/// smallest.
fn fitting(ctx: &Context, text: &str, room: Vec2) -> (FontId, Vec2) {
    let wrap = (room.x - 3.0 * GRID).max(1.0);
    let mut fitting = (FontId::default(), Vec2::ZERO);
    for size in SIZES {
        let font = FontId::proportional(size);
        let layout = || ctx.fonts_mut(|it| it.layout(text.to_owned(), font.clone(), TEXT, wrap));
        let words = layout().size();
        fitting = (font, vec2(words.x + 3.0 * GRID, words.y + 2.0 * GRID));
        if fitting.1.y <= room.y {
            break;
        }
    }
    fitting
}

fn paint(ctx: &Context, index: usize, rect: Rect, toast: &Toast, font: FontId) {
    let id = Id::unique(("antipode-toast", index));
    let layer = LayerId::new(Order::Foreground, Id::unique("antipode-toasts"));
    let colour = match toast.kind {
        ToastKind::Info | ToastKind::State => TEXT,
        ToastKind::Problem => BAD,
    };
    let mut ui = Ui::new(
        ctx.clone(),
        id,
        UiBuilder::new().layer_id(layer).max_rect(rect),
    );
    ui.painter().add(panel(rect));
    let inner = Rect::from_min_max(
        rect.min + vec2(1.5 * GRID, GRID),
        rect.max - vec2(GRID, GRID),
    );
    let label = Label::new(RichText::new(&toast.text).font(font).color(colour)).wrap();
    // `put` would justify the words: lines ended by a long path get their letters spread.
    ui.new_child(UiBuilder::new().max_rect(inner)).add(label);
}

fn stay_s(kind: ToastKind) -> f64 {
    match kind {
        ToastKind::Info | ToastKind::State => 4.0,
        ToastKind::Problem => 8.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_lines_that_tell_a_state_only_the_last_stays_up() {
        let mut toasts = Toasts::default();
        toasts.push("Raised map".into(), ToastKind::State);
        toasts.push("Saved".into(), ToastKind::Info);
        toasts.push("Horizon map".into(), ToastKind::State);
        let up: Vec<_> = toasts.up.iter().map(|toast| toast.text.as_str()).collect();
        assert_eq!(up, ["Saved", "Horizon map"]);
    }
}
