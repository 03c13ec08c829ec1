//! Maps the light of the scene to the picture that is shown.

use wgpu::{
    BindGroup, BindGroupLayout, Color, CommandEncoder, Device, LoadOp, Operations, RenderPass,
    RenderPassColorAttachment, RenderPassDescriptor, RenderPassTimestampWrites, RenderPipeline,
    Sampler, ShaderStages, StoreOp, TextureFormat, TextureView,
};

use crate::error::RenderError;
use crate::shaders::{Shaders, TONEMAP, accepted};

/// The tone-map pass.
#[derive(Debug)]
pub struct Tonemap {
    pipeline: RenderPipeline,
    /// The same with left and right swapped, at whatever size.
    mirror: RenderPipeline,
    layout: BindGroupLayout,
    sampler: Sampler,
}

impl Tonemap {
    /// For targets of the format. `scaled`: whether the light is drawn at another resolution than it is shown at, at times.
    ///
    /// # Errors
    /// When the device refuses the shader.
    pub fn accepted(
        device: &Device,
        shaders: Shaders,
        output: TextureFormat,
        scaled: bool,
    ) -> Result<Self, RenderError> {
        accepted(device, || Self::new(device, shaders, output, scaled))
            .map_err(|said| RenderError::shader(&said))
    }

    fn new(device: &Device, shaders: Shaders, output: TextureFormat, scaled: bool) -> Self {
        let layout = layout(device);
        let sampler = device.create_sampler(&wgpu::SamplerDescriptor {
            label: Some("light"),
            mag_filter: wgpu::FilterMode::Linear,
            min_filter: wgpu::FilterMode::Linear,
            ..Default::default()
        });
        Self {
            pipeline: pipeline(device, shaders, &layout, output, scaled, false),
            mirror: pipeline(device, shaders, &layout, output, true, true),
            layout,
            sampler,
        }
    }

    /// Binds the light that is to be shown.
    pub fn bind(&self, device: &Device, light: &TextureView) -> BindGroup {
        device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("tonemap"),
            layout: &self.layout,
            entries: &[
                wgpu::BindGroupEntry {
                    binding: 0,
                    resource: wgpu::BindingResource::TextureView(light),
                },
                wgpu::BindGroupEntry {
                    binding: 1,
                    resource: wgpu::BindingResource::Sampler(&self.sampler),
                },
            ],
        })
    }

    /// Records the pass over all of a target.
    pub fn draw(
        &self,
        encoder: &mut CommandEncoder,
        light: &BindGroup,
        target: &TextureView,
        timestamp_writes: Option<RenderPassTimestampWrites<'_>>,
    ) {
        let load = LoadOp::Clear(Color::BLACK);
        let mut pass = begin(encoder, target, load, timestamp_writes);
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, light, &[]);
        pass.draw(0..3, 0..1);
    }

    /// Records the pass over a part of a target, the rest of which is black.
    pub fn draw_in(
        &self,
        encoder: &mut CommandEncoder,
        light: &BindGroup,
        target: &TextureView,
        place: &MirrorPlace,
    ) {
        let mut pass = begin(encoder, target, LoadOp::Clear(Color::BLACK), None);
        let [x, y, width, height] = [place.corner.0, place.corner.1, place.size.0, place.size.1];
        pass.set_scissor_rect(x, y, width, height);
        let [x, y, width, height] = [x, y, width, height].map(|pixels| pixels as f32);
        pass.set_viewport(x, y, width, height, 0.0, 1.0);
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, light, &[]);
        pass.draw(0..3, 0..1);
    }

    /// Records the pass over a part of a target, with left and right swapped.
    pub fn lay_mirror(
        &self,
        encoder: &mut CommandEncoder,
        light: &BindGroup,
        target: &TextureView,
        place: &MirrorPlace,
    ) {
        let mut pass = begin(encoder, target, LoadOp::Load, None);
        let [x, y, width, height] = [place.corner.0, place.corner.1, place.size.0, place.size.1];
        pass.set_scissor_rect(x, y, width, height);
        let [x, y, width, height] = [x, y, width, height].map(|pixels| pixels as f32);
        pass.set_viewport(x, y, width, height, 0.0, 1.0);
        pass.set_pipeline(&self.mirror);
        pass.set_bind_group(0, light, &[]);
        pass.draw(0..3, 0..1);
    }
}

/// The part of a picture that a mirror takes, pixels from its upper left corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MirrorPlace {
    /// Its own upper left corner.
    pub corner: (u32, u32),
    /// Width and height.
    pub size: (u32, u32),
}

impl MirrorPlace {
    /// What of it lies in a target of that size; none where nothing does.
    pub fn within(self, target: (u32, u32)) -> Option<Self> {
        let cut = |from: u32, length: u32, end: u32| length.min(end.saturating_sub(from));
        let size = (
            cut(self.corner.0, self.size.0, target.0),
            cut(self.corner.1, self.size.1, target.1),
        );
        (size.0 > 0 && size.1 > 0).then_some(Self { size, ..self })
    }
}

fn begin<'e>(
    encoder: &'e mut CommandEncoder,
    target: &TextureView,
    load: LoadOp<Color>,
    timestamp_writes: Option<RenderPassTimestampWrites<'_>>,
) -> RenderPass<'e> {
    encoder.begin_render_pass(&RenderPassDescriptor {
        label: Some("picture"),
        color_attachments: &[Some(RenderPassColorAttachment {
            view: target,
            depth_slice: None,
            resolve_target: None,
            ops: Operations {
                load,
                store: StoreOp::Store,
            },
        })],
        timestamp_writes,
        ..Default::default()
    })
}

/// What light is read by.
pub(crate) fn layout(device: &Device) -> BindGroupLayout {
    let entry = |binding, ty| wgpu::BindGroupLayoutEntry {
        binding,
        visibility: ShaderStages::FRAGMENT,
        ty,
        count: None,
    };
    let texture = wgpu::BindingType::Texture {
        sample_type: wgpu::TextureSampleType::Float { filterable: true },
        view_dimension: wgpu::TextureViewDimension::D2,
        multisampled: false,
    };
    let sampler = wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering);
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("tonemap"),
        entries: &[entry(0, texture), entry(1, sampler)],
    })
}

fn pipeline(
    device: &Device,
    shaders: Shaders,
    layout: &BindGroupLayout,
    output: TextureFormat,
    scaled: bool,
    swapped: bool,
) -> RenderPipeline {
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some("tonemap"),
        bind_group_layouts: &[Some(layout)],
        immediate_size: 0,
    });
    let module = shaders.compile(device, TONEMAP, None);
    let constants = [
        ("SCALED", f64::from(u8::from(scaled))),
        ("SWAPPED", f64::from(u8::from(swapped))),
        ("ENCODED", f64::from(u8::from(!output.is_srgb()))),
    ];
    let compilation_options = wgpu::PipelineCompilationOptions {
        constants: &constants,
        ..Default::default()
    };
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("tonemap"),
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module: &module,
            entry_point: Some("vertex"),
            compilation_options: compilation_options.clone(),
            buffers: &[],
        },
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil: None,
        multisample: wgpu::MultisampleState::default(),
        fragment: Some(wgpu::FragmentState {
            module: &module,
            entry_point: Some("fragment"),
            compilation_options,
            targets: &[Some(output.into())],
        }),
        multiview_mask: None,
        cache: None,
    })
}
