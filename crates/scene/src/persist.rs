//! Saves a scene: writes one record for each thing of a world.

use std::collections::BTreeMap;

use antipode_items::Item;
use antipode_storage::{
    BotRecord, CourseRecord, DropRecord, FixtureRecord, FlagRecord, LampRecord, PlaceRecord,
    PlayerKept, PlayerRecord, Record, RecordKey, RecordKind, SlotRecord, ViewRecord,
};
use glam::DVec3;

use crate::actors::{ActorId, Actors};
use crate::bot::Bot;
use crate::camera::CameraMode;
use crate::car::Car;
use crate::drops::Drop;
use crate::falling;
use crate::fixture::Fixture;
use crate::npc::mind::Mind;
use crate::player::{Body, Health, Look, Player, Position};
use crate::world::World;

/// Records by their keys.
pub(crate) type All = BTreeMap<RecordKey, Record>;

/// What the world and all in it are to be saved as, but for what was felled, which knows itself what of it has changed. `slots` hold
/// things that this version does not know.
pub(crate) fn records(
    world: &World,
    actors: &Actors,
    player: &Player,
    slots: &[SlotRecord],
) -> All {
    let mut all = All::new();
    let mut single = |record: Record| all.insert(record.kind().numbered(0), record);
    if let Some(kept) = player_record(actors, player, slots) {
        single(Record::Player(Box::new(kept)));
    }
    single(Record::Course(CourseRecord {
        time_of_day_s: world.time_of_day_s,
        simulated_s: world.simulated_s,
        car_given: actors.cars.given,
    }));
    single(Record::View(view_record(world, player)));
    world.planted.records(&mut all);
    things(world, actors, player, &mut all);
    figures(actors, &mut all);
    all.extend(actors.map(|id, car: &Car| {
        let record = Record::Car(car.record());
        (RecordKind::Car.numbered(id.0), record)
    }));
    all
}

fn player_record(actors: &Actors, player: &Player, slots: &[SlotRecord]) -> Option<PlayerKept> {
    let mut own = actors
        .ecs
        .query_one::<(&Position, &Look, &Body, &Health)>(actors.player);
    let (position, look, body, health) = own.get().ok()?;
    let known = (0..).zip(player.inventory.slots());
    let known = known.filter_map(|(slot, stack)| {
        stack.map(|stack| SlotRecord {
            slot,
            item: stack.item.id().to_owned(),
            count: stack.count,
        })
    });
    Some(PlayerKept {
        body: PlayerRecord {
            chart: position.0.chart.number(),
            pos: position.0.pos.to_array(),
            vel: body.0.velocity.to_array(),
            yaw: look.yaw,
            pitch: look.pitch,
            health: health.0,
            third_person: player.gaze.camera == CameraMode::Third,
            flying: player.flying,
            grounded: body.0.grounded,
        },
        item_slot: player.inventory.selected(),
        inventory: known.chain(slots.iter().cloned()).collect(),
        brush_radius_m: player.brush_radius_m,
        flashlight: player.flashlight,
        driving: actors.cars.driven().map(|id| id.0),
        start: player.start.map(|start| PlaceRecord {
            chart: start.chart.number(),
            pos: start.pos.to_array(),
        }),
        been_round: player.circumnavigation.been,
    })
}

fn view_record(world: &World, player: &Player) -> ViewRecord {
    let lens = &player.gaze.lens;
    let goals = lens.goals();
    ViewRecord {
        map: lens.map().unwrap_or_default().to_string(),
        curvature: goals.raised,
        curvature_horizon: goals.horizon,
        bent: lens.bend().is_some(),
        bend: goals.bend,
        view_distance: world.setup.view_distance,
    }
}

/// As which kind of record something that was put down is kept. Lamps and flags had theirs before others could stand.
pub(crate) fn fixture_kind(item: Item) -> RecordKind {
    match item {
        Item::Lamp => RecordKind::Lamp,
        Item::Flag => RecordKind::Flag,
        _ => RecordKind::Fixture,
    }
}

/// What something that was put down is kept as.
pub(crate) fn fixture_record(it: &Fixture) -> Record {
    let (chart, pos) = (it.foot.point.chart.number(), it.foot.point.pos.to_array());
    let (yaw, name) = (it.yaw_rad, it.name.clone());
    match fixture_kind(it.item) {
        RecordKind::Lamp => Record::Lamp(LampRecord { chart, pos }),
        RecordKind::Flag => Record::Flag(FlagRecord {
            chart,
            pos,
            yaw,
            name,
        }),
        _ => Record::Fixture(FixtureRecord {
            chart,
            pos,
            yaw,
            name,
            item: it.item.id().to_owned(),
        }),
    }
}

/// What was put down, and what lies about. What the pointer holds while the backpack is open lies at the player's feet in a save, and
/// a tree that falls as what it breaks into, under the numbers of the next that are thrown away.
fn things(world: &World, actors: &Actors, player: &Player, all: &mut All) {
    let mut fixtures = actors.ecs.query::<(&ActorId, &Fixture)>();
    all.extend(fixtures.iter().map(|(id, it)| {
        let key = fixture_kind(it.item).numbered(id.0);
        (key, fixture_record(it))
    }));
    let drop_record = |id: u32, drop: &Drop| {
        let record = Record::Drop(DropRecord {
            chart: drop.point.chart.number(),
            pos: drop.point.pos.to_array(),
            item: drop.stack.item.id().to_owned(),
            count: drop.stack.count,
        });
        (RecordKind::Drop.numbered(id), record)
    };
    let mut drops = actors.ecs.query::<(&ActorId, &Drop)>();
    all.extend(drops.iter().map(|(id, drop)| drop_record(id.0, drop)));
    let middle = DVec3::Y * (0.5 * actors.tuning.height_m);
    let carried = player.inventory.carried();
    let carried = carried.map(|stack| Drop::lying(stack, actors.feet().moved(middle)));
    let still = carried.into_iter().chain(falling::kept(world, actors));
    let numbered = (actors.next::<Drop>().0..).zip(still);
    all.extend(numbered.map(|(id, drop)| drop_record(id, &drop)));
}

fn figures(actors: &Actors, all: &mut All) {
    let mut figures = actors
        .ecs
        .query::<(&Bot, &Position, &Look, &Health, &Mind)>();
    let living = figures.iter().filter(|(.., health, _)| health.0 > 0.0);
    all.extend(living.map(|(bot, position, look, health, mind)| {
        // Who sits is within what is solid of the stone.
        let stands = mind.seat.map_or(position.0, |seat| seat.left(position.0));
        let record = Record::Figure(BotRecord {
            chart: stands.chart.number(),
            pos: stands.pos.to_array(),
            yaw: look.yaw,
            health: health.0,
            hostile: bot.hostile,
            provoked_s: mind.angry_s,
            native: bot.native,
        });
        (RecordKind::Figure.numbered(bot.id), record)
    }));
}
