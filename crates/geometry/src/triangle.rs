//! Triangles of geodesics.

use std::f64::consts::PI;

/// The sum of the angles in radians of a triangle of geodesics whose sides are all `side_m` metres long, in a space of
/// curvature `curvature_per_m2`. A side too long for a triangle on a sphere, a third of the way round, is cut to it.
///
/// From the law of cosines with three equal sides: cos A = C / (1 + C), where C is the cosine of the side in radii on a
/// sphere, its hyperbolic cosine in hyperbolic space, and 1 in flat space.
pub fn equilateral_angle_sum_rad(curvature_per_m2: f64, side_m: f64) -> f64 {
    let side = side_m * curvature_per_m2.abs().sqrt();
    let c = if curvature_per_m2 < 0.0 {
        side.cosh()
    } else {
        side.min(2.0 * PI / 3.0).cos()
    };
    // For long hyperbolic sides C overflows to infinity, and the angles vanish.
    let cosine = if c.is_finite() { c / (1.0 + c) } else { 1.0 };
    3.0 * cosine.clamp(-1.0, 1.0).acos()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sum_is_two_right_angles_in_flat_space_and_three_in_an_octant() {
        assert!((equilateral_angle_sum_rad(0.0, 12.0) - PI).abs() < 1e-12);
        let quarter_m = 32.0 * PI / 2.0;
        let octant = equilateral_angle_sum_rad(32f64.powi(-2), quarter_m);
        assert!((octant - 1.5 * PI).abs() < 1e-12);
    }

    #[test]
    fn what_is_over_or_missing_is_the_area_in_radii() {
        // Gauss and Bonnet: for small triangles the area is nearly that of flat space.
        for curvature in [-1.0 / 400.0, 1.0 / 1024.0] {
            let side_m = 0.5;
            let area = 3f64.sqrt() / 4.0 * side_m * side_m;
            let over = equilateral_angle_sum_rad(curvature, side_m) - PI;
            assert!((over / (curvature * area) - 1.0).abs() < 1e-3, "{over}");
        }
        assert!(equilateral_angle_sum_rad(-1.0, 1e6) < 1e-6);
    }
}
