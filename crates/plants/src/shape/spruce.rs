//! Spruces: storeys of drooping boughs about a straight trunk.

use std::f32::consts::TAU;

use glam::Vec3;

use super::mesh::{Colour, Dice, Mesh, add_turned, rgb, smooth};
use super::plan::Build;
use super::trunk::{Limb, add_limb};
use super::{Material, Shape, Size};

/// Needles in the shade, between and in the light.
const NEEDLES: [Colour; 3] = [rgb(20, 46, 34), rgb(42, 84, 54), rgb(84, 122, 78)];

/// The shape of a spruce.
pub(super) fn grow(build: Build, size: Size) -> Shape {
    let mut mesh = Mesh::default();
    let lowest = build.height * build.by_age(0.1, 0.13, 0.17);
    let mut trunk = Limb::trunk(
        Vec3::Y * build.height,
        Vec3::ZERO,
        build.trunk,
        build.by_age(1.2, 1.35, 1.5),
    );
    // Farther up the boughs hide it.
    trunk.rings.retain(|ring| ring.0.y < lowest * 1.6);
    trunk
        .rings
        .push((Vec3::Y * lowest * 1.7, build.trunk * 0.9));
    trunk.rings.push((Vec3::Y * lowest * 2.3, 0.0));
    let bark = |place: Vec3| {
        rgb(86, 66, 50).lerp(rgb(40, 34, 28), smooth(lowest * 0.4, lowest * 1.6, place.y))
    };
    let mut wood = |limb: &Limb, sides| add_limb(&mut mesh, limb, sides, &bark, &|_| 0.0);
    match size {
        Size::Near => wood(&trunk, 6),
        Size::Middle => wood(&trunk.coarse(1).stouter(3), 3),
        Size::Coarse | Size::Far => wood(&trunk.coarse(0).stouter(3), 3),
    }
    match size {
        Size::Near => {
            let count = build.by_age(7, 11, 13);
            let mut dice = Dice::new(build.by_age(71, 72, 73));
            for storey in 0..count {
                add_storey(&mut mesh, build, lowest, [storey, count], &mut dice);
            }
        }
        Size::Middle => add_cones(&mut mesh, build, lowest, 5, 6),
        Size::Coarse => add_cones(&mut mesh, build, lowest, 3, 5),
        Size::Far => add_far(&mut mesh, build, lowest),
    }
    mesh.finish()
}

/// How far boughs reach at a height, from 0 at the lowest to 1 at the top, metres: their tips, before they droop.
fn reach(build: Build, up: f32) -> f32 {
    let belly = build.by_age(1.0, 1.06, 1.12);
    build.radius
        * (1.0 - up).powf(build.by_age(0.95, 0.85, 0.75))
        * (belly - 0.12 * (1.0 - up)).min(1.0)
}

/// The look of needles: lighter at the tips and towards the top.
fn needles(build: Build, place: Vec3, normal: Vec3, tip: f32) -> (Colour, f32) {
    let up = (place.y / build.height).clamp(0.0, 1.0);
    let light = (0.22 * up + 0.5 * tip + 0.28 * (normal.y * 0.5 + 0.5)).clamp(0.0, 1.0);
    let [dark, middle, bright] = NEEDLES;
    let colour = if light < 0.5 {
        dark.lerp(middle, light * 2.0)
    } else {
        middle.lerp(bright, light * 2.0 - 1.0)
    };
    (colour, 0.12 * up + 0.3 * tip)
}

/// A storey of boughs: how it is turned, its hue, and how many boughs it has.
struct Storey {
    build: Build,
    turn: f32,
    hue: Vec3,
    boughs: usize,
}

impl Storey {
    /// Adds a corner at so many boughs about the trunk, at a distance and a height, which faces upward so far, and lies
    /// so near the tips.
    fn put(
        &self,
        mesh: &mut Mesh,
        bough: f32,
        [reach, height]: [f32; 2],
        rise: f32,
        tip: f32,
    ) -> u16 {
        let angle = self.turn + bough / self.boughs as f32 * TAU;
        let side = Vec3::new(angle.cos(), 0.0, angle.sin());
        let normal = (side * (1.0 - rise.abs() * 0.5) + Vec3::Y * rise).normalize_or(Vec3::Y);
        let place = side * reach + Vec3::Y * height;
        let (colour, sway) = needles(self.build, place, normal, tip);
        mesh.corner(place, normal, colour + self.hue, Material::Leaves, sway)
    }

