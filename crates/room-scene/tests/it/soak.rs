//! Somebody walks, jumps, shoots and throws at random through every room of the game.

use std::sync::Arc;

use antipode_deformation::SceneQuery as _;
use antipode_deformation::{Place, Sides, Space, Triangle, Triangles};
use antipode_room_scene::tuning::{LOST_BELOW_M, STEP_S};
use antipode_room_scene::{RoomScene, Steer, ThingKind};
use antipode_rooms::mesh::{Roundness, meshes};
use antipode_rooms::room::Object;
use antipode_rooms::{Assets, What, poses, shipped, space};
use fastrand::Rng;
use glam::DVec3;

use crate::room;

/// A centre may be so deep in a solid, metres.
const DEEPEST_M: f64 = 0.05;
/// Who wants to go and does not get farther than this in so many seconds has to turn round; who does not after
/// [`STUCK_S`] whatever they try is stuck.
const STAYS_M: f64 = 0.3;
const STUCK_S: f64 = 20.0;

/// How far beyond a face a body may be that is not said to have crossed it, metres.
const AT_FACE_M: f64 = 1e-4;
/// Who has left the land falls so far and as far aside at most, and nothing flies higher, metres.
const FALLS_M: (f64, f64, f64) = (LOST_BELOW_M + 2.0, 60.0, 210.0);

/// How far a place is from where its aberrations say that it is, metres: outside of one that it is in, or within one that it is not
/// in and that has walls, through which nobody gets.
fn strayed(space: &Space, place: &Place) -> f64 {
    let outside = |number: usize| {
        let it = &space.placed()[number].aberration;
        let local = it.turn.inverse() * (place.point - it.centre);
        (local.abs() - it.half).max_element()
    };
    let beyond = place.stack.iter().map(outside).fold(0.0, f64::max);
    let has_walls = |number: &usize| space.placed()[*number].aberration.sides == Sides::Walls;
    let is_in = |number: &usize| place.stack.iter().any(|it| it == *number);
    let others = (0..space.placed().len()).filter(|number| !is_in(number));
    let within = others.filter(has_walls).map(|number| -outside(number));
    within.fold(beyond, f64::max)
}

/// Solids of a room, to ask what is inside of them.
pub struct Inside {
    /// Of each object that is closed.
    objects: Vec<(String, Triangles, (DVec3, DVec3))>,
    /// All that stands in the room lies within.
    hull: (DVec3, DVec3),
    /// Its aberrations.
    space: Space,
}

impl Inside {
    pub fn of(scene: &RoomScene) -> Self {
        let room = scene.room();
        let mut objects = Vec::new();
        for mesh in meshes(room, &Assets::default(), Roundness::default()) {
            let object = &room.objects[mesh.object];
            if matches!(object.what, What::Aberration(_)) || object.mass.is_some() {
                continue;
            }
            let corner = |it: u32| {
                mesh.pose
                    .transform_point3(mesh.shape.positions[it as usize])
            };
            let triangles: Vec<_> = mesh
                .shape
                .triangles
                .iter()
                .map(|it| Triangle {
                    corners: it.map(corner),
                    object: 0,
                })
                .collect();
            let all = || triangles.iter().flat_map(|it| it.corners);
            let bounds = (
                all().fold(DVec3::INFINITY, DVec3::min),
                all().fold(DVec3::NEG_INFINITY, DVec3::max),
            );
            objects.push((object.name.clone(), Triangles::new(triangles), bounds));
        }
        let hull = objects.iter().fold(
            (DVec3::INFINITY, DVec3::NEG_INFINITY),
            |(low, high), (_, _, bounds)| (low.min(bounds.0), high.max(bounds.1)),
        );
        let space = space(room).unwrap();
        Self {
            objects,
            hull,
            space,
        }
    }

