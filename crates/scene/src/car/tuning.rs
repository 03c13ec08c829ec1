//! Figures of the car that a player feels besides its driving, with units.

use glam::DVec3;

/// Cars in a world at once.
pub const MOST_CARS: usize = 16;
/// Ground within this of a car must be there before it moves, in metres; a moving one needs what it reaches in
/// [`NEEDED_AHEAD_S`] besides.
pub const NEEDED_AROUND_M: f64 = 4.0;
/// In seconds.
pub const NEEDED_AHEAD_S: f64 = 0.1;
/// A car can be entered, or set upright from outside, within this, in metres of the space.
pub const REACH_M: f64 = 4.0;
/// As far from the middle of the picture as a car is in view, as tangents of the angles to the side and up.
pub const IN_VIEW: (f64, f64) = (1.6, 1.2);
/// The driver's figure sits here, in the car's axes, in metres.
pub const SEAT_M: DVec3 = DVec3::new(-0.16, 0.40, -0.23);
/// The driver's eyes above the seat, in metres.
pub const EYES_UP_M: f64 = 0.85;
/// The camera on the bonnet, in the car's axes, in metres.
pub const BONNET_M: DVec3 = DVec3::new(0.70, 1.16, 0.0);
/// The eye of the rear mirror, over the tail, in the car's axes, in metres.
pub const MIRROR_M: DVec3 = DVec3::new(-1.80, 1.20, 0.0);
/// Vertical field of view of the mirror, in radians.
pub const MIRROR_FOV_Y_RAD: f64 = 0.36;
/// It looks so far up from straight back, in radians.
pub const MIRROR_UP_RAD: f64 = 0.04;
/// The camera behind the car: behind it and above the ground it stands on, in metres.
pub const CHASE_BACK_M: f64 = 5.4;
/// In metres.
pub const CHASE_UP_M: f64 = 2.3;
/// It looks at a point so far above the ground the car stands on, in metres.
pub const CHASE_LOOKS_UP_M: f64 = 1.3;
/// It rises with a slope behind the car so as to be so far over the ground, in metres.
pub const CHASE_OVER_GROUND_M: f64 = 0.9;
/// But no higher than this over where it would be, in metres.
pub const CHASE_RISES_M: f64 = 3.5;
/// Rate of the spring that it hangs on, per second.
pub const CHASE_RATE_PER_S: f64 = 7.0;
/// How fast it swings round behind the car, per second.
pub const CHASE_TURN_PER_S: f64 = 3.5;
/// A look aside stays for so long after the mouse, in seconds, and goes back at this rate, per second.
pub const LOOK_STAYS_S: f64 = 1.5;
/// Per second.
pub const LOOK_RETURNS_PER_S: f64 = 2.5;
/// Farthest look up and down from where the camera looks of itself, in radians.
pub const LOOK_MOST_RAD: (f64, f64) = (0.9, 0.7);
/// Slower than this, in m/s, a car is as good as standing: a look aside stays.
pub const STANDS_M_S: f64 = 1.0;
/// Places beside the car where one may get out, in the car's level axes, in metres: the driver's door first, the roof
/// last.
pub const DOORS_M: [DVec3; 7] = [
    DVec3::new(-0.2, 0.0, -1.35),
    DVec3::new(-0.2, 0.0, 1.35),
    DVec3::new(-2.2, 0.0, 0.0),
    DVec3::new(2.2, 0.0, 0.0),
    DVec3::new(-1.8, 0.0, -1.6),
    DVec3::new(-1.8, 0.0, 1.6),
    DVec3::new(-0.2, 1.6, 0.0),
];
/// How far below and above the car's own ground a place beside it may be, in metres.
pub const DOOR_DROP_M: f64 = 2.5;
/// In metres.
pub const DOOR_RISE_M: f64 = 1.4;
/// Slower than this, in m/s, a car that touches someone only shoves.
pub const SHOVES_BELOW_M_S: f64 = 3.0;
/// Health that being run over takes for each m/s above that.
pub const DAMAGE_PER_M_S: f64 = 0.5;
/// The same one is hurt by cars again only after so many seconds.
pub const HURTS_AGAIN_AFTER_S: f64 = 0.6;
/// A body that is run over flies ahead of the car, faster by this share of the car's speed, and up with this share.
pub const THROWN: (f64, f64) = (0.15, 0.25);
/// Mass of someone who is run over, in kilograms: what it costs the car.
pub const BODY_KG: f64 = 80.0;
/// A body this near a car's is touched, in metres.
pub const TOUCH_GAP_M: f64 = 0.06;
/// Impulse of a bullet for each m/s of its speed, in newton seconds: what it would weigh in kilograms. It is much, so
/// that a shot is seen to rock the car.
pub const BULLET_PUSH_KG: f64 = 8.0;
/// Share of a bullet's speed that is left when it has met a car.
pub const BULLET_BACK: f64 = 0.2;
/// A car's jolt of this much, in m/s, is a crash.
pub const CRASH_FROM_M_S: f64 = 3.0;
/// Share of a crash's speed that the driver feels: as much as the end of a fall that fast.
pub const CRASH_SHARE: f64 = 0.65;
/// Share of a car's speed that hits a driver who gets out, as the end of a fall at that speed would: without the double force no car
/// on level ground is fast enough to hurt.
pub const JUMPED_OFF_SHARE: f64 = 0.8;
/// Bushes halve a car's speed in so much of the way through them, in metres.
pub const BUSHES_HALVE_M: f64 = 12.0;
/// Slower than this, in m/s, a car goes through them unnoticed.
pub const RUSTLES_FROM_M_S: f64 = 1.0;
/// A bush that a car is in rustles and loses leaves again after so many seconds.
pub const RUSTLES_EVERY_S: f64 = 0.15;
/// The horn scatters who is within this, in metres of the space.
pub const HORN_REACH_M: f64 = 30.0;
/// Where the head lights and the tail lights are, in the car's axes, in metres; the others are their mirror images.
pub const HEAD_LIGHT_M: DVec3 = DVec3::new(1.58, 0.655, 0.335);
/// In metres.
pub const TAIL_LIGHT_M: DVec3 = DVec3::new(-1.85, 0.66, 0.345);
/// A new world's car stands as far from the start as one of these, in metres.
pub const FIRST_CAR_RINGS_M: [f64; 3] = [7.0, 9.5, 12.0];
