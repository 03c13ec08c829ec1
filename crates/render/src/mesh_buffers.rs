//! Vertices and indices of one mesh on the adapter.

use antipode_terrain::Vertex;
use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{Buffer, BufferDescriptor, BufferUsages, Device, IndexFormat, Queue, RenderPass};

/// A mesh ready to be drawn.
#[derive(Debug)]
pub struct MeshBuffers {
    vertices: Buffer,
    indices: Buffer,
    index_count: u32,
    index_format: IndexFormat,
}

impl MeshBuffers {
    /// Buffers that fit a mesh and stay as they are.
    pub fn new(device: &Device, vertices: &[Vertex], indices: &[u32]) -> Self {
        let buffer = |label, contents: &[u8], usage| {
            device.create_buffer_init(&BufferInitDescriptor {
                label: Some(label),
                contents,
                usage,
            })
        };
        let short: Option<Vec<u16>> = u16::try_from(vertices.len())
            .is_ok()
            .then(|| indices.iter().map(|&i| i as u16).collect());
        let (bytes, index_format) = match &short {
            Some(short) => (bytemuck::cast_slice(short), IndexFormat::Uint16),
            None => (bytemuck::cast_slice(indices), IndexFormat::Uint32),
        };
        Self {
            vertices: buffer(
                "chunk vertices",
                bytemuck::cast_slice(vertices),
                BufferUsages::VERTEX,
            ),
            indices: buffer("chunk indices", bytes, BufferUsages::INDEX),
            index_count: indices.len() as u32,
            index_format,
        }
    }

    /// Buffers with room for meshes up to a power of two, to be filled again and again: making buffers anew for
    /// a mesh that changes at every step would cost more than filling them, and memory that drivers are slow to
    /// take back.
    pub fn roomy(device: &Device, vertices: usize, indices: usize) -> Self {
        let buffer = |label, bytes: usize, usage| {
            device.create_buffer(&BufferDescriptor {
                label: Some(label),
                size: bytes.next_power_of_two() as u64,
                usage: usage | BufferUsages::COPY_DST,
                mapped_at_creation: false,
            })
        };
        Self {
            vertices: buffer(
                "refined vertices",
                vertices * size_of::<Vertex>(),
                BufferUsages::VERTEX,
            ),
            indices: buffer(
                "refined indices",
                indices * size_of::<u32>(),
                BufferUsages::INDEX,
            ),
            index_count: 0,
            index_format: IndexFormat::Uint32,
        }
    }

    /// Whether a mesh of that size fits buffers with room.
    pub fn has_room(&self, vertices: usize, indices: usize) -> bool {
        self.vertices.size() >= (vertices * size_of::<Vertex>()) as u64
            && self.indices.size() >= (indices * size_of::<u32>()) as u64
    }

    /// Fills buffers with room.
    pub fn fill(&mut self, queue: &Queue, vertices: &[Vertex], indices: &[u32]) {
        queue.write_buffer(&self.vertices, 0, bytemuck::cast_slice(vertices));
        queue.write_buffer(&self.indices, 0, bytemuck::cast_slice(indices));
        self.index_count = indices.len() as u32;
    }

    /// Triangles of the mesh.
    pub fn triangles(&self) -> usize {
        self.index_count as usize / 3
    }

    /// Draws the mesh once, with the instance that is bound.
    pub fn draw(&self, pass: &mut RenderPass<'_>) {
        pass.set_vertex_buffer(0, self.vertices.slice(..));
        pass.set_index_buffer(self.indices.slice(..), self.index_format);
        pass.draw_indexed(0..self.index_count, 0, 0..1);
    }
}
