//! What makes a room sound, as far as it can be told without the files beside it. Whoever reads, writes or changes a
//! room asks here, so there is one list of what is refused.

use std::ops::RangeInclusive;

use antipode_storage::{MAX_NAME_CHARS, NameError, is_unprintable};
use foldhash::fast::FixedState;
use glam::{DVec2, DVec3};

use crate::bounds::{
    FARTHEST_M, FASTEST_FALL_M_S2, MOST_ABERRATIONS, MOST_DEEP, MOST_LIGHTS, MOST_LOOSE,
    MOST_NAME_CHARS, MOST_OBJECTS, MOST_PORTALS, MOST_TEXT_CHARS, POWERS, TURNS_DEG,
};
use crate::check_kind::{check_kind, check_loose};
use crate::error::Fault;
use crate::pose::{parents, pose};
use crate::room::{Object, Places, Room, VERSION, What};
use crate::space::{space, space_so_far};

/// A mark for what is wrong in a room, before it is known which field of which object it is.
pub(crate) struct Wrong {
    /// The field within its object or room: `what.size`.
    pub field: String,
    /// What is wrong with it.
    pub reason: String,
}

pub(crate) type Checked = Result<(), Wrong>;

pub(crate) fn wrong(field: &str, reason: impl Into<String>) -> Wrong {
    Wrong {
        field: field.to_owned(),
        reason: reason.into(),
    }
}

/// Checks everything that a room says.
///
/// # Errors
/// The first that is wrong.
pub fn check(room: &Room) -> Result<(), Fault> {
    check_each(room)?;
    space(room).map(|_| ())
}

/// The same of a room that is being changed: its portals may not fit their partners yet.
///
/// # Errors
/// The first that is wrong.
pub fn check_so_far(room: &Room) -> Result<(), Fault> {
    check_each(room)?;
    space_so_far(room).map(|_| ())
}

/// The same of a room in an editor: its aberrations and portals may lie anyhow, and those that do not fit are closed.
///
/// # Errors
/// The first that is wrong.
pub fn check_each(room: &Room) -> Result<(), Fault> {
    check_whole(room).map_err(|it| Fault {
        field: it.field.clone(),
        path: it.field,
        reason: it.reason,
    })?;
    let mut names = Places::with_capacity_and_hasher(room.objects.len(), FixedState::default());
    for (index, object) in room.objects.iter().enumerate() {
        let in_object = |it: Wrong| fault(room, index, it);
        check_object(object).map_err(in_object)?;
        if let Some(first) = names.insert(object.name.as_str(), index) {
            let reason = format!(
                "is the name of object {} as well; names are unique",
                first + 1
            );
            return Err(in_object(wrong("name", reason)));
        }
    }
    check_groups(room)?;
    check_counts(room)
}

/// What is wrong with an object, told of the room.
pub(crate) fn fault(room: &Room, index: usize, it: Wrong) -> Fault {
    let name = &room.objects[index].name;
    let last = it.field.rsplit('.').next().unwrap_or(&it.field);
    let of = if it.field == "name" {
        format!("object {}", index + 1)
    } else {
        shown(name)
    };
    Fault {
        field: format!("{last} of {of}"),
        path: format!("objects[{index}].{}", it.field),
        reason: it.reason,
    }
}

/// A text of the file in quotes, without what could harm a terminal, and not too long.
pub fn shown(text: &str) -> String {
    let short: String = text.chars().take(MOST_NAME_CHARS + 1).collect();
    format!("\"{}\"", short.escape_debug())
}

fn check_whole(room: &Room) -> Checked {
    if room.version == 0 || room.version > VERSION {
        return Err(wrong(
            "version",
            format!("is {}, and there are 1 to {VERSION}", room.version),
        ));
    }
    check_room_name(&room.name).map_err(|reason| wrong("name", reason))?;
    check_text("sentence", &room.sentence)?;
    let fall = -FASTEST_FALL_M_S2..=FASTEST_FALL_M_S2;
    each("gravity", room.gravity, &fall, " m/s2 along each axis")?;
    one("sky.light", room.sky.light, &POWERS, "")?;
    if let Some(sun) = &room.sun {
        aim("sun.aim", sun.aim)?;
        one("sun.power", sun.power, &POWERS, "")?;
    }
    if let Some(fog) = &room.fog {
        one("fog.reach", fog.reach, &(1.0..=100_000.0), " m")?;
    }
    position("spawn.at", room.spawn.at)?;
    aim("spawn.look", room.spawn.look)?;
    if room.objects.len() > MOST_OBJECTS {
        let reason = format!(
            "has {} of them, and a room has at most {MOST_OBJECTS}",
            room.objects.len()
        );
        return Err(wrong("objects", reason));
    }
    Ok(())
}

/// What a room may be called: what a world may be called.
fn check_room_name(name: &str) -> Result<(), String> {
    antipode_storage::check_name(name).map_err(|error| match error {
        NameError::TooLong { chars } => {
            format!("has {chars} characters, and at most {MAX_NAME_CHARS} fit")
        }
        NameError::Unprintable(bad) => format!(
            "has a character that cannot be shown ({})",
            bad.escape_unicode()
        ),
        _ => "is to have at least one character that can be seen".to_owned(),
    })
}

fn check_object(object: &Object) -> Checked {
    check_name(&object.name).map_err(|reason| wrong("name", reason))?;
    position("at", object.at)?;
    each("turn", object.turn, &TURNS_DEG, " degrees")?;
    check_kind(&object.what)?;
    check_loose(&object.what, object.mass)?;
    let surface = &object.surface;
    one("surface.glow", surface.glow, &POWERS, "")?;
    if let Some(checker) = &surface.checker {
        one(
            "surface.checker.size",
            checker.size,
            &(0.01..=FARTHEST_M),
            " m",
        )?;
    }
    if let Some(texture) = &surface.texture {
        one(
            "surface.texture.size",
            texture.size,
            &(0.01..=FARTHEST_M),
            " m",
        )?;
        crate::files::check_texture(&texture.file)
            .map_err(|reason| wrong("surface.texture.file", reason))?;
    }
    Ok(())
}

