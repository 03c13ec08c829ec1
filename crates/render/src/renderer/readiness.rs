//! Keeps the pipelines of frames ready, and handles a frame whose pipelines are not made yet.

use antipode_frame::Frame;
use wgpu::{BindGroupLayout, CommandEncoder, Device, TextureView};

use super::{DrawStats, Options, Picture, Renderer, check};
use crate::error::RenderError;
use crate::pipeline_cache::{Key, PipelineCache};
use crate::pipelines::{Pipelines, scene_layout};
use crate::shaders::Shaders;
use crate::shadow::ShadowQuality;
use crate::targets::drawn_size;
use crate::tonemap::Tonemap;

/// Samples a pixel, the shadows' quality, and whether there are surfaces.
type PipelineQuality = (u32, ShadowQuality, bool);

impl Options {
    pub(super) fn pipeline_quality(&self) -> PipelineQuality {
        (self.samples, self.shadows, self.surfaces)
    }
}

/// Pipelines of a quality.
pub(super) fn pipeline_cache(
    device: &Device,
    shaders: Shaders,
    layout: &BindGroupLayout,
    quality: PipelineQuality,
) -> PipelineCache<Pipelines> {
    PipelineCache::new(maker(device, shaders, layout, quality))
}

#[allow(
    clippy::type_complexity,
    reason = "a cache of pipelines takes it as it is"
)]
fn maker(
    device: &Device,
    shaders: Shaders,
    layout: &BindGroupLayout,
    quality: PipelineQuality,
) -> Box<dyn Fn(Key) -> Result<Pipelines, String> + Send + Sync> {
    let (device, layout) = (device.clone(), layout.clone());
    Box::new(move |key| Pipelines::new(&device, shaders, &layout, key, quality))
}

impl Renderer {
    /// Begins to make ready for all maps, in a thread: for whoever shows frames in motion. From now on no frame waits
    /// for that, but one after [`Renderer::complete_next`]: until its map is ready, the last picture of the same world
    /// is shown again, if there is one.
    pub fn prepare_maps(&mut self) {
        self.patient = false;
        // Another frame of the same map is the likeliest.
        if let Some(map) = self.map {
            self.pipelines.order(map);
        }
        self.pipelines.order_all();
    }

    /// Whether a frame of any map can be drawn now.
    pub fn are_maps_ready(&self) -> bool {
        self.patient || self.pipelines.are_all_made()
    }

    /// Draws with other options from the next frame on. The land stays on the adapter; pipelines are made anew where
    /// the samples, the shadows or the surfaces differ. After [`Renderer::prepare_maps`] no frame waits for those: they are drawn
    /// with the options before until the new ones are ready.
    ///
    /// # Errors
    /// When the options are out of range, or the adapter refuses a shader; nothing is changed then.
    pub fn set_options(&mut self, options: Options) -> Result<(), RenderError> {
        check(&options)?;
        let is_scaled = options.scale != 1.0;
        let tonemap =
            Tonemap::accepted(&self.device, self.shaders, options.output_format, is_scaled)?;
        let quality = options.pipeline_quality();
        if let Some(later) = &mut self.later
            && later.0.pipeline_quality() == quality
        {
            // What is being made for those serves for these, too.
            *later = (options, tonemap);
            return Ok(());
        }
        self.pipelines.keep();
        self.later = None;
        if quality == self.options.pipeline_quality() {
            self.take_options(options, tonemap);
            return Ok(());
        }
        let layout = scene_layout(&self.device);
        if self.patient {
            self.pipelines = pipeline_cache(&self.device, self.shaders, &layout, quality);
            self.take_options(options, tonemap);
        } else {
            let make = maker(&self.device, self.shaders, &layout, quality);
            self.pipelines.renew(make);
            self.later = Some((options, tonemap));
        }
        Ok(())
    }

    fn take_options(&mut self, options: Options, tonemap: Tonemap) {
        self.options = options;
        self.tonemap = tonemap;
        self.shadows.set_quality(options.shadows);
        self.further.clear();
        self.openings.clear();
        self.deeper.clear();
        self.fit();
    }

    /// Makes ready for targets of `width` by `height` pixels.
    pub fn resize(&mut self, width: u32, height: u32) {
        self.asked = (width, height, false);
        self.fit();
    }

    /// Makes ready for targets of `width` by `height` pixels at their full resolution, whatever share the options
    /// say: for pictures that are kept. [`Renderer::resize`] goes back.
    pub fn resize_full(&mut self, width: u32, height: u32) {
        self.asked = (width, height, true);
        self.fit();
    }

    fn fit(&mut self) {
        let (width, height, full) = self.asked;
        let scale = if full { 1.0 } else { self.options.scale };
        let size = drawn_size(width, height, scale, self.largest_side());
        self.height_px = height;
        let samples = self.options.samples;
        self.picture.fit(&self.device, &self.tonemap, size, samples);
        self.pictured = None;
    }

    /// Why the scene cannot be drawn: the adapter refuses one of its shaders. Known for all maps once
    /// [`Renderer::prepare_maps`] has come to its end, and for the map of a frame when that is drawn.
    pub fn fault(&self) -> Option<RenderError> {
        self.pipelines.refused().map(RenderError::shader)
    }

    /// The frame's map. Sees to it that the map that the player may turn to from there is made ready meanwhile, so that
    /// a turn does not stutter.
    pub(super) fn map_of(&mut self, frame: &Frame) -> Key {
        let key = key(frame);
        if self.map != Some(key) {
            self.map = Some(key);
            if let Some(next) = key.map.turns_to {
                self.pipelines.order(Key::whole(next));
            }
        }
        key
    }

    /// A further view's map. Where its frame may wait it is ready now; else it is ordered, and nothing waits
    /// for it.
    pub(super) fn map_of_further(&mut self, frame: &Frame) -> Key {
        let map = key(frame);
        if self.patient || self.chunks.rush {
            self.pipelines.finish(map);
        } else if !self.pipelines.is_made(map) {
            self.pipelines.order(map);
        }
        map
    }

    /// Whether a frame of a map can be drawn now. One that is to be complete, and any where nobody prepares, waits
    /// here until it can.
    pub(super) fn is_ready(&mut self, map: Key) -> bool {
        if self.patient || self.chunks.rush {
            self.pipelines.finish(map);
        } else {
            self.pipelines.want(map);
            if self.pipelines.turn(map)
                && let Some((options, tonemap)) = self.later.take()
            {
                self.take_options(options, tonemap);
            }
        }
        self.awaits_map = !self.pipelines.is_made(map);
        !self.awaits_map
    }

    /// Takes over what the frame brings, and records the last picture of the same world in its place.
    pub(super) fn show_last(
        &mut self,
        frame: &Frame,
        encoder: &mut CommandEncoder,
        target: &TextureView,
    ) -> DrawStats {
        self.chunks.apply(frame);
        let picture = if self.pictured == Some(frame.content.loaded_world) {
            self.show_again(encoder, target);
            Picture::Last
        } else {
            Picture::None
        };
        DrawStats {
            picture,
            land_bytes: self.chunks.bytes(),
            ..DrawStats::default()
        }
    }
}

/// What a frame is drawn by.
fn key(frame: &Frame) -> Key {
    Key {
        map: frame.view.strategy.shader(),
        is_cut: frame.view.is_cut(),
    }
}
