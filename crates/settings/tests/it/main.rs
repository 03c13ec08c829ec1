//! What must hold of the settings and their file.
#![allow(clippy::panic, clippy::unwrap_used, reason = "tests fail by panicking")]

mod file;
mod properties;
