//! Lays out the backpack: three lines of the backpack above the hotbar's, on windows of every size.

use egui::{Pos2, Rect, pos2, vec2};

use super::{HOTBAR, SLOTS};
use crate::layout::inset;
use crate::theme::GRID;

/// Slots in a line, and lines.
const COLUMNS: f32 = HOTBAR as f32;
const LINES: f32 = (SLOTS / HOTBAR) as f32;
const GAP: f32 = 4.0;
/// Between the backpack and the hotbar.
const PARTS: f32 = 12.0;
/// Largest and smallest side of a slot, in points.
const SIDE: (f32, f32) = (56.0, 4.0);
/// From this height on there is room for a title, and for what the mouse or the keys do.
const TITLED: f32 = 300.0;
const HELPED: f32 = 340.0;
/// Heights of both, and of the buttons, in points.
const TITLE: f32 = 32.0;
const HELP: f32 = 52.0;

/// What stands where.
#[derive(Clone, Copy, Debug)]
pub(super) struct Places {
    pub panel: Rect,
    pub title: Option<Rect>,
    pub help: Option<Rect>,
    pub foot: Rect,
    /// What is made of ground is shown here, in place of the slots and the help.
    pub page: Rect,
    /// Whether the slots are there to be pointed at.
    pub has_slots: bool,
    corner: Pos2,
    side: f32,
}

impl Places {
    pub(super) fn new(screen: Rect) -> Self {
        let screen = inset(screen, GRID);
        let margin = if screen.height() < TITLED { 6.0 } else { 12.0 };
        let title = if screen.height() < TITLED {
            0.0
        } else {
            TITLE + GRID
        };
        let help = if screen.height() < HELPED { 0.0 } else { HELP };
        let foot = if screen.height() < TITLED { 22.0 } else { 32.0 };
        let gaps = (COLUMNS - 1.0) * GAP;
        let between = (LINES - 2.0) * GAP + PARTS;
        let rest = title + help + foot + 2.0 * GRID + between + 2.0 * margin;
        let across = (screen.width() - 2.0 * margin - gaps) / COLUMNS;
        let down = (screen.height() - rest) / LINES;
        let side = across.min(down).clamp(SIDE.1, SIDE.0).floor();
        let size = vec2(COLUMNS * side + gaps + 2.0 * margin, LINES * side + rest);
        let panel = Rect::from_center_size(screen.center(), size.round());
        let inner = inset(panel, margin);
        let corner = inner.min + vec2(0.0, title);
        let below = corner.y + LINES * side + between + GRID;
        let line = |top: f32, height: f32| {
            Rect::from_min_max(pos2(inner.min.x, top), pos2(inner.max.x, top + height))
        };
        Self {
            panel,
            title: (title > 0.0).then(|| line(inner.min.y, TITLE)),
            help: (help > 0.0).then(|| line(below, help)),
            foot: line(below + help, foot),
            page: line(corner.y, below + help - GRID - corner.y),
            has_slots: true,
            corner,
            side,
        }
    }

    /// What a slot covers.
    pub(super) fn slot(&self, slot: u8) -> Rect {
        let (column, line) = (f32::from(slot % HOTBAR), line(slot));
        let mut corner = self.corner + vec2(column, f32::from(line)) * (self.side + GAP);
        if slot < HOTBAR {
            corner.y += PARTS - GAP;
        }
        Rect::from_min_size(corner, vec2(self.side, self.side))
    }

    /// The slot at a place.
    pub(super) fn slot_at(&self, at: Pos2) -> Option<u8> {
        let all = if self.has_slots { 0..SLOTS } else { 0..0 };
        all.into_iter().find(|slot| self.slot(*slot).contains(at))
    }
}

/// The line a slot stands in, from the top: the hotbar's is the last.
fn line(slot: u8) -> u8 {
    let lines = SLOTS / HOTBAR;
    (slot / HOTBAR + lines - 1) % lines
}

/// The slot so many columns to the right and lines down, within the lines.
pub(super) fn beside(slot: u8, [right, down]: [i32; 2]) -> u8 {
    let lines = i32::from(SLOTS / HOTBAR);
    let column = (i32::from(slot % HOTBAR) + right).clamp(0, i32::from(HOTBAR) - 1);
    let line = (i32::from(line(slot)) + down).clamp(0, lines - 1);
    (((line + 1) % lines) * i32::from(HOTBAR) + column) as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_slot_lies_on_another_or_leaves_the_panel_in_any_window() {
        for (width, height) in [
            (320.0, 200.0),
            (427.0, 240.0),
            (640.0, 360.0),
            (800.0, 600.0),
            (2560.0, 1440.0),
        ] {
            let screen = Rect::from_min_size(Pos2::ZERO, vec2(width, height));
            let places = Places::new(screen);
            assert!(screen.contains_rect(places.panel), "{places:?}");
            let all: Vec<_> = (0..SLOTS).map(|slot| places.slot(slot)).collect();
            for (place, rect) in all.iter().enumerate() {
                assert!(
                    places.panel.contains_rect(*rect),
                    "{place} in {width}x{height}"
                );
                assert!(!rect.intersects(places.foot));
                assert!(places.help.is_none_or(|help| !help.intersects(*rect)));
                assert!(places.title.is_none_or(|title| !title.intersects(*rect)));
                assert!(all[..place].iter().all(|other| !other.intersects(*rect)));
                assert_eq!(places.slot_at(rect.center()), Some(place as u8));
            }
            assert!(all[0].min.y > all[39].max.y, "the hotbar is below");
            assert!(places.panel.contains_rect(places.page), "{places:?}");
            assert!(!places.page.intersects(places.foot));
            assert!(places.title.is_none_or(|it| !it.intersects(places.page)));
            let turned = Places {
                has_slots: false,
                ..places
            };
            assert_eq!(turned.slot_at(all[0].center()), None);
        }
        Places::new(Rect::from_min_size(Pos2::ZERO, vec2(1.0, 1.0)));
    }

    #[test]
    fn arrows_walk_through_the_lines_as_they_are_seen() {
        assert_eq!(beside(10, [0, -1]), 10);
        assert_eq!(beside(10, [0, 1]), 20);
        assert_eq!(beside(35, [0, 1]), 5);
        assert_eq!(beside(5, [0, -1]), 35);
        assert_eq!(beside(5, [0, 1]), 5);
        assert_eq!(
            (beside(9, [1, 0]), beside(8, [1, 0]), beside(20, [-1, 0])),
            (9, 9, 20)
        );
    }
}
