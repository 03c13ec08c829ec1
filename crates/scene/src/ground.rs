//! The loaded ground: resident chunks as colliders, as density for point queries, and as changes for the renderer.

use std::collections::{BTreeMap, HashMap};
use std::f64::consts::SQRT_2;
use std::sync::Arc;

use antipode_geometry::{Atlas, CHUNK_CELLS, ChartPoint, ChunkCoord};
use antipode_physics::{PhysicsWorld, TerrainCollider};
use antipode_streaming::{Chunk, is_in_world};
use antipode_terrain::{ChunkMesh, Cover, Field, Kind, Samples, Thing};
use glam::{DVec3, IVec3, Vec3, Vec3Swizzles};

use crate::frame::{ChunkChange, Land};

/// How far apart the heights are that a search for ground tries, in metres: thinner ground is missed.
const SEARCH_STEP_M: f64 = 0.5;
/// Halvings of the last step, to end within a micrometre.
const SEARCH_HALVINGS: u32 = 20;

/// Distance over which the slope of the ground is felt, in metres.
const SLOPE_REACH_M: f64 = 0.4;

/// What is kept of a resident chunk that has a surface.
#[derive(Debug)]
struct Resident {
    /// Only near bodies.
    samples: Option<Arc<Samples>>,
    triangles: usize,
}

/// What is needed no more of a chunk. To drop it takes longer than a frame should.
pub type Spent = (Option<TerrainCollider>, Option<Arc<Samples>>);

/// Resident ground around the player.
#[derive(Debug)]
pub struct Ground {
    field: Arc<Field>,
    chunks: HashMap<ChunkCoord, Resident>,
    /// What pictures show. A picture that is kept keeps the land of its moment.
    land: Arc<Land>,
    /// Meshes of chunks that are there for bodies alone, beyond the view: the renderer is told of them when it comes
    /// to them.
    unseen: BTreeMap<ChunkCoord, Arc<ChunkMesh>>,
    /// How often what bodies feel of it has changed.
    changes: u64,
}

impl Ground {
    /// Nothing resident yet.
    pub fn new(field: Arc<Field>) -> Self {
        Self {
            field,
            chunks: HashMap::new(),
            land: Arc::default(),
            unseen: BTreeMap::new(),
            changes: 0,
        }
    }

    /// Takes in a chunk: its collider goes to the physics, its mesh to the renderer. Returns what it takes the
    /// place of. What is not `seen` is kept from the renderer.
    pub fn put(&mut self, chunk: Chunk, seen: bool, physics: &mut PhysicsWorld) -> Spent {
        self.changes += 1;
        let collider = replace_terrain(physics, chunk.coord, chunk.collider);
        let triangles = chunk.mesh.triangles().len();
        let before = self.chunks.insert(
            chunk.coord,
            Resident {
                samples: chunk.samples,
                triangles,
            },
        );
        self.unseen.insert(chunk.coord, chunk.mesh);
        if seen {
            self.show_all(|coord| coord == chunk.coord);
        }
        (collider, before.and_then(|chunk| chunk.samples))
    }

    /// Makes a resident chunk solid, since a body has come near, or with nothing to be so no longer. Returns
    /// what this takes the place of.
    pub fn set_solid(
        &mut self,
        coord: ChunkCoord,
        collider: Option<TerrainCollider>,
        samples: Option<Arc<Samples>>,
        physics: &mut PhysicsWorld,
    ) -> Spent {
        let Some(chunk) = self.chunks.get_mut(&coord) else {
            return (collider, samples);
        };
        self.changes += 1;
        let before = std::mem::replace(&mut chunk.samples, samples);
        (replace_terrain(physics, coord, collider), before)
    }

    /// Tells the renderer of the chunks that have come into view.
    pub fn show_all(&mut self, is_seen: impl Fn(ChunkCoord) -> bool) {
        for (coord, mesh) in self.unseen.extract_if(.., |coord, _| is_seen(*coord)) {
            Arc::make_mut(&mut self.land).change(ChunkChange::Put(coord, mesh));
        }
    }

    /// Lets a chunk go, and returns what there was of it.
    pub fn remove(&mut self, coord: ChunkCoord, physics: &mut PhysicsWorld) -> Spent {
        let Some(chunk) = self.chunks.remove(&coord) else {
            return (None, None);
        };
        self.changes += 1;
        self.unseen.remove(&coord);
        Arc::make_mut(&mut self.land).change(ChunkChange::Remove(coord));
        (replace_terrain(physics, coord, None), chunk.samples)
    }

    /// What grows and stands on a resident chunk.
    pub fn things(&self, coord: ChunkCoord) -> &[Thing] {
        let mesh = self.unseen.get(&coord);
        let mesh = mesh.or_else(|| self.land.mesh(coord));
        mesh.map_or(&[], |mesh| &mesh.things)
    }

    /// What pictures show of it.
    pub fn land(&self) -> &Arc<Land> {
        &self.land
    }

