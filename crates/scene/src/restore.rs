//! From a save to the scene: what is stored of a world comes back, and numbers that no play could have produced are
//! replaced by the start's. What is not taken in stays in the save as it is.

use std::collections::BTreeMap;

use antipode_geometry::{Atlas, ChartId, ChartPoint};
use antipode_storage::{
    BotRecord, CourseRecord, DropRecord, FelledRecord, PlayerKept, PlayerRecord, Record, RecordKey,
    RecordKind, Records, SlotRecord, ViewRecord,
};
use glam::DVec3;

use crate::actors::{ActorId, Actors};
use crate::bot::{self, Bot};
use crate::camera::CameraMode;
use crate::car::Car;
use crate::car::doors::take_wheel;
use crate::car::tuning::MOST_CARS;
use crate::drops::Drop;
use crate::fixture::{self, Fixture};
use crate::inventory::{Inventory, SLOTS, Stack};
use crate::lens::{DialGoals, Lens};
use crate::notice::Notice;
use crate::npc::mind::Mind;
use crate::npc::tuning::ANGRY_S;
use crate::persist::All;
use crate::planted::{self, MOST_PLANTED};
use crate::player::Player;
use crate::situation::Situation;
use crate::tuning::{BOT_HEALTH, BRUSH_RADIUS_M, FULL_HEALTH, MOST_BOTS, MOST_DROPS};
use crate::world::World;
use crate::{body, car};
use antipode_items::Item;

/// The game saves nothing that is faster than this. A faster body in a save is slowed down: the ground that it would reach is not to be asked for.
pub(crate) const FASTEST_RESTORED_M_S: f64 = 100.0;
/// Longer than this, in seconds, nobody plays: three hundred years. A step still counts there.
pub(crate) const LONGEST_PLAYED_S: f64 = 1e10;
/// Columns of chunks in which something was felled, at most: more than anybody gets round to.
const MOST_FELLED: usize = 1 << 20;
/// A driver who is farther from the car in the save, in metres, does not sit in it.
const SEATED_WITHIN_M: f64 = 8.0;

/// Takes in the player: where and how he is, and what he has. Returns what is in his slots that this version does not
/// know.
pub(crate) fn player(
    world: &World,
    actors: &mut Actors,
    player: &mut Player,
    kept: &PlayerKept,
    notices: &mut Vec<Notice>,
) -> Vec<SlotRecord> {
    if !place_player(world, actors, player, &kept.body) {
        notices.push(Notice::PlayerDamaged);
    }
    let start = kept.start.as_ref();
    player.start = start.and_then(|it| point(world, it.chart, it.pos));
    player.circumnavigation.been = kept.been_round;
    player.flashlight = kept.flashlight;
    let (least, most, usual) = BRUSH_RADIUS_M;
    player.brush_radius_m = finite_or(kept.brush_radius_m, usual).clamp(least, most);
    player.inventory = Inventory::empty();
    let mut unknown = Vec::new();
    for record in &kept.inventory {
        if let Some(item) = Item::from_id(&record.item) {
            let count = record.count.max(1);
            put_slot(&mut player.inventory, record.slot, Stack { item, count });
        } else {
            notices.push(Notice::UnknownItem(record.item.clone()));
            unknown.push(record.clone());
        }
    }
    player.inventory.select(kept.item_slot);
    unknown
}

/// Puts a saved stack where it was; one without a place goes wherever there is room.
fn put_slot(inventory: &mut Inventory, slot: u8, stack: Stack) {
    if slot < SLOTS && inventory.slots()[usize::from(slot)].is_none() {
        inventory.put(slot, stack);
    } else {
        inventory.give(stack.item, stack.count);
    }
}

/// Returns whether the numbers are such as a play could have produced.
fn place_player(
    world: &World,
    actors: &mut Actors,
    player: &mut Player,
    record: &PlayerRecord,
) -> bool {
    let numbers =
        record
            .pos
            .iter()
            .chain(&record.vel)
            .chain([&record.yaw, &record.pitch, &record.health]);
    if !numbers.into_iter().all(|n| n.is_finite()) {
        return false;
    }
    let Some(chart) = chart(&*world.strategy, record.chart) else {
        return false;
    };
    let point = ChartPoint::new(chart, DVec3::from_array(record.pos));
    let velocity = DVec3::from_array(record.vel).clamp_length_max(FASTEST_RESTORED_M_S);
    body::place(world, actors, player, point, velocity, record.grounded);
    actors.set_look(record.yaw, record.pitch);
    actors.set_health(record.health);
    player.gaze.camera = if record.third_person {
        CameraMode::Third
    } else {
        CameraMode::First
    };
    player.flying = record.flying;
    true
}

