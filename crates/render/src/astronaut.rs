//! The astronaut: 1.8 m of white suit with orange accents, put together from rounded solids.
//!
//! x is ahead, y up from the feet, z to the right.

use glam::Vec3;

use crate::solids::{Part, Solid};

const SUIT: [u8; 4] = [236, 238, 240, 26];
const SEAM: [u8; 4] = [186, 192, 200, 16];
const ORANGE: [u8; 4] = [244, 118, 26, 40];
const DARK: [u8; 4] = [58, 64, 76, 40];
const VISOR: [u8; 4] = [52, 38, 22, 255];
const PACK: [u8; 4] = [204, 209, 214, 20];
const LAMP: [u8; 4] = [120, 226, 255, 160];

/// Height of the hips, about which the legs swing, metres.
const HIP_M: f32 = 0.86;
/// Height of the shoulders, about which the arms swing, metres.
const SHOULDER_M: f32 = 1.34;
/// Arms swing less than legs, and against them.
const ARM_SHARE: f32 = -0.75;
/// Patches of each part, from pole to pole and around.
const RINGS: u16 = 8;
const SIDES: u16 = 12;

/// The whole figure.
pub fn astronaut() -> Solid {
    let mut solid = Solid::default();
    torso(&mut solid);
    head(&mut solid);
    backpack(&mut solid);
    for side in [-1.0, 1.0] {
        leg(&mut solid, side);
        arm(&mut solid, side);
    }
    solid
}

fn put(solid: &mut Solid, colour: [u8; 4], roundness: f32, centre: [f32; 3], radii: [f32; 3]) {
    swinging(solid, [0.0, 0.0], colour, roundness, centre, radii);
}

fn swinging(
    solid: &mut Solid,
    swing: [f32; 2],
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
        swing,
        glow: 0.0,
    };
    solid.add(&part, RINGS, SIDES);
}

fn torso(solid: &mut Solid) {
    put(solid, SUIT, 0.75, [0.0, 0.90, 0.0], [0.175, 0.16, 0.215]);
    put(solid, ORANGE, 0.7, [0.0, 0.975, 0.0], [0.185, 0.035, 0.222]);
    put(solid, SUIT, 0.7, [0.0, 1.17, 0.0], [0.20, 0.245, 0.245]);
    put(solid, DARK, 0.4, [0.185, 1.16, 0.0], [0.045, 0.075, 0.115]);
    put(
        solid,
        ORANGE,
        0.5,
        [0.225, 1.185, -0.05],
        [0.016, 0.022, 0.028],
    );
    put(
        solid,
        LAMP,
        0.5,
        [0.225, 1.185, 0.05],
        [0.016, 0.022, 0.028],
    );
}

fn head(solid: &mut Solid) {
    put(solid, ORANGE, 0.8, [0.0, 1.40, 0.0], [0.175, 0.04, 0.175]);
    put(solid, SUIT, 0.95, [0.0, 1.575, 0.0], [0.225, 0.225, 0.225]);
    put(
        solid,
        DARK,
        0.85,
        [0.095, 1.575, 0.0],
        [0.142, 0.158, 0.188],
    );
    put(
        solid,
        VISOR,
        0.9,
        [0.118, 1.575, 0.0],
        [0.140, 0.138, 0.168],
    );
    for side in [-1.0, 1.0] {
        put(
            solid,
            SEAM,
            0.7,
            [-0.01, 1.57, side * 0.215],
            [0.06, 0.07, 0.04],
        );
    }
}

fn backpack(solid: &mut Solid) {
    put(solid, PACK, 0.4, [-0.275, 1.19, 0.0], [0.125, 0.265, 0.205]);
    put(
        solid,
        ORANGE,
        0.4,
        [-0.285, 1.36, 0.0],
        [0.122, 0.045, 0.212],
    );
    put(solid, DARK, 0.4, [-0.385, 1.13, 0.0], [0.03, 0.12, 0.12]);
    put(solid, SEAM, 1.0, [-0.30, 1.56, -0.15], [0.012, 0.20, 0.012]);
    put(
        solid,
        ORANGE,
        1.0,
        [-0.30, 1.76, -0.15],
        [0.028, 0.028, 0.028],
    );
}

