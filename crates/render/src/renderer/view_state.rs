//! What a view has for itself on the adapter: its targets, what its shaders are told, and its draws. Nothing of it is shared,
//! so that several views can be drawn by one submission.

use antipode_frame::Frame;
use wgpu::{
    BindGroup, BindGroupLayout, Color, CommandEncoder, Device, LoadOp, Operations, Queue,
    RenderPass, RenderPassColorAttachment, RenderPassDepthStencilAttachment, RenderPassDescriptor,
    RenderPassTimestampWrites, RenderPipeline, StoreOp,
};

use super::DrawStats;
use crate::celestial::{Celestial, FAINTEST};
use crate::charts::Charts;
use crate::chunk_store::{ChunkStore, Shading};
use crate::culling::Falls;
use crate::draw_list::{DrawCount, DrawList, LandDraws};
use crate::dust::DustDraws;
use crate::figure_buffers::Statics;
use crate::figure_draws::FigureDraws;
use crate::figures::Figures;
use crate::heavens::Heavens;
use crate::marker::MarkerBalls;
use crate::openings::{Beyond, OpeningDraws};
use crate::outlines::Outlines;
use crate::pages::Pages;
use crate::pipelines::{Pipelines, scene_layout};
use crate::plan::{FramePlan, LandIndex, Planner};
use crate::pressers::Pressers;
use crate::shades::Shades;
use crate::shadow::Shadows;
use crate::targets::Targets;
use crate::tile::Tile;
use crate::tonemap::{MirrorPlace, Tonemap};
use crate::uniforms::SceneUniform;

/// What a view's pictures are drawn with from one frame to the next.
#[derive(Debug)]
pub(super) struct ViewState {
    /// The pictures of the sky and the shadow maps.
    bindings: BindGroup,
    pub targets: Targets,
    /// Its light, as the tone map reads it.
    pub light: BindGroup,
    /// What of the frame's picture it takes, if it is a mirror's.
    pub mirror: Option<MirrorPlace>,
    planner: Planner,
    /// What its shaders are told, with the charts of what it draws and of what is drawn into shadow maps for it.
    pub charts: Charts,
    list: DrawList,
    land: LandDraws,
    pub figures: FigureDraws,
    marker: MarkerBalls,
    dust: DustDraws,
    outlines: Outlines,
    openings: OpeningDraws,
    /// Whether the last frame drew it, of what is seen through an opening.
    pub is_drawn: bool,
}

/// What all views are drawn from.
#[derive(Clone, Copy)]
pub(super) struct Scenery<'a> {
    pub pipelines: &'a Pipelines,
    pub pages: &'a Pages,
    pub models: &'a Statics,
    pub celestial: &'a Celestial,
}

/// What of a view is drawn, and what its openings show.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Part<'a> {
    /// A part of a larger picture.
    pub tile: Option<Tile>,
    /// The rectangle that is looked at: x, y, width and height in pixels; all of it without one.
    pub seen: Option<[u32; 4]>,
    /// What lies beyond each opening, in the frame's order.
    pub beyond: &'a [Beyond<'a>],
}

/// What all views read besides what is their own.
#[derive(Clone, Copy)]
pub(super) struct Shared<'a> {
    pub heavens: &'a Heavens,
    pub shadows: &'a Shadows,
}

/// The land that views are made of.
#[derive(Clone, Copy)]
pub(super) struct LandSource<'a> {
    pub chunks: &'a ChunkStore,
    pub index: &'a LandIndex,
    pub shadows: &'a Shadows,
}

impl ViewState {
    /// A view that is drawn `size` pixels large, with so many samples of a pixel.
    pub fn new(
        device: &Device,
        shared: Shared<'_>,
        tonemap: &Tonemap,
        land: LandDraws,
        size: (u32, u32),
        samples: u32,
    ) -> Self {
        let layout = scene_layout(device);
        let targets = Targets::new(device, size, samples);
        Self {
            bindings: bind_scene(device, &layout, shared),
            light: tonemap.bind(device, &targets.light),
            targets,
            mirror: None,
            planner: Planner::default(),
            charts: Charts::new(device),
            list: DrawList::default(),
            land,
            figures: FigureDraws::new(device),
            marker: MarkerBalls::new(device),
            dust: DustDraws::new(device),
            outlines: Outlines::new(device),
            openings: OpeningDraws::new(device),
            is_drawn: false,
        }
    }

    /// Draws in targets of another size from now on.
    pub fn fit(&mut self, device: &Device, tonemap: &Tonemap, size: (u32, u32), samples: u32) {
        self.targets = Targets::new(device, size, samples);
        self.light = tonemap.bind(device, &self.targets.light);
    }

    /// Draws each mesh by a call of its own from now on.
    pub fn draw_singly(&mut self) {
        self.land.draw_singly();
    }

    /// Buffers for the land of another view.
    pub fn more_land(&self) -> LandDraws {
        self.land.another()
    }

    /// Reads other shadow maps from now on.
    pub fn rebind(&mut self, device: &Device, shared: Shared<'_>) {
        let layout = scene_layout(device);
        self.bindings = bind_scene(device, &layout, shared);
    }

    /// Begins a frame: decides what to draw of the land in a picture `height_px` pixels high.
    pub fn plan(&mut self, frame: &Frame, height_px: u32, land_index: &LandIndex) -> FramePlan {
        self.charts.begin(frame);
        self.planner.plan(frame, height_px, land_index)
    }

