//! Turns the positions of the sticks into walking and looking: dead zones and the response curve.

use antipode_scene::{Actions, LookTurn};
use antipode_settings::Settings;
use glam::DVec2;

use super::Axis;

/// The turn of the view grows with this power of the way of the stick: fine aim near the middle, quick turns at
/// the end.
const LOOK_POWER: i32 = 2;
/// How far a stick has to be over to count as a direction in a menu.
const DIRECTION_FROM: f64 = 0.6;

/// A direction in a menu.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// To the line above.
    Up,
    /// To the line below.
    Down,
    /// To the left.
    Left,
    /// To the right.
    Right,
}

/// How the sticks answer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Feel {
    /// Turn of the view with the stick all the way over, radians a second.
    pub look_rad_per_s: f64,
    /// Whether moving the stick away looks down.
    pub inverted: bool,
    /// Share of the way around the middle that counts as rest, 0 to under 1.
    pub dead_zone: f64,
}

impl From<&Settings> for Feel {
    fn from(settings: &Settings) -> Self {
        Self {
            look_rad_per_s: settings.pad_look_speed_deg_per_s.to_radians(),
            inverted: settings.pad_invert_look,
            dead_zone: settings.pad_dead_zone_pc / 100.0,
        }
    }
}

/// Where the sticks stand.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sticks {
    left: DVec2,
    right: DVec2,
}

impl Sticks {
    /// A stick has moved along an axis; what is no number is its middle.
    pub fn set(&mut self, axis: Axis, value: f32) {
        let value = if value.is_finite() {
            f64::from(value.clamp(-1.0, 1.0))
        } else {
            0.0
        };
        match axis {
            Axis::LeftX => self.left.x = value,
            Axis::LeftY => self.left.y = value,
            Axis::RightX => self.right.x = value,
            Axis::RightY => self.right.y = value,
        }
    }

    /// Adds what the left stick asks for in a step: it walks.
    pub fn add_to(&self, actions: &mut Actions, feel: Feel) {
        let walk = rest_taken_out(self.left, feel.dead_zone);
        actions.forward = (actions.forward + walk.y).clamp(-1.0, 1.0);
        actions.strafe = (actions.strafe + walk.x).clamp(-1.0, 1.0);
    }

    /// How far the right stick turns the view in `passed_s` seconds.
    pub fn turn(&self, feel: Feel, passed_s: f64) -> LookTurn {
        let look = rest_taken_out(self.right, feel.dead_zone);
        let turn = look * look.length().powi(LOOK_POWER - 1) * (feel.look_rad_per_s * passed_s);
        LookTurn {
            right_rad: turn.x,
            up_rad: if feel.inverted { -turn.y } else { turn.y },
        }
    }

    /// The way the left stick points in a menu, if it is far enough over.
    pub fn direction(&self) -> Option<Direction> {
        let DVec2 { x, y } = self.left;
        if x.abs().max(y.abs()) < DIRECTION_FROM {
            return None;
        }
        Some(match (x.abs() > y.abs(), x > 0.0, y > 0.0) {
            (true, true, _) => Direction::Right,
            (true, false, _) => Direction::Left,
            (false, _, true) => Direction::Up,
            (false, _, false) => Direction::Down,
        })
    }
}

/// A stick without its dead zone: from nothing at its edge to 1 all the way over, in the same direction. Around the
/// middle and not along each axis, so that slow turns do not snap to the axes.
fn rest_taken_out(stick: DVec2, dead_zone: f64) -> DVec2 {
    let dead_zone = dead_zone.clamp(0.0, 0.95);
    let over = stick.length();
    if over <= dead_zone {
        return DVec2::ZERO;
    }
    // Many sticks reach past 1 in the corners and not quite to it along the axes.
    stick / over * ((over - dead_zone) / (1.0 - dead_zone)).min(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    const FEEL: Feel = Feel {
        look_rad_per_s: 3.0,
        inverted: false,
        dead_zone: 0.2,
    };

    fn asked(axes: &[(Axis, f32)], feel: Feel) -> Actions {
        let (mut sticks, mut actions) = (Sticks::default(), Actions::default());
        for (axis, value) in axes {
            sticks.set(*axis, *value);
        }
        sticks.add_to(&mut actions, feel);
        let turn = sticks.turn(feel, 0.5);
        (actions.look_yaw, actions.look_pitch) = (turn.right_rad, turn.up_rad);
        actions
    }

    #[test]
    fn a_stick_that_does_not_quite_come_back_moves_nothing() {
        let drift = [
            (Axis::LeftX, 0.13),
            (Axis::LeftY, -0.14),
            (Axis::RightX, 0.19),
        ];
        assert_eq!(asked(&drift, FEEL), Actions::default());
    }

    #[test]
    fn from_the_edge_of_the_dead_zone_on_it_goes_without_a_jump_up_to_all_there_is() {
        assert!(asked(&[(Axis::LeftY, 0.21)], FEEL).forward < 0.02);
        assert!((asked(&[(Axis::LeftY, 0.6)], FEEL).forward - 0.5).abs() < 1e-6);
        assert_eq!(asked(&[(Axis::LeftY, 1.0)], FEEL).forward, 1.0);
        assert_eq!(asked(&[(Axis::LeftX, -1.0)], FEEL).strafe, -1.0);
        let corner = asked(&[(Axis::LeftX, 1.0), (Axis::LeftY, 1.0)], FEEL);
        assert!((corner.forward.hypot(corner.strafe) - 1.0).abs() < 1e-9);
    }

    #[test]
    fn half_a_stick_turns_far_less_than_half_as_fast() {
        let all = asked(&[(Axis::RightX, 1.0)], FEEL).look_yaw;
        assert!((all - 1.5).abs() < 1e-9, "3 rad/s for half a second");
        let half = asked(&[(Axis::RightX, 0.6)], FEEL).look_yaw;
        assert!((half - all / 4.0).abs() < 1e-6);
    }

    #[test]
    fn away_looks_up_and_inverted_down() {
        let away = [(Axis::RightY, 1.0)];
        assert!(asked(&away, FEEL).look_pitch > 1.0);
        let inverted = Feel {
            inverted: true,
            ..FEEL
        };
        assert!(asked(&away, inverted).look_pitch < -1.0);
    }

    #[test]
    fn keys_and_sticks_together_walk_no_faster() {
        let mut sticks = Sticks::default();
        sticks.set(Axis::LeftY, 1.0);
        let mut actions = Actions {
            forward: 1.0,
            ..Actions::default()
        };
        sticks.add_to(&mut actions, FEEL);
        assert_eq!(actions.forward, 1.0);
    }

    #[test]
    fn nonsense_from_a_driver_is_the_middle() {
        let odd = [(Axis::LeftX, f32::NAN), (Axis::RightX, f32::INFINITY)];
        assert_eq!(asked(&odd, FEEL), Actions::default());
    }

    #[test]
    fn in_menus_a_stick_points_one_way_or_none() {
        let points = |x: f32, y: f32| {
            let mut sticks = Sticks::default();
            sticks.set(Axis::LeftX, x);
            sticks.set(Axis::LeftY, y);
            sticks.direction()
        };
        assert_eq!(points(0.0, 0.9), Some(Direction::Up));
        assert_eq!(points(0.3, -0.9), Some(Direction::Down));
        assert_eq!(points(0.8, 0.7), Some(Direction::Right));
        assert_eq!(points(-0.8, 0.0), Some(Direction::Left));
        assert_eq!(points(0.3, 0.4), None);
    }
}
