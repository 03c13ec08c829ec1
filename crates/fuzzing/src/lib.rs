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
pub mod targets;
pub mod watch;
pub mod world_folder;

use std::sync::LazyLock;

pub use targets::{Seen, TARGETS, Target, target};

/// Says which target is to be fuzzed.
const CHOICE: &str = "ANTIPODE_FUZZ_TARGET";

/// Runs the target that `ANTIPODE_FUZZ_TARGET` names, as a fuzzer wants it.
///
/// # Panics
/// When what must hold for any input does not: that is how a fuzzer is told. And where no target is named.
#[expect(clippy::panic, reason = "a fuzzer is told by panics")]
pub fn must_hold(bytes: &[u8]) {
    static CHOSEN: LazyLock<Option<&Target>> =
        LazyLock::new(|| std::env::var(CHOICE).ok().and_then(|name| target(&name)));
    let Some(target) = *CHOSEN else {
        let names: Vec<_> = TARGETS.iter().map(|target| target.name).collect();
        panic!("{CHOICE} is to be one of {}", names.join(", "));
    };
    let held = (target.run)(bytes);
    assert!(held.is_ok(), "{}: {held:?}", target.name);
}
