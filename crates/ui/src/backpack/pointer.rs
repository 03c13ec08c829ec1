//! What the pointer does on the slots, press by press: a press takes a stack, and where it is let go decides whether
//! that was a click or a drag. Followed from the events themselves, so that a slow frame that holds a whole drag means
//! the same as a fast one.

use std::collections::VecDeque;

use egui::{Context, Event, Modifiers, PointerButton, Pos2};

use super::layout::Places;
use super::{BackpackWish, Buttons, SLOTS, wish};
use crate::hud::SlotView;

/// A button that went down or up.
#[derive(Clone, Copy, Debug)]
struct Press {
    at: Pos2,
    other: bool,
    down: bool,
    held: Modifiers,
}

/// Presses that wait for their turn, and the drag that may have begun.
#[derive(Debug, Default)]
pub(super) struct Presses {
    waiting: VecDeque<Press>,
    /// The slot that a press has taken a stack from, until it is let go, and whether by the other button.
    from: Option<(u8, bool)>,
}

impl Presses {
    /// Takes in what the pointer did, and returns what that asks for: at most one thing a frame, since what the next
    /// press means depends on what came of it. `carries`: something is at the pointer.
    pub(super) fn take(
        &mut self,
        ctx: &Context,
        places: &Places,
        buttons: &Buttons,
        carries: bool,
        slots: &[SlotView],
    ) -> Option<BackpackWish> {
        ctx.input(|input| self.waiting.extend(input.events.iter().filter_map(press)));
        while let Some(press) = self.waiting.pop_front() {
            let found = if press.down {
                self.down(press, places, carries, slots)
            } else {
                self.up(press, places, buttons, carries)
            };
            if found.is_some() {
                if !self.waiting.is_empty() {
                    ctx.request_repaint();
                }
                return found;
            }
        }
        None
    }

    /// A drag that has begun is none any more: what it took stays at the pointer.
    pub(super) fn end_drag(&mut self) {
        self.from = None;
    }

    fn down(
        &mut self,
        press: Press,
        places: &Places,
        carries: bool,
        slots: &[SlotView],
    ) -> Option<BackpackWish> {
        let Some(slot) = places.slot_at(press.at) else {
            let outside = carries && !places.panel.contains(press.at);
            return outside.then_some(BackpackWish::LetGo {
                whole: !press.other,
            });
        };
        let wish = if press.other {
            BackpackWish::ClickOther(slot)
        } else {
            wish(slot, press.held)
        };
        let full = slots
            .get(usize::from(slot))
            .is_some_and(|view| view.item.is_some());
        let takes = !carries && full && !matches!(wish, BackpackWish::Send(_));
        self.from = takes.then_some((slot, press.other));
        Some(wish)
    }

    fn up(
        &mut self,
        press: Press,
        places: &Places,
        buttons: &Buttons,
        carries: bool,
    ) -> Option<BackpackWish> {
        let (from, _) = self.from.take_if(|(_, other)| *other == press.other)?;
        if !carries {
            return None;
        }
        match places.slot_at(press.at) {
            // Let go where it was taken: it stays at the pointer.
            Some(slot) if slot == from => None,
            Some(slot) => Some(BackpackWish::EndDrag(slot)),
            // Dragged onto the button that throws away.
            None if buttons.throw.contains(press.at) => Some(BackpackWish::LetGo { whole: true }),
            None if places.panel.contains(press.at) => Some(BackpackWish::EndDrag(SLOTS)),
            None => Some(BackpackWish::LetGo { whole: true }),
        }
    }
}

fn press(event: &Event) -> Option<Press> {
    match event {
        Event::PointerButton {
            pos,
            button: button @ (PointerButton::Primary | PointerButton::Secondary),
            pressed,
            modifiers,
        } => Some(Press {
            at: *pos,
            other: *button == PointerButton::Secondary,
            down: *pressed,
            held: *modifiers,
        }),
        _ => None,
    }
}
