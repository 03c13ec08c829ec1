//! Fuzz targets for all code of the game that reads foreign bytes, and attacks on saves.
//!
//! A [`Target`] reads an input, checks what must hold for every input, and can make and mutate inputs. Three programs
//! use the list of targets: `fuzz/` (cargo-fuzz, nightly), the tests of this crate (stable; they replay the corpus and
//! every find, and run a seeded campaign), and `antipode-fuzzing`, which runs long campaigns and makes the corpus anew.

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
