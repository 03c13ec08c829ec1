//! What orders do while a room is open.

use antipode_room_scene::{RoomScene, Steer};
use antipode_scene::Actions;
use glam::DVec3;

use super::parse::{Order, Setting};
use crate::failure::Failure;

/// Carries out an order that a room has a way of its own for; none for all others.
pub fn obey_in_room(room: &mut RoomScene, order: &Order) -> Option<Result<(), Failure>> {
    match order {
        Order::Aim(yaw, pitch) => {
            room.aim(*yaw, *pitch);
            Some(Ok(()))
        }
        Order::Teleport(feet, _) => {
            let there = room.teleport(DVec3::from_array(*feet));
            Some(there.map_err(|error| Failure::Usage(error.to_string())))
        }
        _ => only_in_worlds(order).map(|name| {
            Err(Failure::Usage(format!(
                "\"{name}\" is for worlds, and a room is open"
            )))
        }),
    }
}

/// The name of an order that makes sense in worlds only.
fn only_in_worlds(order: &Order) -> Option<&'static str> {
    match order {
        Order::Save => Some("save"),
        Order::Scroll(_) => Some("scroll"),
        Order::Give(..) => Some("give"),
        Order::NameFlag(_) => Some("name-flag"),
        Order::Spawn(..) => Some("spawn"),
        Order::Perf(_) => Some("perf"),
        Order::Set(setting) if !matches!(setting, Setting::Own(..) | Setting::Quality(_)) => {
            Some("set")
        }
        _ => None,
    }
}

/// What a step of a room takes of what is held and turned.
pub fn steer(actions: &Actions) -> Steer {
    Steer {
        forward: actions.forward,
        strafe: actions.strafe,
        sprint: actions.sprint,
        jump: actions.jump,
        look_yaw_rad: actions.look_yaw,
        look_pitch_rad: actions.look_pitch,
        shoot: actions.primary,
        place: actions.secondary,
        throw: actions.drop_one,
    }
}

#[cfg(test)]
mod tests {
    use antipode_physics::CharacterTuning;
    use antipode_room_scene::tuning;

    #[test]
    fn one_is_as_tall_and_as_fast_in_rooms_as_in_worlds() {
        let worlds = CharacterTuning::default();
        assert_eq!(tuning::WALK_SPEED_M_S, worlds.walk_speed_m_s);
        assert_eq!(tuning::SPRINT_FACTOR, worlds.sprint_factor);
        assert_eq!(tuning::RADIUS_M, worlds.radius_m);
        let jump = (2.0 * worlds.gravity_m_s2 * worlds.jump_height_m).sqrt();
        assert!((tuning::JUMP_SPEED_M_S - jump).abs() < 1e-6, "{jump}");
        assert_eq!(tuning::TERMINAL_SPEED_M_S, worlds.terminal_speed_m_s);
        assert_eq!(tuning::STEP_S, antipode_scene::tuning::STEP_S);
        use antipode_scene::tuning as world;
        assert_eq!(tuning::THIRD_PERSON_BACK_M, world::THIRD_PERSON_BACK_M);
        assert_eq!(tuning::THIRD_PERSON_UP_M, world::THIRD_PERSON_UP_M);
        assert_eq!(tuning::CAMERA_RADIUS_M, world::CAMERA_RADIUS_M);
        assert_eq!(tuning::FIGURE_SEEN_FROM_M, world::FIGURE_SEEN_FROM_M);
    }
}
