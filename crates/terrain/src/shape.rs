//! Shapes of the brush, and what they make of the field.
//!
//! The ball pushes the field, weaker the farther out, as the reference game does. The others lead it towards that of a
//! body: inside, dug ground is the body's distance `d` to its hull above zero and built ground as much below, so that
//! planes come out as planes. A stroke changes a sample by no more than its amount.

use glam::DVec3;

use crate::field::FIELD_BAND_M;
use crate::samples::Samples;

/// What a stroke's brush is like, and what it does.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub enum Shape {
    /// Pushes the field within a ball, weaker the farther out.
    #[default]
    Ball,
    /// Digs or builds an upright cube, its half edge the radius.
    Box,
    /// Digs or builds an upright cylinder as high as it is wide.
    Cylinder,
    /// Brings the ground within an upright cylinder to a height of the chart, metres.
    Flatten {
        /// The height.
        height_m: f64,
    },
    /// Brings each sample within a ball nearer to the mean of those beside it.
    Smooth,
}

/// Samples so far outside of a body still take its distance, metres: its hull lies between them and those inside.
const HULL_M: f64 = 1.5;

impl Shape {
    /// How far from its middle a brush of a radius changes anything, metres.
    pub(crate) fn reach_m(self, radius_m: f64) -> f64 {
        match self {
            Self::Ball | Self::Smooth => radius_m,
            Self::Box => 3.0_f64.sqrt() * (radius_m + HULL_M),
            Self::Cylinder | Self::Flatten { .. } => 2.0_f64.sqrt() * (radius_m + HULL_M),
        }
    }

    /// How far inside of the brush's body a place so far off its middle is, metres; outside less than zero.
    fn inside_m(self, off: DVec3, radius_m: f64) -> f64 {
        let aside = off.x.hypot(off.z);
        match self {
            Self::Ball | Self::Smooth => radius_m - off.length(),
            Self::Box => radius_m - off.abs().max_element(),
            Self::Cylinder | Self::Flatten { .. } => radius_m - aside.max(off.y.abs()),
        }
    }

    /// By how much the owned sample `(i, j, k)` of a chunk, at height `y` and so far off the middle, is to change if
    /// nothing holds it, metres of field; `digs` says which way bodies work. 0 for the ball, which pushes.
    pub(crate) fn change(
        self,
        now: &Samples,
        [i, j, k]: [usize; 3],
        (off, y): (DVec3, f64),
        (radius_m, digs): (f64, bool),
    ) -> f32 {
        let (i, j, k) = (i + 1, j + 1, k + 1);
        let value = now.get(i, j, k);
        let inside = self.inside_m(off, radius_m);
        match self {
            Self::Ball => 0.0,
            Self::Box | Self::Cylinder if inside < -HULL_M => 0.0,
            Self::Box | Self::Cylinder if digs => (inside as f32 - value).max(0.0),
            Self::Box | Self::Cylinder => (-inside as f32 - value).min(0.0),
            Self::Flatten { .. } | Self::Smooth if inside <= 0.0 => 0.0,
            Self::Flatten { height_m } => {
                let band = f64::from(FIELD_BAND_M);
                (y - height_m).clamp(-band, band) as f32 - value
            }
            Self::Smooth => {
                let beside = now.get(i - 1, j, k) + now.get(i + 1, j, k);
                let above = now.get(i, j - 1, k) + now.get(i, j + 1, k);
                let along = now.get(i, j, k - 1) + now.get(i, j, k + 1);
                let mean = (beside + above + along) / 6.0;
                // Weaker towards the rim, so that none is seen.
                (mean - value) * (inside / radius_m) as f32
            }
        }
    }
}
