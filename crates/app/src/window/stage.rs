//! The window with everything that draws into it.

use std::collections::VecDeque;
use std::sync::Arc;

use antipode_render::{Gpu, Offscreen, Options, PictureReading, RenderError, Renderer, Tile};
use antipode_scene::frame::Frame;
use antipode_settings::Settings;
use image::RgbaImage;
use winit::event_loop::OwnedDisplayHandle;
use winit::window::{Fullscreen, Window};

use crate::cli::Common;
use crate::drawn::Drawn;
use crate::failure::Failure;
use crate::overlay::Overlay;
use crate::picture::adapter_choice;

/// Share of the resolution drawn on a software adapter.
const SOFTWARE_SCALE: f32 = 0.5;
/// Size of the menu's pictures in pixels.
const THUMBNAIL: (u32, u32) = (320, 180);

/// Colour behind the menu when no world is open, linear light.
const BACKDROP: wgpu::Color = wgpu::Color {
    r: 0.012,
    g: 0.018,
    b: 0.035,
    a: 1.0,
};

/// Window, surface, renderer and interface.
pub struct Stage {
    /// The window.
    pub window: Arc<Window>,
    /// The interface over the picture.
    pub overlay: Overlay,
    /// What turns window events into the interface's input.
    pub input: egui_winit::State,
    gpu: Gpu,
    surface: wgpu::Surface<'static>,
    config: wgpu::SurfaceConfiguration,
    renderer: Renderer,
    options: Options,
    drawn: Option<Drawn>,
    gpu_ms: Option<f64>,
    /// The tile of a larger picture under way.
    tile: Option<PictureReading>,
    /// Pictures of the screen under way, the first asked for first.
    screenshots: VecDeque<PictureReading>,
    /// The menu's picture under way, and of which world.
    thumbnail: Option<(u64, PictureReading)>,
}

impl std::fmt::Debug for Stage {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Stage")
            .field("gpu", &self.gpu)
            .finish_non_exhaustive()
    }
}

impl Stage {
    /// Sets up drawing into a window.
    ///
    /// # Errors
    /// When no adapter of the kind asked for can draw into it.
    pub fn new(
        window: Arc<Window>,
        display: OwnedDisplayHandle,
        common: &Common,
    ) -> Result<Self, Failure> {
        let (gpu, surface) = Gpu::for_window(
            Box::new(display),
            Arc::clone(&window),
            adapter_choice(common.adapter),
        )?;
        let size = window.inner_size();
        let (width, height) = (size.width.max(1), size.height.max(1));
        let mut config = surface
            .get_default_config(&gpu.adapter, width, height)
            .ok_or_else(|| {
                Failure::Runtime(format!(
                    "The adapter {} cannot draw into a window.",
                    gpu.name()
                ))
            })?;
        let formats = surface.get_capabilities(&gpu.adapter).formats;
        config.format = best_format(&formats, config.format);
        config.present_mode = wgpu::PresentMode::AutoVsync;
        surface.configure(&gpu.device, &config);
        let software = gpu.is_software();
        let options = Options {
            samples: if software { 1 } else { 4 },
            scale: if software { SOFTWARE_SCALE } else { 1.0 },
            output_format: config.format,
        };
        let mut renderer = Renderer::new(&gpu, options)?;
        renderer.resize(width, height);
        renderer.prepare_maps();
        let overlay = Overlay::new(&gpu, config.format);
        let input = egui_winit::State::new(
            overlay.context().clone(),
            egui::ViewportId::ROOT,
            &window,
            Some(window.scale_factor() as f32),
            None,
            Some(gpu.device.limits().max_texture_dimension_2d as usize),
        );
        Ok(Self {
            window,
            overlay,
            input,
            gpu,
            surface,
            config,
            renderer,
            options,
            drawn: None,
            gpu_ms: None,
            tile: None,
            screenshots: VecDeque::new(),
            thumbnail: None,
        })
    }

    /// The adapter's name.
    pub fn adapter_name(&self) -> &str {
        self.gpu.name()
    }

    /// The adapter's name if it draws in software, at half resolution, which a player should know.
    pub fn software(&self) -> Option<String> {
        let software = self.gpu.is_software();
        software.then(|| self.gpu.name().to_owned())
    }

    /// What the last frame of the world was drawn with, and the adapter's own time in milliseconds.
    pub fn drawn(&self) -> Option<(Drawn, Option<f64>)> {
        self.drawn.map(|drawn| (drawn, self.gpu_ms))
    }

