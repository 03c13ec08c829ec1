//! Seams: flat triangles in a chunk's faces that close the gap to neighbours of half its step.
//!
//! A seam's outline is the neighbour's contour on the face one way and the chunk's own the other
//! ([`crate::loops`]). Positions come from the samples of the face as the neighbour has them, by
//! the function that makes its vertices, so no crack is left, however narrow.

use antipode_geometry::CHUNK_CELLS;
use std::ops::Range;

use crate::crossings::{Reach, solid_bits};
use crate::loops::{EDGES, NODES, Node, each_loop, successors};
use crate::maker::{Maker, place_on_edge};
use crate::mesh::{PARTS_PER_M, Vertex};
use crate::samples::FACE_AXES;

/// A chunk's length in parts of position.
const CHUNK_PARTS: u32 = CHUNK_CELLS as u32 * PARTS_PER_M;
const NO_VERTEX: u32 = u32::MAX;

/// Makes seams; what it holds is kept from chunk to chunk only for its room.
#[derive(Debug, Default)]
pub(crate) struct SeamMesher {
    /// The solid samples of a face, a row in one word.
    rows: Vec<u64>,
    /// Vertices by their edge: see [`Face::slot`].
    known: Vec<u32>,
}

/// One face of the chunk.
#[derive(Clone, Copy)]
struct Face<'a> {
    number: usize,
    values: &'a [f32],
    /// Samples in a row.
    side: usize,
    /// Parts from sample to sample.
    spacing: u32,
}

/// A corner of a seam: where it is in the face, parts, and its vertex.
#[derive(Debug, Clone, Copy, Default)]
struct Corner {
    at: [i64; 2],
    vertex: u32,
}

impl Face<'_> {
    fn axis(&self) -> usize {
        self.number / 2
    }

    fn plane(&self) -> u32 {
        CHUNK_PARTS * (self.number % 2) as u32
    }

    /// Whether loops run the other way: the nearer face looks down its axis, and rows and
    /// columns across z are a left-handed pair.
    fn is_turned(&self) -> bool {
        self.number.is_multiple_of(2) != (self.axis() == 2)
    }

    /// The place of an edge in the table of vertices, coarse edges after the fine ones.
    fn slot(&self, edge: Node) -> usize {
        let corner = (edge.length - 1) * self.side * self.side + edge.low[1] * self.side;
        2 * (corner + edge.low[0]) + edge.along
    }

    fn slots(&self) -> usize {
        4 * self.side * self.side
    }

    /// The edge of a coarse cell on which a vertex of the chunk's surface lies, if it does so in
    /// this face.
    fn coarse_edge(&self, vertex: &Vertex) -> Option<Node> {
        let axis = self.axis();
        let place = vertex.place();
        if place[axis] != self.plane() {
            return None;
        }
        let (row, rows) = FACE_AXES[axis];
        let at = [place[row], place[rows]];
        let length = 2 * self.spacing;
        Some(Node {
            low: at.map(|c| 2 * (c / length) as usize),
            along: usize::from(at[0].is_multiple_of(length)),
            length: 2,
        })
    }

    /// Where the contour crosses an edge of the face.
    fn place(&self, edge: Node) -> [u32; 3] {
        let low = edge.low[1] * self.side + edge.low[0];
        let high = low + edge.length * [1, self.side][edge.along];
        let length = self.spacing * edge.length as u32;
        let mut at = edge.low.map(|c| c as u32 * self.spacing);
        at[edge.along] += place_on_edge(self.values[low], self.values[high], length);
        let (row, rows) = FACE_AXES[self.axis()];
        let mut place = [self.plane(); 3];
        (place[row], place[rows]) = (at[0], at[1]);
        place
    }

    fn corner(&self, index: u32, vertices: &[Vertex]) -> Corner {
        let (row, rows) = FACE_AXES[self.axis()];
        let place = vertices[index as usize].place();
        Corner {
            at: [row, rows].map(|axis| i64::from(place[axis])),
            vertex: index,
        }
    }
}

impl SeamMesher {
    /// Adds the seams of a chunk to the vertices and indices of its surface: for each face the
    /// range of its indices.
    pub(crate) fn sew(
        &mut self,
        maker: &Maker<'_>,
        reach: &Reach,
        vertices: &mut Vec<Vertex>,
        indices: &mut Vec<u32>,
    ) -> [Range<u32>; 6] {
        let samples = maker.samples();
        let Some(finer) = samples.level().finer() else {
            return Default::default();
        };
        let surface = vertices.len();
        std::array::from_fn(|number| {
            let face = Face {
                number,
                values: samples.face(number),
                side: samples.face_side(),
                spacing: finer.step_m() * PARTS_PER_M,
            };
            let first = indices.len() as u32;
            if self.read(&face) {
                self.know(&face, &vertices[..surface]);
                self.sew_face(&face, maker, reach, vertices, indices);
            }
            first..indices.len() as u32
        })
    }

