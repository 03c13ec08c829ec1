//! How far an answer is off: in units in the last place, in radians, or relative to its size.

use glam::{DVec3, DVec4, Vec4};

/// The distance between neighbouring `f32` numbers at this size.
pub fn ulp(x: f64) -> f64 {
    let exponent = ((x.abs().to_bits() >> 52) as i32 - 1023).max(-1022);
    f64::from((exponent - 23).max(-149)).exp2()
}

/// Units in the last place between a single-precision answer and the exact one.
pub fn off(ours: f32, exact: f64) -> f64 {
    (f64::from(ours) - exact).abs() / ulp(exact)
}

/// The same for a ported point, in parts of 2^-23: its spatial part relative to that part's length,
/// and w to w, or to 1 where w is less. A vector's components have binades of their own, so there
/// is no one distance between neighbouring vectors.
pub fn off_point(ours: Vec4, exact: DVec4) -> f64 {
    off_vector(ours.as_dvec4() - exact, exact) / f64::from(f32::EPSILON)
}

/// Of a difference, the spatial part's greatest component relative to the exact length, and w.
pub fn off_vector(gap: DVec4, exact: DVec4) -> f64 {
    if gap.is_nan() {
        // `max` would lose it.
        return f64::NAN;
    }
    let length = exact.truncate().length();
    let space = gap.truncate().abs().max_element();
    let space = if length > 0.0 { space / length } else { space };
    space.max(gap.w.abs() / exact.w.abs().max(1.0))
}

/// The angle between two directions in radians, exact for small ones.
pub fn angle(a: DVec3, b: DVec3) -> f64 {
    let scale = |v: DVec3| v / v.abs().max_element();
    let (a, b) = (scale(a).normalize(), scale(b).normalize());
    2.0 * (a - b).length().atan2((a + b).length())
}

/// The relative difference.
pub fn relative(ours: f64, exact: f64) -> f64 {
    if ours == exact {
        return 0.0;
    }
    ((ours - exact) / exact).abs()
}

/// A point or a vector for the column of worst inputs.
pub fn words(v: DVec3) -> String {
    format!("({:.9e}, {:.9e}, {:.9e})", v.x, v.y, v.z)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_in_the_last_place_are_those_of_the_format() {
        for x in [1.0_f32, 1.999, 2.0, 1e-30, 3.3e7] {
            let next = f64::from(f32::from_bits(x.to_bits() + 1)) - f64::from(x);
            assert_eq!(ulp(f64::from(x)), next, "{x}");
        }
        assert_eq!(off(1.5, 1.5), 0.0);
        assert!(off_point(Vec4::NAN, DVec4::W).is_nan());
        assert!((angle(DVec3::X, DVec3::new(1.0, 1e-9, 0.0)) - 1e-9).abs() < 1e-20);
    }
}
