//! What the fuzz targets, the replay of their finds and the attacks on saves have in
//! common: one list of everything that reads bytes of others, what each must keep, and
//! what makes such bytes.
//!
//! A [`Target`] is used by `fuzz/` (cargo-fuzz, nightly), by the tests here (stable:
//! the corpus and every find replayed, and a seeded campaign) and by the program
//! `antipode-fuzzing`, which runs long campaigns and makes the corpus anew.

pub mod attacks;
pub mod campaign;
pub mod forge;
mod mutation;
pub mod place;
pub mod targets;
pub mod watch;

pub use targets::{Seen, TARGETS, Target, target};

/// Runs a target as a fuzzer wants it.
///
/// # Panics
/// When what must hold for any input does not: that is how a fuzzer is told.
pub fn must_hold(name: &str, bytes: &[u8]) {
    let held = target(name).map(|target| (target.run)(bytes));
    assert!(matches!(held, Some(Ok(_))), "{name}: {held:?}");
}
