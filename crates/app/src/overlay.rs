//! The interface painted over a picture: egui's shapes into the same texture, for window and script alike. What stays as it
//! was in the last frame is kept: painted anew, the display would take a fifth of a frame in software.

mod change;
mod sheet;

use std::collections::HashMap;

use antipode_render::Gpu;
use change::Tiles;
use egui::epaint::{ClippedShape, ImageDelta};
use egui::{ImageData, TextureId, TexturesDelta};
use egui_wgpu::RendererOptions;
use sheet::{Layer, Sheet};

/// Paints egui's output into texture views of one format.
pub struct Overlay {
    context: egui::Context,
    renderer: egui_wgpu::Renderer,
    /// What every texture holds, to be sent again when the adapter is another.
    textures: HashMap<TextureId, ImageDelta>,
    layer: Layer,
    last: Last,
}

/// What was painted last.
#[derive(Debug, Default)]
struct Last {
    shapes: Vec<ClippedShape>,
    /// Where they are.
    covered: Option<Tiles>,
    /// They themselves, once that was worth while.
    sheet: Option<Sheet>,
    /// Whether something else was painted since.
    is_stale: bool,
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
            layer: Layer::new(&gpu.device, format),
            last: Last::default(),
        }
    }

    /// Paints with another adapter from now on; the last one may be lost.
    pub fn move_to(&mut self, gpu: &Gpu, format: wgpu::TextureFormat) {
        let options = RendererOptions::default();
        self.renderer = egui_wgpu::Renderer::new(&gpu.device, format, options);
        self.layer = Layer::new(&gpu.device, format);
        self.last = Last::default();
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
        let pixels_per_point = output.pixels_per_point;
        for (id, deltas) in &output.textures_delta.set {
            for delta in deltas {
                self.renderer
                    .update_texture(&gpu.device, &gpu.queue, *id, delta);
            }
        }
        self.skip(&output.textures_delta);
        let shapes = output.shapes;
        let covered = Tiles::under(size, pixels_per_point, &shapes);
        let changed = Tiles::between(size, pixels_per_point, [&self.last.shapes, &shapes]);
        let fits = self.last.covered.take();
        let fits = fits.is_some_and(|last| last.fit(size, pixels_per_point));
        if !fits {
            self.last.sheet = None;
        }
        let is_same = fits && output.textures_delta.set.is_empty();
        // Where most is new, it would only be painted twice.
        if is_same && 3 * changed.count() < 2 * covered.count() {
            let sheet = self.last.sheet.take();
            // Cut into rectangles, what lies in many is sent as often: of all of it, it is sent whole.
            let (tiles, shown) = if self.last.is_stale || sheet.is_none() {
                (&covered, shapes.clone())
            } else {
                (&changed, changed.cut(&shapes))
            };
            let sheet = sheet.unwrap_or_else(|| self.layer.sheet(&gpu.device, size));
            self.renew(gpu, encoder, &sheet, tiles, shown);
            for target in targets {
                self.layer
                    .lay(&mut begin(encoder, target), &sheet, &covered);
            }
            self.last.sheet = Some(sheet);
            self.last.is_stale = false;
        } else {
            let jobs = self.upload(gpu, encoder, &covered, shapes.clone());
            for target in targets {
                self.render(begin(encoder, target), &jobs, &covered);
            }
            self.last.is_stale = true;
        }
        for id in &output.textures_delta.free {
            self.renderer.free_texture(id);
        }
        self.last.shapes = shapes;
        self.last.covered = Some(covered);
    }

    /// Paints some tiles of a sheet anew.
    fn renew(
        &mut self,
        gpu: &Gpu,
        encoder: &mut wgpu::CommandEncoder,
        sheet: &Sheet,
        tiles: &Tiles,
        shapes: Vec<ClippedShape>,
    ) {
        if tiles.count() == 0 {
            return;
        }
        let jobs = self.upload(gpu, encoder, tiles, shapes);
        let mut pass = begin(encoder, &sheet.view);
        self.layer.empty(&mut pass, tiles);
        self.render(pass, &jobs, tiles);
    }

    /// Sends shapes to the adapter, as triangles.
    fn upload(
        &mut self,
        gpu: &Gpu,
        encoder: &mut wgpu::CommandEncoder,
        tiles: &Tiles,
        shapes: Vec<ClippedShape>,
    ) -> Vec<egui::ClippedPrimitive> {
        let screen = tiles.screen();
        let jobs = self.context.tessellate(shapes, screen.pixels_per_point);
        let (device, queue) = (&gpu.device, &gpu.queue);
        let uploads = self
            .renderer
            .update_buffers(device, queue, encoder, &jobs, &screen);
        gpu.queue.submit(uploads);
        jobs
    }

    /// Draws what was sent last.
    fn render(&self, pass: wgpu::RenderPass<'_>, jobs: &[egui::ClippedPrimitive], tiles: &Tiles) {
        self.renderer
            .render(&mut pass.forget_lifetime(), jobs, &tiles.screen());
    }
}