    /// Adds the outside from the shoulder down to a hem that goes out and in, told by distances and heights.
    fn add_outside(&self, mesh: &mut Mesh, shoulder: &[u16], hem: &[[f32; 2]]) {
        let looks = [(0.45, 1.0), (0.5, 0.45)];
        let hem: Vec<u16> = hem
            .iter()
            .enumerate()
            .map(|(i, &place)| {
                self.put(mesh, i as f32 / 2.0, place, looks[i % 2].0, looks[i % 2].1)
            })
            .collect();
        for i in 0..self.boughs {
            let (a, b) = (shoulder[i], shoulder[(i + 1) % self.boughs]);
            let (c, d, e) = (hem[2 * i], hem[2 * i + 1], hem[(2 * i + 2) % hem.len()]);
            mesh.triangle(c, a, d);
            mesh.triangle(d, a, b);
            mesh.triangle(d, b, e);
        }
    }
}

/// Adds one storey: a skirt whose hem goes out and in, closed below.
fn add_storey(
    mesh: &mut Mesh,
    build: Build,
    lowest: f32,
    [storey, count]: [usize; 2],
    dice: &mut Dice,
) {
    let step = (build.height - lowest) / count as f32;
    let height = lowest + step * storey as f32;
    let out = reach(build, storey as f32 / count as f32) * dice.between(0.93, 1.0);
    let last = storey + 1 == count;
    let top = if last {
        build.height
    } else {
        height + step * 1.32
    };
    let turn = dice.between(0.0, TAU);
    let hue = Vec3::new(
        dice.between(-0.012, 0.012),
        dice.between(-0.02, 0.02),
        dice.between(-0.012, 0.012),
    );
    let boughs = if last { 5 } else { 8 };
    let storey = Storey {
        build,
        turn,
        hue,
        boughs,
    };
    let shoulder = [out * 0.3, top - step * 0.3];
    let shoulder: Vec<u16> = (0..boughs)
        .map(|i| storey.put(mesh, i as f32, shoulder, 0.7, 0.1))
        .collect();
    if last {
        let peak = storey.put(mesh, 0.0, [0.0, top], 1.0, 0.8);
        mesh.close_above(&shoulder, peak);
    }
    let hem: Vec<[f32; 2]> = (0..boughs)
        .flat_map(|_| {
            let tip = [
                out * dice.between(0.9, 1.04),
                height - step * dice.between(0.02, 0.22),
            ];
            [tip, [out * 0.75, height + step * 0.22]]
        })
        .collect();
    storey.add_outside(mesh, &shoulder, &hem);
    let under = hem
        .iter()
        .enumerate()
        .map(|(i, &place)| storey.put(mesh, i as f32 / 2.0, place, -0.8, 0.12));
    let under: Vec<u16> = under.collect();
    let middle = storey.put(mesh, 0.0, [0.0, height + step * 0.45], -1.0, 0.0);
    mesh.close_below(&under, middle);
}

/// Adds plain cones in place of storeys, closed below.
fn add_cones(mesh: &mut Mesh, build: Build, lowest: f32, count: usize, sides: usize) {
    let step = (build.height - lowest) / count as f32;
    for i in 0..count {
        let low = lowest + step * i as f32 - step * 0.05;
        let top = if i + 1 == count {
            build.height
        } else {
            low + step * 1.7
        };
        let out = reach(build, i as f32 / count as f32) * 0.89;
        let foot = Vec3::ZERO;
        let profile = [[0.0, top], [out, low], [out, low], [0.0, low + step * 0.3]];
        add_turned(
            mesh,
            foot,
            &profile,
            sides,
            Material::Leaves,
            &|place, normal| {
                let tip = (place.x.hypot(place.z) / out.max(0.01)).min(1.0);
                needles(build, place, normal, tip * 0.8)
            },
        );
    }
}

/// Adds two cones, the lower one under the upper one.
fn add_far(mesh: &mut Mesh, build: Build, lowest: f32) {
    let whole = build.height - lowest;
    let out = build.radius * 0.8;
    for profile in [
        [
            [0.0, build.height * 1.02],
            [out * 0.66, lowest + whole * 0.36],
        ],
        [[0.0, lowest + whole * 0.85], [out, lowest - whole * 0.03]],
    ] {
        add_turned(
            mesh,
            Vec3::ZERO,
            &profile,
            4,
            Material::Leaves,
            &|place, normal| needles(build, place, normal, place.x.hypot(place.z) / out),
        );
    }
}
