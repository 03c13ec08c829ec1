//! Actors and the rest that changes while a world is played, one record a thing.
//!
//! A record's key is its kind and its number:
//!
//! | bytes | what |
//! |---|---|
//! | 0 | length of the kind's name, 1 to 32 |
//! | 1.. | the name |
//! | then 8 | the number, big-endian |
//!
//! So all of a kind lie side by side in the order of their numbers. The seal's version is that of the kind, not of
//! the schema: a later game may add kinds, or change one, in a world that this one opens. What it does not know it
//! leaves where it is.

use std::collections::BTreeMap;
use std::fmt;

use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::codec::{self, Fault, Kind};
use crate::record_shapes::{
    BotRecord, CarRecord, CourseRecord, DropRecord, LampRecord, PlayerKept, ViewRecord,
};
use crate::store::Raw;

/// The longest name of a kind, bytes.
const MAX_KIND_BYTES: usize = 32;
/// Bytes of a number in a key.
const ID_BYTES: usize = 8;

/// The kinds that this version knows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum RecordKind {
    /// A player, with what belongs to it.
    Player,
    /// What the world has one of and what changes with time.
    Course,
    /// How the player looks at the world.
    View,
    /// A lamp that was put down.
    Lamp,
    /// A stack that lies about.
    Drop,
    /// A figure that nobody plays.
    Figure,
    /// A car.
    Car,
}

impl RecordKind {
    /// All of them.
    pub const ALL: [Self; 7] = [
        Self::Player,
        Self::Course,
        Self::View,
        Self::Lamp,
        Self::Drop,
        Self::Figure,
        Self::Car,
    ];

    /// What it is called on disk.
    pub fn name(self) -> &'static str {
        match self {
            Self::Player => "player",
            Self::Course => "course",
            Self::View => "view",
            Self::Lamp => "lamp",
            Self::Drop => "drop",
            Self::Figure => "figure",
            Self::Car => "car",
        }
    }

    /// The version of its shape that this build writes.
    pub(crate) fn version(self) -> u16 {
        1
    }

    /// The key of the one record of a kind that a world has one of.
    pub fn single(self) -> RecordKey {
        RecordKey { kind: self, id: 0 }
    }

    fn of_name(name: &[u8]) -> Option<Self> {
        Self::ALL
            .into_iter()
            .find(|kind| kind.name().as_bytes() == name)
    }
}

/// Which record: its kind and its number among all actors of the world.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct RecordKey {
    /// Its kind.
    pub kind: RecordKind,
    /// Its number; 0 for what a world has one of.
    pub id: u64,
}

impl RecordKey {
    /// The key as stored.
    pub(crate) fn to_bytes(self) -> Vec<u8> {
        let name = self.kind.name().as_bytes();
        let mut bytes = Vec::with_capacity(1 + name.len() + ID_BYTES);
        bytes.push(name.len() as u8);
        bytes.extend(name);
        bytes.extend(self.id.to_be_bytes());
        bytes
    }
}

impl fmt::Display for RecordKey {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.kind {
            RecordKind::Player => f.write_str("the player's state"),
            RecordKind::Course => f.write_str("the world's time"),
            RecordKind::View => f.write_str("the player's view"),
            kind => write!(f, "{} {}", kind.name(), self.id),
        }
    }
}

/// The parts of a stored key, whatever its kind.
pub(crate) struct KeyParts<'a> {
    /// Name of the kind.
    pub(crate) name: &'a str,
    /// Its number.
    pub(crate) id: u64,
}

impl<'a> KeyParts<'a> {
    /// Reads a stored key; `None` if these bytes are none.
    pub(crate) fn of(bytes: &'a [u8]) -> Option<Self> {
        let (&length, rest) = bytes.split_first()?;
        let (name, id) = rest.split_at_checked(usize::from(length))?;
        let name = std::str::from_utf8(name).ok()?;
        let is_name = (1..=MAX_KIND_BYTES).contains(&name.len())
            && name.bytes().all(|it| it.is_ascii_graphic());
        let id = u64::from_be_bytes(id.try_into().ok()?);
        is_name.then_some(Self { name, id })
    }

