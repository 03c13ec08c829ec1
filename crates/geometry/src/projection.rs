//! Projects view coordinates into the picture: focal factors, and one depth rule per space.
//!
//! Depth is reversed: it is cleared to 0, nearer is greater, and the near distance gives 1.

use glam::{DVec2, DVec4};

use crate::kernel::depth;

/// How near things come before far ones; clip z before the division by -Z, with n the near
/// distance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Depth {
    /// `n`: flat space.
    Reciprocal,
    /// `n / (W + k rho)`, which is `n exp(-d)`: keeps its relative precision to any hyperbolic
    /// distance, where `W - k rho` loses it all.
    Exponential {
        /// Radius of curvature in metres.
        radius_m: f64,
    },
    /// `(n W - Z) / 2`: linear in the vertex, and falls along a ray through W = 0 to the antipode.
    Great,
    /// `n (1 + W) / 2`: on a sphere it falls to the antipode too, and becomes the flat rule as the
    /// sphere grows.
    Upright,
}

/// A perspective projection without a far plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Projection {
    /// Horizontal focal factor: clip x per view x.
    pub sx: f64,
    /// Vertical focal factor: clip y per view y.
    pub sy: f64,
    /// Near distance in metres.
    pub near_m: f64,
}

impl Projection {
    /// `fov_y_rad` is the full vertical field of view, below a half turn; `aspect` is width by
    /// height.
    pub fn new(fov_y_rad: f64, aspect: f64, near_m: f64) -> Self {
        let sy = 1.0 / (0.5 * fov_y_rad).tan();
        let sx = sy / aspect;
        Self { sx, sy, near_m }
    }

    /// Clip coordinates of a point in view coordinates, under a depth rule.
    pub fn clip(&self, rule: Depth, view: DVec4) -> DVec4 {
        let z = match rule {
            Depth::Reciprocal => self.near_m,
            Depth::Exponential { radius_m } => {
                depth::exponential(self.near_m, 1.0 / radius_m, view.to_array())
            }
            Depth::Great => depth::great(self.near_m, view.to_array()),
            Depth::Upright => depth::upright(self.near_m, view.to_array()),
        };
        DVec4::new(self.sx * view.x, self.sy * view.y, z, -view.z)
    }

    /// Where clip coordinates fall in the picture, -1 to 1 from left to right and from bottom
    /// to top; `None` for what lies behind the eye.
    pub fn screen(clip: DVec4) -> Option<DVec2> {
        (clip.w > 0.0).then(|| DVec2::new(clip.x, clip.y) / clip.w)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests fail by panicking")]
mod tests {
    use super::*;

    #[test]
    fn the_edges_of_the_field_of_view_are_the_edges_of_the_picture() {
        let fov: f64 = 1.2;
        let projection = Projection::new(fov, 1.6, 0.1);
        let edge = DVec4::new(0.0, (0.5 * fov).tan() * 7.0, -7.0, 1.0);
        let clip = projection.clip(Depth::Reciprocal, edge);
        assert!((Projection::screen(clip).unwrap() - DVec2::Y).length() < 1e-14);
        assert!((projection.sy / projection.sx - 1.6).abs() < 1e-14);
        let behind = DVec4::new(0.0, 0.0, 1.0, 1.0);
        let clip = projection.clip(Depth::Reciprocal, behind);
        assert_eq!(Projection::screen(clip), None);
    }

    #[test]
    fn the_near_distance_has_depth_one_in_every_space() {
        let (near, radius) = (0.05, 20.0);
        let projection = Projection::new(1.0, 1.0, near);
        let t: f64 = near / radius;
        let exponential = Depth::Exponential { radius_m: radius };
        let cases = [
            (Depth::Reciprocal, -near, 1.0),
            (exponential, -radius * t.sinh(), t.cosh()),
            (Depth::Great, -radius * t.sin(), t.cos()),
            (Depth::Upright, -radius * t.sin(), t.cos()),
        ];
        for (rule, z, w) in cases {
            let view = DVec4::new(0.0, 0.0, z, w);
            let clip = projection.clip(rule, view);
            assert!((clip.z / clip.w - 1.0).abs() < 0.003, "{rule:?}");
        }
    }

    #[test]
    fn depth_falls_along_rays_in_f32() {
        // To d = 20 in hyperbolic space, and through W = 0 to just before the antipode on the
        // sphere. The f32 depth itself must order two surfaces a hundredth of a radius apart.
        let (near, radius) = (0.05, 20.0);
        let projection = Projection::new(1.0, 1.0, near);
        let exponential = Depth::Exponential { radius_m: radius };
        let depth = |rule, t: f64| {
            let (z, w) = match rule {
                Depth::Reciprocal => (-radius * t, 1.0),
                Depth::Exponential { .. } => (-radius * t.sinh(), t.cosh()),
                Depth::Great | Depth::Upright => (-radius * t.sin(), t.cos()),
            };
            let tilt: f64 = 0.4;
            let view = DVec4::new(-z * tilt.sin(), 0.0, z * tilt.cos(), w);
            let clip = projection.clip(rule, view);
            (clip.z as f32) / (clip.w as f32)
        };
        let ends = [
            (Depth::Reciprocal, 40.0),
            (exponential, 40.0),
            (Depth::Great, std::f64::consts::PI - near / radius),
            (Depth::Upright, std::f64::consts::PI - near / radius),
        ];
        for (rule, end) in ends {
            let mut last = f32::INFINITY;
            let mut t = 2.0 * near / radius;
            while t < end {
                let here = depth(rule, t);
                assert!(here < last && here > 0.0, "{rule:?} at {t}: {here} {last}");
                last = here;
                t += 0.01;
            }
        }
    }
}