    /// Sees to it that no centre of a body is where none may be; how deep the deepest is in a solid, metres.
    pub fn check(&self, scene: &RoomScene, at: &str) -> f64 {
        let things = scene.things().into_iter();
        let things = things.filter(|it| it.kind != ThingKind::Mark);
        let things = things.map(|it| ("thing", it.place));
        let (feet, _) = scene.feet_between(1.0);
        let bodies = [("feet", feet), ("eye", scene.eye().place)];
        let loose = scene.loose_states().into_iter();
        let loose = loose.map(|it| ("loose", it.place));
        let mut deepest_m: f64 = 0.0;
        for (what, place) in things.chain(bodies).chain(loose) {
            let at = format!("{at}: {what} at {}", place.point);
            assert!(place.point.is_finite(), "{at}");
            let strayed_m = strayed(&self.space, &place);
            assert!(strayed_m < AT_FACE_M, "{at} is {strayed_m} m off its boxes");
            // At 60 m/s it goes 171 m aside before it has fallen as deep, and who has grown goes farther.
            let larger = match what {
                "loose" => 3.0 * place.scale.max(1.0),
                _ => 1.0,
            };
            self.check_hull(what, place.point, larger, &at);
            // The feet touch what they stand on.
            let middle = if what == "feet" {
                scene.middle()
            } else {
                place.point
            };
            let (depth, solid) = self.deepest(middle);
            assert!(depth <= DEEPEST_M, "{at} is {depth} m inside of {solid}");
            deepest_m = deepest_m.max(depth);
        }
        deepest_m
    }

    fn check_hull(&self, what: &str, point: DVec3, larger: f64, at: &str) {
        let (low, high) = self.hull;
        let over_floor = point.x > low.x && point.x < high.x && point.z > low.z && point.z < high.z;
        let is_over = point.y > low.y - AT_FACE_M;
        assert!(!over_floor || is_over, "{at} is under the floor");
        let (down, aside, up) = FALLS_M;
        let aside = aside * larger;
        let below = low - DVec3::new(aside, down, aside);
        let above = high + DVec3::new(aside, up, aside);
        let is_within = below.cmple(point).all() && point.cmple(above).all();
        // A bullet flies 200 m, and is gone.
        assert!(is_within || what == "thing", "{at} is out of the room");
    }

    /// How deep a point is in which solid, metres.
    fn deepest(&self, point: DVec3) -> (f64, &str) {
        let mut found = (0.0, "nothing");
        for (name, triangles, (low, high)) in &self.objects {
            let is_near = point.cmpge(*low).all() && point.cmple(*high).all();
            if is_near && is_inside(triangles, point) {
                let depth = depth(triangles, point);
                if depth > found.0 {
                    found = (depth, name.as_str());
                }
            }
        }
        found
    }
}

/// A ray from the inside of a closed solid leaves it an odd number of times; the way is chosen so as to meet no edge.
fn is_inside(triangles: &Triangles, point: DVec3) -> bool {
    let way = DVec3::new(0.618_034, 0.754_877, 0.213_413);
    let (mut from, mut times) = (point, 0);
    while let Some(hit) = triangles.first(from, way, 1e5) {
        from += way * (hit.time + 1e-7);
        times += 1;
    }
    times % 2 == 1
}

fn depth(triangles: &Triangles, point: DVec3) -> f64 {
    // A ball in which the nearest triangle lies, by its corners' distances to planes: thin solids are met soon.
    let ways = [
        DVec3::X,
        DVec3::NEG_X,
        DVec3::Y,
        DVec3::NEG_Y,
        DVec3::Z,
        DVec3::NEG_Z,
    ];
    let out = ways.map(|way| {
        triangles
            .first(point, way, 1e5)
            .map_or(f64::MAX, |it| it.time)
    });
    out.into_iter().fold(f64::MAX, f64::min)
}

#[derive(Debug, Default)]
struct Tally {
    walked_m: f64,
    crossings: usize,
    jumps: usize,
    shots: usize,
    hits: usize,
    throws: usize,
    anew: usize,
    deepest_m: f64,
    fell_s: f64,
    most_things: usize,
}

/// Straight on.
const AHEAD: Steer = Steer {
    forward: 1.0,
    strafe: 0.0,
    sprint: false,
    jump: false,
    look_yaw_rad: 0.0,
    look_pitch_rad: 0.0,
    shoot: false,
    place: false,
    throw: false,
    grasp: false,
};

/// Wants something else every now and then.
struct Player {
    rng: Rng,
    steer: Steer,
    until: usize,
}

impl Player {
    fn wants(&mut self, step: usize, tally: &mut Tally) -> Steer {
        let rng = &mut self.rng;
        if step >= self.until {
            self.until = step + rng.usize(10..150);
            self.steer = Steer {
                forward: [1.0, 1.0, 1.0, 0.0, -1.0][rng.usize(..5)],
                strafe: [0.0, 0.0, 1.0, -1.0][rng.usize(..4)],
                sprint: rng.u8(..3) == 0,
                look_yaw_rad: (rng.f64() - 0.5) * 0.06,
                look_pitch_rad: (rng.f64() - 0.5) * 0.01,
                ..Steer::default()
            };
        }
        let steer = Steer {
            jump: rng.u8(..40) == 0,
            shoot: rng.u8(..30) == 0,
            throw: rng.u8(..90) == 0,
            place: rng.u16(..400) == 0,
            ..self.steer
        };
        tally.jumps += usize::from(steer.jump);
        tally.shots += usize::from(steer.shoot);
        tally.throws += usize::from(steer.throw);
        steer
    }
}

