//! Whether the golden files are those of the script beside them.

use super::golden::{FUNCTIONS, KERNELS, STRATEGIES};

const SCRIPT: &[u8] = include_bytes!("../../../../../tests/reference/make_golden.py");

/// FNV-1a, 64 bits.
fn fnv(bytes: &[u8]) -> String {
    let hash = bytes.iter().fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
        (hash ^ u64::from(*byte)).wrapping_mul(0x100_0000_01b3)
    });
    format!("{hash:016x}")
}

fn between<'a>(text: &'a str, start: &str, end: &str) -> &'a str {
    let from = text.find(start).expect("the field is there") + start.len();
    let rest = &text[from..];
    &rest[..rest.rfind(end).expect("the field ends")]
}

fn field<'a>(text: &'a str, name: &str) -> &'a str {
    let rest = between(text, &format!("\"{name}\": \""), "}");
    &rest[..rest.find('"').unwrap()]
}

#[test]
fn the_golden_files_are_the_scripts_own() {
    for (name, text) in [
        ("functions.json", FUNCTIONS),
        ("kernels.json", KERNELS),
        ("strategies.json", STRATEGIES),
    ] {
        let stale = "run tests/reference/make_golden.py again";
        assert_eq!(field(text, "generator"), fnv(SCRIPT), "{name}: {stale}");
        let data = between(text, "\"data\": ", "\n}\n");
        assert_eq!(
            field(text, "content"),
            fnv(data.as_bytes()),
            "{name}: {stale}"
        );
    }
}
