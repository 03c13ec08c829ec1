//! The tuning of a vehicle: every figure that a player feels, with its units.

use glam::DVec3;

use super::VehicleMotion;

/// Sizes, forces and speeds of a vehicle with four wheels. [`Default`] gives the game's car.
///
/// Places are metres in the vehicle's own axes: x ahead, y up, z to the right, from the ground below its middle when it
/// stands on level ground. Every value is expected to be finite and positive.
#[derive(Clone, Debug, PartialEq)]
pub struct VehicleTuning {
    /// Mass in kilograms.
    pub mass_kg: f64,
    /// Where the mass is.
    pub mass_centre: DVec3,
    /// Size of the box whose inertia the vehicle has.
    pub inertia_box_m: DVec3,
    /// Hubs of the wheels at rest: front left, front right, rear left, rear right.
    pub hubs: [DVec3; 4],
    /// Radius of the wheels.
    pub wheel_radius_m: f64,
    /// How far a wheel can hang below its place at rest, under no load.
    pub droop_m: f64,
    /// How far a wheel can be pushed in from its place at rest.
    pub bump_m: f64,
    /// Damping of the suspension, as a share of the critical one: pushed in and let out.
    pub damping: (f64, f64),
    /// Greatest force of one spring, in newtons.
    pub spring_most_n: f64,
    /// Grip of the tyres: greatest sideways force as a share of the load.
    pub grip: f64,
    /// Friction of the body against the ground.
    pub body_friction: f64,
    /// Acceleration ahead and backwards.
    pub acceleration_m_s2: (f64, f64),
    /// Speed ahead and backwards that the engine reaches on level ground.
    pub top_speed_m_s: (f64, f64),
    /// What sprinting multiplies force and speed ahead by.
    pub boost_factor: f64,
    /// Share of the top speed from which the force falls to nothing at the top speed.
    pub full_force_to: f64,
    /// How fast the brake slows it.
    pub brake_m_s2: f64,
    /// How fast the engine slows it when nothing is asked of it.
    pub engine_brake_m_s2: f64,
    /// Slower than this the brake holds it when nothing is asked of it.
    pub holds_below_m_s: f64,
    /// Farthest that the front wheels turn.
    pub steer_most_rad: f64,
    /// How fast they turn.
    pub steer_rate_rad_s: f64,
    /// Steering is eased so that a turn takes no more sideways acceleration than this.
    pub turn_most_m_s2: f64,
    /// Downward acceleration.
    pub gravity_m_s2: f64,
    /// Fastest fall.
    pub terminal_speed_m_s: f64,
    /// Share of its spin that it loses per second.
    pub spin_damping_per_s: f64,
    /// What turns it back upright: angular acceleration about its length for the sine of its lean, 1/s^2.
    pub righting_per_s2: f64,
    /// Share of its roll that this takes away per second.
    pub righting_damping_per_s: f64,
    /// Greatest angular acceleration of both together about its length.
    pub righting_most_rad_s2: f64,
    /// Leaning as far as the first of these it has all of that, at the second nothing: it goes over and lies.
    pub righting_lean_rad: (f64, f64),
}

impl Default for VehicleTuning {
    fn default() -> Self {
        Self {
            mass_kg: 900.0,
            // Lower than in a real car and spread wider: on land as rough as this it would lie on its side every minute.
            mass_centre: DVec3::new(0.0, 0.30, 0.0),
            inertia_box_m: DVec3::new(3.2, 1.6, 2.0),
            hubs: [
                DVec3::new(1.0, 0.36, -0.61),
                DVec3::new(1.0, 0.36, 0.61),
                DVec3::new(-0.98, 0.36, -0.61),
                DVec3::new(-0.98, 0.36, 0.61),
            ],
            wheel_radius_m: 0.36,
            droop_m: 0.12,
            bump_m: 0.16,
            damping: (0.35, 0.5),
            spring_most_n: 40_000.0,
            grip: 1.3,
            body_friction: 0.35,
            acceleration_m_s2: (8.0, 6.0),
            top_speed_m_s: (15.0, 7.0),
            boost_factor: 2.0,
            full_force_to: 0.75,
            brake_m_s2: 10.0,
            engine_brake_m_s2: 2.6,
            holds_below_m_s: 0.8,
            steer_most_rad: 41f64.to_radians(),
            steer_rate_rad_s: 2.0,
            turn_most_m_s2: 7.0,
            gravity_m_s2: 9.81,
            terminal_speed_m_s: 60.0,
            spin_damping_per_s: 0.6,
            righting_per_s2: 20.0,
            righting_damping_per_s: 4.0,
            // Its own weight turns it about the wheels of one side by 11 rad/s^2; a hard enough knock beats this.
            righting_most_rad_s2: 10.0,
            // Its weight alone brings it back from 64 degrees. On its side it lies at 82: nothing unseen lifts it there.
            righting_lean_rad: (40f64.to_radians(), 70f64.to_radians()),
        }
    }
}

impl VehicleTuning {
    /// Distance between the axles, metres.
    pub fn wheelbase_m(&self) -> f64 {
        self.hubs[0].x - self.hubs[2].x
    }

    /// How far the front wheels turn at most at a speed, radians: on a circle of radius `L / tan(angle)` the sideways
    /// acceleration is `v^2 tan(angle) / L`.
    pub fn steer_limit_rad(&self, speed_m_s: f64) -> f64 {
        let most = self.turn_most_m_s2 * self.wheelbase_m() / (speed_m_s * speed_m_s).max(1e-9);
        most.atan().min(self.steer_most_rad)
    }

    /// Where the centre of mass is, in metres of the chart.
    pub(super) fn mass_place(&self, motion: &VehicleMotion) -> DVec3 {
        motion.place + motion.turn * self.mass_centre
    }

    /// Stiffness of one spring for each kilogram, 1/s^2: four of them carry the vehicle when pushed in by the droop.
    pub(super) fn stiffness(&self) -> f64 {
        self.gravity_m_s2 / (4.0 * self.droop_m)
    }

    /// Damping of one spring for each kilogram, 1/s, at a share of the critical one. Four springs of stiffness k swing
    /// at `w = sqrt(4 k)`; four dampers c are critical at `4 c = 2 w`.
    pub(super) fn damping_per_s(&self, share: f64) -> f64 {
        share * 0.5 * (4.0 * self.stiffness()).sqrt()
    }

    /// Length of a spring under no load, from where its ray begins, metres: above its wheel at full bump.
    pub(super) fn spring_m(&self) -> f64 {
        self.droop_m + self.bump_m + SPRING_ROOM_M
    }

    /// Where a wheel's spring begins, in the vehicle's axes.
    pub(super) fn mount(&self, wheel: usize) -> DVec3 {
        self.hubs[wheel] + DVec3::Y * (self.bump_m + SPRING_ROOM_M)
    }
}

/// A spring begins so far above the wheel at full bump, in metres, so that a ray begins in the air however deep the
/// wheel is pushed.
const SPRING_ROOM_M: f64 = 0.12;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steering_is_eased_down_with_speed() {
        let tuning = VehicleTuning::default();
        assert_eq!(tuning.steer_limit_rad(0.0), tuning.steer_most_rad);
        assert_eq!(tuning.steer_limit_rad(2.0), tuning.steer_most_rad);
        let (slow, fast) = (tuning.steer_limit_rad(8.0), tuning.steer_limit_rad(15.0));
        assert!(fast < slow && slow < tuning.steer_most_rad);
        let sideways = 15.0 * 15.0 * fast.tan() / tuning.wheelbase_m();
        assert!((sideways - tuning.turn_most_m_s2).abs() < 1e-9);
    }
}
