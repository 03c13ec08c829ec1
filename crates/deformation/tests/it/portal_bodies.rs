//! Who walks, flies and rolls through portals.

use antipode_deformation::{Flyer, Place, Portal, Space, Triangles, Void, Walker, WalkerShape};
use antipode_testing::rooms;
use glam::{DQuat, DVec2, DVec3};

use crate::common::{portal, v};

const G: DVec3 = DVec3::new(0.0, -9.81, 0.0);

const SHAPE: WalkerShape = WalkerShape {
    radius_m: 0.35,
    height_m: 1.8,
    eye_m: 1.27,
    step_m: 0.4,
    steepest_rad: 0.87,
};

fn floor() -> Vec<antipode_deformation::Triangle> {
    rooms::cuboid(v(0.0, -0.5, 0.0), DQuat::IDENTITY, v(200.0, 0.5, 200.0), 0)
}

fn door(name: &str, at: DVec3, yaw_deg: f64, to: usize, height: f64) -> Portal {
    Portal {
        polygon: Portal::rectangle(DVec2::new(height / 2.0, height)),
        ..portal(name, at + DVec3::Y * height / 2.0, yaw_deg, to)
    }
}

fn standing(space: &Space, feet: DVec3) -> Walker {
    let mut walker = Walker::new(Place::at(space, feet + DVec3::Y * SHAPE.radius_m), SHAPE);
    walker.grounded = true;
    walker
}

/// Two doors on walls: one looks along +x, the other along +z.
fn on_walls() -> (Space, Triangles) {
    let doors = vec![
        door("one", DVec3::ZERO, 0.0, 1, 2.4),
        door("other", v(50.0, 0.0, 0.0), 90.0, 0, 2.4),
    ];
    let one = rooms::cuboid(v(-0.5, 2.0, 0.0), DQuat::IDENTITY, v(0.5, 2.0, 6.0), 1);
    let other = rooms::cuboid(v(50.0, 2.0, -0.5), DQuat::IDENTITY, v(6.0, 2.0, 0.5), 2);
    let scene = Triangles::new([floor(), one, other].concat());
    (Space::with_portals(Vec::new(), doors).unwrap(), scene)
}

#[test]
fn one_walks_through_a_door_on_a_wall_and_on_as_it_is_turned() {
    let (space, scene) = on_walls();
    for rate in [30, 60, 144, 1000] {
        let mut walker = standing(&space, v(3.0, 0.0, 0.2));
        let mut heading = DVec3::NEG_X;
        let (mut jump, mut before) = (0.0f64, walker.eye_place(&space, DVec3::Y));
        for _ in 0..2 * rate {
            walker.step(&space, &scene, heading * 3.0, G, 1.0 / f64::from(rate));
            heading = walker.turned() * heading;
            let eye = walker.eye_place(&space, DVec3::Y);
            if eye.passage == before.passage {
                jump = jump.max((eye.point - before.point).length() * f64::from(rate));
            }
            before = eye;
        }
        // Three metres before one, three behind the other, and as far to the side of its middle.
        let feet = walker.body.place.point - DVec3::Y * SHAPE.radius_m;
        assert!((feet - v(50.2, 0.0, 3.0)).length() < 1e-6, "{rate}: {feet}");
        assert!((heading - DVec3::Z).length() < 1e-9);
        assert!((walker.body.velocity - DVec3::Z * 3.0).length() < 1e-6);
        assert!(walker.grounded && jump < 3.01, "{rate}: {jump}");
    }
}

#[test]
fn a_wall_beside_a_door_stops_one() {
    let (space, scene) = on_walls();
    let mut walker = standing(&space, v(3.0, 0.0, 1.0));
    for _ in 0..120 {
        walker.step(&space, &scene, v(-3.0, 0.0, 0.0), G, 1.0 / 60.0);
    }
    // The door ends at 0.6: who is 0.35 thick and comes at 1.0 is before its wall.
    let x = walker.body.place.point.x;
    assert!((x - 0.35).abs() < 0.01, "{x}");
    assert_eq!(walker.body.place.passage.count, 0);
}

