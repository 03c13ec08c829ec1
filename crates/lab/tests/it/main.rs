//! What must hold of the laboratory: what it compares, measures and reports.
#![allow(
    clippy::expect_used,
    clippy::panic,
    clippy::unwrap_used,
    reason = "tests fail by panicking"
)]

mod accuracy;
mod docs;
mod double_double;
mod gpu;
mod peer;
mod report;
mod speed;
