//! The file of settings: whatever it says, what was understood of it is written and
//! read again as the same.

use antipode_settings::{Condition, Config, actions, fields, read, write};
use fastrand::Rng;

use super::{Seen, Target, must};
use crate::mutation::{change_text, some};

pub(super) const TARGET: Target = Target {
    name: "settings",
    run,
    seeds,
    mutate,
};

const WORDS: &[&str] = &[
    "true",
    "false",
    "0",
    "-1",
    "1e308",
    "-1e-308",
    "NaN",
    "inf",
    "-inf",
    "1e999",
    "4294967296",
    "18446744073709551616",
    "\"\"",
    "\"\\u{0}\"",
    "\"\u{202e}\"",
    "[]",
    "[",
    "]",
    "(",
    ")",
    "{",
    "}",
    ":",
    ",",
    "((",
    "[[",
    "{{",
    "Some(",
    "schema: 0",
    "schema: 2",
    "schema: 1.5",
    "profile: \"\"",
    "/*",
    "*/",
    "//",
    "'a'",
    "r#\"",
    "\"#",
    "b\"",
    "0x",
    "1_0",
    "\u{feff}",
    "\"KeyW\"",
    "\"WheelUp\"",
    "\"PadSouth\"",
    "keys",
    "learnt",
    "name",
    "settings",
    "profiles",
    "()",
    "\n",
    "#![enable(implicit_some)]",
];

/// What a value can be.
const VALUES: &[&str] = &[
    "true",
    "false",
    "0",
    "-0.0",
    "1e308",
    "NaN",
    "inf",
    "-inf",
    "\"\"",
    "[]",
    "{}",
    "()",
    "(a: 1)",
    "{\"a\": 1}",
    "Some(1)",
    "\"en\"",
    "\"zh\"",
    "\"fast\"",
    "\"exact\"",
    "\"raised\"",
    "\"KeyW\", \"KeyA\", \"KeyS\", \"KeyD\", \"Digit1\"",
    "\"WheelUp\"",
    "'x'",
    "18446744073709551616",
    "b\"a\"",
    "[[[[]]]]",
];

fn run(bytes: &[u8]) -> Result<Seen, String> {
    let reading = read(bytes);
    for notice in &reading.notices {
        let said = notice.to_string();
        must(said.len() < 2000, || {
            format!("a notice has {} bytes", said.len())
        })?;
    }
    let seen = Seen {
        past_checksums: true,
        taken: reading.condition != Condition::Damaged,
    };
    if reading.config == Config::default() {
        return Ok(seen);
    }
    let text = write(&reading.config)?;
    let again = read(text.as_bytes());
    must(
        again.condition == Condition::Sound && again.notices.is_empty(),
        || {
            format!(
                "its own file is not understood: {:?} {:?}",
                again.condition, again.notices
            )
        },
    )?;
    must(again.config == reading.config, || {
        "what was written is read as something else".to_owned()
    })?;
    Ok(seen)
}

fn seeds() -> Vec<(String, Vec<u8>)> {
    let written = write(&Config::default()).unwrap_or_default();
    let by_hand = fields()
        .iter()
        .map(|field| format!("{}: true,\n", field.id.replace('-', "_")));
    let by_hand = format!("({})", by_hand.collect::<String>());
    let keys = actions()
        .iter()
        .map(|info| format!("\"{}\": [\"KeyW\", \"LEFT\"],\n", info.id));
    let keys = format!(
        "(schema: 1, profile: \"B\", profiles: [(name: \"B\", keys: {{{}}})])",
        keys.collect::<String>()
    );
    let newer = "(schema: 7, settings: {\"field-of-view\": 90, \"from-the-future\": [1, (2)]}, learnt: [\"dig\"])";
    [
        ("written", written),
        ("by-hand", by_hand),
        ("keys", keys),
        ("newer", newer.to_owned()),
    ]
    .map(|(name, text)| (name.to_owned(), text.into_bytes()))
    .into()
}

fn mutate(rng: &mut Rng, seed: &[u8]) -> Vec<u8> {
    let mut text = seed.to_vec();
    if rng.bool() {
        // Values alone, so that the file stays one.
        for _ in 0..some(rng) {
            change_value(rng, &mut text);
        }
        return text;
    }
    for _ in 0..some(rng) {
        change_text(rng, &mut text, WORDS);
    }
    text
}

/// Puts something else in the place of what stands behind a colon.
pub(super) fn change_value(rng: &mut Rng, text: &mut Vec<u8>) {
    let colons: Vec<usize> = (0..text.len()).filter(|at| text[*at] == b':').collect();
    let Some(colon) = rng.choice(colons) else {
        return;
    };
    let value = &text[colon + 1..];
    let end = value
        .iter()
        .position(|byte| b",)}\n".contains(byte))
        .unwrap_or(value.len());
    let new: String = match rng.u8(..5) {
        0 => format!("{}", rng.i32(-300..300)),
        1 => format!("{:?}", (rng.f64() - 0.5) * 10_f64.powi(rng.i32(-320..320))),
        2 => format!(
            "{:?}",
            rng.alphanumeric().to_string().repeat(rng.usize(..70))
        ),
        3 => format!("[{}]", VALUES[rng.usize(..VALUES.len())]),
        _ => VALUES[rng.usize(..VALUES.len())].to_owned(),
    };
    text.splice(colon + 1..colon + 1 + end, new.into_bytes());
}
