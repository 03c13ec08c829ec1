//! What must hold of deformed space and of what travels through it.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "tests fail by panicking"
)]

mod balls;
mod bodies;
mod checks;
mod common;
mod faces;
mod hierarchy;
mod light;
mod paths;
mod walkers;
mod wild;
