//! Shapes of small growth: blades that are seen from both sides, fronds, flowers, mushrooms and crystals. Fine ones for close by,
//! and coarse ones of about a third of the triangles. Grass is grey here: it takes the colour of its ground.

use std::f32::consts::TAU;
use std::sync::LazyLock;

use glam::Vec3;

use super::mesh::{Colour, Dice, Mesh, add_turned, rgb};
use super::{Material, Shape};
use crate::growth::Growth;

/// Grey by which grass keeps the colour of its ground, where it stands and at its tips.
const GREYS: [Colour; 2] = [rgb(108, 112, 100), rgb(182, 190, 150)];
const STRAW: [Colour; 2] = [rgb(116, 104, 66), rgb(186, 170, 112)];
const FERN: [Colour; 2] = [rgb(32, 62, 28), rgb(84, 138, 56)];
const STEM: [Colour; 2] = [rgb(52, 84, 40), rgb(78, 118, 54)];
const REED: [Colour; 2] = [rgb(72, 92, 44), rgb(150, 158, 84)];
const CATTAIL: Colour = rgb(92, 60, 38);
const MUSHROOM: [Colour; 2] = [rgb(214, 202, 182), rgb(176, 108, 74)];
const CRYSTAL: Colour = rgb(168, 158, 226);
const COBBLE: Colour = rgb(226, 219, 202);

/// The fine and the coarse shape of each kind.
static SHAPES: LazyLock<Vec<[Shape; 2]>> = LazyLock::new(|| {
    let of = |growth: &Growth| [true, false].map(|is_fine| made(*growth, is_fine));
    Growth::ALL.iter().map(of).collect()
});

/// The shape of small growth, as it is close by or farther off.
pub fn low_shape(growth: Growth, is_fine: bool) -> &'static Shape {
    &SHAPES[usize::from(growth.byte())][usize::from(!is_fine)]
}

fn made(growth: Growth, is_fine: bool) -> Shape {
    let mut mesh = Mesh::default();
    let mut dice = Dice::new(u64::from(growth.byte()) + 40);
    let few = |fine: usize, coarse: usize| if is_fine { fine } else { coarse };
    // What is left of many blades is wider.
    let wide = if is_fine { 1.0 } else { 1.7 };
    let grass = [Material::Blade; 2];
    let own = [Material::Petal; 2];
    match growth {
        Growth::Grass => {
            let all = Blades {
                many: few(7, 3),
                within_m: 0.34,
                high_m: [0.22, 0.46],
                wide_m: 0.07 * wide,
                lean: 0.45,
            };
            all.add(&mut mesh, &mut dice, GREYS, grass);
        }
        Growth::DryGrass => {
            let all = Blades {
                many: few(6, 3),
                within_m: 0.16,
                high_m: [0.3, 0.6],
                wide_m: 0.035 * wide,
                lean: 0.5,
            };
            all.add(&mut mesh, &mut dice, STRAW, own);
        }
        Growth::Daisy => flowers(&mut mesh, &mut dice, few(3, 1), rgb(240, 238, 226), wide),
        Growth::Poppy => flowers(
            &mut mesh,
            &mut dice,
            few(2, 1),
            rgb(206, 52, 36),
            1.3 * wide,
        ),
        Growth::Bellflower => flowers(&mut mesh, &mut dice, few(3, 1), rgb(96, 98, 208), wide),
        Growth::Fern => ferns(&mut mesh, &mut dice, few(7, 4)),
        Growth::Reed => {
            let all = Blades {
                many: few(6, 3),
                within_m: 0.4,
                high_m: [1.1, 1.9],
                wide_m: 0.05 * wide,
                lean: 0.16,
            };
            all.add(&mut mesh, &mut dice, REED, own);
            cattails(&mut mesh, &mut dice, few(3, 1));
        }
        Growth::Mushroom => mushrooms(&mut mesh, &mut dice, few(3, 1), is_fine),
        Growth::Crystal => crystals(&mut mesh, &mut dice, few(5, 2)),
        Growth::Cobble => cobble(&mut mesh, few(7, 4) as u32),
    }
    mesh.finish()
}

