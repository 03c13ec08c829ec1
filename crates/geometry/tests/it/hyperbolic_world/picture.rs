//! What an eye sees: points there and back, frames and normals, and what is not to be culled.

use antipode_geometry::tiling::equiangular_point;
use antipode_geometry::{
    Atlas, BoundingCylinder, ChartId, ChartPoint, Eye, HyperbolicWorld, Map, Metric, Optics,
    Projection,
};
use glam::{DMat4, DVec2, DVec3, DVec4};
use proptest::prelude::{prop_assert, prop_assert_eq, proptest};

use super::common::{angles, beyond, charts, looking, place, steps, worlds};
use crate::space::common::{cases, projection, vector};

/// That of the model: -1 for points.
fn inner(a: DVec4, b: DVec4) -> f64 {
    a.truncate().dot(b.truncate()) - a.w * b.w
}

fn radii(world: &HyperbolicWorld, view: DVec4) -> DVec4 {
    (view.truncate() / world.radius_m()).extend(view.w)
}

/// `port` of shaders/spaces/squares.wgsl, of a place relative to the reference of its chart.
fn port(world: &HyperbolicWorld, eye: &Eye, point: ChartPoint) -> DVec4 {
    let (radius_m, reference) = (world.radius_m(), world.reference(eye, point.chart));
    let u = (point.pos - reference) / radius_m;
    let origin = world.port_origin(eye, point.chart);
    let (here, w0) = (DVec2::new(origin.x, origin.y), origin.z);
    let t = DVec2::new(u.x.tanh(), u.z.tanh());
    let away = t * (1.0 - here * here) / (1.0 + here * t);
    let at = here + away;
    let along = w0 * here.dot(away);
    let level = (away + w0 * here * (along / (1.0 + w0))) / (1.0 - at.length_squared()).sqrt();
    let more = level.length_squared() / (1.0 + (1.0 + level.length_squared()).sqrt());
    let lift = reference.y / radius_m;
    let upright = (lift + u.y).cosh();
    DVec4::new(
        radius_m * upright * level.x,
        radius_m * (u.y.sinh() - lift.sinh() * upright * more),
        radius_m * upright * level.y,
        u.y.cosh() + lift.cosh() * upright * more,
    )
}

