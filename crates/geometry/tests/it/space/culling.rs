//! Culling may waste, but never drop what is in the picture.

use std::sync::Arc;

use antipode_geometry::{
    BoundingCylinder, ChartId, ChartPoint, ChunkCoord, Curvature, Eye, Geometry, Horizon, Optics,
    Projection, Raised, Strategy, strategy,
};
use glam::{DVec2, DVec3, IVec3};
use proptest::prelude::{prop_assert, proptest};
use proptest::strategy::Strategy as _;

use super::common::{cases, eye, in_space, projection, vector};

fn spaces() -> Vec<Arc<dyn Strategy>> {
    let mut spaces: Vec<Arc<dyn Strategy>> = [16.0, 32.0, 64.0]
        .map(|radius| strategy(Geometry::Spherical, radius))
        .to_vec();
    spaces.push(strategy(Geometry::Euclidean, 0.0));
    spaces.push(strategy(Geometry::Hyperbolic, 20.0));
    spaces.push(Arc::new(Horizon::hyperbolic(20.0)));
    spaces.push(Arc::new(Horizon::bent()));
    spaces
}

/// `n^3` points of a box, its corners among them.
fn samples(min: DVec3, max: DVec3, n: u32) -> impl Iterator<Item = DVec3> {
    let last = f64::from(n - 1);
    (0..n * n * n).map(move |i| {
        let at = DVec3::new(
            f64::from(i % n),
            f64::from(i / n % n),
            f64::from(i / (n * n)),
        );
        min + (max - min) * (at / last)
    })
}

/// Whether a point of the box is in the picture and near enough to be drawn.
fn shown(space: &dyn Strategy, eye: &Eye, point: ChartPoint) -> bool {
    let view = space.view_point(eye, point);
    let near = space.eye_distance_m(eye, view) <= space.sight_limit_m(eye)
        && !space.trims(eye, point.chart, point.pos, point.pos);
    let clip = space.clip_from_view(eye, &projection(), view);
    near && Projection::screen(clip).is_some_and(|at| at.abs().max_element() <= 1.0)
}

proptest! {
    #![proptest_config(cases(400))]

    #[test]
    fn cells_hold_their_boxes_and_nothing_seen_is_culled(
        eye in eye(25.0), corner in vector(250.0), size in vector(40.0).prop_map(DVec3::abs),
        other in proptest::bool::ANY, turned in proptest::bool::ANY,
    ) {
        for space in spaces() {
            let mut eye = eye;
            eye.point = in_space(space.as_ref(), eye.point);
            if turned && space.curvature() == Curvature::FLAT {
                eye.dial = -eye.dial;
            }
            let sphere = space.geometry() == Geometry::Spherical;
            let chart = if sphere && other { ChartId::SECOND } else { ChartId::FIRST };
            let min = if sphere {
                (corner * DVec3::new(0.2, 0.1, 0.2)).abs().min(DVec3::splat(40.0 * space.radius_m() / 64.0))
            } else {
                eye.point.pos + corner
            };
            let size = if sphere { size.min(DVec3::splat(12.0)) } else { size };
            let max = min + size;
            let cell = space.sight_cell(&eye, chart, min, max);
            let frustum = space.frustum(&eye, &projection());
            let seen = frustum.cell_seen(space.as_ref(), &eye, chart, min, max).is_some();
            for pos in samples(min, max, 7) {
                let point = ChartPoint::new(chart, pos);
                let view = space.view_point(&eye, point);
                if !space.trims(&eye, chart, pos, pos) {
                    let direction = eye.to_chart(view.truncate());
                    prop_assert!(cell.holds(direction, 1e-6), "{space:?} {cell:?} {direction:?}");
                    let distance = space.eye_distance_m(&eye, view);
                    prop_assert!(cell.nearest_m <= distance * (1.0 + 1e-9) + 1e-6, "{space:?}");
                }
                prop_assert!(seen || !shown(space.as_ref(), &eye, point), "{space:?}");
            }
        }
    }
}

