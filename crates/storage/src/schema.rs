//! Every version of every stored value, and the way from an old one to today's.
//!
//! The structs below are today's shapes and are stored field by field in their
//! order, without names: changing a field, its type or its place is a new schema
//! version. To make one: copy the struct as it was into `schema_history.rs`, raise
//! [`SCHEMA_VERSION`], and let [`Versioned::upgrade`] decode the old shape and
//! convert it. `tests/saves` keeps a world of each version for ever.
//!
//! Records of things have versions of their own, each kind for itself: see `record.rs`.

use serde::de::{DeserializeOwned, Error};
use serde::{Deserialize, Deserializer, Serialize};

use crate::codec::{self, Fault, Kind, Record};
use crate::schema_history::{v1, v2, v3, v4, v5};

pub use crate::record_shapes::{
    BotRecord, CarRecord, CourseRecord, DropRecord, LampRecord, PlaceRecord, PlayerKept,
    PlayerRecord, SlotRecord, ViewRecord,
};
pub use crate::state::WorldState;

/// The schema version this build writes.
pub const SCHEMA_VERSION: u16 = 7;
/// The last version that kept the state as one value.
const LAST_OF_ONE_STATE: u16 = 6;

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

/// Which chunk: its hemisphere (0 for A, 1 for B) and its index in chunks.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default, Serialize, Deserialize,
)]
pub struct ChunkKey {
    /// Chart: 0 for A, 1 for B.
    pub chart: u8,
    /// Index along x.
    pub x: i32,
    /// Index along y (up).
    pub y: i32,
    /// Index along z.
    pub z: i32,
}

impl ChunkKey {
    /// Length of [`Self::to_bytes`].
    pub(crate) const BYTES: usize = 1 + Self::INDEX_BYTES;
    /// Bytes of the three indices.
    const INDEX_BYTES: usize = 12;

    /// A key whose order as bytes is the order of `ChunkKey`: big-endian with the
    /// sign flipped, so that neighbours along z lie side by side in the store.
    pub(crate) fn to_bytes(self) -> [u8; Self::BYTES] {
        let mut bytes = [0; Self::BYTES];
        bytes[0] = self.chart;
        for (slot, index) in bytes[1..].chunks_exact_mut(4).zip([self.x, self.y, self.z]) {
            slot.copy_from_slice(&((index as u32) ^ 0x8000_0000).to_be_bytes());
        }
        bytes
    }

    /// The inverse of [`Self::to_bytes`]; `None` for any other length.
    pub(crate) fn from_bytes(bytes: &[u8]) -> Option<Self> {
        let (&chart, rest) = bytes.split_first()?;
        let (words, []) = rest.as_chunks::<4>() else {
            return None;
        };
        let &[x, y, z] = words else { return None };
        let index = |word| (u32::from_be_bytes(word) ^ 0x8000_0000) as i32;
        Some(Self {
            chart,
            x: index(x),
            y: index(y),
            z: index(z),
        })
    }

    /// Whether bytes are the key of a chunk of a chart with a name, which only a later game knows: the chart as in
    /// [`chart`], then the indices. It is longer than any key of the two hemispheres.
    pub(crate) fn is_of_named_chart(bytes: &[u8]) -> bool {
        bytes.split_first().is_some_and(|(&length, rest)| {
            let length = usize::from(length);
            (2..=MAX_CHART_BYTES).contains(&length) && rest.len() == length + Self::INDEX_BYTES
        })
    }
}

/// The longest name of a chart: four coordinates of two integers of 128 bits each, and some more.
const MAX_CHART_BYTES: usize = 144;

/// Reads a chart as it is stored: the byte 0 or 1 for hemisphere A or B. A larger one is the length of a name, which
/// follows; fails for such, since this version knows no such chart.
pub(crate) fn chart<'a, D: Deserializer<'a>>(from: D) -> Result<u8, D::Error> {
    match u8::deserialize(from)? {
        chart @ (0 | 1) => Ok(chart),
        _ => Err(D::Error::custom("a chart that this version does not know")),
    }
}

impl std::fmt::Display for ChunkKey {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let chart = if self.chart == 0 { 'A' } else { 'B' };
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

/// What worlds up to version 6 kept as one value: read, never written.
impl Versioned for WorldState {
    const KIND: Kind = Kind::State;
    const VERSION: u16 = LAST_OF_ONE_STATE;

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
