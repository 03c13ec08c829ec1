//! How far the eye goes while refinements are made: what is begun now is to hold when it is shown, and until the next.

use antipode_geometry::{ChartPoint, Strategy};
use glam::DVec3;

/// An eye that goes farther than this in a frame has not gone but was put there, metres.
const LEAP_M: f64 = 4.0;
/// An eye that goes less than this in a frame stands, metres.
const STANDS_M: f64 = 0.002;
/// Land is refined so far ahead of a walker at least, metres: shorter ways would have to be made more often.
const LEAST_M: f64 = 0.75;
/// Of frames in which a set was made, so many count at most.
const MOST_FRAMES: u32 = 30;

/// Where the eye goes, and how long sets take.
#[derive(Debug, Default)]
pub struct Lead {
    last: Option<ChartPoint>,
    /// What it goes in a frame, about the mean of the last few.
    step: DVec3,
    /// Frames since the set under way was begun.
    age: u32,
    /// Frames that the last set took.
    took: u32,
}

impl Lead {
    /// Another frame, with the eye there.
    pub fn frame(&mut self, strategy: &dyn Strategy, eye: &ChartPoint) {
        self.age += 1;
        let mut last = self.last.replace(*eye);
        if let Some(before) = last.filter(|last| last.chart != eye.chart) {
            let crossing = strategy.carry(before, eye.chart);
            self.step = crossing.map_or(DVec3::ZERO, |crossing| crossing.rotation() * self.step);
            last = crossing.map(|crossing| crossing.point);
        }
        let step = last.map_or(DVec3::ZERO, |last| eye.pos - last.pos);
        self.step = if step.length() > LEAP_M {
            DVec3::ZERO
        } else {
            // Frames and steps of the world do not keep time: now and then a frame has none, or two.
            self.step.midpoint(step)
        };
    }

    /// A set is begun.
    pub fn begin(&mut self) {
        self.age = 0;
    }

    /// The set is shown.
    pub fn end(&mut self) {
        self.took = self.age.min(MOST_FRAMES);
    }

    /// The set is not there yet, and the eye cannot wait for it.
    pub fn late(&mut self) {
        self.took = self.took.max(self.age).min(MOST_FRAMES);
    }

    /// Whether the eye stands.
    pub fn rests(&self) -> bool {
        self.step.length() < STANDS_M
    }

    /// Where the eye will be when a set that is begun now is there.
    pub fn when_made(&self, eye: &ChartPoint) -> ChartPoint {
        eye.moved(self.step * f64::from(self.took))
    }

    /// The way from now to when the set after the one that is begun now can be there, metres.
    pub fn way(&self) -> DVec3 {
        if self.rests() {
            return DVec3::ZERO;
        }
        let way = self.step * f64::from(2 * self.took + 1);
        way.clamp_length_min(LEAST_M)
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

    use antipode_geometry::{ChartId, Geometry, strategy};

    use super::*;

    #[test]
    fn who_runs_over_the_equator_is_led_on_the_same_way() {
        let sphere = strategy(Geometry::Spherical, 32.0);
        let rim_m = sphere.domain(ChartId::FIRST).radius_m().unwrap();
        let mut lead = Lead::default();
        // Past the rim the way goes on in the other chart, whose axes are turned against those of the first.
        let heading = DVec3::new(0.5, 0.0, 0.75_f64.sqrt());
        let at = |step: i32| {
            let from_middle_m = rim_m + 0.1 * f64::from(step);
            let eye = ChartPoint::a(heading * from_middle_m + DVec3::Y * 4.0);
            let crossing = (step >= 0).then(|| sphere.images(eye, f64::INFINITY)[0]);
            crossing.map_or(eye, |crossing| crossing.point)
        };
        lead.begin();
        for step in -20..0 {
            lead.frame(&*sphere, &at(step));
        }
        lead.end();
        for step in 0..3 {
            lead.frame(&*sphere, &at(step));
            let off_m = lead.when_made(&at(step)).pos.distance(at(step + 20).pos);
            assert!(off_m < 0.2, "{step}: {off_m} m");
        }
    }
}
