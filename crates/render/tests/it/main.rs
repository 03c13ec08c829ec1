//! What must hold of pictures.
#![allow(
    clippy::expect_used,
    clippy::panic,
    clippy::unwrap_used,
    reason = "tests fail by panicking"
)]

mod bushes;
mod common;
mod culling;
mod dark_lines;
mod digging;
mod dust;
mod figures;
mod lamps;
mod levels;
mod lost;
mod openings;
mod outlines;
mod overhead;
mod pictures;
mod plan;
mod rigid;
mod shadow_cut;
mod shadows;
mod sky;
mod spaces;
mod squares;
mod squares_shadows;
mod sun_rays;
mod tiles;
mod views;
