//! What must hold of readers of others' bytes.
#![allow(clippy::panic, clippy::unwrap_used, reason = "tests fail by panicking")]

mod campaign;
mod replay;