/// Takes in everything else. Returns what was taken in, and the world's course if the save has it.
pub(crate) fn things(
    world: &mut World,
    actors: &mut Actors,
    lens: &mut Lens,
    records: Records,
    notices: &mut Vec<Notice>,
) -> (All, Option<CourseRecord>) {
    if records.unknown > 0 {
        notices.push(Notice::UnknownRecords(records.unknown));
    }
    let (mut taken, mut course) = (All::new(), None);
    let mut seen = BTreeMap::<_, usize>::new();
    for (key, record) in records.known {
        let seen = seen.entry(key.kind).or_default();
        *seen += 1;
        if let Record::Course(it) = &record {
            course = Some(it.clone());
        }
        if *seen <= most(key.kind) && thing(world, actors, lens, key, &record, notices) {
            taken.insert(key, record);
        }
    }
    for (kind, last) in records.last {
        number_next(world, actors, kind.numbered(last.saturating_add(1)));
    }
    (taken, course)
}

/// Takes one thing in; false for what is not to be.
fn thing(
    world: &mut World,
    actors: &mut Actors,
    lens: &mut Lens,
    key: RecordKey,
    record: &Record,
    notices: &mut Vec<Notice>,
) -> bool {
    number_next(world, actors, key);
    match record {
        Record::Player(_) => key.id == 0,
        // The streamer keeps it.
        Record::Earth(_) => false,
        Record::Course(_) => true,
        Record::View(it) => {
            view(lens, it, notices);
            true
        }
        Record::Lamp(it) => {
            let at = point(world, it.chart, it.pos);
            fixture(world, actors, Item::Lamp, at, (None, ""))
        }
        Record::Flag(it) => {
            let at = point(world, it.chart, it.pos);
            fixture(world, actors, Item::Flag, at, (Some(it.yaw), &it.name))
        }
        Record::Fixture(it) => {
            let Some(item) = Item::from_id(&it.item) else {
                notices.push(Notice::UnknownItem(it.item.clone()));
                return false;
            };
            let at = point(world, it.chart, it.pos);
            fixture(world, actors, item, at, (Some(it.yaw), &it.name))
        }
        Record::Drop(it) => drop(world, actors, it, notices),
        Record::Figure(it) => figure(world, actors, it),
        Record::Car(it) => car::restore(world, actors, it),
        Record::Felled(it) => {
            felled(world, key.id, it);
            // It tells by itself what of it is to be saved.
            false
        }
        Record::Planted(it) => {
            let at = point(world, it.place.chart, it.place.pos);
            planted::restore(world, key.id, at, it)
        }
    }
}

/// Says which number the next of a kind gets.
fn number_next(world: &mut World, actors: &mut Actors, key: RecordKey) {
    match key.kind {
        RecordKind::Player | RecordKind::Course | RecordKind::View | RecordKind::Earth => {}
        RecordKind::Felled => world.felled.has_numbered(key.id),
        RecordKind::Planted => world.planted.has_numbered(key.id),
        RecordKind::Lamp | RecordKind::Flag | RecordKind::Fixture => {
            actors.number_next_fixture(key.kind, key.id);
        }
        RecordKind::Drop => actors.number_next::<Drop>(key.id),
        RecordKind::Figure => actors.number_next::<Bot>(key.id),
        RecordKind::Car => actors.number_next::<Car>(key.id),
    }
}

/// Leaves out what was felled, unless it was so in no place of this world.
fn felled(world: &mut World, id: u32, it: &FelledRecord) {
    if let Some(chart) = chart(&*world.strategy, it.chart) {
        let column = (chart, [it.x, it.z]);
        world.felled.restore(&world.streamer, id, column, it);
    }
}

/// Puts up what was put down, with its heading and its name.
fn fixture(
    world: &World,
    actors: &mut Actors,
    item: Item,
    at: Option<ChartPoint>,
    (yaw, name): (Option<f64>, &str),
) -> bool {
    let yaw_rad = yaw.map(|yaw| finite_or(yaw, 0.0));
    let it = at.and_then(|at| Fixture::standing(world, item, at, yaw_rad));
    it.and_then(|it| fixture::enter(actors, it.named(name)))
        .is_some()
}

