//! The ground below a vehicle that stands in a door: that of both sides, each cut at the leaf.
//!
//! Both sides are written in the leaf's own axes, in which what passes keeps its place. With s the side of the leaf on which
//! this side lies, its triangles are kept where s x >= 0 and the other side's where s x <= 0; a triangle that the plane x = 0 cuts
//! becomes the polygon of its part, which is split into triangles again.

use antipode_geometry::{ChunkCoord, Leaf};
use glam::DVec3;
use rapier3d::parry::bounding_volume::Aabb;
use rapier3d::parry::shape::{SharedShape, TriMesh};

use super::cut::cut;
use super::doors::Junction;
use crate::PhysicsWorld;
use crate::chart_ground::Ground;
use crate::collider::Block;

/// Ground so far from a foot is taken in, metres: more than any part of a vehicle that stands in the door.
const AROUND_M: DVec3 = DVec3::new(6.5, 5.0, 6.5);
/// Each side reaches so far over the leaf, metres, that nothing falls between them.
const LAPS_M: f64 = 0.01;

/// A block that a sill is made of: of which side, and where.
type Source = (bool, ChunkCoord, usize, DVec3, Block);

/// Ground of both sides.
pub(super) struct Sill {
    junction: Junction,
    sources: Vec<Source>,
    /// In the own axes of the junction's leaf of this side.
    pub shape: Option<SharedShape>,
}

impl Sill {
    /// The ground of a junction. What was made before is kept while neither the doors nor their ground have changed; the flag says whether
    /// it was made anew.
    pub fn made(before: Option<Self>, world: &PhysicsWorld, junction: &Junction) -> (Self, bool) {
        let sides = [(false, &junction.host), (true, &junction.far)];
        let found: Vec<(bool, &Leaf, &Ground)> = sides
            .into_iter()
            .flat_map(|(is_far, leaf)| {
                let around = [leaf.foot.pos - AROUND_M, leaf.foot.pos + AROUND_M];
                let ground = world.chart(leaf.foot.chart);
                let all = ground.grounds_in(around[0], around[1]).into_iter();
                all.map(move |ground| (is_far, leaf, ground))
            })
            .collect();
        if let Some(before) = before
            && before.is_of(junction, &found)
        {
            return (before, false);
        }
        let source = |(is_far, _, it): &(bool, &Leaf, &Ground)| {
            (*is_far, it.coord, it.number(), it.origin, it.block.clone())
        };
        let mut triangles = Vec::new();
        for (is_far, leaf, ground) in &found {
            let side = if *is_far {
                -junction.side
            } else {
                junction.side
            };
            cut_block(leaf, ground, side, &mut triangles);
        }
        let made = Self {
            junction: *junction,
            sources: found.iter().map(source).collect(),
            shape: mesh(&triangles),
        };
        (made, true)
    }

    fn is_of(&self, junction: &Junction, found: &[(bool, &Leaf, &Ground)]) -> bool {
        let is_same = |(source, (is_far, _, it)): (&Source, &(bool, &Leaf, &Ground))| {
            (source.0, source.1, source.2, source.3) == (*is_far, it.coord, it.number(), it.origin)
                && source.4.is_like(&it.block)
        };
        self.junction == *junction
            && self.sources.len() == found.len()
            && self.sources.iter().zip(found).all(is_same)
    }
}

/// The triangles of a block near a leaf, in the leaf's own axes, as far as they lie on one side of it, and a little more.
fn cut_block(leaf: &Leaf, ground: &Ground, side: f64, out: &mut Vec<[DVec3; 3]>) {
    let Some(mesh) = ground.block.mesh() else {
        return;
    };
    let (low, high) = (
        leaf.foot.pos - AROUND_M - ground.origin,
        leaf.foot.pos + AROUND_M - ground.origin,
    );
    let near = Aabb::new(low.as_vec3(), high.as_vec3());
    let mut found: Vec<u32> = mesh.bvh().intersect_aabb(&near).collect();
    found.sort_unstable();
    let (vertices, indices) = (mesh.vertices(), mesh.indices());
    for id in found {
        let Some(corners) = indices.get(id as usize) else {
            continue;
        };
        let corners =
            corners.map(|at| leaf.local(vertices[at as usize].as_dvec3() + ground.origin));
        cut(corners, |at| side * at.x + LAPS_M, out);
    }
}

fn mesh(triangles: &[[DVec3; 3]]) -> Option<SharedShape> {
    let is_whole = |it: &&[DVec3; 3]| (it[1] - it[0]).cross(it[2] - it[0]).length() > 1e-9;
    let whole = triangles.iter().filter(is_whole);
    let corners: Vec<_> = whole.flatten().map(|it| it.as_vec3()).collect();
    let numbers = (0..corners.len() as u32 / 3).map(|it| [3 * it, 3 * it + 1, 3 * it + 2]);
    let mesh = TriMesh::new(corners, numbers.collect()).ok()?;
    Some(SharedShape::new(mesh))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_triangle_is_cut_at_the_leaf_and_its_parts_are_the_whole() {
        let corners = [
            DVec3::new(-1.0, 0.0, 0.0),
            DVec3::new(2.0, 1.0, 0.5),
            DVec3::new(-0.5, 0.2, 2.0),
        ];
        let area = |all: &[[DVec3; 3]]| -> f64 {
            let double = all.iter().map(|it| (it[1] - it[0]).cross(it[2] - it[0]));
            double.sum::<DVec3>().length()
        };
        let parts = [-1.0, 1.0].map(|side| {
            let mut out = Vec::new();
            cut(corners, |at| side * at.x + LAPS_M, &mut out);
            for at in out.iter().flatten() {
                assert!(side * at.x >= -LAPS_M - 1e-12, "{at}");
            }
            area(&out)
        });
        let whole = area(&[corners]);
        assert!(parts[0] > 0.2 * whole && parts[1] > 0.2 * whole);
        let more = (parts[0] + parts[1]) / whole;
        assert!((1.0..1.03).contains(&more), "{more}");
    }
}