proptest! {
    #![proptest_config(cases(400))]

    #[test]
    fn a_drum_is_seen_wherever_boxes_in_it_are(
        eye in eye(25.0), corner in vector(250.0), size in vector(60.0).prop_map(DVec3::abs),
        low in vector(0.5), high in vector(0.5), other in proptest::bool::ANY,
    ) {
        for space in spaces() {
            let mut eye = eye;
            eye.point = in_space(space.as_ref(), eye.point);
            let sphere = space.geometry() == Geometry::Spherical;
            let chart = if sphere && other { ChartId::SECOND } else { ChartId::FIRST };
            let middle = if sphere { corner * 0.2 } else { eye.point.pos + corner };
            let (min, max) = (middle + low.min(high) * size, middle + low.max(high) * size);
            let (across, aside) = (0.5 * (max - min), 0.5 * (min + max) - middle);
            let cylinder = BoundingCylinder {
                chart,
                middle: DVec2::new(middle.x, middle.z),
                radius_m: aside.x.hypot(aside.z) + across.x.hypot(across.z),
                heights_m: [min.y, max.y],
            };
            let inner = space.sight_cell(&eye, chart, min, max);
            let outer = space.sight_cell_of(&eye, &cylinder);
            if inner.is_empty() {
                continue;
            }
            let at = format!("{space:?} {cylinder:?} {outer:?} {inner:?}");
            prop_assert!(outer.nearest_m <= inner.nearest_m * (1.0 + 1e-9) + 1e-6, "{at}");
            let slack = |slope: f64| 1e-9 * (1.0 + slope.abs().min(1e300));
            prop_assert!(outer.slope[0] <= inner.slope[0] + slack(inner.slope[0]), "{at}");
            prop_assert!(outer.slope[1] >= inner.slope[1] - slack(inner.slope[1]), "{at}");
            let apart = (inner.azimuth_rad - outer.azimuth_rad).rem_euclid(std::f64::consts::TAU);
            let apart = apart.min(std::f64::consts::TAU - apart);
            let reach = outer.half_width_rad + 1e-9;
            let inside = apart + inner.half_width_rad <= reach || reach > std::f64::consts::PI;
            prop_assert!(inside, "{at}");
        }
    }
}

proptest! {
    #![proptest_config(cases(400))]

    #[test]
    fn a_ball_rises_over_no_sheet_by_more_than_its_bound(
        eye in eye(25.0), away in vector(1.0), reach_m in 1.0..60.0_f64, radius_m in 0.1..6.0_f64,
        way in vector(1.0), other in proptest::bool::ANY, turned in proptest::bool::ANY,
    ) {
        for space in spaces() {
            let mut eye = eye;
            eye.point = in_space(space.as_ref(), eye.point);
            if turned && space.curvature() == Curvature::FLAT {
                eye.dial = -eye.dial;
            }
            let middle = in_space(space.as_ref(), eye.point.moved(away * reach_m));
            let middle = match space.images(middle, f64::INFINITY).pop().filter(|_| other) {
                Some(crossing) => crossing.point,
                None => middle,
            };
            let rises_m = space.ball_rises_m(&eye, middle, radius_m);
            let normal = way.normalize_or(DVec3::X);
            let over = |point: ChartPoint| normal.dot(space.view_point(&eye, point).truncate());
            if over(middle) >= -rises_m {
                continue;
            }
            for part in samples(DVec3::NEG_ONE, DVec3::ONE, 6) {
                let point = middle.moved(part.normalize_or_zero() * radius_m);
                prop_assert!(over(point) < 0.0, "{space:?} {middle:?} {}", over(point));
            }
        }
    }
}