    /// Takes the signs of a face's samples, and says whether they differ.
    fn read(&mut self, face: &Face<'_>) -> bool {
        self.rows.clear();
        let rows = face.values.chunks_exact(face.side).map(solid_bits);
        self.rows.extend(rows);
        let all = (1 << face.side) - 1;
        self.rows.iter().any(|&row| row != 0) && self.rows.iter().any(|&row| row != all)
    }

    fn know(&mut self, face: &Face<'_>, surface: &[Vertex]) {
        self.known.clear();
        self.known.resize(face.slots(), NO_VERTEX);
        for (n, vertex) in surface.iter().enumerate() {
            if let Some(edge) = face.coarse_edge(vertex) {
                self.known[face.slot(edge)] = n as u32;
            }
        }
    }

    fn sew_face(
        &mut self,
        face: &Face<'_>,
        maker: &Maker<'_>,
        reach: &Reach,
        vertices: &mut Vec<Vertex>,
        indices: &mut Vec<u32>,
    ) {
        let cells = face.side / 2;
        let (row, rows) = FACE_AXES[face.axis()];
        for v in 0..cells {
            for u in 0..cells {
                let solid = self.solid(u, v);
                let mut cell = [(cells - 1) * (face.number % 2); 3];
                (cell[row], cell[rows]) = (u, v);
                if matches!(solid, 0 | 0o777) || !reach.has_cell(cell[0], cell[2]) {
                    continue;
                }
                each_loop(successors(solid), |nodes| {
                    let place = |node: u8| {
                        let mut edge = EDGES[usize::from(node)];
                        edge.low = [2 * u + edge.low[0], 2 * v + edge.low[1]];
                        edge
                    };
                    // What is seen of a sliver, if anything, looks as the surface beside it.
                    let coarse = nodes.iter().find(|node| place(**node).length == 2);
                    let like = coarse.map(|&node| self.known[face.slot(place(node))]);
                    let like = like.and_then(|known| vertices.get(known as usize)).copied();
                    let mut corners = [Corner::default(); NODES];
                    for (corner, &node) in corners.iter_mut().zip(nodes) {
                        let index = &mut self.known[face.slot(place(node))];
                        if *index == NO_VERTEX {
                            *index = vertices.len() as u32;
                            let at = face.place(place(node));
                            vertices.push(match like {
                                Some(like) => Vertex::at(at, like.octahedral, like.colour),
                                None => maker.at(at),
                            });
                        }
                        *corner = face.corner(*index, vertices);
                    }
                    fill(&corners[..nodes.len()], face.is_turned(), indices);
                });
            }
        }
    }

    /// The solid samples of a coarse cell's face, `3 v + u`.
    fn solid(&self, u: usize, v: usize) -> u16 {
        let row = |n: usize| (self.rows[2 * v + n] >> (2 * u) & 7) as u16;
        row(0) | row(1) << 3 | row(2) << 6
    }
}

/// Cuts a loop into triangles. Where the two contours cross, the loop does so too, and no cut
/// keeps to the space between them; the one of least area strays least.
fn fill(corners: &[Corner], turned: bool, indices: &mut Vec<u32>) {
    let count = corners.len();
    // By the ends of a part of the loop: its least area, and the corner that its last edge's
    // triangle goes to.
    let mut least = [[(0_i64, 0_usize); NODES]; NODES];
    for length in 2..count {
        for first in 0..count - length {
            let last = first + length;
            let area = |middle: usize| {
                let ends = [corners[first], corners[middle], corners[last]];
                twice_area(ends) + least[first][middle].0 + least[middle][last].0
            };
            let best = (first + 1..last).map(|middle| (area(middle), middle)).min();
            least[first][last] = best.unwrap_or_default();
        }
    }
    let mut open = [(0, 0); NODES];
    open[0] = (0, count.saturating_sub(1));
    let mut waiting = 1;
    while waiting > 0 {
        waiting -= 1;
        let (first, last) = open[waiting];
        if last < first + 2 {
            continue;
        }
        let middle = least[first][last].1;
        let [a, b, c] = [first, middle, last].map(|n| corners[n]);
        // Corners in one place take nothing away: the other two edges cancel.
        if a.at != b.at && b.at != c.at && c.at != a.at {
            let (b, c) = if turned { (c, b) } else { (b, c) };
            indices.extend([a.vertex, b.vertex, c.vertex]);
        }
        open[waiting] = (first, middle);
        open[waiting + 1] = (middle, last);
        waiting += 2;
    }
}

/// Twice the area of a triangle, whichever way it runs, square parts.
fn twice_area([a, b, c]: [Corner; 3]) -> i64 {
    let across = |p: Corner, q: Corner| [q.at[0] - p.at[0], q.at[1] - p.at[1]];
    let (p, q) = (across(a, b), across(a, c));
    (p[0] * q[1] - p[1] * q[0]).abs()
}
