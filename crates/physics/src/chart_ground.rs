//! The solid ground of one chart, and the coordinates in which Rapier sees it.
//!
//! Origins of chunks are kept in `f64`; Rapier's colliders stand relative to a floating origin, a
//! multiple of 32 m, so that its `f32` positions stay below about 600 m near the player whatever the
//! place in the chart. Terrain has no body: it is a set of standalone colliders. Rapier's own
//! query tree is refreshed only by a simulation step, so the world keeps a tree of its own that
//! changes with every chunk and lends it to Rapier's query pipeline.

use std::collections::HashMap;
use std::sync::Arc;

use antipode_geometry::{ChartId, ChartPoint, ChunkCoord};
use glam::DVec3;
use rapier3d::dynamics::{IslandManager, RigidBodySet, SoftBodySet};
use rapier3d::geometry::{ColliderBuilder, ColliderHandle, ColliderSet};
use rapier3d::parry::bounding_volume::Aabb;
use rapier3d::parry::partitioning::{Bvh, BvhBuildStrategy};
use rapier3d::parry::query::DefaultQueryDispatcher;
use rapier3d::pipeline::{QueryFilter, QueryPipeline};

use crate::TerrainCollider;
use crate::collider::{BLOCKS, Block};

/// The floating origin moves when the focus is further than this from it along an axis.
const RECENTRE_BEYOND_M: f64 = 512.0;

/// The floating origin is a multiple of this, the edge of a chunk, so offsets stay whole numbers.
const ORIGIN_STEP_M: f64 = 32.0;

/// Boxes in the tree are grown by this against the rounding of `f32` at the reach of the frame.
const BOX_SKIN_M: f32 = 0.01;

/// A block of a chunk's terrain where it stands.
pub(crate) struct Ground {
    pub coord: ChunkCoord,
    number: usize,
    pub origin: DVec3,
    pub block: Block,
}

impl Ground {
    /// Which block of its chunk it is.
    pub fn number(&self) -> usize {
        self.number
    }
}

/// Something solid that moves and that characters cannot walk through. Rays and casts do not meet it.
#[derive(Clone, Debug)]
pub struct Obstacle {
    pub(crate) chart: ChartId,
    /// Counter-clockwise seen from outside, in metres of the chart.
    triangles: Arc<[[DVec3; 3]]>,
    min: DVec3,
    max: DVec3,
}

impl Obstacle {
    /// A closed body of triangles, counter-clockwise seen from outside, in metres of a chart.
    pub fn new(chart: ChartId, triangles: Arc<[[DVec3; 3]]>) -> Self {
        let corners = || triangles.iter().flatten().copied();
        Self {
            chart,
            min: corners().fold(DVec3::MAX, DVec3::min),
            max: corners().fold(DVec3::MIN, DVec3::max),
            triangles,
        }
    }
}

/// Something small and solid that stands still. Whatever meets terrain meets it.
#[derive(Clone, Debug)]
pub struct Solid {
    chart: ChartId,
    /// Where its shape's origin is, metres of the chart.
    foot: DVec3,
    shape: TerrainCollider,
}

impl Solid {
    /// One whose triangles lie within a metre or two of its foot, metres of a chart.
    pub fn new(chart: ChartId, foot: DVec3, shape: TerrainCollider) -> Self {
        Self { chart, foot, shape }
    }

    /// The chart that it stands in.
    pub fn chart(&self) -> ChartId {
        self.chart
    }

    fn is(&self, other: &Self) -> bool {
        let is_same_shape = || {
            let (shared, of) = self.shape.shared_parts(&other.shape);
            shared == of
        };
        self.foot == other.foot && is_same_shape()
    }
}

/// Rapier's names of a chunk's blocks.
type Standing = [Option<ColliderHandle>; BLOCKS];

/// Everything solid that is written in a chart, and the questions that can be asked of it.
///
/// Positions are metres of the chart. Queries take `&self` and change nothing.
pub struct ChartGround {
    bodies: RigidBodySet,
    soft_bodies: SoftBodySet,
    islands: IslandManager,
    colliders: ColliderSet,
    tree: Bvh,
    chunks: HashMap<ChunkCoord, Standing>,
    grounds: HashMap<u32, Ground>,
    solids: Vec<(Solid, Vec<ColliderHandle>)>,
    /// How many solids there have been: each has a number of its own.
    solids_put: usize,
    obstacles: Vec<Obstacle>,
    origin: DVec3,
}

