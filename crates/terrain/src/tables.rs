//! The triangles of marching cubes.
//!
//! Corner `c` of a cell stands at `(c & 1, c >> 1 & 1, c >> 2)`; a case is the set of its solid
//! corners, corner `c` as bit `c`. The surface's loops follow from one rule for every face,
//! which looks at nothing but the face's own four corners: solid corners that share no edge of
//! an ambiguous face are kept apart. Two cells therefore always agree on the segments in their
//! common face, and meshes have no cracks. Of the ways to cut a loop into triangles the rows
//! take one without a diagonal in a face of the cell, where it could meet the neighbour's, and
//! with the shortest diagonals. Triangles run counter-clockwise seen from the air.

/// An edge of a cell: its lower corner, and the axis along which it runs.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Edge {
    /// Corner at the edge's lower end, 0..8.
    pub corner: usize,
    /// 0, 1, 2 for x, y, z.
    pub axis: usize,
}

const fn edge(corner: usize, axis: usize) -> Edge {
    Edge { corner, axis }
}

/// The twelve edges that [`TRIANGLES`] names.
pub(crate) const EDGES: [Edge; 12] = [
    edge(0, 0),
    edge(2, 0),
    edge(4, 0),
    edge(6, 0),
    edge(0, 1),
    edge(1, 1),
    edge(4, 1),
    edge(5, 1),
    edge(0, 2),
    edge(1, 2),
    edge(2, 2),
    edge(3, 2),
];

