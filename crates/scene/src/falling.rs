//! A tree on its way down: it turns about its root as a rod does, strikes whom it meets, and breaks into logs where it lies.

use std::f64::consts::FRAC_PI_2;

use antipode_geometry::ChartPoint;
use antipode_items::Item;
use antipode_plants::Age;
use antipode_terrain::{Cover, FIRST_PLANTED};
use glam::{DQuat, DVec3};
use hecs::Entity;

use crate::actors::{ActorId, Actors, all_mut};
use crate::bot::Bot;
use crate::damage::{DamageKind, hurt_bot, hurt_player};
use crate::drops::Drop;
use crate::felling::Standing;
use crate::frame::FallingThing;
use crate::ground::height_below;
use crate::inventory::Stack;
use crate::logs;
use crate::outbox::Outbox;
use crate::particles::Effect;
use crate::pick::over;
use crate::player::{Health, Player, Position};
use crate::sound::SoundEvent;
use crate::tuning::{DROP, STEP_S};
use crate::world::World;

/// Gravity in the falling of a tree, m/s2.
const GRAVITY_M_S2: f64 = 9.81;
/// How far a tree leans when it begins to fall, radians, and how fast it tilts then, radians a second.
const FIRST_LEAN_RAD: f64 = 0.04;
const FIRST_RATE: f64 = 0.25;
/// It lies at the latest when it hangs down so far, radians.
const LAST_LEAN_RAD: f64 = 0.9 * std::f64::consts::PI;
/// Where along its height a tree meets the ground, as shares.
const MEETS_AT: [f64; 3] = [0.45, 0.7, 0.95];
/// Whom a trunk strikes as it comes down: so far to either side of it besides its radius, and so much at least over the ground, metres.
const STRUCK_M: f64 = 0.6;
/// How far over the place where it lay a log begins to roll, metres.
const LOGS_UP_M: f64 = 0.3;
/// Where a save has what it breaks into: so far beside its root, on the ground below so much over that, so far down at most, metres.
const KEPT_ASIDE_M: f64 = 0.8;
const KEPT_FROM_M: f64 = 2.0;
const KEPT_TO_M: f64 = 8.0;
/// What that takes of somebody's health, for each metre of the tree's height.
const DAMAGE_PER_M: f64 = 1.6;

/// A tree on its way down.
#[derive(Clone, Debug)]
pub(crate) struct Falling {
    standing: Standing,
    /// The way it falls, a level unit vector of the chart.
    way: DVec3,
    lean_rad: f64,
    rate: f64,
}

impl Falling {
    /// One that begins to fall, along the level part of a way.
    pub fn begin(standing: Standing, way: DVec3) -> Self {
        Self {
            standing,
            way: way.with_y(0.0).normalize_or(DVec3::X),
            lean_rad: FIRST_LEAN_RAD,
            rate: FIRST_RATE,
        }
    }

    fn turn(&self) -> DQuat {
        DQuat::from_axis_angle(DVec3::Y.cross(self.way), self.lean_rad)
    }

    /// A place so far up its trunk.
    fn at(&self, up_m: f64) -> ChartPoint {
        self.standing.root().moved(self.turn() * DVec3::Y * up_m)
    }

    fn height_m(&self) -> f64 {
        self.standing.height_m()
    }

    /// How many logs and seeds it breaks into.
    fn leaves(&self) -> [u32; 2] {
        let least = u32::from(self.standing.solid_m().is_some());
        let logs = logs::pieces_in(Item::Log, self.standing.wood_m3()).max(least);
        let was_planted = self.standing.thing.slot >= FIRST_PLANTED;
        let seeds = match self.standing.age {
            // What it came from is not lost.
            Age::Young => u32::from(was_planted),
            Age::Grown => 1,
            Age::Old => 2,
        };
        [logs, seeds]
    }

    /// What a save has of it: what it breaks into, on the ground beside where it stood.
    pub fn kept(&self, world: &World) -> Vec<Drop> {
        let beside = self.standing.root().moved(self.way * KEPT_ASIDE_M);
        let crossing = world.strategy.cross(beside);
        let beside = crossing.map_or(beside, |it| it.point);
        let is_solid = |at: ChartPoint| world.ground.is_solid(at);
        let below = |at: ChartPoint| {
            let high = at.moved(DVec3::Y * KEPT_FROM_M);
            let low_y = height_below(high, KEPT_TO_M, is_solid).filter(|_| !is_solid(high))?;
            Some(ChartPoint::new(
                at.chart,
                at.pos.with_y(low_y + DROP.radius_m),
            ))
        };
        let root = self.standing.root();
        // Over an edge, or under one, it lies where it stood.
        let at = below(beside).or_else(|| below(root)).unwrap_or(root);
        let stacks = [Item::Log, Item::Seed].into_iter().zip(self.leaves());
        let stacks = stacks.filter(|(_, count)| *count > 0);
        let lying = stacks.map(|(item, count)| Drop::lying(Stack { item, count }, at));
        lying.collect()
    }

