//! Triangles and squares of geodesics.

use std::f64::consts::PI;

use glam::{DMat3, DVec3};

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

/// How far one ends from where one began who walks four sides of `side_m` metres with a right angle to the same hand between
/// them, in metres, in a space of curvature `curvature_per_m2`; 0 in flat space.
///
/// In (X, Z, W), with C and S the cosine and sine of a side in radii on a sphere, and its hyperbolic ones in hyperbolic space, a
/// side ahead is `T: (X, W) -> (C X + S W, C W -+ S X)` and a quarter turn `Q: (X, Z) -> (-Z, X)`. One begins at (0, 0, 1) and
/// ends at `p = (T Q)^4 (0, 0, 1)`, at a distance whose sine is the length of (X, Z).
pub fn square_gap_m(curvature_per_m2: f64, side_m: f64) -> f64 {
    let root = curvature_per_m2.abs().sqrt();
    let side = side_m * root;
    let is_hyperbolic = curvature_per_m2 < 0.0;
    let (c, s) = if is_hyperbolic {
        (side.cosh(), side.sinh())
    } else {
        (side.cos(), side.sin())
    };
    let back = if is_hyperbolic { s } else { -s };
    let ahead = DMat3::from_cols_array_2d(&[[c, 0.0, back], [0.0, 1.0, 0.0], [s, 0.0, c]]);
    let turn = DMat3::from_cols_array_2d(&[[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]);
    let end = (0..4).fold(DVec3::Z, |at, _| ahead * (turn * at));
    let sine = end.truncate().length();
    if is_hyperbolic {
        sine.asinh() / root
    } else if root > 0.0 {
        sine.atan2(end.z) / root
    } else {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_1_SQRT_2;

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

    /// The first three are those of the golden tiling, by exact numbers a + b phi.
    #[test]
    fn four_sides_do_not_close_in_curved_space_and_a_fifth_closes_where_five_squares_meet() {
        let golden = 0.5 * (1.0 + 5f64.sqrt());
        let radius_m = 64.0 / golden.acosh();
        let k = -1.0 / (radius_m * radius_m);
        for (side_m, gap_m) in [(20.0, 1.599), (30.0, 5.581), (64.0, 64.0)] {
            let found = square_gap_m(k, side_m);
            assert!((found / gap_m - 1.0).abs() < 1e-3, "{side_m}: {found}");
        }
        assert_eq!(square_gap_m(0.0, 30.0), 0.0);
        // Of a small square of side s the gap is s^3 |K| / sqrt(2): it turns by its area s^2 |K| about a corner that is s sqrt(1/2)
        // from its middle.
        for curvature in [1.0, -1.0] {
            let small = square_gap_m(curvature, 1e-2);
            assert!((small / 1e-6 - FRAC_1_SQRT_2).abs() < 1e-3, "{small}");
        }
        // Three quarters of the way round closes with three sides; four sides of a quarter end a quarter away.
        let quarter_m = 0.5 * PI;
        assert!((square_gap_m(1.0, quarter_m) - quarter_m).abs() < 1e-12);
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
