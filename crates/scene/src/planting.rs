//! Seeds, and what becomes of them: the hand puts one into soft ground, and it grows by the days of the world. What was planted
//! stands among what grew by itself, in slots of its own, and is felled like that.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use antipode_geometry::{CHUNK_CELLS, ChartPoint, ChunkCoord};
use antipode_items::Item;
use antipode_plants::{Age, Species, left_of, tree_at};
use antipode_storage::{PlaceRecord, PlantedRecord, Record, RecordKind};
use antipode_streaming::Streamer;
use antipode_terrain::{FIRST_PLANTED, Thing};
use glam::DVec3;

use crate::actions::Actions;
use crate::actors::Actors;
use crate::crosshair::Crosshair;
use crate::falling::Falling;
use crate::felling;
use crate::frame::{Marker, MarkerShape};
use crate::notice::Hint;
use crate::outbox::Outbox;
use crate::persist::All;
use crate::player::Player;
use crate::restore::finite_or;
use crate::situation::Situation;
use crate::sound::SoundEvent;
use crate::tuning::{DAY_S, FIXTURE_REACH_M};
use crate::world::World;

/// What a seed has grown into by then, days of the world: its age, and how large it is of that.
const STAGES: [(f64, Age, f64); 7] = [
    (0.0, Age::Young, 0.18),
    (0.15, Age::Young, 0.4),
    (0.4, Age::Young, 0.7),
    (0.8, Age::Young, 1.0),
    (1.5, Age::Grown, 0.7),
    (2.5, Age::Grown, 1.0),
    (6.0, Age::Old, 1.0),
];
/// Planted in a world at most.
pub(crate) const MOST_PLANTED: usize = 4096;
/// Ground is level enough for a tree where its unit normal has so much upright.
const LEVEL: f64 = 0.8;
/// No other trunk is so near, metres.
const APART_M: f64 = 1.2;
/// So high above it there is to be air, metres, looked for at each of them.
const AIR_M: [f64; 3] = [1.0, 2.0, 3.0];
/// A root lies so far below the ground's face that it shows nowhere, metres.
const ROOTED_M: f64 = 0.04;
/// Radius of the ball that shows where a seed would go, metres.
const MARKER_M: f64 = 0.08;

/// One that was planted, as it stands now.
#[derive(Clone, Debug)]
struct Plant {
    id: u32,
    thing: Thing,
    species: Species,
    /// When it was planted, simulated seconds.
    since_s: f64,
}

impl Plant {
    /// What it is after so many simulated seconds; what was felled stays a stump.
    fn grown(&self, now_s: f64) -> Thing {
        if self.thing.species != self.species.byte() {
            return self.thing;
        }
        let days = (now_s - self.since_s) / DAY_S;
        let reached = STAGES.iter().rev().find(|(from, ..)| days >= *from);
        let (_, age, size) = reached.unwrap_or(&STAGES[0]);
        // No two of a kind are as large: by where they stand, so that it is the same after every load.
        let root = self.thing.root.as_dvec3();
        let own = (3.7 * root.x + 5.3 * root.z).rem_euclid(1.0);
        Thing {
            age: age.byte(),
            scale: (size * (0.86 + 0.28 * own)) as f32,
            ..self.thing
        }
    }
}

/// All that was planted in a world and stands, or has left a stump.
#[derive(Clone, Debug, Default)]
pub(crate) struct Planted {
    all: BTreeMap<(ChunkCoord, u8), Plant>,
    next: u32,
    /// The one that was looked at last.
    looked_at: Option<(ChunkCoord, u8)>,
}

impl Planted {
    /// Whether a thing that a chunk shows is still that.
    pub fn has(&self, coord: ChunkCoord, thing: &Thing) -> bool {
        let found = self.all.get(&(coord, thing.slot));
        found.is_some_and(|it| it.thing.species == thing.species)
    }

    /// How many trees there are.
    pub fn count(&self) -> usize {
        let trees = self.all.values();
        trees
            .filter(|it| it.thing.species == it.species.byte())
            .count()
    }

    /// Puts one in; nothing where the chunk or the world can have no more.
    fn add(
        &mut self,
        (id, root, species): (u32, ChartPoint, Species),
        since_s: f64,
        now_s: f64,
    ) -> Option<(ChunkCoord, Thing)> {
        let coord = ChunkCoord::containing(root);
        let is_free = |slot: &u8| !self.all.contains_key(&(coord, *slot));
        let slot = (FIRST_PLANTED..=u8::MAX).find(is_free)?;
        if self.all.len() >= MOST_PLANTED {
            return None;
        }
        let root = root.pos - coord.origin();
        // What a save says may lie where no chunk is.
        let in_chunk = 0.0..=f64::from(CHUNK_CELLS);
        if !root.to_array().iter().all(|along| in_chunk.contains(along)) {
            return None;
        }
        let thing = Thing {
            root: root.as_vec3(),
            slot,
            species: species.byte(),
            age: Age::Young.byte(),
            turn_rad: (7.0 * root.x + 11.0 * root.z).rem_euclid(TAU) as f32,
            scale: 1.0,
        };
        let mut plant = Plant {
            id,
            thing,
            species,
            since_s,
        };
        plant.thing = plant.grown(now_s);
        let thing = plant.thing;
        self.next = self.next.max(id);
        self.all.insert((coord, slot), plant);
        Some((coord, thing))
    }

