//! What an edit makes of a room.

use std::collections::HashSet;
use std::sync::Arc;

use antipode_rooms::words::{Pairs, set, set_spawn};
use antipode_rooms::{Object, Room, What, own_pose, shown};
use glam::{DAffine3, DQuat, DVec3};

use crate::clip::Clip;
use crate::copies::{FreeNames, carried, closure};
use crate::edit::{Array, Edit, Field, Placed};
use crate::error::{WorkshopError, missing, refuse};
use crate::place::{Groups, put, tidy, turn_of};
use crate::room_fields::set_room;

/// The most copies of an array.
pub const MOST_COPIES: u32 = 200;

type Made = Result<(), WorkshopError>;

/// What a room is after an edit. Whether that is sound is not looked at.
///
/// # Errors
/// If it names what is not there, or says what makes no sense.
pub fn make(room: &Room, edit: &Edit) -> Result<Room, WorkshopError> {
    let mut made = room.clone();
    make_in(&mut made, edit)?;
    Ok(made)
}

/// The same in the room itself, which may be changed in part if the edit is refused.
pub(crate) fn make_in(room: &mut Room, edit: &Edit) -> Made {
    match edit {
        Edit::Insert(object) => {
            room.push(object.clone());
            Ok(())
        }
        Edit::Remove(names) => remove(room, names),
        Edit::Change(name, fields) => change(room, name, fields),
        Edit::Place(placed) => place(room, placed),
        Edit::Group { name, at, members } => group(room, name, *at, members),
        Edit::Carry { group, members } => carry(room, group.as_deref(), members),
        Edit::Ungroup(names) => ungroup(room, names),
        Edit::Duplicate { names, by } => {
            let array = Array {
                names: names.clone(),
                count: 1,
                step: *by,
                turn_deg: 0.0,
                about: None,
            };
            copy_in_a_row(room, &array)
        }
        Edit::Array(array) => copy_in_a_row(room, array),
        Edit::Paste { clip, by, .. } => {
            paste(room, clip, *by);
            Ok(())
        }
        Edit::Room(fields) => set_room(room, fields),
        Edit::Spawn(fields) => Ok(set_spawn(&mut room.spawn, &pairs(fields)?)?),
        Edit::Several(edits) => several(room, edits),
    }
}

/// Changes of many objects in a row look for all of them at once.
fn several(room: &mut Room, edits: &[Edit]) -> Made {
    let is_plain = |edit: &Edit| match edit {
        Edit::Change(_, fields) => fields.iter().all(|it| it.key != "name"),
        _ => false,
    };
    for run in edits.chunk_by(|a, b| is_plain(a) && is_plain(b)) {
        let at = match run {
            [_] => None,
            run => Some(indices(room, run)?),
        };
        for (number, edit) in run.iter().enumerate() {
            match (edit, &at) {
                (Edit::Change(_, fields), Some(at)) => {
                    set(room.object_mut(at[number]), &pairs(fields)?, false)?;
                }
                _ => make_in(room, edit)?,
            }
        }
    }
    Ok(())
}

/// The place of the object of each change.
fn indices(room: &Room, changes: &[Edit]) -> Result<Vec<usize>, WorkshopError> {
    let places = room.places();
    let touched = changes.iter().flat_map(Edit::touched);
    touched
        .map(|name| places.get(name).copied().map_or_else(|| missing(name), Ok))
        .collect()
}

pub(crate) fn pairs(fields: &[Field]) -> Result<Pairs<'_>, WorkshopError> {
    let all = fields.iter().map(|it| (it.key.as_str(), it.value.as_str()));
    Ok(Pairs::from_pairs(all)?)
}

fn exist(room: &Room, names: &[String]) -> Made {
    let places = room.places();
    match names
        .iter()
        .find(|name| !places.contains_key(name.as_str()))
    {
        Some(name) => missing(name),
        None => Ok(()),
    }
}

fn remove(room: &mut Room, names: &[String]) -> Made {
    exist(room, names)?;
    let gone: HashSet<String> = closure(room, names)
        .into_iter()
        .map(str::to_owned)
        .collect();
    room.objects.retain(|it| !gone.contains(&it.name));
    Ok(())
}

fn change(room: &mut Room, name: &str, fields: &[Field]) -> Made {
    let pairs = pairs(fields)?;
    let Some((index, _)) = room.find(name) else {
        return missing(name);
    };
    let object = room.object_mut(index);
    set(object, &pairs, false)?;
    if object.name == name {
        return Ok(());
    }
    let new_name = object.name.clone();
    for object in &mut room.objects {
        if object.group.as_deref() == Some(name) {
            Arc::make_mut(object).group = Some(new_name.clone());
        }
        if matches!(&object.what, What::Portal(it) if it.to == *name)
            && let What::Portal(it) = &mut Arc::make_mut(object).what
        {
            it.to.clone_from(&new_name);
        }
    }
    Ok(())
}

fn place(room: &mut Room, placed: &[Placed]) -> Made {
    let places = room.places();
    let found = placed.iter().map(|it| {
        let index = places.get(it.name.as_str()).copied();
        index.map_or_else(|| missing(&it.name), Ok)
    });
    let found: Vec<usize> = found.collect::<Result<_, _>>()?;
    for (index, to) in found.into_iter().zip(placed) {
        let object = room.object_mut(index);
        object.at = to.at.unwrap_or(object.at);
        object.turn = to.turn.unwrap_or(object.turn);
    }
    Ok(())
}

