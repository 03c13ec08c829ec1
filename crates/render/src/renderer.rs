//! Draws one frame after another: the scene as light, then the light as a picture.

use antipode_frame::Frame;
use wgpu::{
    BindGroup, Buffer, BufferUsages, Color, CommandEncoder, Device, LoadOp, Operations, Queue,
    RenderPass, RenderPassColorAttachment, RenderPassDepthStencilAttachment, RenderPassDescriptor,
    RenderPipeline, StoreOp, TextureView,
};

use crate::celestial::{Celestial, FAINTEST};
use crate::chunk_store::ChunkStore;
use crate::draw_list::{DrawList, LandDraws};
use crate::error::RenderError;
use crate::figures::Figures;
use crate::gpu::Gpu;
use crate::heavens::Heavens;
use crate::marker::MarkerBalls;
use crate::outlines::Outlines;
use crate::pipelines::{Pipelines, scene_layout};
use crate::plan::Planner;
use crate::refinery::Delivery;
use crate::shaders::Shaders;
use crate::shadow::Shadows;
use crate::targets::Targets;
use crate::tile::Tile;
use crate::timing::Timing;
use crate::tonemap::Tonemap;
use crate::uniforms::SceneUniform;
use crate::workshop::Workshop;

mod options;
mod readiness;
mod scene;
#[cfg(test)]
mod tests;

use options::check;
pub use options::{DrawStats, Options, Picture};
use scene::bind_scene;

/// Holds everything on the adapter that outlives a frame.
#[derive(Debug)]
pub struct Renderer {
    device: Device,
    queue: Queue,
    options: Options,
    shaders: Shaders,
    pipelines: Workshop<Pipelines>,
    /// Whether frames wait for pipelines.
    patient: bool,
    /// Whether the last frame was not drawn for want of pipelines.
    awaits_map: bool,
    /// Options to be taken together with the pipelines that are being made for them.
    later: Option<(Options, Tonemap)>,
    /// The last frame's map, by its number in `SpaceUniform::kind`.
    map: Option<u32>,
    uniform: Buffer,
    scene_bindings: BindGroup,
    targets: Targets,
    /// Width and height of the pictures, pixels, and whether they are drawn at full resolution.
    asked: (u32, u32, bool),
    /// The number of the world that the targets hold a picture of.
    pictured: Option<u64>,
    tonemap: Tonemap,
    light: BindGroup,
    chunks: ChunkStore,
    planner: Planner,
    land: LandDraws,
    list: DrawList,
    figures: Figures,
    shadows: Shadows,
    heavens: Heavens,
    marker: MarkerBalls,
    outlines: Outlines,
    celestial: Celestial,
    timing: Option<Timing>,
    /// Height of the targets, pixels: what errors are measured in.
    height_px: u32,
    /// The part of a larger picture that is being drawn.
    tile: Option<Tile>,
}

impl Renderer {
    /// A renderer for targets of one pixel; [`Renderer::resize`] gives it their size.
    ///
    /// # Errors
    /// When the options are out of range, a model cannot be read, or the adapter refuses the last pass's shader. Those of the scene are
    /// compiled later: see [`Renderer::fault`].
    pub fn new(gpu: &Gpu, options: Options) -> Result<Self, RenderError> {
        Self::with_shaders(gpu, options, Shaders::default())
    }

    /// As [`Renderer::new`], with these shaders.
    ///
    /// # Errors
    /// As [`Renderer::new`].
    pub fn with_shaders(
        gpu: &Gpu,
        options: Options,
        shaders: Shaders,
    ) -> Result<Self, RenderError> {
        check(&options)?;
        let (device, queue) = (gpu.device.clone(), gpu.queue.clone());
        let scene_layout = scene_layout(&device);
        let uniform = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("scene"),
            size: size_of::<SceneUniform>() as u64,
            usage: BufferUsages::UNIFORM | BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let heavens = Heavens::new(&device, &queue)?;
        let shadows = Shadows::new(gpu, options.shadows);
        let extras = (&heavens, &shadows);
        let scene_bindings = bind_scene(&device, &scene_layout, &uniform, extras);
        let quality = options.pipeline_quality();
        let pipelines = readiness::workshop(&device, shaders, &scene_layout, quality);
        let targets = Targets::new(&device, (1, 1), options.samples);
        let tonemap = Tonemap::accepted(&device, shaders, &options)?;
        let light = tonemap.bind(&device, &targets.light);
        Ok(Self {
            chunks: ChunkStore::new(gpu),
            planner: Planner::default(),
            land: LandDraws::new(gpu),
            list: DrawList::default(),
            figures: Figures::new(&device)?,
            shadows,
            heavens,
            marker: MarkerBalls::new(&device),
            outlines: Outlines::new(&device),
            celestial: Celestial::new(&device),
            timing: Timing::new(&device, &queue),
            height_px: 1,
            tile: None,
            device,
            queue,
            options,
            shaders,
            pipelines,
            patient: true,
            awaits_map: false,
            later: None,
            map: None,
            uniform,
            scene_bindings,
            targets,
            asked: (1, 1, false),
            pictured: None,
            tonemap,
            light,
        })
    }

