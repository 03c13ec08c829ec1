//! What grows is felled here: by the tool in hand, or because the ground under it was dug away. A tree falls about its root,
//! strikes whom it meets, and leaves its wood to who gathers.

use std::collections::BTreeMap;
use std::f64::consts::FRAC_PI_2;

use antipode_geometry::{ChartPoint, ChunkCoord};
use antipode_plants::{Age, Species};
use antipode_storage::{FelledRecord, Record, RecordKind};
use antipode_streaming::{Chunk, Column, Streamer, column_of};
use antipode_terrain::{Cover, Kind, Stock, Thing};
use glam::{DQuat, DVec2, DVec3, IVec3};
use hecs::Entity;

use crate::actions::Actions;
use crate::actors::{ActorId, Actors, all_mut};
use crate::bot::Bot;
use crate::crosshair::Crosshair;
use crate::damage::{DamageKind, hurt_bot, hurt_player};
use crate::frame::FallingThing;
use crate::ground::chunks_near;
use crate::outbox::Outbox;
use crate::particles::Effect;
use crate::persist::All;
use crate::pick::over;
use crate::player::{Health, Player, Position};
use crate::probe::PlantsProbe;
use crate::situation::Situation;
use crate::sound::SoundEvent;
use crate::step::Simulation;
use crate::tool;
use crate::tuning::{REACH_M, STEP_S};
use crate::world::World;

/// Gravity in the falling of a tree, m/s2.
const GRAVITY_M_S2: f64 = 9.81;
/// How far from what is solid of a thing a tool may be to strike it, metres.
const STRIKES_M: f64 = 0.2;
/// What it takes to fell the thinnest thing, and more for each metre of its radius, as tools dig: seconds with a wooden pickaxe.
const TOUGHNESS: (f64, f64) = (0.6, 7.0);
/// How much more wood a tree has than its trunk, for its branches.
const BRANCHES: f64 = 1.4;
/// What is near in a probe, metres.
const NEAR_M: f64 = 30.0;
/// How far a tree leans when it begins to fall, radians, and how fast it tilts then, radians a second.
const FIRST_LEAN_RAD: f64 = 0.04;
const FIRST_RATE: f64 = 0.25;
/// It lies at the latest when it hangs down so far, radians.
const LAST_LEAN_RAD: f64 = 0.9 * std::f64::consts::PI;
/// Where along its height a tree meets the ground, as shares.
const MEETS_AT: [f64; 3] = [0.45, 0.7, 0.95];
/// Whom a trunk strikes as it comes down: so far to either side of it besides its radius, and so much at least over the ground, metres.
const STRUCK_M: f64 = 0.6;
/// What that takes of somebody's health, for each metre of the tree's height.
const DAMAGE_PER_M: f64 = 1.6;

/// What was felled in a world, by columns of chunks: the number of the record, and a bit for each slot.
#[derive(Clone, Debug, Default)]
pub(crate) struct Felled {
    columns: BTreeMap<Column, (u32, u128)>,
    next: u32,
}

impl Felled {
    /// Whether a thing was felled.
    pub fn has(&self, coord: ChunkCoord, slot: u8) -> bool {
        let found = self.columns.get(&column_of(coord));
        found.is_some_and(|(_, slots)| slots.unbounded_shr(slot.into()) & 1 == 1)
    }

    /// How many things were.
    pub fn count(&self) -> u32 {
        self.columns
            .values()
            .map(|(_, slots)| slots.count_ones())
            .sum()
    }

    fn add(&mut self, column: Column, slots: u128) {
        let next = &mut self.next;
        let (_, all) = self.columns.entry(column).or_insert_with(|| {
            *next += 1;
            (*next, 0)
        });
        *all |= slots;
    }

    /// What a save has of it. What still falls stands there again: its wood has not been had yet.
    pub fn records(&self, actors: &Actors, all: &mut All) {
        let falling = actors.map(|_, it: &Falling| {
            let Standing { coord, thing, .. } = it.standing;
            (column_of(coord), 1_u128.unbounded_shl(thing.slot.into()))
        });
        let landed = self.columns.iter().filter_map(|(column, (id, slots))| {
            let falls = falling.iter().filter(|(of, _)| of == column);
            let slots = falls.fold(*slots, |slots, (_, slot)| slots & !slot);
            (slots != 0).then_some((column, (id, slots)))
        });
        all.extend(landed.map(|((chart, [x, z]), (id, slots))| {
            let record = FelledRecord {
                chart: chart.number(),
                x: *x,
                z: *z,
                slots: [slots as u64, (slots >> 64) as u64],
            };
            (RecordKind::Felled.numbered(*id), Record::Felled(record))
        }));
    }