    /// Leaves of one what is left of such a thing when it is felled, as the chunk workers do.
    pub fn fell(&mut self, coord: ChunkCoord, slot: u8) {
        let Some(plant) = self.all.get_mut(&(coord, slot)) else {
            return;
        };
        match left_of(&plant.thing) {
            Some(stump) => plant.thing = stump,
            None => {
                self.all.remove(&(coord, slot));
            }
        }
    }

    /// Has the next of all grow, if it is due: one a step, so that no step has much to do.
    fn grow(&mut self, streamer: &mut Streamer, now_s: f64) {
        let after = |key| self.all.range(key..).map(|(key, _)| *key);
        let next = match self.looked_at {
            Some(last) => after(last).find(|key| *key != last),
            None => None,
        };
        self.looked_at = next.or_else(|| self.all.keys().next().copied());
        let Some(key) = self.looked_at else {
            return;
        };
        if let Some(plant) = self.all.get_mut(&key) {
            let grown = plant.grown(now_s);
            if grown != plant.thing {
                plant.thing = grown;
                streamer.plant(key.0, grown);
            }
        }
    }

    /// What a save has of it. What still falls stands there again, as what grew by itself does.
    pub fn records(&self, actors: &Actors, all: &mut All) {
        let falling = actors.map(|_, it: &Falling| it.slot());
        all.extend(self.all.iter().map(|((coord, slot), it)| {
            let pos = coord.origin() + it.thing.root.as_dvec3();
            let is_stump = it.thing.species != it.species.byte();
            let record = PlantedRecord {
                place: PlaceRecord {
                    chart: coord.chart.number(),
                    pos: pos.to_array(),
                },
                species: it.species.byte(),
                since_s: it.since_s,
                felled: is_stump && !falling.contains(&(*coord, *slot)),
            };
            (RecordKind::Planted.numbered(it.id), Record::Planted(record))
        }));
    }
}

/// Takes over one that a save has; false for what can stand in no place of this world.
pub(crate) fn restore(
    world: &mut World,
    id: u32,
    at: Option<ChartPoint>,
    it: &PlantedRecord,
) -> bool {
    let now_s = world.simulated_s;
    let since_s = finite_or(it.since_s, now_s).min(now_s);
    let tree = Species::of_byte(it.species).filter(|it| it.is_tree());
    let Some((root, species)) = at.zip(tree) else {
        return false;
    };
    let Some((coord, thing)) = world.planted.add((id, root, species), since_s, now_s) else {
        return false;
    };
    let stump = left_of(&thing).filter(|_| it.felled);
    if stump.is_some() {
        world.planted.fell(coord, thing.slot);
    }
    world
        .streamer
        .remember_planted(coord, stump.unwrap_or(thing));
    true
}

/// Where the seed in hand would go, and whether one would grow there; none where no ground is in reach.
fn bed(now: Situation<'_>) -> Option<(ChartPoint, bool)> {
    let world = now.world;
    let spot = Crosshair::aimed(now).ground(FIXTURE_REACH_M);
    let crossing = world.strategy.cross(spot.point);
    let point = crossing.map_or(spot.point, |crossing| crossing.point);
    let is_level = f64::from(world.ground.normal(point).y) >= LEVEL;
    let is_soft = world.ground.kind(point).hardness() == 0;
    let has_air = AIR_M
        .iter()
        .all(|up_m| !world.ground.is_solid(point.moved(DVec3::Y * *up_m)));
    let is_alone = felling::solids_near(world, point, APART_M).is_empty();
    spot.hit
        .then_some((point, is_level && is_soft && has_air && is_alone))
}

fn is_in_hand(now: Situation<'_>) -> bool {
    now.player.inventory.held() == Some(Item::Seed) && !now.actors.cars.is_driving()
}

/// Shows where the seed in hand would go.
pub(crate) fn marker(now: Situation<'_>) -> Option<Marker> {
    let (point, _) = is_in_hand(now).then(|| bed(now)).flatten()?;
    Some(Marker {
        point,
        radius_m: MARKER_M,
        active: false,
        shape: MarkerShape::Ball,
        ground: None,
    })
}

/// The left button puts the seed in hand into the ground under the crosshair, where it becomes a tree of that land.
pub(crate) fn use_in_hand(
    world: &mut World,
    actors: &Actors,
    player: &mut Player,
    outbox: &mut Outbox,
    actions: &Actions,
) {
    let now = Situation::of(world, actors, player);
    if !actions.primary || player.primary_before || !is_in_hand(now) {
        return;
    }
    let Some((point, true)) = bed(now) else {
        outbox.hints.push(Hint::NoPlaceFor(Item::Seed));
        return;
    };
    let root = point.moved(DVec3::NEG_Y * ROOTED_M);
    let share = (root.pos.x * 0.37 + root.pos.z * 0.61).rem_euclid(1.0);
    let species = tree_at(world.ground.field(), point, share as f32);
    let (id, now_s) = (world.planted.next + 1, world.simulated_s);
    let Some((coord, thing)) = world.planted.add((id, root, species), now_s, now_s) else {
        outbox.hints.push(Hint::TooMany(Item::Seed));
        return;
    };
    player.inventory.spend(Item::Seed);
    world.streamer.plant(coord, thing);
    outbox.sounds.push(SoundEvent::PutDown(Item::Seed));
}

/// Lets what was planted grow.
pub(crate) fn step(world: &mut World) {
    let now_s = world.simulated_s;
    world.planted.grow(&mut world.streamer, now_s);
}
