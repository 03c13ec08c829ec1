//! What must hold of the words of the game.
#![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

mod common;
mod keys;
mod locales;
mod tokens;
