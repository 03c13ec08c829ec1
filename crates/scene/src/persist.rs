//! Between the scene and its save: everything the player could change goes out and comes back.

use antipode_geometry::{ChartPoint, ChunkCoord, Hemisphere, HyperbolicMap};
use antipode_storage::{
    BotRecord, DropRecord, LampRecord, PlaceRecord, PlayerRecord, SlotRecord, WorldMeta, WorldState,
};
use glam::DVec3;

use crate::camera::CameraMode;
use crate::drops::Drop;
use crate::ground::height_below;
use crate::inventory::{Inventory, SLOTS, Stack};
use crate::item::Item;
use crate::lamp::Lamp;
use crate::lens::DialGoals;
use crate::notice::Notice;
use crate::npc::tuning::ANGRY_S;
use crate::player::{Health, Look};
use crate::scene::Scene;
use crate::tuning::{BOT_HEALTH, BRUSH_RADIUS_M, FULL_HEALTH, MOST_BOTS, MOST_DROPS, MOST_LAMPS};

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

/// Depth below the player's head searched for ground, in metres.
pub(crate) const GROUND_SEARCH_M: f64 = 128.0;

impl Scene {
    /// The records to commit.
    pub(crate) fn records(&self) -> (WorldMeta, WorldState) {
        let mut meta = self.world.setup.to_meta();
        meta.created_unix_s = self.kept.created_unix_s;
        meta.played_s = self.world.simulated_s;
        meta.cheated = self.kept.cheated;
        (meta, self.state())
    }

    fn state(&self) -> WorldState {
        let goals = self.player.lens.goals();
        let (position, look, body, _) = self.player_parts();
        let inventory = (0..)
            .zip(self.player.inventory.slots())
            .filter_map(|(slot, stack)| {
                stack.map(|s| SlotRecord {
                    slot,
                    item: s.item.id().to_owned(),
                    count: s.count,
                })
            })
            .chain(self.kept.unknown.slots.iter().cloned())
            .collect();
        WorldState {
            player: PlayerRecord {
                hemisphere: hemisphere_record(position.0),
                pos: position.0.pos.to_array(),
                vel: body.0.velocity.to_array(),
                yaw: look.yaw,
                pitch: look.pitch,
                health: self.health(),
                third_person: self.shown.camera == CameraMode::Third,
                flying: self.player.flying,
                grounded: body.0.grounded,
            },
            item_slot: self.player.inventory.selected(),
            inventory,
            time_of_day_s: self.world.time_of_day_s,
            map: self.player.lens.map().unwrap_or_default().to_string(),
            curvature: goals.raised,
            curvature_horizon: goals.horizon,
            bent: self.player.lens.bend().is_some(),
            bend: goals.bend,
            brush_radius_m: self.player.brush_radius_m,
            simulated_s: self.world.simulated_s,
            view_distance: self.world.setup.view_distance,
            flashlight: self.player.flashlight,
            lamps: self.lamps().iter().map(lamp_record).collect(),
            drops: self
                .drops()
                .iter()
                .map(drop_record)
                .chain(self.carried_record())
                .chain(self.kept.unknown.drops.iter().cloned())
                .collect(),
            bots: self.bot_records(),
            cars: self.car_records(),
            driving: self
                .driven_number()
                .and_then(|number| u32::try_from(number).ok()),
            car_given: self.actors.cars.given,
            start: self.player.start.map(|start| PlaceRecord {
                hemisphere: hemisphere_record(start),
                pos: start.pos.to_array(),
            }),
            been_round: self.player.round.been,
        }
    }

    /// What the pointer holds while the backpack is open lies at the player's feet in a save.
    fn carried_record(&self) -> Option<DropRecord> {
        let stack = self.player.inventory.carried()?;
        let middle = self
            .feet()
            .moved(DVec3::Y * (0.5 * self.actors.tuning.height_m));
        Some(drop_record(&Drop::lying(stack, middle)))
    }

