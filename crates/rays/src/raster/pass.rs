//! The passes of a raster, and the one by rays that goes on from there.

use std::ops::Range;
use std::sync::OnceLock;

use bytemuck::{bytes_of, cast_slice};
use glam::DVec2;
use wgpu::{
    BindGroup, BindGroupLayout, BindingResource, BindingType, Buffer, BufferUsages, CommandEncoder,
    ComputePipeline, Device, Queue, RenderPass, RenderPipeline, ShaderStages, TextureView,
};

use super::draws::{Call, Draws, PackedDraw, PackedView, Stock, pack};
use super::plan::Plan;
use super::target::{DEPTH_FORMAT, VISIBLE_FORMAT, Visible};
use crate::kinds::Kinds;
use crate::loaded::Loaded;
use crate::packed::Rule;
use crate::rays::{READ, buffer, group, layout, pipeline_with};
use crate::shaders::{RASTER, RASTERED};

/// Views that a picture has at most; their numbers are bytes.
pub const MOST_VIEWS: usize = 64;
/// Numbers at the head of the views.
const VIEWS_HEAD: u64 = 16;

/// What draws what is seen.
#[derive(Debug)]
pub struct Raster {
    draws_layout: BindGroupLayout,
    /// What the pass by rays is bound to beside what it has always.
    pub visible_layout: BindGroupLayout,
    first: Pair,
    first_cut: RenderPipeline,
    deeper: Pair,
    /// By the number of what is told beforehand; compiled when they are asked for.
    rays: [[OnceLock<ComputePipeline>; Kinds::COUNT]; 2],
    views: Buffer,
    nothing: TextureView,
}

/// For triangles, and for faces.
#[derive(Debug)]
struct Pair {
    triangles: RenderPipeline,
    faces: RenderPipeline,
}

/// The part of a picture that is drawn.
#[derive(Clone, Debug)]
pub struct Region {
    /// Pixels of the picture.
    pub size: (u32, u32),
    /// Which rows.
    pub rows: Range<u32>,
    /// Where in a pixel each sample is, in pixels from its middle.
    pub samples: Vec<DVec2>,
}