fn view(lens: &mut Lens, record: &ViewRecord, notices: &mut Vec<Notice>) {
    let map = record.map.parse();
    if map.is_err() {
        notices.push(Notice::UnknownMap(record.map.clone()));
    }
    let goals = DialGoals {
        raised: record.curvature,
        horizon: record.curvature_horizon,
        bend: record.bend,
    };
    lens.restore(map.unwrap_or_default(), record.bent, goals);
}

fn drop(
    world: &World,
    actors: &mut Actors,
    record: &DropRecord,
    notices: &mut Vec<Notice>,
) -> bool {
    let Some(item) = Item::from_id(&record.item) else {
        notices.push(Notice::UnknownItem(record.item.clone()));
        return false;
    };
    let Some(at) = point(world, record.chart, record.pos) else {
        return false;
    };
    let count = record.count.max(1);
    actors.enter(Drop::lying(Stack { item, count }, at));
    true
}

fn figure(world: &World, actors: &mut Actors, record: &BotRecord) -> bool {
    let at = point(world, record.chart, record.pos);
    let Some(at) = at.filter(|_| record.yaw.is_finite()) else {
        return false;
    };
    let health = finite_or(record.health, BOT_HEALTH).clamp(0.1, FULL_HEALTH);
    let (yaw, hostile, native) = (record.yaw, record.hostile, record.native);
    let entity = bot::spawn(world, actors, at, yaw, hostile, health, native);
    if let Ok(mind) = actors.ecs.query_one_mut::<&mut Mind>(entity) {
        mind.angry_s = finite_or(record.provoked_s, 0.0).clamp(0.0, ANGRY_S);
    }
    true
}

/// Puts the player at the wheel of the car with that number in the save, if he is close enough to it.
pub(crate) fn seat(world: &World, actors: &mut Actors, player: &Player, driving: Option<u32>) {
    let car = driving.and_then(|id| actors.car_view(ActorId(id)));
    let Some(car) = car else { return };
    let now = Situation::of(world, actors, player);
    if world
        .strategy
        .distance_m(now.feet(), car.point, &now.head())
        <= SEATED_WITHIN_M
    {
        take_wheel(actors, &car, CameraMode::First);
    }
}

/// A saved place, if it is one of this world.
pub(crate) fn point(world: &World, record: u128, pos: [f64; 3]) -> Option<ChartPoint> {
    let pos = DVec3::from_array(pos);
    let at = ChartPoint::new(chart(&*world.strategy, record)?, pos);
    pos.is_finite()
        .then(|| body::within_world(&*world.strategy, at))
}

/// Hemisphere B in saves; those of worlds of one chart may name it, too.
const HEMISPHERE_B: u128 = 1;

/// A saved chart: the first one for the second of a world that has no second, and none for another that the world has
/// not. What a later game has put there stays in the save as it is.
pub(crate) fn chart(strategy: &dyn Atlas, record: u128) -> Option<ChartId> {
    let chart = ChartId::new(record);
    if strategy.has_chart(chart) {
        Some(chart)
    } else {
        (record == HEMISPHERE_B).then_some(ChartId::FIRST)
    }
}

/// How many of a kind are taken in.
fn most(kind: RecordKind) -> usize {
    match kind {
        RecordKind::Player | RecordKind::Course | RecordKind::View | RecordKind::Earth => 1,
        RecordKind::Lamp | RecordKind::Flag | RecordKind::Fixture => most_fixtures(),
        RecordKind::Drop => 2 * MOST_DROPS,
        RecordKind::Figure => MOST_BOTS,
        RecordKind::Car => MOST_CARS,
        RecordKind::Felled => MOST_FELLED,
        RecordKind::Planted => MOST_PLANTED,
    }
}

/// How many are taken in of what was put down; of each item the world has its own limit besides.
fn most_fixtures() -> usize {
    let stands = Item::ALL.into_iter().filter_map(Item::stands);
    stands.map(|stands| stands.most).sum()
}

/// The value, where it is a number.
pub(crate) fn finite_or(value: f64, otherwise: f64) -> f64 {
    if value.is_finite() { value } else { otherwise }
}
