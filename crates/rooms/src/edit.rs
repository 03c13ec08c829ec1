//! A room that is being changed, by commands of words, with undo and redo.
//!
//! | command | |
//! |---|---|
//! | `add KIND name=NAME at=X,Y,Z ...` | puts something in; `add spawn at=X,Y,Z look=YAW,PITCH` says where one begins |
//! | `change NAME key=value ...` | changes something; `name=` gives it another name |
//! | `remove NAME` | takes something away, and with a group all that it carries |
//! | `group NAME MEMBER ...` | makes a group that carries these |
//! | `undo [N]`, `redo [N]` | takes steps back, and makes them again |
//!
//! A change that would leave the room unsound is refused, and the room is as it was. Only portals may not fit their partners
//! for a while, since pairs are made and changed one after the other: until they do they are closed, and the room is not saved.

use glam::DVec3;

use crate::bounds::MOST_NAME_CHARS;
use crate::check::{check_so_far, shown};
use crate::error::RoomError;
use crate::room::{Object, Room, What};
pub use crate::words::KINDS;
use crate::words::{Pairs, new_object, set, set_spawn};

/// How many steps can be taken back.
pub const MOST_STEPS: usize = 500;

/// A room that is being changed.
#[derive(Debug, Clone)]
pub struct Editor {
    room: Room,
    past: Vec<Step>,
    future: Vec<Step>,
}

/// A change, both ways: what stood in place of what among the objects, and what else the room was.
#[derive(Debug, Clone)]
struct Step {
    start: usize,
    before: Vec<Object>,
    after: Vec<Object>,
    /// The room without its objects.
    frame_before: Room,
    frame_after: Room,
}

impl Step {
    /// The step from one room to another.
    fn between(before: &Room, after: &Room) -> Self {
        let (old, new) = (&before.objects, &after.objects);
        let same = |(a, b): &(&Object, &Object)| a == b;
        let start = old.iter().zip(new).take_while(same).count();
        let most = old.len().min(new.len()) - start;
        let end = old
            .iter()
            .rev()
            .zip(new.iter().rev())
            .take(most)
            .take_while(same)
            .count();
        Self {
            start,
            before: old[start..old.len() - end].to_vec(),
            after: new[start..new.len() - end].to_vec(),
            frame_before: frame(before),
            frame_after: frame(after),
        }
    }

    fn make(&self, room: &mut Room) {
        replace(
            room,
            self.start,
            self.before.len(),
            &self.after,
            &self.frame_after,
        );
    }

    fn take_back(&self, room: &mut Room) {
        replace(
            room,
            self.start,
            self.after.len(),
            &self.before,
            &self.frame_before,
        );
    }
}

fn frame(room: &Room) -> Room {
    Room {
        version: room.version,
        name: room.name.clone(),
        sentence: room.sentence.clone(),
        gravity: room.gravity,
        sky: room.sky,
        sun: room.sun,
        fog: room.fog,
        spawn: room.spawn,
        objects: Vec::new(),
    }
}

fn replace(room: &mut Room, start: usize, count: usize, by: &[Object], frame: &Room) {
    let mut objects = std::mem::take(&mut room.objects);
    objects.splice(start..start + count, by.iter().cloned());
    *room = Room {
        objects,
        ..frame.clone()
    };
}

fn refuse<T>(sentence: impl Into<String>) -> Result<T, RoomError> {
    Err(RoomError::Command(sentence.into()))
}

impl Editor {
    /// Begins to change a room that is sound.
    pub fn new(room: Room) -> Self {
        Self {
            room,
            past: Vec::new(),
            future: Vec::new(),
        }
    }

    /// The room as it is now.
    pub fn room(&self) -> &Room {
        &self.room
    }

    /// How many steps can be taken back, and how many made again.
    pub fn steps(&self) -> (usize, usize) {
        (self.past.len(), self.future.len())
    }

    /// Does what a command says. Its words have lost their quotes: `name="a b"` is the one word `name=a b`.
    ///
    /// # Errors
    /// [`RoomError::Command`]: what is wrong with the command, or with the room that it would leave. The room is as it
    /// was then.
    pub fn apply(&mut self, words: &[&str]) -> Result<(), RoomError> {
        let Some((command, rest)) = words.split_first() else {
            return refuse("A command is missing: add, change, remove, group, undo or redo.");
        };
        let made = match *command {
            "undo" => return self.undo(steps(rest)?),
            "redo" => return self.redo(steps(rest)?),
            "add" => add(&self.room, rest),
            "change" => change(&self.room, rest),
            "remove" => remove(&self.room, rest),
            "group" => group(&self.room, rest),
            other => refuse(format!(
                "There is no command {}; there are add, change, remove, group, undo and redo.",
                shown(other)
            )),
        }?;
        self.step(made)
    }

