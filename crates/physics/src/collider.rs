//! Terrain as the physics sees it: triangle meshes with their bounding-volume trees.
//!
//! Building the trees is the costly part, so a collider is built on a chunk worker and then only
//! handed over: it is `Send + Sync` and a clone shares the meshes. A chunk's ground is cut into
//! eight blocks of 16 m with a tree each, so that an edit builds anew only those it has changed: the
//! cost of a tree grows faster than the number of its triangles, and a brush is smaller than a block.

use glam::Vec3;
use rapier3d::parry::bounding_volume::Aabb;
use rapier3d::parry::shape::{SharedShape, TriMesh};

/// Triangles with less than twice this area (m^2) are points or lines to the physics.
const LEAST_DOUBLE_AREA_M2: f32 = 1e-9;

/// Blocks of a collider: two along each axis.
pub(crate) const BLOCKS: usize = 8;

/// Edge of a block (m): half of a chunk's. Triangles farther out belong to the outermost blocks.
const BLOCK_M: f32 = 16.0;

/// One eighth of a collider.
#[derive(Clone)]
pub(crate) struct Block {
    pub shape: SharedShape,
    pub bounds: Aabb,
}

impl Block {
    fn build(vertices: Vec<Vec3>, triangles: Vec<[u32; 3]>) -> Option<Self> {
        let mesh = TriMesh::new(vertices, triangles).ok()?;
        let bounds = mesh.local_aabb();
        Some(Self {
            shape: SharedShape::new(mesh),
            bounds,
        })
    }

    /// Its triangles, in metres from the corner of the chunk; nothing of a shape that is no mesh.
    pub fn mesh(&self) -> Option<&TriMesh> {
        self.shape.as_trimesh()
    }

    /// Whether both are the same mesh in memory.
    pub fn is(&self, other: &Self) -> bool {
        std::ptr::addr_eq(self.shape.0.as_ref(), other.shape.0.as_ref())
    }

    /// Whether both are the same ground, though one may have been made anew: land that was let go of and came again must not
    /// end the contacts of what stands on it.
    pub fn is_like(&self, other: &Self) -> bool {
        let same = |other: &TriMesh| self.has(other.vertices(), other.indices());
        self.is(other) || other.mesh().is_some_and(same)
    }

    fn has(&self, vertices: &[Vec3], triangles: &[[u32; 3]]) -> bool {
        self.mesh()
            .is_some_and(|mesh| mesh.indices() == triangles && mesh.vertices() == vertices)
    }
}

/// The collision mesh of one chunk, in metres from the chunk's origin. Cheap to clone.
#[derive(Clone)]
pub struct TerrainCollider {
    blocks: [Option<Block>; BLOCKS],
}

impl TerrainCollider {
    /// Builds a collider from vertices in metres (local to the chunk) and triangles that index
    /// them, counter-clockwise seen from the air: the character stands on that side only.
    ///
    /// Degenerate triangles, and those with an index out of range or a vertex that is not finite,
    /// are left out. Returns `None` when no triangle remains.
    pub fn build(positions: &[[f32; 3]], triangles: &[[u32; 3]]) -> Option<Self> {
        Self::rebuild(None, positions, triangles)
    }

    /// As [`build`](Self::build), but takes over from what the chunk had `before` every part that
    /// is still the same. Gives the same collider either way.
    pub fn rebuild(
        before: Option<&Self>,
        positions: &[[f32; 3]],
        triangles: &[[u32; 3]],
    ) -> Option<Self> {
        let mut places = vec![u32::MAX; positions.len()];
        let mut sorted: [Vec<[u32; 3]>; BLOCKS] = Default::default();
        for &triangle in triangles {
            if let Some(block) = block_of(positions, triangle) {
                sorted[block].push(triangle);
            }
        }
        let mut number = 0;
        let blocks = sorted.map(|triangles| {
            let old = before.and_then(|before| before.blocks[number].as_ref());
            number += 1;
            let (vertices, triangles) = own(positions, triangles, &mut places);
            match old {
                Some(old) if old.has(&vertices, &triangles) => Some(old.clone()),
                _ => Block::build(vertices, triangles),
            }
        });
        Self::of(blocks)
    }

    /// The collider of some blocks; `None` if there are none.
    pub(crate) fn of(blocks: [Option<Block>; BLOCKS]) -> Option<Self> {
        blocks
            .iter()
            .any(Option::is_some)
            .then_some(Self { blocks })
    }

    /// How many triangles the mesh holds.
    pub fn triangle_count(&self) -> usize {
        let meshes = self.blocks.iter().flatten().filter_map(Block::mesh);
        meshes.map(TriMesh::num_triangles).sum()
    }

    /// How many of the parts it is made of are the very ones of `other`, and how many it has.
    pub fn shared_parts(&self, other: &Self) -> (usize, usize) {
        let pairs = self.blocks.iter().zip(&other.blocks);
        let shared = pairs.filter(|pair| matches!(pair, (Some(a), Some(b)) if a.is(b)));
        (shared.count(), self.blocks.iter().flatten().count())
    }

    pub(crate) fn blocks(&self) -> &[Option<Block>; BLOCKS] {
        &self.blocks
    }
}

impl std::fmt::Debug for TerrainCollider {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("TerrainCollider")
            .field("triangles", &self.triangle_count())
            .finish_non_exhaustive()
    }
}

