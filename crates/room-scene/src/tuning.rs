//! Figures of play and of light in rooms, with their units. Who walks is as tall and as fast as in worlds.

use std::f64::consts::PI;

use antipode_deformation::WalkerShape;

/// Length of a step, seconds.
pub const STEP_S: f64 = 1.0 / 60.0;
/// In so many parts what is loose goes on in a step.
pub const PARTS: u32 = 2;
/// Mass of who walks, kilograms of their own size.
pub const WALKER_MASS_KG: f64 = 80.0;
/// With how much force they push what is loose, newtons of their own size.
pub const PUSH_N: f64 = 500.0;
/// From how near, felt metres beyond their radius.
pub const PUSH_REACH_M: f64 = 0.12;
/// The heaviest that they lift, kilograms of their own size.
pub const LIFT_KG: f64 = 60.0;
/// From how far off, felt metres from the eye.
pub const GRASP_REACH_M: f64 = 3.0;
/// How far before the eye what is held is, felt metres before its nearest side.
pub const HOLD_M: f64 = 0.75;
/// How much of its way to there it goes in a second, and how fast at most, felt metres per second.
pub const HOLD_RATE: (f64, f64) = (12.0, 8.0);
/// What is farther than this from where it is to be held, felt metres, for longer than [`SLIPS_AFTER_S`], is let go.
pub const SLIPS_M: f64 = 1.6;
/// See [`SLIPS_M`]; seconds.
pub const SLIPS_AFTER_S: f64 = 0.6;
/// By how much what is held is drawn round who turns about, seen from the eye, radians.
pub const SWINGS_RAD: f64 = 1.0;
/// Speed at which what is held is thrown, felt metres per second; what is heavier than [`LIGHT_KG`] is thrown slower.
pub const HURL_SPEED_M_S: f64 = 8.0;
/// See [`HURL_SPEED_M_S`].
pub const LIGHT_KG: f64 = 15.0;
/// What a bullet gives to what it hits, N s of the size of who shot.
pub const BULLET_PUSH_N_S: f64 = 8.0;
/// Felt speed of who walks, metres per second.
pub const WALK_SPEED_M_S: f64 = 4.5;
/// How many times as fast a sprint is.
pub const SPRINT_FACTOR: f64 = 1.7;
/// How soon who walks is as fast as wished: on the ground, in the air, and in the air without a wish; m/s^2.
pub const ACCELERATIONS_M_S2: (f64, f64, f64) = (50.0, 12.0, 4.0);
/// Felt speed with which a jump begins, metres per second: v^2 = 2 g h for 1.2 m under 9.81 m/s^2.
pub const JUMP_SPEED_M_S: f64 = 4.852_215;
/// Nobody falls faster, metres per second.
pub const TERMINAL_SPEED_M_S: f64 = 60.0;
/// Time in which a view that a portal has rolled is level again, seconds.
pub const RIGHTING_S: f64 = 0.4;
/// Felt height of the eye above the feet, metres.
pub const EYE_M: f64 = 1.62;
/// Felt radius of who walks, metres.
pub const RADIUS_M: f64 = 0.35;
/// How far behind the eye and above it the camera of the third person feels, metres; as in worlds.
pub const THIRD_PERSON_BACK_M: f64 = 5.2;
/// See [`THIRD_PERSON_BACK_M`].
pub const THIRD_PERSON_UP_M: f64 = 0.45;
/// Most that it rises besides, so that ground does not hide the legs, felt metres; as in worlds.
pub const THIRD_PERSON_RISES_M: f64 = 1.5;
/// What of the legs it is to see, felt metres above the feet.
pub const SHINS_M: f64 = 0.3;
/// Felt metres by which a camera stays off what it cannot go through.
pub const CAMERA_RADIUS_M: f64 = 0.25;
/// From this many felt metres behind the head on the camera shows who walks.
pub const FIGURE_SEEN_FROM_M: f64 = 2.2;
/// The greatest pitch of the view, radians.
pub const PITCH_LIMIT_RAD: f64 = 89.0 * PI / 180.0;
/// Angle between the top and the bottom of a picture, radians.
pub const FOV_Y_RAD: f64 = 75.0 * PI / 180.0;
/// Who is farther from the origin than this, along an axis, has fallen out of the room and begins anew; metres.
pub const LOST_M: f64 = 1100.0;
/// So is who is farther below all that stands in it, along gravity; metres.
pub const LOST_BELOW_M: f64 = 40.0;
/// Signs that are nearer are read, felt metres: the gun is put out of their way.
pub const READS_M: f64 = 5.0;
/// How far the crosshair picks, felt metres.
pub const PICK_M: f64 = 100_000.0;

