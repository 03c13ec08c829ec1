//! The pipelines: one for each way of drawing something.

use wgpu::{
    BindGroupLayout, BlendComponent, BlendFactor, BlendOperation, BlendState, CompareFunction, Device, RenderPipeline,
    ShaderModule, ShaderStages, TextureFormat, VertexAttribute, VertexBufferLayout, VertexStepMode,
};

use crate::chunk_store::{VERTEX_ATTRIBUTES, VERTEX_BYTES};
use crate::shaders::{FIGURE, MARKER, SKY, TERRAIN, TONEMAP};
use crate::solids::ModelVertex;
use crate::targets::{DEPTH_FORMAT, LIGHT_FORMAT};
use crate::uniforms::{ChunkInstance, FigureInstance, MarkerInstance};

/// Everything a frame is drawn with.
#[derive(Debug)]
pub struct Pipelines {
    /// Land.
    pub terrain: RenderPipeline,
    /// Land that reaches over the equator.
    pub terrain_rim: RenderPipeline,
    /// Figures.
    pub figure: RenderPipeline,
    /// Sky, behind everything.
    pub sky: RenderPipeline,
    /// The marker where it is seen.
    pub marker: RenderPipeline,
    /// The marker where land hides it.
    pub marker_hidden: RenderPipeline,
    /// Light to display.
    pub tonemap: RenderPipeline,
    /// Binds the scene's uniform.
    pub scene_layout: BindGroupLayout,
    /// Binds the light and its sampler.
    pub tonemap_layout: BindGroupLayout,
}

/// Colours come multiplied by their opacity.
const TRANSLUCENT: BlendState = BlendState {
    color: BlendComponent {
        src_factor: BlendFactor::One,
        dst_factor: BlendFactor::OneMinusSrcAlpha,
        operation: BlendOperation::Add,
    },
    alpha: BlendComponent::OVER,
};

/// How one pipeline of the scene pass differs from the others.
struct Recipe<'a> {
    module: &'a ShaderModule,
    fragment: &'static str,
    buffers: &'a [Option<VertexBufferLayout<'a>>],
    depth_compare: CompareFunction,
    depth_write: bool,
    blend: Option<BlendState>,
    culled: bool,
}

impl Pipelines {
    /// Compiles all shaders for the given samples a pixel and target format. `scaled` says whether the light
    /// is drawn at another resolution than it is shown at.
    pub fn new(device: &Device, samples: u32, output: TextureFormat, scaled: bool) -> Self {
        let scene_layout = scene_layout(device);
        let land = [buffer(VERTEX_BYTES, VertexStepMode::Vertex, &VERTEX_ATTRIBUTES), instance::<ChunkInstance>(&ChunkInstance::ATTRIBUTES)];
        let figure = [model(), instance::<FigureInstance>(&FigureInstance::ATTRIBUTES)];
        let position = wgpu::vertex_attr_array![0 => Float32x3];
        let marker = [buffer(12, VertexStepMode::Vertex, &position), instance::<MarkerInstance>(&MarkerInstance::ATTRIBUTES)];
        let [terrain_module, figure_module, sky_module, marker_module] =
            [TERRAIN, FIGURE, SKY, MARKER].map(|shader| shader.compile(device));
        let make = |recipe: &Recipe<'_>| scene_pipeline(device, &scene_layout, samples, recipe);
        let solid = |module, fragment, buffers| Recipe {
            module,
            fragment,
            buffers,
            depth_compare: CompareFunction::Greater,
            depth_write: true,
            blend: None,
            culled: true,
        };
        let glass = |fragment, depth_compare| Recipe {
            depth_compare,
            depth_write: false,
            blend: Some(TRANSLUCENT),
            ..solid(&marker_module, fragment, &marker)
        };
        let sky =
            Recipe { depth_compare: CompareFunction::GreaterEqual, depth_write: false, culled: false, ..solid(&sky_module, "fragment", &[]) };
        let (tonemap, tonemap_layout) = tonemap_pipeline(device, output, scaled);
        Self {
            terrain: make(&solid(&terrain_module, "fragment", &land)),
            terrain_rim: make(&solid(&terrain_module, "fragment_rim", &land)),
            figure: make(&solid(&figure_module, "fragment", &figure)),
            sky: make(&sky),
            marker: make(&glass("fragment", CompareFunction::GreaterEqual)),
            marker_hidden: make(&glass("fragment_hidden", CompareFunction::Less)),
            tonemap,
            scene_layout,
            tonemap_layout,
        }
    }
}

