//! Which space a world is in, and through which map it is seen.

use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Serialize};

/// The three spaces of constant curvature.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Geometry {
    /// Flat space, curvature 0.
    Euclidean,
    /// Hyperbolic space, curvature -1/R^2.
    Hyperbolic,
    /// The three-sphere, curvature +1/R^2.
    Spherical,
}

impl Geometry {
    /// All three, in menu order.
    pub const ALL: [Self; 3] = [Self::Euclidean, Self::Hyperbolic, Self::Spherical];

    /// The sign of the curvature: 0, -1 or +1.
    pub fn sign(self) -> f64 {
        match self {
            Self::Euclidean => 0.0,
            Self::Hyperbolic => -1.0,
            Self::Spherical => 1.0,
        }
    }

    /// The lower-case name, as in saves and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Euclidean => "euclidean",
            Self::Hyperbolic => "hyperbolic",
            Self::Spherical => "spherical",
        }
    }
}

impl fmt::Display for Geometry {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// A word that names none of the three spaces.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("\"{0}\" is no geometry; choose euclidean, hyperbolic or spherical")]
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
#[error("\"{0}\" is no hyperbolic map; choose raised or horizon")]
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

    #[test]
    fn names_read_back_and_others_are_refused() {
        for geometry in Geometry::ALL {
            assert_eq!(geometry.to_string().parse(), Ok(geometry));
        }
        let refused = "Spherical".parse::<Geometry>();
        assert!(refused.is_err_and(|e| e.to_string().contains("\"Spherical\"")));
    }
}
