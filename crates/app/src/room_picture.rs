//! Pictures of rooms: rays into the light of a picture, the tone map of worlds after it, and the writing on signs.

use antipode_rays::{Loaded, Picture, RayScene, Rays};
use antipode_render::{Gpu, Offscreen, Options, Shaders, Tonemap};
use antipode_room_scene::{RoomScene, SignBoard};
use antipode_rooms::Colour;
use egui::{Align2, Color32, FontId, LayerId, Pos2, Rect, Vec2};
use image::RgbaImage;

use crate::failure::Failure;
use crate::overlay::Overlay;
use crate::room_figures::RoomFigures;

/// Pixels across the writing of a sign.
const SIGN_PX: u32 = 1024;

/// What draws rooms.
#[derive(Debug)]
pub struct RoomPictures {
    rays: Rays,
    tonemap: Tonemap,
    picture: Picture,
    /// What was drawn last, with what tells it from others.
    loaded: Option<Drawn>,
}

#[derive(Debug)]
struct Drawn {
    look: (u64, u64),
    scene: RayScene,
    loaded: Loaded,
    figures: RoomFigures,
}

impl RoomPictures {
    /// For pictures of this size.
    ///
    /// # Errors
    /// When the adapter cannot trace rays or refuses a shader.
    pub fn new(gpu: &Gpu, options: &Options, size: (u32, u32)) -> Result<Self, Failure> {
        Ok(Self {
            rays: Rays::new(&gpu.device)?,
            tonemap: Tonemap::accepted(&gpu.device, Shaders::default(), options)?,
            picture: Picture::new(&gpu.device, size),
            loaded: None,
        })
    }

    /// Draws a room as who walks in it sees it, and waits for it. `look` tells what the room looks like from what others do.
    ///
    /// # Errors
    /// When the room is too large for the adapter, or that fails.
    pub fn shoot(
        &mut self,
        gpu: &Gpu,
        overlay: &mut Overlay,
        target: &Offscreen,
        (room, look): (&RoomScene, (u64, u64)),
        options: &antipode_rays::Options,
    ) -> Result<RgbaImage, Failure> {
        if self.loaded.as_ref().is_none_or(|it| it.look != look) {
            let mut scene = room.ray_scene(|board| write_sign(gpu, overlay, board))?;
            let figures = RoomFigures::add_to(&mut scene)?;
            let loaded = self.rays.upload(&gpu.device, &gpu.queue, &scene)?;
            self.loaded = Some(Drawn {
                look,
                scene,
                loaded,
                figures,
            });
        }
        let mut encoder = gpu.encoder();
        if let Some(drawn) = &mut self.loaded {
            let Drawn {
                scene,
                loaded,
                figures,
                ..
            } = drawn;
            scene.lamps = room.lamps_between(1.0);
            figures.show(gpu, loaded, (room, 1.0))?;
            self.rays.draw(
                (&gpu.device, &gpu.queue),
                &mut encoder,
                (scene, loaded),
                (&room.eye(), &self.picture),
                *options,
            );
        }
        let light = self.tonemap.bind(&gpu.device, &self.picture.light);
        self.tonemap.draw(&mut encoder, &light, target.view(), None);
        gpu.queue.submit([encoder.finish()]);
        Ok(target.read(gpu)?)
    }
}

/// The picture of what stands on a board.
fn write_sign(gpu: &Gpu, overlay: &mut Overlay, board: &SignBoard) -> Result<RgbaImage, Failure> {
    let height = (f64::from(SIGN_PX) / board.aspect).clamp(64.0, 2048.0) as u32;
    let size = (SIGN_PX, height);
    let target = Offscreen::new(gpu, size.0, size.1, wgpu::TextureFormat::Rgba8Unorm);
    let output = written(overlay.context(), board, size);
    let mut encoder = gpu.encoder();
    overlay.paint(gpu, &mut encoder, &[target.view()], size, output);
    gpu.queue.submit([encoder.finish()]);
    Ok(target.read(gpu)?)
}

/// The words as large as they fit, in the middle of the board.
fn written(context: &egui::Context, board: &SignBoard, size: (u32, u32)) -> egui::FullOutput {
    let rect = Rect::from_min_size(Pos2::ZERO, Vec2::new(size.0 as f32, size.1 as f32));
    let mut input = egui::RawInput {
        screen_rect: Some(rect),
        ..Default::default()
    };
    if let Some(viewport) = input.viewports.get_mut(&egui::ViewportId::ROOT) {
        viewport.native_pixels_per_point = Some(1.0);
    }
    context.run_pass(input, |context| {
        let painter = context.layer_painter(LayerId::background());
        let (paper, ink) = colours(board.colour);
        painter.rect_filled(rect, 0.0, paper);
        let inner = rect.shrink(0.07 * rect.height()).size();
        let mut points = 0.5 * rect.height();
        let words = loop {
            let font = FontId::proportional(points);
            let words = painter.layout(board.text.clone(), font, ink, inner.x);
            if (words.size().y <= inner.y && words.size().x <= inner.x) || points < 8.0 {
                break words;
            }
            points *= 0.92;
        };
        let place = Align2::CENTER_CENTER.anchor_size(rect.center(), words.size());
        painter.galley(place.min, words, ink);
    })
}

/// Of the board, and of what is written on it so that it can be read.
fn colours(board: Colour) -> (Color32, Color32) {
    let [red, green, blue] = board.0;
    let brightness = 0.3 * f32::from(red) + 0.6 * f32::from(green) + 0.1 * f32::from(blue);
    let ink = if brightness > 110.0 {
        Color32::from_gray(24)
    } else {
        Color32::from_gray(240)
    };
    (Color32::from_rgb(red, green, blue), ink)
}
