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
use crate::schema_history::{v1, v2, v3, v4, v5, v6};

pub use crate::record_shapes::{
    BotRecord, CarRecord, CourseRecord, DropRecord, LampRecord, PlaceRecord, PlayerKept,
    PlayerRecord, SlotRecord, ViewRecord,
};
pub use crate::state::WorldState;

/// The schema version this build writes.
pub const SCHEMA_VERSION: u16 = 7;
/// The last version that kept the state as one value, and chunks under keys of one width.
pub(crate) const LAST_OF_ONE_STATE: u16 = 6;

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
    /// Length of the keys of worlds up to version 6: the hemisphere and three indices.
    pub(crate) const OLD_BYTES: usize = 13;
    /// Bytes of the three indices.
    const INDEX_BYTES: usize = 12;

    /// The key as stored: the chart's name behind its length, then the indices big-endian with the sign flipped. So
    /// the chunks of a chart lie side by side, and neighbours along z within it. A name has 1 to
    /// [`MAX_CHART_BYTES`] bytes; this version has names of one byte, the hemisphere.
    pub(crate) fn to_bytes(self) -> Vec<u8> {
        let mut bytes = Vec::with_capacity(2 + Self::INDEX_BYTES);
        bytes.extend([1, self.hemisphere]);
        bytes.extend(self.index_bytes());
        bytes
    }

    /// The key as worlds up to version 6 have it.
    pub(crate) fn to_old_bytes(self) -> [u8; Self::OLD_BYTES] {
        let mut bytes = [self.hemisphere; Self::OLD_BYTES];
        bytes[1..].copy_from_slice(&self.index_bytes());
        bytes
    }

    fn index_bytes(self) -> [u8; Self::INDEX_BYTES] {
        let mut bytes = [0; Self::INDEX_BYTES];
        for (slot, index) in bytes.chunks_exact_mut(4).zip([self.x, self.y, self.z]) {
            slot.copy_from_slice(&((index as u32) ^ 0x8000_0000).to_be_bytes());
        }
        bytes
    }

    /// Reads a stored key of any version; `None` for one of a chart that this version has no place for.
    pub(crate) fn from_bytes(bytes: &[u8]) -> Option<Self> {
        let (hemisphere, rest) = match bytes {
            [hemisphere, rest @ ..] if bytes.len() == Self::OLD_BYTES => (*hemisphere, rest),
            [1, hemisphere, rest @ ..] => (*hemisphere, rest),
            _ => return None,
        };
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

    /// Whether bytes are the key of a chunk of any chart, known or not.
    pub(crate) fn is_of_any_chart(bytes: &[u8]) -> bool {
        bytes.split_first().is_some_and(|(&length, rest)| {
            let length = usize::from(length);
            (1..=MAX_CHART_BYTES).contains(&length) && rest.len() == length + Self::INDEX_BYTES
        })
    }
}

/// The longest name of a chart: four coordinates of two integers of 128 bits each, and some more.
pub(crate) const MAX_CHART_BYTES: usize = 144;

/// A chart on disk: its name as bytes, of which this version has those of one byte.
pub(crate) mod chart {
    use serde::de::Error;
    use serde::{Deserialize, Deserializer, Serializer};

    /// Writes the name of a hemisphere.
    #[expect(clippy::trivially_copy_pass_by_ref, reason = "serde calls it so")]
    pub(crate) fn serialize<S: Serializer>(chart: &u8, to: S) -> Result<S::Ok, S::Error> {
        to.collect_seq([*chart])
    }

    /// Reads the name of a hemisphere; fails for that of another chart.
    pub(crate) fn deserialize<'a, D: Deserializer<'a>>(from: D) -> Result<u8, D::Error> {
        let name = Vec::<u8>::deserialize(from)?;
        match name.as_slice() {
            [hemisphere] => Ok(*hemisphere),
            _ => Err(D::Error::custom("a chart that this version does not know")),
        }
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

/// What worlds up to version 6 kept as one value: read, never written.
impl Versioned for WorldState {
    const KIND: Kind = Kind::State;
    const VERSION: u16 = LAST_OF_ONE_STATE;

    fn upgrade(version: u16, body: &[u8]) -> Result<Self, SchemaFault> {
        let state: v6::WorldState = match version {
            1 => v4::WorldState::from(v3::WorldState::from(decode::<v1::WorldState>(body)?))
                .into_v6(),
            2 | 3 => v4::WorldState::from(decode::<v3::WorldState>(body)?).into_v6(),
            4 => decode::<v4::WorldState>(body)?.into_v6(),
            5 => decode::<v5::WorldState>(body)?.into(),
            _ => decode(body)?,
        };
        Ok(state.into())
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