#[test]
fn behind_a_portal_twice_as_large_one_is_and_goes_twice_as_large() {
    let doors = vec![
        door("one", DVec3::ZERO, 0.0, 1, 2.4),
        door("other", v(50.0, 0.0, 0.0), 0.0, 0, 4.8),
    ];
    let space = Space::with_portals(Vec::new(), doors).unwrap();
    let scene = Triangles::new(floor());
    let mut walker = standing(&space, v(1.0, 0.0, 0.0));
    let mut heading = DVec3::NEG_X;
    for _ in 0..60 {
        walker.step(&space, &scene, heading * 3.0, G, 1.0 / 60.0);
        heading = walker.turned() * heading;
    }
    let place = walker.body.place;
    assert!((place.scale - 2.0).abs() < 1e-12);
    assert!(
        (place.point - v(54.0, 0.7, 0.0)).length() < 1e-3,
        "{}",
        place.point
    );
    let eye = walker.eye_place(&space, DVec3::Y).point;
    assert!((eye.y - 2.0 * 1.62).abs() < 1e-3, "{eye}");
    assert!((walker.body.velocity.length() - 3.0).abs() < 1e-6 && walker.grounded);
}

#[test]
fn who_falls_through_a_floor_comes_out_of_a_wall_and_the_eye_does_not_jump() {
    let mut hole = portal("hole", v(0.0, 0.0, 0.0), 0.0, 1);
    hole.turn = DQuat::from_rotation_z(90f64.to_radians());
    let wall = portal("wall", v(50.0, 20.0, 0.0), 0.0, 0);
    let space = Space::with_portals(Vec::new(), vec![hole, wall]).unwrap();
    let scene = Triangles::new(floor());
    let mut walker = Walker::new(Place::at(&space, v(0.0, 5.0, 0.0)), SHAPE);
    let mut before = walker.eye_place(&space, DVec3::Y);
    let mut turned = DQuat::IDENTITY;
    for _ in 0..90 {
        let has = walker.body.velocity.with_y(0.0);
        walker.step(&space, &scene, has, G, 1.0 / 60.0);
        turned = walker.turned() * turned;
        let eye = walker.eye_place(&space, DVec3::Y);
        if eye.passage.portal == before.passage.portal {
            let way = (eye.point - before.point).length();
            assert!(way < 15.0 / 60.0 + 0.2, "{way} {eye:?}");
        }
        before = eye;
    }
    let velocity = walker.body.velocity;
    // What fell 5 m flies out as fast, and falls again.
    assert!(
        (velocity.x - (2.0 * 9.81 * 5.0f64).sqrt()).abs() < 0.1,
        "{velocity}"
    );
    assert!(velocity.y < -1.0, "{velocity}");
    assert!((turned * DVec3::NEG_Y - DVec3::X).length() < 1e-9);
    let up = before.point - walker.body.place.point;
    assert!((up - DVec3::Y * SHAPE.eye_m).length() < 1e-6, "{up}");
}

#[test]
fn between_portals_energy_is_kept_and_at_them_speed() {
    let mut rng = fastrand::Rng::with_seed(3);
    for _ in 0..30 {
        let portals = rooms::portals(&mut rng, &[], 3, 2.0);
        let space = Space::with_portals(Vec::new(), portals).unwrap();
        let mut body = Flyer {
            place: Place::at(&space, rooms::point(&mut rng)),
            velocity: rooms::direction(&mut rng) * 5.0,
        };
        let energy = |it: &Flyer| {
            0.5 * it.velocity.length_squared() - G.dot(it.place.point) / it.place.scale
        };
        let mut before = (energy(&body), body.place.passage);
        for _ in 0..400 {
            let speed = body.velocity.length();
            body.fly(&space, &Void, G, 0.005);
            let now = (energy(&body), body.place.passage);
            if now.1 == before.1 {
                assert!((now.0 - before.0).abs() < 1e-9 * (1.0 + before.0.abs()));
            } else {
                assert!((body.velocity.length() - speed).abs() < 9.82 * 0.005 * 1.01);
            }
            before = now;
        }
    }
}
