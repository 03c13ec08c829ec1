//! Meshes of chunks, as the GPU and the collider take them.

use std::ops::Range;

use bytemuck::{Pod, Zeroable};
use glam::Vec3;

use crate::kind::between_bytes;
use crate::level::Level;
use crate::light::LightTables;
use crate::thing::Thing;
use crate::tuft::Tuft;

/// Units of a vertex's position in a metre.
pub const UNITS_PER_M: u32 = 1024;
/// A unit has two to the power of this many parts.
const PART_BITS: usize = 5;
/// Parts of units in a metre: places are whole multiples of their size.
pub const PARTS_PER_M: u32 = UNITS_PER_M << PART_BITS;
/// Parts along a chunk's edge.
const CHUNK_PARTS: u32 = antipode_geometry::CHUNK_CELLS as u32 * PARTS_PER_M;
/// The greatest value of a signed normalised 16-bit integer.
const SNORM_MAX: f32 = 32767.0;

/// A vertex of the ground: 16 bytes.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Pod, Zeroable)]
pub struct Vertex {
    /// Place from the chunk's origin in 1/1024 m, rounded down, each 0..=32768. Whole numbers,
    /// so that both chunks at a face mean the same place.
    pub units: [u16; 3],
    /// What is left of it in 1/32768 m: five bits for each axis, x lowest. Exact in `f32` too.
    pub parts: u16,
    /// Unit normal in the chart, toward the air, as a point of the unfolded octahedron (see `octahedral`).
    pub octahedral: [i16; 2],
    /// Colour, sRGB. The fourth has in its five lowest bits the number of the kind of ground at the solid end of the vertex's
    /// edge, 31 for none; above them 7 where that is the skin of untouched land, which shows rock where it is steep, or else
    /// how much of the sky is left so deep below it, 0 to 6.
    pub colour: [u8; 4],
}

impl Vertex {
    /// The vertex at a position in metres from the chunk's origin, held to the chunk and to
    /// whole parts, with a normal of any length and an sRGB colour.
    pub fn new(position: Vec3, normal: Vec3, colour: [u8; 3]) -> Self {
        let parts = (position * PARTS_PER_M as f32).to_array();
        let place = parts.map(|p| p.round().clamp(0.0, CHUNK_PARTS as f32) as u32);
        let [r, g, b] = colour;
        Self::at(place, octahedral(normal), [r, g, b, 255])
    }

    /// The vertex at a position in metres from the corner of what it is part of, each held to 0..64 and to 1/1024 m.
    pub fn wide(position: Vec3, normal: Vec3, colour: [u8; 4]) -> Self {
        // Casts saturate.
        let units = position * UNITS_PER_M as f32 + 0.5;
        Self {
            units: units.to_array().map(|unit| unit as u16),
            parts: 0,
            octahedral: octahedral(normal),
            colour,
        }
    }

    /// The vertex at a place in 1/32768 m from the chunk's origin, each 0..=2^20.
    #[inline]
    pub fn at(place: [u32; 3], octahedral: [i16; 2], colour: [u8; 4]) -> Self {
        let [x, y, z] = place.map(|p| (p & ((1 << PART_BITS) - 1)) as u16);
        Self {
            units: place.map(|p| (p >> PART_BITS) as u16),
            parts: x | y << PART_BITS | z << (2 * PART_BITS),
            octahedral,
            colour,
        }
    }

    /// The vertex half way between two, as a picture has it there: the mean of their light and of the sky. Of two kinds it has
    /// one, whichever way one looks. Places are rounded down to whole parts: chunks stand a whole even number of those apart.
    pub fn between(a: &Self, b: &Self) -> Self {
        let (from, to) = (a.place(), b.place());
        let light = LightTables::get();
        let [r, g, blue] = std::array::from_fn(|i| light.halfway(a.colour[i], b.colour[i]));
        Self::at(
            std::array::from_fn(|i| from[i].midpoint(to[i])),
            octahedral(a.normal() + b.normal()),
            [r, g, blue, between_bytes(a.colour[3], b.colour[3])],
        )
    }

