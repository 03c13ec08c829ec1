//! Every version of every stored value, and the way from an old one to today's.
//!
//! The structs below are today's shapes and are stored field by field in their
//! order, without names: changing a field, its type or its place is a new schema
//! version. To make one: copy the struct as it was into `schema_history.rs`, raise
//! [`SCHEMA_VERSION`], and let [`Versioned::upgrade`] decode the old shape and
//! convert it. `tests/saves` keeps a world of each version for ever.

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use crate::codec::{self, Fault, Kind, Record};
use crate::schema_history::{v1, v2, v3, v4, v5};

/// The schema version this build writes.
pub const SCHEMA_VERSION: u16 = 6;

/// What a world is: fixed at its creation, but for the name and the times.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct WorldMeta {
    /// The name the player gave, printable, 1 to 40 characters.
    pub name: String,
    /// Seed of the terrain.
    pub seed: u64,
    /// `euclidean`, `hyperbolic` or `spherical`.
    pub geometry: String,
    /// Radius of curvature in metres; 0 or infinite in a flat world.
    pub radius_m: f64,
    /// The biome's identifier, empty if it follows from the seed.
    pub biome: String,
    /// When the world was made, seconds since 1970 UTC.
    pub created_unix_s: u64,
    /// When it was last played, seconds since 1970 UTC.
    pub last_played_unix_s: u64,
    /// Time spent in it, seconds.
    pub played_s: f64,
    /// Whether a command that cheats was ever used in it.
    pub cheated: bool,
}

/// The player's body.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct PlayerRecord {
    /// Hemisphere: 0 for A, 1 for B.
    pub hemisphere: u8,
    /// Feet, chart metres.
    pub pos: [f64; 3],
    /// Velocity, metres per second.
    pub vel: [f64; 3],
    /// Heading, radians.
    pub yaw: f64,
    /// Elevation of the view, radians.
    pub pitch: f64,
    /// Health, 0 to 100.
    pub health: f64,
    /// Whether the view is from behind.
    pub third_person: bool,
    /// Whether the spectator's flight is on.
    pub flying: bool,
    /// Whether the feet stood on something.
    pub grounded: bool,
}

/// One filled slot of the inventory.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct SlotRecord {
    /// Which slot, 0 is the first.
    pub slot: u8,
    /// The item's identifier, such as `pickaxe-iron`.
    pub item: String,
    /// How many.
    pub count: u32,
}

/// A lamp that was put down.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct LampRecord {
    /// Hemisphere: 0 for A, 1 for B.
    pub hemisphere: u8,
    /// Its foot, chart metres.
    pub pos: [f64; 3],
}

/// A stack that lies about.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct DropRecord {
    /// Hemisphere: 0 for A, 1 for B.
    pub hemisphere: u8,
    /// Its middle, chart metres.
    pub pos: [f64; 3],
    /// The item's identifier.
    pub item: String,
    /// How many.
    pub count: u32,
}

/// A figure that nobody plays.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct BotRecord {
    /// Hemisphere: 0 for A, 1 for B.
    pub hemisphere: u8,
    /// Feet, chart metres.
    pub pos: [f64; 3],
    /// Heading, radians.
    pub yaw: f64,
    /// Its health.
    pub health: f64,
    /// Whether it fights the player.
    pub hostile: bool,
    /// For how long yet a peaceful one that was provoked fights, seconds.
    pub provoked_s: f64,
    /// Whether it came by itself, and may go so.
    pub native: bool,
}

/// A car.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct CarRecord {
    /// Hemisphere: 0 for A, 1 for B.
    pub hemisphere: u8,
    /// The ground below its middle when it stands on level ground, chart metres.
    pub pos: [f64; 3],
    /// How it is turned from facing along +x, a unit quaternion x, y, z, w of the chart.
    pub turn: [f64; 4],
    /// Velocity, metres per second.
    pub vel: [f64; 3],
    /// Angular velocity, radians per second.
    pub spin: [f64; 3],
    /// Whether its lights are on.
    pub lights: bool,
    /// How far its front wheels are turned to the right, radians.
    pub steer: f64,
    /// How far each spring is pushed in, metres; zero in the air.
    pub springs: [f64; 4],
    /// Whether it has come to rest.
    pub rests: bool,
}

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

/// A place.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct PlaceRecord {
    /// Hemisphere: 0 for A, 1 for B.
    pub hemisphere: u8,
    /// Chart metres.
    pub pos: [f64; 3],
}

/// Which chunk: its hemisphere (0 for A, 1 for B) and its index in chunks.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default, Serialize, Deserialize,
)]
pub struct ChunkKey {
    /// Hemisphere: 0 for A, 1 for B.
    pub hemisphere: u8,
    /// Index along x.
    pub x: i32,
    /// Index along y (up).
    pub y: i32,
    /// Index along z.
    pub z: i32,
}

