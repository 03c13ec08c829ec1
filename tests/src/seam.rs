//! How far two pictures differ.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::missing_panics_doc,
    reason = "a helper of tests fails by panicking"
)]

use std::path::Path;

use image::RgbImage;

/// The difference of two pictures of one size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Difference {
    /// Mean over all pixels and channels, in steps of 1/255.
    pub mean: f64,
    /// Share of pixels that differ by more than 12 steps in any channel, 0 to 1.
    pub far_off: f64,
}

/// Reads a picture.
///
/// # Panics
/// When it cannot be read.
pub fn picture(path: &Path) -> RgbImage {
    image::open(path)
        .unwrap_or_else(|e| panic!("{}: {e}", path.display()))
        .to_rgb8()
}

/// Compares two pictures.
///
/// # Panics
/// When their sizes differ.
pub fn compare(a: &RgbImage, b: &RgbImage) -> Difference {
    assert_eq!(a.dimensions(), b.dimensions());
    let (mut sum, mut far) = (0u64, 0u64);
    for (p, q) in a.pixels().zip(b.pixels()) {
        let steps: Vec<u8> = p.0.iter().zip(q.0).map(|(x, y)| x.abs_diff(y)).collect();
        sum += steps.iter().map(|s| u64::from(*s)).sum::<u64>();
        far += u64::from(steps.iter().any(|s| *s > 12));
    }
    let pixels = f64::from(a.width()) * f64::from(a.height());
    Difference {
        mean: sum as f64 / (3.0 * pixels),
        far_off: far as f64 / pixels,
    }
}

/// The block of two pictures that differs most.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Block {
    /// How far its means are apart in the channel that differs most, steps of 1/255.
    pub steps: f64,
    /// Its upper left corner, pixels.
    pub at: (u32, u32),
}

/// Sides of a block, pixels: what adapters round differently is single pixels of edges and stars, and fades in the mean.
const BLOCK: u32 = 16;

/// Compares the means of blocks of two pictures; what is left over at the right and below forms smaller blocks.
///
/// # Panics
/// When their sizes differ.
pub fn worst_block(a: &RgbImage, b: &RgbImage) -> Block {
    assert_eq!(a.dimensions(), b.dimensions());
    let (width, height) = a.dimensions();
    let corners = (0..height)
        .step_by(BLOCK as usize)
        .flat_map(|y| (0..width).step_by(BLOCK as usize).map(move |x| (x, y)));
    let blocks = corners.map(|(x, y)| {
        let mut sum = [0i64; 3];
        let (right, below) = ((x + BLOCK).min(width), (y + BLOCK).min(height));
        for (x, y) in (y..below).flat_map(|y| (x..right).map(move |x| (x, y))) {
            let pair = a.get_pixel(x, y).0.into_iter().zip(b.get_pixel(x, y).0);
            for (sum, (p, q)) in sum.iter_mut().zip(pair) {
                *sum += i64::from(p) - i64::from(q);
            }
        }
        let worst = sum.iter().map(|sum| sum.abs()).max().unwrap();
        let pixels = f64::from(right - x) * f64::from(below - y);
        let steps = worst as f64 / pixels;
        Block { steps, at: (x, y) }
    });
    blocks.max_by(|a, b| a.steps.total_cmp(&b.steps)).unwrap()
}

/// How far each pixel is off, eight times as bright.
pub fn difference(a: &RgbImage, b: &RgbImage) -> RgbImage {
    RgbImage::from_fn(a.width(), a.height(), |x, y| {
        let [p, q] = [a, b].map(|picture| picture.get_pixel(x, y).0);
        image::Rgb([0, 1, 2].map(|i| p[i].abs_diff(q[i]).saturating_mul(8)))
    })
}

/// How many different colours a picture holds, as a sign that it shows something.
pub fn colours(picture: &RgbImage) -> usize {
    picture
        .pixels()
        .map(|p| p.0)
        .collect::<std::collections::HashSet<_>>()
        .len()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_pictures_differ_by_nothing_and_one_pixel_counts() {
        let black = RgbImage::new(10, 10);
        let mut dotted = black.clone();
        assert_eq!(
            compare(&black, &dotted),
            Difference {
                mean: 0.0,
                far_off: 0.0
            }
        );
        dotted.put_pixel(3, 4, image::Rgb([255, 0, 0]));
        let difference = compare(&black, &dotted);
        assert!(
            (difference.mean - 0.85).abs() < 1e-12 && (difference.far_off - 0.01).abs() < 1e-12
        );
        assert_eq!(colours(&dotted), 2);
        assert_eq!(
            super::difference(&black, &dotted).get_pixel(3, 4).0,
            [255, 0, 0]
        );
    }

    #[test]
    fn the_worst_block_is_found_also_where_it_is_cut_off() {
        let black = RgbImage::new(40, 20);
        let mut dotted = black.clone();
        dotted.put_pixel(3, 4, image::Rgb([255, 0, 0]));
        dotted.put_pixel(39, 19, image::Rgb([0, 64, 0]));
        let Block { steps, at } = worst_block(&dotted, &black);
        assert_eq!((steps, at), (2.0, (32, 16)));
    }
}