/// Blades about the root.
struct Blades {
    many: usize,
    within_m: f32,
    high_m: [f32; 2],
    wide_m: f32,
    /// How far they lean outwards, as a share of their height.
    lean: f32,
}

impl Blades {
    fn add(&self, mesh: &mut Mesh, dice: &mut Dice, colours: [Colour; 2], of: [Material; 2]) {
        for n in 0..self.many {
            let way = out_at((n as f32 + dice.unit()) / self.many as f32);
            let foot = way * (self.within_m * dice.unit());
            let high = dice.between(self.high_m[0], self.high_m[1]);
            let tip = foot + way * (self.lean * high * dice.unit()) + Vec3::Y * high;
            let across = out_at(dice.unit()) * (0.5 * self.wide_m);
            blade(mesh, [foot - across, foot + across, tip], colours, of[0]);
        }
    }
}

/// The way out at a share of a turn.
fn out_at(turn: f32) -> Vec3 {
    let (sin, cos) = (turn * TAU).sin_cos();
    Vec3::new(cos, 0.0, sin)
}

/// A triangle that is seen from both sides, lit as the ground is: its first two corners stand still and its last one sways.
fn blade(mesh: &mut Mesh, places: [Vec3; 3], colours: [Colour; 2], of: Material) {
    let [a, b, tip] = places;
    let foot = |mesh: &mut Mesh, place| mesh.corner(place, Vec3::Y, colours[0], of, 0.0);
    let (a, b) = (foot(mesh, a), foot(mesh, b));
    let tip = mesh.corner(tip, Vec3::Y, colours[1], of, 1.0);
    mesh.triangle(a, b, tip);
    mesh.triangle(b, a, tip);
}

fn flowers(mesh: &mut Mesh, dice: &mut Dice, many: usize, petals: Colour, wide: f32) {
    for n in 0..many {
        let way = out_at((n as f32 + dice.unit()) / many as f32);
        let foot = way * (0.2 * dice.unit());
        let head = foot + way * 0.06 + Vec3::Y * dice.between(0.26, 0.46);
        let across = out_at(dice.unit()) * 0.014;
        blade(
            mesh,
            [foot - across, foot + across, head],
            STEM,
            Material::Petal,
        );
        let reach = 0.055 * wide;
        let middle = mesh.corner(
            head - Vec3::Y * 0.02,
            Vec3::Y,
            petals * 0.72,
            Material::Petal,
            1.0,
        );
        let ring: Vec<u16> = (0..4)
            .map(|side| {
                let place = head + out_at(side as f32 / 4.0) * reach + Vec3::Y * 0.03;
                mesh.corner(place, Vec3::Y, petals, Material::Petal, 1.0)
            })
            .collect();
        mesh.close_above(&ring, middle);
        mesh.close_below(&ring, middle);
    }
}

fn ferns(mesh: &mut Mesh, dice: &mut Dice, many: usize) {
    for n in 0..many {
        let way = out_at((n as f32 + 0.6 * dice.unit()) / many as f32);
        let across = Vec3::new(-way.z, 0.0, way.x) * 0.09;
        let (long, high) = (dice.between(0.4, 0.62), dice.between(0.26, 0.44));
        let middle = way * (0.5 * long) + Vec3::Y * high;
        let tip = way * long + Vec3::Y * (0.7 * high);
        let still = [Vec3::ZERO, middle - across, middle + across];
        let [root, left, right] = [0, 1, 2].map(|i| {
            mesh.corner(
                still[i],
                Vec3::Y,
                FERN[usize::from(i > 0)],
                Material::Petal,
                0.0,
            )
        });
        let tip = mesh.corner(tip, Vec3::Y, FERN[1], Material::Petal, 1.0);
        for [a, b, c] in [[root, left, right], [left, tip, right]] {
            mesh.triangle(a, b, c);
            mesh.triangle(a, c, b);
        }
    }
}

