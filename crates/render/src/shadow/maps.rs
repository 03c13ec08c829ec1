//! The shadow maps on the adapter: layers of one texture, and the passes that draw into them.

use wgpu::{
    BindGroup, BindGroupDescriptor, BindGroupEntry, BindGroupLayout, BindGroupLayoutDescriptor,
    BindGroupLayoutEntry, BindingType, Buffer, BufferBinding, BufferUsages, CommandEncoder, Device,
    Extent3d, LoadOp, Operations, Origin3d, Queue, RenderPass, RenderPassDepthStencilAttachment,
    RenderPassDescriptor, Sampler, SamplerBindingType, ShaderStages, StoreOp, TexelCopyTextureInfo,
    Texture, TextureAspect, TextureDescriptor, TextureDimension, TextureSampleType, TextureUsages,
    TextureView, TextureViewDescriptor, TextureViewDimension,
};

use super::uniform::CasterUniform;
use crate::targets::DEPTH_FORMAT;
use crate::timing::Timing;

/// Passes of a frame: all maps of a closed world, and the figures.
pub const PASSES: usize = 8;
/// Uniforms begin at multiples of this many bytes, on every adapter.
const STRIDE: u64 = 256;

/// Layers of depth, as large as each other.
#[derive(Debug)]
pub struct Maps {
    /// All layers, for reading.
    pub all: TextureView,
    /// How they are read.
    pub sampler: Sampler,
    layers: Vec<TextureView>,
    texture: Texture,
    /// Texels of a side.
    pub texels: u32,
    uniforms: Buffer,
    bindings: BindGroup,
}

/// What the passes into the maps are bound by.
pub fn caster_layout(device: &Device) -> BindGroupLayout {
    device.create_bind_group_layout(&BindGroupLayoutDescriptor {
        label: Some("shadow caster"),
        entries: &[BindGroupLayoutEntry {
            binding: 0,
            visibility: ShaderStages::VERTEX,
            ty: BindingType::Buffer {
                ty: wgpu::BufferBindingType::Uniform,
                has_dynamic_offset: true,
                min_binding_size: None,
            },
            count: None,
        }],
    })
}

/// The layout of what the scene's shaders read maps by.
pub fn scene_entries() -> [BindGroupLayoutEntry; 2] {
    let entry = |binding, ty| BindGroupLayoutEntry {
        binding,
        visibility: ShaderStages::FRAGMENT,
        ty,
        count: None,
    };
    [
        entry(
            2,
            BindingType::Texture {
                sample_type: TextureSampleType::Depth,
                view_dimension: TextureViewDimension::D2Array,
                multisampled: false,
            },
        ),
        entry(3, BindingType::Sampler(SamplerBindingType::NonFiltering)),
    ]
}

impl Maps {
    /// So many layers of so many texels a side.
    pub fn new(device: &Device, texels: u32, layers: u32) -> Self {
        let texture = device.create_texture(&TextureDescriptor {
            label: Some("shadow maps"),
            size: Extent3d {
                width: texels,
                height: texels,
                depth_or_array_layers: layers,
            },
            mip_level_count: 1,
            sample_count: 1,
            dimension: TextureDimension::D2,
            format: DEPTH_FORMAT,
            usage: TextureUsages::RENDER_ATTACHMENT
                | TextureUsages::TEXTURE_BINDING
                | TextureUsages::COPY_SRC
                | TextureUsages::COPY_DST,
            view_formats: &[],
        });
        let view = |first: u32, count: u32, dimension| {
            texture.create_view(&TextureViewDescriptor {
                dimension: Some(dimension),
                base_array_layer: first,
                array_layer_count: Some(count),
                ..Default::default()
            })
        };
        let uniforms = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("shadow casters"),
            size: STRIDE * PASSES as u64,
            usage: BufferUsages::UNIFORM | BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let bindings = device.create_bind_group(&BindGroupDescriptor {
            label: Some("shadow casters"),
            layout: &caster_layout(device),
            entries: &[BindGroupEntry {
                binding: 0,
                resource: wgpu::BindingResource::Buffer(BufferBinding {
                    buffer: &uniforms,
                    offset: 0,
                    size: wgpu::BufferSize::new(size_of::<CasterUniform>() as u64),
                }),
            }],
        });
        Self {
            all: view(0, layers, TextureViewDimension::D2Array),
            sampler: device.create_sampler(&wgpu::SamplerDescriptor {
                label: Some("shadow maps"),
                ..Default::default()
            }),
            layers: (0..layers)
                .map(|layer| view(layer, 1, TextureViewDimension::D2))
                .collect(),
            texture,
            texels,
            uniforms,
            bindings,
        }
    }

    /// Tells the pass of that number what it draws.
    pub fn write(&self, queue: &Queue, pass: usize, uniform: &CasterUniform) {
        let at = STRIDE * (pass % PASSES) as u64;
        queue.write_buffer(&self.uniforms, at, bytemuck::bytes_of(uniform));
    }

    /// Copies a layer into another.
    pub fn copy(&self, encoder: &mut CommandEncoder, from: u32, to: u32) {
        let place = |layer| TexelCopyTextureInfo {
            texture: &self.texture,
            mip_level: 0,
            origin: Origin3d {
                x: 0,
                y: 0,
                z: layer,
            },
            aspect: TextureAspect::All,
        };
        let size = Extent3d {
            width: self.texels,
            height: self.texels,
            depth_or_array_layers: 1,
        };
        encoder.copy_texture_to_texture(place(from), place(to), size);
    }

    /// Begins the pass of that number into a layer, over what is there or over nothing.
    pub fn begin<'e>(
        &self,
        encoder: &'e mut CommandEncoder,
        pass: usize,
        layer: u32,
        is_fresh: bool,
        timing: Option<&Timing>,
    ) -> Option<RenderPass<'e>> {
        let view = self.layers.get(layer as usize)?;
        let load = if is_fresh {
            LoadOp::Clear(0.0)
        } else {
            LoadOp::Load
        };
        let mut begun = encoder.begin_render_pass(&RenderPassDescriptor {
            label: Some("shadows"),
            color_attachments: &[],
            depth_stencil_attachment: Some(RenderPassDepthStencilAttachment {
                view,
                depth_ops: Some(Operations {
                    load,
                    store: StoreOp::Store,
                }),
                stencil_ops: None,
            }),
            timestamp_writes: timing.map(Timing::begin),
            ..Default::default()
        });
        let offset = STRIDE as u32 * (pass % PASSES) as u32;
        begun.set_bind_group(3, &self.bindings, &[offset]);
        Some(begun)
    }
}
