//! What the world has to show to who walks and measures in it, chart by chart.

use std::f64::consts::{FRAC_PI_2, PI};

use antipode_geometry::{
    Atlas, BodyChart, ChartId, ChartPoint, Eye, HyperbolicWorld, Map, equilateral_angle_sum_rad,
};
use glam::DVec3;

use super::common::{apart_m, chart, outward};
use antipode_geometry::tiling::Side;

/// Somebody on foot.
struct Walker<'a> {
    world: &'a HyperbolicWorld,
    at: ChartPoint,
    yaw: f64,
    charts: usize,
}

impl<'a> Walker<'a> {
    fn new(world: &'a HyperbolicWorld, at: ChartPoint, yaw: f64) -> Self {
        Self {
            world,
            at,
            yaw,
            charts: 0,
        }
    }

    /// Straight on, in steps as those of a walk.
    fn walk(&mut self, way_m: f64) {
        let steps = (way_m.abs() / 0.25).ceil().max(1.0);
        for _ in 0..steps as u32 {
            let ahead = DVec3::new(self.yaw.cos(), 0.0, self.yaw.sin()) * (way_m / steps);
            let step = BodyChart::step(self.world, self.at, ahead);
            self.charts += usize::from(step.point.chart != self.at.chart);
            self.at = step.point;
            self.yaw -= step.turn_rad;
        }
    }
}

/// A chart far out.
fn far() -> ChartId {
    chart(&outward(&[0, 1, 3].map(Side::new), 30.0))
}

#[test]
fn four_sides_with_right_angles_end_where_they_should() {
    for (radius_m, ends) in [
        (60.305, [(20.0, 1.599), (30.0, 5.581), (64.0, 64.0)]),
        (30.152, [(20.0, 6.922), (30.0, 25.934), (64.0, 177.218)]),
    ] {
        let world = HyperbolicWorld::new(radius_m);
        for (side_m, end_m) in ends {
            for (start, yaw) in [(ChartId::FIRST, 0.3), (far(), -2.0)] {
                // Near a corner, so that even the shortest sides lead over edges.
                let corner_m = world.domain(start).half_width_m() - 3.0;
                let start = ChartPoint::new(start, DVec3::new(corner_m, 0.0, -corner_m));
                let mut walker = Walker::new(&world, start, yaw);
                for _ in 0..4 {
                    walker.walk(side_m);
                    walker.yaw += FRAC_PI_2;
                }
                let missed_m = apart_m(&world, start, walker.at);
                println!(
                    "R {radius_m}, {side_m} m: {missed_m:.4} m, {} charts",
                    walker.charts
                );
                assert!((missed_m / end_m - 1.0).abs() < 1e-3, "{missed_m} {end_m}");
                assert!(walker.charts > 0);
            }
        }
    }
}

#[test]
fn five_sides_as_long_as_a_square_is_wide_close_and_higher_up_shorter_ones_do() {
    for world in super::common::worlds() {
        for height_m in [0.0, 20.0] {
            let width_m = 2.0 * world.domain(ChartId::FIRST).half_width_m();
            let start = ChartPoint::new(far(), DVec3::new(3.0, height_m, -5.0));
            let mut walker = Walker::new(&world, start, 1.0);
            for _ in 0..5 {
                let stretch = BodyChart::new(&world, walker.at).level_stretch(height_m);
                walker.walk(width_m * stretch);
                walker.yaw += FRAC_PI_2;
            }
            let missed_m = apart_m(&world, start, walker.at);
            println!("five sides of {width_m} m at {height_m} m miss by {missed_m:e} m");
            assert!(missed_m < 1e-9);
            assert!((walker.yaw - 1.0 - 2.5 * PI).rem_euclid(2.0 * PI).min(1.0) < 1.0 + 1e-9);
            assert!((walker.at.pos.y - height_m).abs() < 1e-9);
        }
    }
}

