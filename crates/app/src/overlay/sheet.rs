//! A texture that keeps the interface from one frame to the next, to be laid over their pictures.

use wgpu::{
    BindGroup, BindGroupLayout, BlendState, Device, RenderPass, RenderPipeline, TextureFormat,
    TextureUsages, TextureView,
};

use super::change::Tiles;

/// Draws what is kept, and empties it.
#[derive(Debug)]
pub(super) struct Layer {
    format: TextureFormat,
    layout: BindGroupLayout,
    lay: RenderPipeline,
    empty: RenderPipeline,
}

/// What is kept of the interface: its colours multiplied by their opacity.
#[derive(Debug)]
pub(super) struct Sheet {
    pub view: TextureView,
    binding: BindGroup,
}

impl Layer {
    /// For targets of a format.
    pub fn new(device: &Device, format: TextureFormat) -> Self {
        let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("interface"),
            entries: &[wgpu::BindGroupLayoutEntry {
                binding: 0,
                visibility: wgpu::ShaderStages::FRAGMENT,
                ty: wgpu::BindingType::Texture {
                    sample_type: wgpu::TextureSampleType::Float { filterable: false },
                    view_dimension: wgpu::TextureViewDimension::D2,
                    multisampled: false,
                },
                count: None,
            }],
        });
        let blend = Some(BlendState::PREMULTIPLIED_ALPHA_BLENDING);
        Self {
            lay: pipeline(device, &layout, format, "fragment", blend),
            empty: pipeline(device, &layout, format, "fragment_empty", None),
            format,
            layout,
        }
    }

    /// An empty sheet of `size` pixels.
    pub fn sheet(&self, device: &Device, size: (u32, u32)) -> Sheet {
        let texture = device.create_texture(&wgpu::TextureDescriptor {
            label: Some("interface"),
            size: wgpu::Extent3d {
                width: size.0,
                height: size.1,
                depth_or_array_layers: 1,
            },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: self.format,
            usage: TextureUsages::RENDER_ATTACHMENT | TextureUsages::TEXTURE_BINDING,
            view_formats: &[],
        });
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        let binding = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("interface"),
            layout: &self.layout,
            entries: &[wgpu::BindGroupEntry {
                binding: 0,
                resource: wgpu::BindingResource::TextureView(&view),
            }],
        });
        Sheet { view, binding }
    }

    /// Lays some tiles of a sheet over what a pass draws into.
    pub fn lay(&self, pass: &mut RenderPass<'_>, sheet: &Sheet, tiles: &Tiles) {
        pass.set_bind_group(0, &sheet.binding, &[]);
        draw(pass, &self.lay, tiles);
    }

    /// Empties some tiles of what a pass draws into.
    pub fn empty(&self, pass: &mut RenderPass<'_>, tiles: &Tiles) {
        draw(pass, &self.empty, tiles);
    }
}

fn draw(pass: &mut RenderPass<'_>, pipeline: &RenderPipeline, tiles: &Tiles) {
    pass.set_pipeline(pipeline);
    for [x, y, width, height] in tiles.rectangles() {
        pass.set_scissor_rect(x, y, width, height);
        pass.draw(0..3, 0..1);
    }
}

fn pipeline(
    device: &Device,
    layout: &BindGroupLayout,
    format: TextureFormat,
    fragment: &str,
    blend: Option<BlendState>,
) -> RenderPipeline {
    let module = device.create_shader_module(wgpu::include_wgsl!("sheet.wgsl"));
    let groups = [Some(layout)];
    let is_read = blend.is_some();
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some("interface"),
        bind_group_layouts: if is_read { &groups } else { &[] },
        immediate_size: 0,
    });
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("interface"),
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module: &module,
            entry_point: Some("vertex"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            buffers: &[],
        },
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil: None,
        multisample: wgpu::MultisampleState::default(),
        fragment: Some(wgpu::FragmentState {
            module: &module,
            entry_point: Some(fragment),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            targets: &[Some(wgpu::ColorTargetState {
                format,
                blend,
                write_mask: wgpu::ColorWrites::ALL,
            })],
        }),
        multiview_mask: None,
        cache: None,
    })
}
