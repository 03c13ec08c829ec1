//! Everything that can be done to a room, as one kind of value. An edit is made of a room by [`crate::make`], has words as a
//! command by [`crate::words`], and its way back is the [`crate::delta`] between the rooms before and after.

use antipode_rooms::wording::{number, three, two};
use antipode_rooms::{Colour, Object};
use glam::{DVec2, DVec3};

use crate::clip::Clip;

/// Something that is done to a room, in one step. Objects are told by their names. Lengths are metres, turns degrees.
#[derive(Debug, Clone, PartialEq)]
pub enum Edit {
    /// Puts an object in, at the end of the list.
    Insert(Object),
    /// Takes objects away, groups with all that they carry.
    Remove(Vec<String>),
    /// Changes fields of an object; `name` among them renames it, and whoever names it follows.
    Change(String, Vec<Field>),
    /// Puts objects elsewhere, or turns them. A [`Self::Change`] of each does the same by way of words, which takes a drag of 2,000
    /// things longer than all else.
    Place(Vec<Placed>),
    /// Makes a group at a place of the room, or takes one that is there, and lets it carry objects, which stay where they are.
    Group {
        /// Its name.
        name: String,
        /// Where a new one is. A group that is there stays where it is.
        at: DVec3,
        /// What it carries besides what it carried.
        members: Vec<String>,
    },
    /// Lets a group carry objects, or none; they stay where they are in the room.
    Carry {
        /// The group, or none.
        group: Option<String>,
        /// What is carried from now on.
        members: Vec<String>,
    },
    /// Takes groups away; what they carried stays where it is, in the group that carried them.
    Ungroup(Vec<String>),
    /// Copies objects, groups with all that they carry; each copy is moved along the room's axes.
    Duplicate {
        /// What is copied.
        names: Vec<String>,
        /// How far off the copies are.
        by: DVec3,
    },
    /// Copies objects several times in a row or in a ring.
    Array(Array),
    /// Puts copied objects in, or a part of several.
    Paste {
        /// What was copied.
        clip: Clip,
        /// How far off where they were when they were copied.
        by: DVec3,
        /// It is a part of the game, and told as something that was added.
        is_part: bool,
    },
    /// Changes the room itself: `name`, `sentence`, `gravity`, `sky`, `light`, `sun` (yaw and pitch, or `none`), `sun-colour`,
    /// `sun-power`, `fog` (its reach, or `none`), `fog-colour`.
    Room(Vec<Field>),
    /// Changes where one begins: `at` and `look`.
    Spawn(Vec<Field>),
    /// Several, one after the other, as one step.
    Several(Vec<Edit>),
}

/// Where an object is put; in a group, from the group.
#[derive(Debug, Clone, PartialEq)]
pub struct Placed {
    /// Its name.
    pub name: String,
    /// Where it is from then on, if it is moved.
    pub at: Option<DVec3>,
    /// How it is turned from then on, (yaw, pitch, roll), if it is turned.
    pub turn: Option<DVec3>,
}

/// Copies in a row or in a ring.
#[derive(Debug, Clone, PartialEq)]
pub struct Array {
    /// What is copied.
    pub names: Vec<String>,
    /// How many copies are made of each, 1 to 200.
    pub count: u32,
    /// From one to the next, along the room's axes.
    pub step: DVec3,
    /// How each is turned from the one before, about the upright, as yaw.
    pub turn_deg: f64,
    /// The upright that turns go about; each one's own middle if there is none.
    pub about: Option<DVec3>,
}

/// A field and its value, in the words of commands: `at=0,1,-5`. What has no value says `none`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Field {
    /// The word of the field.
    pub key: String,
    /// Its value.
    pub value: String,
}

impl Field {
    /// A field with its value as it is written in commands.
    pub fn new(key: &str, value: impl Into<String>) -> Self {
        Self {
            key: key.to_owned(),
            value: value.into(),
        }
    }

    /// A number; no digit of it is lost.
    pub fn number(key: &str, value: f64) -> Self {
        Self::new(key, number(value))
    }

    /// Two numbers.
    pub fn two(key: &str, value: DVec2) -> Self {
        Self::new(key, two(value))
    }

    /// Three numbers.
    pub fn three(key: &str, value: DVec3) -> Self {
        Self::new(key, three(value))
    }

    /// A colour.
    pub fn colour(key: &str, value: Colour) -> Self {
        Self::new(key, value.to_string())
    }
}

impl Edit {
    /// Gives an object another name.
    pub fn rename(from: &str, to: &str) -> Self {
        Self::Change(from.to_owned(), vec![Field::new("name", to)])
    }

    /// Changes one field of several objects to one value.
    pub fn change_all(names: &[String], field: &Field) -> Self {
        let one = |name: &String| Self::Change(name.clone(), vec![field.clone()]);
        match names {
            [name] => one(name),
            names => Self::Several(names.iter().map(one).collect()),
        }
    }

    /// Whether it is there to put something in.
    pub fn puts_in(&self) -> bool {
        matches!(
            self,
            Self::Insert(_)
                | Self::Group { .. }
                | Self::Duplicate { .. }
                | Self::Array(_)
                | Self::Paste { .. }
        )
    }

    /// The objects that it changes or takes away. What is locked is not to be among them.
    pub fn touched(&self) -> Vec<&str> {
        match self {
            Self::Remove(names) | Self::Ungroup(names) => {
                names.iter().map(String::as_str).collect()
            }
            Self::Change(name, _) => vec![name],
            Self::Place(placed) => placed.iter().map(|it| it.name.as_str()).collect(),
            Self::Group { members, .. } | Self::Carry { members, .. } => {
                members.iter().map(String::as_str).collect()
            }
            Self::Several(edits) => edits.iter().flat_map(Self::touched).collect(),
            Self::Insert(_)
            | Self::Duplicate { .. }
            | Self::Array(_)
            | Self::Paste { .. }
            | Self::Room(_)
            | Self::Spawn(_) => Vec::new(),
        }
    }
}