/// By case: edges, three to a triangle.
#[rustfmt::skip]
pub(crate) static TRIANGLES: [&[u8]; 256] = [
    &[],
    &[0, 4, 8],
    &[0, 9, 5],
    &[4, 8, 5, 8, 9, 5],
    &[1, 10, 4],
    &[0, 1, 8, 1, 10, 8],
    &[0, 9, 5, 1, 10, 4],
    &[1, 10, 5, 10, 8, 5, 8, 9, 5],
    &[1, 5, 11],
    &[0, 4, 8, 1, 5, 11],
    &[0, 9, 1, 9, 11, 1],
    &[1, 4, 11, 4, 8, 9, 4, 9, 11],
    &[4, 5, 10, 5, 11, 10],
    &[0, 5, 8, 5, 11, 10, 5, 10, 8],
    &[0, 9, 4, 9, 11, 4, 11, 10, 4],
    &[8, 9, 10, 9, 11, 10],
    &[2, 8, 6],
    &[0, 4, 2, 4, 6, 2],
    &[0, 9, 5, 2, 8, 6],
    &[2, 9, 6, 9, 5, 4, 9, 4, 6],
    &[1, 10, 4, 2, 8, 6],
    &[0, 1, 10, 0, 10, 2, 10, 6, 2],
    &[0, 9, 5, 1, 10, 4, 2, 8, 6],
    &[1, 10, 5, 10, 6, 2, 10, 2, 5, 2, 9, 5],
    &[1, 5, 11, 2, 8, 6],
    &[0, 4, 2, 4, 6, 2, 1, 5, 11],
    &[0, 9, 1, 9, 11, 1, 2, 8, 6],
    &[1, 4, 11, 4, 6, 11, 6, 2, 11, 2, 9, 11],
    &[2, 8, 6, 4, 5, 10, 5, 11, 10],
    &[0, 5, 2, 5, 11, 2, 11, 10, 2, 10, 6, 2],
    &[0, 9, 4, 9, 11, 4, 11, 10, 4, 2, 8, 6],
    &[2, 9, 6, 9, 11, 6, 11, 10, 6],
    &[2, 7, 9],
    &[0, 4, 8, 2, 7, 9],
    &[0, 2, 5, 2, 7, 5],
    &[2, 7, 8, 7, 5, 8, 5, 4, 8],
    &[1, 10, 4, 2, 7, 9],
    &[0, 1, 8, 1, 10, 8, 2, 7, 9],
    &[0, 2, 5, 2, 7, 5, 1, 10, 4],
    &[1, 10, 5, 10, 8, 5, 8, 2, 5, 2, 7, 5],
    &[1, 5, 11, 2, 7, 9],
    &[0, 4, 8, 1, 5, 11, 2, 7, 9],
    &[0, 2, 7, 0, 7, 1, 7, 11, 1],
    &[1, 4, 11, 4, 8, 2, 4, 2, 11, 2, 7, 11],
    &[2, 7, 9, 4, 5, 10, 5, 11, 10],
    &[0, 5, 8, 5, 11, 10, 5, 10, 8, 2, 7, 9],
    &[0, 2, 4, 2, 7, 11, 2, 11, 4, 11, 10, 4],
    &[2, 7, 8, 7, 11, 10, 7, 10, 8],
    &[6, 7, 8, 7, 9, 8],
    &[0, 4, 9, 4, 6, 9, 6, 7, 9],
    &[0, 8, 5, 8, 6, 7, 8, 7, 5],
    &[4, 6, 5, 6, 7, 5],
    &[1, 10, 4, 6, 7, 8, 7, 9, 8],
    &[0, 1, 9, 1, 10, 6, 1, 6, 9, 6, 7, 9],
    &[0, 8, 5, 8, 6, 7, 8, 7, 5, 1, 10, 4],
    &[1, 10, 5, 10, 6, 7, 10, 7, 5],
    &[1, 5, 11, 6, 7, 8, 7, 9, 8],
    &[0, 4, 9, 4, 6, 9, 6, 7, 9, 1, 5, 11],
    &[0, 8, 1, 8, 6, 1, 6, 7, 1, 7, 11, 1],
    &[1, 4, 11, 4, 6, 11, 6, 7, 11],
    &[4, 5, 10, 5, 11, 10, 6, 7, 8, 7, 9, 8],
    &[0, 5, 11, 0, 11, 6, 11, 10, 6, 0, 6, 9, 6, 7, 9],
    &[0, 8, 6, 0, 6, 11, 6, 7, 11, 0, 11, 4, 11, 10, 4],
    &[6, 7, 10, 7, 11, 10],
    &[3, 6, 10],
    &[0, 4, 8, 3, 6, 10],
    &[0, 9, 5, 3, 6, 10],
    &[3, 6, 10, 4, 8, 5, 8, 9, 5],
    &[1, 3, 4, 3, 6, 4],
    &[0, 1, 8, 1, 3, 8, 3, 6, 8],
    &[0, 9, 5, 1, 3, 4, 3, 6, 4],
    &[1, 3, 5, 3, 6, 8, 3, 8, 5, 8, 9, 5],
    &[1, 5, 11, 3, 6, 10],
    &[0, 4, 8, 1, 5, 11, 3, 6, 10],
    &[0, 9, 1, 9, 11, 1, 3, 6, 10],
    &[1, 4, 11, 4, 8, 9, 4, 9, 11, 3, 6, 10],
    &[3, 6, 11, 6, 4, 11, 4, 5, 11],
    &[0, 5, 8, 5, 11, 3, 5, 3, 8, 3, 6, 8],
    &[0, 9, 4, 9, 11, 4, 11, 3, 4, 3, 6, 4],
    &[3, 6, 11, 6, 8, 9, 6, 9, 11],
    &[2, 8, 3, 8, 10, 3],
    &[0, 4, 2, 4, 10, 2, 10, 3, 2],
    &[0, 9, 5, 2, 8, 3, 8, 10, 3],
    &[2, 9, 3, 9, 5, 3, 5, 4, 3, 4, 10, 3],
    &[1, 3, 4, 3, 2, 4, 2, 8, 4],
    &[0, 1, 2, 1, 3, 2],
    &[0, 9, 5, 1, 3, 4, 3, 2, 4, 2, 8, 4],
    &[1, 3, 5, 3, 2, 5, 2, 9, 5],
    &[1, 5, 11, 2, 8, 3, 8, 10, 3],
    &[0, 4, 2, 4, 10, 2, 10, 3, 2, 1, 5, 11],
    &[0, 9, 1, 9, 11, 1, 2, 8, 3, 8, 10, 3],
    &[1, 4, 11, 4, 10, 2, 10, 3, 2, 4, 2, 11, 2, 9, 11],
    &[2, 8, 3, 8, 4, 3, 4, 5, 3, 5, 11, 3],
    &[0, 5, 2, 5, 11, 2, 11, 3, 2],
    &[0, 9, 4, 9, 11, 4, 11, 3, 4, 3, 2, 4, 2, 8, 4],
    &[2, 9, 3, 9, 11, 3],
    &[2, 7, 9, 3, 6, 10],
    &[0, 4, 8, 2, 7, 9, 3, 6, 10],
    &[0, 2, 5, 2, 7, 5, 3, 6, 10],
    &[2, 7, 8, 7, 5, 8, 5, 4, 8, 3, 6, 10],
    &[1, 3, 4, 3, 6, 4, 2, 7, 9],
    &[0, 1, 8, 1, 3, 8, 3, 6, 8, 2, 7, 9],
    &[0, 2, 5, 2, 7, 5, 1, 3, 4, 3, 6, 4],
    &[1, 3, 5, 3, 6, 8, 3, 8, 5, 8, 2, 5, 2, 7, 5],
    &[1, 5, 11, 2, 7, 9, 3, 6, 10],
    &[0, 4, 8, 1, 5, 11, 2, 7, 9, 3, 6, 10],
    &[0, 2, 7, 0, 7, 1, 7, 11, 1, 3, 6, 10],
    &[1, 4, 11, 4, 8, 2, 4, 2, 11, 2, 7, 11, 3, 6, 10],
    &[2, 7, 9, 3, 6, 11, 6, 4, 11, 4, 5, 11],
    &[0, 5, 8, 5, 11, 3, 5, 3, 8, 3, 6, 8, 2, 7, 9],
    &[0, 2, 4, 2, 7, 11, 2, 11, 4, 11, 3, 4, 3, 6, 4],
    &[2, 7, 8, 7, 11, 8, 11, 3, 8, 3, 6, 8],
    &[3, 7, 10, 7, 9, 8, 7, 8, 10],
    &[0, 4, 9, 4, 10, 3, 4, 3, 9, 3, 7, 9],
    &[0, 8, 5, 8, 10, 5, 10, 3, 5, 3, 7, 5],
    &[3, 7, 10, 7, 5, 10, 5, 4, 10],
    &[1, 3, 4, 3, 7, 9, 3, 9, 4, 9, 8, 4],
    &[0, 1, 9, 1, 3, 9, 3, 7, 9],
    &[0, 8, 5, 8, 4, 3, 4, 1, 3, 8, 3, 5, 3, 7, 5],
    &[1, 3, 5, 3, 7, 5],
    &[1, 5, 11, 3, 7, 10, 7, 9, 8, 7, 8, 10],
    &[0, 4, 9, 4, 10, 3, 4, 3, 9, 3, 7, 9, 1, 5, 11],
    &[0, 8, 1, 8, 10, 7, 10, 3, 7, 8, 7, 1, 7, 11, 1],
    &[1, 4, 11, 4, 10, 7, 10, 3, 7, 4, 7, 11],
    &[3, 7, 9, 3, 9, 4, 9, 8, 4, 3, 4, 11, 4, 5, 11],
    &[0, 5, 3, 5, 11, 3, 0, 3, 9, 3, 7, 9],
    &[0, 8, 4, 3, 7, 11],
    &[3, 7, 11],
    &[3, 11, 7],
    &[0, 4, 8, 3, 11, 7],
    &[0, 9, 5, 3, 11, 7],
    &[3, 11, 7, 4, 8, 5, 8, 9, 5],
    &[1, 10, 4, 3, 11, 7],
    &[0, 1, 8, 1, 10, 8, 3, 11, 7],
    &[0, 9, 5, 1, 10, 4, 3, 11, 7],
    &[1, 10, 5, 10, 8, 5, 8, 9, 5, 3, 11, 7],
    &[1, 5, 3, 5, 7, 3],
    &[0, 4, 8, 1, 5, 3, 5, 7, 3],
    &[0, 9, 1, 9, 7, 1, 7, 3, 1],
    &[1, 4, 3, 4, 8, 3, 8, 9, 3, 9, 7, 3],
    &[3, 10, 7, 10, 4, 5, 10, 5, 7],
    &[0, 5, 8, 5, 7, 8, 7, 3, 8, 3, 10, 8],
    &[0, 9, 4, 9, 7, 3, 9, 3, 4, 3, 10, 4],
    &[3, 10, 7, 10, 8, 7, 8, 9, 7],
    &[2, 8, 6, 3, 11, 7],
    &[0, 4, 2, 4, 6, 2, 3, 11, 7],
    &[0, 9, 5, 2, 8, 6, 3, 11, 7],
    &[2, 9, 6, 9, 5, 4, 9, 4, 6, 3, 11, 7],
    &[1, 10, 4, 2, 8, 6, 3, 11, 7],
    &[0, 1, 10, 0, 10, 2, 10, 6, 2, 3, 11, 7],
    &[0, 9, 5, 1, 10, 4, 2, 8, 6, 3, 11, 7],
    &[1, 10, 5, 10, 6, 2, 10, 2, 5, 2, 9, 5, 3, 11, 7],
    &[1, 5, 3, 5, 7, 3, 2, 8, 6],
    &[0, 4, 2, 4, 6, 2, 1, 5, 3, 5, 7, 3],
    &[0, 9, 1, 9, 7, 1, 7, 3, 1, 2, 8, 6],
    &[1, 4, 3, 4, 6, 9, 6, 2, 9, 4, 9, 3, 9, 7, 3],
    &[2, 8, 6, 3, 10, 7, 10, 4, 5, 10, 5, 7],
    &[0, 5, 2, 5, 7, 10, 7, 3, 10, 5, 10, 2, 10, 6, 2],
    &[0, 9, 4, 9, 7, 3, 9, 3, 4, 3, 10, 4, 2, 8, 6],
    &[2, 9, 6, 9, 7, 10, 7, 3, 10, 9, 10, 6],
    &[2, 3, 9, 3, 11, 9],
    &[0, 4, 8, 2, 3, 9, 3, 11, 9],
    &[0, 2, 5, 2, 3, 5, 3, 11, 5],
    &[2, 3, 8, 3, 11, 5, 3, 5, 8, 5, 4, 8],
    &[1, 10, 4, 2, 3, 9, 3, 11, 9],
    &[0, 1, 8, 1, 10, 8, 2, 3, 9, 3, 11, 9],
    &[0, 2, 5, 2, 3, 5, 3, 11, 5, 1, 10, 4],
    &[1, 10, 5, 10, 8, 5, 8, 2, 5, 2, 3, 5, 3, 11, 5],
    &[1, 5, 3, 5, 9, 3, 9, 2, 3],
    &[0, 4, 8, 1, 5, 3, 5, 9, 3, 9, 2, 3],
    &[0, 2, 1, 2, 3, 1],
    &[1, 4, 3, 4, 8, 3, 8, 2, 3],
    &[2, 3, 9, 3, 10, 4, 3, 4, 9, 4, 5, 9],
    &[0, 5, 8, 5, 9, 3, 9, 2, 3, 5, 3, 8, 3, 10, 8],
    &[0, 2, 4, 2, 3, 4, 3, 10, 4],
    &[2, 3, 8, 3, 10, 8],
    &[3, 11, 6, 11, 9, 6, 9, 8, 6],
    &[0, 4, 9, 4, 6, 9, 6, 3, 9, 3, 11, 9],
    &[0, 8, 5, 8, 6, 3, 8, 3, 5, 3, 11, 5],
    &[3, 11, 6, 11, 5, 4, 11, 4, 6],
    &[1, 10, 4, 3, 11, 6, 11, 9, 6, 9, 8, 6],
    &[0, 1, 9, 1, 10, 6, 1, 6, 9, 6, 3, 9, 3, 11, 9],
    &[0, 8, 5, 8, 6, 3, 8, 3, 5, 3, 11, 5, 1, 10, 4],
    &[1, 10, 5, 10, 6, 5, 6, 3, 5, 3, 11, 5],
    &[1, 5, 3, 5, 9, 3, 9, 8, 3, 8, 6, 3],
    &[0, 4, 9, 4, 6, 9, 6, 3, 9, 3, 1, 9, 1, 5, 9],
    &[0, 8, 1, 8, 6, 1, 6, 3, 1],
    &[1, 4, 3, 4, 6, 3],
    &[3, 10, 4, 3, 4, 9, 4, 5, 9, 3, 9, 6, 9, 8, 6],
    &[0, 5, 9, 3, 10, 6],
    &[0, 8, 3, 8, 6, 3, 0, 3, 4, 3, 10, 4],
    &[3, 10, 6],
    &[6, 10, 7, 10, 11, 7],
    &[0, 4, 8, 6, 10, 7, 10, 11, 7],
    &[0, 9, 5, 6, 10, 7, 10, 11, 7],
    &[4, 8, 5, 8, 9, 5, 6, 10, 7, 10, 11, 7],
    &[1, 11, 4, 11, 7, 6, 11, 6, 4],
    &[0, 1, 8, 1, 11, 7, 1, 7, 8, 7, 6, 8],
    &[0, 9, 5, 1, 11, 4, 11, 7, 6, 11, 6, 4],
    &[1, 11, 7, 1, 7, 8, 7, 6, 8, 1, 8, 5, 8, 9, 5],
    &[1, 5, 10, 5, 7, 10, 7, 6, 10],
    &[0, 4, 8, 1, 5, 10, 5, 7, 10, 7, 6, 10],
    &[0, 9, 1, 9, 7, 1, 7, 6, 1, 6, 10, 1],
    &[1, 4, 8, 1, 8, 7, 8, 9, 7, 1, 7, 10, 7, 6, 10],
    &[4, 5, 6, 5, 7, 6],
    &[0, 5, 8, 5, 7, 8, 7, 6, 8],
    &[0, 9, 4, 9, 7, 6, 9, 6, 4],
    &[6, 8, 7, 8, 9, 7],
    &[2, 8, 7, 8, 10, 7, 10, 11, 7],
    &[0, 4, 2, 4, 10, 2, 10, 11, 2, 11, 7, 2],
    &[0, 9, 5, 2, 8, 7, 8, 10, 7, 10, 11, 7],
    &[2, 9, 5, 2, 5, 10, 5, 4, 10, 2, 10, 7, 10, 11, 7],
    &[1, 11, 4, 11, 7, 2, 11, 2, 4, 2, 8, 4],
    &[0, 1, 11, 0, 11, 2, 11, 7, 2],
    &[0, 9, 5, 1, 11, 4, 11, 7, 2, 11, 2, 4, 2, 8, 4],
    &[1, 11, 2, 11, 7, 2, 1, 2, 5, 2, 9, 5],
    &[1, 5, 10, 5, 7, 10, 7, 2, 10, 2, 8, 10],
    &[0, 4, 2, 4, 10, 2, 10, 1, 5, 10, 5, 2, 5, 7, 2],
    &[0, 9, 1, 9, 7, 1, 7, 2, 8, 7, 8, 1, 8, 10, 1],
    &[1, 4, 10, 2, 9, 7],
    &[2, 8, 7, 8, 4, 5, 8, 5, 7],
    &[0, 5, 2, 5, 7, 2],
    &[0, 9, 4, 9, 7, 4, 7, 2, 4, 2, 8, 4],
    &[2, 9, 7],
    &[2, 6, 9, 6, 10, 11, 6, 11, 9],
    &[0, 4, 8, 2, 6, 9, 6, 10, 11, 6, 11, 9],
    &[0, 2, 5, 2, 6, 10, 2, 10, 5, 10, 11, 5],
    &[2, 6, 10, 2, 10, 5, 10, 11, 5, 2, 5, 8, 5, 4, 8],
    &[1, 11, 4, 11, 9, 4, 9, 2, 4, 2, 6, 4],
    &[0, 1, 8, 1, 11, 6, 11, 9, 6, 9, 2, 6, 1, 6, 8],
    &[0, 2, 5, 2, 6, 11, 6, 4, 11, 4, 1, 11, 2, 11, 5],
    &[1, 11, 5, 2, 6, 8],
    &[1, 5, 10, 5, 9, 2, 5, 2, 10, 2, 6, 10],
    &[0, 4, 8, 1, 5, 10, 5, 9, 2, 5, 2, 10, 2, 6, 10],
    &[0, 2, 6, 0, 6, 1, 6, 10, 1],
    &[1, 4, 2, 4, 8, 2, 1, 2, 10, 2, 6, 10],
    &[2, 6, 9, 6, 4, 9, 4, 5, 9],
    &[0, 5, 8, 5, 9, 6, 9, 2, 6, 5, 6, 8],
    &[0, 2, 4, 2, 6, 4],
    &[2, 6, 8],
    &[8, 10, 9, 10, 11, 9],
    &[0, 4, 9, 4, 10, 11, 4, 11, 9],
    &[0, 8, 5, 8, 10, 5, 10, 11, 5],
    &[4, 10, 5, 10, 11, 5],
    &[1, 11, 4, 11, 9, 4, 9, 8, 4],
    &[0, 1, 9, 1, 11, 9],
    &[0, 8, 5, 8, 4, 11, 4, 1, 11, 8, 11, 5],
    &[1, 11, 5],
    &[1, 5, 10, 5, 9, 8, 5, 8, 10],
    &[0, 4, 9, 4, 10, 9, 10, 1, 9, 1, 5, 9],
    &[0, 8, 1, 8, 10, 1],
    &[1, 4, 10],
    &[4, 5, 8, 5, 9, 8],
    &[0, 5, 9],
    &[0, 8, 4],
    &[],
];

