//! The window with everything that draws into it.

mod canvas;
mod input;
mod pictures;
mod recovery;
mod rooms;
mod show;
pub mod world;

use std::collections::VecDeque;
use std::sync::Arc;
use std::time::Instant;

use antipode_language::Texts;
use antipode_render::{AdapterChoice, Gpu, Options, PictureReading, Preset, Renderer, Shaders};
use antipode_room_scene::RoomScene;
use antipode_settings::Settings;
use winit::event_loop::OwnedDisplayHandle;
use winit::window::{Fullscreen, Window};

use crate::common::Common;
use crate::drawn::Drawn;
use crate::failure::Failure;
use crate::options;
use crate::overlay::Overlay;
use crate::picture::adapter_choice;
use crate::window::visit::RoomId;
use canvas::Canvas;
use recovery::Recoveries;
use rooms::Rooms;
pub use show::{SceneShown, Showing};
use world::Pictured;

/// Window, surface, renderer and interface.
pub struct Stage {
    /// The window.
    pub window: Arc<Window>,
    /// The interface over the picture.
    pub overlay: Overlay,
    /// What turns window events into the interface's input.
    pub input: egui_winit::State,
    gpu: Gpu,
    display: OwnedDisplayHandle,
    choice: AdapterChoice,
    /// None while the adapter is lost and no other is open.
    surface: Option<wgpu::Surface<'static>>,
    config: wgpu::SurfaceConfiguration,
    renderer: Renderer,
    options: Options,
    rooms: Rooms,
    pictured: Pictured,
    /// The tile of a larger picture under way.
    tile: Option<PictureReading>,
    /// Pictures of the screen under way, the first asked for first.
    screenshots: VecDeque<PictureReading>,
    /// The menu's picture under way, and of which world.
    thumbnail: Option<(u64, PictureReading)>,
    recoveries: Recoveries,
    /// When the interface's time began.
    began: Instant,
    /// The next texture is to be taken for lost, on purpose.
    loses_surface: bool,
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
        shaders: Shaders,
    ) -> Result<Self, Failure> {
        let choice = adapter_choice(common.adapter);
        let Canvas {
            gpu,
            surface,
            config,
            renderer,
            options,
        } = Canvas::open(&window, display.clone(), choice, shaders)?;
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
            display,
            choice,
            surface: Some(surface),
            config,
            renderer,
            options,
            rooms: Rooms::default(),
            pictured: Pictured::default(),
            tile: None,
            screenshots: VecDeque::new(),
            thumbnail: None,
            recoveries: Recoveries::default(),
            began: Instant::now(),
            loses_surface: false,
        })
    }

    /// The adapter's name.
    pub fn adapter_name(&self) -> &str {
        self.gpu.name()
    }

    /// The adapter, its driver and the interface to it.
    pub fn adapter_info(&self) -> wgpu::AdapterInfo {
        self.gpu.adapter.get_info()
    }

    /// The adapter's name if it draws in software, which a player should know.
    pub fn software(&self) -> Option<String> {
        let software = self.gpu.is_software();
        software.then(|| self.gpu.name().to_owned())
    }

    /// What the last frame of the world was drawn with, and the adapter's own time in milliseconds.
    pub fn drawn(&self) -> Option<(Drawn, Option<f64>)> {
        self.pictured.told()
    }

    /// Draws, shows and waits as the settings say from the next frame on.
    ///
    /// # Errors
    /// When the renderer refuses; it goes on as before then.
    pub fn follow(&mut self, settings: &Settings) -> Result<(), Failure> {
        let preset = options::preset(settings, self.gpu.is_software());
        let software = preset == Preset::Software;
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
            self.configure();
        }
        let options = Options {
            samples: settings.msaa.samples(software),
            scale: settings.render_scale.share(software),
            output_format: self.config.format,
            shadows: options::shadows(settings, software),
            preset,
        };
        if options != self.options {
            self.renderer.set_options(options)?;
            self.options = options;
            self.renderer.resize(self.config.width, self.config.height);
            self.renderer.prepare_maps();
        }
        Ok(())
    }

    /// Whether the next frame of the same moment would show more, or there is a picture to take over.
    pub fn is_busy(&self) -> bool {
        self.reads_pictures() || self.renderer.is_busy() || self.rooms.is_busy()
    }

    /// Whether land that the frames have brought is not shown yet, or not as fine as it is to be.
    pub fn is_land_coming(&self) -> bool {
        self.renderer.is_land_coming()
    }

    /// Whether any world can be drawn now.
    pub fn are_maps_ready(&self) -> bool {
        self.renderer.are_maps_ready()
    }

    /// Has the interface drawn with so many pixels a point, as on another monitor.
    pub fn rescale(&mut self, scale: f32) {
        let context = self.overlay.context();
        context.set_pixels_per_point(scale);
    }

    /// A room is to be drawn: begins to make what for, unless that is there. Returns why it cannot be drawn, once.
    /// What is read in it is in the language of `texts`.
    pub fn prepare_room(&mut self, id: RoomId, room: &RoomScene, texts: &Texts) -> Option<Failure> {
        let shown = (room, texts);
        self.rooms.prepare(&self.gpu, &self.options, id, shown)
    }

    /// Whether what is shown of a room is as it was a while ago.
    pub fn is_room_late(&self) -> bool {
        self.rooms.is_late()
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
        let most = self.largest_side();
        let (width, height) = (width.min(most), height.min(most));
        self.config.width = width;
        self.config.height = height;
        self.configure();
        self.renderer.resize(width, height);
    }

    /// The texture to show next; none while nobody can see the window or there is nothing to draw on.
    pub fn next_texture(&mut self) -> Option<wgpu::SurfaceTexture> {
        use wgpu::CurrentSurfaceTexture as Current;
        for _ in 0..2 {
            let next = if std::mem::take(&mut self.loses_surface) {
                Current::Lost
            } else {
                self.surface.as_ref()?.get_current_texture()
            };
            match next {
                Current::Success(texture) | Current::Suboptimal(texture) => return Some(texture),
                Current::Outdated => self.configure(),
                Current::Lost => self.remake_surface(),
                Current::Timeout | Current::Occluded | Current::Validation => return None,
            }
        }
        None
    }

    fn configure(&self) {
        if let Some(surface) = &self.surface {
            surface.configure(&self.gpu.device, &self.config);
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
