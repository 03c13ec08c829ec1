//! The kinds of spaces, and the maps through which they are seen.

use std::fmt;
use std::ops::RangeInclusive;
use std::str::FromStr;
use std::sync::Arc;

use serde::{Deserialize, Serialize};

use crate::{Strategy, ViewMode, flat, hyperbolic, hyperbolic_world, spherical};

/// Radii of curvature of the worlds of a space, in metres.
#[derive(Debug, Clone, PartialEq)]
pub struct Radii {
    /// Where none is chosen; infinite where space is flat.
    pub default_m: f64,
    /// What a player may choose from, where there is a choice.
    pub chosen_m: Option<RangeInclusive<f64>>,
    /// What a save may say; anything where it does not matter.
    pub saved_m: Option<RangeInclusive<f64>>,
}

/// What there is to know of a space before there is a world in it: its row in the table of spaces.
pub(crate) struct Entry {
    pub name: &'static str,
    pub radii: Radii,
    /// The space of a radius, which is positive and, but where flat, finite.
    pub make: fn(f64) -> Arc<dyn Strategy>,
}

/// The space of that kind and radius in metres.
///
/// Flat space ignores the radius. A radius that is not a positive number is replaced by the
/// default one; menus and commands check [`Radii::chosen_m`] before.
pub fn strategy(geometry: Geometry, radius_m: f64) -> Arc<dyn Strategy> {
    let Entry { make, radii, .. } = geometry.entry();
    let is_useful = radius_m.is_finite() && radius_m > 0.0;
    make(if is_useful { radius_m } else { radii.default_m })
}

/// The space that pictures of a world are taken with: in hyperbolic worlds through the given
/// map, in flat ones bent by the eye's dial or not. Everything that is not about the picture is as
/// in [`strategy`] of the same geometry and radius.
pub fn picture(
    geometry: Geometry,
    radius_m: f64,
    map: HyperbolicMap,
    bend: bool,
) -> Arc<dyn Strategy> {
    let world = strategy(geometry, radius_m);
    ViewMode::saved(world.view_modes(), map, bend).of(&world, 1.0)
}

/// The kinds of world that a player can choose: each has a row in the menus and a name in saves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Geometry {
    /// Flat space, curvature 0.
    Euclidean,
    /// Flat land seen in hyperbolic space, curvature -1/R^2: the hyperbolic lens.
    Hyperbolic,
    /// The three-sphere, curvature +1/R^2.
    Spherical,
    /// Hyperbolic space over a plane in squares, five about a corner, curvature -1/R^2.
    #[serde(rename = "hyperbolic-world")]
    HyperbolicWorld,
}

impl Geometry {
    /// All of them, each at the place of its variant.
    pub const ALL: [Self; 4] = [
        Self::Euclidean,
        Self::Hyperbolic,
        Self::Spherical,
        Self::HyperbolicWorld,
    ];

    fn entry(self) -> &'static Entry {
        match self {
            Self::Euclidean => &flat::ENTRY,
            Self::Hyperbolic => &hyperbolic::ENTRY,
            Self::Spherical => &spherical::ENTRY,
            Self::HyperbolicWorld => &hyperbolic_world::ENTRY,
        }
    }

    /// The lower-case name, as in saves and on the command line.
    pub fn name(self) -> &'static str {
        self.entry().name
    }

    /// Radii of curvature of its worlds.
    pub fn radii(self) -> &'static Radii {
        &self.entry().radii
    }
}

impl fmt::Display for Geometry {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// A word that names none of the spaces.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("\"{0}\" is not a geometry; choose euclidean, hyperbolic, spherical or hyperbolic-world")]
pub struct ParseGeometryError(String);

impl FromStr for Geometry {
    type Err = ParseGeometryError;

    /// Reads a lower-case name.
    ///
    /// # Errors
    /// [`ParseGeometryError`] for any other word.
    fn from_str(name: &str) -> Result<Self, Self::Err> {
        Self::ALL
            .into_iter()
            .find(|geometry| geometry.name() == name)
            .ok_or_else(|| ParseGeometryError(name.to_owned()))
    }
}

/// How hyperbolic worlds are carried into hyperbolic space.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum HyperbolicMap {
    /// The exponential chart with its centre below the eye; the dial is that offset.
    #[default]
    Raised,
    /// The cylindrical chart about the eye's plumb line; the dial is the curvature itself.
    Horizon,
}

impl HyperbolicMap {
    /// Both, in menu order.
    pub const ALL: [Self; 2] = [Self::Raised, Self::Horizon];

    /// The lower-case name, as in saves and scripts.
    pub fn name(self) -> &'static str {
        match self {
            Self::Raised => "raised",
            Self::Horizon => "horizon",
        }
    }

    /// The other map.
    #[must_use]
    pub fn other(self) -> Self {
        match self {
            Self::Raised => Self::Horizon,
            Self::Horizon => Self::Raised,
        }
    }
}

impl fmt::Display for HyperbolicMap {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// A word that names no map of hyperbolic worlds.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("\"{0}\" is not a hyperbolic map; choose raised or horizon")]
pub struct ParseMapError(String);

impl FromStr for HyperbolicMap {
    type Err = ParseMapError;

    /// Reads a lower-case name.
    ///
    /// # Errors
    /// [`ParseMapError`] for any other word.
    fn from_str(name: &str) -> Result<Self, Self::Err> {
        Self::ALL
            .into_iter()
            .find(|map| map.name() == name)
            .ok_or_else(|| ParseMapError(name.to_owned()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{DEFAULT_HYPERBOLIC_RADIUS_M, DEFAULT_SPHERE_RADIUS_M};

    #[test]
    fn names_read_back_and_others_are_refused() {
        for geometry in Geometry::ALL {
            assert_eq!(geometry.to_string().parse(), Ok(geometry));
        }
        let refused = "Spherical".parse::<Geometry>();
        assert!(refused.is_err_and(|e| e.to_string().contains("\"Spherical\"")));
    }

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
            assert_eq!(space.is_closed(), sphere);
            assert_eq!(space.limits().is_some(), sphere);
            assert_eq!(space.has_sky(), !sphere);
            assert_eq!(space.globe().is_some(), sphere);
            let own = space.view_modes()[0].dial();
            assert_eq!(own.is_some(), geometry == Geometry::Hyperbolic);
        }
    }
}