    /// The key, if this version knows the kind.
    pub(crate) fn known(&self) -> Option<RecordKey> {
        let kind = RecordKind::of_name(self.name.as_bytes())?;
        Some(RecordKey { kind, id: self.id })
    }
}

/// What is stored of one thing.
#[derive(Debug, Clone, PartialEq)]
pub enum Record {
    /// See [`RecordKind::Player`].
    Player(Box<PlayerKept>),
    /// See [`RecordKind::Course`].
    Course(CourseRecord),
    /// See [`RecordKind::View`].
    View(ViewRecord),
    /// See [`RecordKind::Lamp`].
    Lamp(LampRecord),
    /// See [`RecordKind::Drop`].
    Drop(DropRecord),
    /// See [`RecordKind::Figure`].
    Figure(BotRecord),
    /// See [`RecordKind::Car`].
    Car(CarRecord),
}

/// Records to write, and keys of those that are gone.
pub type RecordChanges = BTreeMap<RecordKey, Option<Record>>;

impl Record {
    /// Its kind.
    pub fn kind(&self) -> RecordKind {
        match self {
            Self::Player(_) => RecordKind::Player,
            Self::Course(_) => RecordKind::Course,
            Self::View(_) => RecordKind::View,
            Self::Lamp(_) => RecordKind::Lamp,
            Self::Drop(_) => RecordKind::Drop,
            Self::Figure(_) => RecordKind::Figure,
            Self::Car(_) => RecordKind::Car,
        }
    }

    /// Its body, not yet sealed.
    pub(crate) fn encoded(&self) -> Result<Vec<u8>, Fault> {
        fn body(value: &impl Serialize) -> Result<Vec<u8>, Fault> {
            codec::encode(value)
        }
        match self {
            Self::Player(it) => body(it),
            Self::Course(it) => body(it),
            Self::View(it) => body(it),
            Self::Lamp(it) => body(it),
            Self::Drop(it) => body(it),
            Self::Figure(it) => body(it),
            Self::Car(it) => body(it),
        }
    }

    /// Reads a body of a kind and version; `None` if this version cannot: of a later one, of a chart that it does
    /// not know, or of no sense.
    pub(crate) fn decoded(kind: RecordKind, version: u16, body: &[u8]) -> Option<Self> {
        fn of<T: DeserializeOwned>(body: &[u8]) -> Option<T> {
            codec::decode(body).ok()
        }
        if version != kind.version() {
            return None;
        }
        Some(match kind {
            RecordKind::Player => Self::Player(Box::new(of(body)?)),
            RecordKind::Course => Self::Course(of(body)?),
            RecordKind::View => Self::View(of(body)?),
            RecordKind::Lamp => Self::Lamp(of(body)?),
            RecordKind::Drop => Self::Drop(of(body)?),
            RecordKind::Figure => Self::Figure(of(body)?),
            RecordKind::Car => Self::Car(of(body)?),
        })
    }
}

/// The records of a world.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Records {
    /// Those that this version knows.
    pub known: BTreeMap<RecordKey, Record>,
    /// How many there are besides of each kind's name: of a kind, a version or a chart that only a later game knows.
    /// They stay in the world as they are.
    pub unknown: BTreeMap<String, usize>,
    /// A number larger than that of any record, known or not.
    pub next_actor: u64,
}

impl Records {
    /// Takes a stored record, if it can be believed.
    pub(crate) fn take(&mut self, raw: &Raw) {
        let (Ok(record), Some(parts)) = (codec::unseal(&raw.bytes), KeyParts::of(&raw.key)) else {
            return;
        };
        if record.kind != Kind::Record || record.key != raw.key {
            return;
        }
        self.next_actor = self.next_actor.max(parts.id);
        let known = parts.known();
        let read = known
            .and_then(|key| Some((key, Record::decoded(key.kind, record.version, record.body)?)));
        match read {
            Some((key, value)) => drop(self.known.insert(key, value)),
            None => *self.unknown.entry(parts.name.to_owned()).or_default() += 1,
        }
    }
}

#[cfg(test)]
mod tests;
