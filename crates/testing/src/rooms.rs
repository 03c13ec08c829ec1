//! Deformed rooms made by chance: boxes beside and within each other, turned anyhow, portals and solids between them.

use antipode_deformation::{Aberration, Portal, Sides, Space, Traveller, Triangle, Ways};
use fastrand::Rng;
use glam::{DMat3, DQuat, DVec2, DVec3};

/// Half of the edges of the room in which all of it lies, metres.
pub const HALF_M: f64 = 12.0;

/// A direction of length 1, all alike.
pub fn direction(rng: &mut Rng) -> DVec3 {
    loop {
        let v = DVec3::from_array([0; 3].map(|_| 2.0 * rng.f64() - 1.0));
        if (0.01..=1.0).contains(&v.length_squared()) {
            return v.normalize();
        }
    }
}

/// A point of the room.
pub fn point(rng: &mut Rng) -> DVec3 {
    DVec3::from_array([0; 3].map(|_| (2.0 * rng.f64() - 1.0) * 0.98 * HALF_M))
}

fn turn(rng: &mut Rng) -> DQuat {
    DQuat::from_axis_angle(direction(rng), std::f64::consts::TAU * rng.f64())
}

/// A stretch between 1/`most` and `most`, as often above as below 1.
fn stretch(rng: &mut Rng, most: f64) -> f64 {
    most.powf(2.0 * rng.f64() - 1.0)
}

/// Boxes up to `depth` deep, stretched by up to `most` and its inverse, with the sides that `sides` chooses.
pub fn aberrations(
    rng: &mut Rng,
    depth: usize,
    most: f64,
    sides: impl Fn(&mut Rng) -> Sides + Copy,
) -> Vec<Aberration> {
    let mut made = Vec::new();
    let room = (DVec3::ZERO, DQuat::IDENTITY, DVec3::splat(HALF_M));
    fill(rng, room, depth, most, sides, &mut made);
    made
}

fn fill(
    rng: &mut Rng,
    (centre, axes, half): (DVec3, DQuat, DVec3),
    depth: usize,
    most: f64,
    sides: impl Fn(&mut Rng) -> Sides + Copy,
    made: &mut Vec<Aberration>,
) {
    if depth == 0 {
        return;
    }
    // Two cells beside each other along the longest axis, each of which may hold a box.
    let axis = (0..3).fold(0, |best, i| if half[i] > half[best] { i } else { best });
    for side in [-0.5, 0.5] {
        let mut cell = half;
        cell[axis] *= 0.5;
        let mut offset = DVec3::ZERO;
        offset[axis] = side * half[axis];
        let middle = centre + axes * offset;
        let sides_of = sides(rng);
        let mut stretches = DVec3::from_array([0; 3].map(|_| stretch(rng, most)));
        if sides_of == Sides::Walls {
            stretches = DVec3::select(glam::BVec3::new(true, false, false), stretches, DVec3::ONE);
        }
        // Boxes that are turned as what they lie in may touch it; others fit however they are turned.
        let (own_turn, own_half) = if rng.f64() < 0.4 {
            (axes, cell * if rng.bool() { 1.0 } else { 0.8 })
        } else {
            let reach = cell.min_element() * 0.98;
            let shape = DVec3::from_array([0; 3].map(|_| 0.4 + 0.6 * rng.f64()));
            (turn(rng), shape * (reach / shape.length()))
        };
        made.push(Aberration {
            name: format!("box {}", made.len()),
            centre: middle,
            turn: own_turn,
            half: own_half,
            stretch: stretches,
            sides: sides_of,
            ways: Ways::Both,
        });
        fill(
            rng,
            (middle, own_turn, own_half),
            depth - 1,
            most,
            sides,
            made,
        );
    }
}