fn begin<'e>(
    encoder: &'e mut wgpu::CommandEncoder,
    target: &wgpu::TextureView,
) -> wgpu::RenderPass<'e> {
    encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
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
    })
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
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use antipode_render::{AdapterChoice, Offscreen};
    use egui::{Color32, ColorImage, LayerId, Rect, pos2, vec2};
    use image::RgbaImage;

    use super::*;

    const SIZE: (u32, u32) = (300, 200);
    const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

    /// Plates that stay and one that moves, which half covers one of the others, over grey.
    fn painted(gpu: &Gpu, overlay: &mut Overlay, moved: f32) -> RgbaImage {
        let screen = Rect::from_min_size(pos2(0.0, 0.0), vec2(300.0, 200.0));
        let input = egui::RawInput {
            screen_rect: Some(screen),
            ..Default::default()
        };
        let output = overlay.context().run_pass(input, |context| {
            let painter = context.layer_painter(LayerId::background());
            let plate = |x, y, colour| {
                let rect = Rect::from_min_size(pos2(x, y), vec2(40.5, 30.0));
                painter.rect_filled(rect, 6.0, colour);
            };
            for step in 0..6u8 {
                plate(
                    10.0 + 48.0 * f32::from(step),
                    20.0,
                    Color32::from_black_alpha(120),
                );
            }
            plate(
                20.0 + moved,
                40.0,
                Color32::from_rgba_unmultiplied(255, 80, 0, 150),
            );
            plate(30.0, 150.0, Color32::WHITE);
        });
        let target = Offscreen::new(gpu, SIZE.0, SIZE.1, FORMAT);
        let mut encoder = gpu.encoder();
        let grey = wgpu::Color {
            r: 0.5,
            g: 0.5,
            b: 0.5,
            a: 1.0,
        };
        encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: target.view(),
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(grey),
                    store: wgpu::StoreOp::Store,
                },
            })],
            ..Default::default()
        });
        overlay.paint(gpu, &mut encoder, &[target.view()], SIZE, output);
        gpu.queue.submit([encoder.finish()]);
        target.read(gpu).unwrap()
    }

    #[test]
    fn what_is_kept_of_the_interface_looks_as_if_it_were_painted_anew() {
        let Ok(gpu) = Gpu::headless(AdapterChoice::Auto) else {
            return;
        };
        let mut overlay = Overlay::new(&gpu, FORMAT);
        for (frame, moved) in [0.0, 0.0, 0.0, 3.0, 30.5, 30.5, 200.0]
            .into_iter()
            .enumerate()
        {
            let kept = painted(&gpu, &mut overlay, moved);
            let anew = painted(&gpu, &mut Overlay::new(&gpu, FORMAT), moved);
            let off = kept
                .iter()
                .zip(anew.iter())
                .map(|(a, b)| a.abs_diff(*b))
                .max();
            assert!(off <= Some(3), "{off:?} in frame {frame}");
            assert_eq!(overlay.last.is_stale, frame == 0, "{frame}");
        }
    }

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