    fn bot_records(&self) -> Vec<BotRecord> {
        let living = self.bots().into_iter().filter(|view| view.health > 0.0);
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

    /// Takes a saved state in. Numbers that no play could have produced are replaced by the start's.
    pub(crate) fn restore(&mut self, state: &WorldState) {
        self.restore_player(&state.player);
        let start = state.start.as_ref();
        self.player.start = start.and_then(|it| self.restored_point(it.hemisphere, it.pos));
        self.player.round.been = state.been_round;
        self.kept.unknown = Unknown::default();
        self.player.inventory = Inventory::empty();
        for record in &state.inventory {
            if let Some(item) = Item::from_id(&record.item) {
                let count = record.count.max(1);
                self.restore_slot(record.slot, Stack { item, count });
            } else {
                self.outbox
                    .notices
                    .push(Notice::UnknownItem(record.item.clone()));
                self.kept.unknown.slots.push(record.clone());
            }
        }
        self.player.inventory.select(state.item_slot);
        self.restore_things(state);
        let seated = |number: &u32| {
            let car = usize::try_from(*number)
                .ok()
                .and_then(|number| state.cars.get(number));
            let car = car.and_then(|car| self.restored_point(car.hemisphere, car.pos));
            let away_m = |car| {
                self.world
                    .strategy
                    .distance_m(self.feet(), car, &self.head())
            };
            car.is_some_and(|car| away_m(car) <= SEATED_WITHIN_M)
        };
        let driving = state.driving.filter(seated);
        self.restore_cars(&state.cars, driving, state.car_given);
        self.set_time_of_day_s(finite_or(state.time_of_day_s, 0.0));
        self.restore_lens(state);
        let (least, most, usual) = BRUSH_RADIUS_M;
        self.player.brush_radius_m = finite_or(state.brush_radius_m, usual).clamp(least, most);
        self.world.simulated_s = finite_or(state.simulated_s, 0.0).clamp(0.0, LONGEST_PLAYED_S);
        self.kept.saved_at_s = self.world.simulated_s;
    }

    /// Puts a saved stack where it was; one without a place goes wherever there is room.
    fn restore_slot(&mut self, slot: u8, stack: Stack) {
        if slot < SLOTS && self.player.inventory.slots()[usize::from(slot)].is_none() {
            self.player.inventory.put(slot, stack);
        } else {
            self.player.inventory.give(stack.item, stack.count);
        }
    }

    fn restore_things(&mut self, state: &WorldState) {
        self.player.flashlight = state.flashlight;
        let point = |hemisphere: u8, pos: [f64; 3]| self.restored_point(hemisphere, pos);
        let lamps = state.lamps.iter().take(MOST_LAMPS);
        let lamps: Vec<_> = lamps
            .filter_map(|it| point(it.hemisphere, it.pos))
            .map(Lamp::standing)
            .collect();
        let mut unknown = Vec::new();
        let mut drops = Vec::new();
        for record in state.drops.iter().take(2 * MOST_DROPS) {
            match (
                Item::from_id(&record.item),
                point(record.hemisphere, record.pos),
            ) {
                (Some(item), Some(at)) => {
                    let count = record.count.max(1);
                    drops.push(Drop::lying(Stack { item, count }, at));
                }
                (None, _) => unknown.push(record.clone()),
                (Some(_), None) => {}
            }
        }
        let bots: Vec<_> = state
            .bots
            .iter()
            .take(MOST_BOTS)
            .filter(|it| it.yaw.is_finite())
            .filter_map(|it| point(it.hemisphere, it.pos).map(|at| (it, at)))
            .collect();
        self.actors.clear::<Lamp>();
        self.actors.clear::<Drop>();
        for lamp in lamps {
            self.actors.enter(lamp);
        }
        for drop in drops {
            self.actors.enter(drop);
        }
        let told = unknown.iter().map(|it| it.item.clone());
        self.outbox.notices.extend(told.map(Notice::UnknownItem));
        self.kept.unknown.drops = unknown;
        for (record, at) in bots {
            let health = finite_or(record.health, BOT_HEALTH).clamp(0.1, FULL_HEALTH);
            let id = self.restore_bot(at, record.yaw, record.hostile, health);
            let angry_s = finite_or(record.provoked_s, 0.0).clamp(0.0, ANGRY_S);
            self.restore_mind(id, angry_s, record.native);
        }
    }

    /// A saved place, if it is one of this world.
    pub(crate) fn restored_point(&self, hemisphere: u8, pos: [f64; 3]) -> Option<ChartPoint> {
        let pos = DVec3::from_array(pos);
        let hemisphere = if hemisphere == 1 && self.world.strategy.rim_m().is_some() {
            Hemisphere::B
        } else {
            Hemisphere::A
        };
        let at = ChartPoint::new(hemisphere, pos);
        pos.is_finite().then(|| self.within_world(at))
    }

    fn restore_lens(&mut self, state: &WorldState) {
        let map = state.map.parse().unwrap_or_else(|_| {
            self.outbox
                .notices
                .push(Notice::UnknownMap(state.map.clone()));
            HyperbolicMap::default()
        });
        let goals = DialGoals {
            raised: state.curvature,
            horizon: state.curvature_horizon,
            bend: state.bend,
        };
        self.player.lens.restore(map, state.bent, goals);
    }

    fn restore_player(&mut self, record: &PlayerRecord) {
        let numbers = record.pos.iter().chain(&record.vel).chain([
            &record.yaw,
            &record.pitch,
            &record.health,
        ]);
        if !numbers.into_iter().all(|n| n.is_finite()) {
            self.outbox.notices.push(Notice::PlayerDamaged);
            return;
        }
        let hemisphere = if record.hemisphere == 1 && self.world.strategy.rim_m().is_some() {
            Hemisphere::B
        } else {
            Hemisphere::A
        };
        let point = ChartPoint::new(hemisphere, DVec3::from_array(record.pos));
        let velocity = DVec3::from_array(record.vel).clamp_length_max(FASTEST_RESTORED_M_S);
        self.place_body(point, velocity, record.grounded);
        if let Ok((look, health)) = self
            .actors
            .ecs
            .query_one_mut::<(&mut Look, &mut Health)>(self.actors.player)
        {
            *look = Look {
                yaw: 0.0,
                pitch: 0.0,
            };
            look.turn(record.yaw, record.pitch);
            health.0 = record.health.clamp(0.0, FULL_HEALTH);
        }
        self.shown.camera = if record.third_person {
            CameraMode::Third
        } else {
            CameraMode::First
        };
        self.player.flying = record.flying;
    }

    /// Height of the ground under the player's head, in metres of the chart; `None` where none is near, or where
    /// the head is in rock with no cave below. Beyond where bodies move it is that of untouched ground, whatever
    /// happens to be loaded there.
    pub fn ground_height(&self) -> Option<f64> {
        height_below(self.head().point, GROUND_SEARCH_M, |point| {
            let density = if self.world.lets_move(ChunkCoord::containing(point)) {
                self.world.ground.density(point)
            } else {
                self.world.ground.untouched_density(point)
            };
            density < 0.0
        })
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
