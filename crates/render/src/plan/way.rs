//! The straight way along which an eye is expected to go on: land is refined for all of it at once, so that what is
//! made for it still holds when it is shown.

use antipode_geometry::{ChartId, ChartPoint, Strategy};
use glam::{DVec3, IVec3};

/// A way begins and ends on a grid of this width, metres: an eye that stands, or moves by less, asks for nothing new.
const GRID_M: f64 = 0.5;
/// No place is farther than this from the middle of its cell, metres.
const CELL_M: f64 = 0.5 * 1.733 * GRID_M;
/// The places by which a way is looked at lie at most so far apart, metres.
const STRIDE_M: f64 = 1.0;
/// They are exact in any chunk: whole parts of a metre, this many.
const PARTS_PER_M: f64 = 16.0;
/// No way is longer, metres.
const LONGEST_M: f64 = 6.0;

/// A straight way of an eye along the chart; a single place, where it stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Way {
    chart: ChartId,
    from: IVec3,
    to: IVec3,
}

impl Way {
    /// The way from a place along a step in metres, of which only the first part counts where that is long.
    pub fn new(from: &ChartPoint, step: DVec3) -> Self {
        let cell = |pos: DVec3| (pos / GRID_M).round().as_ivec3();
        Self {
            chart: from.chart,
            from: cell(from.pos),
            to: cell(from.pos + step.clamp_length_max(LONGEST_M)),
        }
    }

    fn ends(&self) -> [DVec3; 2] {
        [self.from, self.to].map(|end| end.as_dvec3() * GRID_M)
    }

    /// Places along it: no eye that it covers is farther than [`Way::slack_m`] from one of them.
    pub fn places(&self) -> impl Iterator<Item = ChartPoint> + use<> {
        let ([from, to], chart) = (self.ends(), self.chart);
        let steps = self.strides();
        (0..=steps).map(move |i| {
            let part = f64::from(i) / f64::from(steps.max(1));
            let pos = (from.lerp(to, part) * PARTS_PER_M).round() / PARTS_PER_M;
            ChartPoint::new(chart, pos)
        })
    }

    fn strides(&self) -> u32 {
        let [from, to] = self.ends();
        (from.distance(to) / STRIDE_M).ceil() as u32
    }

    /// How far an eye that it covers may be from the nearest of its places, metres.
    pub fn slack_m(&self) -> f64 {
        if self.is_place() {
            return CELL_M;
        }
        // Across the way, along it, and what rounding takes.
        CELL_M.hypot(0.5 * STRIDE_M) + 0.5 * 1.733 / PARTS_PER_M
    }

    /// How far an eye is from it, metres along its chart; infinite from where that does not reach.
    pub fn away_m(&self, strategy: &dyn Strategy, eye: &ChartPoint) -> f64 {
        let carried = strategy.carry(*eye, self.chart);
        carried.map_or(f64::INFINITY, |crossing| {
            self.distance_m(crossing.point.pos)
        })
    }

    fn distance_m(&self, pos: DVec3) -> f64 {
        let [from, to] = self.ends();
        let along = to - from;
        let part = (pos - from).dot(along) / along.length_squared();
        // Of a single place the part is no number.
        let part = if part.is_finite() {
            part.clamp(0.0, 1.0)
        } else {
            0.0
        };
        (from + along * part).distance(pos)
    }

    /// Whether what is made for it holds for an eye.
    pub fn covers(&self, eye: &ChartPoint) -> bool {
        eye.chart == self.chart && self.distance_m(eye.pos) <= CELL_M
    }

    /// Whether it is a single place.
    pub fn is_place(&self) -> bool {
        self.from == self.to
    }

    /// The chart that it lies in.
    pub fn chart(&self) -> ChartId {
        self.chart
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

    use antipode_geometry::{Geometry, strategy};

    use super::super::testing::Numbers;
    use super::*;

    #[test]
    fn an_eye_that_a_way_covers_is_near_one_of_its_places() {
        let mut numbers = Numbers::new(5);
        let mut any =
            |reach_m: f64| DVec3::from_array([(); 3].map(|()| numbers.between(-reach_m, reach_m)));
        for _ in 0..2000 {
            let (from, step) = (ChartPoint::a(any(1e5)), any(4.0));
            let way = Way::new(&from, step);
            assert!(way.covers(&from));
            let eye = from.moved(any(1.0) + step * 0.5);
            if way.covers(&eye) {
                let nearest = way.places().map(|place| place.pos.distance(eye.pos));
                let nearest = nearest.fold(f64::INFINITY, f64::min);
                assert!(nearest <= way.slack_m(), "{way:?} {eye:?}: {nearest}");
            }
            assert!(!way.covers(&ChartPoint::new(ChartId::SECOND, eye.pos)));
        }
    }

    #[test]
    fn who_stands_asks_for_one_place_and_who_flies_for_no_more_than_a_few() {
        let from = ChartPoint::a(DVec3::new(3.0, 1.0, -8.1));
        assert_eq!(Way::new(&from, DVec3::ZERO).places().count(), 1);
        assert_eq!(
            Way::new(&from, DVec3::X * 0.1),
            Way::new(&from, DVec3::ZERO)
        );
        assert!(Way::new(&from, DVec3::X * 1e9).places().count() <= 8);
    }

    #[test]
    fn a_way_is_as_far_from_an_eye_in_the_other_chart() {
        let sphere = strategy(Geometry::Spherical, 32.0);
        let rim_m = sphere.domain(ChartId::FIRST).radius_m().unwrap();
        let at = |x: f64| ChartPoint::a(DVec3::new(x, 4.0, 0.0));
        let way = Way::new(&at(rim_m - 0.5), DVec3::ZERO);
        let over = sphere.images(at(rim_m + 2.0), f64::INFINITY)[0].point;
        assert_eq!(over.chart, ChartId::SECOND);
        let away_m = way.away_m(&*sphere, &over);
        assert!((away_m - 2.5).abs() < 0.5, "{away_m}");
        let antipode = ChartPoint::new(ChartId::SECOND, DVec3::new(0.0, 4.0, 0.0));
        assert!(way.away_m(&*sphere, &antipode) > rim_m);
    }
}
