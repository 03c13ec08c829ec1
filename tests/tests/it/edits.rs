//! A thousand edits at chunk corners: every batch that is shown fits its neighbours edge for edge, and what
//! one walks on is what one sees.

use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;
use std::time::Duration;

use antipode_geometry::{CHUNK_CELLS, ChartId, ChartPoint, ChunkCoord, Geometry, strategy};
use antipode_physics::PhysicsWorld;
use antipode_streaming::{Chunk, Config, Streamer, Until, Update, Wish};
use antipode_terrain::{ChunkMesh, Field, Generator, Stroke};
use glam::{DVec3, IVec3};

const LIMIT: Duration = Duration::from_mins(2);
/// In chunks; what lies beyond is not loaded and fits nothing.
const VIEW_DISTANCE: u32 = 2;
const EDITS: usize = 1000;
/// Strokes sent before the batch they make is waited for.
const STROKES_A_BATCH: usize = 4;

/// A small generator of our own (xorshift64*), so that the same edits are made on every machine.
struct Dice(u64);

impl Dice {
    fn next(&mut self, below: u64) -> u64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 33) % below
    }

    fn unit(&mut self) -> f64 {
        self.next(1 << 20) as f64 / f64::from(1 << 20)
    }
}

type Edge = [[u32; 2]; 2];

/// The open edges of a mesh that lie in the plane `axis = at` of its chunk, each with how often it occurs.
fn open_edges(mesh: &ChunkMesh, axis: usize, at: f32) -> BTreeMap<Edge, i32> {
    let mut count: HashMap<[u32; 2], i32> = HashMap::new();
    for triangle in mesh.triangles() {
        for k in 0..3 {
            let (a, b) = (triangle[k], triangle[(k + 1) % 3]);
            *count.entry([a.min(b), a.max(b)]).or_default() += 1;
        }
    }
    let mut open = BTreeMap::new();
    for ([a, b], times) in count {
        let ends = [a, b].map(|i| mesh.vertices[i as usize].position().to_array());
        if times != 1 || ends.iter().any(|p| p[axis] != at) {
            continue;
        }
        let flat = |p: [f32; 3]| [p[(axis + 1) % 3].to_bits(), p[(axis + 2) % 3].to_bits()];
        let mut edge = ends.map(flat);
        edge.sort_unstable();
        *open.entry(edge).or_default() += 1;
    }
    open
}

struct Shown {
    chunks: HashMap<ChunkCoord, Arc<ChunkMesh>>,
    physics: PhysicsWorld,
}

impl Shown {
    fn put(&mut self, chunk: Chunk) {
        self.physics.chart_mut(chunk.coord.chart).set_terrain(
            chunk.coord,
            chunk.coord.origin(),
            chunk.collider,
        );
        self.chunks.insert(chunk.coord, chunk.mesh);
    }

    /// Takes updates in and returns the chunks that changed, each batch checked as it is shown.
    fn take(&mut self, updates: Vec<Update>) -> usize {
        let mut batches = 0;
        for update in updates {
            match update {
                Update::Loaded(chunk) => self.put(chunk),
                Update::Edited(chunks) => {
                    batches += 1;
                    let coords: Vec<_> = chunks.iter().map(|c| c.coord).collect();
                    for chunk in chunks {
                        self.put(chunk);
                    }
                    for coord in coords {
                        self.fits_neighbours(coord);
                    }
                }
                Update::Unloaded(coord) => {
                    self.chunks.remove(&coord);
                }
                Update::Solid {
                    coord, collider, ..
                } => {
                    let ground = self.physics.chart_mut(coord.chart);
                    ground.set_terrain(coord, coord.origin(), collider);
                }
                Update::Saved | Update::Moved { .. } | Update::Undone(_) => {}
                Update::Problem(sentence) => panic!("{sentence}"),
                Update::SaveFailed(cause) => panic!("{cause}"),
            }
        }
        batches
    }

    fn fits_neighbours(&self, coord: ChunkCoord) {
        let side = CHUNK_CELLS as f32;
        let empty = Arc::new(ChunkMesh::default());
        let mesh = |c: &ChunkCoord| self.chunks.get(c).unwrap_or(&empty);
        let loaded = |c: &ChunkCoord| c.index.abs().max_element() <= VIEW_DISTANCE as i32;
        for axis in 0..3 {
            let mut step = IVec3::ZERO;
            step[axis] = 1;
            let above = ChunkCoord {
                index: coord.index + step,
                ..coord
            };
            let below = ChunkCoord {
                index: coord.index - step,
                ..coord
            };
            for (low, high) in [(coord, above), (below, coord)] {
                if loaded(&low) && loaded(&high) {
                    assert_eq!(
                        open_edges(mesh(&low), axis, side),
                        open_edges(mesh(&high), axis, 0.0),
                        "a gap between {low:?} and {high:?}"
                    );
                }
            }
        }
    }