fn cattails(mesh: &mut Mesh, dice: &mut Dice, many: usize) {
    for n in 0..many {
        let foot = out_at((n as f32 + dice.unit()) / many as f32) * (0.3 * dice.unit());
        let high = dice.between(1.3, 1.8);
        let paint = |place: Vec3, _: Vec3| {
            (
                if place.y > high - 0.34 {
                    CATTAIL
                } else {
                    REED[0]
                },
                0.0,
            )
        };
        let profile = [
            [0.0, high],
            [0.035, high - 0.06],
            [0.035, high - 0.3],
            [0.012, high - 0.35],
            [0.012, 0.0],
        ];
        add_turned(mesh, foot, &profile, 3, Material::Petal, &paint);
    }
}

fn mushrooms(mesh: &mut Mesh, dice: &mut Dice, many: usize, is_fine: bool) {
    for n in 0..many {
        let foot = out_at((n as f32 + dice.unit()) / many as f32) * dice.between(0.06, 0.22);
        let high = dice.between(0.1, 0.3);
        let reach = high * dice.between(0.5, 0.7);
        let paint = |place: Vec3, normal: Vec3| {
            let is_cap = place.y > 0.6 * high && normal.y > -0.4;
            (MUSHROOM[usize::from(is_cap)], 0.0)
        };
        let cap = [
            [0.0, high],
            [0.7 * reach, 0.9 * high],
            [reach, 0.66 * high],
            [0.22 * reach, 0.66 * high],
            [0.26 * reach, 0.0],
        ];
        let sides = if is_fine { 6 } else { 4 };
        add_turned(mesh, foot, &cap, sides, Material::Petal, &paint);
    }
}

fn crystals(mesh: &mut Mesh, dice: &mut Dice, many: usize) {
    for n in 0..many {
        let way = out_at((n as f32 + dice.unit()) / many as f32);
        let foot = way * (0.14 * dice.unit()) - Vec3::Y * 0.06;
        let high = dice.between(0.18, 0.6);
        let tip = foot + (way * dice.between(0.1, 0.6) + Vec3::Y).normalize_or(Vec3::Y) * high;
        let reach = high * 0.17;
        // Each face has its own corners: facets are flat.
        for side in 0..4 {
            let [a, b] = [side, side + 1].map(|at| foot + out_at(at as f32 / 4.0) * reach);
            let normal = (tip - a).cross(b - a).normalize_or(Vec3::Y);
            let shade = dice.between(0.75, 1.0);
            let [a, tip, b] = [a, tip, b]
                .map(|place| mesh.corner(place, normal, CRYSTAL * shade, Material::Crystal, 0.0));
            mesh.triangle(a, tip, b);
        }
    }
}

fn cobble(mesh: &mut Mesh, sides: u32) {
    let profile = [[0.0, 0.13], [0.15, 0.11], [0.24, 0.03], [0.22, -0.06]];
    let paint = |_: Vec3, _: Vec3| (COBBLE, 0.0);
    add_turned(
        mesh,
        Vec3::ZERO,
        &profile,
        sides as _,
        Material::Petal,
        &paint,
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_growth_stands_on_its_root_and_is_cheaper_farther_off() {
        for growth in Growth::ALL {
            let [fine, coarse] = [true, false].map(|is_fine| low_shape(growth, is_fine));
            assert!(
                fine.triangles.len() <= 160 && coarse.triangles.len() <= 64,
                "{growth:?}"
            );
            assert!(
                3 * coarse.triangles.len() <= 2 * fine.triangles.len(),
                "{growth:?}"
            );
            for shape in [fine, coarse] {
                let [low, high] = shape.limits();
                assert!(
                    low.y <= 0.01 && (0.09..2.0).contains(&high.y),
                    "{growth:?}: {low} {high}"
                );
                assert!(
                    low.with_y(0.0).length().max(high.with_y(0.0).length()) < 1.0,
                    "{growth:?}"
                );
            }
        }
    }

    #[test]
    fn crystals_are_seen_from_outside() {
        for corner in &low_shape(Growth::Crystal, true).corners {
            assert!(corner.normal.y > -0.6, "{corner:?}");
        }
    }
}
