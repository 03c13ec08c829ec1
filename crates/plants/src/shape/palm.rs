//! Palms: a bare curved trunk with a tuft of long leaves.

use std::f32::consts::TAU;

use glam::Vec3;

use super::mesh::{Colour, Dice, Mesh, add_turned, rgb, smooth};
use super::plan::Build;
use super::trunk::{DEPTH, Limb, add_limb};
use super::{Material, Shape, Size};

/// Leaves in the shade, between and in the light.
const LEAVES: [Colour; 3] = [rgb(44, 82, 38), rgb(86, 136, 54), rgb(150, 184, 84)];

/// The shape of a palm.
pub(super) fn grow(build: Build, size: Size) -> Shape {
    let mut mesh = Mesh::default();
    let trunk = trunk(build);
    let head = trunk.rings.last().map_or(Vec3::Y, |ring| ring.0);
    let bark = |place: Vec3| {
        let stripe = if size == Size::Near {
            0.9 + 0.14 * (place.y * 5.3).sin()
        } else {
            0.9
        };
        let under = 1.0 - 0.4 * smooth(head.y * 0.75, head.y, place.y);
        rgb(122, 98, 70).lerp(rgb(156, 132, 98), smooth(0.0, head.y, place.y)) * stripe * under
    };
    let sway = |place: Vec3| 0.25 * (place.y / build.height).clamp(0.0, 1.0).powi(2);
    let (coarse, sides) = match size {
        Size::Near => (trunk.clone(), 6),
        Size::Middle => (trunk.coarse(1).stouter(3), 3),
        Size::Coarse | Size::Far => (trunk.coarse(0).stouter(3), 3),
    };
    add_limb(&mut mesh, &coarse, sides, &bark, &sway);
    let mut dice = Dice::new(build.by_age(81, 82, 83));
    match size {
        Size::Near => {
            let count = build.by_age(7, 12, 12);
            for i in 0..count {
                let upper = i % 3 == 2;
                let rise = if upper {
                    dice.between(0.75, 1.0)
                } else {
                    dice.between(0.25, 0.6)
                };
                let angle = (i as f32 + dice.between(-0.2, 0.2)) / count as f32 * TAU;
                add_leaf(
                    &mut mesh,
                    build,
                    head,
                    [angle, rise, dice.between(0.9, 1.0)],
                    5,
                );
            }
            add_nuts(&mut mesh, build, head);
        }
        Size::Middle => {
            for i in 0..6 {
                let rise = if i % 3 == 2 { 0.85 } else { 0.42 };
                add_leaf(&mut mesh, build, head, [i as f32 / 6.0 * TAU, rise, 1.0], 2);
            }
        }
        Size::Coarse | Size::Far => {
            let out = (build.radius - head.x) * 0.95;
            let count = if size == Size::Far { 4 } else { 7 };
            for i in 0..count {
                add_blade(&mut mesh, build, head, i as f32 / count as f32 * TAU, out);
            }
        }
    }
    mesh.finish()
}

/// The trunk: it leaves the ground aslant and rights itself.
fn trunk(build: Build) -> Limb {
    let top = build.height - build.radius * build.by_age(0.42, 0.3, 0.26);
    let lean = build.radius * build.by_age(0.06, 0.22, 0.26);
    let steps = (top / 1.2).ceil().max(4.0) as usize;
    let flare = build.by_age(1.5, 1.45, 1.6);
    let mut rings = vec![(Vec3::Y * -DEPTH, build.trunk * flare)];
    for step in 0..=steps {
        let t = step as f32 / steps as f32;
        let swell = 1.0 - 0.34 * t + (flare - 1.0) * (1.0 - smooth(0.0, 0.14, t));
        rings.push((
            Vec3::new(
                lean * (t * 1.45).sin(),
                top * t,
                0.12 * lean * (t * 4.0).sin(),
            ),
            build.trunk * swell,
        ));
    }
    let head = rings.last().map_or(Vec3::Y, |ring| ring.0);
    rings.push((head + Vec3::Y * build.trunk * 0.8, 0.0));
    Limb { rings, ridges: 0.0 }
}

/// The look of a place on a leaf.
fn look(build: Build, head: Vec3, place: Vec3, normal: Vec3) -> (Colour, f32) {
    let away = ((place - head).length() / build.radius).min(1.0);
    let light = (0.15 + 0.45 * away + 0.4 * normal.y).clamp(0.0, 1.0);
    let [dark, middle, bright] = LEAVES;
    let colour = if light < 0.5 {
        dark.lerp(middle, light * 2.0)
    } else {
        middle.lerp(bright, light * 2.0 - 1.0)
    };
    (colour, 0.25 + 0.6 * away)
}

/// A leaf: its angle, how steeply it rises, and its length as a part of what the crown reaches.
type Leaf = [f32; 3];

