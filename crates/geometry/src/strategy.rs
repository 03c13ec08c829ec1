//! The one trait through which the game knows its space.

use std::ops::RangeInclusive;
use std::sync::Arc;

use crate::{
    Atlas, Euclidean, Geometry, Horizon, HyperbolicMap, Map, Metric, Optics, Raised, Spherical,
};

/// Radius of curvature of hyperbolic worlds unless a world says otherwise, in metres.
pub const DEFAULT_HYPERBOLIC_RADIUS_M: f64 = 20.0;
/// Radius of spherical worlds unless a world says otherwise, in metres.
pub const DEFAULT_SPHERE_RADIUS_M: f64 = 32.0;
/// Radii that a player may choose for a spherical world, in metres.
pub const SPHERE_RADIUS_RANGE_M: RangeInclusive<f64> = 16.0..=256.0;
/// Hyperbolic worlds draw nothing farther than this many radii from the eye: past it a
/// hyperboloid coordinate in `f32` has no digits left to order two surfaces by.
pub const FAR_LIMIT_RADII: f64 = 20.0;

/// A space: its charts, how they are seen and drawn, and how long its ways are.
pub trait Strategy: Atlas + Map + Optics + Metric {}

impl<T: Atlas + Map + Optics + Metric> Strategy for T {}

/// The space of that kind and radius in metres.
///
/// Flat space ignores the radius. A radius that is not a positive number is replaced by the
/// default one; menus and commands check [`SPHERE_RADIUS_RANGE_M`] before.
pub fn strategy(geometry: Geometry, radius_m: f64) -> Arc<dyn Strategy> {
    let radius_or = |default_m: f64| {
        if radius_m.is_finite() && radius_m > 0.0 {
            radius_m
        } else {
            default_m
        }
    };
    match geometry {
        Geometry::Euclidean => Arc::new(Euclidean),
        Geometry::Hyperbolic => Arc::new(Raised::new(radius_or(DEFAULT_HYPERBOLIC_RADIUS_M))),
        Geometry::Spherical => Arc::new(Spherical::new(radius_or(DEFAULT_SPHERE_RADIUS_M))),
    }
}

/// The strategy that pictures of a world are taken with: in hyperbolic worlds through the given
/// map, in flat ones bent by the eye's dial or not. Everything that is not about the picture is as
/// in [`strategy`] of the same geometry and radius.
pub fn picture(
    geometry: Geometry,
    radius_m: f64,
    map: HyperbolicMap,
    bend: bool,
) -> Arc<dyn Strategy> {
    let world = strategy(geometry, radius_m);
    match geometry {
        Geometry::Hyperbolic if map == HyperbolicMap::Horizon => {
            Arc::new(Horizon::hyperbolic(world.radius_m()))
        }
        Geometry::Euclidean if bend => Arc::new(Horizon::bent()),
        _ => world,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_useless_radius_becomes_the_default() {
        for radius in [0.0, -3.0, f64::NAN, f64::INFINITY] {
            let sphere = strategy(Geometry::Spherical, radius);
            assert_eq!(sphere.radius_m(), DEFAULT_SPHERE_RADIUS_M);
            let raised = strategy(Geometry::Hyperbolic, radius);
            assert_eq!(raised.radius_m(), DEFAULT_HYPERBOLIC_RADIUS_M);
        }
        assert_eq!(strategy(Geometry::Spherical, 48.0).radius_m(), 48.0);
        assert_eq!(
            strategy(Geometry::Euclidean, 48.0).radius_m(),
            f64::INFINITY
        );
    }

    #[test]
    fn only_the_sphere_has_a_rim_limits_and_no_sky() {
        for geometry in Geometry::ALL {
            let space = strategy(geometry, 32.0);
            let sphere = geometry == Geometry::Spherical;
            assert_eq!(space.geometry(), geometry);
            assert_eq!(space.all_charts().is_some(), sphere);
            assert_eq!(space.limits().is_some(), sphere);
            assert_eq!(space.has_sky(), !sphere);
            assert_eq!(space.dial().is_some(), geometry == Geometry::Hyperbolic);
        }
    }
}