/// The block that a triangle's middle lies in; `None` if it is unsound.
fn block_of(positions: &[[f32; 3]], triangle: [u32; 3]) -> Option<usize> {
    let [a, b, c] = triangle.map(|index| positions.get(index as usize).map(|&p| Vec3::from(p)));
    let (a, b, c) = (a?, b?, c?);
    let double_area = (b - a).cross(c - a).length();
    if !double_area.is_finite() || double_area <= LEAST_DOUBLE_AREA_M2 {
        return None;
    }
    let high = (a + b + c).cmpge(Vec3::splat(3.0 * BLOCK_M));
    Some(high.bitmask() as usize)
}

/// The vertices that some triangles use, in the order of their first use, and the triangles that
/// index those. `places` is `u32::MAX` throughout, before and after.
fn own(
    positions: &[[f32; 3]],
    mut triangles: Vec<[u32; 3]>,
    places: &mut [u32],
) -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let mut used = Vec::with_capacity(triangles.len() / 2 + 3);
    for index in triangles.as_flattened_mut() {
        let place = &mut places[*index as usize];
        if *place == u32::MAX {
            *place = used.len() as u32;
            used.push(*index);
        }
        *index = *place;
    }
    let vertices = used
        .into_iter()
        .map(|index| {
            places[index as usize] = u32::MAX;
            Vec3::from(positions[index as usize])
        })
        .collect();
    (vertices, triangles)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use super::*;

    const SQUARE: [[f32; 3]; 4] = [
        [0.0, 0.0, 0.0],
        [0.0, 0.0, 1.0],
        [1.0, 0.0, 1.0],
        [1.0, 0.0, 0.0],
    ];

    /// Ground of 32 by 32 squares at a height for each corner.
    fn ground(height: impl Fn(u32, u32) -> f32) -> (Vec<[f32; 3]>, Vec<[u32; 3]>) {
        let corners = (0..33).flat_map(|x| (0..33).map(move |z| (x, z)));
        let positions = corners.map(|(x, z)| [x as f32, height(x, z), z as f32]);
        let squares = (0..32).flat_map(|x| (0..32).map(move |z| x * 33 + z));
        let triangles = squares.flat_map(|at| [[at, at + 1, at + 34], [at, at + 34, at + 33]]);
        (positions.collect(), triangles.collect())
    }

    #[test]
    fn a_collider_crosses_threads_and_shares_its_mesh() {
        fn crosses<T: Send + Sync + Clone + 'static>(_: &T) {}
        let collider = TerrainCollider::build(&SQUARE, &[[0, 1, 2], [0, 2, 3]]).unwrap();
        crosses(&collider);
        let copy = collider.clone();
        assert_eq!(copy.shared_parts(&collider), (1, 1));
        assert_eq!(copy.triangle_count(), 2);
    }

    #[test]
    fn unsound_triangles_are_left_out() {
        let mut points = SQUARE.to_vec();
        points.push([f32::NAN, 0.0, 0.0]);
        let triangles = [[0, 1, 2], [0, 0, 1], [0, 1, 4], [0, 1, 99]];
        assert_eq!(
            TerrainCollider::build(&points, &triangles)
                .unwrap()
                .triangle_count(),
            1
        );
    }

    #[test]
    fn nothing_to_stand_on_is_no_collider() {
        assert!(TerrainCollider::build(&[], &[]).is_none());
        assert!(TerrainCollider::build(&SQUARE, &[[1, 1, 1]]).is_none());
    }

    #[test]
    fn every_triangle_is_in_one_block_and_in_its_place() {
        let (positions, triangles) = ground(|x, z| 14.0 + ((x * 7 + z * 3) % 5) as f32);
        let collider = TerrainCollider::build(&positions, &triangles).unwrap();
        let mut found: Vec<[[u32; 3]; 3]> = Vec::new();
        for block in collider.blocks.iter().flatten() {
            let mesh = block.mesh().unwrap();
            let corner =
                |&index: &u32| mesh.vertices()[index as usize].to_array().map(f32::to_bits);
            found.extend(mesh.indices().iter().map(|t| t.each_ref().map(corner)));
        }
        let corner = |index: u32| positions[index as usize].map(f32::to_bits);
        let mut want: Vec<_> = triangles.iter().map(|t| t.map(corner)).collect();
        found.sort_unstable();
        want.sort_unstable();
        assert_eq!(found, want);
        assert_eq!(collider.triangle_count(), triangles.len());
    }

    #[test]
    fn after_a_change_only_the_blocks_it_touches_are_built_anew() {
        let (positions, triangles) = ground(|_, _| 8.0);
        let before = TerrainCollider::build(&positions, &triangles).unwrap();
        let (dug, triangles) = ground(|x, z| if x + z < 6 { 6.0 } else { 8.0 });
        let after = TerrainCollider::rebuild(Some(&before), &dug, &triangles).unwrap();
        assert_eq!(after.shared_parts(&before), (3, 4));
        let same = TerrainCollider::rebuild(Some(&after), &dug, &triangles).unwrap();
        assert_eq!(same.shared_parts(&after), (4, 4));
        let fresh = TerrainCollider::build(&dug, &triangles).unwrap();
        let vertices = |c: &TerrainCollider| {
            let blocks = c.blocks.iter().flatten();
            blocks
                .map(|b| b.mesh().unwrap().vertices().to_vec())
                .collect::<Vec<_>>()
        };
        assert_eq!(vertices(&fresh), vertices(&after));
    }
}
