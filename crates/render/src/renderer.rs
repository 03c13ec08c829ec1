//! Draws one frame after another: the scene as light, then the light as a picture.

use antipode_scene::frame::Frame;
use wgpu::{
    BindGroup, BindGroupLayout, Buffer, BufferUsages, Color, CommandEncoder, Device, LoadOp,
    Operations, Queue, RenderPass, RenderPassColorAttachment, RenderPassDepthStencilAttachment,
    RenderPassDescriptor, StoreOp, TextureFormat, TextureView,
};

use crate::celestial::Celestial;
use crate::chunk_store::ChunkStore;
use crate::draw_list::{DrawList, LandDraws};
use crate::error::RenderError;
use crate::figures::Figures;
use crate::gpu::Gpu;
use crate::marker::MarkerBalls;
use crate::pipelines::{Pipelines, scene_layout};
use crate::plan::{PlanStats, plan};
use crate::targets::{Targets, drawn_size};
use crate::timing::Timing;
use crate::tonemap::Tonemap;
use crate::uniforms::SceneUniform;

/// Maps that shaders are compiled for.
const MAPS: usize = 4;
/// The number of the map that every open world can turn to.
const HORIZON: u32 = antipode_geometry::SpaceUniform::HORIZON;

/// How pictures are drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Samples a pixel: 4, or 1 where fill is dear, as on software adapters.
    pub samples: u32,
    /// Share of the target's resolution that is drawn along each side, 0.1 to 1; scaled up to the target.
    pub scale: f32,
    /// Format of the targets.
    pub output_format: TextureFormat,
}

/// What drawing a frame took.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DrawStats {
    /// Triangles sent.
    pub triangles: usize,
    /// Calls to the adapter that draw something; one may draw many chunks.
    pub draws: usize,
    /// Chunks with land that were left out.
    pub culled: usize,
    /// Bytes of the buffers that the land's meshes lie in.
    pub land_bytes: u64,
    /// What the planner chose, and the error that causes.
    pub plan: PlanStats,
    /// The adapter's own time of a frame shortly before this one, milliseconds, where it can tell.
    pub gpu_ms: Option<f32>,
}

impl DrawStats {
    fn add(&mut self, (triangles, draws): (usize, usize)) {
        self.triangles += triangles;
        self.draws += draws;
    }
}

/// Holds everything on the adapter that outlives a frame.
#[derive(Debug)]
pub struct Renderer {
    device: Device,
    queue: Queue,
    options: Options,
    scene_layout: BindGroupLayout,
    /// By the map's number in `SpaceUniform::kind`; made when a world first needs them.
    pipelines: [Option<Pipelines>; MAPS],
    uniform: Buffer,
    scene_bindings: BindGroup,
    targets: Targets,
    tonemap: Tonemap,
    light: BindGroup,
    chunks: ChunkStore,
    land: LandDraws,
    list: DrawList,
    figures: Figures,
    marker: MarkerBalls,
    celestial: Celestial,
    timing: Option<Timing>,
    /// Height of the targets, pixels: what errors are measured in.
    height_px: u32,
}

