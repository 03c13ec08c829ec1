//! Halving of edges near the eye, so that straight drawn edges follow the bent ones of the chart.
//!
//! Whether an edge is halved depends on nothing but the edge, so that triangles on both sides of it agree, in
//! two chunks too, and no crack opens. A triangle with one, two or three halved edges becomes two, three or
//! four.

use std::collections::HashMap;

use antipode_scene::frame::{Frame, Quality};
use antipode_terrain::{ChunkMesh, Vertex};
use glam::{DVec3, IVec3, Vec3};

use super::ChunkLand;
use super::bounds::Bounds;
use super::choice::LONGEST_EDGE_M;
use super::quality::Tolerance;

/// Edges are halved for an eye on this grid, metres: walking does not rebuild them at every step.
const EYE_GRID_M: f64 = 0.125;
/// And for a dial on this grid, notches.
const DIAL_GRID: f64 = 0.125;

/// What a refinement was made for; another key asks for another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RefineKey {
    eye: IVec3,
    dial: i32,
    lift: i32,
    quality: Quality,
}

impl RefineKey {
    /// The key of a frame.
    pub fn of(frame: &Frame) -> Self {
        let eye = &frame.eye;
        Self {
            eye: (eye.point.pos / EYE_GRID_M).round().as_ivec3(),
            dial: (eye.dial / DIAL_GRID).round() as i32,
            lift: (eye.lift_m / EYE_GRID_M).round() as i32,
            quality: frame.quality,
        }
    }
}

/// A chunk's mesh with edges halved.
#[derive(Clone, Debug, PartialEq)]
pub struct Refined {
    /// The mesh's vertices and the middles of halved edges.
    pub vertices: Vec<Vertex>,
    /// Three for each triangle.
    pub indices: Vec<u32>,
    /// How many edges were halved.
    pub halved: usize,
    /// The largest stray of an edge near the eye that stayed as it is, pixels.
    pub error_px: f64,
}

/// The mesh with its edges near the eye halved; `None` where the eye has no place in its chart.
pub fn refined(
    frame: &Frame,
    chunk: &ChunkLand,
    mesh: &ChunkMesh,
    bounds: &Bounds,
) -> Option<Refined> {
    let tolerance = Tolerance::of(frame.quality);
    let mut eye = frame.eye.point;
    eye.pos = (eye.pos / EYE_GRID_M).round() * EYE_GRID_M;
    if eye.hemisphere != chunk.coord.hemisphere {
        eye = frame.strategy.carry(eye)?.point;
    }
    let eye = (eye.pos - chunk.coord.origin()).as_vec3();
    let reach_m = bounds.refine_within_m(&tolerance).min(f64::from(f32::MAX)) as f32;
    let near = |vertex: &Vertex| {
        Vec3::from(vertex.position).distance(eye) < reach_m + LONGEST_EDGE_M as f32
    };
    let near: Vec<bool> = mesh.vertices.iter().map(near).collect();
    let (close, far): (Vec<_>, Vec<_>) = mesh
        .triangles()
        .iter()
        .partition(|corners| corners.iter().any(|&i| near[i as usize]));
    let mut halver = Halver {
        eye,
        bounds,
        tolerance_px: tolerance.shape_px,
        vertices: mesh.vertices.clone(),
        middles: HashMap::new(),
    };
    let mut close: Vec<[u32; 3]> = close;
    for _ in 0..tolerance.halvings {
        let mut next = Vec::with_capacity(close.len() * 2);
        for corners in &close {
            halver.divide(*corners, &mut next);
        }
        let done = next.len() == close.len();
        close = next;
        if done {
            break;
        }
    }
    let error_px = halver.worst_px(&close);
    close.extend(far);
    Some(Refined {
        halved: halver.middles.len(),
        vertices: halver.vertices,
        indices: close.into_flattened(),
        error_px,
    })
}

/// Halves edges, each once.
struct Halver<'a> {
    eye: Vec3,
    bounds: &'a Bounds,
    tolerance_px: f64,
    vertices: Vec<Vertex>,
    middles: HashMap<(u32, u32), u32>,
}

impl Halver<'_> {
    /// The triangles that a triangle becomes.
    fn divide(&mut self, corners: [u32; 3], into: &mut Vec<[u32; 3]>) {
        let [a, b, c] = corners;
        match [self.middle(a, b), self.middle(b, c), self.middle(c, a)] {
            [None, None, None] => into.push(corners),
            [Some(ab), Some(bc), Some(ca)] => {
                into.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
            }
            [Some(ab), None, None] => into.extend([[a, ab, c], [ab, b, c]]),
            [None, Some(bc), None] => into.extend([[b, bc, a], [bc, c, a]]),
            [None, None, Some(ca)] => into.extend([[c, ca, b], [ca, a, b]]),
            [Some(ab), Some(bc), None] => into.extend([[ab, b, bc], [a, ab, bc], [a, bc, c]]),
            [None, Some(bc), Some(ca)] => into.extend([[bc, c, ca], [b, bc, ca], [b, ca, a]]),
            [Some(ab), None, Some(ca)] => into.extend([[ca, a, ab], [c, ca, ab], [c, ab, b]]),
        }
    }

    /// By how many pixels an edge strays from its true picture, at most.
    fn strays_px(&self, a: u32, b: u32) -> f64 {
        let [p, q] = [a, b].map(|i| Vec3::from(self.vertices[i as usize].position));
        let distance_m = f64::from(p.midpoint(q).distance(self.eye));
        self.bounds.bend_px(distance_m) * f64::from(p.distance_squared(q))
    }

    /// The largest stray of any edge of these triangles.
    fn worst_px(&self, triangles: &[[u32; 3]]) -> f64 {
        let edges = triangles
            .iter()
            .flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
        edges.map(|(a, b)| self.strays_px(a, b)).fold(0.0, f64::max)
    }

    /// The middle of an edge that is to be halved.
    fn middle(&mut self, a: u32, b: u32) -> Option<u32> {
        if self.strays_px(a, b) <= self.tolerance_px {
            return None;
        }
        let (first, second) = (self.vertices[a as usize], self.vertices[b as usize]);
        let key = (a.min(b), a.max(b));
        let next = self.vertices.len() as u32;
        let index = *self.middles.entry(key).or_insert(next);
        if index == next {
            self.vertices.push(between(&first, &second));
        }
        Some(index)
    }
}

/// The vertex half way between two.
fn between(a: &Vertex, b: &Vertex) -> Vertex {
    let mean = Vec3::from(a.position).midpoint(Vec3::from(b.position));
    let normal = |v: &Vertex| {
        let [x, y, z, _] = v.normal;
        DVec3::new(f64::from(x), f64::from(y), f64::from(z))
    };
    let turned = (normal(a) + normal(b)).normalize_or_zero() * f64::from(i16::MAX);
    Vertex {
        position: mean.into(),
        normal: [turned.x as i16, turned.y as i16, turned.z as i16, 0],
        colour: std::array::from_fn(|i| a.colour[i].midpoint(b.colour[i])),
    }
}
