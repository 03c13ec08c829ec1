//! Makes the pipelines of the scene pass, one for each way of drawing something.

#[cfg(test)]
mod tests;
mod way;

use antipode_geometry::MapShader;
use wgpu::{
    BindGroupLayout, CompareFunction, Device, PipelineLayout, RenderPipeline, ShaderModule,
    VertexAttribute, VertexBufferLayout, VertexStepMode,
};

use crate::celestial::{CelestialPipelines, Star};
use crate::charts::chart_layout;
use crate::chunk_store::{VERTEX_ATTRIBUTES, VERTEX_BYTES};
use crate::dust::DustPipelines;
use crate::figure_buffers::joints_layout;
use crate::figure_pipelines::FigurePipelines;
use crate::heavens::Heavens;
use crate::outlines;
use crate::pipeline_cache::Key;
use crate::renderer::{PipelineQuality, Preset};
use crate::shaders::{
    CELESTIAL, MARKER, OPENING, OUTLINES, SKY, Shader, Shaders, TERRAIN, accepted,
};
use crate::shadow::{ShadowQuality, caster_layout, scene_entries};
use crate::targets::{DEPTH_FORMAT, LIGHT_FORMAT};
use crate::terrain_pipelines::{ShadowReach, TerrainPipelines};
use crate::tonemap::layout as light_layout;
use crate::uniforms::{ChunkInstance, MarkerInstance, OutlineInstance};

pub(crate) use way::{BENT, GLASS, SOLID, VEIL, Way};
use way::{OPEN, SHINE};

/// Everything the scene is drawn with.
#[derive(Debug)]
pub struct Pipelines {
    /// Land.
    pub terrain: TerrainPipelines,
    /// Figures.
    pub figures: FigurePipelines,
    /// Sky, behind everything.
    pub sky: RenderPipeline,
    /// The same with clouds.
    pub cloudy_sky: RenderPipeline,
    /// The band of faint stars over it.
    pub band: RenderPipeline,
    /// Sun, moon and stars.
    pub celestial: CelestialPipelines,
    /// The marker where it is seen.
    pub marker: RenderPipeline,
    /// The marker where land hides it.
    pub marker_hidden: RenderPipeline,
    /// Outlines of hit shapes where they are seen.
    pub outlines: RenderPipeline,
    /// The same where something hides them.
    pub outlines_hidden: RenderPipeline,
    /// What flies off the ground and is pressed into it.
    pub dust: DustPipelines,
    /// Openings of doors, with what was drawn of the other side.
    pub opening: RenderPipeline,
    /// The same with haze.
    pub opening_haze: RenderPipeline,
    /// Land into a shadow map.
    pub caster: RenderPipeline,
    /// Nothing into a part of one, whatever was there.
    pub hole: RenderPipeline,
}

impl Pipelines {
    /// Compiles the scene's shaders for one map of the space, so many samples a pixel, shadows of a quality and a preset.
    ///
    /// # Errors
    /// What the map's text lacks, or what the device has to say against one of them; either names the map.
    pub fn new(
        device: &Device,
        shaders: Shaders,
        scene_layout: &BindGroupLayout,
        key: Key,
        (samples, shadows, preset): PipelineQuality,
    ) -> Result<Self, String> {
        let refused = |why| format!("the map \"{}\" cannot be drawn: {why}", key.map.name);
        if let Some((file, function)) = key.map.lacks() {
            return Err(refused(format!("\"{file}\" has no function {function}")));
        }
        let made = accepted(device, || {
            let maker = Maker::new(device, shaders, scene_layout, key, samples);
            Self::made_by(&Maker {
                shadows,
                preset,
                by_pixel: preset == Preset::Card,
                ..maker
            })
        });
        made.map_err(refused)
    }