proptest! {
    #![proptest_config(cases(300))]

    #[test]
    fn what_is_seen_comes_back_in_the_chart_that_it_belongs_to(
        from in charts(), over in steps(5), eye in vector(1.2), share in vector(0.9999), angles in angles(),
    ) {
        for world in worlds() {
            let eye = looking(place(&world, from, eye), angles);
            let point = place(&world, beyond(from, &over), share);
            let view = world.view_point(&eye, point);
            let unit = radii(&world, view);
            let lost = 1e-15 * unit.w * unit.w;
            prop_assert!((inner(unit, unit) + 1.0).abs() < 100.0 * lost);
            let back = world.chart_point(&eye, view);
            // The rounding of a coordinate far off, carried to there.
            prop_assert_eq!(back.chart, point.chart);
            prop_assert!(back.pos.distance(point.pos) < 100.0 * lost * world.radius_m(), "{} {}", back.pos, point.pos);
            let viewer = world.viewer(&eye);
            prop_assert_eq!([viewer(eye.point), viewer(point)], [world.view_point(&eye, eye.point), view]);
            let [seen_m, apart_m] = [world.eye_distance_m(&eye, view), world.distance_m(eye.point, point, &eye)];
            prop_assert!((seen_m - apart_m).abs() < 1e-10 * (1.0 + seen_m), "{seen_m} {apart_m}");
        }
    }

    /// And no less so far off, where a little that a direction lacks would have grown.
    #[test]
    fn geodesics_are_as_long_as_asked_and_lead_back(
        from in charts(), eye in vector(1.2), way in vector(1.0), radii in 0.01..14.0_f64, angles in angles(),
    ) {
        for world in worlds() {
            let eye = looking(place(&world, from, eye), angles);
            let (way, length_m) = (way.normalize_or(DVec3::X), radii * world.radius_m());
            let end = world.along(&eye, way, length_m);
            let apart_m = world.distance_m(eye.point, end, &eye);
            // High up coordinates are large, and squares of them cancel.
            let up = end.pos.y.abs() / world.radius_m();
            let lost_m = 1e-9 + 1e-15 * length_m * (radii + 2.0 * up).exp();
            prop_assert!((apart_m - length_m).abs() < lost_m, "{apart_m} {length_m}");
            // Off by no more than a direction's rounding makes there.
            let seen = world.view_point(&eye, end).truncate().normalize();
            prop_assert!(seen.distance(way) < 1e-13 * (2.0 * up).exp(), "{seen} {way}");
            let half = world.along(&eye, way, 0.5 * length_m);
            let rest_m = world.distance_m(half, end, &eye);
            prop_assert!((rest_m - 0.5 * length_m).abs() < lost_m, "{rest_m}");
        }
    }

    /// The law of pictures, with the shaders' port.
    #[test]
    fn the_matrix_of_a_chart_takes_its_port_to_the_view(
        from in charts(), over in steps(6), eye in vector(1.2), share in vector(1.4), angles in angles(),
    ) {
        for world in worlds() {
            let eye = looking(place(&world, from, eye), angles);
            let point = place(&world, beyond(from, &over), share);
            let port = port(&world, &eye, point);
            let view = world.view_point(&eye, point);
            let drawn = world.chart_matrix(&eye, point.chart) * port;
            prop_assert!((drawn - view).length() < 1e-12 * view.length(), "{drawn} {view}");
            prop_assert!((world.curved(&eye, eye.point) - equiangular_point(eye.point.pos / world.radius_m()).unwrap()).length() < 1e-14);
            // The light's model is that of the eye's chart, whichever chart is drawn.
            let lit = radii(&world, world.light_matrix(&eye, point.chart) * port);
            let own = world.curved(&eye, point);
            prop_assert!((lit - own).length() < 1e-12 * own.length(), "{lit} {own}");
            let way = world.between(point.chart, eye.point.chart);
            let metres = |it: DVec4| (it.truncate() * world.radius_m()).extend(it.w);
            let there = equiangular_point(point.pos / world.radius_m()).unwrap();
            let carried = radii(&world, way * metres(there));
            prop_assert!((carried - own).length() < 1e-12 * own.length(), "{carried} {own}");
        }
    }

    /// Near the eye the port is the place itself, in whichever chart that is told: nothing has cancelled.
    #[test]
    fn near_the_eye_the_port_is_as_exact_as_what_lies_before_it(
        from in charts(), share in vector(0.99), by in vector(0.1),
    ) {
        for world in worlds() {
            let point = place(&world, from, share);
            let eye = looking(point, [0.0; 3]);
            for image in world.images(point, 5.0) {
                let chart = image.point.chart;
                prop_assert_eq!(world.reference(&eye, chart), image.point.pos);
                let turn = world.chart_matrix(&eye, chart).w_axis;
                prop_assert!((turn - DVec4::W).length() < 1e-11, "{turn}");
            }
            let step = 1e-3 * by;
            let port = port(&world, &eye, point.moved(step)).truncate();
            let frame = world.in_frame(point, step);
            prop_assert!(port.distance(frame) < 1e-4 * step.length(), "{port} {frame}");
        }
    }

    #[test]
    fn eyes_have_upright_orthonormal_axes_and_frames_are_the_slopes_of_the_chart(
        from in charts(), share in vector(1.3), angles in angles(), way in vector(1.0), normal in vector(1.0),
    ) {
        for world in worlds() {
            let point = place(&world, from, share);
            let eye = looking(point, angles);
            let view = world.view_matrix(&eye);
            prop_assert!((view * (world.radius_m() * world.curved(&eye, point).truncate()).extend(world.curved(&eye, point).w) - DVec4::W).length() < 1e-11);
            // A little step of the chart, seen from where it begins, is the vector in the frame.
            let short = 1e-4;
            let [ahead, back] = [1.0, -1.0].map(|sign| world.view_point(&eye, point.moved(way * (sign * short))));
            let slope = eye.to_chart((ahead - back).truncate() / (2.0 * short));
            let told = world.in_frame(point, way);
            prop_assert!(slope.distance(told) < 1e-6, "{slope} {told}");
            prop_assert!(world.in_chart(point, told).distance(way) < 1e-12);
            // A normal stands on what it stood on in the chart, however that is stretched.
            let along = normal.cross(way);
            let there = world.port_normal(&eye, point, normal);
            prop_assert!((there.length() - 1.0).abs() < 1e-12);
            prop_assert!(there.dot(world.in_frame(point, along)).abs() < 1e-12 * (1.0 + along.length()));
            prop_assert!(there.dot(world.in_frame(point, normal)) > 0.0);
        }
    }
}

