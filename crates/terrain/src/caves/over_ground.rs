//! Ways over the ground of noise space, flat or round, by nothing that machines compute differently.

use antipode_geometry::{ChartId, NoiseFrame};
use glam::DVec3;

use crate::field::Field;

/// The unit vectors of two directions on the ground that are square to each other.
fn axes(field: &Field, ground: DVec3) -> [DVec3; 2] {
    match field.strategy().noise_frame(ChartId::FIRST) {
        NoiseFrame::Radial { .. } => {
            let x = ground.any_orthogonal_vector().normalize();
            [x, ground.normalize().cross(x)]
        }
        NoiseFrame::Square(_) | NoiseFrame::Upright => [DVec3::X, DVec3::Z],
    }
}

/// About a unit vector along the ground, by how far it is turned in halves of a turn, -1 to 1.
pub(super) fn sideways(field: &Field, ground: DVec3, turned: f64) -> DVec3 {
    let [x, z] = axes(field, ground);
    // Round a square: exact on every machine, which sines are not.
    let at = 4.0 * turned;
    let corner = |at: f64| (2.0 - (at.rem_euclid(8.0) - 4.0).abs()).clamp(-1.0, 1.0);
    (x * corner(at) + z * corner(at - 2.0)).normalize()
}

/// A unit vector along the ground square to another.
pub(super) fn sideways_of(field: &Field, ground: DVec3, way: DVec3) -> DVec3 {
    let [x, z] = axes(field, ground);
    (z * way.dot(x) - x * way.dot(z)).normalize_or_zero()
}

/// The place on the ground so far from another.
pub(super) fn on_ground(field: &Field, ground: DVec3, offset: DVec3) -> DVec3 {
    match field.strategy().noise_frame(ChartId::FIRST) {
        NoiseFrame::Radial { radius_m } => (ground + offset).normalize() * radius_m,
        NoiseFrame::Square(_) | NoiseFrame::Upright => ground + offset,
    }
}
