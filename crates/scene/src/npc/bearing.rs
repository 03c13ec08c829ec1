//! Ways over the ground: which way, and how far, in every space alike.
//!
//! They are measured along the level that the ground lies about, y = 0 of the charts, where a geodesic that begins
//! level stays level in every space; at the dial 0 the port of a hyperbolic chart is that of its own centre.

use std::f64::consts::FRAC_PI_2;

use antipode_geometry::{ChartId, ChartPoint, Eye, NoiseFrame, Strategy};
use glam::DVec3;

/// From one place to another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Way {
    /// The unit level direction to set out in, in the chart of the start; zero where there is no way to go.
    pub heading: DVec3,
    /// How far it is along the level, in metres.
    pub level_m: f64,
}

fn level(point: ChartPoint) -> Eye {
    Eye {
        point: ChartPoint::new(point.chart, point.pos.with_y(0.0)),
        ..Eye::default()
    }
}

/// The way over the ground from one place to another.
pub(crate) fn way(strategy: &dyn Strategy, from: ChartPoint, to: ChartPoint) -> Way {
    let eye = level(from);
    let view = strategy.view_point(&eye, level(to).point);
    Way {
        heading: eye
            .to_chart(view.truncate())
            .with_y(0.0)
            .normalize_or_zero(),
        level_m: strategy.eye_distance_m(&eye, view),
    }
}

/// The place that many metres from another along a level heading, at the same height.
pub(crate) fn ahead(
    strategy: &dyn Strategy,
    from: ChartPoint,
    heading: DVec3,
    level_m: f64,
) -> ChartPoint {
    let eye = level(from);
    let end = strategy.along(&eye, eye.to_view(heading), level_m);
    ChartPoint::new(end.chart, end.pos.with_y(from.pos.y))
}

/// The unit level direction from one place to another; zero where there is no way to go.
pub(crate) fn way_to(strategy: &dyn Strategy, from: ChartPoint, to: ChartPoint) -> DVec3 {
    way(strategy, from, to).heading
}

/// How far two places are apart in the space, in metres.
pub(crate) fn apart_m(strategy: &dyn Strategy, from: ChartPoint, to: ChartPoint) -> f64 {
    let eye = Eye {
        point: from,
        ..Eye::default()
    };
    strategy.distance_m(from, to, &eye)
}

/// The level unit vector of a heading in radians.
pub(crate) fn toward(yaw_rad: f64) -> DVec3 {
    DVec3::new(yaw_rad.cos(), 0.0, yaw_rad.sin())
}

/// A heading in a chart, in radians, that comes from no place, such as one that was thrown. It is counted from the axes of
/// the space where charts lie square in it, so that it does not depend on how a chart is turned: a quarter turn takes the
/// headings of the chart to less by one.
pub(crate) fn any_heading(strategy: &dyn Strategy, chart: ChartId, yaw_rad: f64) -> f64 {
    match strategy.noise_frame(chart) {
        NoiseFrame::Square(frame) => yaw_rad + f64::from(frame.quarter_turns) * FRAC_PI_2,
        NoiseFrame::Radial | NoiseFrame::Upright => yaw_rad,
    }
}

#[cfg(test)]
mod tests {
    use antipode_geometry::{ChartId, Geometry, strategy};

    use super::*;

    #[test]
    fn who_goes_ahead_finds_the_way_back_in_every_space() {
        for geometry in Geometry::ALL {
            let space = strategy(geometry, 32.0);
            for turn in 0..12 {
                let from = ChartPoint::a(DVec3::new(11.0, 9.0, -23.0));
                let heading = toward(f64::from(turn) * 0.6);
                let to = ahead(&*space, from, heading, 30.0);
                let there = way(&*space, from, to);
                assert!(
                    (there.level_m - 30.0).abs() < 1e-6,
                    "{geometry:?} {there:?}"
                );
                assert!(
                    (there.heading - heading).length() < 1e-6,
                    "{geometry:?} {turn}"
                );
                let back = way(&*space, to, from);
                let home = ahead(&*space, to, back.heading, back.level_m);
                assert!(apart_m(&*space, home, from) < 1e-5, "{geometry:?} {turn}");
            }
        }
    }

    #[test]
    fn over_the_equator_the_way_is_the_short_one() {
        let space = strategy(Geometry::Spherical, 32.0);
        let rim_m = space.domain(ChartId::FIRST).radius_m().unwrap_or_default();
        let near = |chart, x| ChartPoint::new(chart, DVec3::new(x, 8.0, 0.0));
        let over = way(
            &*space,
            near(ChartId::FIRST, rim_m - 4.0),
            near(ChartId::SECOND, 5.0 - rim_m),
        );
        assert!((over.level_m - 9.0).abs() < 1e-6);
        assert!((over.heading - DVec3::X).length() < 1e-6, "{over:?}");
    }
}
