//! Triangles of geodesics.

use std::f64::consts::PI;

/// The sum of the angles in radians of a triangle of geodesics whose sides are all `side_m` metres long, in a space of
/// curvature `curvature_per_m2`. A side too long for a triangle on a sphere, a third of the way round, is cut to it.
///
/// From the law of cosines with three equal sides: cos A = C / (1 + C), where C is the cosine of the side in radii on a
/// sphere, its hyperbolic cosine in hyperbolic space, and 1 in flat space. So sin^2(A/2) = (1 - cos A)/2 =
/// 1/(2 (1 + C)), which keeps the digits of small angles, and is 0 where C overflows.
pub fn equilateral_angle_sum_rad(curvature_per_m2: f64, side_m: f64) -> f64 {
    let side = side_m * curvature_per_m2.abs().sqrt();
    let c = if curvature_per_m2 < 0.0 {
        side.cosh()
    } else {
        side.min(2.0 * PI / 3.0).cos()
    };
    6.0 * (0.5 / (1.0 + c)).sqrt().min(1.0).asin()
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

    /// By mpmath with 40 digits.
    #[test]
    fn sums_keep_their_digits_however_small() {
        for (curvature, side_m, sum) in [
            (-1.0 / 400.0, 0.5, 3.141_322_041_792_547),
            (-1.0 / 400.0, 10.0, 3.036_613_549_934_796),
            (-1.0 / 400.0, 100.0, 0.489_757_377_252_533_8),
            (-1.0 / 400.0, 700.0, 1.506_599_493_446_388e-07),
            (1.0 / 1024.0, 10.0, 3.184_402_059_240_413),
            (1.0 / 1024.0, 60.0, 6.037_963_899_448_496),
            (1.0 / 4096.0, 1.0, 3.141_698_372_807_767),
        ] {
            let off: f64 = equilateral_angle_sum_rad(curvature, side_m) - sum;
            assert!((off / sum).abs() < 1e-13, "{curvature} {side_m}: {off}");
        }
    }
}