    /// Grows whenever [`Ground::density`] may have changed anywhere: what was worked out of it is right while this stays.
    pub fn changes(&self) -> u64 {
        self.changes
    }

    /// Number of resident chunks with a surface.
    pub fn count(&self) -> usize {
        self.chunks.len()
    }

    /// Triangles of all resident chunks.
    pub fn triangles(&self) -> usize {
        self.chunks.values().map(|chunk| chunk.triangles).sum()
    }

    /// The field at a point, edits included: negative inside the ground. Where no chunk with a surface is
    /// resident, or no body near, the unedited field.
    pub fn density(&self, point: ChartPoint) -> f32 {
        let coord = ChunkCoord::containing(point);
        let chunk = self.chunks.get(&coord);
        match chunk.and_then(|chunk| chunk.samples.as_ref()) {
            Some(samples) => samples.density(point.pos - coord.origin()),
            None => self.field.sample(point),
        }
    }

    /// Whether a chunk has a surface to touch: a body is near.
    pub fn is_touchable(&self, coord: ChunkCoord) -> bool {
        let chunk = self.chunks.get(&coord);
        chunk.is_some_and(|chunk| chunk.samples.is_some())
    }

    /// Whether a point lies inside the ground.
    pub fn is_solid(&self, point: ChartPoint) -> bool {
        self.density(point) < 0.0
    }

    /// The unit normal of the ground at a point: the way in which the field rises fastest.
    pub fn normal(&self, point: ChartPoint) -> Vec3 {
        let density = |offset: DVec3| self.density(point.moved(offset));
        let rise = |axis: DVec3| density(axis * SLOPE_REACH_M) - density(-axis * SLOPE_REACH_M);
        let gradient = Vec3::new(rise(DVec3::X), rise(DVec3::Y), rise(DVec3::Z));
        gradient.try_normalize().unwrap_or(Vec3::Y)
    }

    /// The field at a point as it was before any edit.
    pub fn untouched_density(&self, point: ChartPoint) -> f32 {
        self.field.sample(point)
    }

    /// What the ground at a point is made of: that of untouched land where no chunk with a surface is resident, or no body
    /// near.
    pub fn kind(&self, point: ChartPoint) -> Kind {
        let coord = ChunkCoord::containing(point);
        let chunk = self.chunks.get(&coord);
        let (local, normal) = (point.pos - coord.origin(), self.normal(point));
        match chunk.and_then(|chunk| chunk.samples.as_ref()) {
            Some(samples) => samples.kind(&self.field, coord, local, normal),
            None => self
                .field
                .samples(coord)
                .kind(&self.field, coord, local, normal),
        }
    }

    /// What the ground at a point sounds like: by its kind where that is at hand, else as its biome's colours.
    pub fn cover(&self, point: ChartPoint) -> Cover {
        let chunk = self.chunks.get(&ChunkCoord::containing(point));
        if chunk.is_some_and(|chunk| chunk.samples.is_some()) {
            self.kind(point).cover()
        } else {
            self.field.cover(point, self.normal(point))
        }
    }

    /// The land as it was before any edit.
    pub fn field(&self) -> &Field {
        &self.field
    }

    /// Where a new player stands, on untouched ground.
    pub fn spawn_point(&self) -> ChartPoint {
        crate::spawn::spawn_point(&self.field)
    }

    /// Lowest and highest height that untouched ground can have, metres.
    pub fn height_range_m(&self) -> (f64, f64) {
        self.field.ground_range_m()
    }

    /// Height of the topmost surface of untouched ground in a point's column, metres.
    pub fn untouched_height(&self, point: ChartPoint) -> f64 {
        self.field
            .surface_height(point.chart, point.pos.x, point.pos.z)
    }
}

fn replace_terrain(
    physics: &mut PhysicsWorld,
    coord: ChunkCoord,
    collider: Option<TerrainCollider>,
) -> Option<TerrainCollider> {
    let ground = physics.chart_mut(coord.chart);
    ground.replace_terrain(coord, coord.origin(), collider)
}

/// Height of the first ground below a point, within `depth_m` metres; the point's own chart. Of rock that the
/// point itself lies in the underside is looked for first. `is_solid` tells ground from air.
pub fn height_below(
    point: ChartPoint,
    depth_m: f64,
    is_solid: impl Fn(ChartPoint) -> bool,
) -> Option<f64> {
    let is_solid_at = |y: f64| {
        is_solid(ChartPoint::new(
            point.chart,
            DVec3::new(point.pos.x, y, point.pos.z),
        ))
    };
    let steps = (depth_m / SEARCH_STEP_M).ceil() as u32;
    let height = |step: u32| point.pos.y - f64::from(step) * SEARCH_STEP_M;
    let first_air = (0..steps).find(|&step| !is_solid_at(height(step)))?;
    let rock = (first_air + 1..=steps).find(|&step| is_solid_at(height(step)))?;
    let (mut air, mut rock) = (height(rock - 1), height(rock));
    for _ in 0..SEARCH_HALVINGS {
        let middle = f64::midpoint(air, rock);
        if is_solid_at(middle) {
            rock = middle;
        } else {
            air = middle;
        }
    }
    Some(f64::midpoint(air, rock))
}

