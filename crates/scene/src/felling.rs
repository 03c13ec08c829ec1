//! What grows is felled here: by the tool in hand, or because the ground under it was dug away. What was felled is known, and
//! what of it a save has.

use std::collections::{BTreeMap, BTreeSet};

use antipode_geometry::{ChartPoint, ChunkCoord, Projection};
use antipode_items::Item;
use antipode_plants::{Age, Species, solid_of};
use antipode_storage::{FelledRecord, Record, RecordChanges, RecordKind};
use antipode_streaming::{Chunk, Column, Streamer, column_of};
use antipode_terrain::{Cover, FIRST_PLANTED, Thing};
use glam::{DVec2, DVec3, IVec3};

use crate::actions::Actions;
use crate::actors::Actors;
use crate::crosshair::Crosshair;
use crate::falling::Falling;
use crate::ground::chunks_near;
use crate::logs;
use crate::outbox::Outbox;
use crate::particles::Effect;
use crate::pick::over;
use crate::player::Player;
use crate::probe::PlantsProbe;
use crate::situation::Situation;
use crate::sound::SoundEvent;
use crate::step::Simulation;
use crate::tool;
use crate::tuning::{ASPECT, NEAR_M, REACH_M, STEP_S};
use crate::world::World;

/// How far from what is solid of a thing a tool may be to strike it, metres.
const STRIKES_M: f64 = 0.2;
/// No solid thing is farther from its middle line to its outside, metres.
const STOUTEST_M: f64 = 2.5;
/// What it takes to fell the thinnest thing, and more for each metre of its radius, as tools dig: seconds with a wooden pickaxe.
const TOUGHNESS: (f64, f64) = (0.6, 7.0);
/// How much more wood a tree has than its trunk, for its branches.
const BRANCHES: f64 = 1.4;
/// What is near in a probe, metres.
const PROBED_M: f64 = 30.0;

