//! Worlds for the tests of saves.
#![allow(dead_code, reason = "tests with programs of their own use a part")]

pub mod two;

use antipode_storage::{
    Batch, BotRecord, CHUNK_SAMPLES, CarRecord, ChunkKey, DropRecord, FixtureRecord, FlagRecord,
    LampRecord, PlaceRecord, PlayerRecord, SlotRecord, WorldMeta, WorldState,
};

/// A meta record with every field set.
pub fn meta(name: &str) -> WorldMeta {
    WorldMeta {
        name: name.to_owned(),
        seed: 0x0123_4567_89ab_cdef,
        geometry: "spherical".to_owned(),
        radius_m: 32.0,
        biome: "desert".to_owned(),
        created_unix_s: 1_700_000_000,
        last_played_unix_s: 1_700_000_600,
        played_s: 600.25,
        cheated: false,
        generator: 1,
        gathering: false,
    }
}

/// A state with every field set, its clock at `simulated_s`.
pub fn state(simulated_s: f64) -> WorldState {
    WorldState {
        player: PlayerRecord {
            chart: 1,
            pos: [1.5, -2.25, 1e6],
            vel: [0.125, -9.81, 0.0],
            yaw: 3.0,
            pitch: -0.5,
            health: 87.5,
            third_person: true,
            flying: false,
            grounded: true,
        },
        item_slot: 2,
        inventory: vec![
            SlotRecord {
                slot: 0,
                item: "gun".to_owned(),
                count: 1,
            },
            SlotRecord {
                slot: 5,
                item: "bullet".to_owned(),
                count: 64,
            },
        ],
        time_of_day_s: 43_200.5,
        map: "horizon".to_owned(),
        curvature: 12.5,
        curvature_horizon: 7.25,
        bent: true,
        bend: -3.5,
        brush_radius_m: 5.0,
        simulated_s,
        view_distance: 6,
        flashlight: true,
        lamps: vec![LampRecord {
            chart: 1,
            pos: [1.0, 2.0, -3.5],
        }],
        flags: vec![FlagRecord {
            chart: 1,
            pos: [2.0, 3.0, -4.5],
            yaw: 0.5,
            name: "Home".to_owned(),
        }],
        fixtures: vec![FixtureRecord {
            chart: 1,
            pos: [3.0, 4.0, -5.5],
            yaw: 0.25,
            name: String::new(),
            item: "lantern".to_owned(),
        }],
        drops: vec![DropRecord {
            chart: 0,
            pos: [4.0, 5.0, 6.5],
            item: "bullet".to_owned(),
            count: 3,
        }],
        bots: vec![BotRecord {
            chart: 1,
            pos: [7.0, 8.0, 9.5],
            yaw: 0.75,
            health: 2.0,
            hostile: true,
            provoked_s: 4.5,
            native: true,
        }],
        cars: vec![CarRecord {
            chart: 0,
            pos: [10.0, 11.0, 12.5],
            turn: [0.0, 0.6, 0.0, 0.8],
            vel: [1.0, -2.0, 3.5],
            spin: [0.25, 0.5, -0.75],
            lights: true,
            steer: -0.25,
            springs: [0.125, 0.0, 0.25, 0.0625],
            rests: false,
        }],
        driving: Some(0),
        car_given: true,
        start: Some(PlaceRecord {
            chart: 1,
            pos: [13.0, 14.0, 15.5],
        }),
        been_round: true,
    }
}

/// The chunk `x` chunks along x in hemisphere A.
pub fn key(x: i32) -> ChunkKey {
    ChunkKey {
        chart: 0,
        x,
        y: -1,
        z: 3,
    }
}

/// Edits that tell which chunk and which commit they are of.
pub fn samples(x: i32, commit: i32) -> Vec<i16> {
    let sample = |i: usize| {
        if i % 64 < 20 {
            ((x * 31 + commit * 7) as i16).wrapping_add(i as i16)
        } else {
            0
        }
    };
    (0..CHUNK_SAMPLES).map(sample).collect()
}

/// A batch that writes the chunks `0..chunks` and the state, all marked with `commit`.
pub fn batch(chunks: i32, commit: i32) -> Batch {
    Batch {
        meta: None,
        records: (&state(f64::from(commit))).into(),
        chunks: (0..chunks).map(|x| (key(x), samples(x, commit))).collect(),
        kinds: std::collections::BTreeMap::new(),
    }
}