impl Raster {
    /// Compiles the shaders.
    pub fn new(device: &Device) -> Self {
        let draws_layout = draws_layout(device);
        let visible_layout = layout(
            device,
            "what a raster sees",
            &[texels(wgpu::TextureViewDimension::D2Array), buffer(READ)],
        );
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("raster"),
            source: wgpu::ShaderSource::Wgsl(RASTER.into()),
        });
        let pair = |fragment| Pair {
            triangles: render_pipeline(device, &draws_layout, &module, ("triangle", fragment)),
            faces: render_pipeline(device, &draws_layout, &module, ("face", fragment)),
        };
        Self {
            first: pair("first"),
            first_cut: render_pipeline(device, &draws_layout, &module, ("triangle", "first_cut")),
            deeper: pair("deeper"),
            rays: std::array::from_fn(|_| std::array::from_fn(|_| OnceLock::new())),
            views: device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("views of a raster"),
                size: VIEWS_HEAD + (MOST_VIEWS * size_of::<PackedView>()) as u64,
                usage: BufferUsages::STORAGE | BufferUsages::COPY_DST,
                mapped_at_creation: false,
            }),
            nothing: Visible::new(device, (1, 1), 1).each.remove(0),
            draws_layout,
            visible_layout,
        }
    }

    /// The pass by rays that goes on where a raster has seen something. `sees_all`: there is nothing that only rays know, and
    /// light goes on from nothing.
    pub fn rays(
        &self,
        device: &Device,
        layouts: [&BindGroupLayout; 2],
        kinds: Kinds,
        sees_all: bool,
    ) -> &ComputePipeline {
        self.rays[usize::from(sees_all)][kinds.number()].get_or_init(|| {
            let [scene, picture] = layouts;
            let layouts = [scene, picture, &self.visible_layout];
            let more = [("SEES_ALL", f64::from(u8::from(sees_all)))];
            pipeline_with(
                device,
                ("rays of a raster", &RASTERED, "draw"),
                &layouts,
                kinds,
                &more,
            )
        })
    }

    /// Whether that pass is compiled.
    pub fn has_rays(&self, kinds: Kinds, sees_all: bool) -> bool {
        self.rays[usize::from(sees_all)][kinds.number()]
            .get()
            .is_some()
    }

    /// Records the passes that write what is seen.
    pub fn draw(
        &self,
        (device, queue): (&Device, &Queue),
        encoder: &mut CommandEncoder,
        (loaded, plan): (&Loaded, &Plan),
        (visible, region): (&Visible, &Region),
        rule: Rule,
    ) {
        let samples = self.prepare((device, queue), (loaded, plan), region, rule);
        let packed: Vec<_> = samples.iter().flat_map(|it| &it.packed).copied().collect();
        let draws = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("draws of a raster"),
            size: (packed.len().max(1) * size_of::<PackedDraw>()) as u64,
            usage: BufferUsages::STORAGE | BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        queue.write_buffer(&draws, 0, cast_slice(&packed));
        for level in 0..plan.levels() {
            let before = match level {
                0 => &self.nothing,
                _ => &visible.each[level - 1],
            };
            let resources = [
                BindingResource::TextureView(&loaded.triangles.view),
                draws.as_entire_binding(),
                BindingResource::TextureView(before),
            ];
            let bound = group(device, "draws of a raster", &self.draws_layout, resources);
            let mut pass = begin(encoder, visible, level);
            pass.set_bind_group(0, &bound, &[]);
            // Behind doors all is cut.
            let (pair, cut) = match level {
                0 => (&self.first, &self.first_cut),
                _ => (&self.deeper, &self.deeper.triangles),
            };
            let mut first = 0;
            for (number, draws) in samples.iter().enumerate() {
                let top = number as u32 * region.size.1;
                let calls = draws.calls.iter().filter(|call| call.level == level);
                record(&mut pass, (pair, cut), (region, top), first, calls);
                first += draws.packed.len() as u32;
            }
        }
    }

    /// Writes the views, and lists what each sample draws.
    fn prepare(
        &self,
        (_, queue): (&Device, &Queue),
        (loaded, plan): (&Loaded, &Plan),
        region: &Region,
        rule: Rule,
    ) -> Vec<Draws> {
        let boxes = loaded.aberrations().placed();
        // In coordinates of the scene one view passes all faces.
        let looks = rule == Rule::Plain && loaded.kinds(rule).faces;
        let looked_for = if looks { boxes.len() } else { 0 };
        let head = [plan.levels() as u32, looked_for as u32, 0, 0];
        let views: Vec<_> = plan.views.iter().map(pack).collect();
        queue.write_buffer(&self.views, 0, bytes_of(&head));
        queue.write_buffer(&self.views, VIEWS_HEAD, cast_slice(&views));
        let stock = Stock {
            chunks: &loaded.chunks,
            moved: &loaded.moved,
        };
        let size = DVec2::new(f64::from(region.size.0), f64::from(region.size.1));
        let of_sample = |offset: &DVec2| {
            let mut draws = Draws::default();
            draws.add(plan, &stock, 2.0 * DVec2::new(-offset.x, offset.y) / size);
            draws
        };
        region.samples.iter().map(of_sample).collect()
    }

    /// What the pass by rays is bound to.
    pub fn visible_group(&self, device: &Device, visible: &Visible) -> BindGroup {
        let resources = [
            BindingResource::TextureView(&visible.all),
            self.views.as_entire_binding(),
        ];
        group(
            device,
            "what a raster sees",
            &self.visible_layout,
            resources,
        )
    }
}

