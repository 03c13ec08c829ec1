//! Every version of every stored value, and the way from an old one to today's.
//!
//! The structs below are today's shapes and are stored field by field in their
//! order, without names: changing a field, its type or its place is a new schema
//! version. To make one: copy the struct as it was into `schema_history.rs`, raise
//! [`SCHEMA_VERSION`], and let [`Versioned::upgrade`] decode the old shape and
//! convert it. `tests/saves` keeps a world of each version for ever.
//!
//! Records of things have versions of their own, each kind for itself: see `record.rs`.

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use crate::codec::{self, Fault, Kind, Record};
use crate::schema_history::{v1, v2, v3, v4, v5, v8, v9};

pub use crate::record_shapes::{
    BotRecord, CarRecord, CourseRecord, DropRecord, EarthRecord, FelledRecord, FixtureRecord,
    FlagRecord, LampRecord, PlaceRecord, PlantedRecord, PlayerKept, PlayerRecord, SlotRecord,
    ViewRecord,
};
pub use crate::state::WorldState;

/// The schema version this build writes.
pub const SCHEMA_VERSION: u16 = 10;
/// How worlds were made before they said so.
pub(crate) const FIRST_GENERATOR: u16 = 1;
/// The last version whose chunks had no kinds of ground.
const LAST_WITHOUT_KINDS: u16 = 7;
/// The last version that kept the state as one value.
const LAST_OF_ONE_STATE: u16 = 6;

/// What a world is: fixed at its creation, but for the name and the times.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct WorldMeta {
    /// The name the player gave, printable, 1 to 40 characters.
    pub name: String,
    /// Seed of the terrain.
    pub seed: u64,
    /// `euclidean`, `hyperbolic` or `spherical`.
    pub geometry: String,
    /// Radius of curvature in metres; 0 or infinite in a flat world.
    pub radius_m: f64,
    /// The biome's identifier, empty where the world has several.
    pub biome: String,
    /// When the world was made, seconds since 1970 UTC.
    pub created_unix_s: u64,
    /// When it was last played, seconds since 1970 UTC.
    pub last_played_unix_s: u64,
    /// Time spent in it, seconds.
    pub played_s: f64,
    /// Whether a command that cheats was ever used in it.
    pub cheated: bool,
    /// The number of the generator that makes its land.
    pub generator: u16,
    /// Whether what is built is first to be gathered; else it costs nothing.
    pub gathering: bool,
}

impl Default for WorldMeta {
    fn default() -> Self {
        v9::WorldMeta::from(v8::WorldMeta::default()).into()
    }
}

/// Which chunk: its chart, and its index in chunks.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default, Serialize, Deserialize,
)]
pub struct ChunkKey {
    /// The number of the chart; on a globe 0 and 1 are the hemispheres A and B.
    #[serde(with = "chart")]
    pub chart: u128,
    /// Index along x.
    pub x: i32,
    /// Index along y (up).
    pub y: i32,
    /// Index along z.
    pub z: i32,
}

impl ChunkKey {
    /// Length of [`Self::to_bytes`] for the charts that are a byte.
    pub(crate) const BYTES: usize = 1 + Self::INDEX_BYTES;
    /// Bytes of the three indices.
    const INDEX_BYTES: usize = 12;

    /// A key whose order as bytes is the order of `ChunkKey`: the chart as in [`chart`], then the indices big-endian with
    /// the sign flipped, so that neighbours along z lie side by side in the store.
    pub(crate) fn to_bytes(self) -> Vec<u8> {
        let mut bytes = chart::to_bytes(self.chart);
        for index in [self.x, self.y, self.z] {
            bytes.extend(((index as u32) ^ 0x8000_0000).to_be_bytes());
        }
        bytes
    }

    /// The inverse of [`Self::to_bytes`]; `None` for what is none.
    pub(crate) fn from_bytes(bytes: &[u8]) -> Option<Self> {
        let (chart, rest) = bytes.split_at_checked(bytes.len().checked_sub(Self::INDEX_BYTES)?)?;
        let (words, []) = rest.as_chunks::<4>() else {
            return None;
        };
        let &[x, y, z] = words else { return None };
        let index = |word| (u32::from_be_bytes(word) ^ 0x8000_0000) as i32;
        Some(Self {
            chart: chart::from_bytes(chart)?,
            x: index(x),
            y: index(y),
            z: index(z),
        })
    }

    /// Whether bytes are the key of a chunk of a chart with a name, which may be one that only a later game knows: the
    /// chart as in [`chart`], then the indices. It is longer than any key of the two hemispheres.
    pub(crate) fn is_of_named_chart(bytes: &[u8]) -> bool {
        bytes.split_first().is_some_and(|(&length, rest)| {
            let length = usize::from(length);
            (2..=chart::MAX_NAME_BYTES).contains(&length)
                && rest.len() == length + Self::INDEX_BYTES
        })
    }
}

