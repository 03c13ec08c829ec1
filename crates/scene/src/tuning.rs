//! Figures of play that belong to no other crate, in one place, with their units.

/// Length of one simulation step in seconds.
pub const STEP_S: f64 = 1.0 / 60.0;
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
pub const THIRD_PERSON_BACK_M: f64 = 4.5;
/// Rise of the third-person camera above the eye, in metres.
pub const THIRD_PERSON_UP_M: f64 = 0.6;
/// Radius of the sphere that keeps the third-person camera out of the ground, in metres.
pub const CAMERA_RADIUS_M: f64 = 0.25;
/// Nearest distance drawn, in metres.
pub const NEAR_M: f64 = 0.02;
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
/// What changed is committed at least this often, in simulated seconds.
pub const AUTOSAVE_S: f64 = 3.0;
/// Metres walked per radian of the walking figure's stride.
pub const STRIDE_M_PER_RAD: f64 = 0.28;
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
