//! A hierarchy of boxes, by which the few things are found that a path may meet.
//!
//! It is cut where the surface area heuristic finds least to do (I. Wald, On fast construction of SAH-based bounding volume
//! hierarchies, 2007): boxes are counted in bins along each axis, and of all cuts between bins that with the least sum of
//! area times count is taken. It is our own because it is small and its numbers go to the adapter as they are.

use glam::{DVec3, Vec3};

/// Bins along an axis, and at most so many for each thing: most nodes hold few, and empty bins are all there is to look at then.
const BINS: usize = 16;
const BINS_EACH: usize = 2;
/// Below this level boxes are halved by number, so that no list of boxes can make the hierarchy deep.
const DEEPEST_CUT: usize = 40;
/// What a node costs, beside what is in a leaf.
const NODE_COST: f32 = 1.0;

/// A node: its box, and what is in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BvhNode {
    /// Least corner.
    pub low: Vec3,
    /// Greatest corner.
    pub high: Vec3,
    /// Things in a leaf; 0 for a node that has two children.
    pub count: u32,
    /// Where in [`Bvh::order`] the things begin, or the number of the first child, which the other follows.
    pub first: u32,
}

/// A hierarchy of boxes. Node 0 is the root; children come after their parents.
#[derive(Clone, Debug, Default)]
pub struct Bvh {
    nodes: Vec<BvhNode>,
    order: Vec<u32>,
}

#[derive(Clone, Copy)]
struct Extent {
    low: Vec3,
    high: Vec3,
}

impl Extent {
    const NONE: Self = Self {
        low: Vec3::INFINITY,
        high: Vec3::NEG_INFINITY,
    };

    fn grow(&mut self, low: Vec3, high: Vec3) {
        self.low = self.low.min(low);
        self.high = self.high.max(high);
    }

    fn half_area(&self) -> f32 {
        let edge = (self.high - self.low).max(Vec3::ZERO);
        edge.x * edge.y + edge.y * edge.z + edge.z * edge.x
    }
}

impl Bvh {
    /// Of boxes, each by its least and its greatest corner, with at most `most` of them in a leaf.
    pub fn with_leaves(boxes: &[(Vec3, Vec3)], most: u32) -> Self {
        let mut bvh = Self {
            // As many as there are at most in a hierarchy whose leaves hold one box each, or two.
            nodes: Vec::with_capacity(2 * boxes.len().div_ceil(most.clamp(1, 2) as usize)),
            order: (0..boxes.len() as u32).collect(),
        };
        if boxes.is_empty() {
            return bvh;
        }
        bvh.nodes.push(bvh.leaf(boxes, 0, boxes.len()));
        let mut waiting = vec![(0, 1)];
        while let Some((number, level)) = waiting.pop() {
            let BvhNode { count, first, .. } = bvh.nodes[number];
            let (begin, end) = (first as usize, (first + count) as usize);
            let Some(middle) = bvh.cut(boxes, (begin, end), most, level) else {
                continue;
            };
            let child = bvh.nodes.len();
            bvh.nodes.push(bvh.leaf(boxes, begin, middle));
            bvh.nodes.push(bvh.leaf(boxes, middle, end));
            (bvh.nodes[number].count, bvh.nodes[number].first) = (0, child as u32);
            waiting.extend([(child + 1, level + 1), (child, level + 1)]);
        }
        bvh
    }

    /// The nodes.
    pub fn nodes(&self) -> &[BvhNode] {
        &self.nodes
    }

    /// The nodes, and the numbers of the boxes in the order of the leaves.
    pub fn into_parts(self) -> (Vec<BvhNode>, Vec<u32>) {
        (self.nodes, self.order)
    }

    /// The numbers of the boxes in the order of the leaves.
    pub fn order(&self) -> &[u32] {
        &self.order
    }

    /// Shows every box of the leaves whose nodes pass `enter`, which is asked of a node's corners.
    pub(crate) fn visit(
        &self,
        mut enter: impl FnMut(DVec3, DVec3) -> bool,
        mut show: impl FnMut(u32),
    ) {
        let mut waiting = Vec::with_capacity(64);
        if !self.nodes.is_empty() {
            waiting.push(0);
        }
        while let Some(number) = waiting.pop() {
            let node = &self.nodes[number as usize];
            if !enter(node.low.as_dvec3(), node.high.as_dvec3()) {
                continue;
            }
            if node.count == 0 {
                waiting.extend([node.first, node.first + 1]);
                continue;
            }
            let first = node.first as usize;
            for number in &self.order[first..first + node.count as usize] {
                show(*number);
            }
        }
    }

