//! Who walks: steps, slopes, walls, ceilings, and faces of boxes.

use antipode_deformation::{
    Aberration, Place, Sides, Space, Triangle, Triangles, Walker, WalkerShape,
};
use antipode_testing::rooms::cuboid;
use fastrand::Rng;
use glam::{DQuat, DVec3};

use crate::common::{boxed, space, v};

const G: DVec3 = DVec3::new(0.0, -9.81, 0.0);
const SHAPE: WalkerShape = WalkerShape {
    radius_m: 0.35,
    height_m: 1.8,
    eye_m: 1.27,
    step_m: 0.4,
    steepest_rad: 50.0 * std::f64::consts::PI / 180.0,
};
const RATES: [u32; 4] = [30, 60, 144, 1000];

fn block(low: DVec3, high: DVec3) -> Vec<Triangle> {
    cuboid((low + high) / 2.0, DQuat::IDENTITY, (high - low) / 2.0, 1)
}

fn on_floor(more: impl IntoIterator<Item = Vec<Triangle>>) -> Triangles {
    let floor = block(v(-60.0, -1.0, -60.0), v(60.0, 0.0, 60.0));
    Triangles::new(more.into_iter().chain([floor]).flatten().collect())
}

/// A flight of stairs that rises along z from z = 0.
fn stairs(count: u32, run: f64, rise: f64) -> Vec<Triangle> {
    let step = |i: u32| {
        let (z, y) = (f64::from(i) * run, f64::from(i + 1) * rise);
        block(v(-2.0, 0.0, z), v(2.0, y, z + run))
    };
    (0..count).flat_map(step).collect()
}

struct Walk<'a> {
    space: &'a Space,
    scene: &'a Triangles,
    rate: u32,
    walker: Walker,
}

impl<'a> Walk<'a> {
    fn from(space: &'a Space, scene: &'a Triangles, rate: u32, feet: DVec3) -> Self {
        let middle = feet + DVec3::Y * SHAPE.radius_m;
        Self {
            space,
            scene,
            rate,
            walker: Walker::new(Place::at(space, middle), SHAPE),
        }
    }

    fn on(&mut self, wish: DVec3, seconds: f64) -> &mut Self {
        for _ in 0..(f64::from(self.rate) * seconds).round() as u32 {
            let time = 1.0 / f64::from(self.rate);
            self.walker.step(self.space, self.scene, wish, G, time);
            let now = self.walker.body.place.point;
            assert!(now.is_finite() && now.y > -0.1, "{now}");
        }
        self
    }

    fn feet(&self) -> DVec3 {
        self.walker.body.place.point - DVec3::Y * SHAPE.radius_m
    }
}

#[test]
fn steps_are_climbed_up_to_their_height_and_no_higher() {
    let none = space([]);
    for (rise, climbed) in [(0.18, true), (0.3, true), (0.4, true), (0.45, false)] {
        let scene = on_floor([stairs(8, 0.6, rise)]);
        let mut walk = Walk::from(&none, &scene, 60, v(0.0, 0.0, -2.0));
        walk.on(v(0.0, 0.0, 3.0), 2.2);
        let feet = walk.feet();
        if climbed {
            assert!((feet.y - 8.0 * rise).abs() < 0.01, "{rise}: {feet}");
            assert!((feet.z - 4.6).abs() < 0.1, "nobody is held up: {feet}");
        } else {
            assert!(feet.y < 0.01 && feet.z < 0.0, "{rise}: {feet}");
        }
    }
}

#[test]
fn stairs_are_followed_down_on_foot() {
    let none = space([]);
    let scene = on_floor([stairs(8, 0.6, 0.3)]);
    let mut walk = Walk::from(&none, &scene, 60, v(0.0, 2.41, 4.5));
    walk.on(DVec3::ZERO, 0.3);
    for _ in 0..110 {
        walk.on(v(0.0, 0.0, -3.0), 1.0 / 60.0);
        assert!(walk.walker.grounded, "{}", walk.feet());
    }
    assert!(walk.feet().y < 0.01, "{}", walk.feet());
}

