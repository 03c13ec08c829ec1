//! Crates and balls that are thrown about at random in every room of the game: where they get to, and what they gain.

use antipode_room_scene::{LooseState, RoomScene, Steer};
use antipode_rooms::{Assets, What, poses, shipped};
use glam::DVec3;

use crate::room;
use crate::soak::Inside;

/// What is thrown about: a heap, and a ball that meets none of it.
const HEAP: usize = 6;
const RADIUS_M: f64 = 0.2;
/// What is lower than this has fallen off the floor, metres.
const FELL_OFF_M: f64 = -0.5;
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

/// Energy of a heap, for each kilogram of its own: who is s times as large has s^3 times the mass and s times the speed, so that
/// m s^5 of theirs is what is passed on by blows.
fn energy_of_all(all: &[LooseState]) -> f64 {
    let mass: f64 = all.iter().map(|it| it.own_kg).sum();
    let of = |it: &LooseState| it.own_kg * it.place.scale.powi(5) * it.energy_j_kg;
    all.iter().map(of).sum::<f64>() / mass
}

/// What has risen that may only fall, while nothing crosses anything.
#[derive(Debug)]
struct Kept {
    energy: f64,
    crossed: Vec<(u32, usize)>,
    since_s: f64,
}

impl Kept {
    /// By how much energy has risen beyond what it may; whether something crossed a face or a portal.
    fn look(&mut self, states: &[LooseState], now: f64, thrown: bool) -> (f64, bool) {
        let crossed: Vec<_> = states
            .iter()
            .map(|it| (it.place.passage.count, it.place.stack.len()))
            .collect();
        let crosses = !self.crossed.is_empty() && crossed != self.crossed;
        self.since_s += 1.0 / 60.0;
        if crosses || thrown || self.crossed.is_empty() {
            (self.crossed, self.since_s) = (crossed, 0.0);
        }
        if self.since_s < SETTLES_S {
            self.energy = now;
            return (0.0, crosses);
        }
        let fastest = states.iter().map(|it| it.velocity.length_squared());
        let size = now.abs().max(0.5 * fastest.fold(0.0, f64::max));
        let rose = now - self.energy - RISES.0 * size - RISES.1;
        self.energy = self.energy.min(now);
        (rose, crosses)
    }
}

impl Default for Kept {
    fn default() -> Self {
        Self {
            energy: f64::INFINITY,
            crossed: Vec::new(),
            since_s: 0.0,
        }
    }
}

#[derive(Debug, Default)]
struct Found {
    crossings: u32,
    fastest: f64,
    deepest_m: f64,
    /// The most that energy of the ball that meets nothing of the heap rose, and that of all together, J/kg beyond what it may.
    rose: f64,
    heap_rose: f64,
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
    let (mut of_ball, mut of_all) = (Kept::default(), Kept::default());
    for step in 0..seconds * 60 {
        let throws = step % 90 == 0;
        if throws {
            for name in &names {
                let at = scene.loose_states().into_iter().find(|it| it.name == *name);
                let at = at.unwrap();
                if at.point.y < FELL_OFF_M {
                    // Thrown back from beyond the edge of the floor it would get under it.
                    continue;
                }
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
        let ball = std::slice::from_ref(ball);
        let (rose, crosses) = of_ball.look(ball, energy(&ball[0], g), throws);
        found.crossings += u32::from(crosses);
        found.rose = found.rose.max(rose);
        let (rose, _) = of_all.look(&states, energy_of_all(&states), throws);
        found.heap_rose = found.heap_rose.max(rose);
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
            assert!(found.heap_rose <= 0.0, "{}: {found:?}", shipped.id);
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
