//! The text of a room: whatever it says, it is refused in one line, or what was understood is written and read as the
//! same.

use antipode_rooms::mesh::{Roundness, meshes};
use antipode_rooms::{Assets, read, shipped, write};
use fastrand::Rng;

use super::settings::change_value;
use super::{Seen, Target, must};
use crate::mutation::{change_text, some};

pub(super) const TARGET: Target = Target {
    name: "room",
    run,
    seeds,
    mutate,
};

/// How many objects of a room of the game a seed has.
const MOST_OBJECTS: usize = 20;
const WORDS: &[&str] = &[
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    ",",
    ":",
    "0",
    "-1",
    "1e308",
    "NaN",
    "-inf",
    "0.01",
    "1000",
    "\"\"",
    "\"floor\"",
    "\"\\u{202e}\"",
    "'a'",
    "r#\"",
    "\"#",
    "/*",
    "*/",
    "//",
    "\n",
    "None",
    "Some(",
    "#![enable(implicit_some)]",
    "version: 2",
    "name: \"a\"",
    "group: \"a\"",
    "what: Group",
    "what: Box(size: (1, 1, 1))",
    "Ball(radius: 1)",
    "Stairs(size: (1, 1, 1), steps: 200)",
    "Arch(size: (1, 1, 1), opening: (0.5, 0.5))",
    "Model(file: \"models/a.glb\")",
    "Light(power: 1)",
    "Sign()",
    "Aberration(half: (1, 1, 1), axis: X, felt: 4)",
    "Aberration(half: (9, 9, 9), stretch: (2, 1, 32), sides: Soft)",
    "sides: Legacy(exit: Nothing)",
    "ways: Forward",
    "outline: true",
    "Model(file: \"models/a.fbx\")",
    "Model(file: \"models/a.obj\")",
    "turn: (45, 0, 0)",
    "surface: (glow: 1)",
    "texture: (file: \"textures/../a.png\")",
    "finish: Mirror",
];

fn run(bytes: &[u8]) -> Result<Seen, String> {
    let seen = |taken| Seen {
        past_checksums: true,
        taken,
    };
    let room = match read("room.ron", bytes) {
        Ok(room) => room,
        Err(error) => {
            let said = error.to_string();
            must(said.len() < 2000 && !said.contains('\n'), || {
                format!("a refusal is no line: {said:.300}")
            })?;
            must(said.starts_with("room.ron:"), || {
                format!("a refusal has no line: {said:.300}")
            })?;
            return Ok(seen(false));
        }
    };
    let text = write(&room).map_err(|fault| format!("what was read is not written: {fault}"))?;
    let again = read("again", text.as_bytes())
        .map_err(|error| format!("its own file is not understood: {error}"))?;
    must(again == room, || {
        "what was written is read as something else".to_owned()
    })?;
    let once_more = write(&again).map_err(|fault| fault.to_string())?;
    must(once_more == text, || "it is written in two ways".to_owned())?;
    for mesh in meshes(&room, &Assets::default(), Roundness { around: 12 }) {
        let corners = mesh.shape.positions.iter().chain(&mesh.shape.normals);
        must(corners.into_iter().all(|it| it.is_finite()), || {
            "a corner is no place".to_owned()
        })?;
    }
    Ok(seen(true))
}

fn seeds() -> Vec<(String, Vec<u8>)> {
    // Long ones take long and break nothing that short ones do not.
    let short = |text: &str| {
        let objects = text.split_inclusive("\n        ),\n").take(MOST_OBJECTS);
        objects.chain(["    ],\n)\n"]).collect::<String>()
    };
    let mut seeds: Vec<_> = shipped::ROOMS
        .iter()
        .map(|it| (it.id.to_owned(), short(it.text).into_bytes()))
        .collect();
    let every: Vec<String> = WORDS
        .iter()
        .filter(|word| word.ends_with(')') && word.starts_with(|it: char| it.is_ascii_uppercase()))
        .enumerate()
        .map(|(index, word)| {
            format!(
                "(name: \"{index}\", at: ({}, 0, 0), what: {word}),\n",
                40 * index
            )
        })
        .collect();
    let every = format!(
        "(version: 1, name: \"every\", fog: (colour: \"#ffffff\", reach: 9), objects: [\n{}])",
        every.concat()
    );
    seeds.push(("every".to_owned(), every.into_bytes()));
    seeds
}

fn mutate(rng: &mut Rng, seed: &[u8]) -> Vec<u8> {
    let mut text = seed.to_vec();
    let values = rng.bool();
    for _ in 0..some(rng) {
        if values {
            change_value(rng, &mut text);
        } else {
            change_text(rng, &mut text, WORDS);
        }
    }
    text
}