    /// Takes a changed room in place of the one there is, as one step.
    ///
    /// # Errors
    /// [`RoomError::Command`] if it is not sound.
    pub fn step(&mut self, room: Room) -> Result<(), RoomError> {
        check_so_far(&room).or_else(|fault| refuse(sentence(&fault.to_string())))?;
        if room == self.room {
            return Ok(());
        }
        self.past.push(Step::between(&self.room, &room));
        if self.past.len() > MOST_STEPS {
            self.past.remove(0);
        }
        self.future.clear();
        self.room = room;
        Ok(())
    }

    fn undo(&mut self, count: usize) -> Result<(), RoomError> {
        if self.past.is_empty() {
            return refuse("There is nothing to undo.");
        }
        for _ in 0..count {
            let Some(step) = self.past.pop() else { break };
            step.take_back(&mut self.room);
            self.future.push(step);
        }
        Ok(())
    }

    fn redo(&mut self, count: usize) -> Result<(), RoomError> {
        if self.future.is_empty() {
            return refuse("There is nothing to redo.");
        }
        for _ in 0..count {
            let Some(step) = self.future.pop() else { break };
            step.make(&mut self.room);
            self.past.push(step);
        }
        Ok(())
    }
}

/// A fault as a sentence of its own.
fn sentence(fault: &str) -> String {
    let mut letters = fault.chars();
    letters
        .next()
        .map(|it| it.to_uppercase().chain(letters).collect())
        .unwrap_or_default()
}

/// The number of steps that a command names; one if it names none.
fn steps(words: &[&str]) -> Result<usize, RoomError> {
    match words {
        [] => Ok(1),
        [count] => match count.parse() {
            Ok(count) if (1..=MOST_STEPS).contains(&count) => Ok(count),
            _ => refuse(format!(
                "{} is no number of steps; it is to be 1 to {MOST_STEPS}.",
                shown(count)
            )),
        },
        _ => refuse("One number of steps is enough."),
    }
}

fn add(room: &Room, words: &[&str]) -> Result<Room, RoomError> {
    let Some((kind, rest)) = words.split_first() else {
        return refuse("Say what to add, such as `add box name=wall at=0,1,-5 size=4,2,0.2`.");
    };
    let mut room = room.clone();
    let pairs = Pairs::of(rest)?;
    if *kind == "spawn" {
        set_spawn(&mut room.spawn, &pairs)?;
    } else {
        room.objects.push(new_object(kind, &pairs)?);
    }
    Ok(room)
}

fn change(room: &Room, words: &[&str]) -> Result<Room, RoomError> {
    let Some((name, rest)) = words.split_first() else {
        return refuse("Say what to change, such as `change wall at=0,1,-6`.");
    };
    let mut room = room.clone();
    let pairs = Pairs::of(rest)?;
    let Some(index) = room.find(name).map(|(index, _)| index) else {
        if *name == "spawn" {
            set_spawn(&mut room.spawn, &pairs)?;
            return Ok(room);
        }
        return missing(name);
    };
    set(&mut room.objects[index], &pairs, false)?;
    let new_name = room.objects[index].name.clone();
    for object in &mut room.objects {
        if object.group.as_deref() == Some(name) {
            object.group = Some(new_name.clone());
        }
        if let What::Portal(it) = &mut object.what
            && it.to == *name
        {
            it.to.clone_from(&new_name);
        }
    }
    Ok(room)
}

fn remove(room: &Room, words: &[&str]) -> Result<Room, RoomError> {
    let [name] = words else {
        return refuse("Say one thing to remove, such as `remove wall`.");
    };
    if room.find(name).is_none() {
        return missing(name);
    }
    let mut room = room.clone();
    let mut gone = vec![(*name).to_owned()];
    while !gone.is_empty() {
        room.objects.retain(|it| !gone.contains(&it.name));
        let orphans = room
            .objects
            .iter()
            .filter(|it| it.group.as_ref().is_some_and(|group| gone.contains(group)));
        gone = orphans.map(|it| it.name.clone()).collect();
    }
    Ok(room)
}

fn group(room: &Room, words: &[&str]) -> Result<Room, RoomError> {
    let [name, members @ ..] = words else {
        return refuse(
            "Say the group's name and what it is to carry, such as `group house wall roof`.",
        );
    };
    let mut room = room.clone();
    for member in members {
        let Some((index, object)) = room.find(member) else {
            return missing(member);
        };
        if let Some(other) = &object.group {
            return refuse(format!(
                "{} is in the group {} already.",
                shown(member),
                shown(other)
            ));
        }
        room.objects[index].group = Some((*name).to_owned());
    }
    // At the origin, so that nothing moves.
    if room.find(name).is_none_or(|(_, it)| it.what != What::Group) {
        room.objects
            .push(Object::new(name, DVec3::ZERO, What::Group));
    }
    Ok(room)
}

fn missing<T>(name: &str) -> Result<T, RoomError> {
    let short: String = name.chars().take(MOST_NAME_CHARS).collect();
    refuse(format!(
        "There is nothing called {} in this room.",
        shown(&short)
    ))
}
