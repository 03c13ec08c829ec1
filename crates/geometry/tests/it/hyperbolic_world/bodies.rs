//! The charts of bodies, in the hyperbolic world and on the sphere.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use antipode_geometry::{
    Atlas, BodyChart, BodyFrame, ChartId, ChartPoint, Euclidean, Eye, Map, Metric, Spherical,
    Strategy,
};
use glam::{DVec3, DVec4};
use proptest::prelude::{prop_assert, proptest};

use super::common::{charts, place, worlds};
use crate::space::common::{cases, vector};

const SPEED_M_S: f64 = 4.5;
const TICK_S: f64 = 1.0 / 60.0;

/// A space and a place in it.
fn bodies(chart: ChartId, share: DVec3) -> Vec<(Box<dyn Strategy>, ChartPoint)> {
    let mut all: Vec<(Box<dyn Strategy>, ChartPoint)> = Vec::new();
    for world in worlds() {
        let at = place(&world, chart, share);
        all.push((Box::new(world), at));
    }
    let half = if share.x > 0.0 {
        ChartId::FIRST
    } else {
        ChartId::SECOND
    };
    let level = DVec3::new(share.z, 0.0, share.y) * (0.9 * FRAC_PI_2 * 32.0 / 2f64.sqrt());
    let at = ChartPoint::new(half, level.with_y(5.0 + 10.0 * share.y.abs()));
    all.push((Box::new(Spherical::new(32.0)), at));
    all.push((Box::new(Euclidean), ChartPoint::a(share * 50.0)));
    all
}

