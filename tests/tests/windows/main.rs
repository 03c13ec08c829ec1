//! The game in its window. These tests are a program of their own, and the only one with windows: there is one
//! keyboard on a display, and tests take turns with it within their program.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "tests fail by panicking"
)]

mod endings;
mod graphics;
mod walk;
mod window;
