//! Pictures of rooms: rays into the light of a picture, the tone map of worlds after it, and the writing on signs.

use std::borrow::Cow;
use std::ops::Range;
use std::time::Instant;

use antipode_deformation::{Place, Space};
use antipode_language::Texts;
use antipode_rays::{Loaded, Outline, Picture, RayScene, Rays, Shader};
use antipode_render::{Gpu, Offscreen, Options, Shaders, Tonemap};
use antipode_room_scene::{Moment, RoomScene, SignBoard};
use image::RgbaImage;

use crate::failure::Failure;
use crate::room_figures::{FigureModels, RoomFigures};
use crate::room_texts::RoomTexts;

mod signs;

use signs::Signs;

/// Least share of their strength that edges have in coarse pictures.
const FAINTEST: f32 = 0.25;

/// What draws rooms; it may be asked from any thread.
#[derive(Debug)]
pub struct RoomPainter {
    rays: Rays,
    tonemap: Tonemap,
    signs: Signs,
    figures: FigureModels,
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
        self.scene.outline = Outline::default();
        self.figures.show(gpu, &mut self.loaded, moment)
    }

    /// A view of a room as it is now, in what was drawn of it before it was changed.
    pub fn placed_anew(&self, view: &RoomView) -> RoomView {
        RoomView {
            moment: placed_anew(&self.scene.aberrations, &view.moment),
            ..view.clone()
        }
    }

    /// The next picture has so small a share of the pixels that are shown, along each side.
    pub fn is_drawn_at(&mut self, share: f32) {
        self.scene.outline.strength = strength_at(share);
    }
}

/// A moment in another space than its own: the eye and the lamps are where they are in the scene, in the boxes that are there.
fn placed_anew(space: &Space, moment: &Moment) -> Moment {
    let anew = |place: &Place| Place {
        scale: place.scale,
        turn: place.turn,
        ..Place::at(space, place.point)
    };
    let mut moment = moment.clone();
    moment.eye.place = anew(&moment.eye.place);
    for lamp in &mut moment.lamps {
        lamp.place = anew(&lamp.place);
    }
    moment
}

/// How opaque edges are that are a pixel wide where only a share of the pixels is made: as much less as they are thicker, but
/// seen.
fn strength_at(share: f32) -> f32 {
    Outline::default().strength * share.clamp(FAINTEST, 1.0)
}

impl RoomPainter {
    /// Compiles what pictures are drawn with, for targets of the format that the options name, and reads the models of figures.
    ///
    /// # Errors
    /// When the adapter cannot trace rays or refuses a shader, or a model cannot be read.
    pub fn new(gpu: &Gpu, options: &Options) -> Result<Self, Failure> {
        // While something moves there are as few pixels as can be traced in time.
        let is_scaled = true;
        let format = options.output_format;
        Ok(Self {
            rays: Rays::new(&gpu.device)?,
            tonemap: Tonemap::accepted(&gpu.device, Shaders::default(), format, is_scaled)?,
            signs: Signs::default(),
            figures: FigureModels::read()?,
        })
    }

    /// A shader that has to be compiled before this view can be drawn; none where it can.
    pub fn missing(&self, drawable: &Drawable, view: &RoomView) -> Option<Shader> {
        let what = (&drawable.scene, &drawable.loaded);
        let wanted = (self.rays).shaders(what, &view.moment.eye, as_compiled(view));
        wanted.into_iter().find(|it| !self.rays.is_compiled(*it))
    }

    /// What is not compiled of all that other views of it may be drawn with.
    pub fn uncompiled(&self, drawable: &Drawable) -> Vec<Shader> {
        let mut all = self.rays.all_shaders(&drawable.loaded);
        all.retain(|it| !self.rays.is_compiled(*it));
        all
    }

