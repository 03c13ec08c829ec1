//! What must hold of the mathematics of curved spaces.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "tests fail by panicking"
)]

mod accuracy;
mod hyperbolic_world;
mod space;
mod tiling;
