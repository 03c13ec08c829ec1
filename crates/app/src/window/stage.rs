//! The window with everything that draws into it.

use std::sync::Arc;

use antipode_render::{Gpu, Offscreen, Options, Renderer};
use antipode_scene::frame::Frame;
use image::RgbaImage;
use winit::event_loop::OwnedDisplayHandle;
use winit::window::Window;

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
    drawn: Option<Drawn>,
    gpu_ms: Option<f64>,
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
            drawn: None,
            gpu_ms: None,
        })
    }

    /// The adapter's name.
    pub fn adapter_name(&self) -> &str {
        self.gpu.name()
    }

    /// What a player should know of the adapter, if anything.
    pub fn notice(&self) -> Option<String> {
        self.gpu.is_software().then(|| {
            format!(
                "No graphics card was found: {} draws in software, at half resolution. It works, but slowly.",
                self.gpu.name()
            )
        })
    }

    /// What the last frame of the world was drawn with, and the adapter's own time in milliseconds.
    pub fn drawn(&self) -> Option<(Drawn, Option<f64>)> {
        self.drawn.map(|drawn| (drawn, self.gpu_ms))
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

    /// Draws the world, if there is one, and the interface, and shows them.
    ///
    /// # Errors
    /// When the adapter is lost.
    pub fn show(
        &mut self,
        texture: wgpu::SurfaceTexture,
        frame: Option<&Frame>,
        interface: egui::FullOutput,
    ) -> Result<(), Failure> {
        let target = texture
            .texture
            .create_view(&wgpu::TextureViewDescriptor::default());
        self.paint(frame, interface, &target);
        self.window.pre_present_notify();
        self.gpu.queue.present(texture);
        self.check()
    }

    /// A small picture of the world for the menu; none where the adapter cannot make one.
    pub fn thumbnail(&mut self, frame: &Frame) -> Option<RgbaImage> {
        if !is_plain(self.config.format) && !self.config.format.is_srgb() {
            return None;
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
        match offscreen.read(&self.gpu) {
            Ok(picture) => Some(picture),
            Err(error) => {
                tracing::info!("no picture for the menu: {error}");
                None
            }
        }
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
        let size = (self.config.width, self.config.height);
        self.overlay
            .paint(&self.gpu, &mut encoder, target, size, interface);
        self.gpu.queue.submit([encoder.finish()]);
    }
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
