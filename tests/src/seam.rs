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
    }
}
