//! Pictures that are kept: read back from the adapter while the game goes on.

use antipode_render::{Offscreen, RenderError, Tile};
use antipode_scene::frame::Frame;
use image::RgbaImage;

use super::{Stage, is_plain};

/// Size of the menu's pictures in pixels.
pub(super) const THUMBNAIL: (u32, u32) = (320, 180);

impl Stage {
    /// The menu's picture taken last, once, as soon as the adapter has finished it. Never waits.
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

    /// Whether a picture for the menu is under way.
    pub fn makes_thumbnail(&self) -> bool {
        self.thumbnail.is_some()
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
        let mut encoder = self.gpu.encoder();
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

    /// Whether what is shown can be read back: the window's format has four channels of 8 bits. Wide ones are what
    /// is left where a surface has no other, on no system known.
    pub fn can_keep(&self) -> bool {
        is_plain(self.config.format) || self.config.format.is_srgb()
    }

    pub(super) fn offscreen(&self, size: (u32, u32)) -> Offscreen {
        let (width, height) = size;
        Offscreen::new(&self.gpu, width, height, self.config.format)
    }

    /// Whether a picture is on its way out of the adapter's memory; it is taken over when a frame is drawn.
    pub fn reads_pictures(&self) -> bool {
        self.thumbnail.is_some() || self.tile.is_some() || !self.screenshots.is_empty()
    }
}

fn picture_or_note(read: Result<RgbaImage, RenderError>) -> Option<RgbaImage> {
    read.inspect_err(|error| tracing::info!("no picture for the menu: {error}"))
        .ok()
}