proptest! {
    #![proptest_config(cases(300))]

    #[test]
    fn what_is_near_comes_into_a_bodys_chart_and_back(chart in charts(), share in vector(1.2), off in vector(12.0)) {
        for (space, body) in bodies(chart, share) {
            let own = BodyChart::new(&*space, body);
            prop_assert!(own.pos(body).distance(DVec3::Y * body.pos.y) < 1e-12);
            let point = own.point(off);
            prop_assert!(own.pos(point).distance(off) < 1e-11, "{space:?} {off}");
            // However it is written.
            for image in space.images(point, 8.0) {
                prop_assert!(own.pos(image.point).distance(off) < 1e-10, "{space:?}");
            }
            // Not farther away than the chart says where space is hyperbolic, and not nearer on a sphere.
            let bound = own.stretch_across(off.with_y(0.0).length());
            prop_assert!((bound - 1.0) * -space.curvature().sign >= 0.0);
            let level_m = space.distance_m(own.point(off.with_y(0.0)), own.point(DVec3::ZERO), &Eye::default());
            prop_assert!((level_m - off.with_y(0.0).length()).abs() < 1e-10, "straight out it is true");
        }
    }

    #[test]
    fn lengths_near_a_body_are_those_of_the_space(chart in charts(), share in vector(1.2), a in vector(10.0), way in vector(1.0)) {
        for (space, body) in bodies(chart, share) {
            let own = BodyChart::new(&*space, body);
            let a = a.with_y(body.pos.y);
            let b = a + way.with_y(0.0) * 1e-3;
            let true_m = space.distance_m(own.point(a), own.point(b), &Eye::default());
            let told_m = a.distance(b) * own.level_stretch(body.pos.y);
            let ends = [1.0, own.stretch_across(a.with_y(0.0).length() + 1e-3)];
            let ratio = true_m / told_m;
            let bounds = [ends[0].min(ends[1]), ends[0].max(ends[1])];
            prop_assert!(a.distance(b) < 1e-5 || (bounds[0] - 1e-6..bounds[1] + 1e-6).contains(&ratio), "{space:?} {ratio} {bounds:?}");
        }
    }

    #[test]
    fn a_bodys_frame_has_metres_of_the_space_and_leads_there_and_back(
        chart in charts(), share in vector(1.2), way in vector(2.0), normal in vector(1.0), corner in 0..8_u8,
    ) {
        for (space, body) in bodies(chart, share) {
            let Some(frame) = BodyFrame::of(&*space, body) else {
                prop_assert!(space.curvature().sign == 0.0, "{space:?}");
                prop_assert!(BodyFrame::way(&*space, body, body.moved(way)).distance(way) < 1e-12);
                continue;
            };
            let arrival = frame.arrival(way);
            prop_assert!(arrival.point.chart == body.chart && arrival.point.pos.y == body.pos.y + way.y);
            prop_assert!(frame.offsets()(arrival.point.pos).distance(way) < 1e-10, "{space:?}");
            prop_assert!(frame.arrival(way.with_y(0.0) * 0.0).point == body, "to the bit");
            // Near the body it is the chart's frame, which the world's metric knows by itself.
            let near = frame.offsets()(body.pos + space.in_chart(body, way) * 1e-6) * 1e6;
            prop_assert!(near.distance(way) < 1e-5, "{space:?} {near} {way}");
            // A step is that of the body's chart.
            let step = BodyChart::step(&*space, body, way.with_y(0.0));
            let own = frame.arrival(way.with_y(0.0));
            let same = space.carry(step.point, body.chart).unwrap();
            prop_assert!(same.point.pos.distance(own.point.pos) < 1e-10);
            let turned_rad = own.turn_rad - step.turn_rad - same.turn_rad;
            prop_assert!(turned_rad.sin().abs() < 1e-9, "{space:?} {turned_rad}");
            // A box holds what is in it.
            let high = way.abs() + 0.2;
            let sign = |bit: u8| if corner & bit == 0 { -1.0 } else { 1.0 };
            let at = frame.arrival(high * DVec3::new(sign(1), sign(2), sign(4))).point.pos;
            let (min, max) = frame.chart_box(-high, high);
            prop_assert!(at.cmpge(min - 0.05).all() && at.cmple(max + 0.05).all(), "{space:?} {at} in {min} to {max}");
            // What is square to a normal stays so.
            let plane = normal.cross(way);
            let told = frame.normal(normal).dot(space.in_frame(body, plane));
            prop_assert!(told.abs() < 1e-9 * (1.0 + plane.length() * 10.0));
        }
    }

    /// Told by the frames of the world's charts, which know nothing of bodies' charts.
    #[test]
    fn a_step_goes_so_far_and_turns_as_the_way_does(chart in charts(), share in vector(1.2), heading in 0.0..TAU, step_m in 0.01..9.0_f64) {
        for (space, body) in bodies(chart, share) {
            let ahead = DVec3::new(heading.cos(), 0.0, heading.sin());
            let step = BodyChart::step(&*space, body, ahead * step_m);
            prop_assert!((step.point.pos.y - body.pos.y).abs() < 1e-11);
            let foot = |it: ChartPoint| ChartPoint::new(it.chart, it.pos.with_y(0.0));
            let stretch = BodyChart::new(&*space, body).level_stretch(body.pos.y);
            let plane_m = space.distance_m(foot(body), foot(step.point), &Eye::default());
            prop_assert!((plane_m * stretch - step_m).abs() < 1e-10, "{space:?} {plane_m}");
            // A foot's view of the other is along the way, from either end.
            let seen = |from: ChartPoint, to: ChartPoint| {
                let eye = Eye { point: foot(from), ..Eye::default() };
                eye.to_chart(space.view_point(&eye, foot(to)).truncate()).normalize()
            };
            prop_assert!(seen(body, step.point).distance(ahead) < 1e-11 / step_m.min(1.0));
            let arriving = step.turn_vector(ahead);
            prop_assert!(seen(step.point, body).distance(-arriving) < 1e-11 / step_m.min(1.0), "{space:?}");
            let back = BodyChart::step(&*space, step.point, -arriving * step_m);
            let home = space.carry(back.point, body.chart).unwrap().point;
            prop_assert!(home.pos.distance(body.pos) < 1e-9, "{space:?} {home:?} {body:?}");
        }
    }
}