    /// Draws, shows and waits as the settings say from the next frame on.
    ///
    /// # Errors
    /// When the renderer refuses; it goes on as before then.
    pub fn follow(&mut self, settings: &Settings) -> Result<(), Failure> {
        let software = self.gpu.is_software();
        let context = self.overlay.context();
        context.set_zoom_factor(settings.ui_scale as f32);
        antipode_ui::set_calm(context, settings.reduced_motion);
        let wanted = settings.fullscreen.then_some(Fullscreen::Borderless(None));
        if self.window.fullscreen().is_some() != wanted.is_some() {
            self.window.set_fullscreen(wanted);
        }
        let present_mode = if settings.vsync {
            wgpu::PresentMode::AutoVsync
        } else {
            wgpu::PresentMode::AutoNoVsync
        };
        if self.config.present_mode != present_mode {
            self.config.present_mode = present_mode;
            self.surface.configure(&self.gpu.device, &self.config);
        }
        let options = Options {
            samples: settings.msaa.samples(software),
            scale: settings.render_scale.share(software),
            output_format: self.config.format,
        };
        if options != self.options {
            self.renderer.set_options(options)?;
            self.options = options;
            self.renderer.resize(self.config.width, self.config.height);
            self.renderer.prepare_maps();
        }
        Ok(())
    }

    /// Width over height.
    pub fn aspect(&self) -> f64 {
        f64::from(self.config.width) / f64::from(self.config.height)
    }

    /// Lines of the picture, pixels.
    pub fn height_px(&self) -> u32 {
        self.config.height
    }

    /// The window has a new size in pixels; a size of zero (minimised) changes nothing.
    pub fn resize(&mut self, width: u32, height: u32) {
        if width == 0 || height == 0 {
            return;
        }
        self.config.width = width;
        self.config.height = height;
        self.surface.configure(&self.gpu.device, &self.config);
        self.renderer.resize(width, height);
    }

    /// The texture to show next; none while nobody can see the window or its surface is being made anew.
    ///
    /// # Errors
    /// When the adapter is lost.
    pub fn next_texture(&mut self) -> Result<Option<wgpu::SurfaceTexture>, Failure> {
        use wgpu::CurrentSurfaceTexture as Current;
        self.check()?;
        for _ in 0..2 {
            match self.surface.get_current_texture() {
                Current::Success(texture) | Current::Suboptimal(texture) => {
                    return Ok(Some(texture));
                }
                Current::Outdated | Current::Lost => {
                    self.surface.configure(&self.gpu.device, &self.config);
                }
                _ => break,
            }
        }
        self.check()?;
        Ok(None)
    }

    /// Draws the world, if there is one, and the interface, and shows them. `keeps`: what is shown is read back too.
    ///
    /// # Errors
    /// When the adapter is lost.
    pub fn show(
        &mut self,
        texture: wgpu::SurfaceTexture,
        frame: Option<&Frame>,
        interface: egui::FullOutput,
        keeps: bool,
    ) -> Result<(), Failure> {
        let target = texture
            .texture
            .create_view(&wgpu::TextureViewDescriptor::default());
        let kept = (keeps && self.can_keep())
            .then(|| self.offscreen((self.config.width, self.config.height)));
        let copy = kept.as_ref().map(Offscreen::view);
        self.paint(frame, interface, &target, copy);
        if let Some(kept) = kept {
            self.screenshots.push_back(kept.begin_read(&self.gpu));
        }
        self.window.pre_present_notify();
        self.gpu.queue.present(texture);
        self.check()
    }

    /// Has a small picture of the world drawn for the menu, in place of one that is not finished. `world` comes
    /// back with it. There is none where the adapter cannot make one.
    pub fn begin_thumbnail(&mut self, world: u64, frame: &Frame) {
        if !is_plain(self.config.format) && !self.config.format.is_srgb() {
            return;
        }
        let (width, height) = THUMBNAIL;
        let offscreen = Offscreen::new(&self.gpu, width, height, self.config.format);
        let mut encoder = self
            .gpu
            .device
            .create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        self.renderer.resize(width, height);
        self.renderer.draw(frame, &mut encoder, offscreen.view());
        self.gpu.queue.submit([encoder.finish()]);
        self.renderer.resize(self.config.width, self.config.height);
        self.thumbnail = Some((world, offscreen.begin_read(&self.gpu)));
    }

    /// The picture begun last, once, as soon as the adapter has finished it. Never waits.
    pub fn finished_thumbnail(&mut self) -> Option<(u64, RgbaImage)> {
        let (world, reading) = self.thumbnail.take()?;
        match reading.poll(&self.gpu) {
            Ok(picture) => picture_or_note(picture).map(|picture| (world, picture)),
            Err(reading) => {
                self.thumbnail = Some((world, reading));
                None
            }
        }
    }

    /// The picture begun last, waited for.
    pub fn awaited_thumbnail(&mut self) -> Option<(u64, RgbaImage)> {
        let (world, reading) = self.thumbnail.take()?;
        picture_or_note(reading.finish(&self.gpu)).map(|picture| (world, picture))
    }

    /// The picture of the screen asked for first, once, as soon as the adapter has finished it. Never waits.
    pub fn finished_screenshot(&mut self) -> Option<Result<RgbaImage, RenderError>> {
        match self.screenshots.pop_front()?.poll(&self.gpu) {
            Ok(picture) => Some(picture),
            Err(reading) => {
                self.screenshots.push_front(reading);
                None
            }
        }
    }

