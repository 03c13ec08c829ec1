//! What must hold of walking, driving and flying on any ground.
#![allow(
    clippy::expect_used,
    clippy::panic,
    clippy::unwrap_used,
    reason = "tests fail by panicking"
)]

mod air;
mod charts;
mod common;
mod doors;
mod equator;
mod lengths;
mod sphere;
mod tipping;
mod vehicle;
mod walking;
mod wander;
mod world;