    /// The longest side of a picture that can be drawn, in tiles or at once, pixels.
    pub fn largest_side(&self) -> u32 {
        self.device.limits().max_texture_dimension_2d
    }

    /// As [`Renderer::draw`], but draws a part of a larger picture: complete, however long that takes. The targets are
    /// to be as large as the part, and drawn at full resolution ([`Renderer::resize_full`]); no side of the whole may
    /// be longer than [`Renderer::largest_side`].
    pub fn draw_tile(
        &mut self,
        frame: &Frame,
        tile: Tile,
        encoder: &mut CommandEncoder,
        target: &TextureView,
    ) -> DrawStats {
        self.tile = Some(tile);
        self.complete_next();
        let stats = self.draw(frame, encoder, target);
        self.tile = None;
        stats
    }

    /// Records the picture of the last frame into another target of the same size and format.
    pub fn show_again(&self, encoder: &mut CommandEncoder, target: &TextureView) {
        self.tonemap.draw(encoder, &self.light, target, None);
    }

    /// Whether the next frame of the same moment would show more than the last one did: meshes wait for room, or
    /// are being refined.
    pub fn is_busy(&self) -> bool {
        self.is_land_coming() || self.shadows.is_busy() || self.pipelines.is_renewing()
    }

    /// Whether land that frames have brought is not shown yet, or not as fine as it is to be, for want of time or of
    /// what its map is drawn with.
    pub fn is_land_coming(&self) -> bool {
        self.awaits_map || self.chunks.is_busy()
    }

    /// Lets the next frame be complete, however long that takes: for a single picture. Frames in motion bring what
    /// a step of the eye changes up to date bit by bit.
    pub fn complete_next(&mut self) {
        self.chunks.rush();
    }

    /// Has frames get refined land at another time than as soon as it is made: for tests of what is shown until then.
    pub fn deliver_refined(&mut self, delivery: Delivery) {
        self.chunks.refinements.deliver(delivery);
    }

    /// Draws each mesh by a call of its own from now on, as is done on adapters that cannot draw many by one.
    pub fn draw_singly(&mut self) {
        self.land.draw_singly();
        self.shadows.draw_singly();
    }

    /// Has figures that cannot be seen posed and drawn as well from now on: a test and a measurement compare with that.
    pub fn draw_unseen(&mut self) {
        self.figures.culls = false;
    }

    /// Records the drawing of a frame into `target`, which has the size last given to [`Renderer::resize`].
    ///
    /// The encoder is to be submitted before the next frame is drawn: a frame's data lies in buffers that the
    /// next one overwrites.
    pub fn draw(
        &mut self,
        frame: &Frame,
        encoder: &mut CommandEncoder,
        target: &TextureView,
    ) -> DrawStats {
        let gpu_ms = self
            .timing
            .as_mut()
            .and_then(|timing| timing.collect(&self.device));
        let map = self.map_of(frame);
        if !self.is_ready(map) {
            return DrawStats {
                gpu_ms,
                ..self.show_last(frame, encoder, target)
            };
        }
        let drawn = self.tile.map_or(self.targets.size, |tile| tile.whole);
        let height_px = self.tile.map_or(self.height_px, |tile| tile.whole.1);
        self.chunks.apply(frame);
        self.marker.prepare(&self.queue, frame);
        self.outlines.prepare(&self.device, &self.queue, frame);
        let book = self.chunks.land();
        let land = book.land();
        let mut plan = self.planner.plan(frame, height_px, &book);
        self.chunks.refine(frame, land, &mut plan);
        self.prepare_figures(frame, &mut plan, drawn);
        self.chunks.end_rush();
        self.chunks
            .list(frame, land, &mut plan, &self.shadows, &mut self.list);
        self.land.send(&self.queue, &mut self.list);
        let mut stats = DrawStats {
            culled: self.chunks.len() - plan.chunks.len(),
            land_bytes: self.chunks.bytes(),
            plan: plan.stats,
            gpu_ms,
            ..DrawStats::default()
        };
        let stamped = self.draw_shadows(map, encoder, &mut stats);
        self.draw_scene(frame, (map, stamped), encoder, &mut stats);
        self.pictured = Some(frame.content.loaded_world);
        self.tonemap.draw(
            encoder,
            &self.light,
            target,
            self.timing.as_ref().map(Timing::end),
        );
        if let Some(timing) = &self.timing {
            timing.record(encoder);
        }
        stats
    }

