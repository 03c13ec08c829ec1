//! Edits as words of commands, and back. Words have lost their quotes: `name="a b"` is the one word `name=a b`.
//!
//! | command | |
//! |---|---|
//! | `add KIND name=NAME at=X,Y,Z ...` | puts something in; `add spawn at=X,Y,Z look=YAW,PITCH` says where one begins |
//! | `change NAME key=value ...` | changes something; `name=` gives it another name |
//! | `remove NAME ...` | takes something away, and with a group all that it carries |
//! | `group NAME MEMBER ... [at=X,Y,Z]` | makes a group that carries these, at the origin if nothing else is said |
//! | `carry GROUP\|none MEMBER ...` | lets a group that there is carry these, or none |
//! | `ungroup NAME ...` | takes groups away, and leaves what they carried |
//! | `duplicate NAME ... [by=X,Y,Z]` | copies |
//! | `array NAME ... count=N [step=X,Y,Z] [turn=YAW] [about=X,Y,Z]` | copies in a row, or in a ring |
//! | `room set key=value ...` | changes the room itself |
//! | `undo [N]`, `redo [N]` | takes steps back, and makes them again |
//!
//! A word `;` alone parts commands that are one step together. A paste has no word of its own: it is the `add` of what it puts in.

use std::sync::Arc;

use antipode_rooms::wording::{number, three, words_of};
use antipode_rooms::words::{Pairs, new_object};
use antipode_rooms::{Object, Room, shown, words as rooms_words};
use glam::DVec3;

use crate::edit::{Array, Edit, Field, Placed};
use crate::error::{WorkshopError, refuse};
use crate::make::{MOST_COPIES, make_in, pasted};

/// The most steps that `undo N` and `redo N` go.
pub const MOST_AT_ONCE: usize = 10_000;
/// What parts commands.
const NEXT: &str = ";";
/// What is said where no group carries.
const NO_GROUP: &str = "none";
const COMMANDS: &str =
    "add, change, remove, group, carry, ungroup, duplicate, array, undo and redo";

/// What a command says.
#[derive(Debug, Clone, PartialEq)]
pub enum Command {
    /// An edit.
    Edit(Box<Edit>),
    /// Takes so many steps back.
    Undo(usize),
    /// Makes so many steps again.
    Redo(usize),
}

/// Reads the words of a command; of a room, since `spawn` may be an object in it.
///
/// # Errors
/// What is wrong with them.
pub fn parse(room: &Room, words: &[&str]) -> Result<Command, WorkshopError> {
    match words {
        ["undo", rest @ ..] => return steps(rest).map(Command::Undo),
        ["redo", rest @ ..] => return steps(rest).map(Command::Redo),
        _ => {}
    }
    let mut edits = words
        .split(|it| *it == NEXT)
        .map(|part| edit(room, part))
        .collect::<Result<Vec<_>, _>>()?;
    Ok(Command::Edit(Box::new(match edits.len() {
        1 => edits.remove(0),
        _ => Edit::Several(edits),
    })))
}

/// The number of steps that a command names; one if it names none.
fn steps(words: &[&str]) -> Result<usize, WorkshopError> {
    match words {
        [] => Ok(1),
        [count] => match count.parse() {
            Ok(count) if (1..=MOST_AT_ONCE).contains(&count) => Ok(count),
            _ => refuse(format!(
                "{} is no number of steps; it is to be 1 to {MOST_AT_ONCE}.",
                shown(count)
            )),
        },
        _ => refuse("One number of steps is enough."),
    }
}

fn edit(room: &Room, words: &[&str]) -> Result<Edit, WorkshopError> {
    let Some((command, rest)) = words.split_first() else {
        return refuse(format!("A command is missing: {COMMANDS}."));
    };
    match *command {
        "add" => add(rest),
        "change" => change(room, rest),
        "remove" => {
            names(rest, "Say one thing to remove, such as `remove wall`.").map(Edit::Remove)
        }
        "group" => group(rest),
        "carry" => carry(rest),
        "ungroup" => names(rest, "Say which group, such as `ungroup house`.").map(Edit::Ungroup),
        "duplicate" => duplicate(rest),
        "array" => array(rest),
        "room" => match rest {
            ["set", pairs @ ..] if !pairs.is_empty() => Ok(Edit::Room(fields(pairs)?)),
            _ => refuse("Say what to set, such as `room set gravity=0,-1.6,0`."),
        },
        other => refuse(format!(
            "There is no command {}; there are {COMMANDS}.",
            shown(other)
        )),
    }
}

