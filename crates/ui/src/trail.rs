//! The way by which the player came to what is up, so that going back finds the focus on what was left.

use egui::{Context, Id};

/// The places that lead to the one that is up.
pub(crate) struct Trail {
    /// Each with the widget that led on from it, outermost first.
    behind: Vec<(Id, Option<Id>)>,
    here: Id,
    /// What was pressed last.
    pressed: Option<Id>,
    /// What is to have the focus here, if it is there.
    wanted: Option<Id>,
}

impl Trail {
    /// A way that begins at `root`.
    pub(crate) fn new(root: Id) -> Self {
        Self {
            behind: Vec::new(),
            here: root,
            pressed: None,
            wanted: None,
        }
    }

    /// `place` is up. `is_screen`: the buttons of `root` lead to it, and stand beside every other such screen, too.
    pub(crate) fn arrive(&mut self, place: Id, root: Id, is_screen: bool) {
        if place == self.here {
            return;
        }
        let pressed = self.pressed.take();
        let passed = self.behind.iter().position(|(id, _)| *id == place);
        self.wanted = None;
        if let Some(passed) = passed {
            self.wanted = self.behind[passed].1;
            self.behind.truncate(passed);
        } else if is_screen {
            self.behind = vec![(root, pressed)];
        } else {
            self.behind.push((self.here, pressed));
        }
        self.here = place;
    }

    /// Gives the focus to what was left, if the player came back; whether that is so. To be called before anything is
    /// drawn: a widget that gets the focus later does not come into view.
    pub(crate) fn return_focus(&self, ctx: &Context) -> bool {
        if let Some(left) = self.wanted {
            ctx.memory_mut(|memory| memory.request_focus(left));
        }
        self.wanted.is_some()
    }

    /// Whether what was left was drawn in this frame, and so could take the focus; asked once.
    pub(crate) fn is_returned(&mut self, ctx: &Context) -> bool {
        let left = self.wanted.take();
        left.is_some_and(|left| is_drawn(ctx, left))
    }

    /// Notes what is pressed in this frame: by the pointer, or by keys what has the focus.
    pub(crate) fn note(&mut self, ctx: &Context) {
        let clicked = ctx.interaction_snapshot(|interaction| interaction.clicked);
        let focused = ctx.memory(egui::Memory::focused);
        self.pressed = clicked.or(focused).or(self.pressed);
    }
}

/// Whether what has the focus, if anything has, was drawn in this frame and can be pressed.
pub(crate) fn is_focus_drawn(ctx: &Context) -> bool {
    let focused = ctx.memory(egui::Memory::focused);
    focused.is_none_or(|focused| is_drawn(ctx, focused))
}

fn is_drawn(ctx: &Context, id: Id) -> bool {
    ctx.viewport(|viewport| {
        let widget = viewport.this_pass.widgets.get(id);
        widget.is_some_and(|widget| widget.enabled)
    })
}
