//! Hierarchies of boxes as the shaders walk them: a node has the boxes of both of its children, so that one place is read for
//! each step down. What a child is stands in one number: another node, triangles, or an instance of a mesh.

use antipode_deformation::{Bvh, BvhNode};
use bytemuck::{Pod, Zeroable};
use glam::Vec3;

/// Added to the number of a leaf's first triangle; the last of them is marked.
pub const TRIANGLES: u32 = 0x4000_0000;
/// Added to the number of an instance.
pub const INSTANCE: u32 = 0x8000_0000;
/// No child.
pub const NOTHING: u32 = u32::MAX;
/// What nodes take up in their texture.
pub const NODE_TEXELS: usize = 4;

/// A node, as scene.wgsl has it: four texels.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Node {
    low: Vec3,
    child: u32,
    high: Vec3,
    other_child: u32,
    other_low: Vec3,
    room: u32,
    other_high: Vec3,
    room_too: u32,
}

/// A hierarchy over a list of boxes.
#[derive(Clone, Debug, Default)]
pub struct Tree {
    nodes: Vec<BvhNode>,
    order: Vec<u32>,
    /// For each node how many that have children are before it.
    numbers: Vec<u32>,
    inner: usize,
}

impl Tree {
    /// Over boxes, each by its least and its greatest corner, with at most `most` of them in a leaf.
    pub fn new(boxes: &[(Vec3, Vec3)], most: u32) -> Self {
        let bvh = Bvh::with_leaves(boxes, most);
        let mut inner = 0;
        let numbers = bvh.nodes().iter().map(|node| {
            inner += u32::from(node.count == 0);
            inner - u32::from(node.count == 0)
        });
        let numbers = numbers.collect();
        let (nodes, order) = bvh.into_parts();
        Self {
            nodes,
            order,
            numbers,
            inner: inner as usize,
        }
    }

    /// A single leaf of all boxes.
    pub fn leaf(boxes: &[(Vec3, Vec3)]) -> Self {
        let Some((low, high)) = boxes.first().copied() else {
            return Self::default();
        };
        let leaf = BvhNode {
            low,
            high,
            count: boxes.len() as u32,
            first: 0,
        };
        let mut tree = Self {
            nodes: vec![leaf],
            order: (0..leaf.count).collect(),
            numbers: vec![0],
            inner: 0,
        };
        tree.refit(boxes);
        tree
    }

    /// Numbers of the boxes in the order of the leaves.
    pub fn order(&self) -> &[u32] {
        &self.order
    }

    /// Nodes that [`Self::packed`] makes.
    pub fn node_count(&self) -> usize {
        self.inner
    }

    /// Of each place in the order whether a leaf ends there.
    pub fn ends(&self) -> Vec<bool> {
        let mut ends = vec![false; self.order.len()];
        for leaf in self.nodes.iter().filter(|node| node.count > 0) {
            ends[(leaf.first + leaf.count) as usize - 1] = true;
        }
        ends
    }

    /// The box of all.
    pub fn bounds(&self) -> Option<(Vec3, Vec3)> {
        self.nodes.first().map(|root| (root.low, root.high))
    }

    /// The same leaves about boxes that have moved.
    pub fn refit(&mut self, boxes: &[(Vec3, Vec3)]) {
        // Children come after their parents.
        for at in (0..self.nodes.len()).rev() {
            let BvhNode { first, count, .. } = self.nodes[at];
            let first = first as usize;
            let mut extent = (Vec3::INFINITY, Vec3::NEG_INFINITY);
            let mut grow = |low: Vec3, high: Vec3| {
                extent = (extent.0.min(low), extent.1.max(high));
            };
            if count == 0 {
                let children = &self.nodes[first..first + 2];
                for child in children {
                    grow(child.low, child.high);
                }
            } else {
                for number in &self.order[first..first + count as usize] {
                    let (low, high) = boxes[*number as usize];
                    grow(low, high);
                }
            }
            (self.nodes[at].low, self.nodes[at].high) = extent;
        }
    }

    /// What the root is, and the nodes, the first of which has the number `base`. `leaf` says what a leaf is whose things
    /// begin there in the order.
    pub fn packed(&self, base: u32, leaf: impl Fn(u32) -> u32) -> (u32, Vec<Node>) {
        let what = |number: usize| {
            let node = &self.nodes[number];
            if node.count == 0 {
                base + self.numbers[number]
            } else {
                leaf(node.first)
            }
        };
        if self.nodes.is_empty() {
            return (NOTHING, Vec::new());
        }
        let parents = self.nodes.iter().filter(|node| node.count == 0);
        let pairs = parents.map(|parent| {
            let first = parent.first as usize;
            let (one, other) = (&self.nodes[first], &self.nodes[first + 1]);
            Node {
                low: one.low,
                child: what(first),
                high: one.high,
                other_child: what(first + 1),
                other_low: other.low,
                other_high: other.high,
                ..Node::default()
            }
        });
        (what(0), pairs.collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Boxes that the hierarchy leads to from a child, by their numbers.
    fn reached(nodes: &[Node], order: &[u32], child: u32, found: &mut Vec<u32>) {
        if child >= TRIANGLES {
            found.push(order[(child - TRIANGLES) as usize]);
            return;
        }
        let node = nodes[child as usize];
        for (low, high, next) in [
            (node.low, node.high, node.child),
            (node.other_low, node.other_high, node.other_child),
        ] {
            let before = found.len();
            reached(nodes, order, next, found);
            for number in &found[before..] {
                let (from, to) = place(*number);
                assert!(from.cmpge(low).all() && to.cmple(high).all());
            }
        }
    }

    fn place(number: u32) -> (Vec3, Vec3) {
        let low = Vec3::new(
            (number * 37 % 101) as f32,
            (number % 7) as f32,
            number as f32,
        );
        (low, low + Vec3::ONE)
    }

    #[test]
    fn every_box_is_reached_through_boxes_that_hold_it() {
        let moved: Vec<_> = (0..100).map(place).collect();
        let along = (0..100).map(|n| (Vec3::splat(n as f32), Vec3::splat(n as f32 + 0.5)));
        let mut refitted = Tree::new(&along.collect::<Vec<_>>(), 1);
        refitted.refit(&moved);
        for tree in [Tree::new(&moved, 1), refitted] {
            let (root, nodes) = tree.packed(0, |first| TRIANGLES + first);
            let mut found = Vec::new();
            reached(&nodes, tree.order(), root, &mut found);
            found.sort_unstable();
            assert!(found.into_iter().eq(0..100));
        }
    }

    #[test]
    fn few_boxes_need_no_nodes() {
        assert_eq!(Tree::new(&[], 1).packed(5, |first| first).0, NOTHING);
        let one = Tree::new(&[place(3)], 4);
        assert_eq!(
            one.packed(5, |first| TRIANGLES + first),
            (TRIANGLES, vec![])
        );
        assert_eq!(one.ends(), [true]);
        assert_eq!(
            Tree::leaf(&[place(1), place(2), place(3)]).ends(),
            [false, false, true]
        );
    }
}
