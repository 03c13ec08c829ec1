//! The maps from flat chart coordinates onto a model of the space, in units of its radius.
//!
//! A point X of the model has `inner(X, X) = sign` (w = 1 in flat space) and a tangent V at X
//! has `inner(X, V) = 0`. A map is given for points and one for directions; the latter lands
//! on an orthonormal frame, so it keeps lengths and angles.

use glam::{DVec3, DVec4};

use crate::kernel;

/// The model's inner product: `x x' + y y' + z z' + sign w w'`.
pub fn inner(sign: f64, a: DVec4, b: DVec4) -> f64 {
    kernel::linear::inner(sign, a.to_array(), b.to_array())
}

/// The exponential chart: straight lines through the centre become geodesics of the same
/// length. `q` is in units of the radius.
pub fn exponential(sign: f64, q: DVec3) -> DVec4 {
    kernel::exponential::point(sign, q.to_array()).into()
}

/// A direction at `q`, carried out from the centre by parallel transport along the ray.
pub fn exponential_direction(sign: f64, q: DVec3, v: DVec3) -> DVec4 {
    kernel::exponential::direction(sign, q.to_array(), v.to_array()).into()
}

/// The cylindrical (Fermi) chart: the sheet y = 0 is totally geodesic, and verticals are
/// geodesics perpendicular to it. `p` is in units of the radius.
pub fn cylindrical(sign: f64, p: DVec3) -> DVec4 {
    kernel::cylindrical::point(sign, p.to_array()).into()
}

/// A direction at `p` on the chart's orthonormal frame: radial, tangential and up.
pub fn cylindrical_direction(sign: f64, p: DVec3, v: DVec3) -> DVec4 {
    kernel::cylindrical::direction(sign, p.to_array(), v.to_array()).into()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::{cos_s, sinc_s};
    use proptest::prelude::*;

    type PointMap = fn(f64, DVec3) -> DVec4;
    type DirectionMap = fn(f64, DVec3, DVec3) -> DVec4;
    const CHARTS: [(PointMap, DirectionMap); 2] = [
        (exponential, exponential_direction),
        (cylindrical, cylindrical_direction),
    ];

    fn vector(range: f64) -> impl Strategy<Value = DVec3> {
        prop::array::uniform3(-range..range).prop_map(DVec3::from_array)
    }

    /// Checks the model's equations within `eps cosh^2`, the representation's own limit.
    fn check_model(sign: f64, q: DVec3, v: DVec3, w: DVec3) -> Result<(), TestCaseError> {
        for (point, direction) in CHARTS {
            let x = point(sign, q);
            let tolerance = 1e-14 * (1.0 + x.length_squared());
            prop_assert!((inner(sign, x, x) - sign).abs() < tolerance);
            let (a, b) = (direction(sign, q, v), direction(sign, q, w));
            let tangent = 1e-14 * (1.0 + x.length() * a.length());
            prop_assert!(inner(sign, x, a).abs() < tangent);
            let pair = 1e-14 * (1.0 + a.length() * b.length());
            prop_assert!((inner(sign, a, b) - v.dot(w)).abs() < pair);
        }
        Ok(())
    }

    /// The same cases on every run.
    fn fixed() -> ProptestConfig {
        ProptestConfig {
            rng_seed: proptest::test_runner::RngSeed::Fixed(20),
            failure_persistence: None,
            ..ProptestConfig::default()
        }
    }

    proptest! {
        #![proptest_config(fixed())]

        #[test]
        fn spherical_points_and_tangents_obey_the_model(
            q in vector(3.0), v in vector(1.0), w in vector(1.0),
        ) {
            check_model(1.0, q, v, w)?;
        }

        #[test]
        fn hyperbolic_points_and_tangents_obey_the_model(
            q in vector(10.0), v in vector(1.0), w in vector(1.0),
        ) {
            check_model(-1.0, q, v, w)?;
        }

        #[test]
        fn every_magnitude_stays_on_the_model(
            q in vector(1.0), exponent in -30.0..1.2_f64, v in vector(1.0),
        ) {
            let q = q * 10.0_f64.powf(exponent);
            check_model(-1.0, q, v, v)?;
            check_model(1.0, q, v, v)?;
        }
    }

    #[test]
    fn frames_are_the_derivative_of_the_chart_up_to_its_stretch() {
        // Lengths along E_r, E_t, E_y per chart metre are cos y, cos y sinc r and 1.
        let p = DVec3::new(0.6, 0.3, -0.8);
        let (c, step) = (DVec3::new(0.6, 0.0, -0.8), 1e-6);
        let t = DVec3::new(0.8, 0.0, 0.6);
        for sign in [-1.0, 1.0] {
            let (cos_y, across) = (cos_s(sign, 0.3), sinc_s(sign, 1.0));
            for (v, stretch) in [(c, cos_y), (t, cos_y * across), (DVec3::Y, 1.0)] {
                let slope = (cylindrical(sign, p + v * step) - cylindrical(sign, p - v * step))
                    / (2.0 * step);
                let frame = cylindrical_direction(sign, p, v) * stretch;
                assert!((slope - frame).length() < 1e-9);
            }
        }
    }
}
