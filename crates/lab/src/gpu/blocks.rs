//! How far two pictures of the image suite are apart: by the means of blocks, so that what adapters round differently,
//! single pixels of edges and stars, fades.

use image::RgbImage;

/// The block of two pictures that differs most.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Block {
    /// How far its means are apart in the channel that differs most, steps of 1/255.
    pub steps: f64,
    /// Its upper left corner, pixels.
    pub at: (u32, u32),
}

/// Sides of a block, pixels.
const BLOCK: u32 = 16;

/// Compares the means of blocks of two pictures; what is left over at the right and below forms smaller blocks. Nothing
/// where their sizes differ, or they have no pixels.
pub fn worst_block(a: &RgbImage, b: &RgbImage) -> Option<Block> {
    if a.dimensions() != b.dimensions() {
        return None;
    }
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
        let worst = sum.iter().fold(0, |most, sum| most.max(sum.abs()));
        let pixels = f64::from(right - x) * f64::from(below - y);
        let steps = worst as f64 / pixels;
        Block { steps, at: (x, y) }
    });
    blocks.max_by(|a, b| a.steps.total_cmp(&b.steps))
}

/// How far each pixel is off, eight times as bright; the pictures are of one size.
pub fn difference(a: &RgbImage, b: &RgbImage) -> RgbImage {
    let (width, height) = (a.width().min(b.width()), a.height().min(b.height()));
    RgbImage::from_fn(width, height, |x, y| {
        let [p, q] = [a, b].map(|picture| picture.get_pixel(x, y).0);
        image::Rgb([0, 1, 2].map(|i| p[i].abs_diff(q[i]).saturating_mul(8)))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_worst_block_is_found_also_where_it_is_cut_off() {
        let black = RgbImage::new(40, 20);
        let mut dotted = black.clone();
        dotted.put_pixel(3, 4, image::Rgb([255, 0, 0]));
        dotted.put_pixel(39, 19, image::Rgb([0, 64, 0]));
        let worst = worst_block(&dotted, &black);
        let (steps, at) = (2.0, (32, 16));
        assert_eq!(worst, Some(Block { steps, at }));
        assert_eq!(difference(&black, &dotted).get_pixel(3, 4).0, [255, 0, 0]);
    }

    #[test]
    fn pictures_of_different_sizes_are_not_compared() {
        assert_eq!(
            worst_block(&RgbImage::new(40, 20), &RgbImage::new(20, 40)),
            None
        );
    }
}
