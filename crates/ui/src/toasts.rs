//! Lines that come and go: something was done, or went wrong.

use egui::{
    Context, FontId, Id, Label, LayerId, Order, Rect, RichText, Ui, UiBuilder, Vec2, pos2, vec2,
};

use crate::model::ToastKind;
use crate::theme::{BAD, GRID, TEXT, panel};

/// How many are shown at once; older ones give way.
const MOST: usize = 4;
/// Widest a toast gets, in points.
const WIDTH: f32 = 400.0;

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

    /// Draws them at the right, from the middle of the screen upwards, but never on a `dialog`: those that would lie
    /// on it stand above it, and wait where there is no room. `end_x`: where their room ends, if not with the screen.
    pub(crate) fn show(&mut self, ctx: &Context, dialog: Option<Rect>, end_x: Option<f32>) {
        let now_s = ctx.input(|input| input.time);
        self.up
            .retain(|toast| toast.until_s.is_none_or(|until| now_s < until));
        let screen = ctx.content_rect();
        let end_x = end_x.unwrap_or(screen.max.x);
        // Right of the crosshair and above the dial, however small the screen is.
        let width = WIDTH
            .min(0.5 * screen.width() - 4.0 * GRID)
            .min(end_x - screen.min.x - 2.0 * GRID)
            .max(1.0);
        let mut bottom = screen.center().y;
        for (index, toast) in self.up.iter_mut().enumerate().rev() {
            let size = size_of(ctx, &toast.text, width);
            let place = |bottom: f32| {
                let corner = pos2(end_x - GRID - size.x, bottom - size.y);
                Rect::from_min_size(corner, size)
            };
            let mut rect = place(bottom);
            if let Some(dialog) = dialog.filter(|dialog| dialog.expand(GRID).intersects(rect)) {
                rect = place(dialog.min.y - GRID);
            }
            if dialog.is_some() && rect.min.y < screen.min.y {
                // Its time begins when there is room for it.
                toast.until_s = None;
                continue;
            }
            bottom = rect.min.y - GRID;
            let until = *toast.until_s.get_or_insert(now_s + stay_s(toast.kind));
            ctx.request_repaint_after_secs((until - now_s) as f32);
            paint(ctx, index, rect, toast);
        }
    }
}

/// What a toast of these words covers, at most `width` wide, in points.
fn size_of(ctx: &Context, text: &str, width: f32) -> Vec2 {
    let wrap = (width - 3.0 * GRID).max(1.0);
    let font = FontId::proportional(16.0);
    let words = ctx.fonts_mut(|fonts| fonts.layout(text.to_owned(), font, TEXT, wrap).size());
    vec2(words.x + 3.0 * GRID, words.y + 2.0 * GRID)
}

fn paint(ctx: &Context, index: usize, rect: Rect, toast: &Toast) {
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
    let label = Label::new(RichText::new(&toast.text).color(colour)).wrap();
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
