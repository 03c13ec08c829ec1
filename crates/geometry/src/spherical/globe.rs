//! The ground of a closed world as a globe.

use std::f64::consts::{FRAC_2_PI, FRAC_PI_2, TAU};

use glam::DVec3;

use crate::kernel::sphere::mirrored;
use crate::scalar::sinc;
use crate::{ChartId, ChartPoint};

/// Height over the ground sphere, in radii, from which the chart is too wide to reach only part of it.
const HIGHEST_RAD: f64 = 1.3;

/// The great sphere y = 0 that the ground of a closed world lies along, with the centres of the two charts as its poles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Globe {
    radius_m: f64,
}

/// Whether a chart is that of hemisphere B; all others count as A.
pub(super) fn is_b(chart: ChartId) -> bool {
    chart == ChartId::SECOND
}

impl Globe {
    /// Charts are at most so much wider than the space along their circles: `pi / 2`, at the equator.
    pub const WIDEST: f64 = FRAC_PI_2;

    pub(super) fn new(radius_m: f64) -> Self {
        Self { radius_m }
    }

    /// The letter of a chart's hemisphere.
    pub fn hemisphere(self, chart: ChartId) -> char {
        if is_b(chart) { 'B' } else { 'A' }
    }

    /// How far it is once round, metres.
    pub fn round_m(self) -> f64 {
        TAU * self.radius_m
    }

    /// How far the equator is from the centre of a chart, metres.
    pub fn equator_m(self) -> f64 {
        FRAC_PI_2 * self.radius_m
    }

    /// The place on the ground sheet that north leads to: where -x of hemisphere A meets the equator.
    pub fn north(self) -> ChartPoint {
        ChartPoint::a(DVec3::NEG_X * self.equator_m())
    }

    /// A place as seen from the globe's middle, in metres from there: along +x and +z of hemisphere A, with its pole in
    /// between, and as far out as the place is high.
    pub fn from_middle_m(self, point: ChartPoint) -> DVec3 {
        let b = is_b(point.chart);
        let p = DVec3::from_array(mirrored(b, (point.pos / self.radius_m).to_array()));
        let r = p.x.hypot(p.z);
        let pole = if b { -r.cos() } else { r.cos() };
        DVec3::new(sinc(r) * p.x, pole, sinc(r) * p.z) * (self.radius_m + point.pos.y)
    }

    /// The place at a height over the great circle through both poles and +z, by the angle from where -z meets the
    /// equator up to the pole of A.
    pub fn over_poles(self, turn_rad: f64, height_m: f64) -> ChartPoint {
        let (sin, cos) = turn_rad.sin_cos();
        let chart = if sin < 0.0 {
            ChartId::SECOND
        } else {
            ChartId::FIRST
        };
        let from_centre = FRAC_PI_2 - sin.abs().clamp(0.0, 1.0).asin();
        let z = -from_centre.copysign(cos);
        let at = DVec3::new(0.0, 0.0, z) * self.radius_m;
        ChartPoint::new(chart, at.with_y(height_m))
    }

    /// How far a place lies along that circle's plane, in radii of the globe: towards the pole of A, and towards +z.
    pub fn along_poles(self, point: ChartPoint) -> [f64; 2] {
        let (x, z) = (point.pos.x, point.pos.z);
        let away_m = x.hypot(z);
        let (sin, cos) = (away_m / self.radius_m).sin_cos();
        let along_z = if away_m > 0.0 { sin * z / away_m } else { 0.0 };
        [if is_b(point.chart) { -cos } else { cos }, along_z]
    }

    /// How far in a chart that may be which is so many metres away in the space, from a place at a height of `y_m` metres;
    /// `None` for any distance.
    ///
    /// Over a height `a` in radii lengths are shrunk by `cos(a)`, and round the pole, at the equator, by `2 / pi`.
    pub fn reach_in_chart_m(self, y_m: f64, away_m: f64) -> Option<f64> {
        let height_rad = (y_m.abs() + away_m) / self.radius_m;
        let shrunk = height_rad.cos() * FRAC_2_PI;
        (height_rad < HIGHEST_RAD).then_some(away_m / shrunk)
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    #[test]
    fn the_circle_over_the_poles_leads_through_both_charts_and_back() {
        let globe = Globe::new(40.0);
        for step in 0..720 {
            let turn = (f64::from(step) + 0.5) * TAU / 720.0;
            let at = globe.over_poles(turn, 12.0);
            assert_eq!(
                globe.hemisphere(at.chart),
                if turn < PI { 'A' } else { 'B' }
            );
            assert!(at.pos.z.abs() <= globe.equator_m() && at.pos.y == 12.0);
            let [to_a, along_z] = globe.along_poles(at);
            assert!((to_a - turn.sin()).abs() < 1e-12 && (along_z + turn.cos()).abs() < 1e-12);
            let middle = globe.from_middle_m(at) / 52.0;
            assert!((middle - DVec3::new(0.0, to_a, along_z)).length() < 1e-12);
        }
    }
}
