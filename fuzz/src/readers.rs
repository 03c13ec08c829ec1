//! The targets of the crate `antipode-fuzzing` as one of cargo-fuzz.
#![cfg_attr(feature = "libfuzzer", no_main)]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| antipode_fuzzing::must_hold(bytes));

/// Without libFuzzer there is nothing to run.
#[cfg(not(feature = "libfuzzer"))]
fn main() {}
