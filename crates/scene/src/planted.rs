//! What somebody planted: which trees, where and since when, what they have grown into by the days of the world, and what a save
//! has of them. They stand among what grew by itself, in slots of their own, and are felled like that.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use antipode_geometry::{CHUNK_CELLS, ChartPoint, ChunkCoord};
use antipode_plants::{Age, Species, left_of};
use antipode_storage::{PlaceRecord, PlantedRecord, Record, RecordKind};
use antipode_streaming::Streamer;
use antipode_terrain::{FIRST_PLANTED, Thing};
use glam::DVec3;

use crate::ground::Ground;
use crate::persist::All;
use crate::pick::over;
use crate::restore::finite_or;
use crate::tuning::DAY_S;
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
/// A root lies so far below the ground's face that it shows nowhere, metres.
const ROOTED_M: f64 = 0.04;

/// One that was planted, as it stands now.
#[derive(Clone, Debug)]
struct Plant {
    id: u32,
    thing: Thing,
    species: Species,
    /// When it was planted, and felled, simulated seconds.
    since_s: f64,
    felled_s: Option<f64>,
}

impl Plant {
    /// What it is after so many simulated seconds.
    fn grown(&self, now_s: f64) -> Thing {
        let days = (self.felled_s.unwrap_or(now_s) - self.since_s) / DAY_S;
        let reached = STAGES.iter().rev().find(|(from, ..)| days >= *from);
        let (_, age, size) = reached.unwrap_or(&STAGES[0]);
        // No two of a kind are as large: by where they stand, so that it is the same after every load.
        let root = self.thing.root.as_dvec3();
        let own = (3.7 * root.x + 5.3 * root.z).rem_euclid(1.0);
        let tree = Thing {
            species: self.species.byte(),
            age: age.byte(),
            turn_rad: (7.0 * root.x + 11.0 * root.z).rem_euclid(TAU) as f32,
            scale: (size * (0.86 + 0.28 * own)) as f32,
            ..self.thing
        };
        let left = self.felled_s.and_then(|_| left_of(&tree));
        left.unwrap_or(tree)
    }
}

/// All that was planted in a world and stands, or has left a stump.
#[derive(Clone, Debug, Default)]
pub(crate) struct Planted {
    all: BTreeMap<(ChunkCoord, u8), Plant>,
    /// The number of the last one's record, or of any that a save has.
    last: u32,
    /// The one that was looked at last, and the second in which all are looked at.
    looked_at: Option<(ChunkCoord, u8)>,
    second: f64,
}

impl Planted {
    /// Whether a tree that a chunk shows has not been felled. A stump stands no more, as that of one that grew by itself.
    pub fn has(&self, coord: ChunkCoord, thing: &Thing) -> bool {
        let found = self.all.get(&(coord, thing.slot));
        found.is_some_and(|it| it.felled_s.is_none() && it.thing.species == thing.species)
    }

    /// How many trees there are.
    pub fn count(&self) -> usize {
        let trees = self.all.values();
        trees.filter(|it| it.felled_s.is_none()).count()
    }

    /// Whether one stands, or its stump, within so many metres of a place.
    pub fn is_near(&self, world: &World, place: ChartPoint, within_m: f64) -> bool {
        let mut roots = self.all.iter().map(|((coord, _), it)| {
            ChartPoint::new(coord.chart, coord.origin() + it.thing.root.as_dvec3())
        });
        roots.any(|root| {
            let there = over(&*world.strategy, place, root);
            there.pos.distance(place.pos) < within_m
        })
    }

    /// Takes a number for a record that no save has.
    pub fn number(&mut self) -> u32 {
        self.last = self.last.saturating_add(1);
        self.last
    }

    /// Says that a save has a record of this number.
    pub fn has_numbered(&mut self, id: u32) {
        self.last = self.last.max(id);
    }

    /// Puts one in at a place on the ground; nothing where the chunk or the world can have no more.
    pub fn add(
        &mut self,
        (id, place, species): (u32, ChartPoint, Species),
        (since_s, felled_s): (f64, Option<f64>),
        now_s: f64,
    ) -> Option<(ChunkCoord, Thing)> {
        let coord = ChunkCoord::containing(place);
        let is_free = |slot: &u8| !self.all.contains_key(&(coord, *slot));
        let slot = (FIRST_PLANTED..=u8::MAX).find(is_free)?;
        if self.all.len() >= MOST_PLANTED {
            return None;
        }
        let place = place.pos - coord.origin();
        // What a save says may lie where no chunk is.
        let in_chunk = 0.0..=f64::from(CHUNK_CELLS);
        if !place.to_array().iter().all(|it| in_chunk.contains(it)) {
            return None;
        }
        let mut plant = Plant {
            id,
            thing: Thing {
                root: (place - DVec3::Y * ROOTED_M).as_vec3(),
                slot,
                species: species.byte(),
                age: Age::Young.byte(),
                turn_rad: 0.0,
                scale: 1.0,
            },
            species,
            since_s,
            felled_s,
        };
        plant.thing = plant.grown(now_s);
        let thing = plant.thing;
        self.all.insert((coord, slot), plant);
        Some((coord, thing))
    }