/// Where a body is over `from`, in radii: the model's point, in the frame there.
fn seen(space: &dyn Strategy, from: ChartPoint, to: ChartPoint) -> DVec4 {
    let eye = Eye {
        point: from,
        ..Eye::default()
    };
    space.view_point(&eye, to)
}

fn halton(index: u32, base: u32) -> f64 {
    let (mut part, mut sum, mut left) = (1.0, 0.0, index);
    while left > 0 {
        part /= f64::from(base);
        sum += part * f64::from(left % base);
        left /= base;
    }
    sum
}

/// 50 places and headings of the sphere: a quarter of the way round at walking pace. The heights and speeds that are kept.
#[test]
fn on_the_sphere_a_walk_is_a_great_circle_and_as_fast_everywhere() {
    let space = Spherical::new(32.0);
    let mut most = [0.0_f64; 3];
    for walk in 1..=50 {
        let [u, v, w] = [2, 3, 5].map(|base| halton(walk, base));
        let chart = if walk % 2 == 0 {
            ChartId::FIRST
        } else {
            ChartId::SECOND
        };
        let (r, phi) = (32.0 * (1.0 - u).acos(), TAU * v);
        let height_m = 5.0 + 10.0 * halton(walk, 7);
        let mut at = ChartPoint::new(chart, DVec3::new(r * phi.cos(), height_m, r * phi.sin()));
        let start = at;
        let mut yaw = TAU * w - PI;
        // The plane of the great circle, by its normal: level, aside of the way, at the start's foot.
        let aside = DVec3::new(-yaw.sin(), 0.0, yaw.cos());
        let foot = ChartPoint::new(chart, start.pos.with_y(0.0));
        let eye = Eye {
            point: foot,
            ..Eye::default()
        };
        let quarter_m = FRAC_PI_2 * 32.0 * (height_m / 32.0).cos();
        let ticks = (quarter_m / (SPEED_M_S * TICK_S)).floor() as u32;
        for _ in 0..ticks {
            let way = DVec3::new(yaw.cos(), 0.0, yaw.sin()) * (SPEED_M_S * TICK_S);
            let step = BodyChart::step(&space, at, way);
            let gone_m = space.distance_m(at, step.point, &Eye::default());
            most[0] = most[0].max((gone_m / TICK_S / SPEED_M_S - 1.0).abs());
            at = step.point;
            yaw -= step.turn_rad;
            let view = space.view_point(&eye, at);
            let off = eye.to_chart(view.truncate()).dot(aside) / 32.0 / (height_m / 32.0).cos();
            most[1] = most[1].max(off.asin().abs().to_degrees());
        }
        most[2] = most[2].max((at.pos.y - height_m).abs());
        // A quarter of the world away, but for the last part of a tick.
        let end = seen(&space, foot, ChartPoint::new(at.chart, at.pos.with_y(0.0)));
        let rest_m = f64::from(ticks) * SPEED_M_S * TICK_S / (height_m / 32.0).cos();
        assert!((end.w - (rest_m / 32.0).cos()).abs() < 1e-10);
    }
    println!(
        "speed off by {:e}, {:e} degrees aside, {:e} m up",
        most[0], most[1], most[2]
    );
    assert!(most[0] < 0.005 && most[1] < 0.1 && most[2] < 1e-9);
    // What the walk is made of is exact; these are only roundings.
    assert!(most[0] < 1e-5 && most[1] < 1e-9);
}