    fn leaf(&self, boxes: &[(Vec3, Vec3)], begin: usize, end: usize) -> BvhNode {
        let mut extent = Extent::NONE;
        for number in &self.order[begin..end] {
            let (low, high) = boxes[*number as usize];
            extent.grow(low, high);
        }
        BvhNode {
            low: extent.low,
            high: extent.high,
            count: (end - begin) as u32,
            first: begin as u32,
        }
    }

    /// Parts a leaf's things in two where that saves work, or where they are too many; the number of the first thing of the
    /// second part.
    fn cut(
        &mut self,
        boxes: &[(Vec3, Vec3)],
        (begin, end): (usize, usize),
        most: u32,
        level: usize,
    ) -> Option<usize> {
        let count = end - begin;
        if count < 2 {
            return None;
        }
        let must = count > most.max(1) as usize;
        let middle_of = |number: u32| {
            let (low, high) = boxes[number as usize];
            low + high
        };
        let found = if level < DEEPEST_CUT {
            best_cut(boxes, &self.order[begin..end])
        } else {
            None
        };
        let halves = begin + count / 2;
        let Some(cut) = found else {
            return must.then_some(halves);
        };
        if !must && cut.cost >= count as f32 {
            return None;
        }
        let part = &mut self.order[begin..end];
        let mut low = 0;
        for at in 0..part.len() {
            if cut.is_before(middle_of(part[at])) {
                part.swap(low, at);
                low += 1;
            }
        }
        let is_parted = low > 0 && low < part.len();
        Some(if is_parted { begin + low } else { halves })
    }
}

/// Where things are parted: before a bin along an axis.
struct Cut {
    axis: usize,
    bin: usize,
    bins: usize,
    start: f32,
    scale: f32,
    /// Expected work, in things.
    cost: f32,
}

impl Cut {
    fn is_before(&self, middle: Vec3) -> bool {
        bin_of(middle[self.axis], self.start, self.scale, self.bins) < self.bin
    }
}

fn bin_of(middle: f32, start: f32, scale: f32, bins: usize) -> usize {
    (((middle - start) * scale) as usize).min(bins - 1)
}

/// The cut with the least expected work, if there is any that parts the things. Middles count doubled.
fn best_cut(boxes: &[(Vec3, Vec3)], things: &[u32]) -> Option<Cut> {
    let (mut middles, mut whole) = (Extent::NONE, Extent::NONE);
    for number in things {
        let (low, high) = boxes[*number as usize];
        middles.grow(low + high, low + high);
        whole.grow(low, high);
    }
    let count = BINS.min(BINS_EACH * things.len());
    let mut best: Option<Cut> = None;
    for axis in 0..3 {
        let (start, width) = (middles.low[axis], middles.high[axis] - middles.low[axis]);
        let scale = count as f32 / width;
        if width <= 0.0 || !scale.is_finite() {
            continue;
        }
        let mut bins = [(Extent::NONE, 0_u32); BINS];
        let bins = &mut bins[..count];
        for number in things {
            let (low, high) = boxes[*number as usize];
            let bin = &mut bins[bin_of(low[axis] + high[axis], start, scale, count)];
            bin.0.grow(low, high);
            bin.1 += 1;
        }
        let (bin, work) = cheapest(bins);
        let cost = NODE_COST + work / whole.half_area().max(f32::MIN_POSITIVE);
        if best.as_ref().is_none_or(|best| cost < best.cost) {
            best = Some(Cut {
                axis,
                bin,
                bins: count,
                start,
                scale,
                cost,
            });
        }
    }
    best
}

/// The bin before which to cut, and the sum of area times count of both sides there.
fn cheapest(bins: &[(Extent, u32)]) -> (usize, f32) {
    let mut after = [0.0; BINS];
    let (mut extent, mut count) = (Extent::NONE, 0);
    for (at, bin) in bins.iter().enumerate().rev() {
        extent.grow(bin.0.low, bin.0.high);
        count += bin.1;
        after[at] = extent.half_area() * count as f32;
    }
    let (mut extent, mut count) = (Extent::NONE, 0);
    let mut best = (1, f32::INFINITY);
    for at in 1..bins.len() {
        extent.grow(bins[at - 1].0.low, bins[at - 1].0.high);
        count += bins[at - 1].1;
        let work = extent.half_area() * count as f32 + after[at];
        if count > 0 && work < best.1 {
            best = (at, work);
        }
    }
    best
}
