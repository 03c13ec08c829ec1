//! The interface painted over a picture: egui's shapes into the same texture, for window and script alike.

use std::collections::HashMap;

use antipode_render::Gpu;
use egui::epaint::ImageDelta;
use egui::{ImageData, TextureId, TexturesDelta};
use egui_wgpu::{RendererOptions, ScreenDescriptor};

/// Paints egui's output into texture views of one format.
pub struct Overlay {
    context: egui::Context,
    renderer: egui_wgpu::Renderer,
    /// What every texture holds, to be sent again when the adapter is another.
    textures: HashMap<TextureId, ImageDelta>,
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
        Self {
            context,
            renderer,
            textures: HashMap::new(),
        }
    }

    /// Paints with another adapter from now on; the last one may be lost.
    pub fn move_to(&mut self, gpu: &Gpu, format: wgpu::TextureFormat) {
        let options = RendererOptions::default();
        self.renderer = egui_wgpu::Renderer::new(&gpu.device, format, options);
        for (id, whole) in &self.textures {
            self.renderer
                .update_texture(&gpu.device, &gpu.queue, *id, whole);
        }
    }

    /// Takes note of what a pass changes that is not painted.
    pub fn skip(&mut self, changes: &TexturesDelta) {
        for (id, deltas) in &changes.set {
            for delta in deltas {
                self.note(*id, delta);
            }
        }
        for id in &changes.free {
            self.textures.remove(id);
        }
    }

    fn note(&mut self, id: TextureId, delta: &ImageDelta) {
        match (delta.pos, self.textures.get_mut(&id)) {
            (None, _) => {
                self.textures.insert(id, delta.clone());
            }
            (Some(corner), Some(whole)) => patch(&mut whole.image, &delta.image, corner),
            // A part of nothing: there is no such texture.
            (Some(_), None) => {}
        }
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
        self.skip(&output.textures_delta);
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

/// Writes a part over a picture. What would lie outside is left out.
fn patch(whole: &mut ImageData, part: &ImageData, [left, top]: [usize; 2]) {
    let (ImageData::Color(whole), ImageData::Color(part)) = (whole, part);
    let whole = std::sync::Arc::make_mut(whole);
    let ([width, _], [part_width, _]) = (whole.size, part.size);
    let fits = part_width.min(width.saturating_sub(left));
    let rows = whole.pixels.chunks_exact_mut(width.max(1)).skip(top);
    for (row, new) in rows.zip(part.pixels.chunks_exact(part_width.max(1))) {
        row[left.min(width)..][..fits].copy_from_slice(&new[..fits]);
    }
}

#[cfg(test)]
mod tests {
    use egui::{Color32, ColorImage};

    use super::*;

    fn plain(size: [usize; 2], colour: Color32) -> ImageData {
        ImageData::Color(ColorImage::filled(size, colour).into())
    }

    #[test]
    fn a_part_lies_where_it_belongs_and_what_hangs_over_is_left_out() {
        let mut whole = plain([4, 3], Color32::BLACK);
        patch(&mut whole, &plain([2, 1], Color32::WHITE), [1, 1]);
        patch(&mut whole, &plain([3, 3], Color32::RED), [3, 2]);
        let ImageData::Color(whole) = whole;
        let names: String = whole
            .pixels
            .iter()
            .map(|pixel| match *pixel {
                Color32::WHITE => 'w',
                Color32::RED => 'r',
                _ => '.',
            })
            .collect();
        assert_eq!(names, ".....ww....r");
    }
}
