//! A picture made of tiles is the one that is drawn at once.

use crate::common::{GEOMETRIES, PLAIN, Studio, frame, land, space, standing};
use antipode_frame::{Clip, Figure, Frame, ModelId, Posture, Quality};
use antipode_geometry::{ChartId, Eye, Geometry};
use antipode_items::Item;
use antipode_render::{Offscreen, Tile};
use image::{RgbaImage, imageops};

const SIZE: (u32, u32) = (120, 68);
const TIMES: u32 = 2;

/// A view with land, a figure and, where there is one, sky with the sun in it.
fn view(geometry: Geometry, quality: Quality) -> Frame {
    let space = space(geometry);
    let point = standing(&space, ChartId::FIRST, 5.0, 3.0);
    let empty = frame(&space, point, f64::from(SIZE.0) / f64::from(SIZE.1));
    let [x, y, z] = empty.content.sky.sun_direction;
    let eye = Eye {
        yaw: f64::from(z).atan2(f64::from(x)),
        pitch: if empty.content.sky.dome {
            0.5 * f64::from(y).asin()
        } else {
            -0.2
        },
        ..empty.view.eye
    };
    let mut feet = point;
    feet.pos += 3.0 * eye.front();
    feet.pos.y = point.pos.y - 1.7;
    let figure = Figure {
        posture: Posture::of(Clip::Walk, 0.3),
        held: Some(ModelId::Item(Item::Lamp)),
        ..Figure::standing(ModelId::Astronaut, feet, 0.5)
    };
    empty
        .with_view(|it| {
            it.eye = eye;
            it.quality = quality;
        })
        .with_content(|it| {
            it.figures = vec![figure];
            it.land = land(&space, point, 1);
        })
}

/// The picture of that frame, `TIMES` as large, by tiles of `SIZE`.
fn tiled(studio: &mut Studio, frame: &Frame) -> RgbaImage {
    let mut whole = RgbaImage::new(SIZE.0 * TIMES, SIZE.1 * TIMES);
    for tile in Tile::grid(SIZE, TIMES) {
        let offscreen = Offscreen::new(&studio.gpu, SIZE.0, SIZE.1, PLAIN);
        let mut encoder = studio.gpu.encoder();
        let renderer = studio.renderer();
        renderer.resize_full(SIZE.0, SIZE.1);
        renderer.draw_tile(frame, tile, &mut encoder, offscreen.view());
        studio.gpu.queue.submit([encoder.finish()]);
        let picture = offscreen.read(&studio.gpu).unwrap();
        assert_eq!(studio.gpu.take_error(), None);
        let (x, y) = tile.corner;
        imageops::replace(&mut whole, &picture, i64::from(x), i64::from(y));
    }
    whole
}

/// Pixels that differ by more than rounding, which is a step of the display and one of its noise.
fn apart(a: &RgbaImage, b: &RgbaImage) -> usize {
    let differs = |(p, q): (&image::Rgba<u8>, &image::Rgba<u8>)| {
        p.0.iter().zip(q.0).any(|(x, y)| x.abs_diff(y) > 2)
    };
    a.pixels()
        .zip(b.pixels())
        .filter(|pair| differs(*pair))
        .count()
}

#[test]
fn tiles_join_to_the_picture_that_is_drawn_at_once() {
    for geometry in GEOMETRIES {
        for (quality, samples, scale) in [
            (Quality::Balanced, 1, 0.5),
            (Quality::Balanced, 4, 1.0),
            (Quality::Exact, 1, 1.0),
        ] {
            let Some(mut studio) = Studio::with(SIZE, PLAIN, scale, samples) else {
                return;
            };
            let frame = view(geometry, quality);
            let joined = tiled(&mut studio, &frame);
            let large = (SIZE.0 * TIMES, SIZE.1 * TIMES);
            let mut whole = Studio::with(large, PLAIN, 1.0, samples).unwrap();
            let at_once = whole.picture(&frame);
            let all = (large.0 * large.1) as usize;
            let apart = apart(&joined, &at_once);
            // An edge may fall on the other side of a pixel's middle by the last bit of a coordinate.
            assert!(
                apart * 1000 <= all,
                "{geometry} {quality} {samples}: {apart} of {all} pixels differ"
            );
        }
    }
}

#[test]
fn after_tiles_the_window_is_drawn_as_before() {
    let Some(mut studio) = Studio::with(SIZE, PLAIN, 0.5, 1) else {
        return;
    };
    let frame = view(Geometry::Hyperbolic, Quality::Balanced);
    let before = studio.picture(&frame);
    tiled(&mut studio, &frame);
    studio.renderer().resize(SIZE.0, SIZE.1);
    assert_eq!(apart(&studio.picture(&frame), &before), 0);
}

#[test]
fn the_last_frame_can_be_shown_again_in_another_target() {
    let Some(mut studio) = Studio::with(SIZE, PLAIN, 0.5, 1) else {
        return;
    };
    let shown = studio.picture(&view(Geometry::Euclidean, Quality::Balanced));
    let copy = Offscreen::new(&studio.gpu, SIZE.0, SIZE.1, PLAIN);
    let mut encoder = studio.gpu.encoder();
    studio.renderer().show_again(&mut encoder, copy.view());
    studio.gpu.queue.submit([encoder.finish()]);
    assert_eq!(copy.read(&studio.gpu).unwrap(), shown);
}