fn names(words: &[&str], else_say: &str) -> Result<Vec<String>, WorkshopError> {
    if words.is_empty() {
        return refuse(else_say);
    }
    Ok(words.iter().map(|it| (*it).to_owned()).collect())
}

fn fields(words: &[&str]) -> Result<Vec<Field>, WorkshopError> {
    let pairs = Pairs::of(words)?;
    let all = pairs.all().iter();
    Ok(all.map(|(key, value)| Field::new(key, *value)).collect())
}

/// Parts words into names and what is said with `=`.
fn names_and_pairs<'w>(words: &[&'w str]) -> Result<(Vec<String>, Pairs<'w>), WorkshopError> {
    let (said, names): (Vec<&str>, Vec<&str>) = words.iter().partition(|it| it.contains('='));
    let names = names.into_iter().map(str::to_owned).collect();
    Ok((names, Pairs::of(&said)?))
}

fn add(words: &[&str]) -> Result<Edit, WorkshopError> {
    let Some((kind, rest)) = words.split_first() else {
        return refuse("Say what to add, such as `add box name=wall at=0,1,-5 size=4,2,0.2`.");
    };
    if *kind == "spawn" {
        return Ok(Edit::Spawn(fields(rest)?));
    }
    Ok(Edit::Insert(new_object(kind, &Pairs::of(rest)?)?))
}

fn change(room: &Room, words: &[&str]) -> Result<Edit, WorkshopError> {
    let Some((name, rest)) = words.split_first() else {
        return refuse("Say what to change, such as `change wall at=0,1,-6`.");
    };
    let fields = fields(rest)?;
    if *name == "spawn" && room.find(name).is_none() {
        return Ok(Edit::Spawn(fields));
    }
    // Whether it is there is seen when the edit is made: what parts this command from others may have put it in.
    Ok(Edit::Change((*name).to_owned(), fields))
}

fn group(words: &[&str]) -> Result<Edit, WorkshopError> {
    let (mut names, pairs) = names_and_pairs(words)?;
    let mut at = DVec3::ZERO;
    for (key, value) in pairs.all() {
        match *key {
            "at" => at = rooms_words::three(key, value)?,
            _ => return refuse(format!("A new group has no {}; it has at.", shown(key))),
        }
    }
    if names.is_empty() {
        return refuse(
            "Say the group's name and what it is to carry, such as `group house wall roof`.",
        );
    }
    Ok(Edit::Group {
        name: names.remove(0),
        at,
        members: names,
    })
}

fn carry(words: &[&str]) -> Result<Edit, WorkshopError> {
    let [group, members @ ..] = words else {
        return refuse("Say which group is to carry what, such as `carry house wall roof`.");
    };
    Ok(Edit::Carry {
        group: (*group != NO_GROUP).then(|| (*group).to_owned()),
        members: names(
            members,
            "Say what is to be carried, such as `carry house wall`.",
        )?,
    })
}

fn duplicate(words: &[&str]) -> Result<Edit, WorkshopError> {
    let (names, pairs) = names_and_pairs(words)?;
    let mut by = DVec3::ZERO;
    for (key, value) in pairs.all() {
        match *key {
            "by" => by = rooms_words::three(key, value)?,
            _ => return refuse(format!("A copy has no {}; it has by.", shown(key))),
        }
    }
    if names.is_empty() {
        return refuse("Say what to copy, such as `duplicate wall by=1,0,0`.");
    }
    Ok(Edit::Duplicate { names, by })
}

