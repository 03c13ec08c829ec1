//! What grows low on the ground of a chunk: grass, flowers, ferns and reeds, and mushrooms and crystals in caves.
//!
//! It is scattered over the chunk's own mesh, a place in each cell of the plan and on each floor there, and grows only where
//! nobody has dug or built: where the mesh is that of the untouched field. Nothing of it is kept in a save.

use antipode_geometry::{CHUNK_CELLS, ChartPoint, ChunkCoord};
use antipode_terrain::{ChunkMesh, Field, Kind, Level, Tuft, Vertex};
use glam::{DVec2, DVec3, IVec2, Vec2, Vec3};

use crate::growth::Growth;
use crate::noise::{Draw, grove};

/// Cells along a metre.
const CELLS_PER_M: f32 = 1.5;
/// Chunks are numbered apart from the cells of things.
const CHART: u64 = 0x6c6f_7721;
/// How far from zero the untouched field is where nobody has dug, metres.
const UNTOUCHED_M: f32 = 0.35;
/// Biomes are asked for at places so far apart, metres.
const BIOME_M: i32 = 8;
/// Such places along an edge of a chunk.
const ASKED: usize = (CHUNK_CELLS / BIOME_M) as usize;
/// Steps of the sky that are left in caves at most.
const CAVE_SKY: u8 = 2;
/// The least upright part of a normal that grass grows on, and that a floor of a cave has.
const LEVEL: f32 = 0.72;

/// What grows low on a chunk of the finest level; nothing on others, and in worlds without things.
pub fn undergrowth(field: &Field, coord: ChunkCoord, mesh: &ChunkMesh) -> Vec<Tuft> {
    if mesh.level != Level::FULL || !field.generator().has_things() {
        return Vec::new();
    }
    let patch = Patch::of(field, coord);
    let triangles = mesh.surface_indices().chunks_exact(3);
    let corners = triangles.filter_map(|of| {
        let [a, b, c] = [of[0], of[1], of[2]].map(|index| mesh.vertices.get(index as usize));
        Some([a?, b?, c?])
    });
    corners.flat_map(|of| patch.on(of)).collect()
}

/// The plan of a chunk.
struct Patch<'a> {
    field: &'a Field,
    coord: ChunkCoord,
    /// The names of its biomes, by rows along z.
    biomes: [[&'static str; ASKED]; ASKED],
}

impl<'a> Patch<'a> {
    fn of(field: &'a Field, coord: ChunkCoord) -> Self {
        let asked = |n: usize| (n as f64 + 0.5) * f64::from(BIOME_M);
        let biome = |x: usize, z: usize| {
            let pos = coord.origin() + DVec3::new(asked(x), 0.0, asked(z));
            field.biome_at(ChartPoint::new(coord.chart, pos)).name()
        };
        Self {
            field,
            coord,
            biomes: std::array::from_fn(|x| std::array::from_fn(|z| biome(x, z))),
        }
    }

    fn biome(&self, at: Vec2) -> &'static str {
        let [x, z] = at
            .to_array()
            .map(|m| ((m / BIOME_M as f32) as usize).min(ASKED - 1));
        self.biomes[x][z]
    }

    /// What grows on a triangle.
    fn on(&self, corners: [&Vertex; 3]) -> Vec<Tuft> {
        let places = corners.map(Vertex::position);
        let plan = places.map(|p| Vec2::new(p.x, p.z) * CELLS_PER_M);
        // Twice its area in the plan: what hangs over is seen from its back.
        let area = (plan[1] - plan[0]).perp_dot(plan[2] - plan[0]);
        if area >= 0.0 {
            return Vec::new();
        }
        let low = plan[0].min(plan[1]).min(plan[2]).floor().as_ivec2();
        let high = plan[0].max(plan[1]).max(plan[2]).floor().as_ivec2();
        let cells = (low.x..=high.x).flat_map(|x| (low.y..=high.y).map(move |z| IVec2::new(x, z)));
        let tuft = |cell: IVec2| {
            let across = (CHUNK_CELLS as f32 * CELLS_PER_M) as i32;
            let [x, _, z] = self.coord.index.to_array();
            let number = IVec2::new(x, z)
                .wrapping_mul(IVec2::splat(across))
                .wrapping_add(cell);
            let mut draw = Draw::of(
                self.field.seed(),
                self.coord.chart.number() as u64 ^ CHART,
                number,
            );
            let at = cell.as_vec2() + Vec2::new(draw.share(), draw.share());
            let share = |a: Vec2, b: Vec2| (b - a).perp_dot(at - a) / area;
            let weights = Vec3::new(
                share(plan[1], plan[2]),
                share(plan[2], plan[0]),
                share(plan[0], plan[1]),
            );
            if weights.min_element() < 0.0 {
                return None;
            }
            let root = places[0] * weights.x + places[1] * weights.y + places[2] * weights.z;
            self.tuft(root, corners[weights.max_position()], &mut draw)
        };
        cells.filter_map(tuft).collect()
    }

    /// What grows at a place on the ground of a vertex.
    fn tuft(&self, root: Vec3, ground: &Vertex, draw: &mut Draw) -> Option<Tuft> {
        let [r, g, b, byte] = ground.colour;
        let (kind, sky) = (Kind::of_byte(byte & 31)?, (byte >> 5).min(6));
        let is_level = ground.normal().y >= LEVEL;
        let place = self.coord.origin() + root.as_dvec3();
        let domain = self.field.strategy().domain(self.coord.chart);
        if domain.outside_m(DVec2::new(place.x, place.z)) > 0.0 {
            return None;
        }
        let growth = if sky <= CAVE_SKY {
            Growth::in_cave(kind, is_level, draw)
        } else if is_level {
            let point = ChartPoint::new(self.coord.chart, place);
            let dense = || grove(self.field.seed().rotate_left(7), self.field, point);
            Growth::in_open(kind, self.biome(Vec2::new(root.x, root.z)), dense, draw)
        } else {
            None
        }?;
        let is_untouched = self
            .field
            .sample(ChartPoint::new(self.coord.chart, place))
            .abs()
            < UNTOUCHED_M;
        let mut byte = || (256.0 * draw.share()) as u8;
        is_untouched.then(|| Tuft {
            root,
            growth: growth.byte(),
            turn: byte(),
            size: 128 + byte() / 2,
            rank: byte(),
            ground: [r, g, b, sky],
        })
    }
}
