//! What a drag, or a step of the arrow keys, makes of what is chosen: an edit that counts from the room before the drag.

use std::sync::Arc;

use antipode_room_scene::workshop::Change;
use antipode_rooms::aberration::{Aberration, Lengths};
use antipode_rooms::bounds::{HALVES_M, SIZES_M, STRETCHES};
use antipode_rooms::portal::Opening;
use antipode_rooms::words::{Pairs, set};
use antipode_rooms::{Object, Room, What, rotation};
use antipode_workshop::{Edit, Field, Placed, closure, turn_of};
use glam::{DAffine3, DMat3, DQuat, DVec2, DVec3};

use super::chosen::{half, roots};

/// The edit of a room whose objects have these poses; none where it would change nothing.
pub fn edit(
    (room, poses): (&Room, &[DAffine3]),
    chosen: &[String],
    origin: DVec3,
    change: &Change,
) -> Option<Edit> {
    let roots = roots(room, chosen).into_iter();
    let things = roots.map(|index| (room.objects[index].as_ref(), &poses[index]));
    let edit = match *change {
        Change::Move(way) if way == DVec3::ZERO => return None,
        Change::Turn(_, 0.0) => return None,
        Change::Move(way) => Edit::Place(things.map(|(it, pose)| moved(it, pose, way)).collect()),
        Change::Turn(axis, rad) => {
            let turn = DQuat::from_axis_angle(axis, rad);
            Edit::Place(
                things
                    .map(|(it, pose)| turned(it, pose, origin, turn))
                    .collect(),
            )
        }
        Change::Scale(times) => several(things.flat_map(|(it, _)| match it.what {
            What::Group => group(room, it, most(times)),
            _ => vec![(it, resized(it, times))],
        })),
        Change::Feel(times) => {
            several(things.map(|(it, _)| (it, felt(&it.what, times).into_iter().collect())))
        }
    };
    (!edit.touched().is_empty()).then_some(edit)
}

/// Changes of fields of several things, but for those of which none changes.
fn several<'r>(all: impl Iterator<Item = (&'r Object, Vec<Field>)>) -> Edit {
    let all = all.filter(|(_, fields)| !fields.is_empty());
    Edit::Several(
        all.map(|(it, fields)| Edit::Change(it.name.clone(), fields))
            .collect(),
    )
}

/// The pose of what carries an object.
fn parent(object: &Object, pose: &DAffine3) -> DAffine3 {
    match object.group {
        Some(_) => *pose * antipode_rooms::own_pose(object).inverse(),
        None => DAffine3::IDENTITY,
    }
}

fn moved(object: &Object, pose: &DAffine3, way: DVec3) -> Placed {
    let within = parent(object, pose).inverse();
    Placed {
        name: object.name.clone(),
        at: Some(tidy(within.transform_point3(pose.translation + way))),
        turn: None,
    }
}

fn turned(object: &Object, pose: &DAffine3, origin: DVec3, turn: DQuat) -> Placed {
    let within = parent(object, pose).inverse();
    let place = origin + turn * (pose.translation - origin);
    let own = within.matrix3 * DMat3::from_quat(turn) * pose.matrix3;
    let is_moved = place.distance(pose.translation) > 1e-9;
    Placed {
        name: object.name.clone(),
        at: is_moved.then(|| tidy(within.transform_point3(place))),
        turn: Some(turn_of(DQuat::from_mat3(&own))),
    }
}

/// Rounded to a thousandth of a millimetre, so that files stay readable.
fn tidy(v: DVec3) -> DVec3 {
    v.map(|one| (one * 1e6).round() / 1e6 + 0.0)
}

fn size3(size: DVec3, times: DVec3) -> DVec3 {
    tidy((size * times).map(|one| one.clamp(*SIZES_M.start(), *SIZES_M.end())))
}

fn size1(size: f64, times: f64) -> f64 {
    size3(DVec3::splat(size), DVec3::splat(times)).x
}

/// A board's: its width lies along z, its height along y.
fn size2(size: DVec2, times: DVec3) -> DVec2 {
    DVec2::new(size1(size.x, times.z), size1(size.y, times.y))
}

/// The factor of a thing that is round: that of the axis which changes most.
fn most(times: DVec3) -> f64 {
    let all = times.to_array();
    let by = |it: &f64| (it.ln()).abs();
    all.into_iter()
        .max_by(|a, b| by(a).total_cmp(&by(b)))
        .unwrap_or(1.0)
}

/// A thing that is made so many times as large along its axes: the side away from the handle stays where it is, and so does the lower
/// one, or what stands on the ground would sink into it.
fn resized(object: &Object, times: DVec3) -> Vec<Field> {
    let Some((mut fields, half)) = scaled(&object.what, times) else {
        return Vec::new();
    };
    if let Some(before) = stays(&object.what) {
        let mut grown = half - before;
        for axis in [0, 2] {
            if times[axis] == 1.0 {
                grown[axis] = 0.0;
            }
        }
        let at = tidy(object.at + rotation(object.turn) * grown);
        fields.push(Field::three("at", at));
    }
    fields
}

