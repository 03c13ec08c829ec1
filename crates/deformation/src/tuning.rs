//! Figures that a walker feels.

/// Slopes up to this angle carry a walker, radians.
pub const STEEPEST_RAD: f64 = 0.87;
/// Time in which a walker's eye glides to its felt height, seconds.
pub const EYE_GLIDE_S: f64 = 0.5;
/// Longest part of a step that is moved as a whole, seconds.
pub const LONGEST_PART_S: f64 = 1.0 / 240.0;
/// Of its radius, the most that a walker goes before it looks about for solids.
pub const STRIDE: f64 = 0.5;
