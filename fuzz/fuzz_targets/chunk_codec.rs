//! The target `chunk_codec` of the crate `antipode-fuzzing`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| antipode_fuzzing::must_hold("chunk_codec", bytes));
