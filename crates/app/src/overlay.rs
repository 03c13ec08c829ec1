//! The interface painted over a picture: egui's shapes into the same texture, for window and script alike.

use antipode_render::Gpu;
use egui_wgpu::{RendererOptions, ScreenDescriptor};

/// Paints egui's output into texture views of one format.
pub struct Overlay {
    context: egui::Context,
    renderer: egui_wgpu::Renderer,
}

impl std::fmt::Debug for Overlay {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Overlay").finish_non_exhaustive()
    }
}

impl Overlay {
    /// An overlay with the game's theme for targets of the given format.
    pub fn new(gpu: &Gpu, format: wgpu::TextureFormat) -> Self {
        let context = egui::Context::default();
        antipode_ui::apply_theme(&context);
        let renderer = egui_wgpu::Renderer::new(&gpu.device, format, RendererOptions::default());
        Self { context, renderer }
    }

    /// The interface's context.
    pub fn context(&self) -> &egui::Context {
        &self.context
    }

    /// Paints one pass of the interface over what each of the targets, all of one size in pixels, holds.
    pub fn paint(
        &mut self,
        gpu: &Gpu,
        encoder: &mut wgpu::CommandEncoder,
        targets: &[&wgpu::TextureView],
        size: (u32, u32),
        output: egui::FullOutput,
    ) {
        let screen = ScreenDescriptor {
            size_in_pixels: [size.0, size.1],
            pixels_per_point: output.pixels_per_point,
        };
        for (id, deltas) in &output.textures_delta.set {
            for delta in deltas {
                self.renderer
                    .update_texture(&gpu.device, &gpu.queue, *id, delta);
            }
        }
        let shapes = self
            .context
            .tessellate(output.shapes, output.pixels_per_point);
        let uploads =
            self.renderer
                .update_buffers(&gpu.device, &gpu.queue, encoder, &shapes, &screen);
        gpu.queue.submit(uploads);
        for target in targets {
            let pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                label: Some("interface"),
                color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                    view: target,
                    depth_slice: None,
                    resolve_target: None,
                    ops: wgpu::Operations {
                        load: wgpu::LoadOp::Load,
                        store: wgpu::StoreOp::Store,
                    },
                })],
                ..Default::default()
            });
            self.renderer
                .render(&mut pass.forget_lifetime(), &shapes, &screen);
        }
        for id in &output.textures_delta.free {
            self.renderer.free_texture(id);
        }
    }
}
