//! Balls that are thrown bounce, roll, lie still, and gain nothing, in rooms made by chance too.
#![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

use antipode_deformation::{Aberration, Flyer, Place, Sides, Space, Triangle, Triangles, Ways};
use antipode_testing::rooms;
use fastrand::Rng;
use glam::{DQuat, DVec3};

use super::super::{Around, Bodies, Body};
use crate::tuning::THROWN;

const G: DVec3 = DVec3::new(0.0, -9.81, 0.0);

/// One ball in a space with solids.
struct Alone<'a> {
    around: Around<'a>,
    bodies: Bodies,
}

impl<'a> Alone<'a> {
    fn thrown(space: &'a Space, solids: &'a Triangles, from: Place, velocity: DVec3) -> Self {
        let mut bodies = Bodies::default();
        let flyer = Flyer {
            place: from,
            velocity,
        };
        bodies.throw(space, 1, flyer, 1);
        let around = Around {
            space,
            solids,
            g: G,
        };
        Self { around, bodies }
    }

    fn step(&mut self) -> &Body {
        self.bodies.step(&self.around);
        self.ball()
    }

    fn ball(&self) -> &Body {
        self.bodies.thrown().next().unwrap()
    }
}

fn floor() -> Vec<Triangle> {
    let half = DVec3::new(90.0, 1.0, 90.0);
    rooms::cuboid(DVec3::NEG_Y, DQuat::IDENTITY, half, 0)
}

#[test]
fn a_ball_bounces_as_high_as_it_may_and_lies_still_in_the_end() {
    let (space, solids) = (Space::default(), Triangles::new(floor()));
    let from = Place::at(&space, DVec3::new(0.0, 2.0 + THROWN.radius_m, 0.0));
    let mut alone = Alone::thrown(&space, &solids, from, DVec3::X);
    let (mut tops, mut rose) = (Vec::new(), false);
    for _ in 0..60 * 12 {
        let ball = alone.step();
        let rises = ball.velocity.y > 0.0;
        if rose && !rises {
            tops.push(ball.place.point.y - THROWN.radius_m);
        }
        rose = rises;
        // Rapier lets it in by what it goes in a part of a step.
        assert!(
            ball.place.point.y > 0.5 * THROWN.radius_m,
            "{}",
            ball.place.point
        );
    }
    // 0.6 of the speed is 0.36 of the height.
    assert!((tops[0] - 0.72).abs() < 0.03, "{tops:?}");
    assert!((tops[1] - 0.259).abs() < 0.03, "{tops:?}");
    let ball = alone.ball();
    assert!(
        ball.rests && ball.velocity == DVec3::ZERO,
        "{:?}",
        ball.place
    );
    assert!((ball.place.point.y - THROWN.radius_m).abs() < 2e-3);
    assert!((1.0..4.0).contains(&ball.place.point.x), "{:?}", ball.place);
    assert!(ball.turn.angle_between(DQuat::IDENTITY) > 0.1);
}

#[test]
fn a_ball_keeps_its_felt_size() {
    let large = Aberration {
        name: "large".to_owned(),
        centre: DVec3::new(0.0, 1.5, 0.0),
        turn: DQuat::IDENTITY,
        half: DVec3::new(4.0, 1.52, 4.0),
        stretch: DVec3::splat(4.0),
        sides: Sides::Soft,
        ways: Ways::Both,
    };
    let space = Space::new(vec![large]).unwrap();
    let solids = Triangles::new(floor());
    let from = Place::at(&space, DVec3::Y);
    let mut alone = Alone::thrown(&space, &solids, from, DVec3::ZERO);
    for _ in 0..60 * 20 {
        alone.step();
    }
    let ball = alone.ball();
    assert!(ball.rests, "{:?}", ball.place);
    let felt = THROWN.radius_m / 4.0;
    assert!((ball.place.point.y - felt).abs() < 1e-3, "{:?}", ball.place);
}

#[test]
fn a_ball_rolls_down_a_slope_and_stays_in_a_corner() {
    let space = Space::default();
    let mut all = floor();
    let turn = DQuat::from_rotation_x(-0.4);
    let slope = DVec3::new(4.0, 0.5, 4.0);
    all.extend(rooms::cuboid(DVec3::Z * 4.0, turn, slope, 1));
    let wall = (DVec3::new(0.0, 1.0, -6.0), DVec3::new(9.0, 1.0, 0.5));
    all.extend(rooms::cuboid(wall.0, DQuat::IDENTITY, wall.1, 2));
    let solids = Triangles::new(all);
    let from = Place::at(&space, DVec3::new(0.0, 3.0, 5.0));
    let mut alone = Alone::thrown(&space, &solids, from, DVec3::ZERO);
    for _ in 0..60 * 30 {
        let point = alone.step().place.point;
        assert!(point.y > 0.11 && point.z > -5.4, "{point}");
    }
    let ball = alone.ball();
    assert!(ball.rests && ball.place.point.z < 0.0, "{:?}", ball.place);
}

/// How deep a point is in one of the cuboids, metres; the room itself, number 0, is one that nothing leaves.
fn deepest(solids: &[Triangle], point: DVec3) -> f64 {
    let depths = solids.chunks(12).enumerate().map(|(number, sides)| {
        let depth = sides.iter().fold(f64::MAX, |least, side| {
            let [a, b, c] = side.corners;
            let n = (b - a).cross(c - a).normalize();
            least.min(n.dot(a - point))
        });
        if number == 0 { -depth } else { depth }
    });
    depths.fold(f64::MIN, f64::max)
}

#[test]
fn balls_lie_still_in_the_end_wherever_they_are_thrown() {
    let mut rng = Rng::with_seed(52);
    let (mut still, mut all) = (0, 0);
    for round in 0..12 {
        let sides = move |rng: &mut Rng| match round % 3 {
            0 => Sides::Soft,
            1 => [Sides::Soft, Sides::Walls][rng.usize(..2)],
            _ => [Sides::Soft, Sides::Snell][rng.usize(..2)],
        };
        let space = Space::new(rooms::aberrations(&mut rng, 3, 2.5, sides)).unwrap();
        let triangles = rooms::solids(&mut rng, 60);
        // Rapier has solids that face outward; the room, the first twelve, faces inward.
        let mut facing = triangles.clone();
        facing[..12].iter_mut().for_each(|it| it.corners.reverse());
        let solids = Triangles::new(facing);
        for _ in 0..5 {
            let from = loop {
                let point = rooms::point(&mut rng);
                if deepest(&triangles, point) < -0.8 {
                    break Place::at(&space, point);
                }
            };
            let velocity = rooms::direction(&mut rng) * 9.0;
            let mut alone = Alone::thrown(&space, &solids, from, velocity);
            let above = |ball: &Body| ball.energy(G) + 9.81 * rooms::HALF_M;
            let begun = above(alone.ball());
            for step in 0..60 * 30 {
                let ball = alone.step();
                let (now, has) = (ball.place.point, above(ball));
                let deep = deepest(&triangles, now);
                let at = format!("round {round}, step {step}, {now}");
                assert!(now.is_finite() && deep < 0.05, "{at}: {deep} m deep");
                assert!(has < begun * 1.01, "{at}: {has} of {begun} J/kg");
            }
            all += 1;
            still += u32::from(alone.ball().rests);
        }
    }
    assert!(still * 10 >= all * 9, "{still} of {all}");
}