    /// Place from the chunk's origin in 1/32768 m, each 0..=2^20.
    #[inline]
    pub fn place(&self) -> [u32; 3] {
        std::array::from_fn(|axis| u32::from(self.units[axis]) << PART_BITS | self.left(axis))
    }

    /// [`Self::units`], but rounded up.
    pub fn units_above(&self) -> [u16; 3] {
        std::array::from_fn(|axis| self.units[axis].saturating_add(u16::from(self.left(axis) > 0)))
    }

    /// What is left of a coordinate above whole units, in parts.
    #[inline]
    fn left(&self, axis: usize) -> u32 {
        u32::from(self.parts) >> (PART_BITS * axis) & ((1 << PART_BITS) - 1)
    }

    /// Metres from the chunk's origin, each 0..=32.
    #[inline]
    pub fn position(&self) -> Vec3 {
        Vec3::from(self.place().map(|p| p as f32)) / PARTS_PER_M as f32
    }

    /// Unit normal in the chart, toward the air.
    pub fn normal(&self) -> Vec3 {
        let [x, z] = self.octahedral.map(|n| f32::from(n) / SNORM_MAX);
        let y = 1.0 - x.abs() - z.abs();
        let fold = (-y).max(0.0);
        Vec3::new(x - fold.copysign(x), y, z - fold.copysign(z)).normalize_or(Vec3::Y)
    }
}

/// A direction of any length as a point of the octahedron `|x| + |y| + |z| = 1`, whose lower
/// half is folded outward, seen from above: `(x, z)` as signed normalised integers (Cigolle et
/// al., "A Survey of Efficient Representations for Independent Unit Vectors", JCGT 2014). No
/// direction gives up.
#[inline]
pub fn octahedral(direction: Vec3) -> [i16; 2] {
    let Vec3 { x, y, z } = direction;
    let sum = x.abs() + y.abs() + z.abs();
    // Casts take what is not a number, after a division by zero, to zero: straight up.
    let scale = SNORM_MAX / sum;
    let (x, z) = if y < 0.0 {
        ((sum - z.abs()).copysign(x), (sum - x.abs()).copysign(z))
    } else {
        (x, z)
    };
    // Rounded without a call.
    [x, z].map(|c| (c * scale + 0.5_f32.copysign(c)) as i16)
}

/// Triangles of one chunk, counter-clockwise seen from the air.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ChunkMesh {
    /// The resolution it was made at.
    pub level: Level,
    /// Vertices, each shared by the triangles that meet there.
    pub vertices: Vec<Vertex>,
    /// Three indices into `vertices` for each triangle: the surface's, then the seams'.
    pub indices: Vec<u32>,
    /// For each face, -x, +x, -y, +y, -z and +z, the indices of the flat triangles in that face
    /// that close the gap to a neighbour of half the step, to be drawn only beside one. Empty
    /// where there is no gap, and at [`Level::FULL`].
    pub seams: [Range<u32>; 6],
    /// What the level is off by, metres: 99 of 100 places of untouched land lie nearer to the full
    /// surface ([`Field::level_error_m`](crate::Field::level_error_m)). 0 at [`Level::FULL`].
    pub error_m: f32,
    /// What grows and stands on it.
    pub things: Vec<Thing>,
    /// What grows low on it, at [`Level::FULL`].
    pub tufts: Vec<Tuft>,
}

impl ChunkMesh {
    /// Whether there is nothing to draw, not even beside a finer neighbour.
    pub fn is_empty(&self) -> bool {
        self.indices.is_empty()
    }

    /// The indices of the chunk's own surface.
    pub fn surface_indices(&self) -> &[u32] {
        let seamed = |seam: &&Range<u32>| !seam.is_empty();
        let end = self
            .seams
            .iter()
            .filter(seamed)
            .map(|seam| seam.start)
            .min();
        let end = end.map_or(self.indices.len(), |end| end as usize);
        self.indices.get(..end).unwrap_or_default()
    }