fn array(words: &[&str]) -> Result<Edit, WorkshopError> {
    let (names, pairs) = names_and_pairs(words)?;
    let mut array = Array {
        names,
        count: 0,
        step: DVec3::ZERO,
        turn_deg: 0.0,
        about: None,
    };
    for (key, value) in pairs.all() {
        match *key {
            "count" => array.count = value.parse().unwrap_or_default(),
            "step" => array.step = rooms_words::three(key, value)?,
            "turn" => array.turn_deg = rooms_words::number(key, value)?,
            "about" => array.about = Some(rooms_words::three(key, value)?),
            _ => {
                return refuse(format!(
                    "An array has no {}; it has count, step, turn and about.",
                    shown(key)
                ));
            }
        }
    }
    if array.names.is_empty() || !(1..=MOST_COPIES).contains(&array.count) {
        return refuse(format!(
            "Say what to copy and 1 to {MOST_COPIES} times, such as `array post count=5 step=2,0,0`."
        ));
    }
    Ok(Edit::Array(array))
}

impl Edit {
    /// Its words as a command; of the room that it is made in, since what a paste puts in is called by what is there.
    /// [`parse`] makes of them an edit that does the same.
    pub fn words(&self, room: &Room) -> Vec<String> {
        let mut out = Vec::new();
        self.say(room, &mut out);
        out
    }

    fn say(&self, room: &Room, out: &mut Vec<String>) {
        let said = |key: &str, value: String| format!("{key}={value}");
        let mut say = |command: &str, names: &[String], rest: Vec<String>| {
            out.push(command.to_owned());
            out.extend(names.iter().cloned());
            out.extend(rest);
        };
        match self {
            Self::Insert(object) => say("add", &[], of_object(object)),
            Self::Remove(names) => say("remove", names, Vec::new()),
            Self::Change(name, fields) => {
                say("change", std::slice::from_ref(name), of_fields(fields));
            }
            Self::Place(placed) => {
                let each = placed.iter().map(change_of);
                say_several(&each.collect::<Vec<_>>(), room, out);
            }
            Self::Group { name, at, members } => {
                say("group", std::slice::from_ref(name), members.clone());
                out.push(said("at", three(*at)));
            }
            Self::Carry { group, members } => {
                say(
                    "carry",
                    &[group.clone().unwrap_or_else(|| NO_GROUP.to_owned())],
                    members.clone(),
                );
            }
            Self::Ungroup(names) => say("ungroup", names, Vec::new()),
            Self::Duplicate { names, by } => say("duplicate", names, vec![said("by", three(*by))]),
            Self::Array(array) => {
                let mut rest = vec![
                    said("count", array.count.to_string()),
                    said("step", three(array.step)),
                    said("turn", number(array.turn_deg)),
                ];
                rest.extend(array.about.map(|it| said("about", three(it))));
                say("array", &array.names, rest);
            }
            Self::Paste { clip, by, .. } => {
                let objects = pasted(room, clip, *by).into_iter();
                Self::Several(
                    objects
                        .map(Arc::unwrap_or_clone)
                        .map(Self::Insert)
                        .collect(),
                )
                .say(room, out);
            }
            Self::Room(fields) => say("room", &["set".to_owned()], of_fields(fields)),
            Self::Spawn(fields) => say("add", &["spawn".to_owned()], of_fields(fields)),
            Self::Several(edits) => say_several(edits, room, out),
        }
    }
}

/// What comes later is said of the room that what comes earlier makes.
fn say_several(edits: &[Edit], room: &Room, out: &mut Vec<String>) {
    let mut so_far = room.clone();
    for (number, edit) in edits.iter().enumerate() {
        if number > 0 {
            out.push(NEXT.to_owned());
        }
        edit.say(&so_far, out);
        // What is refused here is refused when it is made, too.
        let _ = make_in(&mut so_far, edit);
    }
}

/// What is put elsewhere as a change of its fields.
fn change_of(placed: &Placed) -> Edit {
    let at = placed.at.map(|it| Field::three("at", it));
    let turn = placed.turn.map(|it| Field::three("turn", it));
    Edit::Change(placed.name.clone(), turn.into_iter().chain(at).collect())
}

fn of_object(object: &Object) -> Vec<String> {
    let pairs = words_of(object).into_iter();
    let pairs = pairs.map(|(key, value)| format!("{key}={value}"));
    std::iter::once(object.what.kind().to_owned())
        .chain(pairs)
        .collect()
}

fn of_fields(fields: &[Field]) -> Vec<String> {
    let all = fields.iter();
    all.map(|it| format!("{}={}", it.key, it.value)).collect()
}
