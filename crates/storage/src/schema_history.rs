//! The shapes of stored values that have changed since they were first written, and their way to the next version.
//! No shape in here ever changes again. A struct in a struct is stored as its fields would be.

/// Version 1 knew one picture of each space.
pub(crate) mod v1 {
    use serde::{Deserialize, Serialize};

    use super::v3;
    use crate::schema::{PlayerRecord, SlotRecord};

    /// What version 1 kept of everything that changes while a world is played.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub(crate) struct WorldState {
        pub player: PlayerRecord,
        pub item_slot: u8,
        pub inventory: Vec<SlotRecord>,
        pub time_of_day_s: f64,
        pub curvature: f64,
        pub brush_radius_m: f64,
        pub simulated_s: f64,
        pub view_distance: u32,
    }

    impl From<WorldState> for v3::WorldState {
        fn from(old: WorldState) -> Self {
            Self {
                player: old.player,
                item_slot: old.item_slot,
                inventory: old.inventory,
                time_of_day_s: old.time_of_day_s,
                map: "raised".to_owned(),
                curvature: old.curvature,
                // Where the dial of a new world stands.
                curvature_horizon: 10.0,
                bent: false,
                bend: 0.0,
                brush_radius_m: old.brush_radius_m,
                simulated_s: old.simulated_s,
                view_distance: old.view_distance,
            }
        }
    }
}

/// Version 2 knew nothing of commands that cheat.
pub(crate) mod v2 {
    use serde::{Deserialize, Serialize};

    use super::v8;

    /// What versions 1 and 2 kept of what a world is.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub(crate) struct WorldMeta {
        pub name: String,
        pub seed: u64,
        pub geometry: String,
        pub radius_m: f64,
        pub biome: String,
        pub created_unix_s: u64,
        pub last_played_unix_s: u64,
        pub played_s: f64,
    }

    impl From<WorldMeta> for v8::WorldMeta {
        fn from(old: WorldMeta) -> Self {
            Self {
                name: old.name,
                seed: old.seed,
                geometry: old.geometry,
                radius_m: old.radius_m,
                biome: old.biome,
                created_unix_s: old.created_unix_s,
                last_played_unix_s: old.last_played_unix_s,
                played_s: old.played_s,
                cheated: false,
            }
        }
    }
}

/// Version 3 knew three pickaxes in the hotbar, and nothing that stands or lies about.
pub(crate) mod v3 {
    use serde::{Deserialize, Serialize};

    use super::v4;
    use crate::schema::{PlayerRecord, SlotRecord};

    /// What a new player of version 4 has and one of version 3 could not have: the slot, the item and how many.
    const NEW_AT_START: [(u8, &str, u32); 3] = [(0, "gun", 1), (4, "bullet", 64), (5, "lamp", 10)];
    /// Slots of version 4.
    const SLOTS: u8 = 40;

    /// What versions 2 and 3 kept of everything that changes while a world is played.
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
    }

    impl From<WorldState> for v4::WorldState {
        /// What there was stays; what is new and was not there is added where it would be at the start, or in the next
        /// free slot.
        fn from(old: WorldState) -> Self {
            let mut inventory = old.inventory;
            for (slot, item, count) in NEW_AT_START {
                if inventory.iter().any(|record| record.item == item) {
                    continue;
                }
                let is_free = |slot: &u8| inventory.iter().all(|record| record.slot != *slot);
                let place = std::iter::once(slot).chain(0..SLOTS).find(is_free);
                if let Some(slot) = place {
                    let item = item.to_owned();
                    inventory.push(SlotRecord { slot, item, count });
                }
            }
            Self {
                before: WorldState { inventory, ..old },
                flashlight: false,
                lamps: Vec::new(),
                drops: Vec::new(),
                bots: Vec::new(),
            }
        }
    }

    #[cfg(test)]
    mod tests {
        use super::*;

        #[test]
        fn who_played_version_3_keeps_everything_and_gets_what_is_new() {
            let record = |slot, item: &str| SlotRecord {
                slot,
                item: item.to_owned(),
                count: 1,
            };
            let old = WorldState {
                player: PlayerRecord::default(),
                item_slot: 1,
                inventory: vec![record(0, "pickaxe-wood"), record(4, "pickaxe-iron")],
                time_of_day_s: 60.0,
                map: "raised".to_owned(),
                curvature: 12.5,
                curvature_horizon: 10.0,
                bent: false,
                bend: 0.0,
                brush_radius_m: 4.0,
                simulated_s: 7.0,
                view_distance: 5,
            };
            let state = v4::WorldState::from(old);
            let slots: Vec<_> = state
                .before
                .inventory
                .iter()
                .map(|it| (it.slot, it.item.as_str(), it.count))
                .collect();
            let expected = [
                (0, "pickaxe-wood", 1),
                (4, "pickaxe-iron", 1),
                (1, "gun", 1),
                (2, "bullet", 64),
                (5, "lamp", 10),
            ];
            assert_eq!(slots, expected);
        }
    }
}

/// Version 4 knew no cars, and nobody in it calmed down.
pub(crate) mod v4 {
    use serde::{Deserialize, Serialize};

