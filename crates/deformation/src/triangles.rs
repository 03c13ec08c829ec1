//! Solids made of triangles, and the hierarchy of boxes by which a path finds the few that it may meet.
//!
//! The hierarchy is made by obvhs (PLOC with reinsertion: D. Meister and J. Bittner) of boxes in `f32` that are rounded
//! outwards; triangles are met in `f64` (T. Möller and B. Trumbore, 1997).

use glam::{DVec3, Vec3};
use obvhs::BvhBuildParams;
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::builder::build_bvh2;

use crate::scene::{SceneHit, SceneQuery};

/// Triangles in a leaf at most.
const LEAF: u32 = 4;

/// A triangle of an object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle {
    /// Its corners, metres of the scene.
    pub corners: [DVec3; 3],
    /// The object that it belongs to.
    pub object: u32,
}

/// A hierarchy of boxes. Node 0 is the root; children of an inner node follow each other.
#[derive(Clone, Default)]
pub struct Bvh {
    tree: Bvh2,
}

impl std::fmt::Debug for Bvh {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Bvh")
            .field("nodes", &self.tree.nodes.len())
            .finish_non_exhaustive()
    }
}

impl Bvh {
    /// Of boxes, each by its least and its greatest corner, with at most `most` of them in a leaf.
    pub fn with_leaves(boxes: &[(Vec3, Vec3)], most: u32) -> Self {
        if boxes.is_empty() {
            return Self::default();
        }
        let boxes: Vec<_> = boxes
            .iter()
            .map(|(low, high)| Aabb::new(low.to_array().into(), high.to_array().into()))
            .collect();
        let parameters = BvhBuildParams {
            max_prims_per_leaf: most,
            ..BvhBuildParams::fast_build()
        };
        let mut tree = build_bvh2(&boxes, parameters, &mut std::time::Duration::default());
        tree.reorder_in_stack_traversal_order();
        Self { tree }
    }

    /// Nodes: least corner, greatest corner, how many things a leaf holds (0 for an inner node), and where in
    /// [`Self::order`] they begin, or the number of the first of an inner node's two children.
    pub fn nodes(&self) -> impl ExactSizeIterator<Item = (Vec3, Vec3, u32, u32)> + '_ {
        self.tree.nodes.iter().map(|node| {
            let (low, high) = corners(&node.aabb);
            (low, high, node.prim_count, node.first_index)
        })
    }

    /// Levels that it has.
    pub fn depth(&self) -> usize {
        // Children follow their parents.
        let mut depths = vec![1; self.tree.nodes.len()];
        for (number, node) in self.tree.nodes.iter().enumerate() {
            if node.prim_count == 0 {
                let first = node.first_index as usize;
                let below = depths[number] + 1;
                depths[first..first + 2].fill(below);
            }
        }
        depths.into_iter().max().unwrap_or(0)
    }

    /// The numbers of the boxes in the order of the leaves.
    pub fn order(&self) -> &[u32] {
        &self.tree.primitive_indices
    }

    /// Shows every box of the leaves whose nodes pass `enter`, which is asked of a node's corners.
    fn visit(&self, mut enter: impl FnMut(DVec3, DVec3) -> bool, mut show: impl FnMut(u32)) {
        let mut waiting = Vec::with_capacity(64);
        if !self.tree.nodes.is_empty() {
            waiting.push(0);
        }
        while let Some(number) = waiting.pop() {
            let node = &self.tree.nodes[number as usize];
            let (low, high) = corners(&node.aabb);
            if !enter(low.as_dvec3(), high.as_dvec3()) {
                continue;
            }
            if node.prim_count == 0 {
                waiting.extend([node.first_index, node.first_index + 1]);
                continue;
            }
            let first = node.first_index as usize;
            for slot in first..first + node.prim_count as usize {
                show(self.tree.primitive_indices[slot]);
            }
        }
    }
}

