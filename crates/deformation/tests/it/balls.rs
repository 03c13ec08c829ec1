//! Balls that are thrown: they bounce, roll, lie still, and gain nothing by any box.

use antipode_deformation::{Ball, BallShape, Place, Sides, Triangles};
use antipode_testing::rooms;
use fastrand::Rng;
use glam::{DQuat, DVec3};

use crate::common::{boxed, space, v};

const G: DVec3 = DVec3::new(0.0, -9.81, 0.0);
const SHAPE: BallShape = BallShape {
    radius_m: 0.12,
    bounce: 0.6,
    slide: 0.9,
    rolling_m_s2: 0.8,
};
/// One that loses nothing.
const SUPER: BallShape = BallShape {
    radius_m: 0.12,
    bounce: 1.0,
    slide: 1.0,
    rolling_m_s2: 0.0,
};

fn floor() -> Vec<antipode_deformation::Triangle> {
    rooms::cuboid(v(0.0, -1.0, 0.0), DQuat::IDENTITY, v(90.0, 1.0, 90.0), 0)
}

/// Above the ground, J/kg.
fn energy(ball: &Ball) -> f64 {
    0.5 * ball.body.velocity.length_squared() - G.dot(ball.body.place.point)
}

#[test]
fn a_ball_bounces_as_high_as_it_may_and_lies_still_in_the_end() {
    let (none, scene) = (space([]), Triangles::new(floor()));
    let start = Place::at(&none, v(0.0, 2.12, 0.0));
    let mut ball = Ball::thrown(start, v(1.0, 0.0, 0.0), SHAPE);
    let mut tops = Vec::new();
    let mut rose = false;
    for _ in 0..60 * 12 {
        ball.step(&none, &scene, G, 1.0 / 60.0);
        let rises = ball.body.velocity.y > 0.0;
        if rose && !rises {
            tops.push(ball.body.place.point.y - 0.12);
        }
        rose = rises;
        assert!(ball.body.place.point.y > 0.115, "{ball:?}");
    }
    // 0.6 of the speed is 0.36 of the height.
    assert!((tops[0] - 0.72).abs() < 0.02, "{tops:?}");
    assert!((tops[1] - 0.259).abs() < 0.02, "{tops:?}");
    assert!(
        ball.rests() && ball.body.velocity == DVec3::ZERO,
        "{ball:?}"
    );
    assert!((ball.body.place.point.y - 0.12).abs() < 1e-3, "{ball:?}");
    let rolled = ball.body.place.point.x;
    assert!((1.0..3.0).contains(&rolled), "{rolled}");
    assert!(ball.turn.angle_between(DQuat::IDENTITY) > 0.1);
}

#[test]
fn a_ball_gains_nothing_by_bouncing_through_boxes() {
    let tall = boxed(
        "tall",
        v(0.0, 5.0, 0.0),
        v(3.0, 5.02, 3.0),
        v(1.0, 2.0, 1.0),
        Sides::Soft,
    );
    let large = boxed(
        "large",
        v(7.0, 1.5, 0.0),
        v(2.0, 1.52, 9.0),
        DVec3::splat(3.0),
        Sides::Soft,
    );
    let small = boxed(
        "small",
        v(-7.0, 1.5, 0.0),
        v(2.0, 1.52, 9.0),
        DVec3::splat(0.5),
        Sides::Soft,
    );
    let space = space([tall, large, small]);
    let mut solids = floor();
    for (x, z) in [(-11.0, 0.0), (11.0, 0.0), (0.0, -9.0), (0.0, 9.0)] {
        let turn = DQuat::from_rotation_y(0.03 * x);
        let half = if x == 0.0 {
            v(12.0, 20.0, 0.2)
        } else {
            v(0.2, 20.0, 12.0)
        };
        solids.extend(rooms::cuboid(v(x, 10.0, z), turn, half, 1));
    }
    let scene = Triangles::new(solids);
    let mut rng = Rng::with_seed(31);
    let (mut most, mut crossings) = (0.0_f64, 0);
    for _ in 0..12 {
        let start = Place::at(
            &space,
            v(rng.f64() * 16.0 - 8.0, 3.0 + 4.0 * rng.f64(), 0.0),
        );
        let mut ball = Ball::thrown(start, rooms::direction(&mut rng) * 8.0, SUPER);
        let before = energy(&ball);
        for _ in 0..60 * 10 {
            let stack = ball.body.place.stack;
            ball.step(&space, &scene, G, 1.0 / 60.0);
            crossings += u32::from(stack != ball.body.place.stack);
            most = most.max(energy(&ball) / before - 1.0);
            assert!(ball.body.place.point.is_finite() && ball.body.place.point.y > 0.0);
        }
    }
    assert!(most < 0.01, "gained {most}");
    assert!(crossings > 80, "{crossings}");
}

#[test]
fn a_ball_keeps_its_felt_size() {
    let large = boxed(
        "large",
        v(0.0, 1.5, 0.0),
        v(4.0, 1.52, 4.0),
        DVec3::splat(4.0),
        Sides::Soft,
    );
    let space = space([large]);
    let scene = Triangles::new(floor());
    let start = Place::at(&space, v(0.0, 1.0, 0.0));
    let mut ball = Ball::thrown(start, DVec3::ZERO, SHAPE);
    for _ in 0..60 * 20 {
        ball.step(&space, &scene, G, 1.0 / 60.0);
    }
    assert!(ball.rests(), "{ball:?}");
    assert!((ball.body.place.point.y - 0.03).abs() < 1e-3, "{ball:?}");
}

#[test]
fn a_ball_rolls_down_a_slope_and_stays_in_a_corner() {
    let none = space([]);
    let mut solids = floor();
    let turn = DQuat::from_rotation_x(-0.4);
    solids.extend(rooms::cuboid(v(0.0, 0.0, 4.0), turn, v(4.0, 0.5, 4.0), 1));
    solids.extend(rooms::cuboid(
        v(0.0, 1.0, -6.0),
        DQuat::IDENTITY,
        v(9.0, 1.0, 0.5),
        2,
    ));
    let scene = Triangles::new(solids);
    let start = Place::at(&none, v(0.0, 3.0, 5.0));
    let mut ball = Ball::thrown(start, DVec3::ZERO, SHAPE);
    for _ in 0..60 * 30 {
        ball.step(&none, &scene, G, 1.0 / 60.0);
        let point = ball.body.place.point;
        assert!(point.y > 0.11 && point.z > -5.4, "{ball:?}");
    }
    assert!(ball.rests() && ball.body.place.point.z < 0.0, "{ball:?}");
}