    /// The indices of the seam in a face, `0..6` for -x, +x, -y, +y, -z and +z; empty for others.
    pub fn seam_indices(&self, face: usize) -> &[u32] {
        let seam = self.seams.get(face).cloned().unwrap_or_default();
        let range = seam.start as usize..seam.end as usize;
        self.indices.get(range).unwrap_or_default()
    }

    /// The surface's triangles, each as three indices into `vertices`.
    pub fn triangles(&self) -> &[[u32; 3]] {
        self.surface_indices().as_chunks::<3>().0
    }

    /// Positions of the vertices, metres from the chunk's origin.
    pub fn positions(&self) -> Vec<[f32; 3]> {
        self.vertices
            .iter()
            .map(|v| v.position().to_array())
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn positions_are_snapped_held_and_exact() {
        let vertex = Vertex::new(Vec3::new(1.0 / 3.0, -4.0, 99.0), Vec3::Y, [1, 2, 3]);
        assert_eq!((vertex.units, vertex.parts), ([341, 0, 32768], 11));
        assert_eq!(vertex.units_above(), [342, 0, 32768]);
        assert_eq!(vertex.position(), Vec3::new(10923.0 / 32768.0, 0.0, 32.0));
        for place in [
            [0; 3],
            [1, 2, 3],
            [31, 1 << 20, 32],
            [(1 << 20) - 1, 33, 99_999],
        ] {
            let vertex = Vertex::at(place, [0; 2], [0; 4]);
            assert_eq!(vertex.place(), place);
            let metres = place.map(|p| p as f32 / 32768.0);
            assert_eq!(vertex.position().to_array(), metres);
        }
        assert_eq!(vertex.colour, [1, 2, 3, 255]);
        assert_eq!(size_of::<Vertex>(), 16);
    }

    #[test]
    fn normals_turn_by_less_than_a_two_hundredth_of_a_degree_either_side_of_every_fold() {
        for i in -50..=50 {
            for j in -50..=50 {
                for (x, y, z) in [
                    (i, j, 50),
                    (i, j, -50),
                    (50, i, j),
                    (-50, i, j),
                    (i, 50, j),
                    (i, -50, j),
                ] {
                    let normal = Vec3::new(x as f32, y as f32, z as f32).normalize();
                    let read = Vertex::new(Vec3::ZERO, normal * 3.0, [0; 3]).normal();
                    let turned = normal.as_dvec3().angle_between(read.as_dvec3());
                    assert!(turned.to_degrees() < 0.005, "{normal} {read}");
                }
            }
        }
        for axis in [
            Vec3::X,
            Vec3::Y,
            Vec3::Z,
            Vec3::NEG_X,
            Vec3::NEG_Y,
            Vec3::NEG_Z,
        ] {
            assert_eq!(Vertex::new(Vec3::ZERO, axis, [0; 3]).normal(), axis);
        }
        for none in [Vec3::ZERO, Vec3::NAN] {
            assert_eq!(Vertex::new(Vec3::ZERO, none, [0; 3]).normal(), Vec3::Y);
        }
    }

    #[test]
    fn surfaces_end_where_the_first_seam_begins() {
        let mut mesh = ChunkMesh {
            indices: (0..12).collect(),
            ..ChunkMesh::default()
        };
        assert_eq!(mesh.triangles().len(), 4);
        mesh.seams[3] = 9..12;
        mesh.seams[1] = 6..9;
        assert_eq!(mesh.surface_indices(), [0, 1, 2, 3, 4, 5]);
        assert_eq!(mesh.seam_indices(1), [6, 7, 8]);
        assert!(mesh.seam_indices(0).is_empty() && mesh.seam_indices(6).is_empty());
    }
}
