//! The published medians that are known here.

use super::halfplane::HalfPlane;
use super::linear::{COLUMNS, Linear};
use super::model::Model;
use super::number::Number;
use super::suite::Test;

/// A median of Celińska-Kopczyńska and Kopczyński, "Numerical Aspects of Hyperbolic Geometry",
/// arXiv 2404.09039, and the row of ours it belongs beside.
#[derive(Clone, Copy, Debug)]
pub struct Published {
    /// The representation's name in our tables.
    pub subject: &'static str,
    /// Its precision.
    pub precision: &'static str,
    /// The test.
    pub test: Test,
    /// The median, in the test's unit.
    pub median: u32,
}

impl Published {
    /// Whether it lies between ours at the two tolerances, give or take one tile or radius, which
    /// is a factor of about seven in the error, or one step in twenty of a walk, which is a factor
    /// of three to seven.
    pub fn is_between(self, tight: u32, loose: u32) -> bool {
        let allowance = if self.test == Test::Walk {
            self.median / 20
        } else {
            1
        };
        (tight.saturating_sub(allowance)..=loose + allowance).contains(&self.median)
    }
}

const SINGLE: &str = <f32 as Number>::NAME;
const DOUBLE: &str = <f64 as Number>::NAME;
const LINEAR: &str = <Linear<f64, COLUMNS> as Model>::NAME;
const HALF_PLANE: &str = <HalfPlane<f64> as Model>::NAME;

/// The medians. Those of the best double representations are read as `loop_iso` and `similarity`,
/// in the order in which the linear ones are given.
pub const MEDIANS: [Published; 8] = [
    published(LINEAR, SINGLE, Test::LoopIso, 6),
    published(LINEAR, SINGLE, Test::Similarity, 7),
    published(LINEAR, SINGLE, Test::Walk, 297),
    published(LINEAR, DOUBLE, Test::LoopIso, 17),
    published(LINEAR, DOUBLE, Test::Similarity, 17),
    published(LINEAR, DOUBLE, Test::Walk, 615),
    published(HALF_PLANE, DOUBLE, Test::LoopIso, 35),
    published(HALF_PLANE, DOUBLE, Test::Similarity, 36),
];

const fn published(
    subject: &'static str,
    precision: &'static str,
    test: Test,
    median: u32,
) -> Published {
    Published {
        subject,
        precision,
        test,
        median,
    }
}
