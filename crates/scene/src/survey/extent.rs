//! How much of the land a map shows, and how finely.

use antipode_geometry::Strategy;

use crate::bearings::on_map_m;

/// How far maps show land, metres of the space: the one on the display and the large one.
const NEAR_M: f64 = 45.0;
const WIDE_M: f64 = 150.0;
/// The large map takes one column of so many both ways.
const WIDE_STEP: i32 = 2;
/// In squares there is so much land far off that the large map shows no more of it than within so many radii, and no edges
/// of squares beyond so many.
const WIDE_RAD: f64 = 2.2;
const EDGES_RAD: f64 = 4.0;
/// Share of the way to the equator and back that a map of a closed world reaches at most.
const CLOSED_SHARE: f64 = 0.8;

/// How much of the land a map shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Extent {
    /// What is about the player, as on the display.
    #[default]
    Near,
    /// All that a large map has room for; in squares all of the plane, as a conformal disc.
    Wide,
}

impl Extent {
    /// One column of so many is taken, both ways.
    pub(super) fn step(self) -> i32 {
        match self {
            Self::Near => 1,
            Self::Wide => WIDE_STEP,
        }
    }

    /// How far land is shown, metres of the level; in a small closed world less, so that nothing is shown twice.
    pub(super) fn land_m(self, strategy: &dyn Strategy) -> f64 {
        // Half way round lies what is on the other side of the world.
        let farthest_m = strategy
            .globe()
            .map_or(f64::INFINITY, |globe| 0.5 * globe.round_m());
        let most_m = match self {
            Self::Near => NEAR_M,
            Self::Wide if strategy.tiled().is_some() => WIDE_M.min(WIDE_RAD * strategy.radius_m()),
            Self::Wide => WIDE_M,
        };
        most_m.min(farthest_m * CLOSED_SHARE)
    }

    /// How far the map reaches, in its own metres.
    pub(super) fn reach_m(self, strategy: &dyn Strategy) -> f64 {
        match self {
            Self::Wide if strategy.tiled().is_some() => on_map_m(strategy, f64::INFINITY),
            _ => on_map_m(strategy, self.land_m(strategy)),
        }
    }

    /// How far edges of squares are shown, metres of the level.
    pub(super) fn edges_m(self, strategy: &dyn Strategy) -> f64 {
        match self {
            Self::Near => self.land_m(strategy),
            Self::Wide => EDGES_RAD * strategy.radius_m(),
        }
    }
}
