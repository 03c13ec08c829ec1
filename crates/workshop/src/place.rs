//! Where objects are in the room, and where they are in another group when they stay there.

use std::collections::HashMap;

use antipode_rooms::bounds::MOST_DEEP;
use antipode_rooms::{Object, Room, What, own_pose, rotation};
use glam::{DAffine3, DQuat, DVec3};

/// Numbers worked out from poses are rounded to so many parts of a metre or a degree, so that files stay readable.
const PARTS: f64 = 1e6;

/// The groups of a room, by their names, and what they are carried by.
pub(crate) struct Groups<'r> {
    room: &'r Room,
    by_name: HashMap<&'r str, usize>,
}

impl<'r> Groups<'r> {
    /// Those of a room.
    pub fn of(room: &'r Room) -> Self {
        let all = room.objects.iter().enumerate();
        let groups = all.filter(|(_, it)| it.what == What::Group);
        Self {
            room,
            by_name: groups
                .map(|(index, it)| (it.name.as_str(), index))
                .collect(),
        }
    }

    /// The groups that carry what is in a group, that itself first.
    pub fn up(&self, group: Option<&str>) -> Vec<&'r Object> {
        let mut found = Vec::new();
        let mut next = group.and_then(|it| self.by_name.get(it));
        while let Some(index) = next
            && found.len() <= MOST_DEEP
        {
            let object: &Object = &self.room.objects[*index];
            found.push(object);
            next = object.group.as_deref().and_then(|it| self.by_name.get(it));
        }
        found
    }

    /// The pose of a group in the room; that of the room for none.
    pub fn pose(&self, group: Option<&str>) -> DAffine3 {
        let up = self.up(group);
        up.iter()
            .fold(DAffine3::IDENTITY, |pose, it| own_pose(it) * pose)
    }
}

/// Puts an object where it is in the room into another frame. What is not moved by that keeps every digit.
pub(crate) fn put(object: &mut Object, from: DAffine3, to: DAffine3) {
    if from == to {
        return;
    }
    let pose = to.inverse() * from * own_pose(object);
    object.at = tidy(pose.translation);
    object.turn = turn_of(DQuat::from_mat3(&pose.matrix3));
}

/// Rounded to what matters.
pub(crate) fn tidy(v: DVec3) -> DVec3 {
    v.map(|one| (one * PARTS).round() / PARTS + 0.0)
}

/// The turn (yaw, pitch, roll) in degrees of a rotation: the way back from [`rotation`].
///
/// The front is where x goes, (cos yaw cos pitch, sin pitch, sin yaw cos pitch); what remains is a rotation about it. A front
/// that is upright has no yaw, and the roll has all of it.
pub fn turn_of(turn: DQuat) -> DVec3 {
    let front = turn * DVec3::X;
    let level = front.x.hypot(front.z);
    let yaw = if level < 1e-9 {
        0.0
    } else {
        front.z.atan2(front.x).to_degrees()
    };
    let pitch = front.y.atan2(level).to_degrees();
    let rest = rotation(DVec3::new(yaw, pitch, 0.0)).inverse() * turn;
    let mut roll = (2.0 * rest.x.atan2(rest.w)).to_degrees();
    if roll > 180.0 {
        roll -= 360.0;
    } else if roll <= -180.0 {
        roll += 360.0;
    }
    tidy(DVec3::new(yaw, pitch, roll))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_come_back_from_their_rotations() {
        for yaw in [-170.0, -90.0, 0.0, 33.5, 180.0] {
            for pitch in [-90.0, -45.0, 0.0, 60.0, 90.0] {
                for roll in [-120.0, 0.0, 77.0, 180.0] {
                    let turn = rotation(DVec3::new(yaw, pitch, roll));
                    let back = rotation(turn_of(turn));
                    assert!(turn.dot(back).abs() > 1.0 - 1e-12, "{yaw} {pitch} {roll}");
                }
            }
        }
        assert_eq!(
            turn_of(rotation(DVec3::new(30.0, 10.0, -5.0))),
            DVec3::new(30.0, 10.0, -5.0)
        );
    }
}