    fn made_by(maker: &Maker<'_>) -> Self {
        let [land, sky, marker] = [TERRAIN, SKY, MARKER].map(|shader| maker.compile(shader));
        let land_buffers = [
            layout(VERTEX_BYTES, VertexStepMode::Vertex, &VERTEX_ATTRIBUTES),
            instances::<ChunkInstance>(&ChunkInstance::ATTRIBUTES),
        ];
        let position = wgpu::vertex_attr_array![0 => Float32x3];
        let marker_buffers = [
            layout(position[0].format.size(), VertexStepMode::Vertex, &position),
            instances::<MarkerInstance>(&MarkerInstance::ATTRIBUTES),
        ];
        let glass = |fragment, compare| {
            maker.make(
                &marker,
                ["vertex", fragment],
                &marker_buffers,
                Way { compare, ..GLASS },
            )
        };
        let dome = |fragment| {
            let way = Way {
                blend: None,
                ..SHINE
            };
            maker.make(&sky, ["vertex", fragment], &[], way)
        };
        let [outlines, outlines_hidden] = maker.outlines();
        let [opening, opening_haze] = maker.openings();
        Self {
            terrain: TerrainPipelines::made_by(maker, &land, &land_buffers),
            figures: FigurePipelines::made_by(maker),
            sky: dome("fragment"),
            cloudy_sky: dome("fragment_clouds"),
            band: maker.make(&sky, ["vertex", "fragment_band"], &[], SHINE),
            celestial: maker.celestial(),
            marker: glass("fragment", CompareFunction::GreaterEqual),
            marker_hidden: glass("fragment_hidden", CompareFunction::Less),
            outlines,
            outlines_hidden,
            dust: DustPipelines::made_by(maker),
            opening,
            opening_haze,
            caster: maker.caster(&land, "vertex_caster", &land_buffers),
            hole: maker.caster(&land, "vertex_hole", &[]),
        }
    }
}

/// What all pipelines of the scene pass have in common.
#[derive(Clone)]
pub(crate) struct Maker<'a> {
    device: &'a Device,
    shaders: Shaders,
    layout: PipelineLayout,
    bent_layout: PipelineLayout,
    open_layout: PipelineLayout,
    caster_layout: PipelineLayout,
    figure_caster_layout: PipelineLayout,
    /// The map that it compiles for.
    pub(crate) map: &'static MapShader,
    samples: u32,
    pub(crate) shadows: ShadowQuality,
    pub(crate) preset: Preset,
    by_figures: bool,
    /// Whether lamps or beams may light what is drawn.
    lit: bool,
    /// Whether it is shown what surfaces are made of.
    by_pixel: bool,
    /// Whether sheets may cut off what is drawn.
    cuts: bool,
}