/// What an object may be called, so that commands can name it.
pub(crate) fn check_name(name: &str) -> Result<(), String> {
    let chars = name.chars().count();
    let is_fit = |it: char| it.is_alphanumeric() || "-_. ".contains(it);
    if name.is_empty() {
        Err("is to have at least one character".to_owned())
    } else if chars > MOST_NAME_CHARS {
        Err(format!(
            "has {chars} characters, and at most {MOST_NAME_CHARS} fit"
        ))
    } else if let Some(bad) = name.chars().find(|it| !is_fit(*it) || is_unprintable(*it)) {
        Err(format!(
            "has the character {bad:?}; letters, digits, '-', '_', '.' and blanks can be used"
        ))
    } else if name.trim() != name {
        Err("begins or ends with a blank".to_owned())
    } else {
        Ok(())
    }
}

pub(crate) fn check_text(field: &str, text: &str) -> Checked {
    let chars = text.chars().count();
    if chars > MOST_TEXT_CHARS {
        return Err(wrong(
            field,
            format!("has {chars} characters, and at most {MOST_TEXT_CHARS} fit"),
        ));
    }
    match text.chars().find(|it| is_unprintable(*it)) {
        Some(bad) => Err(wrong(
            field,
            format!(
                "has a character that cannot be shown ({})",
                bad.escape_unicode()
            ),
        )),
        None => Ok(()),
    }
}

/// A number within a range; what is none is in no range.
pub(crate) fn one(field: &str, value: f64, range: &RangeInclusive<f64>, unit: &str) -> Checked {
    if range.contains(&value) {
        return Ok(());
    }
    Err(wrong(
        field,
        format!(
            "is to be {} to {}{unit}, and is {value}",
            range.start(),
            range.end()
        ),
    ))
}

/// Three numbers, each within a range.
pub(crate) fn each(field: &str, values: DVec3, range: &RangeInclusive<f64>, unit: &str) -> Checked {
    values
        .to_array()
        .into_iter()
        .try_for_each(|value| one(field, value, range, unit))
}

pub(crate) fn pair(field: &str, values: DVec2, range: &RangeInclusive<f64>, unit: &str) -> Checked {
    values
        .to_array()
        .into_iter()
        .try_for_each(|value| one(field, value, range, unit))
}

fn position(field: &str, at: DVec3) -> Checked {
    each(field, at, &(-FARTHEST_M..=FARTHEST_M), " m along each axis")
}

fn aim(field: &str, aim: DVec2) -> Checked {
    one(field, aim.x, &TURNS_DEG, " degrees of yaw")?;
    one(field, aim.y, &(-90.0..=90.0), " degrees of pitch")
}

fn check_groups(room: &Room) -> Result<(), Fault> {
    let parents = parents(room);
    let refuse = |index: usize, reason: &str| {
        let group = shown(room.objects[index].group.as_deref().unwrap_or_default());
        Err(fault(
            room,
            index,
            wrong("group", format!("is {group}, {reason}")),
        ))
    };
    let mut too_deep = None;
    for (index, object) in room.objects.iter().enumerate() {
        if object.group.is_some() && parents[index].is_none() {
            return refuse(index, "and there is no group of that name");
        }
        let up = std::iter::successors(parents[index], |at| parents[*at]);
        // One more than there are means a circle, perhaps of others.
        for (deep, parent) in up.take(room.objects.len()).enumerate() {
            if parent == index {
                return refuse(index, "which it carries itself");
            }
            if deep == MOST_DEEP {
                too_deep = too_deep.or(Some(index));
            }
        }
    }
    if let Some(index) = too_deep {
        return refuse(
            index,
            &format!("and groups carry one another at most {MOST_DEEP} deep"),
        );
    }
    let carried = (0..room.objects.len()).filter(|index| parents[*index].is_some());
    for index in carried {
        let at = pose(room, &parents, index).translation;
        if !at.abs().cmple(DVec3::splat(FARTHEST_M)).all() {
            let reason =
                format!("is more than {FARTHEST_M} m from the room's origin, by way of its group");
            return Err(fault(room, index, wrong("at", reason)));
        }
    }
    Ok(())
}

fn check_counts(room: &Room) -> Result<(), Fault> {
    let places = |is: fn(&What) -> bool| {
        room.objects
            .iter()
            .enumerate()
            .filter(move |(_, object)| is(&object.what))
            .map(|(index, _)| index)
    };
    let loose = room.loose().map(|(index, ..)| index).nth(MOST_LOOSE);
    let counts = [
        (
            "lights",
            MOST_LIGHTS,
            places(|it| matches!(it, What::Light { .. })).nth(MOST_LIGHTS),
        ),
        (
            "aberrations",
            MOST_ABERRATIONS,
            places(|it| matches!(it, What::Aberration(_))).nth(MOST_ABERRATIONS),
        ),
        (
            "portals",
            MOST_PORTALS,
            places(|it| matches!(it, What::Portal(_))).nth(MOST_PORTALS),
        ),
        ("loose things", MOST_LOOSE, loose),
    ];
    for (what, most, beyond) in counts {
        if let Some(index) = beyond {
            return Err(fault(
                room,
                index,
                wrong(
                    "what",
                    format!("is one too many: a room has at most {most} {what}"),
                ),
            ));
        }
    }
    Ok(())
}
