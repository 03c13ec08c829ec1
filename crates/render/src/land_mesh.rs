//! A mesh of the land on the adapter: where its parts lie in the pages, and what of it is drawn.

use std::ops::Range;

use wgpu::util::DrawIndexedIndirectArgs;

use crate::page_allocator::MeshAllocation;
use crate::pages::Pages;
use crate::parts::{Block, Part, SECTIONS};

/// Which seams of a mesh are drawn: bit f for the face f, in the order of [`FACES`](crate::seams::FACES).
pub type SeamMask = u8;

/// A mesh in the pages. It is to go back by [`LandMesh::give_back`], or its room is lost until another world is
/// shown.
#[derive(Debug, Default)]
pub struct LandMesh {
    parts: Vec<PlacedPart>,
}

#[derive(Debug)]
struct PlacedPart {
    allocation: MeshAllocation,
    /// Counted from the page's first index.
    sections: [Range<u32>; SECTIONS],
    /// The surface's blocks, counted from its first index; none where it is drawn as a whole.
    blocks: Vec<Block>,
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
        let mut in_pages = Vec::with_capacity(parts.len());
        for mut part in parts {
            let Some(allocation) = pages.put(&part.vertices, &mut part.indices) else {
                continue;
            };
            let first = allocation.first_index();
            let sections = part.sections.map(|s| s.start + first..s.end + first);
            in_pages.push(PlacedPart {
                allocation,
                sections,
                blocks: part.blocks,
            });
        }
        Self { parts: in_pages }
    }

    /// Gives its room back.
    pub fn give_back(self, pages: &mut Pages) {
        for part in self.parts {
            pages.give_back(part.allocation);
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
        let part =
            move |part: &'_ PlacedPart| part.pieces(1 | u32::from(seams) << 1).collect::<Vec<_>>();
        self.parts.iter().flat_map(part)
    }

    /// The pieces of those blocks of its surface that are seen, each with how `seen` has it drawn, and of the chosen
    /// seams and of what is not in blocks, drawn as `whole` says; and how many triangles are left out.
    pub fn pieces_seen<T: Copy + PartialEq>(
        &self,
        seams: SeamMask,
        whole: T,
        seen: impl Fn(&Block) -> Option<T>,
    ) -> (Vec<(T, Piece)>, usize) {
        let (mut pieces, mut left_out) = (Vec::new(), 0);
        for part in &self.parts {
            let mut chosen = u32::from(seams) << 1;
            if part.blocks.is_empty() {
                chosen |= 1;
            } else {
                left_out += part.push_blocks(&mut pieces, &seen);
            }
            pieces.extend(part.pieces(chosen).map(|piece| (whole, piece)));
        }
        (pieces, left_out)
    }
}

impl PlacedPart {
    /// The pieces of the chosen sections: the surface is bit 0, the seam of face f bit f + 1.
    fn pieces(&self, chosen: u32) -> impl Iterator<Item = Piece> {
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

    /// Adds the blocks that are seen, and tells how many triangles the others have. Blocks that lie side by side and are
    /// drawn alike are one piece.
    fn push_blocks<T: Copy + PartialEq>(
        &self,
        pieces: &mut Vec<(T, Piece)>,
        seen: impl Fn(&Block) -> Option<T>,
    ) -> usize {
        let first = self.sections[0].start;
        let mut run: Option<(T, Range<u32>)> = None;
        let mut left_out = 0;
        for block in &self.blocks {
            let Some(drawn) = seen(block) else {
                left_out += block.indices.len() / 3;
                continue;
            };
            let indices = block.indices.start + first..block.indices.end + first;
            match &mut run {
                Some((way, run)) if *way == drawn && run.end == indices.start => {
                    run.end = indices.end;
                }
                _ => pieces.extend(
                    run.replace((drawn, indices))
                        .map(|(way, run)| (way, self.piece(run))),
                ),
            }
        }
        pieces.extend(run.map(|(way, run)| (way, self.piece(run))));
        left_out
    }

    fn piece(&self, indices: Range<u32>) -> Piece {
        Piece {
            page: self.allocation.page,
            args: DrawIndexedIndirectArgs {
                index_count: indices.end - indices.start,
                instance_count: 1,
                first_index: indices.start,
                base_vertex: self.allocation.first_vertex() as i32,
                first_instance: 0,
            },
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use super::*;
    use crate::page_allocator::{PageAllocator, PageSize};

    /// A part of a surface of 9 indices and seams of 3 each in faces 0, 1 and 4, after 10 other vertices and 12
    /// indices.
    fn part() -> PlacedPart {
        let mut allocator = PageAllocator::new(PageSize {
            vertices: 100,
            indices: 100,
        });
        allocator.allocate(10, 12).unwrap();
        PlacedPart {
            allocation: allocator.allocate(20, 18).unwrap(),
            sections: [12..21, 21..24, 24..27, 27..27, 27..27, 27..30, 30..30],
            blocks: Vec::new(),
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

    #[test]
    fn of_a_surface_in_blocks_only_those_that_are_seen_are_drawn() {
        let block = |from: u32, to: u32| Block {
            indices: from..to,
            min: glam::Vec3::ZERO,
            max: glam::Vec3::splat(to as f32),
        };
        let blocks = vec![block(0, 3), block(3, 6), block(6, 9)];
        let mesh = LandMesh {
            parts: vec![PlacedPart { blocks, ..part() }],
        };
        let drawn = |seams, seen: [f32; 2]| -> (Vec<_>, usize) {
            let is_seen = |b: &Block| (seen[0]..=seen[1]).contains(&b.max.x).then_some(());
            let (pieces, left_out) = mesh.pieces_seen(seams, (), is_seen);
            let args = pieces
                .iter()
                .map(|((), p)| (p.args.first_index, p.args.index_count));
            (args.collect(), left_out)
        };
        assert_eq!(drawn(0, [0.0, 9.0]), (vec![(12, 9)], 0));
        assert_eq!(drawn(0b1, [4.0, 7.0]), (vec![(15, 3), (21, 3)], 2));
        assert_eq!(drawn(0b1, [4.0, 9.0]), (vec![(15, 6), (21, 3)], 1));
        assert_eq!(drawn(0, [10.0, 11.0]), (vec![], 3));
    }
}
