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
//! All of a kind lie side by side in the order of their numbers. The seal's version is that of the kind, not of
//! the schema: a later game may add kinds, or change one, in a world that this one opens. What it does not know it
//! leaves where it is.

use std::collections::BTreeMap;
use std::fmt;

use crate::codec::{self, Fault};
use crate::record_shapes::{
    BotRecord, CarRecord, CourseRecord, DropRecord, EarthRecord, FelledRecord, FixtureRecord,
    FlagRecord, LampRecord, PlantedRecord, PlayerKept, ViewRecord,
};
use crate::store::Raw;
use crate::survey::PLAYERS_STATE;

/// The longest name of a kind, bytes.
const MAX_KIND_BYTES: usize = 32;
/// The highest number of a thing that this version takes in; from there it can count on for as long as anybody plays.
const MAX_ID: u32 = i32::MAX as u32;

/// The table of kinds: of each its shape, its name on disk, and the version of the shape that this build writes.
macro_rules! kinds {
    ($($(#[$doc:meta])* $kind:ident($shape:ty) = $name:literal, version $version:literal;)+) => {
        /// The kinds that this version knows.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum RecordKind {
            $($(#[$doc])* $kind,)+
        }

        /// What is stored of one thing.
        #[derive(Debug, Clone, PartialEq)]
        pub enum Record {
            $($(#[$doc])* $kind($shape),)+
        }

        impl RecordKind {
            /// All of them.
            pub const ALL: &[Self] = &[$(Self::$kind,)+];

            /// What it is called on disk.
            pub fn name(self) -> &'static str {
                match self {
                    $(Self::$kind => $name,)+
                }
            }

            /// The version of its shape that this build writes.
            pub(crate) fn version(self) -> u16 {
                match self {
                    $(Self::$kind => $version,)+
                }
            }
        }

        impl Record {
            /// Its kind.
            pub fn kind(&self) -> RecordKind {
                match self {
                    $(Self::$kind(_) => RecordKind::$kind,)+
                }
            }

            /// Its body, not yet sealed.
            pub(crate) fn encoded(&self) -> Result<Vec<u8>, Fault> {
                match self {
                    $(Self::$kind(it) => codec::encode(it),)+
                }
            }

            /// Reads a body of a kind and version; `None` if this version cannot: of a later one, of a chart that it
            /// does not know, or of no sense.
            pub(crate) fn decoded(kind: RecordKind, version: u16, body: &[u8]) -> Option<Self> {
                if version != kind.version() {
                    return None;
                }
                match kind {
                    $(RecordKind::$kind => codec::decode(body).ok().map(Self::$kind),)+
                }
            }
        }
    };
}

kinds! {
    /// A player, with what belongs to it; 0 is the one who plays here.
    Player(Box<PlayerKept>) = "player", version 1;
    /// What the world has one of and what changes with time.
    Course(CourseRecord) = "course", version 1;
    /// How the player looks at the world.
    View(ViewRecord) = "view", version 1;
    /// Ground that the player has gathered.
    Earth(EarthRecord) = "earth", version 1;
    /// A lamp that was put down.
    Lamp(LampRecord) = "lamp", version 1;
    /// A flag that was planted.
    Flag(FlagRecord) = "flag", version 1;
    /// Something else that was put down and stands.
    Fixture(FixtureRecord) = "fixture", version 1;
    /// A stack that lies about.
    Drop(DropRecord) = "drop", version 1;
    /// A figure that nobody plays.
    Figure(BotRecord) = "figure", version 1;
    /// A car.
    Car(CarRecord) = "car", version 1;
    /// What grew on a column of chunks and was felled.
    Felled(FelledRecord) = "felled", version 1;
    /// A tree that somebody planted.
    Planted(PlantedRecord) = "planted", version 1;
}

impl RecordKind {
    /// The key of the record of that number.
    pub fn numbered(self, id: u32) -> RecordKey {
        RecordKey { kind: self, id }
    }

    fn of_name(name: &str) -> Option<Self> {
        (Self::ALL.iter().copied()).find(|kind| kind.name() == name)
    }
}

/// Which record: its kind and its number among those.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct RecordKey {
    /// Its kind.
    pub kind: RecordKind,
    /// Its number, never given twice while a world is open; 0 for what a world has one of.
    pub id: u32,
}

impl RecordKey {
    /// Whether nobody can play a world without it: of a later version it makes the whole world one of a later game.
    pub(crate) fn is_needed(self) -> bool {
        let single = [RecordKind::Player, RecordKind::Course, RecordKind::View];
        self.id == 0 && single.contains(&self.kind)
    }

    /// The key as stored.
    pub(crate) fn to_bytes(self) -> Vec<u8> {
        let name = self.kind.name().as_bytes();
        let mut bytes = Vec::with_capacity(1 + name.len() + size_of::<u64>());
        bytes.push(name.len() as u8);
        bytes.extend(name);
        bytes.extend(u64::from(self.id).to_be_bytes());
        bytes
    }
}

impl fmt::Display for RecordKey {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.kind {
            RecordKind::Player if self.id == 0 => f.write_str(PLAYERS_STATE),
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

    /// The key, if this version knows the kind and numbers so high.
    pub(crate) fn known(&self) -> Option<RecordKey> {
        let id = u32::try_from(self.id).ok().filter(|id| *id <= MAX_ID)?;
        Some(RecordKind::of_name(self.name)?.numbered(id))
    }
}

/// Records to write, and keys of those that are gone.
pub type RecordChanges = BTreeMap<RecordKey, Option<Record>>;

/// The records of a world.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Records {
    /// Those that this version knows.
    pub known: BTreeMap<RecordKey, Record>,
    /// How many there are besides, of a kind, a version, a chart or a number that only a later game knows. They stay in the
    /// world as they are.
    pub unknown: usize,
    /// Of each kind the largest number that any has, known, unknown or damaged.
    pub last: BTreeMap<RecordKind, u32>,
}

impl Records {
    /// The player who plays here.
    pub fn player(&self) -> Option<&PlayerKept> {
        match self.known.get(&RecordKind::Player.numbered(0))? {
            Record::Player(kept) => Some(kept),
            _ => None,
        }
    }

    /// The ground that he has gathered.
    pub fn earth(&self) -> Option<&EarthRecord> {
        match self.known.get(&RecordKind::Earth.numbered(0))? {
            Record::Earth(kept) => Some(kept),
            _ => None,
        }
    }

    /// Takes a record of today.
    pub(crate) fn put(&mut self, key: RecordKey, record: Record) {
        self.count(key);
        self.known.insert(key, record);
    }

    /// Takes a stored record, if it can be believed.
    pub(crate) fn take(&mut self, raw: &Raw) {
        let Some(parts) = KeyParts::of(&raw.key) else {
            return;
        };
        let known = parts.known();
        if let Some(key) = known {
            self.count(key);
        }
        let Some(record) = codec::unseal(&raw.bytes)
            .ok()
            .filter(|it| it.key == raw.key)
        else {
            return;
        };
        let read = known
            .and_then(|key| Some((key, Record::decoded(key.kind, record.version, record.body)?)));
        match read {
            Some((key, value)) => self.put(key, value),
            None => self.unknown += 1,
        }
    }

    fn count(&mut self, key: RecordKey) {
        let last = self.last.entry(key.kind).or_default();
        *last = key.id.max(*last);
    }
}

#[cfg(test)]
mod tests;
