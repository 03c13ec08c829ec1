//! Halving of edges near the eye, so that straight drawn edges follow the bent ones of the chart.
//!
//! Whether an edge is halved depends on nothing but the edge, so that triangles on both sides of it agree, in
//! two chunks too, and no crack opens. A triangle with one, two or three halved edges becomes two, three or
//! four.

use std::collections::HashMap;
use std::hash::{BuildHasherDefault, Hasher};

use antipode_geometry::Hemisphere;
use antipode_scene::frame::{Frame, Quality};
use antipode_terrain::{ChunkMesh, Vertex};
use glam::{DVec3, IVec3, Vec3};

use super::ChunkLand;
use super::bounds::{BendSteps, Bounds};
use super::choice::LONGEST_EDGE_M;
use super::quality::Tolerance;

/// Edges are halved for an eye anywhere in a cell of this grid, metres: walking does not rebuild them at every
/// step.
const EYE_GRID_M: f64 = 0.5;
/// No eye is farther than this from the middle of its cell, metres.
const EYE_SLACK_M: f64 = 0.5 * 1.733 * EYE_GRID_M;
/// Steps of distance in which the longest edge that may stay is looked up, per metre.
const STEPS_PER_M: f32 = 4.0;
/// Nothing farther is looked at, metres: meshes are not seen beyond it.
const FARTHEST_M: f64 = 1e4;

/// What a refinement was made for; another key asks for another. Together with the mesh it determines the
/// refinement, so that two chunks with the same key agree on the edges they share.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RefineKey {
    hemisphere: Hemisphere,
    eye: IVec3,
    bends: BendSteps,
    quality: Quality,
}

impl RefineKey {
    /// The key of a frame with these bounds.
    pub fn of(frame: &Frame, bounds: &Bounds) -> Self {
        let eye = &frame.eye.point;
        Self {
            hemisphere: eye.hemisphere,
            eye: (eye.pos / EYE_GRID_M).round().as_ivec3(),
            bends: bounds.steps(),
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
    let reach_m = (bounds.refine_within_m(&tolerance) + EYE_SLACK_M).min(FARTHEST_M) as f32;
    let far_m = reach_m + LONGEST_EDGE_M as f32;
    let near = |vertex: &Vertex| Vec3::from(vertex.position).distance_squared(eye) < far_m * far_m;
    let near: Vec<bool> = mesh.vertices.iter().map(near).collect();
    let (close, far): (Vec<_>, Vec<_>) = mesh
        .triangles()
        .iter()
        .partition(|corners| corners.iter().any(|&i| near[i as usize]));
    let mut halver = Halver {
        eye,
        longest_square: longest_squares(bounds, &tolerance, reach_m),
        vertices: mesh.vertices.clone(),
        middles: HashMap::default(),
        worst: 0.0,
    };
    let (mut open, mut done) = (close, far);
    for _ in 0..tolerance.halvings {
        for corners in std::mem::take(&mut open) {
            halver.divide(corners, &mut open, &mut done);
        }
    }
    // What is left was halved as often as it may be.
    halver.look_at(&open);
    done.append(&mut open);
    Some(Refined {
        halved: halver.middles.len(),
        vertices: halver.vertices,
        indices: done.into_flattened(),
        error_px: halver.worst * tolerance.shape_px,
    })
}

/// The square of the longest edge that keeps to the tolerance, by distance in [`STEPS_PER_M`].
fn longest_squares(bounds: &Bounds, tolerance: &Tolerance, reach_m: f32) -> Vec<f32> {
    let steps = (reach_m * STEPS_PER_M) as u32 + 1;
    let at = |step: u32| {
        let distance_m = f64::from(step) / f64::from(STEPS_PER_M) - EYE_SLACK_M;
        (tolerance.shape_px / bounds.bend_px(distance_m.max(0.0))) as f32
    };
    (0..steps).map(at).collect()
}

/// Halves edges, each once.
struct Halver {
    eye: Vec3,
    longest_square: Vec<f32>,
    vertices: Vec<Vertex>,
    middles: HashMap<u64, u32, BuildHasherDefault<EdgeHasher>>,
    /// The largest stray of an edge that stays, in tolerances.
    worst: f64,
}

/// Spreads the two indices of an edge, which no outsider chooses, over the table.
#[derive(Default)]
struct EdgeHasher(u64);

impl Hasher for EdgeHasher {
    fn finish(&self) -> u64 {
        self.0
    }

    fn write(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.write_u64(u64::from(*byte));
        }
    }

    fn write_u64(&mut self, edge: u64) {
        // Fibonacci hashing; the high bits are the well mixed ones.
        self.0 = (self.0 ^ edge)
            .wrapping_mul(0x9e37_79b9_7f4a_7c15)
            .rotate_left(32);
    }
}

impl Halver {
    /// The triangles that a triangle becomes; one that needs no halving is done.
    fn divide(&mut self, corners: [u32; 3], open: &mut Vec<[u32; 3]>, done: &mut Vec<[u32; 3]>) {
        let [a, b, c] = corners;
        match [self.middle(a, b), self.middle(b, c), self.middle(c, a)] {
            [None, None, None] => done.push(corners),
            [Some(ab), Some(bc), Some(ca)] => {
                open.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
            }
            [Some(ab), None, None] => open.extend([[a, ab, c], [ab, b, c]]),
            [None, Some(bc), None] => open.extend([[b, bc, a], [bc, c, a]]),
            [None, None, Some(ca)] => open.extend([[c, ca, b], [ca, a, b]]),
            [Some(ab), Some(bc), None] => open.extend([[ab, b, bc], [a, ab, bc], [a, bc, c]]),
            [None, Some(bc), Some(ca)] => open.extend([[bc, c, ca], [b, bc, ca], [b, ca, a]]),
            [Some(ab), None, Some(ca)] => open.extend([[ca, a, ab], [c, ca, ab], [c, ab, b]]),
        }
    }

