//! Between the scene and its save: everything the player could change goes out and comes back.

use antipode_geometry::{ChartPoint, Hemisphere};
use antipode_storage::{
    BotRecord, DropRecord, LampRecord, PlaceRecord, PlayerRecord, SlotRecord, WorldMeta, WorldState,
};
use glam::DVec3;

use crate::actors::Actors;
use crate::camera::CameraMode;
use crate::drops::Drop;
use crate::inventory::{Inventory, SLOTS, Stack};
use crate::item::Item;
use crate::keeping::Keeping;
use crate::lamp::Lamp;
use crate::lens::{DialGoals, Lens};
use crate::notice::Notice;
use crate::npc::tuning::ANGRY_S;
use crate::player::Player;
use crate::situation::Situation;
use crate::tuning::{BOT_HEALTH, BRUSH_RADIUS_M, FULL_HEALTH, MOST_BOTS, MOST_DROPS, MOST_LAMPS};
use crate::world::World;
use crate::{body, bot, car};

/// Who or what is faster in a save was not saved by the game: the ground that it would reach is not to be asked for.
pub(crate) const FASTEST_RESTORED_M_S: f64 = 100.0;
/// Longer than this, in seconds, nobody plays: three hundred years. A step still counts there.
pub(crate) const LONGEST_PLAYED_S: f64 = 1e10;
/// A driver who is farther from the car in the save, in metres, does not sit in it.
const SEATED_WITHIN_M: f64 = 8.0;
/// Things in the save that this version does not know, as a newer one would: they go back as they came.
#[derive(Clone, Debug, Default)]
pub(crate) struct Unknown {
    slots: Vec<SlotRecord>,
    drops: Vec<DropRecord>,
}

/// The records to commit.
pub(crate) fn records(now: Situation<'_>, kept: &Keeping) -> (WorldMeta, WorldState) {
    let mut meta = now.world.setup.to_meta();
    meta.created_unix_s = kept.created_unix_s;
    meta.played_s = now.world.simulated_s;
    meta.cheated = kept.cheated;
    (meta, state(now, &kept.unknown))
}

fn state(now: Situation<'_>, unknown: &Unknown) -> WorldState {
    let Situation {
        world,
        actors,
        player,
    } = now;
    let lens = &player.gaze.lens;
    let goals = lens.goals();
    let inventory = (0..)
        .zip(player.inventory.slots())
        .filter_map(|(slot, stack)| {
            stack.map(|s| SlotRecord {
                slot,
                item: s.item.id().to_owned(),
                count: s.count,
            })
        })
        .chain(unknown.slots.iter().cloned())
        .collect();
    let lamps = actors.all::<Lamp>().into_iter();
    let drops = actors.all::<Drop>().into_iter();
    WorldState {
        player: player_record(now),
        item_slot: player.inventory.selected(),
        inventory,
        time_of_day_s: world.time_of_day_s,
        map: lens.map().unwrap_or_default().to_string(),
        curvature: goals.raised,
        curvature_horizon: goals.horizon,
        bent: lens.bend().is_some(),
        bend: goals.bend,
        brush_radius_m: player.brush_radius_m,
        simulated_s: world.simulated_s,
        view_distance: world.setup.view_distance,
        flashlight: player.flashlight,
        lamps: lamps.map(|(_, it)| lamp_record(&it)).collect(),
        drops: drops
            .map(|(_, it)| drop_record(&it))
            .chain(carried_record(now))
            .chain(unknown.drops.iter().cloned())
            .collect(),
        bots: bot_records(actors),
        cars: car::records(world, &actors.cars),
        driving: actors
            .cars
            .driven_number()
            .and_then(|number| u32::try_from(number).ok()),
        car_given: actors.cars.given,
        start: player.start.map(|start| PlaceRecord {
            hemisphere: hemisphere_record(start),
            pos: start.pos.to_array(),
        }),
        been_round: player.round.been,
    }
}

