//! The curvature under the wheel: a goal that is set in notches and a value that glides towards it.

use antipode_geometry::Dial as Range;

use crate::tuning::DIAL_REMAINDER_PER_S;

/// The curvature dial of a world; in a space without one it stays at zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurvatureDial {
    range: Option<Range>,
    goal: f64,
    value: f64,
}

impl CurvatureDial {
    /// A dial at rest on the space's default.
    pub fn new(range: Option<Range>) -> Self {
        let start = range.map_or(0.0, |r| r.default);
        Self {
            range,
            goal: start,
            value: start,
        }
    }

    /// Smallest and largest setting, if the space has a dial.
    pub fn range(&self) -> Option<(f64, f64)> {
        self.range.map(|r| (r.min, r.max))
    }

    /// The value in use at this moment.
    pub fn value(&self) -> f64 {
        self.value
    }

    /// The value the dial glides to.
    pub fn goal(&self) -> f64 {
        self.goal
    }

    /// Turns the dial by notches of one metre.
    pub fn turn(&mut self, notches: f64) {
        if let Some(range) = self.range {
            self.goal = (self.goal + notches).clamp(range.min, range.max);
        }
    }

    /// Sets goal and value at once. Returns false when out of range or the space has no dial.
    pub fn set(&mut self, value: f64) -> bool {
        let fits = self.range.is_some_and(|r| (r.min..=r.max).contains(&value));
        if fits {
            self.goal = value;
            self.value = value;
        }
        fits
    }

    /// Glides for `dt_s` seconds; the last ten-thousandth is taken at once so that the dial comes to rest.
    pub fn glide(&mut self, dt_s: f64) {
        let kept = DIAL_REMAINDER_PER_S.powf(dt_s);
        self.value = self.goal + (self.value - self.goal) * kept;
        if (self.value - self.goal).abs() < 1e-4 {
            self.value = self.goal;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn dial() -> CurvatureDial {
        CurvatureDial::new(Some(Range {
            min: 0.0,
            max: 20.0,
            default: 10.0,
        }))
    }

    #[test]
    fn a_notch_glides_without_a_step_and_comes_to_rest() {
        let mut d = dial();
        d.turn(1.0);
        let mut last = d.value();
        for _ in 0..120 {
            d.glide(1.0 / 60.0);
            assert!(d.value() >= last && d.value() - last < 0.2);
            last = d.value();
        }
        assert_eq!(d.value(), 11.0);
    }

    #[test]
    fn the_dial_stops_at_both_ends() {
        let mut d = dial();
        d.turn(50.0);
        assert_eq!(d.goal(), 20.0);
        d.turn(-90.0);
        assert_eq!(d.goal(), 0.0);
        assert!(!d.set(20.5) && !d.set(f64::NAN));
    }

    #[test]
    fn a_space_without_a_dial_ignores_it() {
        let mut d = CurvatureDial::new(None);
        d.turn(3.0);
        assert_eq!(d.goal(), 0.0);
        assert!(!d.set(1.0));
    }
}