/// How the triangles of cells that are turned about the vertical are found in [`TRIANGLES`]. A loop can be cut in several
/// ways, so a row and the turned row of the turned case are not the same triangles: a chart that is turned against the
/// space would have other ground, by millimetres, than one that is not, where both have the same place.
#[derive(Debug)]
pub(crate) struct Turn {
    /// The case of a cell once it is turned into the space, by its case in the chart.
    pub cases: [u8; 256],
    /// Where in the chart the edges are that the rows name. Sixteen, so that no edge is out of bounds.
    pub slots: [Slot; 16],
}

/// Where among those of a column of cells an edge of a cell is.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Slot {
    /// The edges along an axis from one of the four columns of corners, x first: `4 * column + axis`.
    pub line: u8,
    /// 1 for the edges above the cell's lower corners, otherwise 0.
    pub upper: u8,
}

/// By quarter turns of the chart, as [`antipode_geometry::SquareFrame`] counts them.
pub(crate) static TURNS: [Turn; 4] = [turn(0), turn(1), turn(2), turn(3)];

/// The corner of the space that a chart's corner is: one quarter turn takes (x, z) to (z, 1 - x) within the cell.
const fn turned(corner: usize, quarter_turns: usize) -> usize {
    let (mut x, mut z) = (corner & 1, corner >> 2);
    let mut turns = 0;
    while turns < quarter_turns {
        (x, z) = (z, 1 - x);
        turns += 1;
    }
    x | corner & 2 | z << 2
}

