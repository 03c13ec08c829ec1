//! What bodies bump into: trunks and boulders, as triangles for a chunk's collider.

use std::f32::consts::TAU;

use antipode_terrain::Thing;
use glam::{Vec2, Vec3};

use crate::corner::in_chart;
use crate::species::{Age, Species, Trunk};

/// Corners around a trunk.
const AROUND: u32 = 8;
/// How far below its root a trunk begins, metres.
const BELOW_M: f32 = 0.5;
/// How wide a boulder is at its top, as a share of its foot; a trunk.
const TAPER: (f32, f32) = (0.55, 0.9);

/// Of a thinner trunk nobody takes notice, metres.
const THINNEST_M: f64 = 0.04;

/// What one bumps into of a thing, as large as it is; nothing of bushes and of the thinnest trunks.
pub fn solid_of(thing: &Thing) -> Option<Trunk> {
    let (species, age) = (Species::of_byte(thing.species)?, Age::of_byte(thing.age)?);
    let (trunk, scale) = (species.trunk(age)?, f64::from(thing.scale));
    let solid = Trunk {
        radius_m: trunk.radius_m * scale,
        height_m: trunk.height_m * scale,
    };
    (solid.radius_m >= THINNEST_M).then_some(solid)
}

/// Adds what is solid of things to the corners and triangles of a mesh, in metres from the same corner as theirs; the triangles
/// are counter-clockwise seen from outside.
pub fn add_solids(things: &[Thing], corners: &mut Vec<[f32; 3]>, triangles: &mut Vec<[u32; 3]>) {
    for thing in things {
        add_solid(thing, corners, triangles);
    }
}

fn add_solid(
    thing: &Thing,
    corners: &mut Vec<[f32; 3]>,
    triangles: &mut Vec<[u32; 3]>,
) -> Option<()> {
    let solid = solid_of(thing)?;
    let (radius_m, height_m) = (solid.radius_m as f32, solid.height_m as f32);
    let taper = if thing.species == Species::Boulder.byte() {
        TAPER.0
    } else {
        TAPER.1
    };
    let out = |n: u32| {
        // Upwards seen, from +x to -z: counter-clockwise from above.
        let (sin, cos) = (TAU * n as f32 / AROUND as f32 + thing.turn_rad).sin_cos();
        let out = Vec2::new(cos, -sin);
        if thing.species == Species::CornerStone.byte() {
            in_chart(out, thing.turn_rad)
        } else {
            out
        }
    };
    let first = corners.len() as u32;
    let rings = [(-BELOW_M, radius_m), (height_m, radius_m * taper)];
    for (y, radius_m) in rings {
        corners.extend((0..AROUND).map(|n| {
            let out = out(n) * radius_m;
            (thing.root + Vec3::new(out.x, y, out.y)).to_array()
        }));
    }
    let top = corners.len() as u32;
    corners.push((thing.root + Vec3::Y * height_m).to_array());
    for n in 0..AROUND {
        let next = (n + 1) % AROUND;
        let [low, low_next] = [n, next].map(|n| first + n);
        let [high, high_next] = [n, next].map(|n| first + AROUND + n);
        triangles.extend([
            [low, low_next, high_next],
            [low, high_next, high],
            [high, high_next, top],
        ]);
    }
    Some(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::species::left_of;

    #[test]
    fn a_trunk_is_closed_above_ground_and_faces_outwards() {
        let thing = Thing {
            root: Vec3::new(3.0, 8.0, 5.0),
            slot: 0,
            species: Species::Oak.byte(),
            age: Age::Grown.byte(),
            turn_rad: 0.4,
            scale: 1.0,
        };
        let (mut corners, mut triangles) = (vec![[0.0; 3]; 2], Vec::new());
        add_solids(&[thing], &mut corners, &mut triangles);
        assert_eq!((corners.len(), triangles.len()), (2 + 17, 24));
        let middle = thing.root + Vec3::Y;
        for triangle in triangles {
            let [a, b, c] = triangle.map(|n| Vec3::from(corners[n as usize]));
            let out = (a + b + c) / 3.0 - middle;
            assert!((b - a).cross(c - a).dot(out) > 0.0, "{a} {b} {c}");
        }
        let bush = Thing {
            species: Species::Bush.byte(),
            ..thing
        };
        let stump = left_of(&thing).into_iter().collect::<Vec<_>>();
        let (mut low, mut none) = (Vec::new(), Vec::new());
        add_solids(&stump, &mut low, &mut none);
        let tops = low.iter().map(|corner| corner[1] - thing.root.y);
        let high_m = tops.fold(0.0, f32::max);
        assert!((0.3..0.6).contains(&high_m), "a stump is low: {high_m} m");
        assert_eq!(left_of(&bush), None);
        let before = corners.len();
        add_solids(&[bush], &mut corners, &mut Vec::new());
        assert_eq!(corners.len(), before, "nobody bumps into a bush");
    }
}
