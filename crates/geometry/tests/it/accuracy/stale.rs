//! Whether the golden files are those of the scripts beside them.

use super::golden::{FUNCTIONS, KERNELS, STRATEGIES, TILING};

const SCRIPT: &[u8] = include_bytes!("../../../../../tests/reference/make_golden.py");
const TILING_SCRIPT: &[u8] = include_bytes!("../../../../../tests/reference/make_tiling.py");

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
    for (name, text, script) in [
        ("functions.json", FUNCTIONS, SCRIPT),
        ("kernels.json", KERNELS, SCRIPT),
        ("strategies.json", STRATEGIES, SCRIPT),
        ("tiling.json", TILING, TILING_SCRIPT),
    ] {
        let stale = "run the script of tests/reference that makes it again";
        assert_eq!(field(text, "generator"), fnv(script), "{name}: {stale}");
        let data = between(text, "\"data\": ", "\n}\n");
        assert_eq!(
            field(text, "content"),
            fnv(data.as_bytes()),
            "{name}: {stale}"
        );
    }
}