/// Chunks around the eye: how many are kept, and how many of those show nothing.
fn kept_and_wasted(space: &dyn Strategy, eye: &Eye, around: i32) -> (u32, u32, u32) {
    let frustum = space.frustum(eye, &projection());
    let home = ChunkCoord::containing(eye.point);
    let (mut all, mut kept, mut wasted) = (0, 0, 0);
    for x in -around..=around {
        for y in -1..=1 {
            for z in -around..=around {
                let chunk = home.offset(IVec3::new(x, y, z));
                all += 1;
                let (mut min, mut max) = (chunk.min(), chunk.max());
                if let Some(limits) = space.limits() {
                    min.y = min.y.clamp(limits.bedrock_m, limits.ceiling_m);
                    max.y = max.y.clamp(limits.bedrock_m, limits.ceiling_m);
                }
                if frustum
                    .cell_seen(space, eye, chunk.chart, min, max)
                    .is_some()
                {
                    kept += 1;
                    let any = samples(min, max, 6)
                        .any(|pos| shown(space, eye, ChartPoint::new(chunk.chart, pos)));
                    wasted += u32::from(!any);
                }
            }
        }
    }
    (all, kept, wasted)
}

#[test]
fn culling_is_worth_its_while() {
    for space in super::common::spaces() {
        let (mut all, mut kept, mut wasted) = (0, 0, 0);
        for heading in 0..8 {
            let eye = Eye {
                point: ChartPoint::a(DVec3::new(5.0, 9.0, 3.0)),
                yaw: f64::from(heading) * 0.8,
                pitch: -0.2,
                roll: 0.0,
                dial: 10.0,
                lift_m: 1.62,
            };
            let around = if space.is_closed() { 1 } else { 6 };
            let counts = kept_and_wasted(space.as_ref(), &eye, around);
            all += counts.0;
            kept += counts.1;
            wasted += counts.2;
        }
        let geometry = space.geometry();
        println!("{geometry}: {kept} of {all} kept, {wasted} of them for nothing");
        let (most, most_wasted) = if geometry == Geometry::Spherical {
            (0.5, 0.12)
        } else {
            (0.4, 0.03)
        };
        assert!(
            f64::from(kept) < most * f64::from(all),
            "{geometry}: {kept} of {all}"
        );
        assert!(
            f64::from(wasted) < most_wasted * f64::from(kept),
            "{geometry}: {wasted} of {kept}"
        );
    }
}

#[test]
fn far_hyperbolic_chunks_are_not_drawn() {
    let space = Raised::new(20.0);
    let eye = Eye {
        roll: 0.0,
        dial: 10.0,
        ..Eye::default()
    };
    let frustum = space.frustum(&eye, &projection());
    let sees = |x: f64| {
        let min = DVec3::new(x, -5.0, -5.0);
        frustum
            .cell_seen(&space, &eye, ChartId::FIRST, min, min + 10.0)
            .is_some()
    };
    assert!(sees(300.0));
    assert!(!sees(450.0));
    assert!(!sees(1e12));
}

#[test]
fn land_overhead_and_land_behind_are_told_apart_on_the_sphere() {
    let space = strategy(Geometry::Spherical, 16.0);
    let eye = Eye {
        point: ChartPoint::a(DVec3::Y * 5.0),
        pitch: 1.5,
        ..Eye::default()
    };
    let frustum = space.frustum(&eye, &projection());
    let sees = |chart, min: DVec3, size: f64| {
        frustum
            .cell_seen(space.as_ref(), &eye, chart, min, min + size)
            .is_some()
    };
    // The other pole stands overhead; the ground underfoot is behind.
    assert!(sees(ChartId::SECOND, DVec3::new(-2.0, 3.0, -2.0), 4.0));
    assert!(!sees(ChartId::FIRST, DVec3::new(0.0, 1.0, 0.0), 0.5));
    // Nearly the whole chart.
    assert!(sees(ChartId::FIRST, DVec3::new(-24.0, 1.0, -24.0), 20.0));
}
