//! What an object or a room is, in the `key=value` words of commands: the way back from [`crate::words`].
//!
//! Numbers have the shortest digits that are read as the same number, so nothing is lost on the way.

use glam::{DVec2, DVec3};

use crate::aberration::{Aberration, Axis, Exit, Lengths, Sides, Ways};
use crate::portal::{Opening, Portal};
use crate::room::{Finish, Object, Surface, What};

/// A key and its value, as in `size=1,2,3`.
pub type Word = (&'static str, String);

/// Words that make an object again, for `add` with the kind [`What::kind`]: each key once, and none that is as nothing is
/// said of it.
pub fn words_of(object: &Object) -> Vec<Word> {
    // By its parts, so that a field that is new cannot be forgotten here.
    let Object {
        name,
        at,
        turn,
        what,
        surface,
        group,
        mass,
    } = object;
    let mut words = vec![("name", name.clone())];
    if *at != DVec3::ZERO {
        words.push(("at", three(*at)));
    }
    if *turn != DVec3::ZERO {
        words.push(("turn", three(*turn)));
    }
    if let Some(group) = group {
        words.push(("group", group.clone()));
    }
    if let Some(mass) = mass {
        words.push(("mass", number(*mass)));
    }
    of_kind(what, &mut words);
    of_surface(surface, &mut words);
    words
}

fn of_kind(what: &What, words: &mut Vec<Word>) {
    let mut say = |key, value| words.push((key, value));
    match what {
        What::Box { size } | What::Pyramid { size } | What::Ramp { size } => {
            say("size", three(*size));
        }
        What::Cylinder { radius, height } => {
            say("radius", number(*radius));
            say("height", number(*height));
        }
        What::Ball { radius } => say("radius", number(*radius)),
        What::Stairs { size, steps } => {
            say("size", three(*size));
            say("steps", steps.to_string());
        }
        What::Arch { size, opening } => {
            say("size", three(*size));
            say("opening", two(*opening));
        }
        What::Model { file, scale } => {
            say("file", file.clone());
            say("scale", number(*scale));
        }
        What::Light { colour, power } => {
            say("colour", colour.to_string());
            say("power", number(*power));
        }
        What::Aberration(it) => of_aberration(it, words),
        What::Portal(it) => of_portal(it, words),
        What::Sign { text, size } => {
            if let Some(text) = text {
                say("text", text.clone());
            }
            say("size", two(*size));
        }
        What::Group => {}
    }
}

fn of_aberration(it: &Aberration, words: &mut Vec<Word>) {
    words.push(("half", three(it.half)));
    match it.lengths {
        Lengths::Felt { axis, felt_m } => {
            let axis = match axis {
                Axis::X => "x",
                Axis::Y => "y",
                Axis::Z => "z",
            };
            words.push(("axis", axis.to_owned()));
            words.push(("felt", number(felt_m)));
        }
        Lengths::Stretch(stretch) => words.push(("stretch", three(stretch))),
    }
    let (sides, exit) = match it.sides {
        Sides::Walls => ("walls", None),
        Sides::Soft => ("soft", None),
        Sides::Snell => ("snell", None),
        Sides::Legacy { exit } => ("legacy", Some(exit)),
    };
    words.push(("sides", sides.to_owned()));
    if let Some(exit) = exit {
        let exit = match exit {
            Exit::Original => "original",
            Exit::Inverse => "inverse",
            Exit::Nothing => "none",
        };
        words.push(("exit", exit.to_owned()));
    }
    if it.ways == Ways::Forward {
        words.push(("ways", "forward".to_owned()));
    }
    if it.outline {
        words.push(("outline", "on".to_owned()));
    }
}

fn of_portal(it: &Portal, words: &mut Vec<Word>) {
    match &it.opening {
        Opening::Size(size) => words.push(("size", two(*size))),
        Opening::Polygon(corners) => {
            let corners: Vec<_> = corners.iter().map(|it| two(*it)).collect();
            words.push(("polygon", corners.join(",")));
        }
    }
    words.push(("to", it.to.clone()));
    if it.sides != 1 {
        words.push(("sides", it.sides.to_string()));
    }
}

fn of_surface(it: &Surface, words: &mut Vec<Word>) {
    let Surface {
        colour,
        checker,
        texture,
        glow,
        finish,
    } = it;
    // A light has no surface, and its own colour is told already.
    let is_told = words.iter().any(|(key, _)| *key == "colour");
    if *colour != Surface::default().colour && !is_told {
        words.push(("colour", colour.to_string()));
    }
    if let Some(checker) = checker {
        let size = number(checker.size);
        words.push(("checker", format!("{},{size}", checker.colour)));
    }
    if let Some(texture) = texture {
        let size = number(texture.size);
        words.push(("texture", format!("{},{size}", texture.file)));
    }
    if *glow != 0.0 {
        words.push(("glow", number(*glow)));
    }
    let finish = match finish {
        Finish::Matt => return,
        Finish::Mirror => "mirror",
        Finish::Glass => "glass",
    };
    words.push(("finish", finish.to_owned()));
}

/// A number as a word; 0 has no sign.
pub fn number(value: f64) -> String {
    format!("{}", value + 0.0)
}

/// Two numbers as a word: `X,Y`.
pub fn two(it: DVec2) -> String {
    format!("{},{}", number(it.x), number(it.y))
}

/// Three numbers as a word: `X,Y,Z`.
pub fn three(it: DVec3) -> String {
    // 0 has no sign here, either.
    let it = it + 0.0;
    format!("{},{},{}", it.x, it.y, it.z)
}
