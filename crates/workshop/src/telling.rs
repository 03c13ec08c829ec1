//! What is told of edits in the list of history.

use std::sync::Arc;

use antipode_rooms::{Object, Room};
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
    let mut ids = fields.iter().map(|it| of_field(&it.key));
    let Some(first) = ids.next() else {
        return "change";
    };
    ids.fold(first, |so_far, id| match (so_far, id) {
        (a, b) if a == b => a,
        ("rename", _) | (_, "rename") => "rename",
        ("move" | "turn" | "pose", "move" | "turn" | "pose") => "pose",
        ("resize" | "move", "resize" | "move") => "resize",
        ("stretch" | "resize" | "move", "stretch" | "resize" | "move") => "stretch",
        _ => "change",
    })
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
        Edit::Change(name, fields) => changed(&[(name, fields.as_slice())]),
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

/// Of changes of several objects: what is told of all of them, if that is the same.
fn changed(changes: &[(&String, &[Field])]) -> Said {
    let names: Vec<_> = changes.iter().map(|(name, _)| (*name).clone()).collect();
    let mut ids = changes.iter().map(|(_, fields)| of_fields(fields));
    let first = ids.next().unwrap_or("change");
    let id = if ids.all(|it| it == first) {
        first
    } else {
        "change"
    };
    let said = Said::of(id, &names);
    let new_name = changes
        .iter()
        .find_map(|(_, fields)| fields.iter().find(|it| it.key == "name"));
    match new_name {
        Some(field) if id == "rename" => said.with("new", field.value.clone()),
        _ => said,
    }
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
        return changed(&changes);
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
