//! Scripts, which the console reads too: a list of orders, or a sentence that names the line.

use antipode::script::{COMMANDS, SETTINGS, parse};
use fastrand::Rng;

use super::{Seen, Target, must};
use crate::mutation::{change_text, some};

pub(super) const TARGET: Target = Target {
    name: "script",
    run,
    seeds,
    mutate,
};

const WORDS: &[&str] = &[
    "0",
    "-0",
    "-1",
    "1e308",
    "NaN",
    "inf",
    "-inf",
    "1e-400",
    "86400",
    "86401",
    "4294967296",
    "18446744073709551615",
    "0x10",
    "A",
    "B",
    "LEFT",
    "RIGHT",
    "KeyW",
    "Digit3",
    "ShiftLeft",
    "seed=",
    "name=",
    "radius=",
    "name=\"",
    "\"",
    "\"\"",
    "\\",
    "#",
    "\n",
    "\r",
    "\t",
    "\0",
    "\u{85}",
    "\u{202e}",
    "\u{feff}",
    "spherical",
    "euclidean",
    "gun",
    "lamp",
    "flag",
    "name-flag",
    "bot",
    "hostile",
    "x.png",
    "long-house",
    "box",
    "gravity=0,0,0",
    "size=1,1,1",
    "older",
    "versions",
    "at=0,1,-5",
    ".png",
    "on",
    "off",
    "still",
    "raised",
    "time",
    "field-of-view",
    "=",
    "==",
];

fn run(bytes: &[u8]) -> Result<Seen, String> {
    let text = String::from_utf8_lossy(bytes);
    let taken = match parse(&text) {
        Ok(lines) => {
            let most = text.lines().count();
            must(
                lines.iter().all(|line| (1..=most).contains(&line.number)),
                || "an order stands on a line that is none".to_owned(),
            )?;
            true
        }
        Err(mistake) => {
            let said = mistake.to_string();
            must(said.starts_with("line ") && said.len() < 2000, || {
                format!("the mistake is told as {said}")
            })?;
            false
        }
    };
    Ok(Seen {
        past_checksums: true,
        taken,
    })
}

fn seeds() -> Vec<(String, Vec<u8>)> {
    let every = "new spherical seed=12 name=\"Once round\" radius=24 # round\nload X\nsave\ndelete X\nlist\n\
                 hold KeyW 2\ndown KeyA\nup KeyA\ntap Digit4\nclick LEFT\npress RIGHT\nrelease RIGHT\nhold LEFT 1.5\n\
                 look 3 -4\naim -90 0\nscroll -2\nwait 0.5\nsettle\nsettle 9\nprobe\nshot hole.png\n\
                 give lamp 3\nteleport 1 2 3 B\nspawn car 1 2 3 A\n\
                 name-flag Home\nperf 2\nroom versions\nroom older 2\nquit\n";
    let settings = SETTINGS
        .iter()
        .map(|(name, words)| format!("set {name} {}\n", words.first().unwrap_or(&"1")));
    let usage = COMMANDS
        .iter()
        .map(|command| format!("{} {}\n", command.name, command.usage));
    [
        ("every", every.to_owned()),
        ("settings", settings.collect()),
        ("usage", usage.collect()),
    ]
    .map(|(name, text)| (name.to_owned(), text.into_bytes()))
    .into()
}

fn mutate(rng: &mut Rng, seed: &[u8]) -> Vec<u8> {
    let mut text = seed.to_vec();
    // A script ends at its first mistake, so most have few lines.
    let lines: Vec<_> = seed.split(|byte| *byte == b'\n').collect();
    if rng.u8(..4) > 0 {
        let chosen = (0..=rng.usize(..3)).map(|_| lines[rng.usize(..lines.len())]);
        text = chosen.collect::<Vec<_>>().join(&b'\n');
    }
    for _ in 0..some(rng) {
        change_text(rng, &mut text, WORDS);
    }
    text
}
