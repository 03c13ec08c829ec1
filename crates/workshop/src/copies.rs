//! Copies of objects: which are copied with which, what the copies are called, and where their names lead.
//!
//! A portal whose partner is copied with it leads to the copy of that. One whose partner is not leads to itself: it stays
//! sound and shows who looks in, until somebody links it.

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use antipode_rooms::bounds::MOST_NAME_CHARS;
use antipode_rooms::room::Names;
use antipode_rooms::{Object, Room, What};
use glam::DAffine3;

use crate::place::{Groups, put};

/// The objects of these names with all that they carry, in the order of the room.
pub(crate) fn carried<'r>(room: &'r Room, names: &[String]) -> Vec<&'r Arc<Object>> {
    let within = closure(room, names);
    let all = room.objects.iter();
    all.filter(|it| within.contains(it.name.as_str())).collect()
}

/// These names and those of all that they carry.
pub fn closure<'r>(room: &'r Room, names: &[String]) -> Names<'r> {
    let mut members: HashMap<&str, Vec<&'r Object>> = HashMap::new();
    for object in room.objects.iter().map(Arc::as_ref) {
        if let Some(group) = &object.group {
            members.entry(group).or_default().push(object);
        }
    }
    let wanted: Names<'_> = names.iter().map(String::as_str).collect();
    let all = room.objects.iter().map(Arc::as_ref);
    let mut left: Vec<&Object> = all.filter(|it| wanted.contains(it.name.as_str())).collect();
    let mut within = Names::default();
    while let Some(object) = left.pop() {
        if within.insert(object.name.as_str()) && object.what == What::Group {
            left.extend(members.get(object.name.as_str()).into_iter().flatten());
        }
    }
    within
}

/// Copies of objects in the axes of the room: what none of them carries is in no group, and where it was.
pub(crate) fn into_room(room: &Room, picked: &[&Arc<Object>]) -> Vec<Arc<Object>> {
    let groups = Groups::of(room);
    let within: Names<'_> = picked.iter().map(|it| it.name.as_str()).collect();
    let all = picked.iter().map(|object| {
        let mut copy = Arc::clone(object);
        if let Some(group) = &object.group
            && !within.contains(group.as_str())
        {
            let own = Arc::make_mut(&mut copy);
            own.group = None;
            put(own, groups.pose(Some(group)), DAffine3::IDENTITY);
        }
        copy
    });
    all.collect()
}

/// The names that a room has, to find others for copies.
pub(crate) struct FreeNames {
    taken: HashSet<String>,
    /// Where the search for each begins, so that many copies take no longer than few.
    numbers: HashMap<String, usize>,
}

impl FreeNames {
    /// Those that a room has taken.
    pub fn of(room: &Room) -> Self {
        Self {
            taken: room.names().map(str::to_owned).collect(),
            numbers: HashMap::new(),
        }
    }

    /// Gives copies names that are free, and lets them name one another instead of what they are copies of. The groups of the
    /// room that carry originals carry their copies.
    pub fn named_anew(&mut self, mut copies: Vec<Arc<Object>>) -> Vec<Arc<Object>> {
        let mut names = HashMap::new();
        for copy in copies.iter_mut().map(Arc::make_mut) {
            let name = self.free(&copy.name);
            self.taken.insert(name.clone());
            names.insert(std::mem::replace(&mut copy.name, name.clone()), name);
        }
        for copy in copies.iter_mut().map(Arc::make_mut) {
            if let Some(group) = copy.group.as_mut()
                && let Some(name) = names.get(group)
            {
                group.clone_from(name);
            }
            if let What::Portal(portal) = &mut copy.what {
                let partner = names.get(&portal.to).unwrap_or(&copy.name);
                portal.to.clone_from(partner);
            }
        }
        copies
    }

    /// The name if it is free; else with the first number behind it that is, from 2. A number that it has is counted on.
    fn free(&mut self, name: &str) -> String {
        if !self.taken.contains(name) {
            return name.to_owned();
        }
        let base = match name.rsplit_once(' ') {
            Some((base, digits)) if digits.parse::<u32>().is_ok() => base.trim_end(),
            _ => name,
        };
        let next = self.numbers.entry(base.to_owned()).or_insert(2);
        loop {
            let digits = next.to_string();
            let room = MOST_NAME_CHARS - digits.len() - 1;
            let short: String = base.chars().take(room).collect();
            let tried = format!("{} {digits}", short.trim_end());
            *next += 1;
            if !self.taken.contains(&tried) {
                return tried;
            }
        }
    }
}
