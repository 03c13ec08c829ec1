//! Octaves of gradient noise, and how fast their sums are found.
//!
//! Three ways were measured over the 35^3 samples of a surface chunk of four octaves, on one core
//! of a 2.5 GHz server processor shared with other work, the least of many runs:
//!
//! | way | ns a sample |
//! |---|---|
//! | the `noise` crate, sample by sample | 174 |
//! | the `noise` crate, octaves left out where the band decides | 88 |
//! | `simdnoise`, four octaves of another noise (simplex) | 24 |
//! | ours in flat spaces (`upright`) | 4.7 |
//! | ours in curved ones (`tilted`), a sphere of 32 m, 16 samples side by side | 14 |
//! | the same, 8 side by side | 17 |
//! | the same, 4 side by side, on processors without AVX2 | 28 |
//!
//! No vector library has this very noise, on which saved worlds rest, and none can know that a
//! chunk's samples share lattice planes and cells. So the kernels are ours. That of curved spaces
//! is compiled for three widths of vectors and chosen at run time (`wide`); the bits are the same.
//! That of flat spaces, on glam's vectors, was no faster built for AVX2.
//!
//! A sample is the same bit for bit whatever grid it is asked for in, so that chunks and levels
//! of detail meet: its operations and their operands depend on the point alone.

use glam::DVec3;

use crate::form::Form;

/// Frequencies per metre of the three axes, which the octaves multiply.
pub(crate) const AXIS_FREQUENCY: DVec3 = DVec3::new(0.1553, 0.1271, 0.0916);

/// One octave of a fractal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Octave {
    /// Multiplies [`AXIS_FREQUENCY`].
    pub frequency: f64,
    /// Weight of this octave's noise in 0..=1, metres.
    pub amplitude_m: f64,
}

/// Points `base + slope * y` of noise space, as `y` runs up a column of the chart.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Column {
    /// The point at `y = 0`.
    pub base: DVec3,
    /// Its change per metre of height.
    pub slope: DVec3,
    /// What the column makes of the octaves.
    pub form: Form,
}

impl Octave {
    /// Frequencies per metre of the three axes.
    pub(crate) fn frequencies(self) -> DVec3 {
        AXIS_FREQUENCY * self.frequency
    }

    /// The noise is held to this on either side of zero, metres.
    pub(crate) fn half_m(self) -> f32 {
        (self.amplitude_m / 2.0) as f32
    }
}
