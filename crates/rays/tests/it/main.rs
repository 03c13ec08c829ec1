//! What must hold of pictures of deformed rooms, and of their rays.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "tests fail by panicking"
)]

mod agreement;
mod common;
mod lamps;
mod movers;
mod pictures;
mod portals;
mod prepared;
mod raster;
mod shaders;
mod surfaces;
mod views;
