//! Tests of the crate from outside.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]

mod corners;
mod placement;
mod undergrowth;
