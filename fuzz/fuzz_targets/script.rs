//! The target `script` of the crate `antipode-fuzzing`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| antipode_fuzzing::must_hold("script", bytes));
