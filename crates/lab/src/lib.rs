//! The laboratory: measures what the port's accuracy costs, and how it holds at the extremes.
//!
//! Every figure goes into a [`Report`], which is printed, written as JSON, shown as a web page and
//! turned into the tables of `docs/accuracy.md`. The textbook formulas that the game does not use
//! live here, and only here, as the baseline to compare with.

mod report;

pub use report::{Axis, Cell, Plot, Report, Scale, Section, Series, Table};

/// How thoroughly to measure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// Fewer inputs and shorter runs: all suites together stay under a minute.
    pub quick: bool,
}