/// Begins in turn at the middle of each aberration and before each portal, where there is a place, and where the room says. Whether it is
/// before a portal, which one faces.
fn begins(scene: &mut RoomScene, inside: &Inside, turn: usize) -> bool {
    let places = poses(scene.room());
    let spawn = scene.room().spawn.at;
    let of_object = |(index, object): (usize, &Arc<Object>)| {
        let place = &places[index];
        match object.what {
            What::Aberration(_) => Some((place.translation, None)),
            What::Portal(_) => {
                let before = place.transform_point3(DVec3::X * 0.8);
                let ahead = place.transform_vector3(DVec3::NEG_X);
                let yaw_deg = ahead.z.atan2(ahead.x).to_degrees();
                Some((DVec3::new(before.x, spawn.y, before.z), Some(yaw_deg)))
            }
            _ => None,
        }
    };
    let all = scene.room().objects.iter().enumerate();
    let begins: Vec<_> = all.filter_map(of_object).collect();
    let (at, yaw_deg) = match turn % (begins.len() + 1) {
        0 => (spawn, None),
        other => begins[other - 1],
    };
    let free = inside.deepest(at + DVec3::Y * 0.05).0 == 0.0;
    scene.teleport(if free { at } else { spawn }).unwrap();
    if let Some(yaw_deg) = yaw_deg {
        scene.aim(yaw_deg, 0.0);
    }
    free && yaw_deg.is_some()
}

fn play(id: &str, seconds: f64) -> Tally {
    let mut scene = room(id);
    let inside = Inside::of(&scene);
    let mut tally = Tally::default();
    let mut player = Player {
        rng: Rng::with_seed(id.bytes().map(u64::from).sum()),
        steer: Steer::default(),
        until: 0,
    };
    let (mut last, mut stayed) = (scene.feet(), (scene.feet(), 0.0));
    let mut last_eye = scene.eye().place;
    let mut hit = None;
    for step in 0..(seconds / STEP_S) as usize {
        if step % 600 == 0 {
            if begins(&mut scene, &inside, step / 600) {
                player.until = step + 90;
                player.steer = AHEAD;
            }
            last = scene.feet();
            stayed = (last, 0.0);
        }
        let steer = player.wants(step, &mut tally);
        scene.step(&steer);
        let (probe, feet) = (scene.probe(), scene.feet());
        let at = format!("{id}, {:.2} s", step as f64 * STEP_S);
        tally.deepest_m = tally.deepest_m.max(inside.check(&scene, &at));
        let eye = scene.eye().place;
        tally.most_things = tally.most_things.max(probe.things.len());
        tally.hits += usize::from(probe.hit != hit);
        hit = probe.hit;
        let is_elsewhere = eye.passage != last_eye.passage;
        if is_elsewhere {
            stayed = (feet, 0.0);
        } else if feet.distance(last) > 5.0 {
            tally.anew += 1;
            stayed = (feet, 0.0);
        } else {
            tally.walked_m += feet.distance(last);
        }
        last = feet;
        tally.crossings += usize::from(eye.stack != last_eye.stack || is_elsewhere);
        last_eye = eye;
        tally.fell_s += if probe.player.grounded { 0.0 } else { STEP_S };
        stayed.1 += STEP_S;
        if feet.distance(stayed.0) > STAYS_M * probe.scale {
            stayed = (feet, 0.0);
        }
        assert!(
            stayed.1 < STUCK_S,
            "{id}: stuck at {feet} after {step} steps"
        );
    }
    tally
}

fn play_all(seconds: f64) {
    for shipped in shipped::ROOMS {
        let tally = play(shipped.id, seconds);
        println!("{}: {tally:?}", shipped.id);
        assert!(tally.walked_m > seconds * 0.2, "{}: {tally:?}", shipped.id);
        assert!(
            tally.hits > 0 && tally.crossings > 0,
            "{}: {tally:?}",
            shipped.id
        );
    }
}

#[test]
fn nobody_leaves_the_room_or_gets_into_a_solid_or_stuck() {
    play_all(40.0);
}

#[test]
#[ignore = "ten minutes in each room take a while"]
fn ten_minutes_in_every_room() {
    play_all(600.0);
}
