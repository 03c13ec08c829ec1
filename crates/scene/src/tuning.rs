//! Figures of play that belong to no other crate, in one place, with their units.

pub use antipode_frame::hand::{FLASH_S, KICK_S};
pub use antipode_frame::motion::{LANDS_FROM_M_S, RUN_STRIDE_M, RUNS_FROM_M_S, WALK_STRIDE_M};
use antipode_physics::{BallTuning, CharacterTuning};

/// Length of one simulation step in seconds.
pub const STEP_S: f64 = 1.0 / 60.0;
/// How fast the player walks, in metres of the chart a second.
pub fn walk_speed_m_s() -> f64 {
    CharacterTuning::default().walk_speed_m_s
}
/// How far a tool reaches along the geodesic through the crosshair, in metres.
pub const REACH_M: f64 = 23.0;
/// Largest pitch of the view, in radians: one degree short of the vertical.
pub const PITCH_LIMIT_RAD: f64 = 89.0 * std::f64::consts::PI / 180.0;
/// Brush radius in metres: smallest, largest, and at the start.
pub const BRUSH_RADIUS_M: (f64, f64, f64) = (1.0, 10.0, 5.0);
/// Length of the whole day, in seconds.
pub const DAY_S: f64 = 600.0;
/// Time of day at which a new world begins, in seconds.
pub const DAY_START_S: f64 = 60.0;
/// Share of the distance to its goal that the curvature dial keeps after one second: the glide of the scroll.
pub const DIAL_REMAINDER_PER_S: f64 = 1e-4;
/// Dial below which one map gives way to another: the tail of the glide is not waited for. At a radius of 20 m it
/// turns sight lines by at most 0.01 / 20 rad, a quarter of a pixel in a picture 720 pixels high.
pub const DIAL_SWAP_AT: f64 = 0.01;
/// Distance of the third-person camera behind the eye, in metres.
pub const THIRD_PERSON_BACK_M: f64 = 5.2;
/// Rise of the third-person camera above the eye, in metres.
pub const THIRD_PERSON_UP_M: f64 = 0.45;
/// Most that it rises besides, so that ground does not hide the legs, in metres.
pub const THIRD_PERSON_RISES_M: f64 = 1.5;
/// Radius of the sphere that keeps the third-person camera out of the ground, in metres.
pub const CAMERA_RADIUS_M: f64 = 0.25;
/// Nearest distance drawn, in metres.
pub const NEAR_M: f64 = 0.02;
/// The fog behind a door is complete at this distance from an eye close to it, metres, where no more land is loaded there than
/// [`antipode_streaming::Wish::APART_CHUNKS`].
pub const DOOR_FOG_M: f32 = 60.0;
/// Vertical field of view, in radians.
pub const FOV_Y_RAD: f64 = 75.0 * std::f64::consts::PI / 180.0;
/// Open worlds hold a player within this of their middle, in metres: far beyond it positions in `f64` would
/// lose the millimetres that walking needs.
pub const FARTHEST_M: f64 = 1e9;
/// Lines of a picture, until it is known how many they are.
pub const PICTURE_HEIGHT_PX: u32 = 720;
/// Full health.
pub const FULL_HEALTH: f64 = 20.0;
/// Default view distance in chunks, and its allowed range.
pub const VIEW_DISTANCE_CHUNKS: (u32, u32, u32) = (1, 16, 4);
/// Bodies in open worlds move within so many chunks of the player's: those farther off rest where they are.
pub const BODIES_WITHIN_CHUNKS: u16 = 4;
/// What changed is committed at least this often, in simulated seconds.
pub const AUTOSAVE_S: f64 = 3.0;
/// Nearest to the head, in metres, from which the camera behind a figure still shows it.
pub const FIGURE_SEEN_FROM_M: f64 = 2.2;
/// Slowest fall whose end dips the head, in metres per second: a step down a stair does not.
pub const DIP_FROM_M_S: f64 = 2.0;
/// Share of the fall's speed with which the head goes on down.
pub const DIP_PUSH: f64 = 0.5;
/// Fastest that the head goes down after the hardest fall, in metres per second.
pub const DIP_PUSH_MOST_M_S: f64 = 6.0;
/// Rate of the spring that brings the head back, per second.
pub const DIP_RATE_PER_S: f64 = 12.0;
/// Speed of a bullet at the muzzle, in metres per second.
pub const BULLET_SPEED_M_S: f64 = 40.0;
/// How a bullet flies.
pub const BULLET: BallTuning = BallTuning {
    radius_m: 0.06,
    gravity_m_s2: 9.81,
    bounce: 0.25,
    slide: 0.8,
};
/// A bullet is gone when it has lain on the ground for so many seconds.
pub const BULLET_LIES_S: f64 = 5.0;
/// One that stays slower than this lies, in m/s.
pub const BULLET_LIES_BELOW_M_S: f64 = 0.5;
/// One that never falls is gone after so many metres.
pub const BULLET_STRAIGHT_M: f64 = 200.0;
/// Bullets in flight at once.
pub const MOST_BULLETS: usize = 500;
/// A bullet can damage the same body again only after so many seconds. It can damage its own shooter only after them, too.
pub const SAME_BODY_DAMAGED_AFTER_S: f64 = 0.5;
/// A bullet slower than this, in m/s, harms nobody: one that someone has stopped falls back at a tenth of its speed, and
/// others lie about.
pub const BULLET_DAMAGES_FROM_M_S: f64 = 8.0;
/// Health that a bullet takes.
pub const BULLET_DAMAGE: f64 = 1.0;
/// A shot goes through what the crosshair covers within this distance, in metres.
pub const AIM_REACH_M: f64 = 30.0;
/// The muzzle as seen from the eye, in metres: to the right, up and ahead.
pub const MUZZLE_M: (f64, f64, f64) = (0.22, -0.16, 0.7);
/// Least time between two shots, in seconds.
pub const SHOT_EVERY_S: f64 = 0.12;
/// A fall from this height or more hurts, in metres; one metre more, one health more.
pub const FALL_HURTS_FROM_M: f64 = 8.0;
/// Health comes back so long after the last damage, in seconds.
pub const HEALS_AFTER_S: f64 = 6.0;
/// Health that comes back, per second.
pub const HEALS_PER_S: f64 = 0.5;
/// The dead stand up again after so many seconds.
pub const DEAD_S: f64 = 3.0;
/// Health of others than the player.
pub const BOT_HEALTH: f64 = 3.0;
/// How long the dead lie before they are gone, in seconds.
pub const BOT_LIES_S: f64 = 2.0;
/// How far from the eye lamps and flags can be put down, in metres.
pub const FIXTURE_REACH_M: f64 = 8.0;
/// Most figures besides the player's in a world; each looks at every other.
pub const MOST_BOTS: usize = 512;
/// How a thing that was dropped flies.
pub const DROP: BallTuning = BallTuning {
    radius_m: 0.18,
    gravity_m_s2: 9.81,
    bounce: 0.3,
    slide: 0.6,
};
/// Speed at which things are thrown away, in metres per second.
pub const DROP_SPEED_M_S: f64 = 4.0;
/// Things that were dropped are picked up within this of the body's middle, in metres.
pub const PICK_UP_M: f64 = 1.4;
/// Things that were dropped can be picked up after so many seconds.
pub const PICK_UP_AFTER_S: f64 = 1.0;
/// Things lying about at once.
pub const MOST_DROPS: usize = 256;
/// The shape of a picture where none is known, width by height.
pub const ASPECT: f64 = 16.0 / 9.0;
