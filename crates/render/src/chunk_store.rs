//! The terrain's meshes on the adapter.

use std::collections::HashMap;

use antipode_geometry::ChunkCoord;
use antipode_scene::frame::{ChunkChange, Frame};
use antipode_terrain::{ChunkMesh, Vertex};
use glam::Vec3;
use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{Buffer, BufferUsages, Device, IndexFormat, Queue, RenderPass, RenderPipeline};

use crate::culling::Visible;
use crate::uniforms::ChunkInstance;

/// Attributes of a terrain vertex, from location 0 on.
pub const VERTEX_ATTRIBUTES: [wgpu::VertexAttribute; 3] =
    wgpu::vertex_attr_array![0 => Float32x3, 1 => Snorm16x4, 2 => Unorm8x4];
/// Bytes of a terrain vertex.
pub const VERTEX_BYTES: u64 = size_of::<Vertex>() as u64;

/// One chunk's mesh.
#[derive(Debug)]
pub struct GpuChunk {
    vertices: Buffer,
    indices: Buffer,
    index_count: u32,
    index_format: IndexFormat,
    /// Lowest corner of the mesh, metres from the chunk's.
    pub min: Vec3,
    /// Highest corner of the mesh, metres from the chunk's lowest.
    pub max: Vec3,
}

impl GpuChunk {
    fn new(device: &Device, mesh: &ChunkMesh) -> Self {
        let vertices = device.create_buffer_init(&BufferInitDescriptor {
            label: Some("chunk vertices"),
            contents: bytemuck::cast_slice(&mesh.vertices),
            usage: BufferUsages::VERTEX,
        });
        let indices = |contents: &[u8]| {
            let descriptor = BufferInitDescriptor {
                label: Some("chunk indices"),
                contents,
                usage: BufferUsages::INDEX,
            };
            device.create_buffer_init(&descriptor)
        };
        let (indices, index_format) = if u16::try_from(mesh.vertices.len()).is_ok() {
            let short: Vec<u16> = mesh.indices.iter().map(|&i| i as u16).collect();
            (indices(bytemuck::cast_slice(&short)), IndexFormat::Uint16)
        } else {
            (
                indices(bytemuck::cast_slice(&mesh.indices)),
                IndexFormat::Uint32,
            )
        };
        let positions = || mesh.vertices.iter().map(|v| Vec3::from(v.position));
        Self {
            vertices,
            indices,
            index_count: mesh.indices.len() as u32,
            index_format,
            min: positions().reduce(Vec3::min).unwrap_or_default(),
            max: positions().reduce(Vec3::max).unwrap_or_default(),
        }
    }
}

/// All chunks, and this frame's instances.
#[derive(Debug)]
pub struct ChunkStore {
    chunks: HashMap<ChunkCoord, GpuChunk>,
    world: Option<u64>,
    instances: Buffer,
    room: usize,
}

impl ChunkStore {
    /// An empty store.
    pub fn new(device: &Device) -> Self {
        let room = 256;
        Self {
            chunks: HashMap::new(),
            world: None,
            instances: instance_buffer(device, room),
            room,
        }
    }

    /// Takes the frame's changes, dropping everything first when the world is another.
    pub fn apply(&mut self, device: &Device, frame: &Frame) {
        if self.world != Some(frame.loaded_world) {
            self.chunks.clear();
            self.world = Some(frame.loaded_world);
        }
        for change in &frame.chunk_changes {
            match change {
                ChunkChange::Put(coord, mesh) if !mesh.is_empty() => {
                    self.chunks.insert(*coord, GpuChunk::new(device, mesh));
                }
                ChunkChange::Put(coord, _) | ChunkChange::Remove(coord) => {
                    self.chunks.remove(coord);
                }
            }
        }
    }

    /// Every chunk that has triangles.
    pub fn iter(&self) -> impl Iterator<Item = (&ChunkCoord, &GpuChunk)> {
        self.chunks.iter()
    }

    /// How many chunks have triangles.
    pub fn len(&self) -> usize {
        self.chunks.len()
    }

    /// Makes room for the instances of all chunks.
    pub fn reserve(&mut self, device: &Device) {
        if self.chunks.len() > self.room {
            self.room = self.chunks.len().next_power_of_two();
            self.instances = instance_buffer(device, self.room);
        }
    }

    /// Sends where the visible chunks stand.
    pub fn upload(&self, queue: &Queue, visible: &[Visible<'_>]) {
        let instances: Vec<_> = visible.iter().map(|v| v.instance).collect();
        queue.write_buffer(&self.instances, 0, bytemuck::cast_slice(&instances));
    }

    /// Draws the visible chunks in order, those at the rim with `rim`; returns triangles and draw calls.
    pub fn draw(
        &self,
        pass: &mut RenderPass<'_>,
        visible: &[Visible<'_>],
        plain: &RenderPipeline,
        rim: &RenderPipeline,
    ) -> (usize, usize) {
        let mut triangles = 0;
        let mut trimmed = None;
        for (place, Visible { chunk, at_rim, .. }) in visible.iter().enumerate() {
            if trimmed != Some(*at_rim) {
                trimmed = Some(*at_rim);
                pass.set_pipeline(if *at_rim { rim } else { plain });
            }
            // Binding the slice instead of naming a first instance works on OpenGL too.
            let start = (place * size_of::<ChunkInstance>()) as u64;
            pass.set_vertex_buffer(0, chunk.vertices.slice(..));
            pass.set_vertex_buffer(1, self.instances.slice(start..));
            pass.set_index_buffer(chunk.indices.slice(..), chunk.index_format);
            pass.draw_indexed(0..chunk.index_count, 0, 0..1);
            triangles += chunk.index_count as usize / 3;
        }
        (triangles, visible.len())
    }
}

fn instance_buffer(device: &Device, room: usize) -> Buffer {
    device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("chunks"),
        size: (room * size_of::<ChunkInstance>()) as u64,
        usage: BufferUsages::VERTEX | BufferUsages::COPY_DST,
        mapped_at_creation: false,
    })
}

#[cfg(test)]
mod tests {
    use std::mem::offset_of;

    use super::*;

    #[test]
    fn terrain_vertices_are_laid_out_as_the_pipeline_reads_them() {
        let ours = [
            offset_of!(Vertex, position),
            offset_of!(Vertex, normal),
            offset_of!(Vertex, colour),
        ];
        assert_eq!(VERTEX_ATTRIBUTES.map(|a| a.offset as usize), ours);
        assert_eq!(VERTEX_BYTES, 24);
    }
}