    /// By what multiple of the tolerance an edge strays from its true picture, at most.
    fn strays(&self, a: u32, b: u32) -> f32 {
        let [p, q] = [a, b].map(|i| Vec3::from(self.vertices[i as usize].position));
        let step = p.midpoint(q).distance(self.eye) * STEPS_PER_M;
        match self.longest_square.get(step as usize) {
            Some(longest_square) => p.distance_squared(q) / longest_square,
            None => 0.0,
        }
    }

    /// Takes note of the edges of triangles that stay as they are.
    fn look_at(&mut self, triangles: &[[u32; 3]]) {
        for &[a, b, c] in triangles {
            for (a, b) in [(a, b), (b, c), (c, a)] {
                self.worst = self.worst.max(f64::from(self.strays(a, b)));
            }
        }
    }

    /// The middle of an edge that is to be halved.
    fn middle(&mut self, a: u32, b: u32) -> Option<u32> {
        let strays = self.strays(a, b);
        if strays <= 1.0 {
            self.worst = self.worst.max(f64::from(strays));
            return None;
        }
        let key = u64::from(a.min(b)) << 32 | u64::from(a.max(b));
        let next = self.vertices.len() as u32;
        let index = *self.middles.entry(key).or_insert(next);
        if index == next {
            let (first, second) = (self.vertices[a as usize], self.vertices[b as usize]);
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

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use antipode_geometry::{
        ChartPoint, ChunkCoord, Eye, Geometry, HyperbolicMap, Projection, picture,
    };
    use antipode_scene::frame::Sky;
    use std::collections::HashMap;

    use super::super::bounds::PictureScale;
    use super::*;

    /// A rolling meadow of one chunk, two triangles to a cell, with its corner at `corner`.
    fn meadow(corner: DVec3) -> ChunkMesh {
        let mut mesh = ChunkMesh::default();
        let side = 33;
        for i in 0..side * side {
            let (x, z) = ((i % side) as f32, (i / side) as f32);
            let world = corner + DVec3::new(f64::from(x), 0.0, f64::from(z));
            let y = 10.0 + ((world.x * 0.3).sin() * (world.z * 0.2).cos()) as f32;
            mesh.vertices.push(Vertex {
                position: [x, y, z],
                normal: [0, i16::MAX, 0, 0],
                colour: [90, 140, 60, 255],
            });
            if x < 32.0 && z < 32.0 {
                mesh.indices
                    .extend([i, i + side, i + 1, i + 1, i + side, i + side + 1]);
            }
        }
        mesh
    }

    fn frame() -> Frame {
        let strategy = picture(Geometry::Hyperbolic, 20.0, HyperbolicMap::Raised, false);
        let black = [0.0; 3];
        Frame {
            eye: Eye {
                point: ChartPoint::a(DVec3::new(30.2, 12.0, 7.4)),
                dial: 20.0,
                ..Eye::default()
            },
            projection: Projection::new(1.3, 1.7, 0.02),
            strategy,
            sky: Sky {
                top: black,
                horizon: black,
                glare: black,
                stars: 0.0,
                sun_direction: black,
                moon_direction: black,
                key_direction: black,
                key_colour: black,
                ambient_sky: black,
                ambient_ground: black,
                dome: true,
            },
            chunk_changes: Vec::new(),
            figures: Vec::new(),
            marker: None,
            fog_distance_m: 100.0,
            contour_bands: false,
            time_s: 0.0,
            quality: Quality::Balanced,
            loaded_world: 1,
        }
    }

    fn refine_meadow(x: i32) -> (ChunkMesh, Refined, DVec3) {
        let frame = frame();
        let coord =
            ChunkCoord::containing(ChartPoint::a(DVec3::new(f64::from(32 * x) + 1.0, 1.0, 1.0)));
        let mesh = meadow(coord.origin());
        let land = ChunkLand {
            coord,
            min: coord.origin(),
            max: coord.origin() + 32.0,
            triangles: mesh.indices.len() / 3,
            solid_below_m: None,
        };
        let bounds = Bounds::measure(&frame, PictureScale::new(&frame.projection, 720));
        let refined = refined(&frame, &land, &mesh, &bounds).unwrap();
        (mesh, refined, coord.origin())
    }

    /// Edges by the places of their ends, in 1/1024 m, and how often each is used.
    fn edges(mesh: &Refined, origin: DVec3) -> HashMap<[IVec3; 2], u32> {
        let place = |i: u32| {
            let at = Vec3::from(mesh.vertices[i as usize].position).as_dvec3() + origin;
            (at * 1024.0).round().as_ivec3()
        };
        let mut uses = HashMap::new();
        for corners in mesh.indices.as_chunks::<3>().0 {
            for i in 0..3 {
                let mut ends = [place(corners[i]), place(corners[(i + 1) % 3])];
                ends.sort_by_key(IVec3::to_array);
                *uses.entry(ends).or_insert(0) += 1;
            }
        }
        uses
    }

    #[test]
    fn no_crack_opens_inside_a_chunk_or_between_two() {
        let mut uses = HashMap::new();
        for x in 0..2 {
            let (mesh, refined, origin) = refine_meadow(x);
            assert!(refined.halved > 100 && refined.indices.len() > mesh.indices.len());
            assert!(refined.error_px <= 0.5, "{}", refined.error_px);
            for (edge, count) in edges(&refined, origin) {
                *uses.entry(edge).or_insert(0) += count;
            }
        }
        for ([a, b], count) in uses {
            let rim = |p: IVec3| p.x == 0 || p.z == 0 || p.x == 64 * 1024 || p.z == 32 * 1024;
            let expected = if rim(a) && rim(b) && (a.x == b.x || a.z == b.z) {
                1
            } else {
                2
            };
            assert_eq!(count, expected, "{a} {b}");
        }
    }

    #[test]
    fn halving_keeps_the_ground_plan_and_the_side_that_is_up() {
        let (_, refined, _) = refine_meadow(0);
        let mut area = 0.0;
        for corners in refined.indices.as_chunks::<3>().0 {
            let [a, b, c] = corners.map(|i| Vec3::from(refined.vertices[i as usize].position));
            let up = (b - a).cross(c - a).y;
            assert!(up > 0.0);
            area += f64::from(0.5 * up);
        }
        assert!((area - 1024.0).abs() < 1e-2, "{area}");
    }
}