/// The chunks a body at `point` may touch within the next moments: those within `reach_m` of it, in other charts too
/// where their domains are near. Chunks that a closed world does not have are left out.
pub fn chunks_near(strategy: &dyn Atlas, point: ChartPoint, reach_m: f64) -> Vec<ChunkCoord> {
    let reach = DVec3::splat(reach_m);
    let mut near = chunks_in_box(point, -reach, reach);
    let tiled = strategy.tiled();
    for image in strategy.images(point, 2.0 * reach_m) {
        let mut there = chunks_in_box(image.point, -reach, reach);
        if let Some(tiled) = tiled {
            // Beyond the edges of a tile everything is asked in the next one, and coordinates of what lies far beyond an edge are
            // less apart than places.
            there.retain(|&coord| {
                let (low, high) = (coord.min().xz(), coord.max().xz());
                let has_some = strategy.domain(coord.chart).least_outside_m(low, high) < 0.0;
                has_some && tiled.away_m(point, coord.chart, low, high) <= SQRT_2 * reach_m
            });
        }
        near.extend(there);
    }
    near.retain(|coord| is_in_world(strategy, *coord));
    near
}

fn chunks_in_box(point: ChartPoint, low: DVec3, high: DVec3) -> Vec<ChunkCoord> {
    let cell = f64::from(CHUNK_CELLS);
    let low = ((point.pos + low) / cell).floor().as_ivec3();
    let high = ((point.pos + high) / cell).floor().as_ivec3();
    let mut found = Vec::new();
    for x in low.x..=high.x {
        for y in low.y..=high.y {
            for z in low.z..=high.z {
                found.push(ChunkCoord {
                    chart: point.chart,
                    index: IVec3::new(x, y, z),
                });
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    #![allow(clippy::expect_used, reason = "tests fail by panicking")]

    use antipode_geometry::{ChartId, Geometry, strategy};

    use super::*;

    fn ground(geometry: Geometry) -> Ground {
        let strategy = strategy(geometry, 32.0);
        Ground::new(Arc::new(Field::new(7, strategy)))
    }

    #[test]
    fn a_body_in_a_chunks_middle_needs_one_chunk_and_at_its_corner_eight() {
        let flat = strategy(Geometry::Euclidean, 0.0);
        assert_eq!(
            chunks_near(&*flat, ChartPoint::a(DVec3::splat(16.0)), 4.0).len(),
            1
        );
        assert_eq!(
            chunks_near(&*flat, ChartPoint::a(DVec3::splat(32.0)), 4.0).len(),
            8
        );
    }

    #[test]
    fn near_the_equator_both_hemispheres_are_needed() {
        let sphere = strategy(Geometry::Spherical, 32.0);
        let rim = sphere.domain(ChartId::FIRST).radius_m().unwrap_or_default();
        let near = chunks_near(
            &*sphere,
            ChartPoint::a(DVec3::new(rim - 1.0, 10.0, 0.0)),
            4.0,
        );
        assert!(near.iter().any(|c| c.chart == ChartId::SECOND));
        let far = chunks_near(&*sphere, ChartPoint::a(DVec3::new(0.0, 10.0, 0.0)), 4.0);
        assert!(far.iter().all(|c| c.chart == ChartId::FIRST));
    }

    #[test]
    fn a_small_closed_world_needs_no_chunk_it_does_not_have() {
        let sphere = strategy(Geometry::Spherical, 16.0);
        let near = chunks_near(&*sphere, ChartPoint::a(DVec3::new(0.0, 3.0, 0.0)), 30.0);
        assert!(!near.is_empty());
        assert!(
            near.iter()
                .all(|c| (0..=1).contains(&c.index.y) && c.index.x.abs() <= 2)
        );
    }

    #[test]
    fn the_height_below_is_where_the_field_changes_sign() {
        let ground = ground(Geometry::Euclidean);
        for x in [0.0, 13.7, -55.2] {
            let top = ChartPoint::a(DVec3::new(x, 60.0, 3.0));
            let height = height_below(top, 80.0, |point| ground.is_solid(point))
                .expect("there is ground within 80 m");
            let at = |y: f64| ChartPoint::a(DVec3::new(x, y, 3.0));
            assert!(!ground.is_solid(at(height + 0.01)) && ground.is_solid(at(height - 0.01)));
        }
    }

    #[test]
    fn from_inside_rock_the_cave_below_is_found_and_without_one_nothing() {
        let at = |y: f64| ChartPoint::a(DVec3::new(0.0, y, 0.0));
        let cave = |point: ChartPoint| !(-7.3..=-4.1).contains(&point.pos.y);
        let floor = height_below(at(1.0), 20.0, cave).expect("a cave within 20 m");
        assert!((floor + 7.3).abs() < 1e-5, "{floor}");
        assert_eq!(height_below(at(-8.0), 20.0, cave), None);
    }
}
