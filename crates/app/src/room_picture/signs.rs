//! The writing on signs, which is kept from one picture of a room to the next: to write a sign and wait for it takes longer than
//! most edits.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use antipode_render::{Gpu, Offscreen};
use antipode_room_scene::SignBoard;
use antipode_rooms::Colour;
use egui::{Align2, Color32, FontId, LayerId, Pos2, Rect, Vec2};
use image::RgbaImage;

use crate::failure::Failure;
use crate::overlay::Overlay;

/// The format of the writing on signs.
const SIGN_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;
/// Pixels across the writing of a sign.
const SIGN_PX: u32 = 1024;

/// How much wider the strokes of the writing on signs are, as a share of its size.
const BOLDER: f32 = 0.03;

type Written = Vec<(SignBoard, Arc<RgbaImage>)>;

/// What was written for the last room that was made ready to be drawn.
#[derive(Debug, Default)]
pub struct Signs {
    known: Mutex<Written>,
}

impl Signs {
    /// Begins to write the signs of a room; those of the last one are forgotten with the end of it, unless this one has them, too.
    pub fn begin(&self) -> Writing<'_> {
        let mut kept = self.known.lock().unwrap_or_else(PoisonError::into_inner);
        let known = std::mem::take(&mut *kept);
        Writing {
            kept,
            known,
            overlay: None,
        }
    }
}

/// The signs of one room on their way.
pub struct Writing<'a> {
    kept: MutexGuard<'a, Written>,
    known: Written,
    overlay: Option<Overlay>,
}

impl Writing<'_> {
    /// The picture of what stands on a board; waits for it where it is new.
    ///
    /// # Errors
    /// When the adapter fails.
    pub fn write(&mut self, gpu: &Gpu, board: SignBoard) -> Result<Arc<RgbaImage>, Failure> {
        let all = self.kept.iter().chain(&self.known);
        let known = all.into_iter().find(|(it, _)| *it == board);
        let picture = if let Some((_, picture)) = known {
            picture.clone()
        } else {
            let overlay = (self.overlay).get_or_insert_with(|| Overlay::new(gpu, SIGN_FORMAT));
            Arc::new(write_sign(gpu, overlay, &board)?)
        };
        self.kept.push((board, picture.clone()));
        Ok(picture)
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

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

    use antipode_render::AdapterChoice;

    use super::*;

    #[test]
    fn a_sign_is_written_once_as_long_as_rooms_have_it() {
        let opened = Gpu::headless(AdapterChoice::Auto).map_err(|error| error.to_string());
        let Some(gpu) = antipode_testing::needed("a graphics adapter", opened.as_ref()) else {
            return;
        };
        let board = |text: &str| SignBoard {
            text: text.to_owned(),
            colour: Colour([240, 240, 240]),
            aspect: 4.0,
        };
        let signs = Signs::default();
        let write = |texts: &[&str]| {
            let mut writing = signs.begin();
            let each = texts
                .iter()
                .map(|it| writing.write(gpu, board(it)).unwrap());
            each.collect::<Vec<_>>()
        };
        let first = write(&["here", "there"]);
        assert_ne!(first[0], first[1]);
        let again = write(&["there", "elsewhere"]);
        assert!(Arc::ptr_eq(&first[1], &again[0]));
        assert_ne!(again[1], again[0]);
        let third = write(&["here"]);
        assert_eq!(third[0], first[0]);
        assert!(
            !Arc::ptr_eq(&third[0], &first[0]),
            "what no room has is kept"
        );
    }
}
