//! The way from one room to another and back, exactly: what was taken out, put in and changed, and the room's own fields.

use std::cell::LazyCell;
use std::collections::HashSet;
use std::sync::Arc;

use antipode_rooms::{Object, Room};

/// The difference of two rooms. Going there and back leaves every bit of a room as it was.
#[derive(Debug, Clone, PartialEq)]
pub struct Delta {
    /// Taken out: its place before, rising.
    pub(crate) removed: Vec<(usize, Arc<Object>)>,
    /// Put in: its place after, rising.
    pub(crate) inserted: Vec<(usize, Arc<Object>)>,
    /// Changed: its place after, rising; as it was, and as it is.
    pub(crate) changed: Vec<(usize, Arc<Object>, Arc<Object>)>,
    /// The room without its objects, as it was and as it is, if that differs.
    pub(crate) frame: Option<Box<(Room, Room)>>,
}

impl Delta {
    /// The way from one room to another.
    pub fn between(old: &Room, new: &Room) -> Self {
        let mut delta = Self {
            removed: Vec::new(),
            inserted: Vec::new(),
            changed: Vec::new(),
            frame: None,
        };
        let (frame_old, frame_new) = (frame(old), frame(new));
        if frame_old != frame_new {
            delta.frame = Some(Box::new((frame_old, frame_new)));
        }
        delta.walk(&old.objects, &new.objects);
        delta
    }

    /// Walks both lists at once. What has another name in the same place is taken for renamed if neither name is in the
    /// other list.
    fn walk(&mut self, old: &[Arc<Object>], new: &[Arc<Object>]) {
        // Mostly every name is in its place.
        let (in_old, in_new) = (LazyCell::new(|| names(old)), LazyCell::new(|| names(new)));
        let (mut i, mut j) = (0, 0);
        while i < old.len() || j < new.len() {
            match (old.get(i), new.get(j)) {
                (Some(a), Some(b)) => {
                    let stays = || in_new.contains(a.name.as_str());
                    let was = || in_old.contains(b.name.as_str());
                    if a.name == b.name || (!stays() && !was()) {
                        if !Arc::ptr_eq(a, b) && a != b {
                            self.changed.push((j, a.clone(), b.clone()));
                        }
                        (i, j) = (i + 1, j + 1);
                    } else if was() {
                        self.removed.push((i, a.clone()));
                        i += 1;
                    } else {
                        self.inserted.push((j, b.clone()));
                        j += 1;
                    }
                }
                (Some(a), None) => {
                    self.removed.push((i, a.clone()));
                    i += 1;
                }
                (None, Some(b)) => {
                    self.inserted.push((j, b.clone()));
                    j += 1;
                }
                (None, None) => break,
            }
        }
    }

    /// Whether both rooms are the same.
    pub fn is_empty(&self) -> bool {
        self.removed.is_empty()
            && self.inserted.is_empty()
            && self.changed.is_empty()
            && self.frame.is_none()
    }

    /// Whether what was taken out and put in can have been so in a list of that length.
    pub(crate) fn is_in_order(&self, length: usize) -> bool {
        let rises =
            |list: &[(usize, Arc<Object>)]| list.windows(2).all(|pair| pair[0].0 < pair[1].0);
        let (out, put) = (&self.removed, &self.inserted);
        let after = (length + put.len()).checked_sub(out.len());
        let within =
            |list: &[(usize, Arc<Object>)], length| list.last().is_none_or(|it| it.0 < length);
        rises(out) && rises(put) && within(out, length) && after.is_some_and(|it| within(put, it))
    }

    /// Goes the way from the first room to the second.
    pub fn make(&self, room: &mut Room) {
        replace(&mut room.objects, &self.removed, &self.inserted);
        for (index, _, after) in &self.changed {
            room.objects[*index] = after.clone();
        }
        if let Some(frames) = &self.frame {
            set_frame(room, &frames.1);
        }
    }

    /// Goes the way back.
    pub fn take_back(&self, room: &mut Room) {
        for (index, before, _) in &self.changed {
            room.objects[*index] = before.clone();
        }
        replace(&mut room.objects, &self.inserted, &self.removed);
        if let Some(frames) = &self.frame {
            set_frame(room, &frames.0);
        }
    }

    /// The names that objects had before, each with the one that it has after.
    pub fn renamed(&self) -> impl Iterator<Item = (&str, &str)> {
        let all = self.changed.iter();
        all.filter(|(_, before, after)| before.name != after.name)
            .map(|(_, before, after)| (before.name.as_str(), after.name.as_str()))
    }
}

fn names(list: &[Arc<Object>]) -> HashSet<&str> {
    list.iter().map(|it| it.name.as_str()).collect()
}

/// Takes out what is at its place before, and puts in what is to be at its place after, in one pass over the list.
fn replace(
    list: &mut Vec<Arc<Object>>,
    out: &[(usize, Arc<Object>)],
    put: &[(usize, Arc<Object>)],
) {
    if out.is_empty() && put.is_empty() {
        return;
    }
    let mut out = out.iter().map(|(index, _)| *index).peekable();
    let kept = std::mem::take(list).into_iter().enumerate();
    let kept = kept.filter(|(index, _)| out.next_if_eq(index).is_none());
    let mut put = put.iter().peekable();
    for (_, object) in kept {
        while let Some((_, new)) = put.next_if(|(index, _)| *index == list.len()) {
            list.push(new.clone());
        }
        list.push(object);
    }
    list.extend(put.map(|(_, new)| new.clone()));
}

/// A room without its objects.
pub(crate) fn frame(room: &Room) -> Room {
    let empty = Room {
        objects: Vec::new(),
        ..Room::new("")
    };
    let mut frame = empty;
    set_frame(&mut frame, room);
    frame
}

fn set_frame(room: &mut Room, from: &Room) {
    let objects = std::mem::take(&mut room.objects);
    *room = Room {
        version: from.version,
        name: from.name.clone(),
        sentence: from.sentence.clone(),
        gravity: from.gravity,
        sky: from.sky,
        sun: from.sun,
        fog: from.fog,
        spawn: from.spawn,
        objects,
    };
}