impl Default for ChartGround {
    fn default() -> Self {
        Self::new()
    }
}

impl std::fmt::Debug for ChartGround {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("ChartGround")
            .field("chunks", &self.chunks.len())
            .field("origin", &self.origin)
            .finish_non_exhaustive()
    }
}

impl ChartGround {
    /// Nothing solid, about the chart's centre.
    pub fn new() -> Self {
        Self {
            bodies: RigidBodySet::new(),
            soft_bodies: SoftBodySet::new(),
            islands: IslandManager::new(),
            colliders: ColliderSet::new(),
            tree: Bvh::new(),
            chunks: HashMap::new(),
            grounds: HashMap::new(),
            solids: Vec::new(),
            solids_put: 0,
            obstacles: Vec::new(),
            origin: DVec3::ZERO,
        }
    }

    /// Puts a chunk's terrain with its origin at `origin` (m), replacing what the chunk had;
    /// `None` leaves the chunk empty. Parts that are the same as before stay as they are.
    pub fn set_terrain(
        &mut self,
        coord: ChunkCoord,
        origin: DVec3,
        collider: Option<TerrainCollider>,
    ) {
        drop(self.replace_terrain(coord, origin, collider));
    }

    /// As [`set_terrain`](Self::set_terrain); returns the parts that stand there no longer, so that
    /// another thread may drop them, which takes longer than all the rest.
    #[expect(
        clippy::needless_pass_by_value,
        reason = "the terrain is handed over: its parts are shared, and whoever kept it would keep them alive"
    )]
    pub fn replace_terrain(
        &mut self,
        coord: ChunkCoord,
        origin: DVec3,
        collider: Option<TerrainCollider>,
    ) -> Option<TerrainCollider> {
        let mut standing = self.chunks.remove(&coord).unwrap_or_default();
        let mut removed: [Option<Block>; BLOCKS] = Default::default();
        for (number, place) in standing.iter_mut().enumerate() {
            let block = collider.as_ref().and_then(|c| c.blocks()[number].as_ref());
            if self.is_standing(*place, origin, block) {
                continue;
            }
            removed[number] = place.take().and_then(|handle| self.take_out(handle));
            *place = block.map(|block| {
                self.put_in(Ground {
                    coord,
                    number,
                    origin,
                    block: block.clone(),
                })
            });
        }
        if collider.is_some() {
            self.chunks.insert(coord, standing);
        }
        self.forget_changes();
        TerrainCollider::of(removed)
    }

    /// Says which solids stand in the chart, in place of those that did. Those that still do stay as they are.
    pub(crate) fn set_solids(&mut self, wanted: &[Solid]) {
        let before = std::mem::take(&mut self.solids);
        let (kept, gone): (Vec<_>, Vec<_>) = before
            .into_iter()
            .partition(|(it, _)| wanted.iter().any(|other| it.is(other)));
        for handle in gone.into_iter().flat_map(|(_, handles)| handles) {
            self.take_out(handle);
        }
        self.solids = kept;
        for it in wanted {
            if self.solids.iter().any(|(other, _)| other.is(it)) {
                continue;
            }
            let number = BLOCKS + self.solids_put;
            self.solids_put += 1;
            let blocks = it.shape.blocks().iter().flatten();
            let grounds = blocks.map(|block| Ground {
                coord: ChunkCoord::containing(ChartPoint::new(it.chart, it.foot)),
                number,
                origin: it.foot,
                block: block.clone(),
            });
            let handles = grounds.map(|ground| self.put_in(ground)).collect();
            self.solids.push((it.clone(), handles));
        }
        self.forget_changes();
    }

    /// Whether a chunk has terrain to stand on or bump into.
    pub fn has_terrain(&self, coord: ChunkCoord) -> bool {
        self.chunks.contains_key(&coord)
    }

    /// How many chunks have terrain.
    pub fn terrain_count(&self) -> usize {
        self.chunks.len()
    }

    /// How many small solids stand on the terrain.
    pub fn solid_count(&self) -> usize {
        self.solids.len()
    }

    /// Whether there is nothing solid.
    pub(crate) fn is_empty(&self) -> bool {
        self.chunks.is_empty() && self.obstacles.is_empty() && self.solids.is_empty()
    }

    /// Moves the floating origin to `focus` (m), usually the player's feet, when that is more than
    /// 512 m away from it. Nothing moves in the chart. A focus that is not finite is ignored.
    pub fn recentre(&mut self, focus: DVec3) {
        if !focus.is_finite() || (focus - self.origin).abs().max_element() <= RECENTRE_BEYOND_M {
            return;
        }
        self.origin = (focus / ORIGIN_STEP_M).round() * ORIGIN_STEP_M;
        for (handle, collider) in self.colliders.iter_mut() {
            if let Some(ground) = self.grounds.get(&handle.into_raw_parts().0) {
                collider.set_translation((ground.origin - self.origin).as_vec3());
            }
        }
        let mut boxes: Vec<(u32, Aabb)> = self
            .grounds
            .iter()
            .map(|(&index, ground)| {
                (
                    index,
                    standing_box(&ground.block, ground.origin - self.origin),
                )
            })
            .collect();
        boxes.sort_unstable_by_key(|&(index, _)| index);
        let leaves = boxes
            .into_iter()
            .map(|(index, bounds)| (index as usize, bounds));
        self.tree = Bvh::from_iter(BvhBuildStrategy::default(), leaves);
        self.forget_changes();
    }

    /// Where the floating origin stands in the chart (m); multiples of 32.
    pub fn origin(&self) -> DVec3 {
        self.origin
    }

    /// What characters cannot walk through besides the terrain.
    pub(crate) fn obstacles_mut(&mut self) -> &mut Vec<Obstacle> {
        &mut self.obstacles
    }

    /// The triangles of obstacles whose box touches a box of the chart.
    pub(crate) fn obstacles_in(
        &self,
        min: DVec3,
        max: DVec3,
    ) -> impl Iterator<Item = &[DVec3; 3]> + '_ {
        self.obstacles
            .iter()
            .filter(move |it| it.min.cmple(max).all() && it.max.cmpge(min).all())
            .flat_map(|it| it.triangles.iter())
    }

    pub(crate) fn queries(&self) -> QueryPipeline<'_> {
        QueryPipeline {
            dispatcher: &DefaultQueryDispatcher,
            bvh: &self.tree,
            bodies: &self.bodies,
            colliders: &self.colliders,
            filter: QueryFilter::default(),
        }
    }

    /// The terrain whose box touches a box of the chart, in the order of the chunks, so that
    /// the answer does not depend on the order in which they were loaded.
    pub(crate) fn grounds_in(&self, min: DVec3, max: DVec3) -> Vec<&Ground> {
        let wanted = Aabb::new((min - self.origin).as_vec3(), (max - self.origin).as_vec3());
        let mut found: Vec<&Ground> = self
            .tree
            .intersect_aabb(&wanted)
            .filter_map(|index| self.grounds.get(&index))
            .collect();
        found.sort_unstable_by_key(|ground| (ground.coord, ground.number));
        found
    }

    fn is_standing(
        &self,
        place: Option<ColliderHandle>,
        origin: DVec3,
        block: Option<&Block>,
    ) -> bool {
        let standing = place.and_then(|handle| self.grounds.get(&handle.into_raw_parts().0));
        match (standing, block) {
            (Some(ground), Some(block)) => ground.origin == origin && ground.block.is_like(block),
            (None, None) => true,
            _ => false,
        }
    }

    fn put_in(&mut self, ground: Ground) -> ColliderHandle {
        let at = ground.origin - self.origin;
        let shape = ground.block.shape.clone();
        let handle = self
            .colliders
            .insert(ColliderBuilder::new(shape).translation(at.as_vec3()));
        let index = handle.into_raw_parts().0;
        self.tree.insert(standing_box(&ground.block, at), index);
        self.grounds.insert(index, ground);
        handle
    }

    fn take_out(&mut self, handle: ColliderHandle) -> Option<Block> {
        let index = handle.into_raw_parts().0;
        self.tree.remove(index);
        let ground = self.grounds.remove(&index);
        self.colliders.remove(
            handle,
            &mut self.islands,
            &mut self.bodies,
            &mut self.soft_bodies,
            false,
        );
        ground.map(|ground| ground.block)
    }

    /// Rapier notes what changed for its next step. This set is never stepped, so the notes would only grow; what
    /// moves is stepped among copies of the blocks near it.
    fn forget_changes(&mut self) {
        self.colliders.take_modified();
        self.colliders.take_removed();
    }
}

