//! The kinds of things that commands can add, and what each is before anything is said of it.

use glam::{DVec2, DVec3};

use crate::aberration::{Aberration, Lengths, Sides, Ways};
use crate::colour::Colour;
use crate::portal::Portal;
use crate::room::{What, board};

/// Every kind that can be added.
pub const KINDS: [&str; 14] = [
    "box",
    "pyramid",
    "ramp",
    "cylinder",
    "ball",
    "stairs",
    "arch",
    "model",
    "light",
    "aberration",
    "portal",
    "sign",
    "group",
    "spawn",
];

/// What each kind is to be told, besides its name; the kind as yet without it.
pub(crate) fn kind(word: &str) -> Option<(What, &'static [&'static str])> {
    let size = DVec3::ONE;
    let aberration = Aberration {
        half: DVec3::ONE,
        lengths: Lengths::Stretch(DVec3::ONE),
        sides: Sides::Walls,
        ways: Ways::Both,
        outline: false,
    };
    Some(match word {
        "box" => (What::Box { size }, &["size"]),
        "pyramid" => (What::Pyramid { size }, &["size"]),
        "ramp" => (What::Ramp { size }, &["size"]),
        "cylinder" => (
            What::Cylinder {
                radius: 1.0,
                height: 1.0,
            },
            &["radius", "height"],
        ),
        "ball" => (What::Ball { radius: 1.0 }, &["radius"]),
        "stairs" => (What::Stairs { size, steps: 1 }, &["size", "steps"]),
        "arch" => (
            What::Arch {
                size,
                opening: DVec2::splat(0.5),
            },
            &["size", "opening"],
        ),
        "model" => (
            What::Model {
                file: String::new(),
                scale: 1.0,
            },
            &["file"],
        ),
        "light" => (
            What::Light {
                colour: Colour::WHITE,
                power: 1.0,
            },
            &["power"],
        ),
        "aberration" => (What::Aberration(aberration), &["half"]),
        "portal" => (What::Portal(Portal::new()), &["to"]),
        "sign" => (
            What::Sign {
                text: None,
                size: board(),
            },
            &[],
        ),
        "group" => (What::Group, &[]),
        _ => return None,
    })
}
