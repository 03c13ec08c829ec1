//! What must hold of worlds on the disk.
#![allow(clippy::panic, clippy::unwrap_used, reason = "tests fail by panicking")]

mod common;
mod compatibility;
mod damage;
mod doubles;
mod forged_records;
mod repair_and_play;
mod transfer;
mod vanished;
mod worlds;