fn standing_box(block: &Block, at: DVec3) -> Aabb {
    let bounds = &block.bounds;
    let (skin, at) = (glam::Vec3::splat(BOX_SKIN_M), at.as_vec3());
    Aabb::new(bounds.mins + at - skin, bounds.maxs + at + skin)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use glam::IVec3;

    use super::*;

    #[test]
    fn terrain_is_found_in_the_order_of_the_chunks_not_of_their_arrival() {
        // A triangle of the low block and one of the high one.
        let positions = [
            [0.0, 0.0, 0.0],
            [0.0, 0.0, 32.0],
            [32.0, 0.0, 0.0],
            [32.0, 0.0, 32.0],
        ];
        let collider = TerrainCollider::build(&positions, &[[1, 3, 2], [0, 1, 2]]).unwrap();
        let mut world = ChartGround::new();
        for x in [3, -2, 1, 0, -1, 2] {
            let coord = ChunkCoord {
                chart: ChartId::FIRST,
                index: IVec3::new(x, 0, 0),
            };
            world.set_terrain(
                coord,
                DVec3::X * f64::from(x) * 32.0,
                Some(collider.clone()),
            );
        }
        let found = |min: f64, max: f64| -> Vec<i32> {
            let grounds = world.grounds_in(DVec3::new(min, -1.0, 1.0), DVec3::new(max, 1.0, 2.0));
            assert!(grounds.is_sorted_by_key(|ground| (ground.coord, ground.number)));
            let mut chunks: Vec<_> = grounds.iter().map(|ground| ground.coord.index.x).collect();
            chunks.dedup();
            chunks
        };
        assert_eq!(found(-500.0, 500.0), [-2, -1, 0, 1, 2, 3]);
        assert_eq!(found(-40.0, 40.0), [-2, -1, 0, 1]);
        assert_eq!(found(500.0, 900.0), [0; 0]);
    }

    #[test]
    fn what_stands_no_longer_is_handed_back_and_what_stays_is_not() {
        let square = |y: f32| [[0.0, y, 0.0], [0.0, y, 9.0], [9.0, y, 9.0], [9.0, y, 0.0]];
        let shape = |high: f32| {
            let positions = [square(1.0), square(high)].concat();
            [[0, 1, 2], [4, 5, 6]].map(|triangle| (positions.clone(), triangle))
        };
        let build = |before: Option<&TerrainCollider>, high: f32| {
            let [(positions, low), (_, top)] = shape(high);
            TerrainCollider::rebuild(before, &positions, &[low, top]).unwrap()
        };
        let (coord, at) = (ChunkCoord::new(ChartId::FIRST, IVec3::ZERO), DVec3::ZERO);
        let first = build(None, 20.0);
        let second = build(Some(&first), 25.0);
        let mut world = ChartGround::new();
        assert!(
            world
                .replace_terrain(coord, at, Some(first.clone()))
                .is_none()
        );
        assert!(
            world
                .replace_terrain(coord, at, Some(first.clone()))
                .is_none()
        );
        let removed = world
            .replace_terrain(coord, at, Some(second.clone()))
            .unwrap();
        assert_eq!(removed.shared_parts(&first), (1, 1), "the high block alone");
        assert_eq!(removed.shared_parts(&second), (0, 1));
        let removed = world.replace_terrain(coord, at, None).unwrap();
        assert_eq!(removed.shared_parts(&second), (2, 2));
    }
}
