//! Draws one frame after another: the scene pass computes light, and the tone map turns the light into a picture.

use antipode_frame::{Frame, View};
use wgpu::{CommandEncoder, Device, Queue, RenderPassTimestampWrites, TextureView};

use crate::celestial::Celestial;
use crate::chunk_store::ChunkStore;
use crate::culling::Falls;
use crate::draw_list::LandDraws;
use crate::error::RenderError;
use crate::figures::Figures;
use crate::gpu::Gpu;
use crate::heavens::Heavens;
use crate::pipeline_cache::{Key, PipelineCache};
use crate::pipelines::{Pipelines, scene_layout};
use crate::plan::FramePlan;
use crate::shaders::Shaders;
use crate::shadow::{Casters, Shadows};
use crate::subdivision_thread::Delivery;
use crate::tile::Tile;
use crate::timing::Timing;
use crate::tonemap::Tonemap;

mod beyond;
mod further;
mod options;
mod readiness;
#[cfg(test)]
mod tests;
mod view_state;

use options::check;
pub use options::{DrawStats, Options, Picture, Preset};
pub(crate) use readiness::PipelineQuality;
use view_state::{LandSource, Part, Scenery, Shared, ViewState};

/// Another view of what a frame shows, drawn with it.
///
/// It takes land and shadows as they are for the frame's own view: those follow its eye, and edges of land are halved for that.
#[derive(Clone, Copy, Debug)]
pub struct FurtherView<'a> {
    /// From where and how it is seen.
    pub view: &'a View,
    /// Width and height of where it is shown, pixels.
    pub size: (u32, u32),
    /// Where that is.
    pub target: ViewTarget<'a>,
}

/// Where a further view is shown.
#[derive(Clone, Copy, Debug)]
pub enum ViewTarget<'a> {
    /// All over a texture as large as it, of the format that the options name.
    Texture(&'a TextureView),
    /// Over a part of the frame's own picture, left and right swapped as in a mirror: that part's upper left corner, pixels.
    /// All of it is to be in the picture.
    Mirror((u32, u32)),
}

