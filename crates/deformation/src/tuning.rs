//! Figures that a walker feels.

/// Time in which a walker's eye glides to its felt height, seconds.
pub const EYE_GLIDE_S: f64 = 0.5;
/// An eye stays so far, felt metres, below what it would come up against.
pub const EYE_CLEAR_M: f64 = 0.12;
/// Longest part of a step that is moved as a whole, seconds.
pub const LONGEST_PART_S: f64 = 1.0 / 240.0;
/// Of its radius, the most that a body goes before it looks about for solids.
pub const STRIDE: f64 = 0.5;
/// Balls of a body lie at most so many radii above each other.
pub const BALLS_APART: f64 = 0.8;
/// Overlaps shallower than this, felt metres, are touches and are left alone.
pub const TOUCH_M: f64 = 1e-4;
/// A ball must be at least this much of its radius above the edge of a gentle face to be carried by it.
pub const LEAST_LIP_UP: f64 = 0.02;
/// The same where it lands on one.
pub const LEAST_LANDING_LIP_UP: f64 = 0.3;
/// How often one part of a way is pushed out of what it meets before it is given up.
pub const PUSHES: usize = 12;
/// The longest push out of one wall, felt metres.
pub const LONGEST_PUSH_M: f64 = 0.25;
/// Contacts whose level part is less than this are ceilings: no way out sideways.
pub const LEAST_SIDEWAYS: f64 = 0.1;
/// A part of a walk that is too low for a step tries once more with this rise only, felt metres.
pub const SLOPE_RISE_M: f64 = 0.15;
/// Overlaps deeper than this, felt metres, that remain after all pushes of a flight take its part back.
pub const LEFT_OVER_M: f64 = 0.05;
/// A contact that points down at least this much stops a rise.
pub const CEILING_UP: f64 = -0.5;
/// Between slopes that face each other, a fall that makes less of its way than this has ended.
pub const WEDGED_SHARE: f64 = 0.3;
/// Who goes up faster than this, felt metres per second, has left the ground.
pub const LEAVES_M_S: f64 = 0.1;
/// Time in which an eye that a portal has turned is upright again, seconds.
pub const RIGHTING_S: f64 = 0.4;