    /// Leaves of one the stump, as the chunk workers do.
    pub fn fell(&mut self, coord: ChunkCoord, slot: u8, now_s: f64) {
        if let Some(plant) = self.all.get_mut(&(coord, slot)) {
            plant.felled_s = Some(now_s);
            plant.thing = plant.grown(now_s);
        }
    }

    /// Leaves nothing of one.
    pub fn uproot(&mut self, coord: ChunkCoord, slot: u8) {
        self.all.remove(&(coord, slot));
    }

    /// Looks at the next of all, once a second at each at most: if it has grown, or its chunk does not show it as it is, that is
    /// told the workers. One a step, so that no step has much to do.
    pub fn grow(&mut self, streamer: &mut Streamer, ground: &Ground, now_s: f64) {
        let next = match self.looked_at {
            Some(last) => self.all.range(last..).find(|(key, _)| **key != last),
            None if now_s >= self.second + 1.0 || now_s < self.second => {
                self.second = now_s;
                self.all.iter().next()
            }
            None => return,
        };
        self.looked_at = next.map(|(key, _)| *key);
        let Some((coord, slot)) = self.looked_at else {
            return;
        };
        let Some(plant) = self.all.get_mut(&(coord, slot)) else {
            return;
        };
        let grown = plant.grown(now_s);
        let has_grown = grown != plant.thing;
        plant.thing = grown;
        let shown = ground.things(coord).iter().find(|it| it.slot == slot);
        match shown {
            Some(shown) if *shown != grown => streamer.plant(coord, grown),
            // No land is there that would have to be made anew.
            None if has_grown => streamer.remember_planted(coord, grown),
            _ => {}
        }
    }

    /// What a save has of it.
    pub fn records(&self, all: &mut All) {
        all.extend(self.all.iter().map(|((coord, _), it)| {
            let pos = coord.origin() + it.thing.root.as_dvec3() + DVec3::Y * ROOTED_M;
            let record = PlantedRecord {
                place: PlaceRecord {
                    chart: coord.chart.number(),
                    pos: pos.to_array(),
                },
                species: it.species.byte(),
                since_s: it.since_s,
                felled_s: it.felled_s,
            };
            let key = RecordKind::Planted.numbered(it.id);
            (key, Record::Planted(record))
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
    let felled_s = it.felled_s.map(|felled_s| finite_or(felled_s, now_s));
    let tree = Species::of_byte(it.species).filter(|it| it.is_tree());
    let Some((place, species)) = at.zip(tree) else {
        return false;
    };
    let added = world
        .planted
        .add((id, place, species), (since_s, felled_s), now_s);
    if let Some((coord, thing)) = added {
        world.streamer.remember_planted(coord, thing);
    }
    added.is_some()
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests fail by panicking")]
mod tests {
    use super::*;

    fn place(x: f64) -> ChartPoint {
        ChartPoint::a(DVec3::new(x, 8.0, 3.0))
    }

    #[test]
    fn a_tree_grows_and_its_stump_does_not() {
        let mut planted = Planted::default();
        let begun = (1, place(4.0), Species::Oak);
        let (coord, sprout) = planted.add(begun, (0.0, None), 0.0).unwrap();
        let plant = planted.all[&(coord, sprout.slot)].clone();
        let height_m = |it: &Thing| {
            let age = Age::of_byte(it.age).unwrap();
            Species::Oak.height_m(age) * f64::from(it.scale)
        };
        let heights: Vec<_> = STAGES
            .iter()
            .map(|(days, ..)| height_m(&plant.grown(days * DAY_S + 1.0)))
            .collect();
        assert!(heights.is_sorted_by(|a, b| a < b), "{heights:?}");
        planted.fell(coord, sprout.slot, 0.9 * DAY_S);
        let plant = &planted.all[&(coord, sprout.slot)];
        let stump = plant.grown(0.9 * DAY_S);
        assert_eq!(stump.species, Species::Stump.byte());
        assert_eq!(plant.grown(50.0 * DAY_S), stump);
        assert!(!planted.has(coord, &stump) && planted.count() == 0);
    }

    #[test]
    fn a_chunk_and_a_world_can_have_no_more_than_they_have_room_for() {
        let mut planted = Planted::default();
        let added = (0..200).filter(|n| {
            let begun = (*n, place(f64::from(*n) * 0.1), Species::Birch);
            planted.add(begun, (0.0, None), 0.0).is_some()
        });
        assert_eq!(added.count(), 128);
        let added = (200..9000).filter(|n| {
            let begun = (*n, place(f64::from(*n) * 32.0), Species::Birch);
            planted.add(begun, (0.0, None), 0.0).is_some()
        });
        assert_eq!(128 + added.count(), MOST_PLANTED);
        for far in [f64::NAN, f64::INFINITY, 1e300] {
            let begun = (9999, place(far), Species::Birch);
            assert!(planted.add(begun, (0.0, None), 0.0).is_none());
        }
    }

    #[test]
    fn no_number_is_given_twice_nor_one_that_a_save_has() {
        let mut planted = Planted::default();
        planted.has_numbered(7);
        assert_eq!([planted.number(), planted.number()], [8, 9]);
        planted.has_numbered(u32::MAX);
        assert_eq!(planted.number(), u32::MAX);
    }
}
