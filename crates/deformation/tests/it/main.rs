//! What must hold of deformed space and of what travels through it.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "tests fail by panicking"
)]

mod bodies;
mod checks;
mod common;
mod faces;
mod hierarchy;
mod light;
mod paths;
mod portal_bodies;
mod portal_checks;
mod portal_light;
mod portals;
mod walkers;
mod wild;
