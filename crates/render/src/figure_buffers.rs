//! The figures' buffers on the adapter: all models in one, this frame's instances, and the joints of those that bend.
//!
//! Joints lie in uniform buffers, which every adapter's vertex stage can read by number; a call sees those of one batch.

use std::ops::Range;

use glam::Vec3;
use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{
    BindGroup, BindGroupLayout, Buffer, BufferUsages, Device, IndexFormat, RenderPass, ShaderStages,
};

use crate::coarse::coarse;
use crate::models::{Loaded, ModelVertex, Shape, SkinVertex};
use crate::rig::{JOINTS, JointRows};
use crate::uniforms::FigureInstance;

/// Figures whose joints one call can draw: with 21 joints each, just short of the 16 KiB that every adapter binds, and
/// a multiple of the 256 bytes that offsets must be; `BATCH` of figure.wgsl.
pub const BATCH: usize = 16;
/// Bytes of a joint.
pub const ROWS_BYTES: usize = size_of::<JointRows>();
const BATCH_BYTES: u64 = (BATCH * JOINTS * ROWS_BYTES) as u64;

/// Side of the cells that a coarse shadow's vertices are brought together in, metres: a texel of the figures' map at low
/// quality.
const COARSE_M: f32 = 0.05;
/// What is thinner anywhere throws the shadow of all its triangles, metres: cells would fold it flat.
const COARSE_FROM_M: f32 = 0.4;

/// Where a model lies in the buffers.
#[derive(Clone, Debug)]
pub struct ModelRanges {
    /// Number of its first vertex.
    pub base_vertex: i32,
    /// Indices of what hides things behind it.
    pub solid: Range<u32>,
    /// Indices of what lets light through.
    pub clear: Range<u32>,
    /// Indices of coarser triangles of what hides things, for its shadow in large texels.
    pub coarse: Range<u32>,
    /// Lowest and highest corner of its box in the bind pose, metres.
    pub limits: [Vec3; 2],
}

/// All models on the adapter.
#[derive(Debug)]
pub struct Statics {
    vertices: Buffer,
    /// Of the models that come first, which are those that bend.
    skin: Buffer,
    indices: Buffer,
    /// Where each model lies, by its number.
    pub ranges: Vec<ModelRanges>,
}

impl Statics {
    /// Uploads them. Those that bend are to come first.
    pub fn new(device: &Device, models: &[Loaded]) -> Self {
        let mut whole = Shape::default();
        let ranges = models
            .iter()
            .map(|Loaded { shape, .. }| {
                let start = whole.solid.len() as u32;
                let middle = start + shape.solid.len() as u32;
                let end = middle + shape.clear.len() as u32;
                let [low, high] = shape.limits();
                let coarse = if (high - low).min_element() < COARSE_FROM_M {
                    shape.solid.clone()
                } else {
                    coarse(&shape.vertices, &shape.skin, &shape.solid, COARSE_M)
                };
                let ranges = ModelRanges {
                    base_vertex: whole.vertices.len() as i32,
                    solid: start..middle,
                    clear: middle..end,
                    coarse: end..end + coarse.len() as u32,
                    limits: shape.limits(),
                };
                whole.vertices.extend(&shape.vertices);
                whole.skin.extend(&shape.skin);
                whole.solid.extend(&shape.solid);
                whole.solid.extend(&shape.clear);
                whole.solid.extend(&coarse);
                ranges
            })
            .collect();
        let buffer = |label, contents: &[u8], usage| {
            device.create_buffer_init(&BufferInitDescriptor {
                label: Some(label),
                contents,
                usage,
            })
        };
        let (vertex, index) = (BufferUsages::VERTEX, BufferUsages::INDEX);
        Self {
            vertices: buffer("models", bytemuck::cast_slice(&whole.vertices), vertex),
            skin: buffer("model skins", bytemuck::cast_slice(&whole.skin), vertex),
            indices: buffer("model indices", bytemuck::cast_slice(&whole.solid), index),
            ranges,
        }
    }

    /// Lets a pass read the models, with or without what bends them.
    pub fn bind(&self, pass: &mut RenderPass<'_>, bends: bool) {
        pass.set_vertex_buffer(0, self.vertices.slice(..));
        pass.set_index_buffer(self.indices.slice(..), IndexFormat::Uint16);
        if bends {
            pass.set_vertex_buffer(2, self.skin.slice(..));
        }
    }
}

/// A buffer for so many instances.
pub fn instance_buffer(device: &Device, room: usize) -> Buffer {
    device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("figures"),
        size: (room * size_of::<FigureInstance>()) as u64,
        usage: BufferUsages::VERTEX | BufferUsages::COPY_DST,
        mapped_at_creation: false,
    })
}

/// A buffer for the joints of so many figures, a multiple of [`BATCH`], and how a pass reads a batch of it.
pub fn joints_buffer(device: &Device, figures: usize) -> (Buffer, BindGroup) {
    let buffer = device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("joints"),
        size: (figures * JOINTS * ROWS_BYTES) as u64,
        usage: BufferUsages::UNIFORM | BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    let bound = device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("joints"),
        layout: &joints_layout(device),
        entries: &[wgpu::BindGroupEntry {
            binding: 0,
            resource: wgpu::BindingResource::Buffer(wgpu::BufferBinding {
                buffer: &buffer,
                offset: 0,
                size: wgpu::BufferSize::new(BATCH_BYTES),
            }),
        }],
    });
    (buffer, bound)
}

/// What the joints are bound by.
pub fn joints_layout(device: &Device) -> BindGroupLayout {
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("joints"),
        entries: &[wgpu::BindGroupLayoutEntry {
            binding: 0,
            visibility: ShaderStages::VERTEX,
            ty: wgpu::BindingType::Buffer {
                ty: wgpu::BufferBindingType::Uniform,
                has_dynamic_offset: true,
                min_binding_size: wgpu::BufferSize::new(BATCH_BYTES),
            },
            count: None,
        }],
    })
}

/// How vertices of models lie in their buffer.
pub fn vertex_layout() -> wgpu::VertexBufferLayout<'static> {
    wgpu::VertexBufferLayout {
        array_stride: size_of::<ModelVertex>() as u64,
        step_mode: wgpu::VertexStepMode::Vertex,
        attributes: &ModelVertex::ATTRIBUTES,
    }
}

/// How what ties them to a skeleton lies in its own.
pub fn skin_layout() -> wgpu::VertexBufferLayout<'static> {
    wgpu::VertexBufferLayout {
        array_stride: size_of::<SkinVertex>() as u64,
        step_mode: wgpu::VertexStepMode::Vertex,
        attributes: &SkinVertex::ATTRIBUTES,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_batch_of_joints_is_what_every_adapter_can_bind() {
        let least = wgpu::Limits::downlevel_webgl2_defaults();
        assert!(BATCH_BYTES <= least.max_uniform_buffer_binding_size);
        assert_eq!(
            BATCH_BYTES % u64::from(least.min_uniform_buffer_offset_alignment),
            0
        );
    }
}
