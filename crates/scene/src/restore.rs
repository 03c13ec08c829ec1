//! From a save to the scene: what is stored of a world comes back, and numbers that no play could have produced are
//! replaced by the start's. What is not taken in stays in the save as it is.

use std::collections::BTreeMap;

use antipode_geometry::{ChartPoint, ChunkCoord, Hemisphere, HyperbolicMap};
use antipode_storage::{
    BotRecord, CourseRecord, DropRecord, PlayerKept, PlayerRecord, Record, RecordKey, RecordKind,
    Records, ViewRecord,
};
use glam::DVec3;

use crate::camera::CameraMode;
use crate::car::tuning::MOST_CARS;
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
const LONGEST_PLAYED_S: f64 = 1e10;
/// A driver who is farther from the car in the save, in metres, does not sit in it.
const SEATED_WITHIN_M: f64 = 8.0;

/// Depth below the player's head searched for ground, in metres.
pub(crate) const GROUND_SEARCH_M: f64 = 128.0;

impl Scene {
    /// Takes what a save holds in. Of a world whose course is damaged, or that nobody has played, it is known how long
    /// it was played, in seconds.
    pub(crate) fn restore(&mut self, records: Records, played_s: f64) {
        if let Some(kept) = records.player() {
            self.restore_player(kept);
        }
        let driving = records.player().and_then(|kept| kept.driving);
        let mut course = CourseRecord {
            time_of_day_s: self.world.time_of_day_s,
            simulated_s: played_s,
            car_given: false,
        };
        if records.unknown > 0 {
            let notice = Notice::UnknownRecords(records.unknown);
            self.outbox.notices.push(notice);
        }
        let mut seen = BTreeMap::<_, usize>::new();
        for (key, record) in records.known {
            let seen = seen.entry(key.kind).or_default();
            *seen += 1;
            if let Record::Course(it) = &record {
                course = it.clone();
            }
            if *seen <= most(key.kind) && self.restore_record(key, &record) {
                self.kept.handed.insert(key, record);
            }
        }
        for (kind, last) in records.last {
            self.number_next(kind.numbered(last + 1));
        }
        self.restore_seat(driving);
        // Not before: the minds of figures begin at the time of a world that was just opened.
        self.restore_course(&course);
    }

    /// Takes one thing in; false for what is not to be.
    fn restore_record(&mut self, key: RecordKey, record: &Record) -> bool {
        self.number_next(key);
        match record {
            Record::Player(_) => key.id == 0,
            Record::Course(_) => true,
            Record::View(it) => {
                self.restore_view(it);
                true
            }
            Record::Lamp(it) => {
                let at = self.restored_point(it.hemisphere, it.pos);
                at.map(|at| self.actors.enter(Lamp::standing(at))).is_some()
            }
            Record::Drop(it) => self.restore_drop(it),
            Record::Figure(it) => self.restore_figure(it),
            Record::Car(it) => self.restore_car(it),
        }
    }

    /// Says which number the next of a kind gets.
    fn number_next(&mut self, key: RecordKey) {
        match key.kind {
            RecordKind::Player | RecordKind::Course | RecordKind::View => {}
            RecordKind::Lamp => self.actors.number_next::<Lamp>(key.id),
            RecordKind::Drop => self.actors.number_next::<Drop>(key.id),
            RecordKind::Figure => self.actors.next_bot = key.id,
            RecordKind::Car => self.actors.cars.next = key.id,
        }
    }

    fn restore_player(&mut self, kept: &PlayerKept) {
        self.restore_body(&kept.body);
        let start = kept.start.as_ref();
        self.player.start = start.and_then(|it| self.restored_point(it.hemisphere, it.pos));
        self.player.round.been = kept.been_round;
        self.player.inventory = Inventory::empty();
        for record in &kept.inventory {
            if let Some(item) = Item::from_id(&record.item) {
                let count = record.count.max(1);
                self.restore_slot(record.slot, Stack { item, count });
            } else {
                self.tell_unknown_item(&record.item);
                self.kept.unknown_slots.push(record.clone());
            }
        }
        self.player.inventory.select(kept.item_slot);
        self.player.flashlight = kept.flashlight;
        let (least, most, usual) = BRUSH_RADIUS_M;
        self.player.brush_radius_m = finite_or(kept.brush_radius_m, usual).clamp(least, most);
    }

