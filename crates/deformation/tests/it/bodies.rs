//! Bodies: what falls keeps its energy, and walkers end where they ought to.

use antipode_deformation::{
    Aberration, Flyer, Place, Sides, Space, Triangles, Void, Walker, WalkerShape, felt_gravity,
};
use antipode_testing::rooms;
use fastrand::Rng;
use glam::{DQuat, DVec3};

use crate::common::{boxed, space, v};

const G: DVec3 = DVec3::new(0.0, -9.81, 0.0);

fn energy(flyer: &Flyer) -> f64 {
    0.5 * flyer.velocity.length_squared() - G.dot(flyer.place.point)
}

#[test]
fn what_flies_through_boxes_keeps_its_energy() {
    let mut rng = Rng::with_seed(13);
    for _ in 0..20 {
        let space = space(rooms::aberrations(&mut rng, 3, 4.0, |_| Sides::Soft));
        let mut flyer = Flyer {
            place: Place::at(&space, rooms::point(&mut rng)),
            velocity: rooms::direction(&mut rng) * 12.0,
        };
        let before = energy(&flyer);
        for _ in 0..120 {
            flyer.fly(&space, &Void, G, 1.0 / 60.0);
        }
        let gain = energy(&flyer) - before;
        assert!(gain.abs() < 1e-9 * before.abs().max(100.0), "{gain} J/kg");
    }
}

#[test]
fn a_loop_through_a_tall_box_gains_nothing() {
    let tall = boxed(
        "tall",
        v(0.0, 5.0, 0.0),
        v(2.0, 5.0, 2.0),
        v(1.0, 2.0, 1.0),
        Sides::Soft,
    );
    let space = space([tall]);
    let floor = Triangles::new(rooms::cuboid(
        v(0.0, -1.0, 0.0),
        DQuat::IDENTITY,
        v(99.0, 1.0, 99.0),
        0,
    ));
    // Ten bounces in the box; outside it falls as before.
    let mut flyer = Flyer {
        place: Place::at(&space, v(0.0, 12.0, 0.0)),
        velocity: DVec3::ZERO,
    };
    let before = energy(&flyer);
    let mut bounces = 0;
    for _ in 0..3000 {
        let mut left = 1.0 / 60.0;
        while let Some((hit, rest)) = flyer.fly(&space, &floor, G, left) {
            let n = hit.felt_normal;
            flyer.velocity -= 2.0 * flyer.velocity.dot(n) * n;
            flyer.place.point += hit.normal * 1e-9;
            left = rest;
            bounces += 1;
            if rest <= 0.0 {
                break;
            }
        }
    }
    assert!(bounces > 5, "{bounces}");
    assert!(
        (energy(&flyer) - before).abs() < 1e-4,
        "{} J/kg",
        energy(&flyer) - before
    );
    // A felt g that is the same everywhere would have gained g (10 m felt as 20 - 10) on the way down.
    let k = space.squeeze(
        &space.stack_at(v(0.0, 5.0, 0.0)),
        DVec3::Y,
        &antipode_deformation::Traveller::Body,
    );
    assert_eq!(felt_gravity(k, G), G * 0.5);
}

fn house() -> (Space, Triangles) {
    let tunnel = Aberration::tunnel(v(0.0, 2.0, 0.0), DQuat::IDENTITY, v(2.0, 2.0, 5.0), 2, 20.0);
    let tall = boxed(
        "tall",
        v(0.0, 2.5, 11.0),
        v(3.0, 2.5, 4.0),
        v(1.0, 2.0, 1.0),
        Sides::Soft,
    );
    let mut solids = rooms::cuboid(v(0.0, -1.0, 0.0), DQuat::IDENTITY, v(40.0, 1.0, 40.0), 0);
    solids.extend(rooms::cuboid(
        v(1.5, 0.5, -9.0),
        DQuat::from_rotation_y(0.4),
        v(0.5, 0.5, 0.5),
        1,
    ));
    (space([tunnel, tall]), Triangles::new(solids))
}