    /// The first triangle below a point, by brute force over the meshes.
    fn seen_below(&self, from: DVec3) -> Option<f64> {
        let mut nearest: Option<f64> = None;
        for (coord, mesh) in &self.chunks {
            for triangle in mesh.triangles() {
                let [a, b, c] = triangle
                    .map(|i| coord.origin() + mesh.vertices[i as usize].position().as_dvec3());
                if let Some(height) = height_in(from, a, b, c)
                    && height <= from.y
                {
                    nearest = Some(nearest.map_or(height, |n: f64| n.max(height)));
                }
            }
        }
        nearest.map(|height| from.y - height)
    }
}

/// Height of a triangle over the column of a point, if it covers it.
fn height_in(p: DVec3, a: DVec3, b: DVec3, c: DVec3) -> Option<f64> {
    let cross = |u: DVec3, v: DVec3| u.x * v.z - u.z * v.x;
    let area = cross(b - a, c - a);
    if area.abs() < 1e-12 {
        return None;
    }
    let (s, t) = (cross(p - a, c - a) / area, cross(b - a, p - a) / area);
    (s >= 0.0 && t >= 0.0 && s + t <= 1.0).then_some(a.y + s * (b.y - a.y) + t * (c.y - a.y))
}

#[test]
fn a_thousand_edits_at_chunk_corners_leave_no_gap_and_what_is_seen_carries() {
    let space = strategy(Geometry::Euclidean, f64::INFINITY);
    // Bare land: trunks carry, too, and are no land.
    let field = Arc::new(Field::made_by(Generator::Climates, 13, space.clone()));
    let mut streamer =
        Streamer::start(Arc::clone(&field), space.clone(), None, Config::default()).unwrap();
    let mut shown = Shown {
        chunks: HashMap::new(),
        physics: PhysicsWorld::new(),
    };
    let centre = ChartPoint::a(DVec3::splat(16.0));
    streamer.wish(&Wish::new(centre, DVec3::X, VIEW_DISTANCE));
    shown.take(streamer.wait(Until::Idle, LIMIT));
    let mut dice = Dice(0x9E37_79B9_7F4A_7C15);
    let mut batches = 0;
    for n in 0..EDITS {
        let corner = DVec3::new(
            32.0 * (dice.next(3) as f64 - 1.0),
            32.0 * dice.next(2) as f64,
            32.0 * (dice.next(3) as f64 - 1.0),
        );
        let off = DVec3::new(dice.unit(), dice.unit(), dice.unit()) * 6.0 - 3.0;
        let sign = if dice.next(2) == 0 { 1.0 } else { -1.0 };
        streamer.edit(Stroke {
            centre: ChartPoint::a(corner + off),
            radius_m: 1.0 + 9.0 * dice.unit(),
            amount: sign * (0.5 + 4.0 * dice.unit() as f32),
            part: antipode_terrain::Part::Whole,
            kind: None,
            shape: antipode_terrain::Shape::Ball,
            power: None,
        });
        if n % STROKES_A_BATCH == STROKES_A_BATCH - 1 {
            batches += shown.take(streamer.wait(Until::Edits, LIMIT));
        }
    }
    assert!(
        batches >= EDITS / STROKES_A_BATCH,
        "only {batches} batches were shown"
    );
    for _ in 0..40 {
        let from = DVec3::new(60.0 * dice.unit() - 30.0, 50.0, 60.0 * dice.unit() - 30.0);
        let seen = shown.seen_below(from);
        let felt = shown
            .physics
            .chart(ChartId::FIRST)
            .cast_ray(from, DVec3::NEG_Y, 120.0)
            .map(|hit| hit.distance_m);
        match (seen, felt) {
            (Some(seen), Some(felt)) => {
                assert!((seen - felt).abs() < 1e-3, "{from}: {seen} and {felt}");
            }
            (seen, felt) => assert_eq!(seen, felt, "{from}"),
        }
    }
    streamer.close().unwrap();
}
