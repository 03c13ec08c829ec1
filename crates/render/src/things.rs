//! Lamps, bullets and what can be carried, put together from rounded solids.
//!
//! x is ahead, y up from the foot, z to the right; metres.

use glam::Vec3;

use crate::solids::{Part, Solid};

const BRASS: [u8; 4] = [196, 150, 70, 120];
const STEEL: [u8; 4] = [150, 158, 170, 110];
const DARK: [u8; 4] = [58, 64, 76, 40];
const ORANGE: [u8; 4] = [244, 118, 26, 40];
const COPPER: [u8; 4] = [198, 112, 66, 140];
const GLASS: [u8; 4] = [255, 226, 166, 60];
const WOOD: [u8; 4] = [138, 91, 54, 10];
const PLANK: [u8; 4] = [184, 132, 78, 12];
const IRON: [u8; 4] = [203, 209, 218, 120];
const DIAMOND: [u8; 4] = [99, 224, 230, 200];

const RINGS: u16 = 8;
const SIDES: u16 = 12;

fn put(solid: &mut Solid, colour: [u8; 4], roundness: f32, centre: [f32; 3], radii: [f32; 3]) {
    glowing(solid, 0.0, colour, roundness, centre, radii);
}

fn glowing(
    solid: &mut Solid,
    glow: f32,
    colour: [u8; 4],
    roundness: f32,
    centre: [f32; 3],
    radii: [f32; 3],
) {
    let part = Part {
        centre: Vec3::from(centre),
        radii: Vec3::from(radii),
        roundness,
        colour,
        swing: [0.0, 0.0],
        glow,
    };
    solid.add(&part, RINGS, SIDES);
}

/// A glowing globe of glass on a foot of brass, half a metre high.
pub fn lamp() -> Solid {
    let mut solid = Solid::default();
    put(&mut solid, DARK, 0.6, [0.0, 0.02, 0.0], [0.13, 0.02, 0.13]);
    put(
        &mut solid,
        BRASS,
        0.8,
        [0.0, 0.10, 0.0],
        [0.035, 0.09, 0.035],
    );
    put(
        &mut solid,
        BRASS,
        0.7,
        [0.0, 0.19, 0.0],
        [0.085, 0.02, 0.085],
    );
    glowing(
        &mut solid,
        1.0,
        GLASS,
        1.0,
        [0.0, 0.35, 0.0],
        [0.165, 0.165, 0.165],
    );
    put(
        &mut solid,
        BRASS,
        0.7,
        [0.0, 0.515, 0.0],
        [0.045, 0.018, 0.045],
    );
    solid
}

/// A bullet about its middle. Bright enough to be followed.
pub fn bullet() -> Solid {
    let mut solid = Solid::default();
    glowing(
        &mut solid,
        0.35,
        COPPER,
        0.95,
        [0.0, 0.0, 0.0],
        [0.07, 0.06, 0.06],
    );
    solid
}

/// A short gun of compressed gas.
pub fn gun() -> Solid {
    let mut solid = Solid::default();
    put(
        &mut solid,
        STEEL,
        0.4,
        [0.05, 0.10, 0.0],
        [0.17, 0.045, 0.032],
    );
    put(
        &mut solid,
        DARK,
        0.9,
        [0.27, 0.115, 0.0],
        [0.09, 0.02, 0.02],
    );
    put(
        &mut solid,
        ORANGE,
        0.5,
        [0.04, 0.135, 0.0],
        [0.08, 0.018, 0.02],
    );
    put(
        &mut solid,
        DARK,
        0.4,
        [-0.07, 0.0, 0.0],
        [0.045, 0.10, 0.028],
    );
    solid
}

/// A pickaxe with a head of its own colour.
pub fn pickaxe(head: Head) -> Solid {
    let colour = match head {
        Head::Wood => PLANK,
        Head::Iron => IRON,
        Head::Diamond => DIAMOND,
    };
    let mut solid = Solid::default();
    put(&mut solid, WOOD, 0.6, [0.0, 0.0, 0.0], [0.022, 0.30, 0.022]);
    put(
        &mut solid,
        colour,
        0.4,
        [0.0, 0.27, 0.0],
        [0.05, 0.04, 0.04],
    );
    for side in [-1.0, 1.0] {
        put(
            &mut solid,
            colour,
            0.8,
            [side * 0.12, 0.265, 0.0],
            [0.10, 0.028, 0.026],
        );
        put(
            &mut solid,
            colour,
            0.9,
            [side * 0.21, 0.245, 0.0],
            [0.07, 0.02, 0.018],
        );
    }
    solid
}

/// What the head of a pickaxe is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Head {
    /// Planks.
    Wood,
    /// Iron.
    Iron,
    /// Diamond.
    Diamond,
}