impl ChunkKey {
    /// Length of [`Self::to_bytes`].
    pub(crate) const BYTES: usize = 13;

    /// A key whose order as bytes is the order of `ChunkKey`: big-endian with the
    /// sign flipped, so that neighbours along z lie side by side in the store.
    pub(crate) fn to_bytes(self) -> [u8; Self::BYTES] {
        let mut bytes = [0; Self::BYTES];
        bytes[0] = self.hemisphere;
        for (slot, index) in bytes[1..].chunks_exact_mut(4).zip([self.x, self.y, self.z]) {
            slot.copy_from_slice(&((index as u32) ^ 0x8000_0000).to_be_bytes());
        }
        bytes
    }

    /// The inverse of [`Self::to_bytes`]; `None` for any other length.
    pub(crate) fn from_bytes(bytes: &[u8]) -> Option<Self> {
        let (&hemisphere, rest) = bytes.split_first()?;
        let (words, []) = rest.as_chunks::<4>() else {
            return None;
        };
        let &[x, y, z] = words else { return None };
        let index = |word| (u32::from_be_bytes(word) ^ 0x8000_0000) as i32;
        Some(Self {
            hemisphere,
            x: index(x),
            y: index(y),
            z: index(z),
        })
    }
}

impl std::fmt::Display for ChunkKey {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let chart = if self.hemisphere == 0 { 'A' } else { 'B' };
        write!(f, "chunk {chart} ({}, {}, {})", self.x, self.y, self.z)
    }
}

/// Why a stored value could not be turned into today's shape.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum SchemaFault {
    /// Written by a newer game.
    Newer(u16),
    /// Not what was written: a checksum, a shape or a key is wrong.
    Damaged(String),
}

impl From<Fault> for SchemaFault {
    fn from(fault: Fault) -> Self {
        Self::Damaged(fault.to_string())
    }
}

/// A stored value with a history of shapes.
pub(crate) trait Versioned: Sized {
    /// What the record is marked as.
    const KIND: Kind;
    /// The newest version this build knows.
    const VERSION: u16 = SCHEMA_VERSION;

    /// Decodes a body of `version`, which is in `1..=VERSION`, and brings it up to today.
    fn upgrade(version: u16, body: &[u8]) -> Result<Self, SchemaFault>;
}

impl Versioned for WorldMeta {
    const KIND: Kind = Kind::Meta;

    fn upgrade(version: u16, body: &[u8]) -> Result<Self, SchemaFault> {
        match version {
            1 | 2 => decode::<v2::WorldMeta>(body).map(Self::from),
            _ => decode(body),
        }
    }
}

impl Versioned for WorldState {
    const KIND: Kind = Kind::State;

    fn upgrade(version: u16, body: &[u8]) -> Result<Self, SchemaFault> {
        match version {
            1 => decode::<v1::WorldState>(body)
                .map(v3::WorldState::from)
                .map(v4::WorldState::from)
                .map(v5::WorldState::from)
                .map(Self::from),
            2 | 3 => decode::<v3::WorldState>(body)
                .map(v4::WorldState::from)
                .map(v5::WorldState::from)
                .map(Self::from),
            4 => decode::<v4::WorldState>(body)
                .map(v5::WorldState::from)
                .map(Self::from),
            5 => decode::<v5::WorldState>(body).map(Self::from),
            _ => decode(body),
        }
    }
}

/// A chunk's edits as stored; see [`crate::chunk_codec`].
pub(crate) struct ChunkBody(pub Vec<i16>);

impl Versioned for ChunkBody {
    const KIND: Kind = Kind::Chunk;

    fn upgrade(_version: u16, body: &[u8]) -> Result<Self, SchemaFault> {
        Ok(Self(
            crate::chunk_codec::unpack_chunk(body).map_err(SchemaFault::Damaged)?,
        ))
    }
}

fn decode<T: DeserializeOwned>(body: &[u8]) -> Result<T, SchemaFault> {
    codec::decode(body).map_err(SchemaFault::from)
}

/// Checks that a record is of `T`, stored under `key`, of a version we know.
pub(crate) fn check<T: Versioned>(record: &Record<'_>, key: &[u8]) -> Result<(), SchemaFault> {
    if record.version > T::VERSION {
        return Err(SchemaFault::Newer(record.version));
    }
    if record.version == 0 {
        return Err(SchemaFault::Damaged(
            "its schema version 0 was never used".to_owned(),
        ));
    }
    if record.kind != T::KIND || record.key != key {
        return Err(SchemaFault::Damaged("it belongs somewhere else".to_owned()));
    }
    Ok(())
}

/// Reads a sealed value stored under `key`: seal, version, kind, key, then the body.
pub(crate) fn read<T: Versioned>(bytes: &[u8], key: &[u8]) -> Result<T, SchemaFault> {
    let record = codec::unseal(bytes)?;
    check::<T>(&record, key)?;
    T::upgrade(record.version, record.body)
}

#[cfg(test)]
mod tests;
