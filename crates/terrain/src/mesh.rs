//! Meshes of chunks, as the GPU and the collider take them.

use bytemuck::{Pod, Zeroable};

/// A vertex of the ground: 24 bytes.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub struct Vertex {
    /// Metres from the chunk's origin, each 0..=32.
    pub position: [f32; 3],
    /// Unit normal in the chart, toward the air, as signed normalised integers; the fourth is 0.
    pub normal: [i16; 4],
    /// Colour, sRGB; the fourth is 255.
    pub colour: [u8; 4],
}

/// Triangles of one chunk, counter-clockwise seen from the air.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ChunkMesh {
    /// Vertices, each shared by the triangles that meet there.
    pub vertices: Vec<Vertex>,
    /// Three indices into `vertices` for each triangle.
    pub indices: Vec<u32>,
}

impl ChunkMesh {
    /// Whether there is nothing to draw.
    pub fn is_empty(&self) -> bool {
        self.indices.is_empty()
    }

    /// The triangles, each as three indices into `vertices`.
    pub fn triangles(&self) -> &[[u32; 3]] {
        self.indices.as_chunks::<3>().0
    }

    /// Positions of the vertices, metres from the chunk's origin.
    pub fn positions(&self) -> Vec<[f32; 3]> {
        self.vertices.iter().map(|v| v.position).collect()
    }
}
