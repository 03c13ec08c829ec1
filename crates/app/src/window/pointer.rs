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

/// Motion further than this from where the pointer was put, in pixels, was under way before.
const STRAY_PX: f64 = 64.0;
/// Most such motion that is waited out: the pointer's own arrival may be swallowed.
const MOST_STRAYS: u8 = 4;

/// Where the pointer was last, and where it has been put without having arrived yet.
#[derive(Clone, Copy, Debug, Default)]
struct Track {
    last: Option<PhysicalPosition<f64>>,
    warp: Option<PhysicalPosition<f64>>,
    /// How much motion was left out since the pointer was caught.
    strays: u8,
}

impl Track {
    /// The pointer is at a place; how far the player moved it, in pixels. Motion from before a warp may still
    /// arrive after it, so it is measured from the nearer of the two places the pointer can have come from.
    fn moved(&mut self, to: PhysicalPosition<f64>) -> Option<(f64, f64)> {
        let off = |from: PhysicalPosition<f64>| (to.x - from.x, to.y - from.y);
        let length = |(dx, dy): (f64, f64)| dx.hypot(dy);
        let astray = self.warp.is_some_and(|warp| length(off(warp)) > STRAY_PX);
        if astray && self.last.is_none() && self.strays < MOST_STRAYS {
            // Confining a pointer that is outside moves it to the window's edge, which nobody has done by hand.
            self.strays += 1;
            return None;
        }
        let from_last = self.last.replace(to).map(off);
        let moved = match (from_last, self.warp.map(off)) {
            (Some(last), Some(warp)) if length(last) < length(warp) => last,
            (_, Some(warp)) => {
                self.warp = None;
                // Nothing is known of where it was before.
                if from_last.is_none() {
                    (0.0, 0.0)
                } else {
                    warp
                }
            }
            (Some(last), None) => last,
            (None, None) => return None,
        };
        (moved != (0.0, 0.0)).then_some(moved)
    }
}

/// The pointer of one window.
#[derive(Debug)]
pub struct Pointer {
    hold: Hold,
    track: Track,
}

impl Default for Pointer {
    fn default() -> Self {
        Self {
            hold: Hold::Free,
            track: Track::default(),
        }
    }
}

impl Pointer {
    /// Catches the pointer in a window of that size, pixels; whether it was free before.
    pub fn catch(&mut self, window: &Window, size: (u32, u32)) -> bool {
        if self.hold != Hold::Free {
            return false;
        }
        window.set_cursor_visible(false);
        if window.set_cursor_grab(CursorGrabMode::Locked).is_ok() {
            self.hold = Hold::Locked;
            return true;
        }
        if window.set_cursor_grab(CursorGrabMode::Confined).is_err() {
            tracing::debug!(
                "the pointer can be neither locked nor confined; it is put back to the middle only"
            );
        }
        self.hold = Hold::Recentred;
        // Where it was while it was free is no place that the player turns the view from.
        self.track = Track::default();
        self.recentre(window, size);
        true
    }

    /// Lets the pointer go.
    pub fn free(&mut self, window: &Window) {
        if self.hold == Hold::Free {
            return;
        }
        self.hold = Hold::Free;
        self.track.warp = None;
        if window.set_cursor_grab(CursorGrabMode::None).is_err() {
            tracing::debug!("the pointer could not be let go");
        }
        window.set_cursor_visible(true);
    }

    /// The pointer was moved to a place in the window of that size; how far that turns the view, all in pixels. The
    /// window is not asked for its size: that would wait for the window system with each motion.
    pub fn moved(
        &mut self,
        window: &Window,
        size: (u32, u32),
        to: PhysicalPosition<f64>,
    ) -> Option<(f64, f64)> {
        let moved = self.track.moved(to);
        if self.hold != Hold::Recentred {
            return None;
        }
        let (half_x, half_y) = (f64::from(size.0) / 2.0, f64::from(size.1) / 2.0);
        let off_centre =
            (to.x - half_x).abs() > half_x / 2.0 || (to.y - half_y).abs() > half_y / 2.0;
        if off_centre && self.track.warp.is_none() {
            self.recentre(window, size);
        }
        moved
    }

    /// Raw motion; how far it turns the view, in pixels.
    pub fn raw(&self, delta: (f64, f64)) -> Option<(f64, f64)> {
        (self.hold == Hold::Locked).then_some(delta)
    }

    fn recentre(&mut self, window: &Window, size: (u32, u32)) {
        let (width, height) = size;
        let middle = PhysicalPosition::new(f64::from(width / 2), f64::from(height / 2));
        // The warp comes back as a motion event to exactly this place; measured from here it is no motion.
        self.track.warp = window.set_cursor_position(middle).is_ok().then_some(middle);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(x: f64, y: f64) -> PhysicalPosition<f64> {
        PhysicalPosition::new(x, y)
    }

    fn turned(track: &mut Track, places: &[(f64, f64)]) -> (f64, f64) {
        places
            .iter()
            .filter_map(|&(x, y)| track.moved(at(x, y)))
            .fold((0.0, 0.0), |sum, moved| (sum.0 + moved.0, sum.1 + moved.1))
    }

    #[test]
    fn a_warp_turns_nothing_and_what_was_queued_before_it_does_not_jump() {
        let mut track = Track::default();
        assert_eq!(turned(&mut track, &[(900.0, 360.0)]), (0.0, 0.0));
        assert_eq!(turned(&mut track, &[(960.0, 360.0)]), (60.0, 0.0));
        track.warp = Some(at(640.0, 360.0));
        let queued = [(970.0, 362.0), (980.0, 364.0)];
        assert_eq!(turned(&mut track, &queued), (20.0, 4.0));
        assert_eq!(turned(&mut track, &[(640.0, 360.0)]), (0.0, 0.0));
        assert!(track.warp.is_none());
        assert_eq!(turned(&mut track, &[(650.0, 350.0)]), (10.0, -10.0));
    }

    #[test]
    fn a_pointer_caught_from_outside_the_window_turns_nothing_on_its_way_in() {
        let mut track = Track {
            warp: Some(at(400.0, 300.0)),
            ..Track::default()
        };
        let way_in = [(799.0, 599.0), (400.0, 300.0)];
        assert_eq!(turned(&mut track, &way_in), (0.0, 0.0));
        assert!(track.warp.is_none());
        assert_eq!(turned(&mut track, &[(410.0, 297.0)]), (10.0, -3.0));
        // An arrival that never comes is not waited for forever.
        let mut track = Track {
            warp: Some(at(400.0, 300.0)),
            ..Track::default()
        };
        let far = [600.0, 610.0, 620.0, 630.0, 640.0, 650.0].map(|x| (x, 300.0));
        assert_eq!(turned(&mut track, &far), (10.0, 0.0));
    }

    #[test]
    fn a_warp_whose_own_event_is_swallowed_is_measured_from_its_target() {
        let mut track = Track {
            last: Some(at(960.0, 360.0)),
            warp: Some(at(640.0, 360.0)),
            strays: 0,
        };
        assert_eq!(turned(&mut track, &[(645.0, 361.0)]), (5.0, 1.0));
        assert!(track.warp.is_none());
    }
}