fn leg(solid: &mut Solid, side: f32) {
    let swing = [HIP_M, side];
    let z = side * 0.115;
    swinging(
        solid,
        swing,
        SUIT,
        0.8,
        [0.0, 0.68, z],
        [0.115, 0.24, 0.108],
    );
    swinging(
        solid,
        swing,
        ORANGE,
        0.7,
        [0.015, 0.50, z],
        [0.108, 0.05, 0.102],
    );
    swinging(
        solid,
        swing,
        SUIT,
        0.75,
        [0.0, 0.34, z],
        [0.108, 0.22, 0.102],
    );
    swinging(
        solid,
        swing,
        SEAM,
        0.5,
        [0.035, 0.10, z],
        [0.165, 0.105, 0.108],
    );
    swinging(
        solid,
        swing,
        DARK,
        0.4,
        [0.035, 0.025, z],
        [0.172, 0.027, 0.112],
    );
}

fn arm(solid: &mut Solid, side: f32) {
    let swing = [SHOULDER_M, side * ARM_SHARE];
    let z = side * 0.325;
    swinging(
        solid,
        swing,
        SUIT,
        0.9,
        [0.0, 1.31, side * 0.265],
        [0.115, 0.115, 0.12],
    );
    swinging(
        solid,
        swing,
        SUIT,
        0.8,
        [0.0, 1.15, z],
        [0.088, 0.20, 0.085],
    );
    swinging(
        solid,
        swing,
        ORANGE,
        0.7,
        [0.012, 1.02, z],
        [0.088, 0.035, 0.085],
    );
    swinging(
        solid,
        swing,
        SUIT,
        0.75,
        [0.03, 0.90, z],
        [0.082, 0.145, 0.078],
    );
    swinging(
        solid,
        swing,
        DARK,
        0.8,
        [0.04, 0.745, z],
        [0.075, 0.080, 0.070],
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_as_tall_as_a_player_and_stands_on_the_ground() {
        let solid = astronaut();
        let heights = || solid.vertices.iter().map(|v| v.position[1]);
        let (feet, top) = (
            heights().fold(f32::MAX, f32::min),
            heights().fold(f32::MIN, f32::max),
        );
        assert!((-0.01..=0.01).contains(&feet), "{feet}");
        assert!((1.75..=1.85).contains(&top), "{top}");
    }

    #[test]
    fn left_and_right_swing_against_each_other_about_their_joints() {
        let solid = astronaut();
        let at = |z: f32, y: f32| {
            let limb = solid
                .vertices
                .iter()
                .filter(|v| v.position[2] * z > 0.08 && v.position[1] < y);
            limb.map(|v| v.swing)
                .filter(|s| s[0] == HIP_M)
                .collect::<Vec<_>>()
        };
        let (left, right) = (at(-1.0, 0.5), at(1.0, 0.5));
        assert!(left.iter().all(|s| s[1] == -1.0) && !left.is_empty());
        assert!(right.iter().all(|s| s[1] == 1.0) && !right.is_empty());
    }

    #[test]
    fn the_visor_looks_ahead() {
        let solid = astronaut();
        let visor = || solid.vertices.iter().filter(|v| v.colour == VISOR);
        let mean = visor().map(|v| v.position[0]).sum::<f32>() / visor().count() as f32;
        assert!(mean > 0.08, "{mean}");
    }

    #[test]
    fn it_is_low_poly_and_fits_sixteen_bit_indices() {
        let solid = astronaut();
        assert!(solid.vertices.len() < usize::from(u16::MAX));
        assert!(
            (2_000..16_000).contains(&(solid.indices.len() / 3)),
            "{}",
            solid.indices.len() / 3
        );
    }
}
