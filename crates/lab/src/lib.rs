//! The laboratory: measures the accuracy of the port at the extremes, its cost, and the speed of the terrain.
//!
//! A [`Report`] holds every measured value. It can be printed, written as JSON, shown as a web page, and turned into
//! the tables of `docs/accuracy.md` and `docs/terrain.md`. The textbook formulas that the game does not use are here,
//! and only here, as the baseline for comparisons.

pub mod accuracy;
pub mod compute;
pub mod docs;
pub mod double_double;
mod error;
mod figure;
mod files;
pub mod gpu;
pub mod html;
mod json;
mod machine;
pub mod markdown;
pub mod naive;
pub mod peer;
mod random;
mod report;
mod scene_frame;
pub mod single;
pub mod speed;
pub mod svg;
pub mod terrain;
pub mod text;

use antipode_geometry::Geometry;

pub use error::LabError;
pub use machine::made_on;
pub use report::{Axis, Cell, Picture, Plot, Report, Scale, Section, Series, Table};

/// The spaces that the tables compare, in the order of their frames. The lands compared are of one kind, of which worlds in
/// tiles have none.
const SPACES: [Geometry; 3] = [
    Geometry::Euclidean,
    Geometry::Hyperbolic,
    Geometry::Spherical,
];

/// How thoroughly to measure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// Fewer inputs and shorter runs: all suites together stay under a minute.
    pub quick: bool,
}

impl Effort {
    /// A count that is divided by ten in a quick run.
    pub fn count(self, full: usize) -> usize {
        if self.quick { full.div_ceil(10) } else { full }
    }
}
