//! Snags: dead, forked trunks without leaves, charred below.

use glam::Vec3;

use super::mesh::{Dice, Mesh, rgb, smooth};
use super::plan::Build;
use super::trunk::{Limb, add_limb};
use super::{Shape, Size};

/// The shape of a snag.
pub(super) fn grow(build: Build, size: Size) -> Shape {
    let mut mesh = Mesh::default();
    let wood = |place: Vec3| {
        let up = smooth(
            0.1,
            0.95,
            place.y / build.height + 0.1 * (place.x * 3.0 + place.z * 2.0).sin(),
        );
        let streak = 1.0 + 0.09 * (place.z.atan2(place.x) * 4.0 + place.y).sin();
        rgb(50, 41, 40).lerp(rgb(124, 106, 94), up) * streak
    };
    let sway = |place: Vec3| 0.12 * (place.y / build.height).clamp(0.0, 1.0).powi(2);
    let limbs = limbs(build);
    match size {
        Size::Near => {
            for (i, limb) in limbs.iter().enumerate() {
                add_limb(&mut mesh, limb, [8, 6, 5][i.min(2)], &wood, &sway);
            }
        }
        Size::Middle => {
            for (i, limb) in limbs.iter().take(5).enumerate() {
                let (between, sides) = if i == 0 { (2, 4) } else { (2, 3) };
                add_limb(
                    &mut mesh,
                    &limb.coarse(between).stouter(sides),
                    sides,
                    &wood,
                    &sway,
                );
            }
        }
        Size::Coarse | Size::Far => {
            let count = if size == Size::Far { 4 } else { 7 };
            for (i, limb) in limbs.iter().take(count).enumerate() {
                let thin = limb.coarse(0).stouter(3);
                let limb = if i == 0 {
                    thin
                } else {
                    thin.stouter(3).stouter(3)
                };
                add_limb(&mut mesh, &limb, 3, &wood, &sway);
            }
        }
    }
    mesh.finish()
}

/// A crooked limb with a broken end.
fn crooked(from: Vec3, to: Vec3, radii: [f32; 2], crook: f32, dice: &mut Dice) -> Limb {
    let steps = ((to - from).length() / 0.7).ceil().clamp(3.0, 7.0) as usize;
    let mut rings = vec![(from, radii[0])];
    for step in 1..=steps {
        let t = step as f32 / steps as f32;
        let aside = Vec3::new(
            dice.between(-1.0, 1.0),
            dice.between(-0.4, 0.4),
            dice.between(-1.0, 1.0),
        );
        let off = if step < steps {
            aside * crook
        } else {
            Vec3::ZERO
        };
        rings.push((
            from.lerp(to, t) + off,
            radii[0] + (radii[1] - radii[0]) * t.powf(0.8),
        ));
    }
    let (end, wide) = rings[steps];
    let ahead = (end - rings[steps - 1].0).normalize_or(Vec3::Y);
    rings.push((
        end + ahead * wide * 1.6 + Vec3::new(wide * 0.4, 0.0, 0.0),
        0.0,
    ));
    Limb { rings, ridges: 0.0 }
}

/// Limbs of each age: where on the trunk each starts, its angle, how far it reaches, how high it ends, and its girth.
fn plan(build: Build) -> &'static [[f32; 5]] {
    build.by_age(
        &[[0.5, 0.4, 0.9, 0.74, 0.55], [0.66, 3.3, 0.7, 0.86, 0.5]],
        &[
            [0.42, 0.3, 0.98, 0.86, 0.72],
            [0.52, 3.5, 0.72, 0.98, 0.7],
            [0.36, 2.1, 0.8, 0.55, 0.45],
            [0.6, 5.2, 0.55, 0.76, 0.4],
        ],
        &[
            [0.34, 0.2, 0.96, 0.8, 0.7],
            [0.44, 3.95, 0.76, 0.97, 0.72],
            [0.3, 2.2, 0.9, 0.52, 0.5],
            [0.38, 4.6, 0.8, 0.68, 0.5],
            [0.52, 1.4, 0.4, 0.86, 0.45],
        ],
    )
}

/// The crooked trunk.
fn trunk(build: Build, dice: &mut Dice) -> Limb {
    let (height, radius) = (build.height, build.radius);
    let top = Vec3::new(
        0.14 * radius,
        height * build.by_age(0.96, 0.68, 0.6),
        -0.08 * radius,
    );
    let mut trunk = Limb::trunk(
        top,
        Vec3::new(-0.1 * radius, 0.0, 0.08 * radius),
        build.trunk,
        build.by_age(1.3, 1.6, 1.8),
    );
    let last = trunk.rings.len() - 1;
    for (i, ring) in trunk.rings.iter_mut().enumerate().skip(3) {
        ring.1 *= 1.05;
        ring.0 += Vec3::new(dice.between(-1.0, 1.0), 0.0, dice.between(-1.0, 1.0))
            * build.trunk
            * 0.3
            * f32::from(u8::from(i < last));
    }
    trunk.ridges = build.by_age(0.08, 0.16, 0.24);
    trunk
}

/// The trunk first, then the limbs, the largest first, then what grows on them.
fn limbs(build: Build) -> Vec<Limb> {
    let mut dice = Dice::new(build.by_age(91, 92, 93));
    let (height, radius) = (build.height, build.radius);
    let trunk = trunk(build, &mut dice);
    let plan = plan(build);
    let mut limbs = vec![trunk];
    let mut twigs = Vec::new();
    for &[start, angle, reach, end, girth] in plan {
        let out = Vec3::new(angle.cos(), 0.0, angle.sin());
        let from = limbs[0].at_height(height * start);
        let to = out * radius * (reach - 0.04) + Vec3::Y * height * (end - 0.02);
        let girth = build.trunk * girth;
        let limb = crooked(from, to, [girth, girth * 0.38], radius * 0.06, &mut dice);
        let fork = limb.rings[limb.rings.len() / 2].0;
        let tip = fork
            + (out * 0.12 + Vec3::new(-out.z, 0.0, out.x) * 0.3) * radius
            + Vec3::Y * height * 0.13;
        twigs.push(crooked(
            fork,
            tip.min(Vec3::new(radius, height * 0.97, radius)),
            [girth * 0.5, girth * 0.2],
            radius * 0.02,
            &mut dice,
        ));
        limbs.push(limb);
    }
    limbs.extend(twigs.into_iter().take(build.by_age(1, 4, 5)));
    limbs
}
