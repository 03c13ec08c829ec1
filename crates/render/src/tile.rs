//! Pictures larger than what is drawn at once, in tiles.

use wgpu::RenderPass;

/// A part of a larger picture, as large as the targets.
///
/// The whole picture's viewport is laid so that the part falls on the targets. Everything is projected as for the
/// whole, so that tiles have the very edges of land in common and join without a seam.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tile {
    /// Size of the whole picture in pixels.
    pub whole: (u32, u32),
    /// Where the part begins in it, pixels from the upper left corner.
    pub corner: (u32, u32),
}

impl Tile {
    /// The tiles of a picture `times` as large along each side as tiles of `size` pixels, row by row.
    pub fn grid(size: (u32, u32), times: u32) -> impl Iterator<Item = Self> {
        let whole = (size.0 * times, size.1 * times);
        let corners = (0..times).flat_map(move |row| (0..times).map(move |column| (column, row)));
        corners.map(move |(column, row)| Self {
            whole,
            corner: (column * size.0, row * size.1),
        })
    }

    pub(crate) fn lay(self, pass: &mut RenderPass<'_>) {
        let [x, y, width, height] =
            [self.corner.0, self.corner.1, self.whole.0, self.whole.1].map(|pixels| pixels as f32);
        pass.set_viewport(-x, -y, width, height, 0.0, 1.0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_grid_covers_the_whole_picture_once() {
        let tiles: Vec<_> = Tile::grid((3, 2), 2).collect();
        assert!(tiles.iter().all(|tile| tile.whole == (6, 4)));
        let corners: Vec<_> = tiles.iter().map(|tile| tile.corner).collect();
        assert_eq!(corners, [(0, 0), (3, 0), (0, 2), (3, 2)]);
    }
}
