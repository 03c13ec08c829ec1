//! The hyperbolic world: hyperbolic space over a plane in squares, five about every corner, each square a chart.
//!
//! A chart is made when somebody comes to it: its number is that of its tile ([`crate::tiling::TilePath::number`]), so
//! that there are `2^128` of them and none is ever stored. What leads from chart to chart is exact until it is cast.
//! docs/geometry.md says what is missing for a world, and why the charts are what they are.

mod cache;
mod chart;
mod near;
mod optics;
mod plan;
mod tiles;
mod world;

use std::ops::RangeInclusive;
use std::sync::Arc;

use crate::kind::{Entry, Radii};

pub use world::HyperbolicWorld;

/// Radii that a player may choose, metres: tiles of 1 to 4 chunks at their middle, to whichever the nearest is. In smaller ones a
/// chart would be written less far past its edges than ground and things near them need.
const RADII_M: RangeInclusive<f64> = 30.0..=121.0;

pub(crate) static ENTRY: Entry = Entry {
    name: "hyperbolic-world",
    radii: Radii {
        default_m: HyperbolicWorld::RADII_M[1],
        chosen_m: Some(RADII_M),
        saved_m: Some(RADII_M),
    },
    make: |radius_m| Arc::new(HyperbolicWorld::new(radius_m)),
};