#[test]
fn a_head_stops_at_a_lintel_and_a_ceiling() {
    let none = space([]);
    let beam = |height: f64| block(v(-3.0, height, 0.0), v(3.0, height + 0.4, 0.5));
    for (height, passes) in [(1.9, true), (1.7, false), (1.0, false), (0.5, false)] {
        let scene = on_floor([beam(height)]);
        let mut walk = Walk::from(&none, &scene, 60, v(0.0, 0.0, -2.0));
        walk.on(v(0.0, 0.0, 3.0), 2.0);
        assert_eq!(walk.feet().z > 1.0, passes, "{height}: {}", walk.feet());
        assert!(walk.feet().y.abs() < 0.01, "{height}: {}", walk.feet());
    }
    // A jump under a ceiling of 2 m ends there.
    let scene = on_floor([block(v(-5.0, 2.0, -5.0), v(5.0, 2.02, 5.0))]);
    let mut walk = Walk::from(&none, &scene, 60, v(0.0, 0.0, 0.0));
    walk.on(DVec3::ZERO, 0.1);
    walk.walker.body.velocity.y = 6.0;
    for _ in 0..60 {
        walk.on(DVec3::ZERO, 1.0 / 60.0);
        let eye = walk.walker.eye_place(&none, DVec3::Y).point.y;
        assert!(eye < 1.9 && walk.feet().y < 0.205, "{eye}");
    }
    assert!(walk.walker.grounded && walk.feet().y < 1e-3);
}

/// A ball that flies into who jumps pushes them out of its way: never through the floor, however thin that is.
#[test]
fn what_flies_into_who_jumps_pushes_nobody_through_a_floor() {
    let none = space([]);
    let mut rng = Rng::with_seed(5);
    let thin = || block(v(-60.0, -0.1, -60.0), v(60.0, 0.0, 60.0));
    let empty = Triangles::new(thin());
    for _ in 0..400 {
        let feet_m = 0.05 + 0.75 * rng.f64();
        let mut walk = Walk::from(&none, &empty, 60, v(0.0, feet_m, 0.0));
        walk.walker.grounded = false;
        walk.walker.body.velocity.y = 4.0 * (rng.f64() - 0.5);
        let mut ball = || {
            let mut aside = || 0.4 * (rng.f64() - 0.5);
            let (x, z) = (aside(), aside());
            let at = v(x, feet_m + 1.9 * rng.f64(), z);
            let turn = DQuat::from_scaled_axis(v(rng.f64(), rng.f64(), rng.f64()) * 6.0);
            Triangles::new(
                thin()
                    .into_iter()
                    .chain(cuboid(at, turn, DVec3::splat(0.12), 2))
                    .collect(),
            )
        };
        // Some fly by, and one stays.
        let mut balls = vec![ball(), ball()];
        balls.extend(vec![ball(); 30]);
        for scene in balls {
            let mut among = Walk {
                scene: &scene,
                walker: walk.walker.clone(),
                ..walk
            };
            among.on(DVec3::ZERO, 1.0 / 60.0);
            walk.walker = among.walker;
        }
        walk.on(DVec3::ZERO, 1.0);
        assert!(walk.walker.grounded && walk.feet().y.abs() < 0.01);
    }
}

#[test]
fn gentle_slopes_carry_and_steep_ones_do_not() {
    let none = space([]);
    for (degrees, carries) in [(20.0, true), (45.0, true), (55.0, false), (75.0, false)] {
        let angle = f64::to_radians(degrees);
        // A plate whose upper side rises along z from the origin.
        let turn = DQuat::from_rotation_x(-angle);
        let middle = turn * v(0.0, -0.5, 6.0);
        let scene = on_floor([cuboid(middle, turn, v(4.0, 0.5, 6.0), 1)]);
        let mut walk = Walk::from(&none, &scene, 60, v(0.0, 0.0, -2.0));
        walk.on(v(0.0, 0.0, 3.0), 2.5);
        let feet = walk.feet();
        if carries {
            assert!(feet.z > 4.0 && walk.walker.grounded, "{degrees}: {feet}");
            // Who stands there stays there.
            walk.on(DVec3::ZERO, 1.0);
            let stood = walk.feet();
            walk.on(DVec3::ZERO, 1.0);
            assert_eq!(walk.feet(), stood);
        } else {
            assert!(feet.y < 0.3, "{degrees}: {feet}");
        }
    }
}

