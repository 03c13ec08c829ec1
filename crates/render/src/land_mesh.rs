//! A mesh of the land on the adapter: where its parts lie in the pages, and what of it is drawn.

use std::ops::Range;

use wgpu::util::DrawIndexedIndirectArgs;

use crate::page_book::Place;
use crate::pages::Pages;
use crate::parts::{Part, SECTIONS};

/// Which seams of a mesh are drawn: bit f for the face f, in the order of [`FACES`](crate::seams::FACES).
pub type SeamMask = u8;

/// A mesh in the pages. It is to go back by [`LandMesh::give_back`], or its place is lost until another world is
/// shown.
#[derive(Debug, Default)]
pub struct LandMesh {
    parts: Vec<PlacedPart>,
}

#[derive(Debug)]
struct PlacedPart {
    place: Place,
    /// Counted from the page's first index.
    sections: [Range<u32>; SECTIONS],
}

/// What is drawn of one part: a page, and the arguments of a call but for the instance.
#[derive(Clone, Copy, Debug)]
pub struct Piece {
    /// The page it lies in.
    pub page: usize,
    /// Arguments with the first instance left at 0.
    pub args: DrawIndexedIndirectArgs,
}

impl LandMesh {
    /// Puts the parts of a mesh into pages. A part that fits no page is left out.
    pub fn put(pages: &mut Pages, parts: Vec<Part>) -> Self {
        let mut placed = Vec::with_capacity(parts.len());
        for mut part in parts {
            let Some(place) = pages.put(&part.vertices, &mut part.indices) else {
                continue;
            };
            let first = place.first_index();
            let sections = part.sections.map(|s| s.start + first..s.end + first);
            placed.push(PlacedPart { place, sections });
        }
        Self { parts: placed }
    }

    /// Gives its places back.
    pub fn give_back(self, pages: &mut Pages) {
        for part in self.parts {
            pages.give_back(part.place);
        }
    }

    /// Triangles of the surface.
    pub fn triangles(&self) -> usize {
        let surface = |part: &PlacedPart| part.sections[0].len() / 3;
        self.parts.iter().map(surface).sum()
    }

    /// Whether it has a seam in any face.
    pub fn has_seams(&self) -> bool {
        let seamed = |part: &PlacedPart| part.sections[1..].iter().any(|s| !s.is_empty());
        self.parts.iter().any(seamed)
    }

    /// The pieces of its surface and of the chosen seams. Sections that lie side by side are one piece.
    pub fn pieces(&self, seams: SeamMask) -> impl Iterator<Item = Piece> {
        self.parts.iter().flat_map(move |part| part.pieces(seams))
    }
}

impl PlacedPart {
    fn pieces(&self, seams: SeamMask) -> impl Iterator<Item = Piece> {
        // The surface is section 0, the seam of face f section f + 1.
        let chosen = 1 | u32::from(seams) << 1;
        let mut section = 0;
        std::iter::from_fn(move || {
            let is_drawn = |s: usize| chosen >> s & 1 == 1 && !self.sections[s].is_empty();
            section = (section..SECTIONS).find(|&s| is_drawn(s))?;
            let Range { start, mut end } = self.sections[section].clone();
            section += 1;
            while section < SECTIONS && is_drawn(section) && self.sections[section].start == end {
                end = self.sections[section].end;
                section += 1;
            }
            Some(self.piece(start..end))
        })
    }

    fn piece(&self, indices: Range<u32>) -> Piece {
        Piece {
            page: self.place.page,
            args: DrawIndexedIndirectArgs {
                index_count: indices.end - indices.start,
                instance_count: 1,
                first_index: indices.start,
                base_vertex: self.place.first_vertex() as i32,
                first_instance: 0,
            },
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use super::*;
    use crate::page_book::{PageBooks, PageSize};

    /// A part of a surface of 9 indices and seams of 3 each in faces 0, 1 and 4, after 10 other vertices and 12
    /// indices.
    fn part() -> PlacedPart {
        let mut books = PageBooks::new(PageSize {
            vertices: 100,
            indices: 100,
        });
        books.take(10, 12).unwrap();
        PlacedPart {
            place: books.take(20, 18).unwrap(),
            sections: [12..21, 21..24, 24..27, 27..27, 27..27, 27..30, 30..30],
        }
    }

    #[test]
    fn the_surface_and_the_chosen_seams_are_drawn_and_nothing_else() {
        let mesh = LandMesh {
            parts: vec![part()],
        };
        assert_eq!(mesh.triangles(), 3);
        assert!(mesh.has_seams());
        let drawn = |seams| -> Vec<_> {
            let pieces = mesh.pieces(seams).map(|p| p.args);
            pieces
                .map(|a| (a.first_index, a.index_count, a.base_vertex))
                .collect()
        };
        assert_eq!(drawn(0), [(12, 9, 10)]);
        assert_eq!(drawn(0b1), [(12, 12, 10)]);
        assert_eq!(drawn(0b10), [(12, 9, 10), (24, 3, 10)]);
        assert_eq!(drawn(0b10_1100), [(12, 9, 10)]);
        assert_eq!(drawn(0b11_1111), [(12, 15, 10), (27, 3, 10)]);
    }
}