/// Where a thing goes whose fields change, so that its lower side stays; none where that is where it is.
pub fn footing(object: &Object, fields: &[Field]) -> Option<Field> {
    let before = stays(&object.what)?;
    let pairs = fields.iter().map(|it| (it.key.as_str(), it.value.as_str()));
    let mut after = object.clone();
    set(&mut after, &Pairs::from_pairs(pairs).ok()?, false).ok()?;
    let up = DVec3::Y * (half(&after.what).y - before.y);
    (up != DVec3::ZERO).then(|| Field::three("at", tidy(object.at + rotation(object.turn) * up)))
}

/// A group that is made so many times as large: all that it carries grows, and moves away from where the group is.
fn group<'r>(room: &'r Room, group: &Object, times: f64) -> Vec<(&'r Object, Vec<Field>)> {
    let carried = closure(room, std::slice::from_ref(&group.name));
    let all = room.objects.iter().map(Arc::as_ref);
    let all = all.filter(|it| it.name != group.name && carried.contains(it.name.as_str()));
    all.map(|it| {
        let scaled = scaled(&it.what, DVec3::splat(times));
        let mut fields = scaled.map_or_else(Vec::new, |(fields, _)| fields);
        fields.push(Field::three("at", tidy(it.at * times)));
        (it, fields)
    })
    .collect()
}

/// How far from its middle the sides are of which one stays while a thing grows, metres. A model and a group grow about their
/// own origins.
pub fn stays(what: &What) -> Option<DVec3> {
    let has_own = matches!(what, What::Model { .. } | What::Group | What::Light { .. });
    (!has_own).then(|| half(what))
}

/// The fields of a thing that is made so many times as large along its axes, and its half sizes then.
fn scaled(what: &What, times: DVec3) -> Option<(Vec<Field>, DVec3)> {
    let board = |size: DVec2| DVec3::new(half(what).x, size.y / 2.0, size.x / 2.0);
    Some(match what {
        What::Box { size }
        | What::Pyramid { size }
        | What::Ramp { size }
        | What::Stairs { size, .. } => {
            let size = size3(*size, times);
            (vec![Field::three("size", size)], size / 2.0)
        }
        What::Arch { size, opening } => {
            let size = size3(*size, times);
            let opening = Field::two("opening", size2(*opening, times));
            (vec![Field::three("size", size), opening], size / 2.0)
        }
        What::Cylinder { radius, height } => {
            let radius = size1(*radius, most(times.with_y(1.0)));
            let height = size1(*height, times.y);
            let fields = vec![
                Field::number("radius", radius),
                Field::number("height", height),
            ];
            (fields, DVec3::new(radius, height / 2.0, radius))
        }
        What::Ball { radius } => {
            let radius = size1(*radius, most(times));
            (vec![Field::number("radius", radius)], DVec3::splat(radius))
        }
        What::Model { scale, .. } => {
            let scale = size1(*scale, most(times));
            (vec![Field::number("scale", scale)], DVec3::splat(scale))
        }
        What::Sign { size, .. } => {
            let size = size2(*size, times);
            (vec![Field::two("size", size)], board(size))
        }
        What::Portal(it) => match &it.opening {
            Opening::Size(size) => {
                let size = size2(*size, times);
                (vec![Field::two("size", size)], board(size))
            }
            Opening::Polygon(_) => return None,
        },
        What::Aberration(it) => aberration(it, times),
        What::Light { .. } | What::Group => return None,
    })
}

/// A box that grows feels as many times as long as before.
fn aberration(it: &Aberration, times: DVec3) -> (Vec<Field>, DVec3) {
    let clamped = |one: f64| one.clamp(*HALVES_M.start(), *HALVES_M.end());
    let half = tidy((it.half * times).map(clamped));
    let mut fields = vec![Field::three("half", half)];
    if let Lengths::Felt { axis, felt_m } = it.lengths {
        let grown = half[axis.index()] / it.half[axis.index()];
        fields.push(Field::number("felt", round(felt_m * grown)));
    }
    (fields, half)
}

fn round(metres: f64) -> f64 {
    (metres * 1e4).round() / 1e4
}