    /// Compiles a shader, which takes up to seconds.
    ///
    /// # Errors
    /// When the adapter refuses it.
    pub fn compile(&self, gpu: &Gpu, shader: Shader) -> Result<(), Failure> {
        let begun = Instant::now();
        self.rays.compile(&gpu.device, shader)?;
        let took_ms = begun.elapsed().as_millis();
        tracing::debug!("compiled {shader:?} in {took_ms} ms");
        Ok(())
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
        let words = RoomTexts::of(texts);
        let mut writing = self.signs.begin();
        let mut scene = room.ray_scene(|board| {
            let said = SignBoard {
                text: words.say(&board.text).to_owned(),
                ..board.clone()
            };
            writing.write(gpu, said)
        })?;
        drop(writing);
        let figures = RoomFigures::add_to(&mut scene, &self.figures);
        let loaded = self.rays.upload(&gpu.device, &gpu.queue, &scene)?;
        let mut drawable = Drawable {
            scene,
            loaded,
            figures,
        };
        // Who walks is bent here, where nobody waits for it.
        drawable.set(gpu, &room.now())?;
        Ok(drawable)
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
            as_compiled(view),
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

/// How a view is drawn with what is compiled, rather than wait for what would be a little sooner.
fn as_compiled(view: &RoomView) -> antipode_rays::Options {
    antipode_rays::Options {
        as_compiled: true,
        ..view.options
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

impl RoomView {
    /// In a window of that size, which may have become smaller since it was laid out.
    pub fn within(&self, window: (u32, u32)) -> Cow<'_, Self> {
        let tile = self.tile.and_then(|tile| tile.within(window));
        if tile == self.tile {
            return Cow::Borrowed(self);
        }
        Cow::Owned(Self {
            tile,
            ..self.clone()
        })
    }
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
        if let Some((_, drawable)) = &self.drawable {
            while let Some(shader) = self.painter.missing(drawable, view) {
                self.painter.compile(gpu, shader)?;
            }
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

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

    use antipode_rooms::files::ROOM_FILE;
    use antipode_rooms::{Assets, read};
    use antipode_workshop::Document;

    use super::*;

    /// Until the picture of a changed room is made it is drawn as it was, with eye and lamps in boxes that it had then.
    #[test]
    fn in_the_room_as_it_was_nobody_is_in_a_box_that_has_been_put_there_since() {
        let text = r##"(version: 1, name: "Hall", objects: [
            (name: "hall", at: (0, 2, 0), what: Aberration(half: (4, 4, 4), stretch: (2, 2, 2), sides: Soft)),
            (name: "lamp", at: (1, 3, 0), what: Light(colour: "#ffffff", power: 1)),
        ])"##;
        let room = read(ROOM_FILE, text.as_bytes()).unwrap();
        let scene = RoomScene::of(Document::new(room), Assets::default());
        let moment = scene.now();
        let places = |of: &Moment| [of.eye.place, of.lamps[0].place];
        assert!(places(&moment).iter().all(|it| !it.stack.is_empty()));
        let before = placed_anew(&Space::default(), &moment);
        assert!(places(&before).iter().all(|it| it.stack.is_empty()));
        let back = placed_anew(scene.space(), &before);
        assert_eq!(places(&back), places(&moment));
    }

    #[test]
    fn a_picture_that_was_laid_out_in_a_larger_window_is_cut_to_the_smaller() {
        let tile = |corner, size| Tile { corner, size };
        let within = |it: Tile| it.within((800, 600));
        let part = tile((270, 62), (500, 510));
        assert_eq!(within(part), Some(part));
        let wide = tile((270, 62), (685, 610));
        assert_eq!(within(wide), Some(tile((270, 62), (530, 538))));
        assert_eq!(within(tile((800, 62), (10, 10))), None);
    }

    #[test]
    fn edges_of_coarse_pictures_are_as_much_fainter_as_they_are_thicker_and_are_seen() {
        let whole = strength_at(1.0);
        assert_eq!(whole, Outline::default().strength);
        assert!((strength_at(0.5) - 0.5 * whole).abs() < 1e-6);
        assert!(strength_at(0.05) > 0.2 * whole);
    }
}
