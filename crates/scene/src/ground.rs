//! The ground that is there: resident chunks as colliders, as density for point queries, and as changes for the renderer.

use std::collections::HashMap;
use std::sync::Arc;

use antipode_geometry::{CHUNK_CELLS, ChartPoint, ChunkCoord, Strategy};
use antipode_physics::PhysicsWorld;
use antipode_streaming::Chunk;
use antipode_terrain::{Field, RIM_REACH_M, Samples};
use glam::{DVec2, DVec3, IVec3, Vec3Swizzles};

use crate::frame::ChunkChange;

/// What is kept of a resident chunk that has a surface.
#[derive(Debug)]
struct Resident {
    samples: Arc<Samples>,
    triangles: usize,
}

/// Resident ground around the player.
#[derive(Debug)]
pub struct Ground {
    field: Arc<Field>,
    strategy: Arc<dyn Strategy>,
    chunks: HashMap<ChunkCoord, Resident>,
    changes: Vec<ChunkChange>,
}

impl Ground {
    /// Nothing resident yet.
    pub fn new(field: Arc<Field>, strategy: Arc<dyn Strategy>) -> Self {
        Self {
            field,
            strategy,
            chunks: HashMap::new(),
            changes: Vec::new(),
        }
    }

    /// Takes in a chunk: its collider goes to the physics, its mesh to the renderer.
    pub fn put(&mut self, chunk: Chunk, physics: &mut PhysicsWorld) {
        let origin = chunk.coord.origin() + self.strategy.chart_origin_m(chunk.coord.hemisphere);
        physics.set_terrain(chunk.coord, origin, chunk.collider);
        let triangles = chunk.mesh.triangles().len();
        self.chunks.insert(
            chunk.coord,
            Resident {
                samples: chunk.samples,
                triangles,
            },
        );
        self.changes.push(ChunkChange::Put(chunk.coord, chunk.mesh));
    }

    /// Lets a chunk go.
    pub fn remove(&mut self, coord: ChunkCoord, physics: &mut PhysicsWorld) {
        if self.chunks.remove(&coord).is_some() {
            physics.set_terrain(coord, coord.origin(), None);
            self.changes.push(ChunkChange::Remove(coord));
        }
    }

    /// Changes since they were last taken, in order.
    pub fn take_changes(&mut self) -> Vec<ChunkChange> {
        std::mem::take(&mut self.changes)
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
    /// resident, the unedited field.
    pub fn density(&self, point: ChartPoint) -> f32 {
        let coord = ChunkCoord::containing(point);
        match self.chunks.get(&coord) {
            Some(chunk) => chunk.samples.density(point.pos - coord.origin()),
            None => self.field.sample(point),
        }
    }

    /// Whether a point lies inside the ground.
    pub fn is_solid(&self, point: ChartPoint) -> bool {
        self.density(point) < 0.0
    }

    /// Height of the first ground below a point, within `depth_m` metres; the point's own chart.
    pub fn height_below(&self, point: ChartPoint, depth_m: f64) -> Option<f64> {
        let at =
            |y: f64| ChartPoint::new(point.hemisphere, DVec3::new(point.pos.x, y, point.pos.z));
        let step_m = 0.5;
        let mut above = point.pos.y;
        let bottom = point.pos.y - depth_m;
        while above > bottom {
            let below = above - step_m;
            if self.is_solid(at(below)) {
                let (mut air, mut rock) = (above, below);
                for _ in 0..24 {
                    let middle = f64::midpoint(air, rock);
                    if self.is_solid(at(middle)) {
                        rock = middle;
                    } else {
                        air = middle;
                    }
                }
                return Some(f64::midpoint(air, rock));
            }
            above = below;
        }
        None
    }
}

/// The chunks a body at `point` may touch within the next moments: those within `reach_m` of it, in the other
/// chart too where the equator is near. Chunks that a closed world does not have are left out.
pub fn chunks_near(strategy: &dyn Strategy, point: ChartPoint, reach_m: f64) -> Vec<ChunkCoord> {
    let mut near = chunks_in_box(point, reach_m);
    if let (Some(rim), Some(over)) = (strategy.rim_m(), strategy.carry(point))
        && point.pos.x.hypot(point.pos.z) > rim - 2.0 * reach_m
    {
        near.extend(chunks_in_box(over.point, reach_m));
    }
    near.retain(|coord| exists(strategy, *coord));
    near
}

/// Whether a world has this chunk: an open one has all, a closed one those between bedrock and ceiling that
/// reach into its hemisphere.
fn exists(strategy: &dyn Strategy, coord: ChunkCoord) -> bool {
    let (Some(rim_m), Some(limits)) = (strategy.rim_m(), strategy.limits()) else {
        return true;
    };
    let (low, high) = (coord.min(), coord.max());
    let axis_m = DVec2::ZERO.clamp(low.xz(), high.xz()).length();
    axis_m <= rim_m + RIM_REACH_M && high.y >= limits.bedrock_m && low.y <= limits.ceiling_m
}

fn chunks_in_box(point: ChartPoint, reach_m: f64) -> Vec<ChunkCoord> {
    let cell = f64::from(CHUNK_CELLS);
    let low = ((point.pos - reach_m) / cell).floor().as_ivec3();
    let high = ((point.pos + reach_m) / cell).floor().as_ivec3();
    let mut found = Vec::new();
    for x in low.x..=high.x {
        for y in low.y..=high.y {
            for z in low.z..=high.z {
                found.push(ChunkCoord {
                    hemisphere: point.hemisphere,
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

    use antipode_geometry::{Geometry, Hemisphere, strategy};

    use super::*;

    fn ground(geometry: Geometry) -> Ground {
        let strategy = strategy(geometry, 32.0);
        Ground::new(Arc::new(Field::new(7, Arc::clone(&strategy))), strategy)
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
        let rim = sphere.rim_m().unwrap_or_default();
        let near = chunks_near(
            &*sphere,
            ChartPoint::a(DVec3::new(rim - 1.0, 10.0, 0.0)),
            4.0,
        );
        assert!(near.iter().any(|c| c.hemisphere == Hemisphere::B));
        let far = chunks_near(&*sphere, ChartPoint::a(DVec3::new(0.0, 10.0, 0.0)), 4.0);
        assert!(far.iter().all(|c| c.hemisphere == Hemisphere::A));
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
            let height = ground
                .height_below(top, 80.0)
                .expect("there is ground within 80 m");
            let at = |y: f64| ChartPoint::a(DVec3::new(x, y, 3.0));
            assert!(!ground.is_solid(at(height + 0.01)) && ground.is_solid(at(height - 0.01)));
        }
    }
}