    use super::{v3, v5};
    use crate::schema::{self, DropRecord, LampRecord};

    /// What version 4 kept of a figure that nobody plays.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub(crate) struct BotRecord {
        pub chart: u8,
        pub pos: [f64; 3],
        pub yaw: f64,
        pub health: f64,
        pub hostile: bool,
    }

    /// What version 4 kept of everything that changes while a world is played.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub(crate) struct WorldState {
        /// What version 3 had, which is stored first.
        pub before: v3::WorldState,
        pub flashlight: bool,
        pub lamps: Vec<LampRecord>,
        pub drops: Vec<DropRecord>,
        pub bots: Vec<BotRecord>,
    }

    impl From<BotRecord> for schema::BotRecord {
        fn from(old: BotRecord) -> Self {
            Self {
                chart: old.chart.into(),
                pos: old.pos,
                yaw: old.yaw,
                health: old.health,
                hostile: old.hostile,
                provoked_s: 0.0,
                native: false,
            }
        }
    }

    impl From<WorldState> for v5::WorldState {
        /// The world gets its first car when it is opened.
        fn from(old: WorldState) -> Self {
            Self {
                before: old.before,
                flashlight: old.flashlight,
                lamps: old.lamps,
                drops: old.drops,
                bots: old.bots.into_iter().map(Into::into).collect(),
                cars: Vec::new(),
                driving: None,
                car_given: false,
            }
        }
    }
}

/// Version 5 began every world where its land alone decides, and knew nobody who had gone round it.
pub(crate) mod v5 {
    use serde::{Deserialize, Serialize};

    use super::v3;
    use crate::schema::{self, BotRecord, CarRecord, DropRecord, LampRecord};

    /// What version 5 kept of everything that changes while a world is played.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub(crate) struct WorldState {
        /// What version 3 had, which is stored first.
        pub before: v3::WorldState,
        pub flashlight: bool,
        pub lamps: Vec<LampRecord>,
        pub drops: Vec<DropRecord>,
        pub bots: Vec<BotRecord>,
        pub cars: Vec<CarRecord>,
        pub driving: Option<u32>,
        pub car_given: bool,
    }

    impl From<WorldState> for schema::WorldState {
        fn from(old: WorldState) -> Self {
            let before = old.before;
            Self {
                player: before.player,
                item_slot: before.item_slot,
                inventory: before.inventory,
                time_of_day_s: before.time_of_day_s,
                map: before.map,
                curvature: before.curvature,
                curvature_horizon: before.curvature_horizon,
                bent: before.bent,
                bend: before.bend,
                brush_radius_m: before.brush_radius_m,
                simulated_s: before.simulated_s,
                view_distance: before.view_distance,
                flashlight: old.flashlight,
                lamps: old.lamps,
                flags: Vec::new(),
                fixtures: Vec::new(),
                drops: old.drops,
                bots: old.bots,
                cars: old.cars,
                driving: old.driving,
                car_given: old.car_given,
                start: None,
                been_round: false,
            }
        }
    }
}

/// Version 8 knew one generator of land.
pub(crate) mod v8 {
    use serde::{Deserialize, Serialize};

    use super::v9;
    use crate::schema::FIRST_GENERATOR;

    /// What versions 3 to 8 kept of what a world is.
    #[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
    pub(crate) struct WorldMeta {
        pub name: String,
        pub seed: u64,
        pub geometry: String,
        pub radius_m: f64,
        pub biome: String,
        pub created_unix_s: u64,
        pub last_played_unix_s: u64,
        pub played_s: f64,
        pub cheated: bool,
    }

    impl From<WorldMeta> for v9::WorldMeta {
        fn from(old: WorldMeta) -> Self {
            Self {
                name: old.name,
                seed: old.seed,
                geometry: old.geometry,
                radius_m: old.radius_m,
                biome: old.biome,
                created_unix_s: old.created_unix_s,
                last_played_unix_s: old.last_played_unix_s,
                played_s: old.played_s,
                cheated: old.cheated,
                generator: FIRST_GENERATOR,
            }
        }
    }
}

/// Version 9 knew no worlds in which ground is gathered.
pub(crate) mod v9 {
    use serde::{Deserialize, Serialize};

    use crate::schema;

    /// What version 9 kept of what a world is.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub(crate) struct WorldMeta {
        pub name: String,
        pub seed: u64,
        pub geometry: String,
        pub radius_m: f64,
        pub biome: String,
        pub created_unix_s: u64,
        pub last_played_unix_s: u64,
        pub played_s: f64,
        pub cheated: bool,
        pub generator: u16,
    }

    impl From<WorldMeta> for schema::WorldMeta {
        fn from(old: WorldMeta) -> Self {
            Self {
                name: old.name,
                seed: old.seed,
                geometry: old.geometry,
                radius_m: old.radius_m,
                biome: old.biome,
                created_unix_s: old.created_unix_s,
                last_played_unix_s: old.last_played_unix_s,
                played_s: old.played_s,
                cheated: old.cheated,
                generator: old.generator,
                gathering: false,
            }
        }
    }
}
