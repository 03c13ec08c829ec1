//! What must hold of fields, edits, meshes and their levels.
#![allow(
    clippy::expect_used,
    clippy::panic,
    clippy::unwrap_used,
    reason = "tests fail by panicking"
)]

mod caves;
mod climates;
mod common;
mod cone;
mod detail;
mod edits;
mod field;
mod golden;
mod kinds;
mod levels;
mod mesh;
mod seams;
mod tiled;
mod tiles;