/// So many pairs of portals, or portals that are their own partners, about a room of these boxes: polygons of all kinds, turned
/// anyhow, with one side or two, whose sizes differ by up to `most`.
pub fn portals(rng: &mut Rng, boxes: &[Aberration], pairs: usize, most: f64) -> Vec<Portal> {
    let plain = Space::new(boxes.to_vec()).unwrap_or_default();
    let mut made: Vec<Portal> = Vec::new();
    for _ in 0..60 * pairs {
        if made.len() >= 2 * pairs {
            break;
        }
        let first = made.len();
        let two_sided = rng.bool();
        let portal = |number: usize, to: usize, at: DVec3, turn: DQuat, polygon| Portal {
            name: format!("portal {number}"),
            at,
            turn,
            polygon,
            to,
            two_sided,
        };
        let (at, own) = (point(rng), turn(rng));
        let mut more = made.clone();
        if rng.f64() < 0.1 {
            let size = DVec2::new(1.0 + rng.f64(), 1.0 + rng.f64());
            more.push(portal(first, first, at, own, Portal::rectangle(size)));
        } else {
            let (there, other) = (point(rng), turn(rng));
            let polygon = polygon(rng);
            let scale = stretch(rng, most);
            let partner = partner_of(&plain, (at, own, &polygon), (there, other), scale);
            more.push(portal(first, first + 1, at, own, polygon));
            more.push(portal(first + 1, first, there, other, partner));
        }
        if Space::with_portals(boxes.to_vec(), more.clone()).is_ok() {
            made = more;
        }
    }
    made
}

/// Three to seven corners on an ellipse about a point that need not be its middle.
fn polygon(rng: &mut Rng) -> Vec<DVec2> {
    let corners = rng.usize(3..8);
    let radii = DVec2::new(1.0 + 3.0 * rng.f64(), 1.0 + 3.0 * rng.f64());
    let off = DVec2::new(rng.f64() - 0.5, rng.f64() - 0.5);
    let clockwise = if rng.bool() { 1.0 } else { -1.0 };
    (0..corners)
        .map(|i| {
            let share = (i as f64 + 0.6 * rng.f64()) / corners as f64;
            let angle = clockwise * std::f64::consts::TAU * share;
            off + radii * DVec2::new(angle.cos(), angle.sin())
        })
        .collect()
}

/// The corners that the partner of a portal has, turned and placed so, for it to feel `scale` times as large: what is A t
/// along the one is turned from upright to upright, front to back, and is A t along the other.
fn partner_of(
    space: &Space,
    (at, own, polygon): (DVec3, DQuat, &[DVec2]),
    (there, other): (DVec3, DQuat),
    scale: f64,
) -> Vec<DVec2> {
    let k = |at| space.squeeze(&space.stack_at(at), DVec3::X, &Traveller::Body);
    let felt = |at: DVec3, turn: DQuat| {
        let up = (k(at).inverse() * (turn * DVec3::Y)).normalize();
        let normal = (k(at).transpose() * (turn * DVec3::X)).normalize();
        (up, normal.cross(up))
    };
    let ((up, left), (up_there, left_there)) = (felt(at, own), felt(there, other));
    let to_felt = k(at).inverse();
    polygon
        .iter()
        .map(|it| {
            let away = to_felt * (own * DVec3::new(0.0, it.y, -it.x));
            let felt = up_there * away.dot(up) - left_there * away.dot(left);
            let away = other.inverse() * (k(there) * felt * scale);
            DVec2::new(-away.z, away.y)
        })
        .collect()
}

/// The twelve triangles of a box of half sizes `half`, turned, for object `object`.
pub fn cuboid(centre: DVec3, turn: DQuat, half: DVec3, object: u32) -> Vec<Triangle> {
    let axes = DMat3::from_quat(turn) * DMat3::from_diagonal(half);
    let mut made = Vec::new();
    for axis in 0..3 {
        for side in [-1.0, 1.0] {
            let corner = |b: f64, c: f64| {
                let mut local = DVec3::ZERO;
                local[axis] = side;
                local[(axis + 1) % 3] = b * side;
                local[(axis + 2) % 3] = c;
                centre + axes * local
            };
            let [a, b, c, d] = [
                corner(-1.0, -1.0),
                corner(1.0, -1.0),
                corner(1.0, 1.0),
                corner(-1.0, 1.0),
            ];
            made.push(Triangle {
                corners: [a, b, c],
                object,
            });
            made.push(Triangle {
                corners: [a, c, d],
                object,
            });
        }
    }
    made
}

/// So many small cuboids about the room, and the room's own walls as object 0.
pub fn solids(rng: &mut Rng, count: u32) -> Vec<Triangle> {
    let mut made = cuboid(DVec3::ZERO, DQuat::IDENTITY, DVec3::splat(HALF_M), 0);
    for object in 1..=count {
        let half = DVec3::from_array([0; 3].map(|_| 0.1 + 0.5 * rng.f64()));
        made.extend(cuboid(point(rng), turn(rng), half, object));
    }
    made
}