const fn turn(quarter_turns: usize) -> Turn {
    let mut cases = [0; 256];
    let mut case = 0;
    while case < 256 {
        let mut corner = 0;
        while corner < 8 {
            cases[case] |= ((case >> corner & 1) as u8) << turned(corner, quarter_turns);
            corner += 1;
        }
        case += 1;
    }
    let edges = turned_edges(quarter_turns);
    let mut slots = [Slot { line: 0, upper: 0 }; 16];
    let mut n = 0;
    while n < edges.len() {
        let Edge { corner, axis } = EDGES[edges[n]];
        let column = corner & 1 | corner >> 1 & 2;
        slots[n] = Slot {
            line: (4 * column + axis) as u8,
            upper: (corner >> 1 & 1) as u8,
        };
        n += 1;
    }
    Turn { cases, slots }
}

/// What the edges that the rows name are called in the chart.
const fn turned_edges(quarter_turns: usize) -> [usize; 12] {
    let mut edges = [0; 12];
    let mut n = 0;
    while n < 12 {
        let Edge { corner, axis } = EDGES[n];
        let back = 4 - quarter_turns;
        let (a, b) = (turned(corner, back), turned(corner | 1 << axis, back));
        let (lower, along) = (a & b, (a ^ b).trailing_zeros() as usize);
        while EDGES[edges[n]].corner != lower || EDGES[edges[n]].axis != along {
            edges[n] += 1;
        }
        n += 1;
    }
    edges
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every case has the triangles of the case that it is turned into, in their order, and other edges in none.
    #[test]
    fn turned_cells_have_the_triangles_of_the_space() {
        for (quarter_turns, turn) in TURNS.iter().enumerate() {
            let edges = turned_edges(quarter_turns);
            for case in 0..256 {
                let row = TRIANGLES[usize::from(turn.cases[case])];
                for &named in row {
                    let both: [_; 2] = ends(edges[usize::from(named)] as u8).into();
                    assert_ne!(case >> both[0] & 1, case >> both[1] & 1, "{case} {named}");
                    let (a, b) = ends(named);
                    let mut there = both.map(|end| turned(end, quarter_turns));
                    there.sort_unstable();
                    assert_eq!(there, [a, b], "{case} {named}");
                }
            }
        }
        assert!((0..256).all(|case| usize::from(TURNS[0].cases[case]) == case));
    }

    /// Corners at both ends of an edge.
    fn ends(edge: u8) -> (usize, usize) {
        let Edge { corner, axis } = EDGES[usize::from(edge)];
        (corner, corner | 1 << axis)
    }

    /// Whether all these edges lie in one face of the cell.
    fn share_a_face(edges: &[u8]) -> bool {
        (0..3).any(|axis| {
            (0..2).any(|side| {
                edges.iter().all(|&edge| {
                    let (a, b) = ends(edge);
                    a >> axis & 1 == side && b >> axis & 1 == side
                })
            })
        })
    }

    #[test]
    fn every_case_uses_exactly_the_edges_that_change_sign() {
        for (case, row) in TRIANGLES.iter().enumerate() {
            for edge in 0..12 {
                let (a, b) = ends(edge);
                let crosses = case >> a & 1 != case >> b & 1;
                assert_eq!(row.contains(&edge), crosses, "case {case} edge {edge}");
            }
        }
    }

    #[test]
    fn the_border_of_every_case_lies_in_faces_and_nothing_else_does() {
        for (case, row) in TRIANGLES.iter().enumerate() {
            let mut sides = std::collections::BTreeMap::new();
            for t in row.as_chunks::<3>().0 {
                for (a, b) in [(t[0], t[1]), (t[1], t[2]), (t[2], t[0])] {
                    *sides.entry((a, b)).or_insert(0) += 1;
                }
            }
            for (&(a, b), &count) in &sides {
                assert_eq!(count, 1, "case {case}: {a} to {b} twice the same way");
                let inner = sides.contains_key(&(b, a));
                assert_ne!(inner, share_a_face(&[a, b]), "case {case}: {a} to {b}");
            }
        }
    }
}
