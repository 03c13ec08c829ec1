//! Crates and balls that are thrown about at random in every room of the game: where they get to, and what they gain.

use antipode_room_scene::{LooseState, RoomScene, Steer};
use antipode_rooms::{Assets, What, poses, shipped};
use glam::DVec3;

use crate::room;
use crate::soak::Inside;

/// What is thrown about: a heap, and a ball that meets none of it.
const HEAP: usize = 6;
const RADIUS_M: f64 = 0.2;
/// Energy may rise by this share between crossings; and by this much, J/kg, where a blow is rounded.
const RISES: (f64, f64) = (0.01, 0.1);
/// For so long after it has crossed a face or portal a ball may be moved out of what it has grown into, seconds.
const SETTLES_S: f64 = 0.5;

fn add(scene: &mut RoomScene, words: &str) {
    let words: Vec<_> = words.split(' ').collect();
    scene.edit(&words, |_| Ok(Assets::default())).unwrap();
}

/// Energy of a ball for each kilogram of its own size.
fn energy(it: &LooseState, g: DVec3) -> f64 {
    let turns = 0.4 * RADIUS_M * RADIUS_M * it.spin.length_squared();
    0.5 * (it.velocity.length_squared() + turns) - g.dot(it.point) / it.place.scale
}

#[derive(Debug, Default)]
struct Found {
    crossings: u32,
    fastest: f64,
    deepest_m: f64,
    /// The most that energy rose, J/kg beyond what it may.
    rose: f64,
}

/// The middles of all that may be passed or entered in a room.
fn targets(scene: &RoomScene) -> Vec<DVec3> {
    let room = scene.room();
    let poses = poses(room);
    let is_way = |it: &What| matches!(it, What::Portal(_) | What::Aberration(_));
    let all = room.objects.iter().enumerate();
    let ways = all.filter(|(_, it)| is_way(&it.what));
    ways.map(|(index, _)| poses[index].translation).collect()
}

/// A velocity with which one gets to a place if nothing is in the way.
fn towards(from: DVec3, to: DVec3, g: DVec3, random: &mut fastrand::Rng) -> DVec3 {
    let way = to - from;
    let time = (way.length() / (5.0 + 9.0 * random.f64())).clamp(0.3, 2.0);
    way / time - 0.5 * g * time
}

fn somewhere(random: &mut fastrand::Rng, most: f64) -> DVec3 {
    let one = |random: &mut fastrand::Rng| 2.0 * random.f64() - 1.0;
    DVec3::new(one(random), 0.6 * random.f64(), one(random)) * most
}

fn throw_about(id: &str, with_heap: bool, seconds: u32, seed: u64) -> Found {
    let mut scene = room(id);
    let spawn = scene.room().spawn.at;
    let mut random = fastrand::Rng::with_seed(seed);
    let heap = if with_heap { HEAP } else { 0 };
    let names: Vec<_> = (0..=heap).map(|it| format!("thrown-{it}")).collect();
    for (number, name) in names.iter().enumerate() {
        let at = spawn + DVec3::new(0.0, 1.0 + 0.7 * number as f64, -0.8);
        let what = match number {
            0 => format!("ball name={name} radius={RADIUS_M}"),
            it if it % 3 == 0 => format!("cylinder name={name} radius=0.25 height=0.5"),
            _ => format!("box name={name} size=0.5,0.4,0.6"),
        };
        add(
            &mut scene,
            &format!("add {what} at={},{},{} mass=8", at.x, at.y, at.z),
        );
    }
    let g = scene.room().gravity;
    let inside = Inside::of(&scene);
    let targets = targets(&scene);
    let mut found = Found::default();
    let (mut kept, mut crossed, mut since) = (f64::INFINITY, (0, 0), 0.0);
    for step in 0..seconds * 60 {
        let throws = step % 90 == 0;
        if throws {
            for name in &names {
                let at = scene.loose_states().into_iter().find(|it| it.name == *name);
                let at = at.unwrap();
                let by = match random.choice(&targets) {
                    Some(to) if random.u8(0..4) > 0 => {
                        towards(at.point, *to, g, &mut random) - at.velocity
                    }
                    _ => somewhere(&mut random, 11.0),
                };
                assert!(scene.strike(name, by));
            }
        }
        scene.step(&Steer::default());
        found.deepest_m = found
            .deepest_m
            .max(inside.check(&scene, &format!("{id}, step {step}")));
        let states = scene.loose_states();
        for it in &states {
            let numbers = [it.velocity, it.spin, it.point];
            assert!(numbers.iter().all(|it| it.is_finite()), "{id}: {it:?}");
            found.fastest = found.fastest.max(it.velocity.length());
        }
        let ball = states.iter().find(|it| it.name == names[0]).unwrap();
        let where_it_is = (ball.place.passage.count, ball.place.stack.len());
        since += 1.0 / 60.0;
        if where_it_is != crossed || throws {
            found.crossings += u32::from(where_it_is != crossed);
            (crossed, since) = (where_it_is, 0.0);
        }
        let now = energy(ball, g);
        if since < SETTLES_S {
            kept = now;
        } else {
            let size = now.abs().max(0.5 * ball.velocity.length_squared());
            found.rose = found.rose.max(now - kept - RISES.0 * size - RISES.1);
            kept = kept.min(now);
        }
    }
    found
}

fn all_rooms(seconds: u32) {
    let mut crossings = 0;
    for (number, shipped) in shipped::ROOMS.iter().enumerate() {
        for with_heap in [false, true] {
            let found = throw_about(shipped.id, with_heap, seconds, 7 + number as u64);
            println!("{} {with_heap}: {found:?}", shipped.id);
            assert!(found.fastest < 60.1, "{}: {found:?}", shipped.id);
            assert!(with_heap || found.rose <= 0.0, "{}: {found:?}", shipped.id);
            crossings += found.crossings;
        }
    }
    assert!(
        crossings > seconds,
        "{crossings} crossings are too few to tell"
    );
}

#[test]
fn what_is_thrown_about_stays_in_the_room_and_gains_nothing() {
    all_rooms(8);
}

#[test]
#[ignore = "ten minutes of throwing take a while"]
fn ten_minutes_of_throwing_through_all_rooms() {
    all_rooms(40);
}