#[test]
fn the_model_keeps_lengths() {
    let world = HyperbolicWorld::new(60.305);
    let eye = looking(
        place(&world, ChartId::new(77), DVec3::splat(0.6)),
        [0.3, -0.4, 0.2],
    );
    let flip = DMat4::from_diagonal(DVec4::new(1.0, 1.0, 1.0, -1.0));
    for number in [0, 5, 77, 78, 300] {
        let matrix = world.chart_matrix(&eye, ChartId::new(number));
        let exact = DVec3::splat(world.radius_m()).extend(1.0);
        let unit = DMat4::from_diagonal(exact.recip()) * matrix * DMat4::from_diagonal(exact);
        let off = flip * unit.transpose() * flip * unit - DMat4::IDENTITY;
        let most = |it: DMat4| {
            it.to_cols_array()
                .into_iter()
                .fold(0.0, |most: f64, x| most.max(x.abs()))
        };
        assert!(most(off) < 1e-14 * most(unit).powi(2), "{off}");
    }
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

fn shown(world: &HyperbolicWorld, eye: &Eye, point: ChartPoint) -> bool {
    let view = world.view_point(eye, point);
    let near = world.eye_distance_m(eye, view) <= world.sight_limit_m(eye)
        && !world.trims(eye, point.chart, point.pos, point.pos);
    let clip = world.clip_from_view(eye, &projection(), view);
    near && Projection::screen(clip).is_some_and(|at| at.abs().max_element() <= 1.0)
}

proptest! {
    #![proptest_config(cases(300))]

    #[test]
    fn cells_hold_their_boxes_and_nothing_seen_is_culled(
        from in charts(), over in steps(6), eye in vector(1.2), share in vector(1.6), size in vector(40.0), angles in angles(),
    ) {
        for world in worlds() {
            let eye = looking(place(&world, from, eye), angles);
            let chart = beyond(from, &over);
            let min = place(&world, chart, share).pos;
            let max = min + size.abs();
            let cell = world.sight_cell(&eye, chart, min, max);
            let frustum = world.frustum(&eye, &projection());
            let seen = frustum.cell_seen(&world, &eye, chart, min, max).is_some();
            for pos in samples(min, max, 6) {
                let point = ChartPoint::new(chart, pos);
                let view = world.view_point(&eye, point);
                if !world.trims(&eye, chart, pos, pos) {
                    let direction = eye.to_chart(view.truncate());
                    prop_assert!(cell.holds(direction, 1e-6), "{world:?} {cell:?} {direction:?}");
                    let away_m = world.eye_distance_m(&eye, view);
                    prop_assert!(cell.nearest_m <= away_m * (1.0 + 1e-9) + 1e-6, "{cell:?} {away_m}");
                }
                prop_assert!(seen || !shown(&world, &eye, point), "{world:?}");
            }
        }
    }

    #[test]
    fn a_drum_is_seen_wherever_boxes_in_it_are(
        from in charts(), over in steps(4), eye in vector(1.2), share in vector(0.8), size in vector(20.0),
        low in vector(0.5), high in vector(0.5), angles in angles(),
    ) {
        for world in worlds() {
            let eye = looking(place(&world, from, eye), angles);
            let chart = beyond(from, &over);
            let middle = place(&world, chart, share).pos;
            let (min, max) = (middle + low.min(high) * size.abs(), middle + low.max(high) * size.abs());
            let (across, aside) = (0.5 * (max - min), 0.5 * (min + max) - middle);
            let cylinder = BoundingCylinder {
                chart,
                middle: DVec2::new(middle.x, middle.z),
                radius_m: aside.x.hypot(aside.z) + across.x.hypot(across.z),
                heights_m: [min.y, max.y],
            };
            let (inner, outer) = (world.sight_cell(&eye, chart, min, max), world.sight_cell_of(&eye, &cylinder));
            if inner.is_empty() {
                continue;
            }
            prop_assert!(outer.nearest_m <= inner.nearest_m * (1.0 + 1e-9) + 1e-6);
            let slack = |slope: f64| 1e-9 * (1.0 + slope.abs().min(1e300));
            prop_assert!(outer.slope[0] <= inner.slope[0] + slack(inner.slope[0]));
            prop_assert!(outer.slope[1] >= inner.slope[1] - slack(inner.slope[1]));
            for pos in samples(min, max, 3) {
                let view = world.view_point(&eye, ChartPoint::new(chart, pos));
                let direction = eye.to_chart(view.truncate());
                prop_assert!(outer.holds(direction, 1e-6), "{outer:?} {direction}");
            }
        }
    }

    #[test]
    fn a_ball_rises_over_no_sheet_by_more_than_its_bound(
        from in charts(), over in steps(3), eye in vector(1.2), share in vector(1.3), radius_m in 0.1..6.0_f64,
        way in vector(1.0), angles in angles(),
    ) {
        for world in worlds() {
            let eye = looking(place(&world, from, eye), angles);
            let middle = place(&world, beyond(from, &over), share);
            let rises_m = world.ball_rises_m(&eye, middle, radius_m);
            let normal = way.normalize_or(DVec3::X);
            let over = |point: ChartPoint| normal.dot(world.view_point(&eye, point).truncate());
            if over(middle) >= -rises_m {
                continue;
            }
            for part in samples(DVec3::NEG_ONE, DVec3::ONE, 6) {
                let point = middle.moved(part.normalize_or_zero() * radius_m);
                prop_assert!(over(point) < 0.0, "{world:?} {middle:?} {}", over(point));
            }
        }
    }
}

#[test]
fn culling_is_worth_its_while() {
    let world = HyperbolicWorld::new(60.305);
    let (mut all, mut kept, mut wasted) = (0, 0, 0);
    for heading in 0..8 {
        let at = ChartPoint::a(DVec3::new(5.0, 9.0, 3.0));
        let eye = looking(at, [f64::from(heading) * 0.8, -0.2, 0.0]);
        let frustum = world.frustum(&eye, &projection());
        for number in 0..257 {
            let chart = ChartId::new(number);
            for (x, y, z) in [
                (0, 0, 0),
                (-1, 0, 0),
                (0, 0, -1),
                (-1, 0, -1),
                (0, -1, 0),
                (-1, -1, -1),
            ] {
                let min = DVec3::new(f64::from(x), f64::from(y), f64::from(z)) * 32.0;
                let max = min + 32.0;
                all += 1;
                if frustum.cell_seen(&world, &eye, chart, min, max).is_some() {
                    kept += 1;
                    let any = samples(min, max, 6)
                        .any(|pos| shown(&world, &eye, ChartPoint::new(chart, pos)));
                    wasted += u32::from(!any);
                }
            }
        }
    }
    println!("{kept} of {all} kept, {wasted} of them for nothing");
    assert!(f64::from(kept) < 0.4 * f64::from(all) && f64::from(wasted) < 0.06 * f64::from(kept));
}
