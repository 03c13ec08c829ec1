//! What must hold of models: those of the game, and those of strangers.
#![allow(
    clippy::expect_used,
    clippy::panic,
    clippy::unwrap_used,
    reason = "tests fail by panicking"
)]

mod assets;
mod common;
mod poses;
mod refusals;
