//! Version 6 kept all but the land in one value, and a chart as one byte.

use serde::{Deserialize, Serialize};

use crate::schema::{self, SlotRecord};

/// What versions up to 6 kept of it, with the chart as one byte.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(Default))]
pub(crate) struct PlayerRecord {
    pub hemisphere: u8,
    pub pos: [f64; 3],
    pub vel: [f64; 3],
    pub yaw: f64,
    pub pitch: f64,
    pub health: f64,
    pub third_person: bool,
    pub flying: bool,
    pub grounded: bool,
}

impl From<PlayerRecord> for schema::PlayerRecord {
    fn from(old: PlayerRecord) -> Self {
        Self {
            hemisphere: old.hemisphere,
            pos: old.pos,
            vel: old.vel,
            yaw: old.yaw,
            pitch: old.pitch,
            health: old.health,
            third_person: old.third_person,
            flying: old.flying,
            grounded: old.grounded,
        }
    }
}

/// What versions up to 6 kept of it, with the chart as one byte.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct LampRecord {
    pub hemisphere: u8,
    pub pos: [f64; 3],
}

impl From<LampRecord> for schema::LampRecord {
    fn from(old: LampRecord) -> Self {
        Self {
            hemisphere: old.hemisphere,
            pos: old.pos,
        }
    }
}

/// What versions up to 6 kept of it, with the chart as one byte.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct DropRecord {
    pub hemisphere: u8,
    pub pos: [f64; 3],
    pub item: String,
    pub count: u32,
}

impl From<DropRecord> for schema::DropRecord {
    fn from(old: DropRecord) -> Self {
        Self {
            hemisphere: old.hemisphere,
            pos: old.pos,
            item: old.item,
            count: old.count,
        }
    }
}

/// What versions up to 6 kept of it, with the chart as one byte.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct BotRecord {
    pub hemisphere: u8,
    pub pos: [f64; 3],
    pub yaw: f64,
    pub health: f64,
    pub hostile: bool,
    pub provoked_s: f64,
    pub native: bool,
}

impl From<BotRecord> for schema::BotRecord {
    fn from(old: BotRecord) -> Self {
        Self {
            hemisphere: old.hemisphere,
            pos: old.pos,
            yaw: old.yaw,
            health: old.health,
            hostile: old.hostile,
            provoked_s: old.provoked_s,
            native: old.native,
        }
    }
}

/// What versions up to 6 kept of it, with the chart as one byte.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct CarRecord {
    pub hemisphere: u8,
    pub pos: [f64; 3],
    pub turn: [f64; 4],
    pub vel: [f64; 3],
    pub spin: [f64; 3],
    pub lights: bool,
    pub steer: f64,
    pub springs: [f64; 4],
    pub rests: bool,
}

impl From<CarRecord> for schema::CarRecord {
    fn from(old: CarRecord) -> Self {
        Self {
            hemisphere: old.hemisphere,
            pos: old.pos,
            turn: old.turn,
            vel: old.vel,
            spin: old.spin,
            lights: old.lights,
            steer: old.steer,
            springs: old.springs,
            rests: old.rests,
        }
    }
}

/// What versions up to 6 kept of it, with the chart as one byte.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct PlaceRecord {
    pub hemisphere: u8,
    pub pos: [f64; 3],
}

impl From<PlaceRecord> for schema::PlaceRecord {
    fn from(old: PlaceRecord) -> Self {
        Self {
            hemisphere: old.hemisphere,
            pos: old.pos,
        }
    }
}

/// What version 6 kept of everything that changes while a world is played, as one value.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct WorldState {
    pub player: PlayerRecord,
    pub item_slot: u8,
    pub inventory: Vec<SlotRecord>,
    pub time_of_day_s: f64,
    pub map: String,
    pub curvature: f64,
    pub curvature_horizon: f64,
    pub bent: bool,
    pub bend: f64,
    pub brush_radius_m: f64,
    pub simulated_s: f64,
    pub view_distance: u32,
    pub flashlight: bool,
    pub lamps: Vec<LampRecord>,
    pub drops: Vec<DropRecord>,
    pub bots: Vec<BotRecord>,
    pub cars: Vec<CarRecord>,
    pub driving: Option<u32>,
    pub car_given: bool,
    pub start: Option<PlaceRecord>,
    pub been_round: bool,
}

impl From<WorldState> for schema::WorldState {
    fn from(old: WorldState) -> Self {
        Self {
            player: old.player.into(),
            item_slot: old.item_slot,
            inventory: old.inventory,
            time_of_day_s: old.time_of_day_s,
            map: old.map,
            curvature: old.curvature,
            curvature_horizon: old.curvature_horizon,
            bent: old.bent,
            bend: old.bend,
            brush_radius_m: old.brush_radius_m,
            simulated_s: old.simulated_s,
            view_distance: old.view_distance,
            flashlight: old.flashlight,
            lamps: old.lamps.into_iter().map(Into::into).collect(),
            drops: old.drops.into_iter().map(Into::into).collect(),
            bots: old.bots.into_iter().map(Into::into).collect(),
            cars: old.cars.into_iter().map(Into::into).collect(),
            driving: old.driving,
            car_given: old.car_given,
            start: old.start.map(Into::into),
            been_round: old.been_round,
        }
    }
}