    fn tell_unknown_item(&mut self, item: &str) {
        let notice = Notice::UnknownItem(item.to_owned());
        self.outbox.notices.push(notice);
    }

    /// Puts a saved stack where it was; one without a place goes wherever there is room.
    fn restore_slot(&mut self, slot: u8, stack: Stack) {
        if slot < SLOTS && self.player.inventory.slots()[usize::from(slot)].is_none() {
            self.player.inventory.put(slot, stack);
        } else {
            self.player.inventory.give(stack.item, stack.count);
        }
    }

    fn restore_drop(&mut self, record: &DropRecord) -> bool {
        let Some(item) = Item::from_id(&record.item) else {
            self.tell_unknown_item(&record.item);
            return false;
        };
        let Some(at) = self.restored_point(record.hemisphere, record.pos) else {
            return false;
        };
        let count = record.count.max(1);
        self.actors.enter(Drop::lying(Stack { item, count }, at));
        true
    }

    fn restore_figure(&mut self, record: &BotRecord) -> bool {
        let at = self.restored_point(record.hemisphere, record.pos);
        let Some(at) = at.filter(|_| record.yaw.is_finite()) else {
            return false;
        };
        let health = finite_or(record.health, BOT_HEALTH).clamp(0.1, FULL_HEALTH);
        let id = self.restore_bot(at, record.yaw, record.hostile, health);
        let angry_s = finite_or(record.provoked_s, 0.0).clamp(0.0, ANGRY_S);
        self.restore_mind(id, angry_s, record.native);
        true
    }

    fn restore_seat(&mut self, driving: Option<u32>) {
        let Some(number) = driving.and_then(|id| self.actors.cars.number_of(id)) else {
            return;
        };
        let away_m = self.car(number).map(|car| {
            let strategy = &self.world.strategy;
            strategy.distance_m(self.feet(), car.point, &self.head())
        });
        if away_m.is_some_and(|away_m| away_m <= SEATED_WITHIN_M) {
            self.take_wheel(number);
        }
    }

    fn restore_course(&mut self, course: &CourseRecord) {
        self.actors.cars.given = course.car_given;
        self.set_time_of_day_s(finite_or(course.time_of_day_s, 0.0));
        self.world.simulated_s = finite_or(course.simulated_s, 0.0).clamp(0.0, LONGEST_PLAYED_S);
        self.kept.saved_at_s = self.world.simulated_s;
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

    fn restore_view(&mut self, record: &ViewRecord) {
        let map = record.map.parse().unwrap_or_else(|_| {
            let notice = Notice::UnknownMap(record.map.clone());
            self.outbox.notices.push(notice);
            HyperbolicMap::default()
        });
        let goals = DialGoals {
            raised: record.curvature,
            horizon: record.curvature_horizon,
            bend: record.bend,
        };
        self.player.lens.restore(map, record.bent, goals);
    }

    fn restore_body(&mut self, record: &PlayerRecord) {
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

/// How many of a kind are taken in.
fn most(kind: RecordKind) -> usize {
    match kind {
        RecordKind::Player | RecordKind::Course | RecordKind::View => 1,
        RecordKind::Lamp => MOST_LAMPS,
        RecordKind::Drop => 2 * MOST_DROPS,
        RecordKind::Figure => MOST_BOTS,
        RecordKind::Car => MOST_CARS,
    }
}

fn finite_or(value: f64, otherwise: f64) -> f64 {
    if value.is_finite() { value } else { otherwise }
}
