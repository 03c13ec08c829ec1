//! The equiangular chart of a square, in metres: lines along its grid are geodesics, and the square is one of the chart, too.
//!
//! With `a = tanh(x/R) = X/W` and `b = tanh(z/R) = Z/W` a point of the plane is `W (a, b, 1)` with
//! `W = 1/sqrt(1 - a^2 - b^2)`. Directions are told in the frame that comes of the axes at the centre by parallel transport
//! along the plane, as in the cylindrical chart: `E_x = (1 + X^2/(1 + W), X Z/(1 + W), X)` in (X, Z, W), and E_z alike. A
//! tangent (p, q, s) there has the components `p - X s/(1 + W)` and `q - Z s/(1 + W)`.

use glam::{DMat2, DMat4, DVec2, DVec3, DVec4, Vec3Swizzles};

use crate::tiling::{APOTHEM, equiangular_chart, equiangular_point};

/// A chart is written to this part of its square's width past each edge, where neighbouring charts have taken over.
const PAST: f64 = 0.25;
/// X/W there, along an axis: `tanh(1.5 APOTHEM)`.
const REACH_TANH: f64 = 0.661_770_042_700_383_5;
/// What lies past these is drawn in to them, so that everything written has a place: along an axis in radii, and the product
/// of the sines of both, which is 1 where the plane ends.
const FAR_RAD: f64 = 3.0;
const FAR_PRODUCT: f64 = 0.98;
/// Within so many radii along both axes no product is so great: `sinh(0.85)^2 = 0.914`.
const NEAR_RAD: f64 = 0.85;
/// Heights are drawn in to so many radii: squares of coordinates are in range of `f64`.
pub(super) const HIGH_RAD: f64 = 40.0;

/// The chart of any square of a world.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct SquareChart {
    pub radius_m: f64,
}

impl SquareChart {
    /// Half the width of the square, metres.
    pub fn half_m(self) -> f64 {
        APOTHEM * self.radius_m
    }

    /// How far from its middle along an axis the chart is written, metres.
    pub fn reach_m(self) -> f64 {
        (1.0 + 2.0 * PAST) * self.half_m()
    }

    /// Whether a chart is written at a point of its model.
    pub fn is_written(point: DVec4) -> bool {
        point.x.abs().max(point.z.abs()) <= REACH_TANH * point.w
    }

    /// A place in radii, drawn in to where it has a point; what is no number counts as 0.
    fn drawn_in(self, pos: DVec3) -> DVec3 {
        let limits = DVec3::new(FAR_RAD, HIGH_RAD, FAR_RAD);
        let number = |x: f64| if x.is_nan() { 0.0 } else { x };
        let at = DVec3::from_array((pos / self.radius_m).to_array().map(number));
        let mut at = at.clamp(-limits, limits);
        if at.x.abs().max(at.z.abs()) <= NEAR_RAD {
            return at;
        }
        let [x, z] = [at.x, at.z].map(|it| it.sinh().abs());
        if x * z > FAR_PRODUCT {
            let lesser = (FAR_PRODUCT / x.max(z)).asinh();
            let part = if x < z { &mut at.x } else { &mut at.z };
            *part = lesser.copysign(*part);
        }
        at
    }

    /// The point (X, Y, Z, W) of a place, in radii.
    pub fn point(self, pos: DVec3) -> DVec4 {
        equiangular_point(self.drawn_in(pos)).unwrap_or(DVec4::W)
    }

    /// The place of a point.
    pub fn pos(self, point: DVec4) -> DVec3 {
        equiangular_chart(point) * self.radius_m
    }

    /// The frame at a place: the axes of x, up and z, and the point, by columns.
    pub fn frame(self, pos: DVec3) -> DMat4 {
        let point = self.point(pos);
        let cosh = 1.0f64.hypot(point.y);
        let [x, z, w] = [point.x, point.z, point.w].map(|it| it / cosh);
        let part = 1.0 / (1.0 + w);
        DMat4::from_cols(
            DVec4::new(1.0 + x * x * part, 0.0, x * z * part, x),
            DVec4::new(point.y * x, cosh, point.y * z, point.y * w),
            DVec4::new(x * z * part, 0.0, 1.0 + z * z * part, z),
            point,
        )
    }

