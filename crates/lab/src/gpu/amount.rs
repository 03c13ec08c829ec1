//! How much of everything is measured, and how long each part may take at most.
//!
//! The bounds add up to less than five minutes: three spaces of [`Amount::cost_s`], nine pictures of
//! [`Amount::spread_s`], three scripts of [`Amount::script_s`], and what making land and the rows of functions take,
//! which is some seconds. A graphics card comes to none of them; on a slow adapter they cut, and the report says what.

use crate::Effort;

/// Width and height of a picture, pixels.
pub type Size = (u32, u32);

/// What a run measures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Amount {
    /// How far land is made, in chunks of 32 m.
    pub view_distance: u32,
    /// Pictures in which frames are timed one by one.
    pub sizes: [Size; 3],
    /// Pictures of few triangles and many pixels.
    pub pixel_sizes: [Size; 4],
    /// Most views of a frame of the triangles' and the pixels' costs, a multiple of four.
    pub views: usize,
    /// Most rounds through these frames.
    pub rounds: usize,
    /// Longest that one space's costs are measured, seconds.
    pub cost_s: f64,
    /// Most frames of a space and size that are timed one by one.
    pub frames: usize,
    /// Longest that they are, seconds.
    pub spread_s: f64,
    /// Longest that one script of the image suite may take, seconds.
    pub script_s: f64,
}

/// Full HD, 1440p and 4K.
const SIZES: [Size; 3] = [(1920, 1080), (2560, 1440), (3840, 2160)];
const CARD: [Size; 4] = [(640, 360), (1280, 720), (1920, 1080), (2560, 1440)];
const SOFTWARE: [Size; 4] = [(320, 180), (640, 360), (960, 540), (1280, 720)];
const SMALL: [Size; 4] = [(160, 90), (240, 135), (320, 180), (400, 225)];
const SMALL_SIZES: [Size; 3] = [(192, 108), (256, 144), (384, 216)];

impl Amount {
    /// What a run of that effort measures on a graphics card, or on an adapter that draws in software.
    pub fn of(effort: Effort, software: bool) -> Self {
        if effort.quick {
            return Self {
                view_distance: 2,
                sizes: SMALL_SIZES,
                pixel_sizes: SMALL,
                views: 4,
                rounds: 2,
                cost_s: 4.0,
                frames: 8,
                spread_s: 2.0,
                script_s: 60.0,
            };
        }
        Self {
            view_distance: 6,
            sizes: SIZES,
            pixel_sizes: if software { SOFTWARE } else { CARD },
            views: 8,
            rounds: 40,
            cost_s: 15.0,
            frames: 600,
            spread_s: 12.0,
            script_s: 30.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_full_run_is_bounded_by_five_minutes() {
        for software in [false, true] {
            let amount = Amount::of(Effort { quick: false }, software);
            let bound_s = 3.0 * amount.cost_s + 9.0 * amount.spread_s + 3.0 * amount.script_s;
            assert!(bound_s < 270.0, "{bound_s} s");
            assert_eq!(amount.sizes, [(1920, 1080), (2560, 1440), (3840, 2160)]);
        }
    }
}
