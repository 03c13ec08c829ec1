//! Pictures of rooms: rays into the light of a picture, the tone map of worlds after it, and the writing on signs.

use std::ops::Range;

use antipode_language::Texts;
use antipode_rays::{Loaded, Picture, RayScene, Rays};
use antipode_render::{Gpu, Offscreen, Options, Shaders, Tonemap};
use antipode_room_scene::{Moment, RoomScene, SignBoard};
use antipode_rooms::Colour;
use egui::{Align2, Color32, FontId, LayerId, Pos2, Rect, Vec2};
use image::RgbaImage;

use crate::failure::Failure;
use crate::overlay::Overlay;
use crate::room_figures::RoomFigures;
use crate::room_texts::RoomTexts;

/// The format of the writing on signs.
const SIGN_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;
/// Pixels across the writing of a sign.
const SIGN_PX: u32 = 1024;

/// How much wider the strokes of the writing on signs are, as a share of its size.
const BOLDER: f32 = 0.03;

/// What draws rooms; it may be asked from any thread.
#[derive(Debug)]
pub struct RoomPainter {
    rays: Rays,
    tonemap: Tonemap,
}

/// What pictures of a room are drawn of.
#[derive(Debug)]
pub struct Drawable {
    scene: RayScene,
    loaded: Loaded,
    figures: RoomFigures,
}

impl Drawable {
    /// The pictures that follow are of this moment.
    ///
    /// # Errors
    /// As [`RoomFigures::show`].
    pub fn set(&mut self, gpu: &Gpu, moment: &Moment) -> Result<(), Failure> {
        self.scene.lamps.clone_from(&moment.lamps);
        self.figures.show(gpu, &mut self.loaded, moment)
    }
}

impl RoomPainter {
    /// Compiles what pictures are drawn with, for targets of the format that the options name.
    ///
    /// # Errors
    /// When the adapter cannot trace rays or refuses a shader.
    pub fn new(gpu: &Gpu, options: &Options) -> Result<Self, Failure> {
        // While something moves there are as few pixels as can be traced in time.
        let is_scaled = true;
        let format = options.output_format;
        Ok(Self {
            rays: Rays::new(&gpu.device)?,
            tonemap: Tonemap::accepted(&gpu.device, Shaders::default(), format, is_scaled)?,
        })
    }

    /// Makes what a room is drawn of, and waits for the writing on its signs, which is in the language of `texts`.
    ///
    /// # Errors
    /// When the room is too large for the adapter, or that fails.
    pub fn drawable(
        &self,
        gpu: &Gpu,
        room: &RoomScene,
        texts: &Texts,
    ) -> Result<Drawable, Failure> {
        let mut overlay = Overlay::new(gpu, SIGN_FORMAT);
        let words = RoomTexts::of(texts);
        let mut scene = room.ray_scene(|board| {
            let said = SignBoard {
                text: words.say(&board.text).to_owned(),
                ..board.clone()
            };
            write_sign(gpu, &mut overlay, &said)
        })?;
        let figures = RoomFigures::add_to(&mut scene)?;
        let loaded = self.rays.upload(&gpu.device, &gpu.queue, &scene)?;
        self.rays.prepare(&gpu.device, &loaded);
        Ok(Drawable {
            scene,
            loaded,
            figures,
        })
    }

    /// Records some rows of a picture.
    pub fn trace(
        &self,
        gpu: &Gpu,
        encoder: &mut wgpu::CommandEncoder,
        (drawable, picture): (&Drawable, &Picture),
        view: &RoomView,
        rows: Range<u32>,
    ) {
        self.rays.draw_rows(
            (&gpu.device, &gpu.queue),
            encoder,
            (&drawable.scene, &drawable.loaded),
            (&view.moment.eye, picture),
            view.options,
            rows,
        );
    }

    /// Shows a picture in a target of any size, or in a tile of it.
    pub fn show(
        &self,
        gpu: &Gpu,
        encoder: &mut wgpu::CommandEncoder,
        picture: &Picture,
        (target, tile): (&wgpu::TextureView, Option<Tile>),
    ) {
        let light = self.tonemap.bind(&gpu.device, &picture.light);
        match tile {
            Some(tile) => self.tonemap.draw_in(encoder, &light, target, &tile),
            None => self.tonemap.draw(encoder, &light, target, None),
        }
    }
}

/// What a picture of a room is of.
#[derive(Clone, Debug, PartialEq)]
pub struct RoomView {
    /// Tells the room, as it is now, from others.
    pub id: (u64, u64),
    /// The moment.
    pub moment: Moment,
    /// How it is made.
    pub options: antipode_rays::Options,
    /// The part of the window that it is in, if that is not all of it.
    pub tile: Option<Tile>,
}

/// A part of the window, pixels.
pub type Tile = antipode_render::MirrorPlace;

/// Pictures of rooms in memory, one after another.
#[derive(Debug)]
pub struct RoomPictures {
    painter: RoomPainter,
    picture: Picture,
    /// What was drawn last, with what tells it from others.
    drawable: Option<((u64, u64), Drawable)>,
}

impl RoomPictures {
    /// For pictures of this size.
    ///
    /// # Errors
    /// As [`RoomPainter::new`].
    pub fn new(gpu: &Gpu, options: &Options, size: (u32, u32)) -> Result<Self, Failure> {
        Ok(Self {
            painter: RoomPainter::new(gpu, options)?,
            picture: Picture::new(&gpu.device, size),
            drawable: None,
        })
    }

    /// Draws a room as the view says, with signs in the language of `texts`, and waits for it.
    ///
    /// # Errors
    /// When the room is too large for the adapter, or that fails.
    pub fn shoot(
        &mut self,
        gpu: &Gpu,
        target: &Offscreen,
        (room, texts): (&RoomScene, &Texts),
        view: &RoomView,
    ) -> Result<RgbaImage, Failure> {
        if self.drawable.as_ref().is_none_or(|(id, _)| *id != view.id) {
            self.drawable = Some((view.id, self.painter.drawable(gpu, room, texts)?));
        }
        let mut encoder = gpu.encoder();
        if let Some((_, drawable)) = &mut self.drawable {
            drawable.set(gpu, &view.moment)?;
            let rows = 0..self.picture.size.1;
            self.painter
                .trace(gpu, &mut encoder, (drawable, &self.picture), view, rows);
            self.painter
                .show(gpu, &mut encoder, &self.picture, (target.view(), None));
        }
        gpu.queue.submit([encoder.finish()]);
        Ok(target.read(gpu)?)
    }
}

/// The picture of what stands on a board.
fn write_sign(gpu: &Gpu, overlay: &mut Overlay, board: &SignBoard) -> Result<RgbaImage, Failure> {
    let height = (f64::from(SIGN_PX) / board.aspect).clamp(64.0, 2048.0) as u32;
    let size = (SIGN_PX, height);
    let target = Offscreen::new(gpu, size.0, size.1, SIGN_FORMAT);
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
        let mut points = rect.height();
        let words = loop {
            let font = FontId::proportional(points);
            let words = painter.layout(board.text.clone(), font, ink, inner.x);
            if (words.size().y <= inner.y && words.size().x <= inner.x) || points < 8.0 {
                break words;
            }
            points *= 0.92;
        };
        let place = Align2::CENTER_CENTER.anchor_size(rect.center(), words.size());
        // Strokes of a book's weight are too thin to be read from far.
        let bolder = BOLDER * points;
        for (right, down) in [(0.0, 0.0), (bolder, 0.0), (0.0, bolder), (bolder, bolder)] {
            painter.galley(place.min + Vec2::new(right, down), words.clone(), ink);
        }
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