fn record<'a>(
    pass: &mut RenderPass<'_>,
    (pair, cut): (&Pair, &RenderPipeline),
    (region, top): (&Region, u32),
    first: u32,
    calls: impl Iterator<Item = &'a Call>,
) {
    let (width, height) = region.size;
    pass.set_viewport(0.0, top as f32, width as f32, height as f32, 0.0, 1.0);
    for call in calls {
        let Some((low, high)) = scissor(call, region) else {
            continue;
        };
        pass.set_scissor_rect(low.0, top + low.1, high.0 - low.0, high.1 - low.1);
        pass.set_pipeline(match (call.is_faces, call.is_cut) {
            (true, _) => &pair.faces,
            (false, true) => cut,
            (false, false) => &pair.triangles,
        });
        let draws = first + call.draws.start..first + call.draws.end;
        pass.draw(call.vertices.clone(), draws);
    }
}

/// Pixels that a call may change, from the top left: the first, and the one behind the last; none where there are none.
fn scissor(call: &Call, region: &Region) -> Option<((u32, u32), (u32, u32))> {
    let (low, high) = call.extent;
    let along = |share: f64, pixels: u32, spare: f64| {
        let at = (0.5 + 0.5 * share) * f64::from(pixels) + spare;
        at.clamp(0.0, f64::from(pixels)) as u32
    };
    let (width, height) = region.size;
    let x = along(low.x, width, -1.0)..along(high.x, width, 2.0);
    let y = along(-high.y, height, -1.0)..along(-low.y, height, 2.0);
    let y = y.start.max(region.rows.start)..y.end.min(region.rows.end);
    (x.start < x.end && y.start < y.end).then_some(((x.start, y.start), (x.end, y.end)))
}

fn begin<'a>(encoder: &'a mut CommandEncoder, visible: &Visible, level: usize) -> RenderPass<'a> {
    use wgpu::{LoadOp::Clear, Operations, StoreOp};
    encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: Some("what is seen"),
        color_attachments: &[Some(wgpu::RenderPassColorAttachment {
            view: &visible.each[level],
            depth_slice: None,
            resolve_target: None,
            ops: Operations {
                load: Clear(wgpu::Color::TRANSPARENT),
                store: StoreOp::Store,
            },
        })],
        depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
            view: &visible.depth,
            depth_ops: Some(Operations {
                load: Clear(0.0),
                store: StoreOp::Discard,
            }),
            stencil_ops: None,
        }),
        ..Default::default()
    })
}

fn texels(view_dimension: wgpu::TextureViewDimension) -> BindingType {
    BindingType::Texture {
        sample_type: wgpu::TextureSampleType::Uint,
        view_dimension,
        multisampled: false,
    }
}

fn draws_layout(device: &Device) -> BindGroupLayout {
    let entry = |binding, visibility, ty| wgpu::BindGroupLayoutEntry {
        binding,
        visibility,
        ty,
        count: None,
    };
    let list = texels(wgpu::TextureViewDimension::D2);
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("draws of a raster"),
        entries: &[
            entry(0, ShaderStages::VERTEX, list),
            entry(1, ShaderStages::VERTEX, buffer(READ)),
            entry(2, ShaderStages::FRAGMENT, list),
        ],
    })
}

fn render_pipeline(
    device: &Device,
    draws: &BindGroupLayout,
    module: &wgpu::ShaderModule,
    (vertex, fragment): (&str, &str),
) -> RenderPipeline {
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some("raster"),
        bind_group_layouts: &[Some(draws)],
        immediate_size: 0,
    });
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("raster"),
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module,
            entry_point: Some(vertex),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            buffers: &[],
        },
        fragment: Some(wgpu::FragmentState {
            module,
            entry_point: Some(fragment),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            targets: &[Some(VISIBLE_FORMAT.into())],
        }),
        // Rays meet triangles from both sides.
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil: Some(wgpu::DepthStencilState {
            format: DEPTH_FORMAT,
            depth_write_enabled: Some(true),
            // Depth falls with distance, which keeps it as fine far off as near by.
            depth_compare: Some(wgpu::CompareFunction::Greater),
            stencil: wgpu::StencilState::default(),
            bias: wgpu::DepthBiasState::default(),
        }),
        multisample: wgpu::MultisampleState::default(),
        multiview_mask: None,
        cache: None,
    })
}