/// Through arrays, since the library may be built with another version of glam.
fn corners(aabb: &Aabb) -> (Vec3, Vec3) {
    (aabb.min.to_array().into(), aabb.max.to_array().into())
}

/// Solids made of triangles.
#[derive(Clone, Debug, Default)]
pub struct Triangles {
    triangles: Vec<Triangle>,
    bvh: Bvh,
}

impl Triangles {
    /// Of a list. Numbers of parts in hits are those of this list.
    pub fn new(triangles: Vec<Triangle>) -> Self {
        let boxes: Vec<_> = triangles
            .iter()
            .map(|triangle| bounds(&triangle.corners))
            .collect();
        Self {
            bvh: Bvh::with_leaves(&boxes, LEAF),
            triangles,
        }
    }

    /// The triangles.
    pub fn triangles(&self) -> &[Triangle] {
        &self.triangles
    }

    /// As [`SceneQuery::first`], by asking every triangle: what tests compare with.
    pub fn first_of_all(&self, x: DVec3, v: DVec3, longest: f64) -> Option<SceneHit> {
        let hits =
            (0..self.triangles.len() as u32).filter_map(|part| self.meet(part, x, v, longest));
        hits.min_by(|a, b| a.time.total_cmp(&b.time))
    }

    fn meet(&self, part: u32, x: DVec3, v: DVec3, longest: f64) -> Option<SceneHit> {
        let triangle = &self.triangles[part as usize];
        let [a, b, c] = triangle.corners;
        let (ab, ac) = (b - a, c - a);
        let across = v.cross(ac);
        let volume = ab.dot(across);
        if volume == 0.0 {
            return None;
        }
        let from = x - a;
        let along_b = from.dot(across) / volume;
        let turned = from.cross(ab);
        let along_c = v.dot(turned) / volume;
        let time = ac.dot(turned) / volume;
        let is_met = along_b >= 0.0 && along_c >= 0.0 && along_b + along_c <= 1.0;
        (is_met && (0.0..=longest).contains(&time)).then(|| SceneHit {
            time,
            object: triangle.object,
            part,
            normal: ab.cross(ac).normalize(),
        })
    }
}

impl SceneQuery for Triangles {
    fn first(&self, x: DVec3, v: DVec3, longest: f64) -> Option<SceneHit> {
        let pace = v.to_array().map(|one| one.signum() / one.abs().max(1e-200));
        let inverse = DVec3::from_array(pace);
        let nearest = std::cell::Cell::new(longest);
        let mut found = None;
        let enter = |low: DVec3, high: DVec3| {
            let (a, b) = ((low - x) * inverse, (high - x) * inverse);
            let (enters, leaves) = (a.min(b).max_element(), a.max(b).min_element());
            enters <= leaves && leaves >= 0.0 && enters <= nearest.get()
        };
        self.bvh.visit(enter, |part| {
            if let Some(hit) = self.meet(part, x, v, nearest.get()) {
                nearest.set(hit.time);
                found = Some(hit);
            }
        });
        found
    }

    fn near(&self, low: DVec3, high: DVec3, show: &mut dyn FnMut([DVec3; 3])) {
        let enter = |from: DVec3, to: DVec3| from.cmple(high).all() && to.cmpge(low).all();
        self.bvh
            .visit(enter, |part| show(self.triangles[part as usize].corners));
    }
}

/// The corners of a triangle's box in `f32`, rounded outwards.
fn bounds(corners: &[DVec3; 3]) -> (Vec3, Vec3) {
    let [a, b, c] = corners;
    let (low, high) = (a.min(*b).min(*c), a.max(*b).max(*c));
    let down = |value: f64| (value as f32).next_down();
    let up = |value: f64| (value as f32).next_up();
    (
        Vec3::new(down(low.x), down(low.y), down(low.z)),
        Vec3::new(up(high.x), up(high.y), up(high.z)),
    )
}