/// Its felt length times so many, as far as that may be.
pub fn felt(what: &What, times: f64) -> Option<Field> {
    let What::Aberration(it) = what else {
        return None;
    };
    let Lengths::Felt { axis, felt_m } = it.lengths else {
        return None;
    };
    let length = 2.0 * it.half[axis.index()];
    let felt = (felt_m * times).clamp(length * STRETCHES.start(), length * STRETCHES.end());
    // A felt length is told in centimetres, or finer where it is short.
    let step = if felt > 2.0 { 100.0 } else { 1e4 };
    let nearest = (felt * step).round() / step;
    let is_within = STRETCHES.contains(&(nearest / length));
    Some(Field::number(
        "felt",
        if is_within { nearest } else { felt },
    ))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]

    use antipode_rooms::poses;
    use antipode_workshop::make;

    use super::*;

    fn room() -> Room {
        let mut room = Room::new("a");
        let mut group = Object::new("group", DVec3::new(10.0, 0.0, 0.0), What::Group);
        group.turn.x = 90.0;
        let mut block = Object::new(
            "block",
            DVec3::new(1.0, 2.0, 3.0),
            What::Box { size: DVec3::ONE },
        );
        block.group = Some("group".to_owned());
        room.push(group);
        room.push(block);
        room
    }

    fn changed(change: &Change, origin: DVec3) -> DAffine3 {
        let room = room();
        let all = poses(&room);
        let edit = edit((&room, &all), &["block".to_owned()], origin, change).unwrap();
        poses(&make(&room, &edit).unwrap())[2]
    }

    #[test]
    fn what_a_turned_group_carries_moves_along_the_axes_of_the_room() {
        let before = poses(&room())[2].translation;
        let way = DVec3::new(0.5, 1.0, -2.0);
        let after = changed(&Change::Move(way), before).translation;
        assert!(after.distance(before + way) < 1e-9, "{before} {after}");
    }

    #[test]
    fn what_is_turned_goes_round_where_the_handles_are() {
        let pose = poses(&room())[2];
        let origin = pose.translation + DVec3::X;
        let after = changed(&Change::Turn(DVec3::Y, 0.5), origin);
        let turn = DQuat::from_rotation_y(0.5);
        let there = origin + turn * (pose.translation - origin);
        assert!(after.translation.distance(there) < 1e-5);
        let front = after.matrix3 * DVec3::X;
        assert!(
            front.distance(turn * (pose.matrix3 * DVec3::X)) < 1e-5,
            "{front}"
        );
    }

    #[test]
    fn what_grows_stays_on_the_ground_and_on_the_side_away_from_the_handle() {
        let size = DVec3::new(4.0, 2.5, 0.25);
        for what in [
            What::Box { size },
            What::Ball { radius: 0.5 },
            What::Cylinder {
                radius: 0.5,
                height: 2.0,
            },
            What::Sign {
                text: None,
                size: DVec2::ONE,
            },
        ] {
            let mut room = Room::new("a");
            let mut thing = Object::new("it", DVec3::new(1.0, 2.0, 3.0), what.clone());
            thing.turn.x = 90.0;
            room.push(thing);
            for axis in 0..3 {
                let mut times = DVec3::ONE;
                times[axis] = 2.0;
                let side = |room: &Room| {
                    let (all, it) = (poses(room), room.objects.last().unwrap());
                    let pose = *all.last().unwrap();
                    let low = pose.transform_point3(DVec3::NEG_Y * half(&it.what).y);
                    let mut away = DVec3::ZERO;
                    away[axis] = -half(&it.what)[axis];
                    (
                        low.y,
                        pose.transform_point3(away)[if axis == 1 { 1 } else { 2 - axis }],
                    )
                };
                let all = poses(&room);
                let edit = edit(
                    (&room, &all),
                    &["it".to_owned()],
                    DVec3::ZERO,
                    &Change::Scale(times),
                );
                let made = make(&room, &edit.unwrap()).unwrap();
                let ((low, away), (low_then, away_then)) = (side(&room), side(&made));
                assert!(
                    (low - low_then).abs() < 1e-6,
                    "{what:?} {axis}: {low} {low_then}"
                );
                assert!(
                    (away - away_then).abs() < 1e-6,
                    "{what:?} {axis}: {away} {away_then}"
                );
            }
        }
    }

    #[test]
    fn a_group_that_grows_is_in_proportion_as_before() {
        let room = room();
        let all = poses(&room);
        let twice = Change::Scale(DVec3::new(1.0, 2.0, 1.0));
        let edit = edit((&room, &all), &["group".to_owned()], DVec3::ZERO, &twice).unwrap();
        let made = make(&room, &edit).unwrap();
        let (_, block) = made.find("block").unwrap();
        assert_eq!(block.at, DVec3::new(2.0, 4.0, 6.0));
        assert_eq!(
            block.what,
            What::Box {
                size: DVec3::splat(2.0)
            }
        );
        assert_eq!(
            made.find("group").unwrap().1.at,
            room.find("group").unwrap().1.at
        );
    }

    #[test]
    fn a_felt_length_stays_within_what_space_can_be_stretched() {
        let what = What::Aberration(Aberration {
            half: DVec3::new(1.0, 1.0, 39.5),
            lengths: Lengths::Felt {
                axis: antipode_rooms::aberration::Axis::Z,
                felt_m: 395.0,
            },
            sides: antipode_rooms::aberration::Sides::Walls,
            ways: antipode_rooms::aberration::Ways::Both,
            outline: false,
        });
        assert_eq!(felt(&what, 2.0), Some(Field::number("felt", 790.0)));
        let Field { value, .. } = felt(&what, 1000.0).unwrap();
        assert_eq!(value.parse::<f64>().unwrap(), 79.0 * 32.0);
        let (grown, _) = scaled(&what, DVec3::new(1.0, 1.0, 2.0)).unwrap();
        assert_eq!(grown[1], Field::number("felt", 790.0));
    }
}