fn player_record(now: Situation<'_>) -> PlayerRecord {
    let (position, look) = now.actors.player_stance();
    let body = now.actors.player_body();
    PlayerRecord {
        hemisphere: hemisphere_record(position.0),
        pos: position.0.pos.to_array(),
        vel: body.velocity.to_array(),
        yaw: look.yaw,
        pitch: look.pitch,
        health: now.actors.health(),
        third_person: now.player.gaze.camera == CameraMode::Third,
        flying: now.player.flying,
        grounded: body.grounded,
    }
}

/// What the pointer holds while the backpack is open lies at the player's feet in a save.
fn carried_record(now: Situation<'_>) -> Option<DropRecord> {
    let stack = now.player.inventory.carried()?;
    let middle_m = 0.5 * now.actors.tuning.height_m;
    let middle = now.feet().moved(DVec3::Y * middle_m);
    Some(drop_record(&Drop::lying(stack, middle)))
}

fn bot_records(actors: &Actors) -> Vec<BotRecord> {
    let living = bot::views(actors)
        .into_iter()
        .filter(|view| view.health > 0.0);
    living
        .map(|view| BotRecord {
            hemisphere: hemisphere_record(view.point),
            pos: view.point.pos.to_array(),
            yaw: view.yaw,
            health: view.health,
            hostile: view.bot.hostile,
            provoked_s: view.angry_s,
            native: view.bot.native,
        })
        .collect()
}

/// Takes in where the player is and how he is; says so where that cannot be.
pub(crate) fn restore_player(
    world: &World,
    actors: &mut Actors,
    player: &mut Player,
    record: &PlayerRecord,
) -> Result<(), Notice> {
    let numbers =
        record
            .pos
            .iter()
            .chain(&record.vel)
            .chain([&record.yaw, &record.pitch, &record.health]);
    if !numbers.into_iter().all(|n| n.is_finite()) {
        return Err(Notice::PlayerDamaged);
    }
    let hemisphere = hemisphere_of(world, record.hemisphere);
    let point = ChartPoint::new(hemisphere, DVec3::from_array(record.pos));
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
    Ok(())
}

/// Takes in what the player has and has chosen. Numbers that no play could have produced are replaced by the start's.
pub(crate) fn restore_belongings(
    world: &World,
    player: &mut Player,
    unknown: &mut Unknown,
    state: &WorldState,
) -> Vec<Notice> {
    let start = state.start.as_ref();
    player.start = start.and_then(|it| restored_point(world, it.hemisphere, it.pos));
    player.round.been = state.been_round;
    player.flashlight = state.flashlight;
    let (least, most, usual) = BRUSH_RADIUS_M;
    player.brush_radius_m = finite_or(state.brush_radius_m, usual).clamp(least, most);
    player.inventory = Inventory::empty();
    unknown.slots.clear();
    let mut notices = Vec::new();
    for record in &state.inventory {
        if let Some(item) = Item::from_id(&record.item) {
            let count = record.count.max(1);
            restore_slot(&mut player.inventory, record.slot, Stack { item, count });
        } else {
            notices.push(Notice::UnknownItem(record.item.clone()));
            unknown.slots.push(record.clone());
        }
    }
    player.inventory.select(state.item_slot);
    notices
}

/// Puts a saved stack where it was; one without a place goes wherever there is room.
fn restore_slot(inventory: &mut Inventory, slot: u8, stack: Stack) {
    if slot < SLOTS && inventory.slots()[usize::from(slot)].is_none() {
        inventory.put(slot, stack);
    } else {
        inventory.give(stack.item, stack.count);
    }
}