    /// Takes over what a save has, under its number.
    pub fn restore(&mut self, streamer: &Streamer, id: u32, column: Column, record: &FelledRecord) {
        let [low, high] = record.slots.map(u128::from);
        let slots = low | high << 64;
        self.next = self.next.max(id);
        self.columns.entry(column).or_insert((id, 0)).1 |= slots;
        streamer.remember_felled(column, slots);
    }
}

/// A thing where it stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Standing {
    pub coord: ChunkCoord,
    pub thing: Thing,
    pub species: Species,
    pub age: Age,
}

impl Standing {
    fn of(coord: ChunkCoord, thing: Thing) -> Option<Self> {
        Some(Self {
            coord,
            thing,
            species: Species::of_byte(thing.species)?,
            age: Age::of_byte(thing.age)?,
        })
    }

    /// Its root, in the chart.
    pub fn root(&self) -> ChartPoint {
        let root = self.coord.origin() + self.thing.root.as_dvec3();
        ChartPoint::new(self.coord.chart, root)
    }

    /// What of it is solid: radius and height, metres.
    pub fn solid_m(&self) -> Option<(f64, f64)> {
        let (trunk, scale) = (self.species.trunk(self.age)?, f64::from(self.thing.scale));
        Some((trunk.radius_m * scale, trunk.height_m * scale))
    }

    /// The wood in it, cubic metres.
    fn wood_m3(&self) -> f64 {
        let volume = |(radius_m, height_m): (f64, f64)| {
            std::f64::consts::PI * radius_m * radius_m * height_m * BRANCHES
        };
        let is_tree = self.species.is_tree();
        self.solid_m().filter(|_| is_tree).map_or(0.0, volume)
    }

    /// Whether a point lies on what is solid of it.
    fn is_at(&self, point: ChartPoint) -> bool {
        let Some((radius_m, height_m)) = self.solid_m() else {
            return false;
        };
        let from = point.pos - self.root().pos;
        let is_beside = DVec2::new(from.x, from.z).length() <= radius_m + STRIKES_M;
        is_beside && (-STRIKES_M..=height_m + STRIKES_M).contains(&from.y)
    }
}

