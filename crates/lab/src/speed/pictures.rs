//! Two pictures of the same land beside each other: how many pixels differ, and whether those lie at an edge.

use std::sync::Arc;

use antipode_scene::frame::Frame;

use crate::LabError;
use crate::speed::stage::Stage;

/// Differences of a channel up to this many steps of 255 are not seen.
const UNSEEN: u8 = 8;

/// What differs between two pictures.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Difference {
    /// Pixels of land: those that the land changed from the empty picture in either.
    pub land: usize,
    /// Pixels of land that differ visibly.
    pub differing: usize,
    /// Those of them that are farther than a pixel from every edge of the exact picture.
    pub off_edge: usize,
}

/// A picture as rows of pixels.
#[derive(Clone, Debug)]
pub struct Picture {
    /// Pixels a row.
    pub width: usize,
    /// Red, green, blue and opacity.
    pub pixels: Vec<[u8; 4]>,
}

fn apart(a: [u8; 4], b: [u8; 4]) -> bool {
    a.iter().zip(b).any(|(a, b)| a.abs_diff(b) > UNSEEN)
}

impl Picture {
    /// The picture last drawn on a stage, `width` pixels wide.
    ///
    /// # Errors
    /// When the adapter fails.
    pub fn last(stage: &Stage<'_>, width: u32) -> Result<Self, LabError> {
        Ok(Self {
            width: width as usize,
            pixels: stage.picture()?,
        })
    }

    /// The frame's picture without its land, as another world has it before its first mesh.
    ///
    /// # Errors
    /// When the adapter fails.
    pub fn without_land(
        stage: &mut Stage<'_>,
        frame: &Frame,
        width: u32,
    ) -> Result<Self, LabError> {
        let empty = frame.clone().with_content(|it| {
            it.loaded_world = 0;
            it.land = Arc::default();
        });
        stage.draw(&empty)?;
        Self::last(stage, width)
    }

    /// The pixels within a pixel of the one at `index`, itself included.
    fn around(&self, index: usize) -> impl Iterator<Item = usize> + '_ {
        let (x, y) = (index % self.width, index / self.width);
        let height = self.pixels.len() / self.width;
        let rows = y.saturating_sub(1)..(y + 2).min(height);
        rows.flat_map(move |row| {
            (x.saturating_sub(1)..(x + 2).min(self.width))
                .map(move |column| row * self.width + column)
        })
    }

    /// Whether anything visible changes within a pixel.
    fn varies(&self, index: usize) -> bool {
        let mut least = [u8::MAX; 4];
        let mut most = [0; 4];
        for near in self.around(index) {
            for channel in 0..4 {
                least[channel] = least[channel].min(self.pixels[near][channel]);
                most[channel] = most[channel].max(self.pixels[near][channel]);
            }
        }
        apart(least, most)
    }

    /// Whether a pixel at an edge lies within a pixel.
    fn at_edge(&self, index: usize) -> bool {
        self.around(index).any(|near| self.varies(near))
    }

    /// How `other` differs from this picture, the exact one; `empty` is what is seen where there is no land.
    pub fn difference(&self, other: &Self, empty: &Self) -> Difference {
        let mut found = Difference::default();
        for (index, exact) in self.pixels.iter().enumerate() {
            let (got, sky) = (other.pixels[index], empty.pixels[index]);
            if *exact == sky && got == sky {
                continue;
            }
            found.land += 1;
            if apart(*exact, got) {
                found.differing += 1;
                found.off_edge += usize::from(!self.at_edge(index));
            }
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SKY: [u8; 4] = [90, 120, 200, 255];
    const LAND: [u8; 4] = [60, 110, 40, 255];

    /// Sky over land, eight rows of nine pixels, the land from row `top` on.
    fn picture(top: usize) -> Picture {
        let pixels = (0..72)
            .map(|i| if i / 9 < top { SKY } else { LAND })
            .collect();
        Picture { width: 9, pixels }
    }

    #[test]
    fn a_shifted_skyline_differs_at_its_edge_only() {
        let (exact, empty) = (picture(4), picture(8));
        assert_eq!(
            exact.difference(&exact, &empty),
            Difference {
                land: 36,
                differing: 0,
                off_edge: 0
            }
        );
        let by_one = exact.difference(&picture(3), &empty);
        assert_eq!(
            by_one,
            Difference {
                land: 45,
                differing: 9,
                off_edge: 0
            }
        );
        // The edge is between rows 3 and 4; rows 2 to 5 are within a pixel of it, row 1 is not.
        let by_three = exact.difference(&picture(1), &empty);
        assert_eq!(
            by_three,
            Difference {
                land: 63,
                differing: 27,
                off_edge: 9
            }
        );
    }

    #[test]
    fn what_nobody_sees_is_no_difference_and_a_spot_off_the_edges_is_one() {
        let (exact, empty) = (picture(4), picture(8));
        let mut other = exact.clone();
        other.pixels[70] = LAND.map(|c| c.saturating_add(8));
        assert_eq!(exact.difference(&other, &empty).differing, 0);
        other.pixels[70] = [LAND[0] + 9, LAND[1], LAND[2], 255];
        let found = exact.difference(&other, &empty);
        assert_eq!((found.differing, found.off_edge), (1, 1));
    }
}