#[test]
fn three_poles_64_m_apart_have_less_than_two_right_angles() {
    for (radius_m, sum_deg) in [(60.305, 155.48), (30.152, 108.0)] {
        let world = HyperbolicWorld::new(radius_m);
        let law = equilateral_angle_sum_rad(-radius_m.powi(-2), 64.0);
        let first = ChartPoint::new(far(), DVec3::new(-3.0, 0.0, 9.0));
        let mut second = Walker::new(&world, first, 0.7);
        second.walk(64.0);
        let mut third = Walker::new(&world, second.at, second.yaw + PI - law / 3.0);
        third.walk(64.0);
        let poles = [first, second.at, third.at];
        assert!((apart_m(&world, first, third.at) - 64.0).abs() < 2e-3);
        let seen = |from: usize, to: usize| {
            let eye = Eye {
                point: poles[from],
                ..Eye::default()
            };
            let view = world.view_point(&eye, poles[to % 3]).truncate();
            view.normalize()
        };
        let sum: f64 = (0..3)
            .map(|i| seen(i, i + 1).angle_between(seen(i, i + 2)))
            .sum();
        println!("R {radius_m}: {:.4} degrees", sum.to_degrees());
        assert!((sum.to_degrees() - sum_deg).abs() < 0.005, "{sum}");
    }
}

/// Steps and turns of a way of 2 km, always the same.
fn way() -> Vec<(f64, f64)> {
    let mut state = 7_u64;
    let mut drawn = move || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    (0..200)
        .map(|_| (10.0, (drawn() - 0.5) * 4.0 * PI / 3.0))
        .collect()
}

/// A heading is off by 1e-16 at least, and who walks back over D radii by it comes out `1e-16 sinh(D)` radii aside. So it is
/// the distance that counts, not the way.
#[test]
fn two_kilometres_out_and_back_by_the_inverse_end_at_the_start() {
    for (world, most_m) in super::common::worlds().iter().zip([1e-2, 1e-6, 1e-6]) {
        let start = ChartPoint::new(ChartId::FIRST, DVec3::new(2.0, 5.0, 3.0));
        let mut walker = Walker::new(world, start, 0.2);
        for (step_m, turn) in way() {
            walker.yaw += turn;
            walker.walk(step_m);
        }
        let out_m = apart_m(world, start, walker.at);
        for (step_m, turn) in way().into_iter().rev() {
            walker.walk(-step_m);
            walker.yaw -= turn;
        }
        let off_m = if walker.at.chart == start.chart {
            walker.at.pos.distance(start.pos)
        } else {
            f64::INFINITY
        };
        let charts = walker.charts;
        println!(
            "{world:?}: {out_m:.0} m away, {charts} charts, back {off_m:e} m off, {:e} rad",
            walker.yaw - 0.2
        );
        assert!(off_m < most_m);
    }
}

/// By marks that were laid, and not by a heading, nothing is lost however far.
#[test]
fn two_kilometres_straight_out_and_back_along_marks_end_at_the_start() {
    for world in super::common::worlds() {
        let start = ChartPoint::new(ChartId::FIRST, DVec3::new(2.0, 5.0, 3.0));
        let mut walker = Walker::new(&world, start, 0.2);
        let mut marks = vec![start];
        for _ in 0..200 {
            walker.walk(10.0);
            marks.push(walker.at);
        }
        let out_m = apart_m(&world, start, walker.at);
        let stretch = BodyChart::new(&world, start).level_stretch(5.0);
        println!("{world:?}: {out_m:.6} m on the plane");
        // The chord of a level 5 m up is a little shorter than the way.
        assert!(out_m < 2000.0 && out_m > 2000.0 / stretch - 1e-6);
        while let Some(mark) = marks.pop() {
            let body = BodyChart::new(&world, walker.at);
            let to = body.pos(mark);
            assert!(to.with_y(0.0).length() < 10.0 / stretch + 1e-9);
            walker.at = body.arrival(to).point;
        }
        assert_eq!(walker.at.chart, start.chart);
        assert!(walker.at.pos.distance(start.pos) < 1e-12 * 60.0);
    }
}
