//! What is told of edits in the list of history.

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use antipode_rooms::bounds::MOST_DEEP;
use antipode_rooms::{Object, Room, What};
use glam::DVec3;

use crate::edit::{Edit, Field, Placed};
use crate::make::pasted;
use crate::said::Said;

/// The ids of all that is told of steps. Each is put into `name`, the first object, and `count`, how many there are, but for
/// `room`, `spawn`, `several`, `outside` and `version`, of which the last has `when`.
pub const STEPS: [&str; 25] = [
    "add",
    "remove",
    "move",
    "turn",
    "pose",
    "resize",
    "stretch",
    "sides",
    "surface",
    "link",
    "text",
    "light",
    "change",
    "rename",
    "group",
    "carry",
    "ungroup",
    "duplicate",
    "array",
    "paste",
    "room",
    "spawn",
    "several",
    "outside",
    "version",
];

/// What is told of a change of these fields.
fn of_fields(fields: &[Field]) -> &'static str {
    both(fields.iter().map(|it| of_field(&it.key)))
}

/// What is told of several changes as one.
fn both(ids: impl Iterator<Item = &'static str>) -> &'static str {
    let all = ids.reduce(|so_far, id| match (so_far, id) {
        (a, b) if a == b => a,
        ("rename", _) | (_, "rename") => "rename",
        ("move" | "turn" | "pose", "move" | "turn" | "pose") => "pose",
        ("resize" | "move", "resize" | "move") => "resize",
        ("stretch" | "resize" | "move", "stretch" | "resize" | "move") => "stretch",
        _ => "change",
    });
    all.unwrap_or("change")
}

fn of_field(key: &str) -> &'static str {
    match key {
        "name" => "rename",
        "at" => "move",
        "turn" => "turn",
        "size" | "radius" | "height" | "half" | "opening" | "polygon" | "scale" | "steps" => {
            "resize"
        }
        "felt" | "axis" | "stretch" => "stretch",
        "sides" | "exit" | "ways" => "sides",
        "colour" | "checker" | "texture" | "glow" | "finish" => "surface",
        "to" => "link",
        "text" => "text",
        "power" => "light",
        "group" => "carry",
        _ => "change",
    }
}

/// What is told of an edit of a room.
pub(crate) fn told(room: &Room, edit: &Edit) -> Said {
    match edit {
        Edit::Insert(object) => Said::of("add", std::slice::from_ref(&object.name)),
        Edit::Remove(names) => Said::of("remove", names),
        Edit::Change(name, fields) => changed(room, &[(name, fields.as_slice())]),
        Edit::Place(placed) => self::placed(placed),
        Edit::Group { name, members, .. } => group(name, members),
        Edit::Carry {
            group: Some(it),
            members,
        } => group(it, members),
        Edit::Carry {
            group: None,
            members,
        } => Said::of("carry", members),
        Edit::Ungroup(names) => Said::of("ungroup", names),
        Edit::Duplicate { names, .. } => Said::of("duplicate", names),
        Edit::Array(array) => Said::of("array", &array.names),
        Edit::Paste { clip, by, is_part } => {
            // What groups carry comes with them.
            let roots = |all: &[Arc<Object>]| -> Vec<String> {
                let roots = all.iter().filter(|it| it.group.is_none());
                roots.map(|it| it.name.clone()).collect()
            };
            let mut names = roots(&clip.objects);
            if let [_] = names[..] {
                // By the name that it gets in the room.
                names = roots(&pasted(room, clip, *by));
            }
            Said::of(if *is_part { "add" } else { "paste" }, &names)
        }
        Edit::Room(_) => Said::new("room"),
        Edit::Spawn(_) => Said::new("spawn"),
        Edit::Several(edits) => several(room, edits),
    }
}

fn group(name: &str, members: &[String]) -> Said {
    Said::new("group")
        .with("name", name)
        .with_number("count", members.len() as f64)
}

fn placed(placed: &[Placed]) -> Said {
    let has = |field: fn(&Placed) -> Option<DVec3>| placed.iter().any(|it| field(it).is_some());
    let id = match (has(|it| it.at), has(|it| it.turn)) {
        (_, false) => "move",
        (false, true) => "turn",
        (true, true) => "pose",
    };
    let first = placed.first().map(|it| it.name.clone());
    Said::new(id)
        .with("name", first.unwrap_or_default())
        .with_number("count", placed.len() as f64)
}

/// Of changes of several objects: what is told of all of them. What grows with all that a group
/// carries is the group.
fn changed(room: &Room, changes: &[(&String, &[Field])]) -> Said {
    let mut names: Vec<_> = changes.iter().map(|(name, _)| (*name).clone()).collect();
    let id = both(changes.iter().map(|(_, fields)| of_fields(fields)));
    if matches!(id, "resize" | "stretch")
        && let Some(group) = group_of_all(room, &names)
    {
        names = vec![group];
    }
    let said = Said::of(id, &names);
    let new_name = changes
        .iter()
        .find_map(|(_, fields)| fields.iter().find(|it| it.key == "name"));
    match new_name {
        Some(field) if id == "rename" => said.with("new", field.value.clone()),
        _ => said,
    }
}

/// The group that carries all of these, and nothing else but groups.
fn group_of_all(room: &Room, names: &[String]) -> Option<String> {
    let named: HashSet<_> = names.iter().map(String::as_str).collect();
    if named.len() < 2 {
        return None;
    }
    let groups = room.objects.iter().filter(|it| it.what == What::Group);
    let outer: HashMap<_, _> = groups
        .map(|it| (it.name.as_str(), it.group.as_deref()))
        .collect();
    let outermost = |object: &Object| {
        let mut found = None;
        let mut next = object.group.as_deref();
        for _ in 0..=MOST_DEEP {
            let Some(group) = next else { break };
            found = outer.get_key_value(group).map(|(name, _)| *name);
            next = outer.get(group).copied().flatten();
        }
        found
    };
    let first = room
        .objects
        .iter()
        .find(|it| named.contains(it.name.as_str()))?;
    let group = outermost(first)?;
    let mut carried = 0;
    for object in &room.objects {
        let is_named = named.contains(object.name.as_str());
        if outermost(object) == Some(group) {
            if !is_named && object.what != What::Group {
                return None;
            }
            carried += usize::from(is_named);
        }
    }
    let itself = usize::from(named.contains(group));
    (carried + itself == named.len()).then(|| group.to_owned())
}

fn several(room: &Room, edits: &[Edit]) -> Said {
    let changes: Vec<_> = edits
        .iter()
        .filter_map(|it| match it {
            Edit::Change(name, fields) => Some((name, fields.as_slice())),
            _ => None,
        })
        .collect();
    if changes.len() == edits.len() && !changes.is_empty() {
        return changed(room, &changes);
    }
    let inserted: Vec<_> = edits
        .iter()
        .filter_map(|it| match it {
            Edit::Insert(object) => Some(object.name.clone()),
            _ => None,
        })
        .collect();
    match edits {
        [one] => told(room, one),
        _ if inserted.len() == edits.len() => Said::of("add", &inserted),
        _ => Said::new("several").with_number("count", edits.len() as f64),
    }
}