const SHAPE: WalkerShape = WalkerShape {
    radius_m: 0.4,
    height_m: 1.8,
    eye_m: 1.2,
    step_m: 0.4,
    steepest_rad: 0.87,
};

fn walk(rate: u32, seconds: u32, wish: DVec3) -> Walker {
    let (space, scene) = house();
    let mut walker = Walker::new(Place::at(&space, v(0.3, 1.5, -12.0)), SHAPE);
    for _ in 0..rate * seconds {
        walker.step(&space, &scene, wish, G, 1.0 / f64::from(rate));
    }
    walker
}

#[test]
fn a_walker_ends_in_one_place_at_any_rate() {
    for wish in [v(0.0, 0.0, 3.0), v(0.35, 0.0, 4.0)] {
        let places = [30, 60, 144, 1000].map(|rate| walk(rate, 9, wish).body.place.point);
        for place in &places {
            assert!((*place - places[3]).length() < 0.01, "{places:?}");
        }
        assert!(places[0].z > 0.0, "{places:?}");
    }
}

#[test]
fn a_tunnel_is_walked_through_in_its_felt_time() {
    // 7 m to the door at 3 m/s, and then 20 m that are felt in 10 m of the scene.
    let walker = walk(60, 4, v(0.0, 0.0, 3.0));
    assert!(
        (walker.body.place.point.z - (-5.0 + 5.0 / 2.0)).abs() < 0.1,
        "{walker:?}"
    );
    assert!(walker.grounded);
    assert!((walker.body.place.point.y - 0.4).abs() < 0.01);
}

#[test]
fn walls_of_tunnels_and_solids_hold_a_walker() {
    let (space, scene) = house();
    let mut rng = Rng::with_seed(14);
    let mut walker = Walker::new(Place::at(&space, v(0.0, 0.5, 0.0)), SHAPE);
    let mut wish = DVec3::ZERO;
    for step in 0..6000 {
        if step % 60 == 0 {
            let way = rooms::direction(&mut rng);
            wish = v(way.x, 0.0, way.z) * 6.0;
            if walker.grounded && rng.bool() {
                walker.body.velocity.y = 5.0;
                walker.grounded = false;
            }
        }
        let before = walker.body.place;
        walker.step(&space, &scene, wish, G, 1.0 / 60.0);
        let now = walker.body.place;
        assert!(now.point.is_finite() && now.point.y > 0.35 / 2.0, "{now:?}");
        // Only a door leads into a tunnel or out of it.
        if before.stack.contains(0) != now.stack.contains(0) {
            assert!(
                (now.point.z.abs() - 5.0).abs() < 0.2 && now.point.x.abs() < 2.0,
                "{now:?}"
            );
        }
        walker.body.place.point.z = walker.body.place.point.z.clamp(-38.0, 38.0);
        walker.body.place.point.x = walker.body.place.point.x.clamp(-38.0, 38.0);
        walker.body.place = Place::at(&space, walker.body.place.point);
    }
}

#[test]
fn the_eye_of_a_walker_glides_where_a_box_is_stretched_upwards() {
    let (space, scene) = house();
    let mut walker = Walker::new(Place::at(&space, v(0.0, 0.5, 5.5)), SHAPE);
    let up = DVec3::Y;
    let (mut jump, mut before) = (0.0_f64, walker.eye_place(&space, up).point.y);
    for _ in 0..120 {
        walker.step(&space, &scene, v(0.0, 0.0, 2.0), G, 1.0 / 60.0);
        let now = walker.eye_place(&space, up).point.y;
        jump = jump.max((now - before).abs());
        before = now;
    }
    assert!(walker.body.place.stack.contains(1), "{walker:?}");
    assert!((walker.eye.height_m() - 1.2).abs() < 1e-6);
    // The eye comes down from 1.6 m to 0.8 m in half a second: 0.04 m a frame at the most.
    assert!((before - 0.8).abs() < 0.02, "{before}");
    assert!(jump < 0.06, "{jump}");
}
