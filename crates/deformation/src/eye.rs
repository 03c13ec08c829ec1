//! How high a walker's eye is.

use glam::DVec3;

use crate::scene::Void;
use crate::space::{Space, Traveller};
use crate::trace::{Place, trace};
use crate::tuning::EYE_GLIDE_S;

/// The felt height of a walker's eye above its middle. A box that is stretched upwards moves the eye in the scene when the
/// middle enters it; the eye stays where it was and glides to its felt height instead.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EyeHeight {
    /// Felt height where nothing has changed, metres.
    rest_m: f64,
    /// What it is off by, metres, when the glide began.
    off_m: f64,
    /// Of the glide, seconds that are left.
    left_s: f64,
}

impl EyeHeight {
    /// An eye at rest, `rest_m` felt metres above the walker's middle.
    pub fn new(rest_m: f64) -> Self {
        Self {
            rest_m,
            off_m: 0.0,
            left_s: 0.0,
        }
    }

    /// Felt metres above the middle.
    pub fn height_m(&self) -> f64 {
        // Begins and ends without a jump of speed.
        let share = (self.left_s / EYE_GLIDE_S).clamp(0.0, 1.0);
        self.rest_m + self.off_m * share * share * (3.0 - 2.0 * share)
    }

    /// Time passes.
    pub fn glide(&mut self, time_s: f64) {
        self.left_s = (self.left_s - time_s).max(0.0);
    }

    /// The walker's middle came into or out of a box at `middle`, where its eye was at `eye`: the eye stays there.
    pub fn keep(&mut self, space: &Space, middle: &Place, up: DVec3, eye: DVec3) {
        let wanted = (eye - middle.point).dot(up);
        let rise = |felt: f64| {
            let end = Self::above(space, middle, up, felt);
            (end.point - middle.point).dot(up)
        };
        let (mut low, mut high) = (0.0, 64.0 * self.rest_m.max(0.1));
        for _ in 0..48 {
            let between = 0.5 * (low + high);
            if rise(between) < wanted {
                low = between;
            } else {
                high = between;
            }
        }
        self.off_m = 0.5 * (low + high) - self.rest_m;
        self.left_s = EYE_GLIDE_S;
    }

    /// The place of the eye.
    pub fn place(&self, space: &Space, middle: &Place, up: DVec3) -> Place {
        Self::above(space, middle, up, self.height_m())
    }

    fn above(space: &Space, middle: &Place, up: DVec3, felt_m: f64) -> Place {
        trace(space, middle, up, felt_m, &Void, &Traveller::Body).place
    }
}