#[test]
fn walls_are_slid_along_past_every_seam() {
    let none = space([]);
    // A wall of a hundred pieces side by side.
    let pieces = (0..100).map(|i| {
        let z = f64::from(i) * 0.13 - 3.0;
        block(v(1.0, 0.0, z), v(1.5, 3.0, z + 0.13))
    });
    let scene = on_floor(pieces);
    let mut walk = Walk::from(&none, &scene, 60, v(0.6, 0.0, -2.0));
    walk.on(v(2.0, 0.0, 3.0), 3.0);
    let feet = walk.feet();
    assert!((feet.z - 7.0).abs() < 0.05, "{feet}");
    assert!((feet.x - 0.65).abs() < 0.005, "{feet}");
    // A floor of plates is as good as one plate.
    let plates = (0..60).flat_map(|i| {
        (0..10).map(move |j| {
            let (x, z) = (f64::from(j) * 0.21 - 1.0, f64::from(i) * 0.17 - 3.0);
            block(v(x, -0.2, z), v(x + 0.21, 0.0, z + 0.17))
        })
    });
    let scene = Triangles::new(plates.flatten().collect());
    let mut walk = Walk::from(&none, &scene, 60, v(0.0, 0.0, -2.5));
    walk.on(v(0.05, 0.0, 3.0), 2.5);
    assert!(
        (walk.feet() - v(0.125, 0.0, 5.0)).length() < 0.02,
        "{}",
        walk.feet()
    );
}

fn course() -> (Space, Triangles) {
    let tunnel = Aberration::tunnel(
        v(0.0, 4.0, 14.0),
        DQuat::IDENTITY,
        v(2.0, 3.0, 4.0),
        2,
        20.0,
    );
    let hall = boxed(
        "hall",
        v(0.0, 4.5, 24.0),
        v(3.0, 3.0, 4.0),
        v(3.0, 2.0, 3.0),
        Sides::Soft,
    );
    let walls = [
        stairs(5, 0.6, 0.3),
        block(v(-4.0, 0.0, 3.0), v(4.0, 1.5, 40.0)),
        block(v(0.9, 1.5, 8.0), v(1.6, 4.0, 8.6)),
    ];
    (space([tunnel, hall]), on_floor(walls))
}

#[test]
fn stairs_walls_and_boxes_lead_to_one_place_at_any_rate() {
    let (space, scene) = course();
    for wish in [v(0.0, 0.0, 4.0), v(0.12, 0.0, 4.0), v(-0.1, 0.0, 7.0)] {
        let ends = RATES.map(|rate| {
            let mut walk = Walk::from(&space, &scene, rate, v(0.2, 0.0, -2.0));
            walk.on(wish, 9.0);
            walk.walker.body.place
        });
        assert!(ends[0].point.z > 15.0, "{ends:?}");
        for end in ends {
            assert!((end.point - ends[3].point).length() < 0.01, "{ends:?}");
        }
    }
}

#[test]
fn a_jump_leads_to_one_place_at_any_rate() {
    let (space, scene) = course();
    let ends = RATES.map(|rate| {
        let mut walk = Walk::from(&space, &scene, rate, v(0.2, 1.5, 7.0));
        walk.on(v(0.0, 0.0, 4.0), 0.5);
        walk.walker.body.velocity.y = 4.8;
        walk.walker.grounded = false;
        walk.on(v(0.0, 0.0, 4.0), 6.0);
        walk.walker.body.place.point
    });
    for end in ends {
        assert!((end - ends[3]).length() < 0.01, "{ends:?}");
    }
}

#[test]
fn who_enters_a_tall_box_keeps_their_feet_on_the_ground() {
    for tall in [2.0, 6.0, 20.0] {
        let stretch = v(1.0, tall, 1.0);
        let hall = boxed(
            "hall",
            v(0.0, 2.0, 4.0),
            v(3.0, 2.02, 4.0),
            stretch,
            Sides::Soft,
        );
        let (space, scene) = (space([hall]), on_floor([]));
        let mut walk = Walk::from(&space, &scene, 60, v(0.0, 0.0, -1.0));
        walk.on(DVec3::ZERO, 0.2);
        for _ in 0..80 {
            walk.on(v(0.0, 0.0, 3.0), 1.0 / 60.0);
            assert!(walk.walker.grounded, "{tall}: {:?}", walk.walker.body);
        }
        let place = &walk.walker.body.place;
        assert!(place.stack.contains(0), "{place:?}");
        // The middle of a ball of 0.35 felt metres is so many times less high in the scene.
        let height = place.point.y * tall;
        assert!((height - 0.35).abs() < 1e-3, "{tall}: {height}");
        // And back.
        for _ in 0..100 {
            walk.on(v(0.0, 0.0, -3.0), 1.0 / 60.0);
            assert!(walk.walker.grounded, "{tall}: {:?}", walk.walker.body);
        }
        assert!(walk.feet().z < -1.0 && walk.feet().y.abs() < 1e-3);
    }
}

