//! Meshes cut into parts that 16-bit indices reach all of. Nearly every mesh is one part.

use std::collections::HashMap;
use std::ops::Range;

use antipode_terrain::{ChunkMesh, Vertex};
use glam::Vec3;

/// Sections of a mesh that are drawn or left out each by itself: the surface, and the seam of each face.
pub const SECTIONS: usize = 7;

/// Vertices of a part at most.
const MOST_VERTICES: usize = 1 << 16;
/// Indices of a part at most: far less than a page holds.
const MOST_INDICES: usize = 3 << 18;

/// A part of a mesh, ready to be put into a page.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Part {
    /// The vertices that it uses.
    pub vertices: Vec<Vertex>,
    /// Three for each triangle, section by section.
    pub indices: Vec<u16>,
    /// Where each section's indices lie.
    pub sections: [Range<u32>; SECTIONS],
    /// The surface in pieces that lie together; none where it is drawn as a whole.
    pub blocks: Vec<Block>,
}

/// Triangles of the surface that lie together, so that those out of the picture can be left out.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// Where its indices lie, counted from the surface's first.
    pub indices: Range<u32>,
    /// Lowest corner, metres from the chunk's corner.
    pub min: Vec3,
    /// Highest corner, metres from the chunk's corner.
    pub max: Vec3,
}

/// The sections of a chunk's mesh, as indices into its vertices: first the surface, then a seam for each face.
pub fn sections(mesh: &ChunkMesh) -> [&[u32]; SECTIONS] {
    std::array::from_fn(|section| match section {
        0 => mesh.surface_indices(),
        _ => mesh.seam_indices(section - 1),
    })
}

/// The parts of a mesh; none of one without triangles. Its surface lies in `blocks`, or in none.
pub fn parts(vertices: &[Vertex], sections: [&[u32]; SECTIONS], blocks: &[Block]) -> Vec<Part> {
    let mut parts = in_parts(vertices, sections);
    let mut start = 0;
    for part in &mut parts {
        let end = start + part.sections[0].len() as u32;
        part.blocks = blocks_between(blocks, start, end);
        start = end;
    }
    parts
}

/// The blocks that lie between two indices of the surface, as far as they do, counted from the first.
fn blocks_between(blocks: &[Block], start: u32, end: u32) -> Vec<Block> {
    let between = |block: &Block| {
        let indices = block.indices.start.max(start)..block.indices.end.min(end);
        (indices.start < indices.end).then(|| Block {
            indices: indices.start - start..indices.end - start,
            ..block.clone()
        })
    };
    blocks.iter().filter_map(between).collect()
}

fn in_parts(vertices: &[Vertex], sections: [&[u32]; SECTIONS]) -> Vec<Part> {
    let count: usize = sections.iter().map(|section| section.len()).sum();
    if count == 0 {
        return Vec::new();
    }
    if vertices.len() <= MOST_VERTICES && count <= MOST_INDICES {
        return vec![whole(vertices, sections, count)];
    }
    cut(vertices, sections, MOST_VERTICES, MOST_INDICES)
}

fn whole(vertices: &[Vertex], sections: [&[u32]; SECTIONS], count: usize) -> Part {
    let mut indices = Vec::with_capacity(count + 1);
    let sections = sections.map(|section| {
        let start = indices.len() as u32;
        indices.extend(section.iter().map(|&i| i as u16));
        start..indices.len() as u32
    });
    Part {
        vertices: vertices.to_vec(),
        indices,
        sections,
        blocks: Vec::new(),
    }
}

/// Cuts between triangles, as they come. Indices past the vertices' end are left out with their triangle.
fn cut(
    vertices: &[Vertex],
    sections: [&[u32]; SECTIONS],
    most_vertices: usize,
    most_indices: usize,
) -> Vec<Part> {
    let mut parts = Vec::new();
    let mut part = Part::default();
    let mut known: HashMap<u32, u16> = HashMap::new();
    for (number, section) in sections.into_iter().enumerate() {
        let start = part.indices.len() as u32;
        part.sections[number] = start..start;
        for corners in section.as_chunks::<3>().0 {
            let full =
                part.vertices.len() + 3 > most_vertices || part.indices.len() + 3 > most_indices;
            if full {
                known.clear();
                parts.push(std::mem::take(&mut part));
            }
            if corners.iter().any(|&i| i as usize >= vertices.len()) {
                continue;
            }
            for &corner in corners {
                let next = part.vertices.len() as u16;
                let index = *known.entry(corner).or_insert(next);
                if index == next {
                    part.vertices.push(vertices[corner as usize]);
                }
                part.indices.push(index);
            }
            part.sections[number].end = part.indices.len() as u32;
        }
    }
    parts.push(part);
    parts
}

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::*;

    fn vertices(count: u32) -> Vec<Vertex> {
        let place = |i: u32| Vec3::new((i % 32) as f32, (i / 32 % 32) as f32, (i / 1024) as f32);
        (0..count)
            .map(|i| Vertex::new(place(i), Vec3::Y, [1, 2, 3]))
            .collect()
    }

    /// Places of the corners of each triangle of a section.
    fn drawn(parts: &[Part], section: usize) -> Vec<[u16; 3]> {
        let of = |part: &Part| {
            let range = part.sections[section].clone();
            let indices = &part.indices[range.start as usize..range.end as usize];
            let at = |&i: &u16| part.vertices[usize::from(i)].units;
            indices.iter().map(at).collect::<Vec<_>>()
        };
        parts.iter().flat_map(of).collect()
    }

    #[test]
    fn cut_or_whole_the_same_triangles_lie_in_the_same_sections() {
        let vertices = vertices(500);
        let surface: Vec<u32> = (0..900).map(|i| (i * 7 + i / 3) % 500).collect();
        let seam: Vec<u32> = (0..90).map(|i| (i * 11) % 500).collect();
        let mut sections: [&[u32]; SECTIONS] = [&[]; SECTIONS];
        sections[0] = &surface;
        sections[4] = &seam;
        let whole = parts(&vertices, sections, &[]);
        assert_eq!(whole.len(), 1);
        for (most_vertices, most_indices) in [(20, 1000), (1000, 30), (3, 3), (100, 99)] {
            let cut = cut(&vertices, sections, most_vertices, most_indices);
            assert!(cut.len() > 3);
            for part in &cut {
                assert!(part.vertices.len() <= most_vertices);
                assert!(part.indices.len() <= most_indices);
            }
            for section in 0..SECTIONS {
                assert_eq!(drawn(&cut, section), drawn(&whole, section), "{section}");
            }
        }
        assert!(parts(&vertices, [&[]; SECTIONS], &[]).is_empty());
    }

    #[test]
    fn blocks_that_are_cut_keep_every_index_once() {
        let block = |from: u32, to: u32| Block {
            indices: from..to,
            min: Vec3::splat(from as f32),
            max: Vec3::splat(to as f32),
        };
        let blocks = [block(0, 30), block(30, 36), block(36, 90)];
        assert_eq!(blocks_between(&blocks, 0, 90), blocks);
        let cut: Vec<_> = [(0, 33), (33, 60), (60, 90)]
            .map(|(start, end)| blocks_between(&blocks, start, end))
            .into();
        let range = |b: &Block| (b.indices.start, b.indices.end);
        let ranges: Vec<Vec<_>> = cut
            .iter()
            .map(|part| part.iter().map(range).collect())
            .collect();
        assert_eq!(
            ranges,
            [
                vec![(0, 30), (30, 33)],
                vec![(0, 3), (3, 27)],
                vec![(0, 30)]
            ]
        );
        assert_eq!(cut[1][0].max, blocks[1].max);
    }
}