/// A chart as it is stored: the byte 0 or 1 for hemisphere A or B. A larger one is the length of a name, which follows.
/// The names that this version knows are numbers of charts: 16 bytes, big-endian.
pub(crate) mod chart {
    use serde::de::Error;
    use serde::{Deserializer, Serialize, Serializer};

    /// The longest name that later versions may write: this one writes 16 bytes.
    pub(crate) const MAX_NAME_BYTES: usize = 144;
    /// Charts below this have no name.
    const NAMED: u128 = 2;
    /// Length of the name that is a number.
    const NAME_BYTES: u8 = 16;

    /// The bytes of a chart.
    pub(crate) fn to_bytes(chart: u128) -> Vec<u8> {
        let mut bytes = vec![NAME_BYTES];
        bytes.extend(chart.to_be_bytes());
        if chart < NAMED {
            bytes = vec![chart as u8];
        }
        bytes
    }

    /// The chart of all these bytes; `None` for one that this version does not know.
    pub(crate) fn from_bytes(bytes: &[u8]) -> Option<u128> {
        match bytes {
            [chart] => Some(u128::from(*chart)).filter(|chart| *chart < NAMED),
            [NAME_BYTES, name @ ..] => named(name.try_into().ok()?),
            _ => None,
        }
    }

    fn named(name: [u8; NAME_BYTES as usize]) -> Option<u128> {
        Some(u128::from_be_bytes(name)).filter(|chart| *chart >= NAMED)
    }

    pub(crate) fn serialize<S: Serializer>(chart: &u128, to: S) -> Result<S::Ok, S::Error> {
        if *chart < NAMED {
            to.serialize_u8(*chart as u8)
        } else {
            (NAME_BYTES, chart.to_be_bytes()).serialize(to)
        }
    }

    /// Fails for a chart that this version does not know.
    pub(crate) fn deserialize<'a, D: Deserializer<'a>>(from: D) -> Result<u128, D::Error> {
        from.deserialize_tuple(2, Parts)
    }

    /// The byte, and the name if there is one.
    struct Parts;

    impl<'a> serde::de::Visitor<'a> for Parts {
        type Value = u128;

        fn expecting(&self, to: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
            to.write_str("a chart")
        }

        fn visit_seq<A: serde::de::SeqAccess<'a>>(self, mut from: A) -> Result<u128, A::Error> {
            let unknown = || A::Error::custom("a chart that this version does not know");
            match from.next_element::<u8>()?.ok_or_else(unknown)? {
                chart if u128::from(chart) < NAMED => Ok(u128::from(chart)),
                NAME_BYTES => {
                    let name = from.next_element()?.ok_or_else(unknown)?;
                    named(name).ok_or_else(unknown)
                }
                _ => Err(unknown()),
            }
        }
    }
}

impl std::fmt::Display for ChunkKey {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.chart {
            0 => f.write_str("chunk A")?,
            1 => f.write_str("chunk B")?,
            chart => write!(f, "chunk {chart:#x}")?,
        }
        write!(f, " ({}, {}, {})", self.x, self.y, self.z)
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
            1 | 2 => decode::<v2::WorldMeta>(body)
                .map(v8::WorldMeta::from)
                .map(v9::WorldMeta::from)
                .map(Self::from),
            3..=8 => decode::<v8::WorldMeta>(body)
                .map(v9::WorldMeta::from)
                .map(Self::from),
            9 => decode::<v9::WorldMeta>(body).map(Self::from),
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

/// Edits of a chunk's samples, and a byte for each that tells of the kind of ground laid there, or none at all.
pub type StoredGround = (Vec<i16>, Vec<u8>);

/// A chunk's edits as stored, and the bytes of its kinds of ground, of which there may be none; see [`crate::chunk_codec`].
pub(crate) struct ChunkBody(pub Vec<i16>, pub Vec<u8>);

impl Versioned for ChunkBody {
    const KIND: Kind = Kind::Chunk;

    fn upgrade(version: u16, body: &[u8]) -> Result<Self, SchemaFault> {
        let read = match version {
            1..=LAST_WITHOUT_KINDS => {
                crate::chunk_codec::unpack_chunk(body).map(|samples| (samples, Vec::new()))
            }
            _ => crate::chunk_codec::unpack_ground(body),
        };
        let (samples, kinds) = read.map_err(SchemaFault::Damaged)?;
        Ok(Self(samples, kinds))
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