impl<'a> Maker<'a> {
    fn new(
        device: &'a Device,
        shaders: Shaders,
        scene_layout: &BindGroupLayout,
        key: Key,
        samples: u32,
    ) -> Self {
        let layout = |label, groups: &[Option<&BindGroupLayout>]| {
            device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
                label: Some(label),
                bind_group_layouts: groups,
                immediate_size: 0,
            })
        };
        let [chart, joints] = [chart_layout(device), joints_layout(device)];
        let (chart, joints) = (Some(&chart), Some(&joints));
        // What the scene reads is not bound where a map is drawn: the map is a part of it.
        let caster = caster_layout(device);
        let caster = Some(&caster);
        Self {
            device,
            shaders,
            layout: layout("scene", &[Some(scene_layout), chart]),
            open_layout: layout(
                "open",
                &[Some(scene_layout), chart, Some(&light_layout(device))],
            ),
            bent_layout: layout("bent", &[Some(scene_layout), chart, joints]),
            caster_layout: layout("shadow caster", &[None, chart, None, caster]),
            figure_caster_layout: layout("figure shadow caster", &[None, chart, joints, caster]),
            map: key.map,
            samples,
            shadows: ShadowQuality::Off,
            preset: Preset::Card,
            by_figures: true,
            lit: true,
            by_pixel: true,
            cuts: key.is_cut,
        }
    }

    /// One that makes the same for what only some shadows reach.
    pub(crate) fn reached(&self, reach: ShadowReach) -> Self {
        Self {
            shadows: match reach {
                ShadowReach::Nothing => ShadowQuality::Off,
                ShadowReach::All | ShadowReach::Land => self.shadows,
            },
            by_figures: reach == ShadowReach::All,
            ..self.clone()
        }
    }

    /// One that makes the same for what no lamp or beam lights.
    pub(crate) fn unlit(&self) -> Self {
        Self {
            lit: false,
            ..self.clone()
        }
    }

    /// One that makes the same for what is so far off that what it is made of is not seen.
    pub(crate) fn far(&self) -> Self {
        Self {
            by_pixel: false,
            ..self.clone()
        }
    }

    /// One that makes the same for what no sheet cuts.
    pub(crate) fn uncut(&self) -> Self {
        Self {
            cuts: false,
            ..self.clone()
        }
    }

    pub(crate) fn compile(&self, shader: Shader) -> ShaderModule {
        self.shaders.compile(self.device, shader, Some(self.map))
    }

    /// Openings with what lies beyond, and with haze.
    fn openings(&self) -> [RenderPipeline; 2] {
        let module = self.compile(OPENING);
        let offset = wgpu::vertex_attr_array![0 => Float32x3];
        let buffers = [layout(
            offset[0].format.size(),
            VertexStepMode::Vertex,
            &offset,
        )];
        ["fragment", "fragment_haze"]
            .map(|fragment| self.make(&module, ["vertex", fragment], &buffers, OPEN))
    }

    /// Lines before what is nearer, and those behind it.
    fn outlines(&self) -> [RenderPipeline; 2] {
        let module = self.compile(OUTLINES);
        let buffers = [
            layout(
                size_of::<outlines::Corner>() as u64,
                VertexStepMode::Vertex,
                &outlines::Corner::ATTRIBUTES,
            ),
            instances::<OutlineInstance>(&OutlineInstance::ATTRIBUTES),
        ];
        [
            ("fragment", CompareFunction::GreaterEqual),
            ("fragment_hidden", CompareFunction::Less),
        ]
        .map(|(fragment, compare)| {
            let way = Way { compare, ..VEIL };
            self.make(&module, ["vertex", fragment], &buffers, way)
        })
    }

    fn celestial(&self) -> CelestialPipelines {
        let module = self.compile(CELESTIAL);
        let stars = [instances::<Star>(&Star::ATTRIBUTES)];
        CelestialPipelines {
            sun: self.make(&module, ["vertex_sun", "fragment_sun"], &[], SHINE),
            moon: self.make(&module, ["vertex_moon", "fragment_moon"], &[], SHINE),
            star: self.make(&module, ["vertex_star", "fragment_star"], &stars, SHINE),
            orb: self.make(&module, ["vertex_orb", "fragment_orb"], &[], SHINE),
        }
    }

    /// What throws shadows, from both sides: land has no underside where it ends.
    pub(crate) fn caster(
        &self,
        module: &ShaderModule,
        entry: &str,
        buffers: &[VertexBufferLayout<'_>],
    ) -> RenderPipeline {
        self.cast(&self.caster_layout, (module, entry), buffers)
    }

    /// As [`Maker::caster`], of figures. All of them have the same layout, bent or not: adapters keep what is bound behind
    /// the joints from one pipeline to the next only where the layouts agree as far as that.
    pub(crate) fn figure_caster(
        &self,
        module: &ShaderModule,
        entry: &str,
        buffers: &[VertexBufferLayout<'_>],
    ) -> RenderPipeline {
        self.cast(&self.figure_caster_layout, (module, entry), buffers)
    }

    fn cast(
        &self,
        layout: &PipelineLayout,
        (module, entry): (&ShaderModule, &str),
        buffers: &[VertexBufferLayout<'_>],
    ) -> RenderPipeline {
        let compare = match entry {
            "vertex_hole" => CompareFunction::Always,
            _ => CompareFunction::Greater,
        };
        let buffers: Vec<_> = buffers.iter().cloned().map(Some).collect();
        self.device
            .create_render_pipeline(&wgpu::RenderPipelineDescriptor {
                label: Some("shadow caster"),
                layout: Some(layout),
                vertex: wgpu::VertexState {
                    module,
                    entry_point: Some(entry),
                    compilation_options: wgpu::PipelineCompilationOptions::default(),
                    buffers: &buffers,
                },
                primitive: wgpu::PrimitiveState::default(),
                depth_stencil: Some(wgpu::DepthStencilState {
                    format: DEPTH_FORMAT,
                    depth_write_enabled: Some(true),
                    depth_compare: Some(compare),
                    stencil: wgpu::StencilState::default(),
                    bias: wgpu::DepthBiasState::default(),
                }),
                multisample: wgpu::MultisampleState::default(),
                fragment: None,
                multiview_mask: None,
                cache: None,
            })
    }

    pub(crate) fn make(
        &self,
        module: &ShaderModule,
        [vertex, fragment]: [&str; 2],
        buffers: &[VertexBufferLayout<'_>],
        way: Way,
    ) -> RenderPipeline {
        let buffers: Vec<_> = buffers.iter().cloned().map(Some).collect();
        let shadows = ("SHADOWS", f64::from(self.shadows.number()));
        let by_figures = ("FIGURE_SHADOWS", f64::from(u8::from(self.by_figures)));
        let cuts = ("CUTS", f64::from(u8::from(self.cuts)));
        let by_pixel = f64::from(u8::from(self.by_pixel));
        let lit = ("LIT", f64::from(u8::from(self.lit)));
        let constants = [shadows, by_figures, cuts, ("BY_PIXEL", by_pixel), lit];
        let compilation_options = wgpu::PipelineCompilationOptions {
            constants: &constants,
            ..Default::default()
        };
        self.device
            .create_render_pipeline(&wgpu::RenderPipelineDescriptor {
                label: Some(fragment),
                layout: Some(match (way.bends, way.opens) {
                    (true, _) => &self.bent_layout,
                    (false, true) => &self.open_layout,
                    (false, false) => &self.layout,
                }),
                vertex: wgpu::VertexState {
                    module,
                    entry_point: Some(vertex),
                    compilation_options: compilation_options.clone(),
                    buffers: &buffers,
                },
                primitive: wgpu::PrimitiveState {
                    front_face: wgpu::FrontFace::Ccw,
                    cull_mode: way.culled.then_some(wgpu::Face::Back),
                    ..Default::default()
                },
                depth_stencil: Some(wgpu::DepthStencilState {
                    format: DEPTH_FORMAT,
                    depth_write_enabled: Some(way.writes_depth),
                    depth_compare: Some(way.compare),
                    stencil: wgpu::StencilState::default(),
                    bias: wgpu::DepthBiasState::default(),
                }),
                multisample: wgpu::MultisampleState {
                    count: self.samples,
                    ..Default::default()
                },
                fragment: Some(wgpu::FragmentState {
                    module,
                    entry_point: Some(fragment),
                    compilation_options,
                    targets: &[Some(wgpu::ColorTargetState {
                        format: LIGHT_FORMAT,
                        blend: way.blend,
                        write_mask: wgpu::ColorWrites::ALL,
                    })],
                }),
                multiview_mask: None,
                cache: None,
            })
    }
}

fn layout(
    array_stride: u64,
    step_mode: VertexStepMode,
    attributes: &[VertexAttribute],
) -> VertexBufferLayout<'_> {
    VertexBufferLayout {
        array_stride,
        step_mode,
        attributes,
    }
}

pub(crate) fn instances<T>(attributes: &[VertexAttribute]) -> VertexBufferLayout<'_> {
    layout(size_of::<T>() as u64, VertexStepMode::Instance, attributes)
}

/// What the pictures of the sky and the shadow maps are bound by.
pub fn scene_layout(device: &Device) -> BindGroupLayout {
    let entries: Vec<_> = Heavens::layout()
        .into_iter()
        .chain(scene_entries())
        .collect();
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("scene"),
        entries: &entries,
    })
}
