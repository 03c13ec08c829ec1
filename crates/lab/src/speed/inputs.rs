//! Points as a camera over land sees them, the same on every run.

use crate::random::Numbers;

/// A point `near_m` to `far_m` metres away along the ground, nearer ones as often as farther ones, and up to
/// `height_m` above or below the eye; exact in `f32`.
pub fn ground(numbers: &mut Numbers, near_m: f64, far_m: f64, height_m: f64) -> [f32; 3] {
    let away = numbers.turn() * numbers.magnitude(near_m, far_m);
    [away.x, numbers.between(-height_m, height_m), away.y].map(|x| x as f32)
}
