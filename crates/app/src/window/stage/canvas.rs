//! The canvas: adapter, surface and renderer, which come and go together.

use std::sync::Arc;

use antipode_render::{AdapterChoice, Gpu, Options, Renderer, Shaders, ShadowQuality};
use winit::event_loop::OwnedDisplayHandle;
use winit::window::Window;

use super::best_format;
use crate::failure::Failure;

/// Share of the resolution drawn on a software adapter.
const SOFTWARE_SCALE: f32 = 0.5;

/// An open adapter, a window's surface and a renderer for it.
pub struct Canvas {
    pub gpu: Gpu,
    pub surface: wgpu::Surface<'static>,
    pub config: wgpu::SurfaceConfiguration,
    pub renderer: Renderer,
    pub options: Options,
}

impl Canvas {
    /// Opens an adapter that can draw into the window, which has no other surface.
    ///
    /// # Errors
    /// When there is none of the kind asked for, or it refuses to draw.
    pub fn open(
        window: &Arc<Window>,
        display: OwnedDisplayHandle,
        choice: AdapterChoice,
        shaders: Shaders,
    ) -> Result<Self, Failure> {
        let (gpu, surface) = Gpu::for_window(Box::new(display), Arc::clone(window), choice)?;
        #[expect(clippy::disallowed_methods, reason = "no event has told it yet")]
        let size = window.inner_size();
        let most = gpu.device.limits().max_texture_dimension_2d;
        let (width, height) = (size.width.clamp(1, most), size.height.clamp(1, most));
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
            shadows: if software {
                ShadowQuality::Low
            } else {
                ShadowQuality::High
            },
            surfaces: !software,
        };
        let mut renderer = Renderer::with_shaders(&gpu, options, shaders)?;
        renderer.resize(width, height);
        renderer.prepare_maps();
        Ok(Self {
            gpu,
            surface,
            config,
            renderer,
            options,
        })
    }
}
