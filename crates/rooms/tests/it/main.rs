//! What is asked of rooms: their file, their folder, the directory of them, and those that come with the game.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    missing_docs,
    reason = "tests fail by panicking"
)]

mod fbx;
mod folder;
mod import;
mod library;
mod mesh;
mod portals;
mod round_trip;
mod shipped;
mod space;
mod thesis;
mod unsound;
