//! What a drag, or a step of the arrow keys, makes of what is chosen: an edit that counts from the room before the drag.

use antipode_room_scene::workshop::Change;
use antipode_rooms::aberration::{Aberration, Lengths};
use antipode_rooms::bounds::{HALVES_M, SIZES_M, STRETCHES};
use antipode_rooms::portal::Opening;
use antipode_rooms::{Object, Room, What};
use antipode_workshop::{Edit, Field, Placed, turn_of};
use glam::{DAffine3, DMat3, DQuat, DVec2, DVec3};

use super::chosen::roots;

/// The edit of a room whose objects have these poses; none where it would change nothing.
pub fn edit(
    (room, poses): (&Room, &[DAffine3]),
    chosen: &[String],
    origin: DVec3,
    change: &Change,
) -> Option<Edit> {
    let roots = roots(room, chosen).into_iter();
    let things = roots.map(|index| (room.objects[index].as_ref(), &poses[index]));
    let sized = |fields: &dyn Fn(&What) -> Vec<Field>| {
        let all = things.clone().map(|(it, _)| (it, fields(&it.what)));
        let all = all.filter(|(_, fields)| !fields.is_empty());
        Edit::Several(
            all.map(|(it, fields)| Edit::Change(it.name.clone(), fields))
                .collect(),
        )
    };
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
        Change::Scale(times) => sized(&|what| scaled(what, times)),
        Change::Feel(times) => sized(&|what| felt(what, times).into_iter().collect()),
    };
    (!edit.touched().is_empty()).then_some(edit)
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

fn scaled(what: &What, times: DVec3) -> Vec<Field> {
    match what {
        What::Box { size }
        | What::Pyramid { size }
        | What::Ramp { size }
        | What::Stairs { size, .. } => vec![Field::three("size", size3(*size, times))],
        What::Arch { size, opening } => vec![
            Field::three("size", size3(*size, times)),
            Field::two("opening", size2(*opening, times)),
        ],
        What::Cylinder { radius, height } => vec![
            Field::number(
                "radius",
                size1(*radius, most(DVec3::new(times.x, 1.0, times.z))),
            ),
            Field::number("height", size1(*height, times.y)),
        ],
        What::Ball { radius } => vec![Field::number("radius", size1(*radius, most(times)))],
        What::Model { scale, .. } => vec![Field::number("scale", size1(*scale, most(times)))],
        What::Sign { size, .. } => vec![Field::two("size", size2(*size, times))],
        What::Portal(it) => match &it.opening {
            Opening::Size(size) => vec![Field::two("size", size2(*size, times))],
            Opening::Polygon(_) => Vec::new(),
        },
        What::Aberration(it) => aberration(it, times),
        What::Light { .. } | What::Group => Vec::new(),
    }
}

/// A box that grows feels as many times as long as before.
fn aberration(it: &Aberration, times: DVec3) -> Vec<Field> {
    let clamped = |one: f64| one.clamp(*HALVES_M.start(), *HALVES_M.end());
    let half = tidy((it.half * times).map(clamped));
    let mut fields = vec![Field::three("half", half)];
    if let Lengths::Felt { axis, felt_m } = it.lengths {
        let grown = half[axis.index()] / it.half[axis.index()];
        fields.push(Field::number("felt", round(felt_m * grown)));
    }
    fields
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
        let grown = scaled(&what, DVec3::new(1.0, 1.0, 2.0));
        assert_eq!(grown[1], Field::number("felt", 790.0));
    }
}
