//! Culling may waste, but never drop what is in the picture.

use std::sync::Arc;

use antipode_geometry::{
    ChartPoint, ChunkCoord, Eye, FAR_LIMIT_RADII, Geometry, Hemisphere, Projection, Raised,
    Strategy, strategy,
};
use glam::{DVec3, IVec3};
use proptest::prelude::{prop_assert, proptest};
use proptest::strategy::Strategy as _;

use crate::common::{cases, eye, in_space, projection, vector};

fn spaces() -> Vec<Arc<dyn Strategy>> {
    let mut spaces: Vec<Arc<dyn Strategy>> = [16.0, 32.0, 64.0]
        .map(|radius| strategy(Geometry::Spherical, radius))
        .to_vec();
    spaces.push(strategy(Geometry::Euclidean, 0.0));
    spaces.push(strategy(Geometry::Hyperbolic, 20.0));
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
    let near = space.geometry() != Geometry::Hyperbolic
        || space.eye_distance_m(view) <= FAR_LIMIT_RADII * space.radius_m();
    let clip = space.clip_from_view(&projection(), view);
    near && Projection::screen(clip).is_some_and(|at| at.abs().max_element() <= 1.0)
}

proptest! {
    #![proptest_config(cases(300))]

    #[test]
    fn spheres_hold_their_boxes_and_nothing_seen_is_culled(
        eye in eye(60.0), corner in vector(250.0), size in vector(40.0).prop_map(DVec3::abs),
        other in proptest::bool::ANY,
    ) {
        let frustum_eye = eye;
        for space in spaces() {
            let mut eye = frustum_eye;
            eye.point = in_space(space.as_ref(), eye.point);
            let sphere = space.geometry() == Geometry::Spherical;
            let hemisphere = if sphere && other { Hemisphere::B } else { Hemisphere::A };
            let min = if sphere {
                (corner * DVec3::new(0.2, 0.1, 0.2)).min(DVec3::splat(60.0))
            } else {
                eye.point.pos + corner
            };
            let max = min + size;
            let ball = space.bounding_sphere(&eye, hemisphere, min, max);
            let seen = space.frustum(&projection()).sees(&ball);
            for pos in samples(min, max, 7) {
                let point = ChartPoint::new(hemisphere, pos);
                let view = space.view_point(&eye, point);
                let reach = ball.reach_m(space.geometry(), space.radius_m(), view);
                prop_assert!(
                    reach <= ball.radius_m * (1.0 + 1e-9) + 1e-9,
                    "{:?} {reach} > {}", space.geometry(), ball.radius_m
                );
                prop_assert!(seen || !shown(space.as_ref(), &eye, point), "{:?}", space.geometry());
            }
        }
    }
}

/// Chunks around the eye: how many are kept, and how many of those show nothing.
fn kept_and_wasted(space: &dyn Strategy, eye: &Eye, around: i32) -> (u32, u32, u32) {
    let frustum = space.frustum(&projection());
    let home = ChunkCoord::containing(eye.point);
    let (mut all, mut kept, mut wasted) = (0, 0, 0);
    for x in -around..=around {
        for y in -1..=1 {
            for z in -around..=around {
                let chunk = home.offset(IVec3::new(x, y, z));
                all += 1;
                let ball = space.bounding_sphere(eye, chunk.hemisphere, chunk.min(), chunk.max());
                if frustum.sees(&ball) {
                    kept += 1;
                    let any = samples(chunk.min(), chunk.max(), 6)
                        .any(|pos| shown(space, eye, ChartPoint::new(chunk.hemisphere, pos)));
                    wasted += u32::from(!any);
                }
            }
        }
    }
    (all, kept, wasted)
}

#[test]
fn culling_is_worth_its_while() {
    for space in crate::common::spaces() {
        let (mut all, mut kept, mut wasted) = (0, 0, 0);
        for heading in 0..8 {
            let eye = Eye {
                point: ChartPoint::a(DVec3::new(5.0, 9.0, 3.0)),
                yaw: f64::from(heading) * 0.8,
                pitch: -0.2,
                dial: 10.0,
            };
            let around = if space.rim_m().is_some() { 1 } else { 6 };
            let counts = kept_and_wasted(space.as_ref(), &eye, around);
            all += counts.0;
            kept += counts.1;
            wasted += counts.2;
        }
        let geometry = space.geometry();
        println!("{geometry}: {kept} of {all} kept, {wasted} of them for nothing");
        let most = if geometry == Geometry::Spherical {
            0.8
        } else {
            0.55
        };
        assert!(
            f64::from(kept) < most * f64::from(all),
            "{geometry}: {kept} of {all}"
        );
        assert!(
            f64::from(wasted) < 0.5 * f64::from(kept),
            "{geometry}: {wasted} of {kept}"
        );
    }
}

#[test]
fn far_hyperbolic_chunks_are_not_drawn() {
    let space = Raised::new(20.0);
    let eye = Eye {
        dial: 10.0,
        ..Eye::default()
    };
    let frustum = space.frustum(&projection());
    let sees = |x: f64| {
        let min = DVec3::new(x, -5.0, -5.0);
        frustum.sees(&space.bounding_sphere(&eye, Hemisphere::A, min, min + 10.0))
    };
    assert!(sees(300.0));
    assert!(!sees(450.0));
    assert!(!sees(1e12));
}

#[test]
fn a_ball_as_wide_as_a_right_angle_is_always_kept() {
    let space = strategy(Geometry::Spherical, 16.0);
    let eye = Eye {
        point: ChartPoint::a(DVec3::Y * 5.0),
        pitch: 1.5,
        ..Eye::default()
    };
    let frustum = space.frustum(&projection());
    // Nearly a half turn: the sine of its radius is small again, and its middle is behind.
    let wide = space.bounding_sphere(&eye, Hemisphere::A, DVec3::splat(-28.0), DVec3::splat(28.0));
    assert!(wide.radius_m > std::f64::consts::FRAC_PI_2 * 16.0);
    assert!(frustum.sees(&wide));
    let behind = DVec3::new(0.0, 1.0, 0.0);
    let small = space.bounding_sphere(&eye, Hemisphere::A, behind, behind + 0.5);
    assert!(!frustum.sees(&small));
}