/// A tool at work on a thing: which, and how much of what it takes is done.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Chop {
    coord: ChunkCoord,
    slot: u8,
    done: f64,
}

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
    fn turn(&self) -> DQuat {
        DQuat::from_axis_angle(DVec3::Y.cross(self.way), self.lean_rad)
    }

    /// A place so far up its trunk.
    fn at(&self, up_m: f64) -> ChartPoint {
        self.standing.root().moved(self.turn() * DVec3::Y * up_m)
    }

    fn height_m(&self) -> f64 {
        self.standing.species.height_m(self.standing.age) * f64::from(self.standing.thing.scale)
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

/// What falls at the moment.
pub(crate) fn shown(actors: &Actors) -> Vec<FallingThing> {
    actors.map(|_, it: &Falling| it.shown())
}

/// What a script may ask of what grows.
pub(crate) fn probe(now: Situation<'_>) -> Option<PlantsProbe> {
    let (world, feet) = (now.world, now.feet());
    if !world.setup.generator.has_things() {
        return None;
    }
    let mut near: BTreeMap<&'static str, usize> = BTreeMap::new();
    for coord in chunks_near(&*world.strategy, feet, NEAR_M) {
        let things = world.ground.things(coord).iter();
        for it in things.filter_map(|thing| Standing::of(coord, *thing)) {
            let there = over(&*world.strategy, feet, it.root());
            if there.pos.distance(feet.pos) <= NEAR_M {
                *near.entry(it.species.name()).or_default() += 1;
            }
        }
    }
    let ahead = Crosshair::aimed(now).ground(REACH_M);
    let ahead = ahead.hit.then(|| at(world, ahead.point)).flatten();
    Some(PlantsProbe {
        near,
        ahead: ahead.map(|it| it.species.name()),
        felled: world.felled.count(),
        falling: now.actors.count::<Falling>(),
    })
}

/// What a tool that digs strikes of what grows, if it was at it in the last step.
pub(crate) fn struck(now: Situation<'_>, actions: &Actions) -> Option<Standing> {
    let mark = now
        .player
        .tool
        .filter(|mark| actions.primary && mark.hits)?;
    tool::strength_in_hand(now)?;
    at(now.world, mark.point)
}

/// What is solid and has its root within so many metres of a place.
pub(crate) fn solids_near(world: &World, place: ChartPoint, within_m: f64) -> Vec<Standing> {
    let near = chunks_near(&*world.strategy, place, within_m).into_iter();
    let things = near.flat_map(|coord| {
        let things = world.ground.things(coord).iter();
        things.filter_map(move |thing| Standing::of(coord, *thing))
    });
    let is_near = |it: &Standing| {
        let root = over(&*world.strategy, place, it.root());
        it.solid_m().is_some() && root.pos.distance(place.pos) <= within_m
    };
    things.filter(is_near).collect()
}

/// What solid thing stands at a point.
fn at(world: &World, point: ChartPoint) -> Option<Standing> {
    let middle = ChunkCoord::containing(point);
    let near = (0..18).map(|n| IVec3::new(n % 3 - 1, -(n / 9), n / 3 % 3 - 1));
    let mut all = near.flat_map(|by| {
        let coord = ChunkCoord {
            index: middle.index.saturating_add(by),
            ..middle
        };
        let things = world.ground.things(coord).iter();
        things.filter_map(move |thing| Standing::of(coord, *thing))
    });
    all.find(|it| it.is_at(point) && !world.felled.has(it.coord, it.thing.slot))
}

/// A step of a tool's work on a thing.
pub(crate) fn chop(
    world: &mut World,
    actors: &mut Actors,
    player: &mut Player,
    outbox: &mut Outbox,
    it: Standing,
) {
    let strength = player.inventory.held();
    let strength = strength.and_then(antipode_items::Item::brush_strength_per_s);
    let struck_at = player.tool.map_or(it.root(), |mark| mark.point);
    if outbox.sounds.stroke_is_due(true, STEP_S) {
        outbox.sounds.push(SoundEvent::Dug { cover: Cover::Soil });
        outbox.effects.push(Effect::Chopped { at: struck_at });
    }
    let key = (it.coord, it.thing.slot);
    let done = player
        .chop
        .filter(|before| (before.coord, before.slot) == key);
    let done =
        done.map_or(0.0, |before| before.done) + f64::from(strength.unwrap_or_default()) * STEP_S;
    let (least, per_m) = TOUGHNESS;
    let radius_m = it.solid_m().map_or(0.0, |(radius_m, _)| radius_m);
    if done < least + per_m * radius_m {
        player.chop = Some(Chop {
            coord: it.coord,
            slot: it.thing.slot,
            done,
        });
        return;
    }
    player.chop = None;
    player.has_felled = true;
    let feet = over(&*world.strategy, it.root(), actors.feet());
    let away = (it.root().pos - feet.pos).with_y(0.0);
    fell(world, actors, player, outbox, it, away);
}

/// Takes in chunks that an edit has changed, and fells what the ground has gone from under.
pub(crate) fn put_edited(sim: &mut Simulation, chunks: Vec<Chunk>) {
    let Simulation {
        world,
        actors,
        player,
        outbox,
    } = sim;
    for chunk in chunks {
        for (coord, thing) in world.put(chunk) {
            let standing = Standing::of(coord, thing);
            if let Some(it) = standing.filter(|_| !world.felled.has(coord, thing.slot)) {
                let down = world.ground.normal(it.root()).as_dvec3().with_y(0.0);
                fell(world, actors, player, outbox, it, down);
            }
        }
    }
}

fn fell(
    world: &mut World,
    actors: &mut Actors,
    player: &mut Player,
    outbox: &mut Outbox,
    it: Standing,
    way: DVec3,
) {
    let slot = 1_u128.unbounded_shl(it.thing.slot.into());
    world.felled.add(column_of(it.coord), slot);
    world.streamer.fell(it.coord, it.thing.slot);
    outbox.effects.push(Effect::Chopped { at: it.root() });
    if it.species.is_tree() {
        actors.enter(Falling {
            standing: it,
            way: way.normalize_or(DVec3::X),
            lean_rad: FIRST_LEAN_RAD,
            rate: FIRST_RATE,
        });
    } else if it.species == Species::Boulder {
        let (radius_m, height_m) = it.solid_m().unwrap_or_default();
        gain(
            world,
            player,
            Kind::Rock,
            radius_m * radius_m * height_m * 2.0,
        );
    }
}

/// Gives who gathers what a thing was made of, and shows it as what a stroke brings.
fn gain(world: &mut World, player: &mut Player, kind: Kind, m3: f64) {
    let mut brought = Stock::default();
    brought.add(kind, m3);
    if world.streamer.spend(&brought.negative()) {
        player.presses += 1;
        let now_s = world.simulated_s;
        let nothing = antipode_terrain::Earth::default();
        player
            .earthworks
            .enter(player.presses, &nothing, &brought, now_s);
    }
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
        outbox.effects.push(Effect::Chopped { at });
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
    gain(world, player, Kind::Wood, it.standing.wood_m3());
}