/// Takes in lamps, what lies about, and who is there.
pub(crate) fn restore_things(
    world: &World,
    actors: &mut Actors,
    unknown: &mut Unknown,
    state: &WorldState,
) -> Vec<Notice> {
    let point = |hemisphere: u8, pos: [f64; 3]| restored_point(world, hemisphere, pos);
    actors.clear::<Lamp>();
    let lamps = state.lamps.iter().take(MOST_LAMPS);
    for at in lamps.filter_map(|it| point(it.hemisphere, it.pos)) {
        actors.enter(Lamp::standing(at));
    }
    actors.clear::<Drop>();
    unknown.drops.clear();
    let mut notices = Vec::new();
    for record in state.drops.iter().take(2 * MOST_DROPS) {
        let Some(item) = Item::from_id(&record.item) else {
            notices.push(Notice::UnknownItem(record.item.clone()));
            unknown.drops.push(record.clone());
            continue;
        };
        if let Some(at) = point(record.hemisphere, record.pos) {
            let count = record.count.max(1);
            actors.enter(Drop::lying(Stack { item, count }, at));
        }
    }
    let bots = state.bots.iter().take(MOST_BOTS);
    for record in bots.filter(|it| it.yaw.is_finite()) {
        let Some(at) = point(record.hemisphere, record.pos) else {
            continue;
        };
        let health = finite_or(record.health, BOT_HEALTH).clamp(0.1, FULL_HEALTH);
        let id = bot::spawn(world, actors, at, record.yaw, record.hostile, health);
        let angry_s = finite_or(record.provoked_s, 0.0).clamp(0.0, ANGRY_S);
        bot::set_mind(actors, id, angry_s, record.native);
    }
    notices
}

/// Takes in the cars, and the player at the wheel of one if he is close enough to it.
pub(crate) fn restore_cars(
    world: &World,
    actors: &mut Actors,
    player: &Player,
    state: &WorldState,
) {
    let now = Situation::of(world, actors, player);
    let seated = |number: &u32| {
        let car = usize::try_from(*number)
            .ok()
            .and_then(|number| state.cars.get(number));
        let car = car.and_then(|car| restored_point(world, car.hemisphere, car.pos));
        let away_m = |car| world.strategy.distance_m(now.feet(), car, &now.head());
        car.is_some_and(|car| away_m(car) <= SEATED_WITHIN_M)
    };
    let driving = state.driving.filter(seated);
    car::restore(
        world,
        &mut actors.cars,
        &state.cars,
        driving,
        state.car_given,
    );
}

/// Takes in through which picture the player sees; says so where it is not known.
pub(crate) fn restore_lens(lens: &mut Lens, state: &WorldState) -> Result<(), Notice> {
    let map = state.map.parse();
    let goals = DialGoals {
        raised: state.curvature,
        horizon: state.curvature_horizon,
        bend: state.bend,
    };
    let known = map.is_ok();
    lens.restore(map.unwrap_or_default(), state.bent, goals);
    if known {
        Ok(())
    } else {
        Err(Notice::UnknownMap(state.map.clone()))
    }
}

/// A saved place, if it is one of this world.
pub(crate) fn restored_point(world: &World, hemisphere: u8, pos: [f64; 3]) -> Option<ChartPoint> {
    let pos = DVec3::from_array(pos);
    let at = ChartPoint::new(hemisphere_of(world, hemisphere), pos);
    pos.is_finite()
        .then(|| body::within_world(&*world.strategy, at))
}

fn hemisphere_of(world: &World, record: u8) -> Hemisphere {
    if record == 1 && world.strategy.rim_m().is_some() {
        Hemisphere::B
    } else {
        Hemisphere::A
    }
}

fn hemisphere_record(point: ChartPoint) -> u8 {
    u8::from(point.hemisphere == Hemisphere::B)
}

fn lamp_record(lamp: &Lamp) -> LampRecord {
    LampRecord {
        hemisphere: hemisphere_record(lamp.point),
        pos: lamp.point.pos.to_array(),
    }
}

fn drop_record(drop: &Drop) -> DropRecord {
    DropRecord {
        hemisphere: hemisphere_record(drop.point),
        pos: drop.point.pos.to_array(),
        item: drop.stack.item.id().to_owned(),
        count: drop.stack.count,
    }
}

pub(crate) fn finite_or(value: f64, otherwise: f64) -> f64 {
    if value.is_finite() { value } else { otherwise }
}
