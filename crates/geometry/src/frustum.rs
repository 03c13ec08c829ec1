//! Culling: spheres in the curved space against the pyramid that the picture shows.
//!
//! The pyramid's sides are totally geodesic sheets through the eye, so in each space the
//! signed distance of a point from a side has a closed form. The test keeps whatever it cannot
//! rule out.

use glam::{DVec3, DVec4};

use crate::{FAR_LIMIT_RADII, Geometry, Projection};

/// A sphere about a ported object.
///
/// In flat and spherical space it is a ball of the space. In hyperbolic space balls are of no
/// use for culling: two points far off and a little apart are so distant from each other that
/// a ball about both holds the eye. There the radius is measured in the eye's normal
/// coordinates (direction from the eye times distance from the eye), where the pyramid's sides
/// are flat and a box keeps its size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoundingSphere {
    /// The middle in view coordinates: xyz in metres, w without unit.
    pub centre: DVec4,
    /// The radius in metres.
    pub radius_m: f64,
}

impl BoundingSphere {
    /// Distance in metres from the sphere's middle to a point in view coordinates, as its
    /// radius measures it.
    pub fn reach_m(&self, geometry: Geometry, radius_m: f64, view: DVec4) -> f64 {
        match geometry {
            Geometry::Euclidean => self.centre.truncate().distance(view.truncate()),
            Geometry::Hyperbolic => normal_coordinates(radius_m, self.centre)
                .distance(normal_coordinates(radius_m, view)),
            Geometry::Spherical => {
                let unit = |v: DVec4| (v.truncate() / radius_m).extend(v.w);
                let (a, b) = (unit(self.centre), unit(view));
                2.0 * radius_m * (a - b).length().atan2((a + b).length())
            }
        }
    }
}

/// Direction from the eye times geodesic distance, in metres, in hyperbolic space.
fn normal_coordinates(radius_m: f64, view: DVec4) -> DVec3 {
    let rho = view.truncate().length();
    if rho == 0.0 {
        return DVec3::ZERO;
    }
    view.truncate() * ((rho / radius_m).asinh() * radius_m / rho)
}

/// The region that the picture shows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frustum {
    /// Inward unit normals of the four sides, in view coordinates.
    sides: [DVec3; 4],
    geometry: Geometry,
    radius_m: f64,
}

impl Frustum {
    /// The region that `projection` shows in a space of that kind and radius in metres.
    pub fn new(projection: &Projection, geometry: Geometry, radius_m: f64) -> Self {
        let (sx, sy) = (projection.sx, projection.sy);
        let sides = [
            DVec3::new(sx, 0.0, -1.0),
            DVec3::new(-sx, 0.0, -1.0),
            DVec3::new(0.0, sy, -1.0),
            DVec3::new(0.0, -sy, -1.0),
        ];
        Self {
            sides: sides.map(DVec3::normalize_or_zero),
            geometry,
            radius_m,
        }
    }

    /// Whether anything in the sphere may be in the picture. False only where nothing is.
    pub fn sees(&self, sphere: &BoundingSphere) -> bool {
        match self.geometry {
            Geometry::Euclidean => {
                self.reaches(|side| side.dot(sphere.centre.truncate()), sphere.radius_m)
            }
            Geometry::Hyperbolic => {
                let centre = normal_coordinates(self.radius_m, sphere.centre);
                let nearest = centre.length() - sphere.radius_m;
                nearest <= FAR_LIMIT_RADII * self.radius_m
                    && self.reaches(|side| side.dot(centre), sphere.radius_m)
            }
            Geometry::Spherical => {
                // A ball of a right angle or more reaches past every great sphere.
                let angle = sphere.radius_m / self.radius_m;
                angle >= std::f64::consts::FRAC_PI_2
                    || self.reaches(
                        |side| side.dot(sphere.centre.truncate()) / self.radius_m,
                        angle.sin(),
                    )
            }
        }
    }

    /// No side has the sphere wholly behind it. NaN counts as seen.
    fn reaches(&self, height: impl Fn(DVec3) -> f64, depth: f64) -> bool {
        !self.sides.iter().any(|&side| height(side) < -depth)
    }
}
