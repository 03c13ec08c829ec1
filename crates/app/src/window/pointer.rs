//! The mouse as a means to look round: caught while playing, free in the menu.

use winit::dpi::PhysicalPosition;
use winit::window::{CursorGrabMode, Window};

/// How the pointer is held at the moment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Hold {
    Free,
    /// The system keeps the pointer in place and tells raw motion.
    Locked,
    /// The pointer is put back to the middle after each motion. X11 knows no lock, and confining the pointer
    /// there doubles raw motion, so motion is measured from where the pointer was put.
    Recentred,
}

/// The pointer of one window.
#[derive(Debug)]
pub struct Pointer {
    hold: Hold,
    expected: Option<PhysicalPosition<f64>>,
}

impl Default for Pointer {
    fn default() -> Self {
        Self {
            hold: Hold::Free,
            expected: None,
        }
    }
}

impl Pointer {
    /// Catches the pointer.
    pub fn catch(&mut self, window: &Window) {
        if self.hold != Hold::Free {
            return;
        }
        window.set_cursor_visible(false);
        if window.set_cursor_grab(CursorGrabMode::Locked).is_ok() {
            self.hold = Hold::Locked;
            return;
        }
        if window.set_cursor_grab(CursorGrabMode::Confined).is_err() {
            tracing::debug!(
                "the pointer can be neither locked nor confined; it is put back to the middle only"
            );
        }
        self.hold = Hold::Recentred;
        self.recentre(window);
    }

    /// Lets the pointer go.
    pub fn free(&mut self, window: &Window) {
        if self.hold == Hold::Free {
            return;
        }
        self.hold = Hold::Free;
        self.expected = None;
        if window.set_cursor_grab(CursorGrabMode::None).is_err() {
            tracing::debug!("the pointer could not be let go");
        }
        window.set_cursor_visible(true);
    }

    /// The pointer was moved to a place in the window; how far that turns the view, in pixels.
    pub fn moved(&mut self, window: &Window, to: PhysicalPosition<f64>) -> Option<(f64, f64)> {
        if self.hold != Hold::Recentred {
            return None;
        }
        let from = self.expected.replace(to)?;
        let (dx, dy) = (to.x - from.x, to.y - from.y);
        let size = window.inner_size();
        let (half_x, half_y) = (f64::from(size.width) / 2.0, f64::from(size.height) / 2.0);
        let off_centre =
            (to.x - half_x).abs() > half_x / 2.0 || (to.y - half_y).abs() > half_y / 2.0;
        if off_centre {
            self.recentre(window);
        }
        (dx != 0.0 || dy != 0.0).then_some((dx, dy))
    }

    /// Raw motion; how far it turns the view, in pixels.
    pub fn raw(&self, delta: (f64, f64)) -> Option<(f64, f64)> {
        (self.hold == Hold::Locked).then_some(delta)
    }

    fn recentre(&mut self, window: &Window) {
        let size = window.inner_size();
        let middle = PhysicalPosition::new(f64::from(size.width / 2), f64::from(size.height / 2));
        // The warp comes back as a motion event to exactly this place; measured from here it is no motion.
        self.expected = window.set_cursor_position(middle).is_ok().then_some(middle);
    }
}