/// Holds everything on the adapter that outlives a frame.
#[derive(Debug)]
pub struct Renderer {
    device: Device,
    queue: Queue,
    options: Options,
    shaders: Shaders,
    pipelines: PipelineCache<Pipelines>,
    /// Whether frames wait for pipelines.
    patient: bool,
    /// Whether the last frame was not drawn for want of pipelines.
    awaits_map: bool,
    /// Options to be taken together with the pipelines that are being made for them.
    later: Option<(Options, Tonemap)>,
    /// What the last frame's pipelines are kept by.
    map: Option<Key>,
    /// The view of the frames themselves.
    picture: ViewState,
    /// The others, in the order in which the last frame that had so many named them.
    further: Vec<ViewState>,
    /// What is seen through the openings of the last frame.
    openings: Vec<ViewState>,
    /// What is seen in each of them through the same opening again, once it was.
    deeper: Vec<Option<ViewState>>,
    /// Width and height of the pictures, pixels, and whether they are drawn at full resolution.
    asked: (u32, u32, bool),
    /// The number of the world that the targets hold a picture of.
    pictured: Option<u64>,
    /// The number of the world that was shown last.
    shown_world: Option<u64>,
    tonemap: Tonemap,
    chunks: ChunkStore,
    figures: Figures,
    shadows: Shadows,
    heavens: Heavens,
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
        let heavens = Heavens::new(&device, &queue)?;
        let shadows = Shadows::new(gpu, options.shadows);
        let quality = options.pipeline_quality();
        let pipelines =
            readiness::pipeline_cache(&device, shaders, &scene_layout(&device), quality);
        let is_scaled = options.scale != 1.0;
        let tonemap = Tonemap::accepted(&device, shaders, options.output_format, is_scaled)?;
        let shared = Shared {
            heavens: &heavens,
            shadows: &shadows,
        };
        let land = LandDraws::new(gpu);
        let picture = ViewState::new(&device, shared, &tonemap, land, (1, 1), options.samples);
        Ok(Self {
            chunks: ChunkStore::new(gpu),
            figures: Figures::new(&device)?,
            shadows,
            heavens,
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
            picture,
            further: Vec::new(),
            openings: Vec::new(),
            deeper: Vec::new(),
            asked: (1, 1, false),
            pictured: None,
            shown_world: None,
            tonemap,
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
        self.show(encoder, target, None);
    }

    /// Shows the light of the last frame, and of its mirrors.
    fn show(
        &self,
        encoder: &mut CommandEncoder,
        target: &TextureView,
        stamp: Option<RenderPassTimestampWrites<'_>>,
    ) {
        let light = &self.picture.light;
        self.tonemap.draw(encoder, light, target, stamp);
        for state in &self.further {
            if let Some(place) = &state.mirror {
                self.tonemap
                    .lay_mirror(encoder, &state.light, target, place);
            }
        }
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
        self.picture.draw_singly();
        self.further.clear();
        self.openings.clear();
        self.deeper.clear();
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
        self.draw_views(frame, &[], encoder, target).0
    }

    /// As [`Renderer::draw`], and records further views of the same content. Returns what the frame took, and what each
    /// of them did; what one is drawn with may not be made yet ([`Picture::None`]).
    pub fn draw_views(
        &mut self,
        frame: &Frame,
        further: &[FurtherView<'_>],
        encoder: &mut CommandEncoder,
        target: &TextureView,
    ) -> (DrawStats, Vec<DrawStats>) {
        let gpu_ms = self
            .timing
            .as_mut()
            .and_then(|timing| timing.collect(&self.device));
        let is_shared = !further.is_empty() || !frame.openings.is_empty();
        let map = self.map_of(frame);
        self.foresee_openings(frame, map);
        if !self.is_ready(map) || self.awaits_openings(frame, map) {
            let last = DrawStats {
                gpu_ms,
                ..self.show_last(frame, encoder, target)
            };
            return (last, vec![DrawStats::nothing(); further.len()]);
        }
        self.chunks.apply(frame);
        let mut stats = DrawStats {
            gpu_ms,
            ..self.draw_picture(frame, map, is_shared, encoder)
        };
        stats.land_bytes = self.chunks.bytes();
        let others = self.draw_further(frame, further, encoder);
        self.chunks.end_rush();
        self.pictured = Some(frame.content.loaded_world);
        self.shown_world = self.pictured;
        let end = self.timing.as_ref().map(Timing::end);
        self.show(encoder, target, end);
        if let Some(timing) = &self.timing {
            timing.record(encoder);
        }
        (stats, others)
    }

    /// Brings land and shadows up to date for a frame and those that share them, and draws its light.
    fn draw_picture(
        &mut self,
        frame: &Frame,
        map: Key,
        is_shared: bool,
        encoder: &mut CommandEncoder,
    ) -> DrawStats {
        let drawn = self
            .tile
            .map_or(self.picture.targets.size, |tile| tile.whole);
        let height_px = self.tile.map_or(self.height_px, |tile| tile.whole.1);
        let land_index = self.chunks.land();
        let mut plan = self.picture.plan(frame, height_px, &land_index);
        self.chunks.refine(frame, land_index.land(), &mut plan);
        self.chunks.grow(frame, &plan, self.options.preset);
        self.take_figures(frame, &mut plan, is_shared);
        let land = LandSource {
            chunks: &self.chunks,
            index: &land_index,
            shadows: &self.shadows,
        };
        self.picture
            .take_land(&self.device, &self.queue, frame, land, &mut plan, drawn);
        let mut stats = self.planned(&plan);
        let Some(pipelines) = self.pipelines.get(map) else {
            return stats;
        };
        let timing = self.timing.as_ref();
        let casters = Casters {
            pages: self.chunks.pages(),
            charts: &self.picture.charts,
            figures: &self.picture.figures,
            models: &self.figures.statics,
        };
        let (shadows, stamped) = self.shadows.draw(encoder, pipelines, casters, timing);
        stats.shadows = shadows;
        self.draw_beyond(frame, encoder, &mut stats);
        let Some(pipelines) = self.pipelines.get(map) else {
            return stats;
        };
        let timing = self.timing.as_ref();
        let stamp = timing.filter(|_| !stamped).map(Timing::begin);
        let scenery = self.scenery(pipelines);
        let beyond = beyond::of(&self.openings);
        let part = Part {
            tile: self.tile,
            beyond: &beyond,
            ..Part::default()
        };
        self.picture
            .draw(frame, scenery, encoder, part, stamp, &mut stats);
        stats
    }

    /// Takes a frame's figures, and plans the passes into the shadow maps. Which figures there are depends on what the map
    /// of their shadows is a picture of, and that on the maps of land.
    fn take_figures(&mut self, frame: &Frame, plan: &mut FramePlan, is_shared: bool) {
        let charts = &mut self.picture.charts;
        let is_new = self.shadows.prepare(frame, &mut self.chunks, charts);
        let map = self.shadows.figures_shot(frame);
        let (device, queue) = (&self.device, &self.queue);
        let falls = map.map(|shot| Falls { shot, is_shared });
        let heights = self
            .picture
            .take_figures(device, queue, frame, &self.figures, plan, falls);
        let rooms = self.picture.figures.rooms();
        self.shadows.prepare_figures(frame, map, rooms, heights);
        if is_new {
            let shared = Shared {
                heavens: &self.heavens,
                shadows: &self.shadows,
            };
            let deeper = self.deeper.iter_mut().flatten();
            let others = self.further.iter_mut().chain(&mut self.openings);
            let others = others.chain(deeper);
            for view in std::iter::once(&mut self.picture).chain(others) {
                view.rebind(&self.device, shared);
            }
        }
    }

    fn scenery<'a>(&'a self, pipelines: &'a Pipelines) -> Scenery<'a> {
        Scenery {
            pipelines,
            pages: self.chunks.pages(),
            models: &self.figures.statics,
            celestial: &self.celestial,
        }
    }

    fn planned(&self, plan: &FramePlan) -> DrawStats {
        DrawStats {
            culled: self.chunks.len() - plan.chunks.len(),
            plan: plan.stats,
            preset: self.options.preset,
            ..DrawStats::default()
        }
    }
}