impl Renderer {
    /// A renderer for targets of one pixel; [`Renderer::resize`] gives it their size.
    ///
    /// # Errors
    /// When the options are out of range.
    pub fn new(gpu: &Gpu, options: Options) -> Result<Self, RenderError> {
        check(&options)?;
        let (device, queue) = (gpu.device.clone(), gpu.queue.clone());
        let scene_layout = scene_layout(&device);
        let uniform = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("scene"),
            size: size_of::<SceneUniform>() as u64,
            usage: BufferUsages::UNIFORM | BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let scene_bindings = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("scene"),
            layout: &scene_layout,
            entries: &[wgpu::BindGroupEntry {
                binding: 0,
                resource: uniform.as_entire_binding(),
            }],
        });
        let targets = Targets::new(&device, (1, 1), options.samples);
        let tonemap = Tonemap::new(&device, options.output_format, options.scale != 1.0);
        let light = tonemap.bind(&device, &targets.light);
        Ok(Self {
            chunks: ChunkStore::new(gpu),
            land: LandDraws::new(gpu),
            list: DrawList::default(),
            figures: Figures::new(&device),
            marker: MarkerBalls::new(&device),
            celestial: Celestial::new(&device),
            timing: Timing::new(&device, &queue),
            height_px: 1,
            device,
            queue,
            options,
            scene_layout,
            pipelines: [const { None }; MAPS],
            uniform,
            scene_bindings,
            targets,
            tonemap,
            light,
        })
    }

    /// Makes ready for targets of `width` by `height` pixels.
    pub fn resize(&mut self, width: u32, height: u32) {
        let most = self.device.limits().max_texture_dimension_2d;
        let size = drawn_size(width, height, self.options.scale, most);
        self.height_px = height;
        self.targets = Targets::new(&self.device, size, self.options.samples);
        self.light = self.tonemap.bind(&self.device, &self.targets.light);
    }

    /// Lets the next frame be complete, however long that takes: for a single picture. Frames in motion bring what
    /// a step of the eye changes up to date bit by bit.
    pub fn complete_next(&mut self) {
        self.chunks.rush();
    }

    /// Draws each mesh by a call of its own from now on, as is done on adapters that cannot draw many by one.
    pub fn draw_singly(&mut self) {
        self.land.draw_singly();
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
        let kind = self.make_pipelines(frame);
        self.chunks.apply(frame);
        self.marker.prepare(&self.queue, frame);
        self.queue.write_buffer(
            &self.uniform,
            0,
            bytemuck::bytes_of(&SceneUniform::new(frame, self.targets.size)),
        );
        let land = self.chunks.land();
        let mut plan = plan(frame, self.height_px, &land);
        self.chunks.refine(frame, &land, &mut plan);
        self.chunks.end_rush();
        self.figures
            .prepare(&self.device, &self.queue, frame, &mut plan);
        self.chunks.list(frame, &land, &mut plan, &mut self.list);
        self.land.send(&self.queue, &mut self.list);
        let mut stats = DrawStats {
            culled: self.chunks.len() - plan.chunks.len(),
            land_bytes: self.chunks.bytes(),
            plan: plan.stats,
            gpu_ms,
            ..DrawStats::default()
        };
        self.draw_scene(frame, kind, encoder, &mut stats);
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

    /// Makes the pipelines of the frame's map, and of the map that the player may turn to from there, so that a
    /// turn does not stutter. Returns the map's number.
    fn make_pipelines(&mut self, frame: &Frame) -> u32 {
        let kind = frame.strategy.uniform(&frame.eye, &frame.projection).kind[0];
        if self.pipelines[kind as usize % MAPS].is_none() {
            let companion = if frame.strategy.has_sky() {
                HORIZON
            } else {
                kind
            };
            for kind in [kind, companion] {
                let place = &mut self.pipelines[kind as usize % MAPS];
                if place.is_none() {
                    let samples = self.options.samples;
                    *place = Some(Pipelines::new(
                        &self.device,
                        &self.scene_layout,
                        kind,
                        samples,
                    ));
                }
            }
        }
        kind
    }

    fn begin_scene<'e>(
        &self,
        encoder: &'e mut CommandEncoder,
        horizon: [f32; 3],
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
            timestamp_writes: self.timing.as_ref().map(Timing::begin),
            ..Default::default()
        })
    }

    fn draw_scene(
        &self,
        frame: &Frame,
        kind: u32,
        encoder: &mut CommandEncoder,
        stats: &mut DrawStats,
    ) {
        let mut pass = self.begin_scene(encoder, frame.sky.horizon);
        let Some(pipelines) = &self.pipelines[kind as usize % MAPS] else {
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
        if frame.sky.dome {
            pass.set_pipeline(&pipelines.sky);
            pass.draw(0..3, 0..1);
            stats.add((1, 1));
            stats.add(
                self.celestial
                    .draw(&mut pass, &frame.sky, &pipelines.celestial),
            );
        }
        if self.marker.shown() {
            for pipeline in [&pipelines.marker_hidden, &pipelines.marker] {
                pass.set_pipeline(pipeline);
                stats.add(self.marker.draw(&mut pass));
            }
        }
    }
}

fn check(options: &Options) -> Result<(), RenderError> {
    if !matches!(options.samples, 1 | 4) {
        return Err(RenderError::Options(format!(
            "{} samples a pixel were asked for, and only 1 or 4 work",
            options.samples
        )));
    }
    if !(0.1..=1.0).contains(&options.scale) {
        return Err(RenderError::Options(format!(
            "a scale of {} was asked for, and only 0.1 to 1 work",
            options.scale
        )));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn options_out_of_range_are_refused_in_words() {
        let good = Options {
            samples: 4,
            scale: 0.5,
            output_format: TextureFormat::Bgra8UnormSrgb,
        };
        assert_eq!(check(&good), Ok(()));
        for bad in [
            Options { samples: 2, ..good },
            Options { scale: 0.0, ..good },
            Options {
                scale: f32::NAN,
                ..good
            },
        ] {
            let words = check(&bad).err().map(|e| e.to_string()).unwrap_or_default();
            assert!(
                words.starts_with("The renderer cannot be set up"),
                "{words}"
            );
        }
    }
}
