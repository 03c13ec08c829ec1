//! Rays, sphere casts and overlaps against the terrain.

use glam::DVec3;
use rapier3d::math::Pose;
use rapier3d::parry::query::Ray;
use rapier3d::parry::query::details::ShapeCastOptions;
use rapier3d::parry::shape::Ball;

use crate::patch::{Capsule, Patch};
use crate::{BodyGround, ChartGround};

/// Overlaps shallower than this (m) are touches: standing on the ground is no overlap.
const TOUCH_M: f64 = 1e-3;

/// Least share of a ray's direction along each axis.
const LEAST_SHARE: f64 = 1e-6;

/// Where a ray meets the terrain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RayHit {
    /// Distance from the ray's origin in metres.
    pub distance_m: f64,
    /// The point that was hit, in metres of its chart.
    pub point: DVec3,
    /// Unit normal of the triangle that was hit, on the side the ray came from.
    pub normal: DVec3,
}

impl ChartGround {
    /// The first terrain along a ray from `origin` (m) within `max_m` metres. `direction` need not
    /// be unit but must not be zero; a ray that is not finite hits nothing. Both sides of the
    /// ground are hit.
    pub fn cast_ray(&self, origin: DVec3, direction: DVec3, max_m: f64) -> Option<RayHit> {
        let direction = askew(sound_way(origin, direction, max_m)?);
        let ray = Ray::new((origin - self.origin()).as_vec3(), direction.as_vec3());
        let (_, hit) = self
            .queries()
            .cast_ray_and_get_normal(&ray, max_m as f32, false)?;
        let distance_m = f64::from(hit.time_of_impact);
        Some(RayHit {
            distance_m,
            point: origin + direction * distance_m,
            normal: hit.normal.as_dvec3().normalize_or_zero(),
        })
    }

    /// How far (m) a ball of `radius_m` at `origin` can go along `direction` before it touches
    /// terrain; `None` when it is free for `max_m` metres, 0 when it touches from the start.
    pub fn cast_sphere(
        &self,
        origin: DVec3,
        direction: DVec3,
        radius_m: f64,
        max_m: f64,
    ) -> Option<f64> {
        let direction = sound_way(origin, direction, max_m)?;
        if !(radius_m > 0.0 && radius_m.is_finite()) {
            return self
                .cast_ray(origin, direction, max_m)
                .map(|hit| hit.distance_m);
        }
        let from = Pose::from_translation((origin - self.origin()).as_vec3());
        let options = ShapeCastOptions::with_max_time_of_impact(max_m as f32);
        let ball = Ball::new(radius_m as f32);
        let (_, hit) = self
            .queries()
            .cast_shape(&from, direction.as_vec3(), &ball, options)?;
        Some(f64::from(hit.time_of_impact).clamp(0.0, max_m))
    }
}

impl BodyGround<'_> {
    /// Whether an upright capsule that stands with its feet at `feet` (m) cuts into terrain, by
    /// more than a millimetre and from either side. A capsule wholly inside the ground cuts nothing.
    pub fn overlaps_capsule(&self, feet: DVec3, height_m: f64, radius_m: f64) -> bool {
        if !feet.is_finite() {
            return false;
        }
        let capsule = Capsule::new(height_m, radius_m);
        let (min, max) = capsule.bounds(feet);
        let frame = self.frame(feet);
        Patch::gather(self.ground, frame.as_ref(), feet, min, max)
            .depth_any_side(&capsule, DVec3::ZERO)
            > TOUCH_M
    }
}

/// The same direction, but for a share of a millionth along an axis that it is square to: 0.02 mm at 20 m. The tree of
/// boxes misses what such a ray meets, since it puts the reciprocal of a small number in place of that of one below
/// 1.2e-7.
fn askew(direction: DVec3) -> DVec3 {
    let kept = |share: f64| {
        if share.abs() < LEAST_SHARE {
            LEAST_SHARE.copysign(share)
        } else {
            share
        }
    };
    DVec3::from_array(direction.to_array().map(kept))
}

fn sound_way(origin: DVec3, direction: DVec3, max_m: f64) -> Option<DVec3> {
    if origin.is_finite() && max_m > 0.0 {
        direction.try_normalize()
    } else {
        None
    }
}