/// What was felled in a world, by columns of chunks: the number of the record, and a bit for each slot.
#[derive(Clone, Debug, Default)]
pub(crate) struct Felled {
    columns: BTreeMap<Column, (u32, u128)>,
    next: u32,
    /// What no save has been given yet, so that a save looks at no others.
    changed: BTreeSet<Column>,
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
        self.changed.insert(column);
    }

    /// Says that a save has a record of this number.
    pub fn has_numbered(&mut self, id: u32) {
        self.next = self.next.max(id);
    }

    /// What of it is to be saved, since it has changed since this was last asked.
    pub fn take_changes(&mut self) -> RecordChanges {
        let changed = std::mem::take(&mut self.changed).into_iter();
        let record = |column: Column| {
            let (id, slots) = self.columns.get(&column)?;
            let (chart, [x, z]) = column;
            let record = FelledRecord {
                chart: chart.number(),
                x,
                z,
                slots: [*slots as u64, (slots >> 64) as u64],
            };
            let key = RecordKind::Felled.numbered(*id);
            Some((key, Some(Record::Felled(record))))
        };
        changed.filter_map(record).collect()
    }

    /// Takes over what a save has, under its number.
    pub fn restore(&mut self, streamer: &Streamer, id: u32, column: Column, record: &FelledRecord) {
        let [low, high] = record.slots.map(u128::from);
        let slots = low | high << 64;
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
        let solid = solid_of(&self.thing)?;
        Some((solid.radius_m, solid.height_m))
    }

    /// How far its crown reaches about its root, and how high, metres.
    pub fn crown_m(&self) -> (f64, f64) {
        let scale = f64::from(self.thing.scale);
        (self.species.radius_m(self.age) * scale, self.height_m())
    }

    /// How high it stands, metres.
    pub fn height_m(&self) -> f64 {
        self.species.height_m(self.age) * f64::from(self.thing.scale)
    }

    /// What flies off it where it is struck.
    fn chips(&self, at: ChartPoint) -> Effect {
        let is_stone = self.species.is_stone();
        Effect::Chopped { at, is_stone }
    }

    /// The wood in it, cubic metres.
    pub fn wood_m3(&self) -> f64 {
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

/// What a script may ask of what grows.
pub(crate) fn probe(now: Situation<'_>, fov_y_rad: f64) -> Option<PlantsProbe> {
    let (world, feet) = (now.world, now.feet());
    if !world.setup.generator.has_things() && world.planted.count() == 0 {
        return None;
    }
    let mut near: BTreeMap<&'static str, usize> = BTreeMap::new();
    let mut planted_m: f64 = 0.0;
    for (it, _) in standing_near(world, feet, PROBED_M) {
        *near.entry(it.species.name()).or_default() += 1;
        if it.thing.slot >= FIRST_PLANTED && it.species.is_tree() {
            planted_m = planted_m.max(it.height_m());
        }
    }
    let ahead = Crosshair::aimed(now).ground(REACH_M);
    let ahead = ahead.hit.then(|| at(world, ahead.point)).flatten();
    Some(PlantsProbe {
        near,
        in_view: in_view(now, fov_y_rad),
        ahead: ahead.map(|it| it.species.name()),
        felled: world.felled.count(),
        planted: world.planted.count(),
        planted_m,
        falling: now.actors.count::<Falling>(),
    })
}

/// How many things stand where a picture shows their middle.
fn in_view(now: Situation<'_>, fov_y_rad: f64) -> usize {
    let params = now.aiming();
    let eye = now.head_through(&params);
    let projection = Projection::new(fov_y_rad, ASPECT, NEAR_M);
    let is_seen = |it: &Standing| {
        let middle = it.root().moved(DVec3::Y * 0.5 * it.height_m());
        let view = params.strategy.view_point(&eye, middle);
        let clip = params.strategy.clip_from_view(&eye, &projection, view);
        Projection::screen(clip).is_some_and(|at| at.abs().max_element() <= 1.0)
    };
    let shown = now.world.ground.land().meshes();
    let all = shown.flat_map(|(coord, mesh)| {
        let things = mesh.things.iter();
        things.filter_map(move |thing| Standing::of(coord, *thing))
    });
    all.filter(is_seen).count()
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

/// What stands within so many metres of a place, and its root as the place's chart has it.
pub(crate) fn standing_near(
    world: &World,
    place: ChartPoint,
    within_m: f64,
) -> Vec<(Standing, ChartPoint)> {
    let near = chunks_near(&*world.strategy, place, within_m).into_iter();
    let things = near.flat_map(|coord| {
        let things = world.ground.things(coord).iter();
        things.filter_map(move |thing| Standing::of(coord, *thing))
    });
    let there = things.map(|it| (it, over(&*world.strategy, place, it.root())));
    there
        .filter(|(_, root)| root.pos.distance(place.pos) <= within_m)
        .collect()
}

/// What is solid and has its root within so many metres of a place.
pub(crate) fn solids_near(world: &World, place: ChartPoint, within_m: f64) -> Vec<Standing> {
    let near = standing_near(world, place, within_m).into_iter();
    let solid = near.filter(|(it, _)| it.solid_m().is_some());
    solid.map(|(it, _)| it).collect()
}

/// What solid thing stands at a point, whichever chart it is of.
fn at(world: &World, point: ChartPoint) -> Option<Standing> {
    let images = world.strategy.images(point, STOUTEST_M).into_iter();
    let mut all = std::iter::once(point).chain(images.map(|it| it.point));
    all.find_map(|point| in_chart(world, point))
}

/// What solid thing of the chart of a point stands there.
fn in_chart(world: &World, point: ChartPoint) -> Option<Standing> {
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
    all.find(|it| it.is_at(point) && world.stands(it.coord, &it.thing))
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
    let strength = strength.and_then(Item::brush_strength_per_s);
    let struck_at = player.tool.map_or(it.root(), |mark| mark.point);
    if outbox.sounds.stroke_is_due(true, STEP_S) {
        let cover = if it.species.is_stone() {
            Cover::Rock
        } else {
            Cover::Soil
        };
        outbox.sounds.push(SoundEvent::Dug { cover });
        outbox.effects.push(it.chips(struck_at));
    }
    // A sign is there for whoever comes.
    if it.species == Species::CornerStone {
        return;
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
    strike_off(world, it.coord, &it.thing);
    come_down(world, actors, player, outbox, it, away);
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
            // Nobody can have it, and it is there again as soon as its ground is.
            if thing.species == Species::CornerStone.byte() {
                if let Some(it) = Standing::of(coord, thing) {
                    outbox.effects.push(it.chips(it.root()));
                }
                continue;
            }
            let stands = world.stands(coord, &thing);
            if thing.slot < FIRST_PLANTED {
                if stands {
                    strike_off(world, coord, &thing);
                }
            } else {
                // No stump is left without its ground.
                world.planted.uproot(coord, thing.slot);
                world.streamer.uproot(coord, thing.slot);
            }
            if let Some(it) = Standing::of(coord, thing).filter(|_| stands) {
                let down = world.ground.normal(it.root()).as_dvec3().with_y(0.0);
                come_down(world, actors, player, outbox, it, down);
            }
        }
    }
}

/// Notes that a thing was felled, here and with the chunk workers.
fn strike_off(world: &mut World, coord: ChunkCoord, thing: &Thing) {
    if thing.slot < FIRST_PLANTED {
        world.felled.add(column_of(coord), 1_u128 << thing.slot);
    } else {
        let now_s = world.simulated_s;
        world.planted.fell(coord, thing.slot, now_s);
    }
    world.streamer.fell(coord, thing.slot);
}

/// What was felled falls over, or to pieces.
fn come_down(
    world: &mut World,
    actors: &mut Actors,
    player: &mut Player,
    outbox: &mut Outbox,
    it: Standing,
    way: DVec3,
) {
    outbox.effects.push(it.chips(it.root()));
    if it.species.is_tree() {
        actors.enter(Falling::begin(it, way));
    } else if it.species.is_stone() {
        break_stone(world, actors, player, outbox, &it, way);
    }
}

/// A boulder or such falls to stones, away from the blow.
fn break_stone(
    world: &mut World,
    actors: &mut Actors,
    player: &mut Player,
    outbox: &mut Outbox,
    it: &Standing,
    way: DVec3,
) {
    let (radius_m, height_m) = it.solid_m().unwrap_or_default();
    let count = logs::pieces_in(Item::Stone, radius_m * radius_m * height_m * 2.0);
    let ahead = way.normalize_or(DVec3::X);
    let aside = ahead.cross(DVec3::Y);
    let piece = |_, share: f64| {
        let out = (ahead + aside * (4.0 * share - 2.0)).normalize();
        let point = it
            .root()
            .moved(out * 0.5 * radius_m + DVec3::Y * (0.5 * height_m + 0.2));
        (point, out * 1.5 + DVec3::Y, out.cross(DVec3::Y))
    };
    let left = logs::leave(actors, Item::Stone, count.max(1), piece);
    logs::take_in(world, player, outbox, Item::Stone, left);
}

#[cfg(test)]
mod tests;
