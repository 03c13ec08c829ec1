//! What orders do while a room is open.

use antipode_room_scene::RoomScene;
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
        Order::Give(..) | Order::GiveGround(..) => Some("give"),
        Order::Make(_) => Some("make"),
        Order::NameFlag(_) => Some("name-flag"),
        Order::Spawn(..) => Some("spawn"),
        Order::Perf(_) => Some("perf"),
        Order::Set(setting) if !matches!(setting, Setting::Own(..) | Setting::Quality(_)) => {
            Some("set")
        }
        _ => None,
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
        let shape = tuning::SHAPE;
        assert_eq!(shape.height_m, worlds.height_m);
        assert_eq!(shape.step_m, worlds.step_height_m);
        assert_eq!(shape.steepest_rad, worlds.max_slope_rad);
        assert_eq!(shape.eye_m + shape.radius_m, worlds.eye_height_m());
        assert_eq!(tuning::COYOTE_S, worlds.coyote_s);
        assert_eq!(tuning::JUMP_BUFFER_S, worlds.jump_buffer_s);
        assert_eq!(
            tuning::THIRD_PERSON_BACK_M,
            antipode_scene::tuning::THIRD_PERSON_BACK_M
        );
        assert_eq!(
            tuning::THIRD_PERSON_UP_M,
            antipode_scene::tuning::THIRD_PERSON_UP_M
        );
        assert_eq!(
            tuning::CAMERA_RADIUS_M,
            antipode_scene::tuning::CAMERA_RADIUS_M
        );
        assert_eq!(
            tuning::FIGURE_SEEN_FROM_M,
            antipode_scene::tuning::FIGURE_SEEN_FROM_M
        );
    }

    #[test]
    fn the_gun_and_lamps_are_those_of_worlds() {
        use antipode_scene::tuning as worlds;
        assert_eq!(tuning::BULLET_SPEED_M_S, worlds::BULLET_SPEED_M_S);
        assert_eq!(tuning::BULLET_RADIUS_M, worlds::BULLET.radius_m);
        assert_eq!(tuning::BULLET_REACH_M, worlds::BULLET_STRAIGHT_M);
        assert_eq!(tuning::AIM_REACH_M, worlds::AIM_REACH_M);
        assert_eq!(tuning::MUZZLE_M, worlds::MUZZLE_M);
        assert_eq!(tuning::SHOT_EVERY_S, worlds::SHOT_EVERY_S);
        assert_eq!(tuning::REACH_M, worlds::FIXTURE_REACH_M);
    }
}
