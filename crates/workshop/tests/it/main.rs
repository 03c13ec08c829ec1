//! What is asked of the document of a room editor.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    missing_docs,
    reason = "tests fail by panicking"
)]

mod checks;
mod commands;
mod editing;
mod keeping;
mod killed;
mod large;
mod there_and_back;
mod wide;