/// Lines across a leaf, from its foot to its tip: the left edge, the middle and the right edge.
fn lines(build: Build, head: Vec3, [angle, rise, part]: Leaf, steps: usize) -> Vec<[Vec3; 3]> {
    let side = Vec3::new(angle.cos(), 0.0, angle.sin());
    let across = Vec3::new(-angle.sin(), 0.0, angle.cos());
    let reach = (build.radius - head.x.hypot(head.z)) * part * (1.12 - 0.22 * rise);
    let drop = reach * (1.05 - 0.55 * rise);
    let line = |step: usize| {
        let t = step as f32 / steps as f32;
        let lift = (build.height - head.y) * (0.45 + rise * 1.25) * (t * 2.6).sin().max(0.0);
        let height = lift * (1.0 - 0.3 * t) - drop * t * t * t.sqrt();
        let middle = head + side * reach * t.powf(0.9) + Vec3::Y * height;
        let notch = match (steps > 2, step % 2) {
            (true, 0) => 0.78,
            (true, _) => 1.0,
            _ => 1.45,
        };
        let wide = if step < steps {
            0.125 * notch * (t * 2.75 + 0.25).sin() * build.radius
        } else {
            0.0
        };
        let fold = side * wide * 0.4 - Vec3::Y * wide * 0.55;
        [
            middle - across * wide + fold,
            middle,
            middle + across * wide + fold,
        ]
    };
    (0..=steps).map(line).collect()
}

/// Adds a leaf: an arching strip, folded along its middle, with a notched edge.
fn add_leaf(mesh: &mut Mesh, build: Build, head: Vec3, leaf: Leaf, steps: usize) {
    let across = Vec3::new(-leaf[0].sin(), 0.0, leaf[0].cos());
    let lines = lines(build, head, leaf, steps);
    for upside in [true, false] {
        let facing = if upside { 1.0 } else { -1.0 };
        let mut rows: Vec<[u16; 3]> = Vec::new();
        for (step, line) in lines.iter().enumerate() {
            let (before, after) = (
                lines[step.saturating_sub(1)][1],
                lines[(step + 1).min(steps)][1],
            );
            let up = (after - before).cross(across).normalize_or(Vec3::Y);
            let up = if up.y < 0.0 { -up } else { up };
            let mut row = [0; 3];
            for (k, corner) in row.iter_mut().enumerate() {
                let normal = (up + across * (k as f32 - 1.0) * 0.45) * facing;
                let (colour, sway) = look(build, head, line[k], normal.normalize_or(Vec3::Y));
                let rib = if k == 1 && upside { 1.1 } else { 1.0 };
                *corner = mesh.corner(line[k], normal, colour * rib, Material::Leaves, sway);
            }
            rows.push(row);
        }
        for (i, pair) in rows.windows(2).enumerate() {
            add_strip(mesh, pair[0], pair[1], upside, i + 1 == steps);
        }
    }
}

/// Adds a leaf of one triangle, seen from both sides.
fn add_blade(mesh: &mut Mesh, build: Build, head: Vec3, angle: f32, out: f32) {
    let side = Vec3::new(angle.cos(), 0.0, angle.sin());
    let across = Vec3::new(-angle.sin(), 0.0, angle.cos());
    let root = Vec3::new(head.x, build.height * 0.75 + head.y * 0.25, head.z) + side * out * 0.06;
    let tip = head + side * out - Vec3::Y * out * 0.55;
    let places = [root - across * out * 0.55, root + across * out * 0.55, tip];
    let up = (places[1] - places[0])
        .cross(places[2] - places[0])
        .normalize_or(Vec3::Y);
    for normal in [up, -up] {
        let corners = places.map(|place| {
            let (colour, sway) = look(build, head, place, normal);
            mesh.corner(place, normal, colour, Material::Leaves, sway)
        });
        let [a, b, c] = corners;
        if normal == up {
            mesh.triangle(a, b, c);
        } else {
            mesh.triangle(a, c, b);
        }
    }
}

/// Joins two rows across a leaf, of which the second may be the tip.
fn add_strip(mesh: &mut Mesh, near: [u16; 3], far: [u16; 3], upside: bool, tip: bool) {
    let mut put = |a, b, c| {
        if upside {
            mesh.triangle(a, b, c);
        } else {
            mesh.triangle(a, c, b);
        }
    };
    for k in 0..2 {
        put(near[k], near[k + 1], if tip { far[1] } else { far[k + 1] });
        if !tip {
            put(near[k], far[k + 1], far[k]);
        }
    }
}

/// Adds coconuts under the leaves.
fn add_nuts(mesh: &mut Mesh, build: Build, head: Vec3) {
    let size = build.trunk * 0.75;
    for i in 0..build.by_age(0, 3, 5) {
        let angle = i as f32 * 2.2 + 0.6;
        let foot = head + Vec3::new(angle.cos(), -0.6, angle.sin()) * build.trunk * 1.2;
        let profile = [[0.0, size], [size * 0.85, 0.0], [0.0, -size * 1.1]];
        add_turned(mesh, foot, &profile, 5, Material::Wood, &|_, normal| {
            (rgb(84, 56, 34) * (0.85 + 0.25 * normal.y), 0.25)
        });
    }
}
