//! Rapier's wheels and springs of a vehicle.

use rapier3d::control::{DynamicRayCastVehicleController, WheelTuning};
use rapier3d::dynamics::RigidBodyHandle;
use rapier3d::math::Vector;

use super::VehicleTuning;

/// A wheel's ray leans by this share: the tree of boxes misses what a ray that is square to an axis meets.
const RAY_LEANS: f32 = 1e-4;

/// A controller with four wheels.
pub(super) fn controller(
    body: RigidBodyHandle,
    tuning: &VehicleTuning,
) -> DynamicRayCastVehicleController {
    let mut controller = DynamicRayCastVehicleController::new(body);
    let spring = WheelTuning {
        suspension_stiffness: tuning.stiffness() as f32,
        suspension_compression: tuning.damping_per_s(tuning.damping.0) as f32,
        suspension_damping: tuning.damping_per_s(tuning.damping.1) as f32,
        max_suspension_travel: (tuning.droop_m + tuning.bump_m) as f32,
        side_friction_stiffness: 1.0,
        friction_slip: tuning.grip as f32,
        max_suspension_force: tuning.spring_most_n as f32,
    };
    let down = Vector::new(RAY_LEANS, -1.0, RAY_LEANS);
    for wheel in 0..tuning.hubs.len() {
        controller.add_wheel(
            tuning.mount(wheel).as_vec3(),
            down,
            Vector::Z,
            tuning.spring_m() as f32,
            tuning.wheel_radius_m as f32,
            &spring,
        );
    }
    controller
}
