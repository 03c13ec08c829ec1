//! The pictures of things, painted once by the script beside them and brought here to the size in pixels at which they
//! are shown: scaled by the adapter, thin parts of so small a picture would break up.

use egui::{Color32, ColorImage, Context, Id, Painter, Rect, TextureHandle, TextureOptions, pos2};
use image::{ImageFormat, RgbaImage, imageops};

use antipode_items::Item;

/// Sizes of one picture that are kept: the hotbar's, the backpack's, and those from before the window changed.
const MOST_SIZES: usize = 4;

/// Paints what an item looks like over `rect`, which is a square in points.
pub(crate) fn paint(painter: &Painter, item: Item, rect: Rect) {
    let scale = painter.pixels_per_point();
    let side_px = (rect.width() * scale).round();
    if !(1.0..=4096.0).contains(&side_px) {
        return;
    }
    let Some(texture) = texture(painter.ctx(), item, side_px as u32) else {
        return;
    };
    // Pixel on pixel.
    let corner = pos2(
        (rect.min.x * scale).round() / scale,
        (rect.min.y * scale).round() / scale,
    );
    let side = side_px / scale;
    let rect = Rect::from_min_size(corner, egui::vec2(side, side));
    let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
    painter.image(texture.id(), rect, whole, Color32::WHITE);
}

/// The picture in so many pixels; the interface remembers it.
fn texture(ctx: &Context, item: Item, side_px: u32) -> Option<TextureHandle> {
    let id = Id::unique(("antipode-icon", item));
    let known: Vec<(u32, TextureHandle)> = ctx.data(|data| data.get_temp(id)).unwrap_or_default();
    if let Some((_, texture)) = known.iter().find(|(side, _)| *side == side_px) {
        return Some(texture.clone());
    }
    let image = sized(item.icon(), side_px)?;
    let name = format!("icon-{item:?}-{side_px}");
    let texture = ctx.load_texture(name, image, TextureOptions::LINEAR);
    let mut kept = vec![(side_px, texture.clone())];
    kept.extend(known.into_iter().take(MOST_SIZES - 1));
    ctx.data_mut(|data| data.insert_temp(id, kept));
    Some(texture)
}

/// A square picture in so many pixels. Its colours are weighed by their opacity, or what is invisible would darken the
/// edges.
fn sized(png: &[u8], side_px: u32) -> Option<ColorImage> {
    let decoded = image::load_from_memory_with_format(png, ImageFormat::Png);
    let mut picture = match decoded {
        Ok(picture) => picture.to_rgba8(),
        Err(error) => {
            // They are built in, and a test reads them all.
            tracing::error!("an icon cannot be read: {error}");
            return None;
        }
    };
    for pixel in picture.pixels_mut() {
        let [r, g, b, a] = pixel.0;
        let weighed = |c: u8| (u16::from(c) * u16::from(a) / 255) as u8;
        pixel.0 = [weighed(r), weighed(g), weighed(b), a];
    }
    let small: RgbaImage =
        imageops::resize(&picture, side_px, side_px, imageops::FilterType::Triangle);
    let size = [side_px as usize; 2];
    Some(ColorImage::from_rgba_premultiplied(size, small.as_raw()))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use super::*;

    #[test]
    fn every_thing_has_a_picture_of_its_own_at_every_size() {
        for side in [1, 12, 36, 72, 300] {
            let pictures = Item::ALL.map(|item| sized(item.icon(), side).unwrap());
            for (place, picture) in pictures.iter().enumerate() {
                assert_eq!(picture.size, [side as usize; 2]);
                let seen = picture.pixels.iter().filter(|pixel| pixel.a() > 40);
                assert!(
                    side < 12 || seen.count() > 10,
                    "{:?} is bare",
                    Item::ALL[place]
                );
                let is_same = |other: &ColorImage| other.pixels == picture.pixels;
                assert!(side < 12 || !pictures[..place].iter().any(is_same));
            }
        }
    }
}
