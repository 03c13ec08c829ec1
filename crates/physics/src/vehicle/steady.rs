//! Keeps a vehicle from turning over too easily. A hard enough throw still turns it over.

use glam::DVec3;
use rapier3d::dynamics::RigidBodyHandle;

use super::arena::Arena;
use super::{VehicleMotion, VehicleTuning};

/// Lets what keeps a vehicle upright act on its body for a step, its wheels on ground with these normals.
pub(super) fn steady(
    arena: &mut Arena,
    body: RigidBodyHandle,
    normals: &[DVec3],
    tuning: &VehicleTuning,
    dt_s: f64,
) {
    if let Some(motion) = arena.motion(body) {
        arena.spin_by(body, spin_change(tuning, &motion, normals, dt_s));
    }
}

/// By how much a vehicle's spin changes in a step, rad/s: about its length always, about its axles only in the air,
/// where no wheel holds its nose.
fn spin_change(
    tuning: &VehicleTuning,
    motion: &VehicleMotion,
    normals: &[DVec3],
    dt_s: f64,
) -> DVec3 {
    let (up, stands) = (motion.up(), upright(normals));
    let (all_at, none_at) = tuning.righting_lean_rad;
    let share = (none_at - up.angle_between(stands)) / (none_at - all_at);
    if share <= 0.0 {
        return DVec3::ZERO;
    }
    let about = |axis: DVec3| {
        tuning.righting_per_s2 * up.cross(stands).dot(axis)
            - tuning.righting_damping_per_s * motion.spin.dot(axis)
    };
    let (length, axle) = (motion.ahead(), motion.turn * DVec3::Z);
    let most = tuning.righting_most_rad_s2 * share.min(1.0);
    let roll = length * about(length).clamp(-most, most);
    let pitch = if normals.is_empty() {
        axle * about(axle)
    } else {
        DVec3::ZERO
    };
    (roll + pitch) * dt_s
}

/// Upright for a vehicle whose wheels touch ground with these normals: halfway between the ground's and the world's, so
/// that a hillside is driven along. One wheel alone may touch any bump.
fn upright(normals: &[DVec3]) -> DVec3 {
    if normals.len() < 2 {
        return DVec3::Y;
    }
    let ground = normals.iter().sum::<DVec3>().normalize_or(DVec3::Y);
    (ground + DVec3::Y).normalize_or(DVec3::Y)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DQuat;

    fn turned(turn: DQuat, spin: DVec3) -> DVec3 {
        let motion = VehicleMotion {
            turn,
            spin,
            ..VehicleMotion::default()
        };
        spin_change(&VehicleTuning::default(), &motion, &[], 1.0)
    }

    #[test]
    fn it_is_turned_back_from_a_lean_and_left_alone_on_its_side() {
        let most = VehicleTuning::default().righting_most_rad_s2;
        let leans = |rad: f64| turned(DQuat::from_rotation_x(rad), DVec3::ZERO).x;
        assert!(leans(0.2) < -1.0 && leans(-0.2) > 1.0);
        assert!((leans(0.6) + most).abs() < 1e-9, "{}", leans(0.6));
        let fading = -leans(55f64.to_radians()) / most;
        assert!((fading - 0.5).abs() < 1e-9, "{fading}");
        assert_eq!(leans(75f64.to_radians()), 0.0);
        assert!(turned(DQuat::IDENTITY, DVec3::Z).z < -1.0);
    }

    #[test]
    fn on_a_hillside_upright_is_between_the_hill_and_the_world() {
        let hill = DVec3::new(0.0, 1.0, 1.0).normalize();
        let half = upright(&[hill; 4]).y.acos();
        assert!((half - 22.5f64.to_radians()).abs() < 1e-9, "{half}");
        assert_eq!(upright(&[hill]), DVec3::Y);
    }
}