    /// By how much a tile's frame at a place is turned against the frame of another, given the way there: what a direction
    /// takes that is carried along, right-handed about the upright, radians.
    pub fn turn_rad(self, pos: DVec3, way: DMat4) -> f64 {
        let level = self.frame(pos.with_y(0.0));
        let (axis, at) = (way * level.x_axis, way * level.w_axis);
        let part = axis.w / (1.0 + at.w);
        -(axis.z - at.z * part).atan2(axis.x - at.x * part)
    }

    /// What takes a level step of the chart at a place to metres of the space along the frame, and the stretch of height that
    /// is in it.
    ///
    /// A step along x turns a by `da = 1 - a^2` and moves the point by `da (W (1, 0, 0) + a W^3 (a, b, 1))`, which has
    /// the components `da (W (1, 0) + a W^3/(1 + W) (a, b))`.
    fn level_lengths(self, pos: DVec3) -> DMat2 {
        let at = self.drawn_in(pos);
        let v = DVec2::new(at.x.tanh(), at.z.tanh());
        let rest = 1.0 - v * v;
        let w = (1.0 - v.length_squared()).sqrt().recip();
        let part = w * w * w / (1.0 + w);
        let column = |axis: DVec2, along: f64, rest: f64| rest * (w * axis + part * along * v);
        let plane = DMat2::from_cols(column(DVec2::X, v.x, rest.x), column(DVec2::Y, v.y, rest.y));
        plane * at.y.cosh()
    }

    /// A vector of the chart at a place in metres of the space along the frame.
    pub fn in_frame(self, pos: DVec3, vector: DVec3) -> DVec3 {
        let level = self.level_lengths(pos) * vector.xz();
        DVec3::new(level.x, vector.y, level.y)
    }

    /// The inverse of [`Self::in_frame`].
    pub fn in_chart(self, pos: DVec3, vector: DVec3) -> DVec3 {
        let level = self.level_lengths(pos).inverse() * vector.xz();
        DVec3::new(level.x, vector.y, level.y)
    }

    /// A normal of the chart at a place as a unit covector in the frame: by the transposed inverse of the lengths.
    pub fn normal(self, pos: DVec3, normal: DVec3) -> DVec3 {
        let level = self.level_lengths(pos).inverse().transpose() * normal.xz();
        DVec3::new(level.x, normal.y, level.y).normalize_or_zero()
    }

    /// The longest that a metre of the chart is anywhere within so far along the axes of a place, on the plane; infinite
    /// where that leads past the end of the plane. It grows outwards, so that the corner farthest out has it.
    ///
    /// Of the matrix of lengths M it is the root of the greater eigenvalue of `M^T M`.
    pub fn most_stretch(self, pos: DVec3, around_m: f64) -> f64 {
        let corner = (pos.abs() + around_m).with_y(0.0);
        let [x, z] = [corner.x, corner.z].map(|it| (it / self.radius_m).sinh());
        // Not so of a NaN either.
        if x * z < FAR_PRODUCT && corner.max_element() < FAR_RAD * self.radius_m {
            let lengths = self.level_lengths(corner);
            let square = lengths.transpose() * lengths;
            let [a, b, c] = [square.x_axis.x, square.y_axis.y, square.x_axis.y];
            (0.5 * (a + b) + (0.5 * (a - b)).hypot(c)).sqrt()
        } else {
            f64::INFINITY
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chart_is_written_to_its_reach() {
        let chart = SquareChart { radius_m: 60.0 };
        assert!((REACH_TANH - (1.5 * APOTHEM).tanh()).abs() < 2e-16);
        for (share, within) in [(1.0 - 1e-12, true), (1.0 + 1e-12, false)] {
            let pos = DVec3::new(chart.reach_m() * share, 30.0, -20.0);
            assert_eq!(SquareChart::is_written(chart.point(pos)), within);
        }
        assert!(!SquareChart::is_written(DVec4::NAN));
    }
}
