//! Turns a driver's input into forces of the wheels.

use rapier3d::control::DynamicRayCastVehicleController;

use super::{VehicleInput, VehicleTuning};

/// Faster than this the wrong way, in metres per second, the pedals brake before they drive.
const TURNS_ROUND_BELOW_M_S: f64 = 1.0;
/// Faster than the engine drives, it holds back by this, in metres per second squared: less than of a car that is let
/// go, so that a slope may carry it on.
const HOLDS_BACK_M_S2: f64 = 2.0;

/// What the wheels do for one step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Effort {
    /// Acceleration ahead, of the engine, m/s^2.
    pub drive_m_s2: f64,
    /// Greatest deceleration by the brakes, m/s^2.
    pub brake_m_s2: f64,
    /// Whether the driver brakes, as the lights behind show.
    pub brakes: bool,
    /// Whether the brakes keep it where it is.
    pub holds: bool,
}

/// What to do at a speed ahead, in m/s.
pub(super) fn effort(tuning: &VehicleTuning, input: &VehicleInput, speed_m_s: f64) -> Effort {
    let held = |brakes| Effort {
        drive_m_s2: 0.0,
        brake_m_s2: tuning.brake_m_s2,
        brakes,
        holds: speed_m_s.abs() < tuning.holds_below_m_s,
    };
    let throttle = input.throttle.clamp(-1.0, 1.0);
    if input.brake {
        return held(true);
    }
    if throttle == 0.0 {
        let rests = input.parked || speed_m_s.abs() < tuning.holds_below_m_s;
        return if rests {
            held(false)
        } else {
            Effort {
                drive_m_s2: 0.0,
                brake_m_s2: tuning.engine_brake_m_s2,
                brakes: false,
                holds: false,
            }
        };
    }
    let ahead_m_s = speed_m_s * throttle.signum();
    if ahead_m_s < -TURNS_ROUND_BELOW_M_S {
        return held(true);
    }
    let (force, top_m_s) = if throttle > 0.0 {
        let boost = if input.boost {
            tuning.boost_factor
        } else {
            1.0
        };
        (
            tuning.acceleration_m_s2.0 * boost,
            tuning.top_speed_m_s.0 * boost,
        )
    } else {
        (tuning.acceleration_m_s2.1, tuning.top_speed_m_s.1)
    };
    let left = (top_m_s - ahead_m_s) / (top_m_s * (1.0 - tuning.full_force_to));
    if left <= 0.0 {
        return Effort {
            drive_m_s2: 0.0,
            brake_m_s2: HOLDS_BACK_M_S2,
            brakes: false,
            holds: false,
        };
    }
    Effort {
        drive_m_s2: throttle * force * left.min(1.0),
        brake_m_s2: 0.0,
        brakes: false,
        holds: false,
    }
}

/// Turns the front wheels towards what is asked for; radians, to the right positive.
pub(super) fn steer(
    tuning: &VehicleTuning,
    now_rad: f64,
    input: &VehicleInput,
    speed_m_s: f64,
    dt_s: f64,
) -> f64 {
    let goal = input.steer.clamp(-1.0, 1.0) * tuning.steer_limit_rad(speed_m_s);
    let most = tuning.steer_rate_rad_s * dt_s;
    now_rad + (goal - now_rad).clamp(-most, most)
}

/// Hands a step's effort to the wheels.
pub(super) fn apply(
    controller: &mut DynamicRayCastVehicleController,
    tuning: &VehicleTuning,
    effort: &Effort,
    steer_rad: f64,
    dt_s: f64,
) {
    let wheels = controller.wheels_mut();
    let share_kg = tuning.mass_kg / wheels.len().max(1) as f64;
    for (number, wheel) in wheels.iter_mut().enumerate() {
        wheel.engine_force = (share_kg * effort.drive_m_s2) as f32;
        // The controller takes it as the greatest impulse of a step.
        wheel.brake = (share_kg * effort.brake_m_s2 * dt_s) as f32;
        // About the upward axis of a right-handed frame, so to the left positive.
        wheel.steering = if number < 2 { -steer_rad as f32 } else { 0.0 };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(throttle: f64, speed_m_s: f64, boost: bool) -> Effort {
        let input = VehicleInput {
            throttle,
            boost,
            ..VehicleInput::default()
        };
        effort(&VehicleTuning::default(), &input, speed_m_s)
    }

    #[test]
    fn pedals_drive_ahead_and_back_and_brake_against_the_way_it_rolls() {
        assert_eq!(at(1.0, 0.0, false).drive_m_s2, 8.0);
        assert_eq!(at(1.0, 0.0, true).drive_m_s2, 16.0);
        assert!(at(1.0, 14.0, false).drive_m_s2 < 4.0);
        assert!(at(1.0, 16.0, false).drive_m_s2 == 0.0);
        assert!(at(1.0, 16.0, true).drive_m_s2 > 8.0);
        assert!(at(-1.0, 0.0, false).drive_m_s2 < -5.0);
        assert!(at(-1.0, 9.0, false).brakes && at(1.0, -5.0, false).brakes);
        assert!(!at(0.0, 9.0, false).brakes);
    }

    #[test]
    fn the_wheels_turn_no_faster_than_they_can() {
        let tuning = VehicleTuning::default();
        let input = VehicleInput {
            steer: 1.0,
            ..VehicleInput::default()
        };
        let mut angle = 0.0;
        for _ in 0..6 {
            angle = steer(&tuning, angle, &input, 0.0, 1.0 / 60.0);
        }
        assert!((angle - 0.2).abs() < 1e-9, "{angle}");
    }
}
