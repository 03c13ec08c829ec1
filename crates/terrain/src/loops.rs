//! The outlines of a seam in one coarse cell's face.
//!
//! The face has 3 x 3 fine samples, whose corners are the coarse ones. In it lie the contour that
//! the coarse cell's surface ends in and the one that the four fine faces beyond end in. Taken
//! one way and the other, and joined along the face's sides, they are closed loops: the outline
//! of what is solid on the coarse side only, counter-clockwise, less that of what is solid on the
//! fine side only. A side is joined by its own samples, so both faces at it join it alike.
//!
//! As in [`crate::tables`], solid corners of an ambiguous square are kept apart.

/// Most nodes that a face can have: twelve fine edges and four coarse ones.
pub(crate) const NODES: usize = 16;
const NONE: u8 = u8::MAX;

/// An edge between two of a face's samples, on which a contour may have a vertex.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Node {
    /// Lower end, 0..=2 along the row and across the rows.
    pub low: [usize; 2],
    /// Whether it runs along the row (0) or across (1).
    pub along: usize,
    /// One for fine edges, two for coarse ones.
    pub length: usize,
}

const fn node(u: usize, v: usize, along: usize, length: usize) -> Node {
    Node {
        low: [u, v],
        along,
        length,
    }
}

/// The edges of a face: those along rows, those across, and the four coarse ones.
pub(crate) const EDGES: [Node; NODES] = [
    node(0, 0, 0, 1),
    node(1, 0, 0, 1),
    node(0, 1, 0, 1),
    node(1, 1, 0, 1),
    node(0, 2, 0, 1),
    node(1, 2, 0, 1),
    node(0, 0, 1, 1),
    node(1, 0, 1, 1),
    node(2, 0, 1, 1),
    node(0, 1, 1, 1),
    node(1, 1, 1, 1),
    node(2, 1, 1, 1),
    node(0, 0, 0, 2),
    node(2, 0, 1, 2),
    node(0, 2, 0, 2),
    node(0, 0, 1, 2),
];

/// A square of samples, counter-clockwise.
struct Square {
    /// Its corners as samples `3 v + u`.
    corners: [u8; 4],
    /// The edge after each.
    edges: [u8; 4],
}

const fn square(corners: [u8; 4], edges: [u8; 4]) -> Square {
    Square { corners, edges }
}

const FINE: [Square; 4] = [
    square([0, 1, 4, 3], [0, 7, 2, 6]),
    square([1, 2, 5, 4], [1, 8, 3, 7]),
    square([3, 4, 7, 6], [2, 10, 4, 9]),
    square([4, 5, 8, 7], [3, 11, 5, 10]),
];
const COARSE: Square = square([0, 2, 8, 6], [12, 13, 14, 15]);
/// The edges along each side of the face.
const SIDES: [[u8; 3]; 4] = [[0, 1, 12], [8, 11, 13], [4, 5, 14], [6, 9, 15]];

/// The node that comes after each, for samples whose solid ones are bits `3 v + u`.
pub(crate) fn successors(solid: u16) -> [u8; NODES] {
    let mut next = [NONE; NODES];
    follow(solid, &COARSE, |out, back| next[out] = back as u8);
    for square in FINE {
        follow(solid, &square, |out, back| next[back] = out as u8);
    }
    for side in SIDES {
        join(solid, side.map(usize::from), &mut next);
    }
    next
}

/// Names the contours of a square: where the way round it leaves solid ground, and where it had
/// come in.
fn follow(solid: u16, square: &Square, mut contour: impl FnMut(usize, usize)) {
    let Square { corners, edges } = square;
    let is_solid = |n: usize| solid >> corners[n % 4] & 1 == 1;
    for n in 0..4 {
        if is_solid(n) && !is_solid(n + 1) {
            let mut first = n + 4;
            while is_solid(first) {
                first -= 1;
            }
            contour(usize::from(edges[n]), usize::from(edges[first % 4]));
        }
    }
}

/// Joins the two vertices on a side, if there are any: the one where a contour ends, with the
/// one where another begins.
fn join(solid: u16, side: [usize; 3], next: &mut [u8; NODES]) {
    let mut crossed = side.into_iter().filter(|&edge| crosses(solid, EDGES[edge]));
    if let (Some(a), Some(b)) = (crossed.next(), crossed.next()) {
        let (end, begin) = if next[a] == NONE { (a, b) } else { (b, a) };
        next[end] = begin as u8;
    }
}

fn crosses(solid: u16, edge: Node) -> bool {
    let low = 3 * edge.low[1] + edge.low[0];
    let high = low + edge.length * [1, 3][edge.along];
    (solid >> low ^ solid >> high) & 1 == 1
}

/// Calls `found` with each loop, as nodes in order.
pub(crate) fn each_loop(mut next: [u8; NODES], mut found: impl FnMut(&[u8])) {
    for first in 0..NODES {
        let mut nodes = [0; NODES];
        let (mut count, mut at) = (0, first);
        while let Some(after) = next.get_mut(at).filter(|after| **after != NONE) {
            nodes[count] = at as u8;
            count += 1;
            at = usize::from(std::mem::replace(after, NONE));
        }
        if count > 0 {
            found(&nodes[..count]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_case_is_loops_through_each_crossed_edge_once() {
        for solid in 0..512 {
            let mut seen = Vec::new();
            each_loop(successors(solid), |nodes| {
                assert!(nodes.len() > 2, "{solid:09b} {nodes:?}");
                let next = successors(solid);
                let (first, last) = (nodes[0], nodes[nodes.len() - 1]);
                assert_eq!(next[usize::from(last)], first, "{solid:09b} is closed");
                seen.extend_from_slice(nodes);
            });
            seen.sort_unstable();
            let crossed: Vec<_> = (0..NODES as u8)
                .filter(|&n| crosses(solid, EDGES[usize::from(n)]))
                .collect();
            assert_eq!(seen, crossed, "{solid:09b}");
        }
    }

    #[test]
    fn what_is_solid_on_the_coarse_side_only_is_outlined_counter_clockwise() {
        // Corners solid, the middles of the sides and of the face not: the coarse cell's face is
        // all solid and the fine ones keep only the corners.
        let next = successors(0b101_000_101);
        let mut loops = Vec::new();
        each_loop(next, |nodes| loops.push(nodes.to_vec()));
        assert_eq!(loops, [vec![0, 1, 8, 11, 5, 4, 9, 6]]);
    }
}
