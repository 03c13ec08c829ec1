//! How the view rights itself after a portal that turned it: who goes on upright sees the picture roll until it is level.

use antipode_rooms::direction;
use glam::{DQuat, DVec2, DVec3};

use crate::tuning::{PITCH_LIMIT_RAD, RIGHTING_S, STEP_S};
use crate::walk::Look;

/// How far the picture is rolled about the way one looks.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Righting {
    /// As a portal left it, radians, to the right of who looks.
    rolled_rad: f64,
    /// Of the time in which it is level again, seconds that are left.
    left_s: f64,
}

impl Righting {
    /// By how much the picture is rolled, radians.
    pub fn roll_rad(&self) -> f64 {
        let share = self.left_s / RIGHTING_S;
        self.rolled_rad * share * share * (3.0 - 2.0 * share)
    }

    /// A step passes.
    pub fn pass(&mut self) {
        self.left_s = (self.left_s - STEP_S).max(0.0);
    }

    /// It is level at once.
    pub fn right_at_once(&mut self) {
        self.left_s = 0.0;
    }

    /// A portal turns who looks so; where they look afterwards. What is in the middle of the picture stays there.
    pub fn turn(&mut self, look: &Look, turn: DQuat) -> Look {
        let [_, up] = axes(look, self.roll_rad());
        let (front, up) = (turn * look.front(), turn * up);
        let level = front.with_y(0.0);
        // Who looks straight up or down looks ahead where the head or the chin points.
        let ahead = if level.length() > 1e-3 {
            level
        } else {
            -up * front.y.signum()
        };
        let pitch_rad = front.y.clamp(-1.0, 1.0).asin();
        let turned = Look {
            yaw_rad: ahead.z.atan2(ahead.x),
            pitch_rad: pitch_rad.clamp(-PITCH_LIMIT_RAD, PITCH_LIMIT_RAD),
        };
        let [right, upright] = axes(&turned, 0.0);
        self.rolled_rad = up.dot(right).atan2(up.dot(upright));
        self.left_s = RIGHTING_S;
        turned
    }
}

/// To the right and to the top of a picture that is rolled so, each of length 1.
pub fn axes(look: &Look, roll_rad: f64) -> [DVec3; 2] {
    let front = look.front();
    let ahead = direction(DVec2::new(look.degrees().x, 0.0));
    let right = ahead.cross(DVec3::Y).normalize_or(DVec3::X);
    let up = right.cross(front);
    let (sin, cos) = roll_rad.sin_cos();
    [right * cos - up * sin, up * cos + right * sin]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_picture_does_not_jump_at_a_portal_and_is_level_after_two_fifths_of_a_second() {
        for (yaw, pitch) in [(0.3, 0.1), (2.0, -1.2), (-1.0, 0.9)] {
            for turn in [
                DQuat::from_rotation_z(1.5),
                DQuat::from_rotation_x(3.0),
                DQuat::from_rotation_y(2.0),
            ] {
                let before = Look {
                    yaw_rad: yaw,
                    pitch_rad: pitch,
                };
                let mut righting = Righting::default();
                let [right, up] = axes(&before, 0.0);
                let after = righting.turn(&before, turn);
                let [right_after, up_after] = axes(&after, righting.roll_rad());
                assert!((after.front() - turn * before.front()).length() < 1e-9);
                assert!((right_after - turn * right).length() < 1e-9);
                assert!((up_after - turn * up).length() < 1e-9);
                for _ in 0..24 {
                    righting.pass();
                }
                assert!(righting.roll_rad().abs() < 1e-9);
            }
        }
    }

    #[test]
    fn a_turn_about_the_upright_rolls_nothing() {
        let mut righting = Righting::default();
        righting.turn(&Look::default(), DQuat::from_rotation_y(1.0));
        assert!(righting.roll_rad().abs() < 1e-12);
    }
}
