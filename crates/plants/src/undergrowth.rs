//! What grows low on the ground of a chunk: grass, flowers, ferns and reeds, and mushrooms and crystals in caves.
//!
//! It is scattered over the chunk's own mesh, a place in each cell of the plan and on each floor there, and grows only where
//! nobody has dug or built: where the mesh is that of the untouched field. Nothing of it is kept in a save.

use antipode_geometry::{CHUNK_CELLS, ChartPoint, ChunkCoord};
use antipode_terrain::{ChunkMesh, Field, Kind, Level, Tuft, Vertex};
use glam::{DVec2, DVec3, IVec2, Vec2, Vec3, Vec3Swizzles as _};

use crate::corner::lined;
use crate::growth::Growth;
use crate::noise::{Draw, grove};

/// Cells along a metre.
const CELLS_PER_M: f32 = 1.5;
/// Chunks are numbered apart from the cells of things.
const CHART: u64 = 0x6c6f_7721;
/// And those of what lines edges.
const EDGES: u64 = 0x6564_6765;
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
    let floors = corners.filter_map(Floor::of);
    floors.flat_map(|floor| patch.on(&floor)).collect()
}

/// The plan of a chunk.
struct Patch<'a> {
    field: &'a Field,
    coord: ChunkCoord,
    /// The names of its biomes, by rows along z.
    biomes: [[&'static str; ASKED]; ASKED],
    /// Where stones line the edges of its square, metres from its corner.
    lined: Vec<Vec2>,
}

/// A triangle of the ground that is seen from above, in the plan of a chunk.
struct Floor<'a> {
    corners: [&'a Vertex; 3],
    places: [Vec3; 3],
    plan: [Vec2; 3],
    /// Twice its area, less than nothing.
    area: f32,
}

impl<'a> Floor<'a> {
    fn of(corners: [&'a Vertex; 3]) -> Option<Self> {
        let places = corners.map(Vertex::position);
        let plan = places.map(|p| Vec2::new(p.x, p.z));
        let area = (plan[1] - plan[0]).perp_dot(plan[2] - plan[0]);
        // What hangs over is seen from its back.
        (area < 0.0).then_some(Self {
            corners,
            places,
            plan,
            area,
        })
    }

    /// Between which places of the plan it lies.
    fn limits(&self) -> [Vec2; 2] {
        let [a, b, c] = self.plan;
        [a.min(b).min(c), a.max(b).max(c)]
    }

    /// The ground at a place of the plan, and the corner that counts the most there.
    fn at(&self, at: Vec2) -> Option<(Vec3, &'a Vertex)> {
        let [a, b, c] = self.plan;
        let share = |from: Vec2, to: Vec2| (to - from).perp_dot(at - from) / self.area;
        let weights = Vec3::new(share(b, c), share(c, a), share(a, b));
        let [p, q, r] = self.places;
        let root = p * weights.x + q * weights.y + r * weights.z;
        (weights.min_element() >= 0.0).then(|| (root, self.corners[weights.max_position()]))
    }
}

impl<'a> Patch<'a> {
    fn of(field: &'a Field, coord: ChunkCoord) -> Self {
        let asked = |n: usize| (n as f64 + 0.5) * f64::from(BIOME_M);
        let biome = |x: usize, z: usize| {
            let pos = coord.origin() + DVec3::new(asked(x), 0.0, asked(z));
            field.biome_at(ChartPoint::new(coord.chart, pos)).name()
        };
        let (corner, side) = (coord.origin().xz(), CHUNK_CELLS as f32);
        Self {
            field,
            coord,
            biomes: std::array::from_fn(|x| std::array::from_fn(|z| biome(x, z))),
            lined: lined(&**field.strategy(), coord.chart)
                .into_iter()
                .map(|at| (at - corner).as_vec2())
                .filter(|at| at.cmpge(Vec2::ZERO).all() && at.cmplt(Vec2::splat(side)).all())
                .collect(),
        }
    }

    fn biome(&self, at: Vec2) -> &'static str {
        let [x, z] = at
            .to_array()
            .map(|m| ((m / BIOME_M as f32) as usize).min(ASKED - 1));
        self.biomes[x][z]
    }

    /// What grows on a triangle.
    fn on(&self, floor: &Floor<'_>) -> Vec<Tuft> {
        let [low, high] = floor.limits();
        let [first, last] = [low, high].map(|it| (it * CELLS_PER_M).floor().as_ivec2());
        let cells =
            (first.x..=last.x).flat_map(|x| (first.y..=last.y).map(move |z| IVec2::new(x, z)));
        let scattered = cells.filter_map(|cell| {
            let mut draw = self.draw(cell, CHART);
            let at = (cell.as_vec2() + Vec2::new(draw.share(), draw.share())) / CELLS_PER_M;
            let (root, ground) = floor.at(at)?;
            self.tuft(root, ground, &mut draw)
        });
        let is_over = |at: &&Vec2| at.cmpge(low).all() && at.cmple(high).all();
        let lined = self.lined.iter().filter(is_over).filter_map(|at| {
            let (root, ground) = floor.at(*at)?;
            self.cobble(root, ground)
        });
        scattered.chain(lined).collect()
    }

    /// The numbers of a cell of the plan.
    fn draw(&self, cell: IVec2, of: u64) -> Draw {
        let across = (CHUNK_CELLS as f32 * CELLS_PER_M) as i32;
        let [x, _, z] = self.coord.index.to_array();
        let number = IVec2::new(x, z)
            .wrapping_mul(IVec2::splat(across))
            .wrapping_add(cell);
        let chart = self.coord.chart.number() as u64;
        Draw::of(self.field.seed(), chart ^ of, number)
    }

    /// A stone that lines an edge, on the ground of a vertex.
    fn cobble(&self, root: Vec3, ground: &Vertex) -> Option<Tuft> {
        let sky = (ground.colour[3] >> 5).min(6);
        let is_open = sky > CAVE_SKY && self.is_untouched(root);
        let mut draw = self.draw((root * 8.0).xz().as_ivec2(), EDGES);
        let tuft = Self::planted(Growth::Cobble, root, ground, &mut draw);
        // None is left out however far off it is drawn.
        is_open.then_some(Tuft { rank: 0, ..tuft })
    }

    /// Whether nobody has dug or built at a place.
    fn is_untouched(&self, root: Vec3) -> bool {
        let place = self.coord.origin() + root.as_dvec3();
        let at = ChartPoint::new(self.coord.chart, place);
        self.field.sample(at).abs() < UNTOUCHED_M
    }

    fn planted(growth: Growth, root: Vec3, ground: &Vertex, draw: &mut Draw) -> Tuft {
        let [r, g, b, byte] = ground.colour;
        let mut dice = || (256.0 * draw.share()) as u8;
        Tuft {
            root,
            growth: growth.byte(),
            turn: dice(),
            size: 128 + dice() / 2,
            rank: dice(),
            ground: [r, g, b, (byte >> 5).min(6)],
        }
    }

    /// What grows at a place on the ground of a vertex.
    fn tuft(&self, root: Vec3, ground: &Vertex, draw: &mut Draw) -> Option<Tuft> {
        let byte = ground.colour[3];
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
        let is_untouched = self.is_untouched(root);
        is_untouched.then(|| Self::planted(growth, root, ground, draw))
    }
}
