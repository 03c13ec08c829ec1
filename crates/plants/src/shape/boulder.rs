//! Boulders: stones that have broken along planes.

use glam::Vec3;

use super::mesh::{Dice, Mesh, rgb, smooth};
use super::plan::Build;
use super::{Material, Shape, Size};

/// A plane of a stone about its middle: which way it faces and its distance, where stone reaches about 1.
type Plane = (Vec3, f32);

/// The shape of a boulder.
pub(super) fn grow(build: Build, size: Size) -> Shape {
    let all = planes(build);
    let near = faces(&all);
    let faces = match size {
        Size::Near => near.clone(),
        Size::Middle => faces(&all[..16]),
        Size::Coarse => faces(&blunt(&near, &ROUND, 0.88)),
        Size::Far => faces(&blunt(&near, &BLUNT, 0.81)),
    };
    let corners = || near.iter().flat_map(|(_, corners)| corners);
    let top = corners().map(|corner| corner.y).fold(0.01, f32::max);
    let wide = corners()
        .map(|corner| corner.x.hypot(corner.z))
        .fold(0.01, f32::max);
    let middle = build.height * 0.32;
    let scale = Vec3::new(
        build.radius / wide,
        (build.height - middle) / top,
        build.radius / wide,
    );
    let mut mesh = Mesh::default();
    let mut dice = Dice::new(build.by_age(115, 116, 117));
    for (way, corners) in faces {
        let places: Vec<Vec3> = corners
            .iter()
            .map(|&corner| corner * scale + Vec3::Y * middle)
            .collect();
        let tone = dice.between(0.93, 1.06);
        add_face(
            &mut mesh,
            build,
            (way / scale).normalize_or(way),
            &places,
            size == Size::Near,
            tone,
        );
    }
    mesh.finish()
}

/// Adds a flat face, with a corner in its middle where it is seen close by.
fn add_face(mesh: &mut Mesh, build: Build, way: Vec3, places: &[Vec3], close: bool, tone: f32) {
    let centre = places.iter().sum::<Vec3>() / places.len().max(1) as f32;
    let put = |mesh: &mut Mesh, place: Vec3, edge: f32| {
        let normal = way * 0.8 + (place - Vec3::Y * build.height * 0.3).normalize_or(way) * 0.2;
        let up = smooth(-0.1, 1.0, place.y / build.height);
        let light = 0.45 * up + 0.4 * smooth(-0.4, 1.0, way.y) + 0.12 * edge;
        let colour = rgb(82, 78, 76).lerp(rgb(178, 171, 158), light) * tone;
        mesh.corner(place, normal, colour, Material::Stone, 0.0)
    };
    let ring: Vec<u16> = places.iter().map(|&place| put(mesh, place, 1.0)).collect();
    if close {
        let middle = put(mesh, centre, 0.0);
        for i in 0..ring.len() {
            mesh.triangle(middle, ring[i], ring[(i + 1) % ring.len()]);
        }
    } else {
        for i in 2..ring.len() {
            mesh.triangle(ring[0], ring[i - 1], ring[i]);
        }
    }
}

/// The planes of a stone: first those that are seen from farther off, then those that break its edges.
fn planes(build: Build) -> Vec<Plane> {
    let mut dice = Dice::new(build.by_age(111, 112, 114));
    let count = build.by_age(34, 48, 60);
    let planes = (0..count).map(|i| {
        // Evenly spread ways by the golden angle, each a little off.
        let (turn, share) = (
            i as f32 * 2.399_963,
            if i < 16 {
                i as f32 / 16.0
            } else {
                (i - 16) as f32 / (count - 16) as f32
            },
        );
        let up = 0.97 - 1.9 * share;
        let flat = (1.0 - up * up).max(0.0).sqrt();
        let off = Vec3::new(
            dice.between(-0.28, 0.28),
            dice.between(-0.28, 0.28),
            dice.between(-0.28, 0.28),
        );
        let way = (Vec3::new(turn.cos() * flat, up, turn.sin() * flat) + off).normalize_or(Vec3::Y);
        let distance = if i < 16 {
            dice.between(0.74, 1.0)
        } else {
            dice.between(0.92, 1.04)
        };
        (way, distance)
    });
    planes.collect()
}

/// A slanting top, four sides and a bottom.
const BLUNT: [[f32; 3]; 6] = [
    [0.15, 1.0, 0.1],
    [1.0, 0.16, 0.2],
    [-0.2, 0.12, 1.0],
    [-1.0, 0.14, -0.2],
    [0.2, 0.18, -1.0],
    [0.0, -1.0, 0.0],
];
/// The same with four more that slant between the top and the sides.
const ROUND: [[f32; 3]; 10] = [
    [0.15, 1.0, 0.1],
    [1.0, 0.1, 0.2],
    [-0.2, 0.05, 1.0],
    [-1.0, 0.1, -0.2],
    [0.2, 0.05, -1.0],
    [0.8, 0.75, 0.75],
    [-0.7, 0.9, 0.75],
    [-0.8, 0.7, -0.7],
    [0.75, 0.85, -0.8],
    [0.0, -1.0, 0.0],
];

/// Planes about a stone that face so, each at such a share of the way to the farthest corner.
fn blunt(near: &[(Vec3, Vec<Vec3>)], ways: &[[f32; 3]], share: f32) -> Vec<Plane> {
    let planes = ways.iter().map(|way| {
        let way = Vec3::from(*way).normalize_or(Vec3::Y);
        let reach = near
            .iter()
            .flat_map(|(_, corners)| corners)
            .map(|corner| corner.dot(way))
            .fold(0.0, f32::max);
        (way, reach * share)
    });
    planes.collect()
}

/// The faces that planes leave of a large block: the way of each, and its corners counter-clockwise seen from outside.
fn faces(planes: &[Plane]) -> Vec<(Vec3, Vec<Vec3>)> {
    let mut faces = Vec::new();
    for (own, &(way, distance)) in planes.iter().enumerate() {
        let (across, along) = way.any_orthonormal_pair();
        let (across, along) = if across.cross(along).dot(way) > 0.0 {
            (across, along)
        } else {
            (along, across)
        };
        let square = [
            -across - along,
            across - along,
            across + along,
            along - across,
        ];
        let mut corners: Vec<Vec3> = square.map(|corner| way * distance + corner * 4.0).to_vec();
        for (_, &plane) in planes.iter().enumerate().filter(|&(other, _)| other != own) {
            corners = cut(&corners, plane);
        }
        if corners.len() > 2 {
            faces.push((way, corners));
        }
    }
    faces
}

/// What is left of a flat face behind a plane.
fn cut(corners: &[Vec3], (way, distance): Plane) -> Vec<Vec3> {
    let mut left = Vec::new();
    for (i, &here) in corners.iter().enumerate() {
        let next = corners[(i + 1) % corners.len()];
        let (a, b) = (here.dot(way) - distance, next.dot(way) - distance);
        if a <= 0.0 {
            left.push(here);
        }
        if (a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0) {
            left.push(here.lerp(next, a / (a - b)));
        }
    }
    left
}