#[test]
fn in_the_hyperbolic_world_a_walk_is_a_geodesic_of_the_level_and_as_fast_everywhere() {
    for world in worlds() {
        let mut most = [0.0_f64; 2];
        for walk in 1..=50 {
            let [u, v, w] = [2, 3, 5].map(|base| 2.0 * halton(walk, base) - 1.0);
            let chart = ChartId::new(u128::from(walk).pow(walk % 20));
            let start = place(&world, chart, DVec3::new(u, halton(walk, 7), v) * 0.999);
            let height_m = start.pos.y;
            let (mut at, mut yaw) = (start, PI * w);
            let foot = ChartPoint::new(chart, start.pos.with_y(0.0));
            let ahead = DVec3::new(yaw.cos(), 0.0, yaw.sin());
            let (ticks, stretch) = (60 * 40, (height_m / world.radius_m()).cosh());
            for _ in 0..ticks {
                let way = DVec3::new(yaw.cos(), 0.0, yaw.sin()) * (SPEED_M_S * TICK_S);
                let step = BodyChart::step(&world, at, way);
                let gone_m = world.distance_m(at, step.point, &Eye::default());
                most[0] = most[0].max((gone_m / TICK_S / SPEED_M_S - 1.0).abs());
                at = step.point;
                yaw -= step.turn_rad;
            }
            let way_m = f64::from(ticks) * SPEED_M_S * TICK_S / stretch;
            // Straight on along the plane, by the world's own geodesics.
            let eye = Eye {
                point: foot,
                ..Eye::default()
            };
            let end = world.along(&eye, eye.to_view(ahead), way_m);
            let off_m = world.distance_m(end, ChartPoint::new(at.chart, at.pos.with_y(0.0)), &eye);
            most[1] = most[1].max(off_m / way_m);
        }
        println!(
            "{world:?}: speed off by {:e}, {:e} of the way aside",
            most[0], most[1]
        );
        assert!(most[0] < 1e-5 && most[1] < 1e-3, "{most:?}");
    }
}

#[test]
fn the_ground_about_a_body_is_stretched_as_little_as_said() {
    let [_, world, _] = worlds();
    let sphere = Spherical::new(32.0);
    let stretch =
        |space: &dyn Strategy| BodyChart::new(space, ChartPoint::a(DVec3::Y)).stretch_across(10.0);
    assert!((stretch(&world) - 1.0).abs() < 0.005, "{}", stretch(&world));
    assert!(
        (stretch(&sphere) - 1.0).abs() < 0.017,
        "{}",
        stretch(&sphere)
    );
}

/// A wave of the hand is the same in the body's chart before and after an edge: nothing but the address has changed.
#[test]
fn over_an_edge_what_is_about_a_body_stays_where_it_is() {
    for world in worlds() {
        let half_m = world.domain(ChartId::FIRST).half_width_m();
        let thing = ChartPoint::a(DVec3::new(half_m - 2.0, 4.0, 5.0));
        let at = |x: f64| ChartPoint::a(DVec3::new(half_m + x, 3.0, 4.0));
        let here = BodyChart::new(&world, at(0.0)).pos(thing);
        let over = world.carry(at(0.0), ChartId::new(1)).unwrap();
        let there = BodyChart::new(&world, over.point).pos(thing);
        assert!(
            over.turn_vector(here).distance(there) < 1e-11,
            "{here} {there}"
        );
    }
}

/// Who goes to and fro on a line between charts keeps the one, as by [`Atlas::cross`], and is in the same place.
#[test]
fn on_the_line_a_body_keeps_its_chart() {
    let all = bodies(ChartId::FIRST, DVec3::splat(0.5));
    for (space, _) in all
        .iter()
        .filter(|(it, _)| it.domain(ChartId::FIRST).half_width_m().is_finite())
    {
        let half_m = space.domain(ChartId::FIRST).half_width_m();
        let at = ChartPoint::a(DVec3::new(half_m - 0.05, 5.0, 0.0));
        let over = BodyChart::step(&**space, at, DVec3::X * 0.1);
        assert_eq!(over.point.chart, ChartId::FIRST);
        let past = BodyChart::step(&**space, over.point, over.turn_vector(DVec3::X) * 0.3);
        assert!(past.point.chart != ChartId::FIRST, "{space:?}");
        let back = BodyChart::step(
            &**space,
            past.point,
            past.turn_vector(over.turn_vector(DVec3::X)) * -0.4,
        );
        assert!(space.distance_m(back.point, at, &Eye::default()) < 1e-9);
    }
}