    /// Has a tile of a larger picture drawn, of `size` pixels, at full resolution and complete.
    pub fn begin_tile(&mut self, frame: &Frame, tile: Tile, size: (u32, u32)) {
        let offscreen = self.offscreen(size);
        let mut encoder = self
            .gpu
            .device
            .create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        self.renderer.resize_full(size.0, size.1);
        self.renderer
            .draw_tile(frame, tile, &mut encoder, offscreen.view());
        self.gpu.queue.submit([encoder.finish()]);
        self.renderer.resize(self.config.width, self.config.height);
        self.tile = Some(offscreen.begin_read(&self.gpu));
    }

    /// The tile begun last, once, as soon as the adapter has finished it. Never waits.
    pub fn finished_tile(&mut self) -> Option<Result<RgbaImage, RenderError>> {
        match self.tile.take()?.poll(&self.gpu) {
            Ok(picture) => Some(picture),
            Err(reading) => {
                self.tile = Some(reading);
                None
            }
        }
    }

    /// Size of the window, pixels.
    pub fn size(&self) -> (u32, u32) {
        (self.config.width, self.config.height)
    }

    /// Longest side of a picture that can be drawn, pixels.
    pub fn largest_side(&self) -> u32 {
        self.renderer.largest_side()
    }

    /// Whether what is shown can be read back: the window's format has four channels of 8 bits. Wide ones are what
    /// is left where a surface has no other, on no system known.
    pub fn can_keep(&self) -> bool {
        is_plain(self.config.format) || self.config.format.is_srgb()
    }

    fn offscreen(&self, (width, height): (u32, u32)) -> Offscreen {
        Offscreen::new(&self.gpu, width, height, self.config.format)
    }

    fn check(&self) -> Result<(), Failure> {
        match self.gpu.lost() {
            Some(why) => Err(Failure::Runtime(format!(
                "The graphics adapter was lost: {why}. Start the game again; your world is saved."
            ))),
            None => Ok(()),
        }
    }

    fn paint(
        &mut self,
        frame: Option<&Frame>,
        interface: egui::FullOutput,
        target: &wgpu::TextureView,
        copy: Option<&wgpu::TextureView>,
    ) {
        let mut encoder = self
            .gpu
            .device
            .create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        match frame {
            Some(frame) => {
                let stats = self.renderer.draw(frame, &mut encoder, target);
                self.drawn = Some(Drawn::new(&stats, frame.quality));
                // The time of a frame comes some frames later; until then the last one stands.
                self.gpu_ms = stats.gpu_ms.map(f64::from).or(self.gpu_ms);
            }
            None => clear(&mut encoder, target),
        }
        match (copy, frame) {
            (Some(copy), Some(_)) => self.renderer.show_again(&mut encoder, copy),
            (Some(copy), None) => clear(&mut encoder, copy),
            (None, _) => {}
        }
        let targets: Vec<_> = [target].into_iter().chain(copy).collect();
        let size = (self.config.width, self.config.height);
        self.overlay
            .paint(&self.gpu, &mut encoder, &targets, size, interface);
        self.gpu.queue.submit([encoder.finish()]);
    }
}

fn picture_or_note(read: Result<RgbaImage, RenderError>) -> Option<RgbaImage> {
    read.inspect_err(|error| tracing::info!("no picture for the menu: {error}"))
        .ok()
}

/// A format of four bytes without conversion: the interface is designed for blending in display values.
fn is_plain(format: wgpu::TextureFormat) -> bool {
    use wgpu::TextureFormat::{Bgra8Unorm, Rgba8Unorm};
    matches!(format, Bgra8Unorm | Rgba8Unorm)
}

/// The plain format if the surface has one; wide ones such as `Rgba16Float` are read as linear light by the system.
fn best_format(
    formats: &[wgpu::TextureFormat],
    otherwise: wgpu::TextureFormat,
) -> wgpu::TextureFormat {
    let mut formats = formats.iter().copied();
    formats
        .find(|&format| is_plain(format))
        .unwrap_or(otherwise)
}

fn clear(encoder: &mut wgpu::CommandEncoder, target: &wgpu::TextureView) {
    encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: Some("backdrop"),
        color_attachments: &[Some(wgpu::RenderPassColorAttachment {
            view: target,
            depth_slice: None,
            resolve_target: None,
            ops: wgpu::Operations {
                load: wgpu::LoadOp::Clear(BACKDROP),
                store: wgpu::StoreOp::Store,
            },
        })],
        ..Default::default()
    });
}

#[cfg(test)]
mod tests {
    use wgpu::TextureFormat as Format;

    use super::*;

    #[test]
    fn plain_formats_go_before_wide_and_converting_ones() {
        let wide = [
            Format::Rgba16Float,
            Format::Bgra8UnormSrgb,
            Format::Bgra8Unorm,
        ];
        assert_eq!(best_format(&wide, wide[0]), Format::Bgra8Unorm);
        assert_eq!(
            best_format(&wide[..2], Format::Bgra8UnormSrgb),
            Format::Bgra8UnormSrgb
        );
    }
}
