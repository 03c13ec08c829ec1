//! Octaves of gradient noise.

use glam::DVec3;

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