/// What light of brightness 1 is to the tone map: the noon sun.
pub const DAYLIGHT: f32 = 1.3;
/// The share of a lamp's power that its light has at no distance. Lamps are soft near by: c / (1 + 0.24 d^2), which is
/// power / d^2 from a few metres on for c = 0.24 power.
pub const LAMP_SHARE: f32 = 0.24;
/// The share of noon light at which a lamp has faded away.
pub const LAMP_FAINT: f32 = 0.003;
/// How large a lamp is, metres: what is nearer throws no shadow.
pub const LAMP_RADIUS_M: f32 = 0.15;
/// Felt metres at which fog is complete in rooms without: beyond anything that stands in them.
pub const NO_FOG_M: f32 = 200_000.0;
/// How much more light the writing on signs throws back than paper would, so that it can be read in the shade.
pub const SIGN_BRIGHTNESS: f32 = 1.7;
/// Index of refraction of glass.
pub const GLASS: f32 = 1.5;
/// Share of light that a mirror throws back.
pub const MIRROR: f32 = 0.92;

/// What who walks is like to solids: as tall as in worlds, with the same steps and slopes.
pub const SHAPE: WalkerShape = WalkerShape {
    radius_m: RADIUS_M,
    height_m: 1.8,
    eye_m: EYE_M - RADIUS_M,
    step_m: 0.4,
    steepest_rad: 50.0 * PI / 180.0,
};
/// For how long after walking off an edge a jump is still granted, seconds.
pub const COYOTE_S: f64 = 0.1;
/// For how long before landing a press of jump is remembered, seconds.
pub const JUMP_BUFFER_S: f64 = 0.1;

/// Felt speed of a bullet at the muzzle, metres per second.
pub const BULLET_SPEED_M_S: f64 = 40.0;
/// Felt radius of a bullet, metres.
pub const BULLET_RADIUS_M: f64 = 0.06;
/// A bullet is gone after so many felt metres.
pub const BULLET_REACH_M: f64 = 200.0;
/// Bullets in flight at once; the oldest goes.
pub const MOST_BULLETS: usize = 100;
/// A shot goes through what the crosshair covers within so many felt metres.
pub const AIM_REACH_M: f64 = 30.0;
/// The muzzle as felt from the eye, metres: to the right, up and ahead.
pub const MUZZLE_M: (f64, f64, f64) = (0.22, -0.16, 0.7);
/// Least time between two shots, seconds.
pub const SHOT_EVERY_S: f64 = 0.12;
/// Felt radius of what a bullet leaves, metres.
pub const MARK_RADIUS_M: f64 = 0.03;
/// Marks at once; the oldest goes.
pub const MOST_MARKS: usize = 64;
/// What is thrown.
pub struct ThrownBall {
    /// Felt radius, metres.
    pub radius_m: f64,
    /// Kilograms.
    pub mass_kg: f64,
    /// The share of speed that comes back from a blow, 0 to 1.
    pub bounce: f64,
    /// What it loses of its spin, a second: rolling it loses two sevenths of that of its speed.
    pub spin_damping_per_s: f64,
}

/// See [`ThrownBall`].
pub const THROWN: ThrownBall = ThrownBall {
    radius_m: 0.12,
    mass_kg: 1.5,
    bounce: 0.6,
    spin_damping_per_s: 3.0,
};
/// Felt speed at which it is thrown, metres per second.
pub const THROW_SPEED_M_S: f64 = 9.0;
/// How far above the crosshair it is thrown, as a share of that speed.
pub const THROW_RISE: f64 = 0.15;
/// Balls at once; the oldest goes.
pub const MOST_BALLS: usize = 32;
/// How far from the eye lamps can be put down and taken up, felt metres.
pub const REACH_M: f64 = 8.0;
/// Felt radius of a lamp that is put down, metres.
pub const LAMP_BODY_M: f64 = 0.1;
/// A lamp is taken up where the crosshair passes it within so many felt metres.
pub const LAMP_GRIP_M: f64 = 0.25;
