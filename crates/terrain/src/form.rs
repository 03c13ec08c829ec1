//! How a column's ground is shaped from the noise that all columns have in common.

use glam::Vec4;

/// Metres of height from terrace to terrace.
const TERRACE_M: f64 = 6.0;
/// The terraces' wave rises by no more than this times the height, so that ground with all of it still has no overhang
/// from that alone: a parabola of height one has a slope of eight a period.
const TERRACE_WAVE_M: f32 = TERRACE_M as f32 / 8.0;

/// What a column makes of the octaves. Its sum is `fall_m + terraces * wave(y) + sum_i waves_i noise_i`, which lowers the
/// ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Form {
    /// What each octave is multiplied by.
    pub waves: Vec4,
    /// How far the column's ground lies below the middle of the world's, metres.
    pub fall_m: f32,
    /// How much the ground lies in terraces, 0 to 1.
    pub terraces: f32,
}

impl Form {
    /// The octaves as they are.
    pub(crate) const PLAIN: Self = Self {
        waves: Vec4::ONE,
        fall_m: 0.0,
        terraces: 0.0,
    };

    /// What there is of the sum before the octaves, by [`terrace_wave`].
    #[inline]
    pub(crate) fn start(&self, wave: f32) -> f32 {
        self.terraces * wave + self.fall_m
    }

    /// [`Self::start`] of four heights.
    #[inline]
    pub(crate) fn starts(&self, waves: Vec4) -> Vec4 {
        self.terraces * waves + self.fall_m
    }

    /// Of each number that of both which is picked.
    pub(crate) fn pick(&self, other: &Self, pick: impl Fn(f32, f32) -> f32) -> Self {
        let waves = [0, 1, 2, 3].map(|n| pick(self.waves[n], other.waves[n]));
        Self {
            waves: Vec4::from(waves),
            fall_m: pick(self.fall_m, other.fall_m),
            terraces: pick(self.terraces, other.terraces),
        }
    }

    /// Each number moved by what two others say.
    pub(crate) fn moved(
        &self,
        from: &Self,
        to: &Self,
        by: impl Fn(f32, (f32, f32)) -> f32,
    ) -> Self {
        let waves = [0, 1, 2, 3].map(|n| by(self.waves[n], (from.waves[n], to.waves[n])));
        Self {
            waves: Vec4::from(waves),
            fall_m: by(self.fall_m, (from.fall_m, to.fall_m)),
            terraces: by(self.terraces, (from.terraces, to.terraces)),
        }
    }

    /// Least and greatest sum, where an octave is held to `halves` on either side of zero.
    pub(crate) fn sums(&self, halves: Vec4) -> [f32; 2] {
        let most = self.waves.dot(halves) + self.terraces * TERRACE_WAVE_M;
        [self.fall_m - most, self.fall_m + most]
    }
}

/// The wave of the terraces at a height: it repeats each [`TERRACE_M`], and is nothing where there is no height.
pub(crate) fn terrace_wave(y: f64) -> f32 {
    /// Adding this to a number of periods leaves no room for a fraction.
    const ROUNDS: f64 = 6_755_399_441_055_744.0;
    if !y.is_finite() {
        return 0.0;
    }
    let periods = y / TERRACE_M;
    let t = (periods - ((periods + ROUNDS) - ROUNDS)) as f32;
    TERRACE_WAVE_M * t * (8.0 - 16.0 * t.abs())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn terraces_repeat_and_never_turn_the_ground_over() {
        let mut before = terrace_wave(-20.0);
        for n in 1..4000 {
            let y = -20.0 + 0.01 * f64::from(n);
            let wave = terrace_wave(y);
            assert!(wave.abs() <= TERRACE_WAVE_M * 1.001, "{y}: {wave}");
            assert!((wave - terrace_wave(y + TERRACE_M)).abs() < 1e-5, "{y}");
            assert!((wave - before).abs() < 0.010_01, "{y}: {before} {wave}");
            before = wave;
        }
        assert_eq!(terrace_wave(f64::INFINITY), 0.0);
    }
}