fn buffer(array_stride: u64, step_mode: VertexStepMode, attributes: &[VertexAttribute]) -> Option<VertexBufferLayout<'_>> {
    Some(VertexBufferLayout { array_stride, step_mode, attributes })
}

fn instance<T>(attributes: &[VertexAttribute]) -> Option<VertexBufferLayout<'_>> {
    buffer(size_of::<T>() as u64, VertexStepMode::Instance, attributes)
}

fn model() -> Option<VertexBufferLayout<'static>> {
    buffer(size_of::<ModelVertex>() as u64, VertexStepMode::Vertex, &ModelVertex::ATTRIBUTES)
}

fn scene_layout(device: &Device) -> BindGroupLayout {
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("scene"),
        entries: &[wgpu::BindGroupLayoutEntry {
            binding: 0,
            visibility: ShaderStages::VERTEX_FRAGMENT,
            ty: wgpu::BindingType::Buffer {
                ty: wgpu::BufferBindingType::Uniform,
                has_dynamic_offset: false,
                min_binding_size: None,
            },
            count: None,
        }],
    })
}

fn scene_pipeline(device: &Device, layout: &BindGroupLayout, samples: u32, recipe: &Recipe<'_>) -> RenderPipeline {
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some("scene"),
        bind_group_layouts: &[Some(layout)],
        immediate_size: 0,
    });
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some(recipe.fragment),
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module: recipe.module,
            entry_point: Some("vertex"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            buffers: recipe.buffers,
        },
        primitive: wgpu::PrimitiveState {
            front_face: wgpu::FrontFace::Ccw,
            cull_mode: recipe.culled.then_some(wgpu::Face::Back),
            ..Default::default()
        },
        depth_stencil: Some(wgpu::DepthStencilState {
            format: DEPTH_FORMAT,
            depth_write_enabled: Some(recipe.depth_write),
            depth_compare: Some(recipe.depth_compare),
            stencil: wgpu::StencilState::default(),
            bias: wgpu::DepthBiasState::default(),
        }),
        multisample: wgpu::MultisampleState { count: samples, ..Default::default() },
        fragment: Some(wgpu::FragmentState {
            module: recipe.module,
            entry_point: Some(recipe.fragment),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            targets: &[Some(wgpu::ColorTargetState {
                format: LIGHT_FORMAT,
                blend: recipe.blend,
                write_mask: wgpu::ColorWrites::ALL,
            })],
        }),
        multiview_mask: None,
        cache: None,
    })
}

fn tonemap_layout(device: &Device) -> BindGroupLayout {
    let entry = |binding, ty| wgpu::BindGroupLayoutEntry { binding, visibility: ShaderStages::FRAGMENT, ty, count: None };
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

fn tonemap_pipeline(device: &Device, output: TextureFormat, scaled: bool) -> (RenderPipeline, BindGroupLayout) {
    let bindings = tonemap_layout(device);
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some("tonemap"),
        bind_group_layouts: &[Some(&bindings)],
        immediate_size: 0,
    });
    let module = TONEMAP.compile(device);
    let constants = [("SCALED", f64::from(u8::from(scaled))), ("ENCODED", f64::from(u8::from(!output.is_srgb())))];
    let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("tonemap"),
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
            entry_point: Some("fragment"),
            compilation_options: wgpu::PipelineCompilationOptions { constants: &constants, ..Default::default() },
            targets: &[Some(output.into())],
        }),
        multiview_mask: None,
        cache: None,
    });
    (pipeline, bindings)
}