    fn begin_scene<'e>(
        &self,
        encoder: &'e mut CommandEncoder,
        horizon: [f32; 3],
        stamped: bool,
    ) -> RenderPass<'e> {
        let [r, g, b] = horizon.map(f64::from);
        let clear = LoadOp::Clear(Color { r, g, b, a: 1.0 });
        let light = &self.targets.light;
        let (view, resolve_target, store) = match &self.targets.samples {
            Some(samples) => (samples, Some(light), StoreOp::Discard),
            None => (light, None, StoreOp::Store),
        };
        encoder.begin_render_pass(&RenderPassDescriptor {
            label: Some("scene"),
            color_attachments: &[Some(RenderPassColorAttachment {
                view,
                depth_slice: None,
                resolve_target,
                ops: Operations { load: clear, store },
            })],
            depth_stencil_attachment: Some(RenderPassDepthStencilAttachment {
                view: &self.targets.depth,
                depth_ops: Some(Operations {
                    load: LoadOp::Clear(0.0),
                    store: StoreOp::Discard,
                }),
                stencil_ops: None,
            }),
            timestamp_writes: self.timing.as_ref().filter(|_| !stamped).map(Timing::begin),
            ..Default::default()
        })
    }

    /// What lies behind everything, from the back to the front.
    fn draw_sky(
        &self,
        frame: &Frame,
        pipelines: &Pipelines,
        pass: &mut RenderPass<'_>,
        stats: &mut DrawStats,
    ) {
        let mut cover = |pass: &mut RenderPass<'_>, pipeline: &RenderPipeline| {
            pass.set_pipeline(pipeline);
            pass.draw(0..3, 0..1);
            stats.add((1, 1));
        };
        if frame.content.sky.dome {
            cover(pass, &pipelines.sky);
            if frame.content.sky.stars > FAINTEST {
                cover(pass, &pipelines.band);
            }
        }
        let celestial = self
            .celestial
            .draw(pass, &frame.content.sky, &pipelines.celestial);
        if frame.content.sky.dome && frame.content.sky.clouds > 0.0 {
            cover(pass, &pipelines.clouds);
        }
        stats.add(celestial);
    }

    fn draw_scene(
        &self,
        frame: &Frame,
        (map, stamped): (u32, bool),
        encoder: &mut CommandEncoder,
        stats: &mut DrawStats,
    ) {
        let mut pass = self.begin_scene(encoder, frame.content.sky.horizon, stamped);
        if let Some(tile) = self.tile {
            tile.lay(&mut pass);
        }
        let Some(pipelines) = self.pipelines.get(map) else {
            return;
        };
        pass.set_bind_group(0, &self.scene_bindings, &[]);
        // Figures stand before the land more often than behind it.
        stats.add(self.figures.draw(&mut pass, pipelines));
        stats.add(
            self.land
                .draw(&mut pass, &self.list, self.chunks.pages(), |number| {
                    pipelines.terrain.numbered(number)
                }),
        );
        self.draw_sky(frame, pipelines, &mut pass, stats);
        stats.add(self.figures.draw_clear(&mut pass, pipelines));
        if self.marker.shown() {
            for pipeline in [&pipelines.marker_hidden, &pipelines.marker] {
                pass.set_pipeline(pipeline);
                stats.add(self.marker.draw(&mut pass));
            }
        }
        if self.outlines.shown() {
            for pipeline in [&pipelines.outlines_hidden, &pipelines.outlines] {
                pass.set_pipeline(pipeline);
                stats.add(self.outlines.draw(&mut pass));
            }
        }
    }
}