    /// As a picture has it.
    fn shown(&self) -> FallingThing {
        FallingThing {
            point: self.standing.root(),
            thing: self.standing.thing,
            turn: self.turn(),
        }
    }
}

/// What a save has of what falls at the moment: it lies there as logs.
pub(crate) fn kept(world: &World, actors: &Actors) -> Vec<Drop> {
    actors.map(|_, it: &Falling| it.kept(world)).concat()
}

/// What falls at the moment, as a picture has it.
pub(crate) fn shown(actors: &Actors) -> Vec<FallingThing> {
    actors.map(|_, it: &Falling| it.shown())
}

/// Lets what falls go on: a rod about its end, which gravity turns by `3 g sin(lean) / (2 length)` a second squared.
pub(crate) fn step(
    world: &mut World,
    actors: &mut Actors,
    player: &mut Player,
    outbox: &mut Outbox,
) {
    let mut landed: Vec<(ActorId, Falling)> = Vec::new();
    for (id, it) in all_mut::<Falling>(&mut actors.ecs) {
        it.rate += 1.5 * GRAVITY_M_S2 * it.lean_rad.sin() / it.height_m() * STEP_S;
        it.lean_rad += it.rate * STEP_S;
        let meets = |share: &f64| world.ground.is_solid(it.at(share * it.height_m()));
        let lies = it.lean_rad > 0.5 * FRAC_PI_2 && MEETS_AT.iter().any(meets);
        if lies || it.lean_rad > LAST_LEAN_RAD {
            landed.push((id, it.clone()));
        }
    }
    for (id, it) in landed {
        actors.remove::<Falling>(id);
        land(world, actors, player, outbox, &it);
    }
}

/// A tree comes down: it strikes whom it meets, and is broken into wood.
fn land(
    world: &mut World,
    actors: &mut Actors,
    player: &mut Player,
    outbox: &mut Outbox,
    it: &Falling,
) {
    let speed_m_s = it.rate * it.height_m();
    for share in [0.2, 0.45, 0.7, 0.95] {
        let at = it.at(share * it.height_m());
        outbox.effects.push(Effect::Landed { at, speed_m_s });
        let is_stone = false;
        outbox.effects.push(Effect::Chopped { at, is_stone });
    }
    let cover = Cover::Soil;
    outbox.sounds.push(SoundEvent::Landed { cover, speed_m_s });
    let (radius_m, _) = it.standing.solid_m().unwrap_or_default();
    let damage = DAMAGE_PER_M * it.height_m();
    let strategy = &*world.strategy;
    let is_under = |feet: ChartPoint| {
        let root = it.standing.root();
        let from = over(strategy, root, feet).pos - root.pos;
        let along_m = from.dot(it.way);
        let across_m = from.dot(it.way.cross(DVec3::Y)).abs();
        let trunk = it.turn() * DVec3::Y;
        let over_m = trunk.y / trunk.dot(it.way).max(0.1) * along_m - from.y;
        (0.5..it.height_m()).contains(&along_m)
            && across_m < radius_m + STRUCK_M
            && (-1.0..2.5).contains(&over_m)
    };
    let hit: Vec<Entity> = {
        let mut bots = actors.ecs.query::<(Entity, &Bot, &Position, &Health)>();
        let living = bots.iter().filter(|(.., health)| health.0 > 0.0);
        let under = living.filter(|(_, _, position, _)| is_under(position.0));
        under.map(|(entity, ..)| entity).collect()
    };
    let hits_player = is_under(actors.feet()) && !actors.cars.is_driving();
    for entity in hit {
        let by = Some(actors.player);
        hurt_bot(actors, entity, damage, by);
    }
    if hits_player {
        let from = Some(-it.way);
        hurt_player(actors, player, outbox, damage, DamageKind::Tree, from);
    }
    break_tree(world, actors, player, outbox, it);
}

/// A tree that has come down breaks: logs along its trunk, the faster the farther up, and the seeds of its crown.
fn break_tree(
    world: &mut World,
    actors: &mut Actors,
    player: &mut Player,
    outbox: &mut Outbox,
    it: &Falling,
) {
    let (_, trunk_m) = it.standing.solid_m().unwrap_or_default();
    let speed_m_s = it.rate * it.height_m();
    let aside = it.way.cross(DVec3::Y);
    let [count, seeds] = it.leaves();
    let log = |n: u32, share: f64| {
        let side = if n.is_multiple_of(2) { 1.0 } else { -1.0 };
        let velocity = aside * side * (0.5 + 0.12 * share * speed_m_s) + DVec3::Y;
        let point = it.at(share * trunk_m).moved(DVec3::Y * LOGS_UP_M);
        (point, velocity, it.way)
    };
    let left = logs::leave(actors, Item::Log, count, log);
    logs::take_in(world, player, outbox, Item::Log, left);
    let seed = |_, share: f64| {
        let point = it.at(0.8 * it.height_m()).moved(DVec3::Y * LOGS_UP_M);
        (point, aside * (2.0 * share - 0.7) + DVec3::Y, it.way)
    };
    let left = logs::leave(actors, Item::Seed, seeds, seed);
    logs::take_in(world, player, outbox, Item::Seed, left);
}