    /// Takes a frame's figures and what is laid over its world; `map` is that of the shadows that its figures are to throw.
    /// Returns the heights between which they lie that fall on it.
    pub fn take_figures(
        &mut self,
        device: &Device,
        queue: &Queue,
        frame: &Frame,
        figures: &Figures,
        plan: &mut FramePlan,
        map: Option<Falls>,
    ) -> [f64; 2] {
        self.marker.prepare(queue, frame, &mut self.charts);
        self.dust.prepare(queue, frame, &mut self.charts);
        self.openings.prepare(queue, frame, &mut self.charts);
        self.outlines
            .prepare(device, queue, frame, &mut self.charts);
        let (seen, heights) = figures.seen(frame, plan, map);
        self.figures.take(device, queue, seen, &mut self.charts);
        heights
    }

    /// Takes a frame's land, and tells the shaders of the frame, which is drawn `drawn` pixels large.
    pub fn take_land(
        &mut self,
        device: &Device,
        queue: &Queue,
        frame: &Frame,
        land: LandSource<'_>,
        plan: &mut FramePlan,
        drawn: (u32, u32),
    ) {
        let (shades, pressers) = (Shades::of(frame), Pressers::of(frame));
        let shading = Shading {
            shadows: land.shadows,
            shades: &shades,
            pressers: &pressers,
        };
        let (list, charts) = (&mut self.list, &mut self.charts);
        land.chunks
            .list(frame, land.index.land(), plan, shading, list, charts);
        self.land.send(queue, &mut self.list);
        let scene = SceneUniform::new(frame, drawn, &shades, &land.shadows.uniform(frame));
        self.charts.send(device, queue, frame, &scene, &pressers);
    }

    /// Draws the light of a frame that was taken.
    pub fn draw(
        &self,
        frame: &Frame,
        scenery: Scenery<'_>,
        encoder: &mut CommandEncoder,
        part: Part<'_>,
        stamp: Option<RenderPassTimestampWrites<'_>>,
        stats: &mut DrawStats,
    ) {
        let Scenery {
            pipelines, models, ..
        } = scenery;
        let charts = &self.charts;
        let mut pass = self.begin(encoder, frame.content.sky.horizon, stamp);
        if let Some(tile) = part.tile {
            tile.lay(&mut pass);
        }
        if let Some([x, y, width, height]) = part.seen {
            pass.set_scissor_rect(x, y, width, height);
        }
        pass.set_bind_group(0, &self.bindings, &[]);
        self.charts.bind(&mut pass, 0);
        // Figures stand before the land more often than behind it, and what lies behind an opening is not seen.
        stats.add(self.figures.draw(&mut pass, models, charts, pipelines));
        let openings = &self.openings;
        stats.add(openings.draw(&mut pass, charts, pipelines, part.beyond));
        let terrain = |number| pipelines.terrain.numbered(number);
        let land = &self.land;
        stats.add(land.draw(&mut pass, &self.list, charts, scenery.pages, terrain));
        let dust = &self.dust;
        stats.add(dust.draw_marks(&mut pass, charts, &pipelines.dust));
        draw_sky(frame, scenery, &mut pass, stats);
        stats.add(
            self.figures
                .draw_clear(&mut pass, models, charts, pipelines),
        );
        stats.add(dust.draw(&mut pass, charts, &pipelines.dust));
        let marker = [&pipelines.marker_hidden, &pipelines.marker];
        stats.add(self.marker.draw(&mut pass, charts, marker));
        let outlines = [&pipelines.outlines_hidden, &pipelines.outlines];
        stats.add(self.outlines.draw(&mut pass, charts, outlines));
    }

    fn begin<'e>(
        &self,
        encoder: &'e mut CommandEncoder,
        horizon: [f32; 3],
        timestamp_writes: Option<RenderPassTimestampWrites<'_>>,
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
            timestamp_writes,
            ..Default::default()
        })
    }
}

/// What lies behind everything, from the back to the front.
fn draw_sky(frame: &Frame, scenery: Scenery<'_>, pass: &mut RenderPass<'_>, stats: &mut DrawStats) {
    let (pipelines, sky) = (scenery.pipelines, &frame.content.sky);
    let mut cover = |pass: &mut RenderPass<'_>, pipeline: &RenderPipeline| {
        pass.set_pipeline(pipeline);
        pass.draw(0..3, 0..1);
        stats.add(DrawCount {
            triangles: 1,
            draws: 1,
        });
    };
    if sky.dome {
        let is_cloudy = sky.clouds > 0.0;
        cover(
            pass,
            if is_cloudy {
                &pipelines.cloudy_sky
            } else {
                &pipelines.sky
            },
        );
        if sky.stars > FAINTEST {
            cover(pass, &pipelines.band);
        }
    }
    stats.add(scenery.celestial.draw(pass, sky, &pipelines.celestial));
}

/// The pictures that the scene's shaders read.
fn bind_scene(device: &Device, layout: &BindGroupLayout, shared: Shared<'_>) -> BindGroup {
    let heavens = shared.heavens.bind().into_iter();
    let entries: Vec<_> = heavens.chain(shared.shadows.bind()).collect();
    device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("scene"),
        layout,
        entries: &entries,
    })
}