#[test]
fn who_would_be_too_large_inside_stays_outside() {
    // A box in which one is four times as large, under a ceiling of 3 m.
    let small = boxed(
        "small",
        v(0.0, 1.4, 5.0),
        v(3.0, 1.5, 3.0),
        DVec3::splat(0.25),
        Sides::Soft,
    );
    let space = space([small]);
    let scene = on_floor([block(v(-4.0, 3.0, 1.0), v(4.0, 3.2, 9.0))]);
    let mut walk = Walk::from(&space, &scene, 60, v(0.0, 0.0, -1.0));
    walk.on(v(0.0, 0.0, 3.0), 3.0);
    let feet = walk.feet();
    assert!(feet.z < 2.01 && feet.y.abs() < 0.01, "{feet}");
    // And can go away again.
    walk.on(v(0.0, 0.0, -3.0), 1.0);
    assert!(walk.feet().z < -0.9, "{}", walk.feet());
}

#[test]
fn felt_speed_is_the_same_all_the_way_through_a_tunnel() {
    let (space, scene) = course();
    let mut walk = Walk::from(&space, &scene, 60, v(0.3, 1.5, 7.0));
    walk.on(DVec3::ZERO, 0.2);
    let (mut inside, mut last) = (0, walk.walker.body.place);
    for _ in 0..600 {
        walk.on(v(0.0, 0.0, 3.0), 1.0 / 60.0);
        let now = walk.walker.body.place;
        assert!((walk.walker.body.velocity - v(0.0, 0.0, 3.0)).length() < 1e-9);
        if now.stack.contains(0) && last.stack.contains(0) {
            inside += 1;
            // 8 m of the scene are felt as 20.
            let felt = (now.point - last.point).z * 2.5 * 60.0;
            assert!((felt - 3.0).abs() < 1e-6, "{felt}");
        }
        last = now;
    }
    assert!((395..405).contains(&inside), "20 m at 3 m/s: {inside}");
}

#[test]
fn between_steps_the_eye_goes_along_the_way() {
    let (space, scene) = course();
    let mut walk = Walk::from(&space, &scene, 60, v(0.2, 0.0, -2.0));
    walk.on(v(0.0, 0.0, 3.7), 0.2);
    let mut last = walk.walker.eye_place(&space, DVec3::Y);
    let mut inside = 0;
    for _ in 0..60 * 10 {
        walk.on(v(0.0, 0.0, 3.7), 1.0 / 60.0);
        for share in (0..=24).map(|part| f64::from(part) / 24.0) {
            let (eye, middle) = walk.walker.between(&space, DVec3::Y, share);
            // At most 4 m/s, and the rise of a step's edge.
            assert!(eye.point.distance(last.point) < 0.07, "{last:?} {eye:?}");
            for place in [&eye, &middle] {
                let asked = Place::at(&space, place.point);
                let is_on_face = |number: usize| {
                    let placed = &space.placed()[number];
                    let off = placed.local(place.point).abs() - placed.aberration.half;
                    off.abs().min_element() < 1e-9
                };
                let agrees = (0..2).all(|number| {
                    is_on_face(number)
                        || asked.stack.contains(number) == place.stack.contains(number)
                });
                assert!(agrees, "{place:?}");
            }
            last = eye;
        }
        let (eye, middle) = walk.walker.between(&space, DVec3::Y, 1.0);
        assert_eq!(eye, walk.walker.eye_place(&space, DVec3::Y));
        assert_eq!(middle, walk.walker.body.place);
        inside += u32::from(middle.stack.contains(0));
    }
    assert!(inside > 250 && last.stack.contains(1), "{inside} {last:?}");
}
