//! Everything that changes while a world is played, but for the terrain, as one value: what worlds up to version 6
//! were stored as, and what is convenient where all of it is looked at.

use serde::{Deserialize, Serialize};

use crate::record::{Record, RecordChanges, RecordKey};
use crate::record_shapes::{
    BotRecord, CarRecord, CourseRecord, DropRecord, FixtureRecord, FlagRecord, LampRecord,
    PlaceRecord, PlayerKept, PlayerRecord, SlotRecord, ViewRecord,
};

/// Everything that changes while a world is played, but for the terrain.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct WorldState {
    /// The player's body.
    pub player: PlayerRecord,
    /// The slot in the hand.
    pub item_slot: u8,
    /// The filled slots.
    pub inventory: Vec<SlotRecord>,
    /// Time of day, seconds.
    pub time_of_day_s: f64,
    /// The map of a hyperbolic world, `raised` or `horizon`; without meaning elsewhere.
    pub map: String,
    /// Dial of the raised map, metres; without meaning but in hyperbolic worlds.
    pub curvature: f64,
    /// Dial of the horizon map; without meaning but in hyperbolic worlds.
    pub curvature_horizon: f64,
    /// Whether the picture of a flat world is bent.
    pub bent: bool,
    /// Dial of the bend, positive where hyperbolic; kept while the picture is flat.
    pub bend: f64,
    /// Radius of the brush, metres.
    pub brush_radius_m: f64,
    /// Simulated time since the world was made, seconds.
    pub simulated_s: f64,
    /// View distance, chunks.
    pub view_distance: u32,
    /// Whether the flashlight is on.
    pub flashlight: bool,
    /// Lamps that were put down, in that order.
    pub lamps: Vec<LampRecord>,
    /// Flags that were planted, in that order. They came with records: in version 6, whose state is this value, they are not.
    #[serde(skip)]
    pub flags: Vec<FlagRecord>,
    /// What else was put down, in that order; as flags.
    #[serde(skip)]
    pub fixtures: Vec<FixtureRecord>,
    /// What lies about.
    pub drops: Vec<DropRecord>,
    /// Other figures.
    pub bots: Vec<BotRecord>,
    /// Cars.
    pub cars: Vec<CarRecord>,
    /// Which of the cars the player drives.
    pub driving: Option<u32>,
    /// Whether the world has been given its first car, which it may have lost since.
    pub car_given: bool,
    /// Where the player stands up again from death; none where the land alone decides.
    pub start: Option<PlaceRecord>,
    /// Whether the player was told of having gone once round the world.
    pub been_round: bool,
}

impl WorldState {
    /// The same as records; the actors of a kind are numbered from 0 in the order of their list.
    pub fn to_records(&self) -> impl Iterator<Item = (RecordKey, Record)> {
        let lamps = self.lamps.iter().cloned().map(Record::Lamp);
        let flags = self.flags.iter().cloned().map(Record::Flag);
        let fixtures = self.fixtures.iter().cloned().map(Record::Fixture);
        let drops = self.drops.iter().cloned().map(Record::Drop);
        let bots = self.bots.iter().cloned().map(Record::Figure);
        let cars = self.cars.iter().cloned().map(Record::Car);
        let actors = numbered(lamps)
            .chain(numbered(flags))
            .chain(numbered(fixtures))
            .chain(numbered(drops));
        let actors = actors.chain(numbered(bots)).chain(numbered(cars));
        let singles = [
            Record::Player(Box::new(self.player_kept())),
            Record::Course(CourseRecord {
                time_of_day_s: self.time_of_day_s,
                simulated_s: self.simulated_s,
                car_given: self.car_given,
            }),
            Record::View(ViewRecord {
                map: self.map.clone(),
                curvature: self.curvature,
                curvature_horizon: self.curvature_horizon,
                bent: self.bent,
                bend: self.bend,
                view_distance: self.view_distance,
            }),
        ];
        actors.chain(singles.map(|it| (it.kind().numbered(0), it)))
    }

    fn player_kept(&self) -> PlayerKept {
        PlayerKept {
            body: self.player.clone(),
            item_slot: self.item_slot,
            inventory: self.inventory.clone(),
            brush_radius_m: self.brush_radius_m,
            flashlight: self.flashlight,
            driving: self.driving,
            start: self.start.clone(),
            been_round: self.been_round,
        }
    }

    /// All of `records` in one value, actors in the order of their numbers.
    pub fn of_records<'a>(records: impl IntoIterator<Item = (&'a RecordKey, &'a Record)>) -> Self {
        let mut state = Self::default();
        let (mut cars, mut driving) = (Vec::new(), None);
        for (key, record) in records {
            match record.clone() {
                Record::Player(it) if key.id == 0 => {
                    driving = it.driving;
                    state.take_player(*it);
                }
                Record::Player(_) | Record::Earth(_) | Record::Felled(_) | Record::Planted(_) => {}
                Record::Course(it) => {
                    state.time_of_day_s = it.time_of_day_s;
                    state.simulated_s = it.simulated_s;
                    state.car_given = it.car_given;
                }
                Record::View(it) => state.take_view(it),
                Record::Lamp(it) => state.lamps.push(it),
                Record::Flag(it) => state.flags.push(it),
                Record::Fixture(it) => state.fixtures.push(it),
                Record::Drop(it) => state.drops.push(it),
                Record::Figure(it) => state.bots.push(it),
                Record::Car(it) => {
                    cars.push(key.id);
                    state.cars.push(it);
                }
            }
        }
        let seat = driving.and_then(|id| cars.iter().position(|car| *car == id));
        state.driving = seat.and_then(|at| u32::try_from(at).ok());
        state
    }

    fn take_player(&mut self, kept: PlayerKept) {
        self.player = kept.body;
        self.item_slot = kept.item_slot;
        self.inventory = kept.inventory;
        self.brush_radius_m = kept.brush_radius_m;
        self.flashlight = kept.flashlight;
        self.start = kept.start;
        self.been_round = kept.been_round;
    }

    fn take_view(&mut self, view: ViewRecord) {
        self.map = view.map;
        self.curvature = view.curvature;
        self.curvature_horizon = view.curvature_horizon;
        self.bent = view.bent;
        self.bend = view.bend;
        self.view_distance = view.view_distance;
    }
}

/// What to write for a world without records to hold this state.
impl From<&WorldState> for RecordChanges {
    fn from(state: &WorldState) -> Self {
        let records = state.to_records();
        records.map(|(key, record)| (key, Some(record))).collect()
    }
}

fn numbered(records: impl Iterator<Item = Record>) -> impl Iterator<Item = (RecordKey, Record)> {
    (0..)
        .zip(records)
        .map(|(id, record)| (record.kind().numbered(id), record))
}
