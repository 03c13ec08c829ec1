//! Where things are: turns as rotations, and groups that carry others.

use glam::{DAffine3, DQuat, DVec2, DVec3};

use crate::room::{Object, Room, What};

/// The rotation of a turn (yaw, pitch, roll) in degrees.
///
/// A turn takes +x to (cos yaw cos pitch, sin pitch, sin yaw cos pitch). Roll goes about x and changes nothing of that;
/// pitch about z takes x to (cos pitch, sin pitch, 0); and a turn of -yaw about y takes that to the whole.
pub fn rotation(turn_deg: DVec3) -> DQuat {
    let turn = turn_deg.map(f64::to_radians);
    DQuat::from_rotation_y(-turn.x)
        * DQuat::from_rotation_z(turn.y)
        * DQuat::from_rotation_x(turn.z)
}

/// Where (yaw, pitch) in degrees looks.
pub fn direction(aim_deg: DVec2) -> DVec3 {
    rotation(aim_deg.extend(0.0)) * DVec3::X
}

/// An object's own pose, in its group if it has one.
pub fn own_pose(object: &Object) -> DAffine3 {
    DAffine3::from_rotation_translation(rotation(object.turn), object.at)
}

/// The pose of every object in the room; of spawn, sun and the like no groups are known. Groups that are not there, or
/// that carry themselves, carry nothing.
pub fn poses(room: &Room) -> Vec<DAffine3> {
    let parents = parents(room);
    let all = 0..room.objects.len();
    all.map(|index| pose(room, &parents, index)).collect()
}

/// The pose of one of them, by the groups that carry each.
pub(crate) fn pose(room: &Room, parents: &[Option<usize>], index: usize) -> DAffine3 {
    let mut pose = own_pose(&room.objects[index]);
    let mut at = parents[index];
    for _ in 0..crate::bounds::MOST_DEEP {
        let Some(parent) = at else { break };
        pose = own_pose(&room.objects[parent]) * pose;
        at = parents[parent];
    }
    pose
}

/// The group that carries each object, by its place.
pub(crate) fn parents(room: &Room) -> Vec<Option<usize>> {
    let groups: std::collections::HashMap<&str, usize> = room
        .objects
        .iter()
        .enumerate()
        .filter(|(_, object)| object.what == What::Group)
        .map(|(index, object)| (object.name.as_str(), index))
        .collect();
    let of = |object: &Object| {
        object
            .group
            .as_ref()
            .and_then(|it| groups.get(it.as_str()).copied())
    };
    room.objects.iter().map(|it| of(it)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_take_the_front_to_where_one_aims() {
        let near = |a: DVec3, b: DVec3| assert!(a.distance(b) < 1e-12, "{a} {b}");
        near(direction(DVec2::ZERO), DVec3::X);
        near(direction(DVec2::new(-90.0, 0.0)), -DVec3::Z);
        near(direction(DVec2::new(90.0, 0.0)), DVec3::Z);
        near(direction(DVec2::new(0.0, 90.0)), DVec3::Y);
        let (yaw, pitch) = (0.7_f64, -0.3_f64);
        let aim = DVec3::new(
            yaw.cos() * pitch.cos(),
            pitch.sin(),
            yaw.sin() * pitch.cos(),
        );
        let turn = DVec3::new(yaw.to_degrees(), pitch.to_degrees(), 123.0);
        near(rotation(turn) * DVec3::X, aim);
        // A quarter roll takes the upright to the right-hand side, which is +z of what looks along +x.
        near(rotation(DVec3::new(0.0, 0.0, 90.0)) * DVec3::Y, DVec3::Z);
    }

    #[test]
    fn groups_carry_what_is_in_them() {
        let mut room = Room::new("a");
        let mut group = |name: &str, at: DVec3, yaw: f64, within: Option<&str>| {
            let mut it = Object::new(name, at, What::Group);
            it.turn.x = yaw;
            it.group = within.map(str::to_owned);
            room.push(it);
        };
        group("outer", DVec3::new(10.0, 0.0, 0.0), 90.0, None);
        group("inner", DVec3::new(1.0, 2.0, 0.0), 0.0, Some("outer"));
        let at = poses(&room)[2].translation;
        assert!(at.distance(DVec3::new(10.0, 2.0, 1.0)) < 1e-12, "{at}");
    }
}