fn group(room: &mut Room, name: &str, at: DVec3, members: &[String]) -> Made {
    exist(room, members)?;
    // Something else of that name is refused when the room is checked.
    if !has_group(room, name) {
        room.push(Object::new(name, at, What::Group));
    }
    carry(room, Some(name), members)
}

fn has_group(room: &Room, name: &str) -> bool {
    let mut all = room.objects.iter();
    all.any(|it| it.name == name && it.what == What::Group)
}

fn carry(room: &mut Room, group: Option<&str>, members: &[String]) -> Made {
    exist(room, members)?;
    if let Some(name) = group
        && !has_group(room, name)
    {
        return refuse(format!("There is no group {} in this room.", shown(name)));
    }
    let groups = Groups::of(room);
    let to = groups.pose(group);
    let places = room.places();
    let from: Vec<_> = members
        .iter()
        .filter_map(|name| places.get(name.as_str()).copied())
        .map(|index| (index, groups.pose(room.objects[index].group.as_deref())))
        .collect();
    for (index, from) in from {
        let object = room.object_mut(index);
        put(object, from, to);
        object.group = group.map(str::to_owned);
    }
    Ok(())
}

fn ungroup(room: &mut Room, names: &[String]) -> Made {
    let gone: HashSet<&str> = names.iter().map(String::as_str).collect();
    exist(room, names)?;
    let is_other = |it: &&Arc<Object>| gone.contains(it.name.as_str()) && it.what != What::Group;
    if let Some(other) = room.objects.iter().find(is_other) {
        return refuse(format!("{} is no group.", shown(&other.name)));
    }
    let groups = Groups::of(room);
    let mut freed = Vec::new();
    for (index, object) in room.objects.iter().enumerate() {
        let group = object.group.as_deref().filter(|it| gone.contains(it));
        if group.is_none() || gone.contains(object.name.as_str()) {
            continue;
        }
        // The first of the groups around it that stays.
        let mut up = groups.up(group).into_iter();
        let outer = up.find(|it| !gone.contains(it.name.as_str()));
        let outer = outer.map(|it| it.name.clone());
        freed.push((
            index,
            groups.pose(group),
            groups.pose(outer.as_deref()),
            outer,
        ));
    }
    for (index, from, to, outer) in freed {
        let object = room.object_mut(index);
        put(object, from, to);
        object.group = outer;
    }
    room.objects.retain(|it| !gone.contains(it.name.as_str()));
    Ok(())
}

fn copy_in_a_row(room: &mut Room, array: &Array) -> Made {
    exist(room, &array.names)?;
    if !(1..=MOST_COPIES).contains(&array.count) {
        return refuse(format!(
            "{} copies are not possible; 1 to {MOST_COPIES} are.",
            array.count
        ));
    }
    let picked = carried(room, &array.names);
    let within = closure(room, &array.names);
    let groups = Groups::of(room);
    // The axes that each counts from that no other of them carries.
    let frames: Vec<_> = picked
        .iter()
        .map(|it| match &it.group {
            Some(group) if within.contains(group.as_str()) => None,
            group => Some(groups.pose(group.as_deref())),
        })
        .collect();
    let originals: Vec<Arc<Object>> = picked.into_iter().cloned().collect();
    let mut names = FreeNames::of(room);
    for number in 1..=array.count {
        let mut copies = originals.clone();
        for (copy, frame) in copies.iter_mut().zip(&frames) {
            if let Some(frame) = frame {
                place_copy(Arc::make_mut(copy), *frame, array, f64::from(number));
            }
        }
        room.objects.extend(names.named_anew(copies));
    }
    Ok(())
}

/// Puts the copy of that number where it is to be; its group has that pose in the room.
fn place_copy(copy: &mut Object, frame: DAffine3, array: &Array, number: f64) {
    let step = array.step * number;
    if array.turn_deg == 0.0 {
        if frame == DAffine3::IDENTITY {
            copy.at += step;
        } else {
            copy.at = tidy(copy.at + frame.matrix3.inverse() * step);
        }
        return;
    }
    // A positive yaw takes +x to +z, which is a turn about y the other way.
    let turn = DQuat::from_rotation_y(-(array.turn_deg * number).to_radians());
    let pose = frame * own_pose(copy);
    let at = array.about.map_or(pose.translation, |about| {
        about + turn * (pose.translation - about)
    });
    let turned =
        DAffine3::from_rotation_translation(turn * DQuat::from_mat3(&pose.matrix3), at + step);
    let own = frame.inverse() * turned;
    copy.at = tidy(own.translation);
    copy.turn = turn_of(DQuat::from_mat3(&own.matrix3));
}

/// The objects that a paste puts in, as they are called then.
pub(crate) fn pasted(room: &Room, clip: &Clip, by: DVec3) -> Vec<Arc<Object>> {
    let mut copies = clip.objects.clone();
    for copy in copies.iter_mut().filter(|it| it.group.is_none()) {
        Arc::make_mut(copy).at += by;
    }
    FreeNames::of(room).named_anew(copies)
}

fn paste(room: &mut Room, clip: &Clip, by: DVec3) {
    let objects = pasted(room, clip, by);
    room.objects.extend(objects);
}
