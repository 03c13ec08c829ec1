//! What of the interface is painted otherwise than in the last frame, in tiles of the screen.

use egui::epaint::ClippedShape;
use egui::{Rect, pos2};
use egui_wgpu::ScreenDescriptor;

/// Side of a tile, pixels.
const TILE: u32 = 32;
/// How far shapes may reach past what they say they cover, for soft edges, pixels.
const SOFT: f32 = 2.0;

/// Some of the tiles of a screen.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Tiles {
    /// Width and height of the screen, pixels.
    size: (u32, u32),
    pixels_per_point: f32,
    /// Row by row.
    has: Vec<bool>,
}

impl Tiles {
    /// None of a screen's.
    pub fn none(size: (u32, u32), pixels_per_point: f32) -> Self {
        let count = size.0.div_ceil(TILE) * size.1.div_ceil(TILE);
        Self {
            size,
            pixels_per_point,
            has: vec![false; count as usize],
        }
    }

    /// Those that any of the shapes covers.
    pub fn under(size: (u32, u32), pixels_per_point: f32, shapes: &[ClippedShape]) -> Self {
        let mut tiles = Self::none(size, pixels_per_point);
        for shape in shapes {
            tiles.add(shape);
        }
        tiles
    }

    /// Those where two lists of shapes show something else.
    pub fn between(
        size: (u32, u32),
        pixels_per_point: f32,
        [old, new]: [&[ClippedShape]; 2],
    ) -> Self {
        let mut tiles = Self::none(size, pixels_per_point);
        let before = same(old.iter().zip(new));
        let (old, new) = (&old[before..], &new[before..]);
        let after = same(old.iter().rev().zip(new.iter().rev()));
        let (old, new) = (&old[..old.len() - after], &new[..new.len() - after]);
        let is_paired = old.len() == new.len();
        for (i, shape) in old.iter().chain(new).enumerate() {
            let i = i % old.len().max(1);
            if !is_paired || old[i] != new[i] {
                tiles.add(shape);
            }
        }
        tiles
    }

    /// How many they are.
    pub fn count(&self) -> usize {
        self.has.iter().filter(|has| **has).count()
    }

    /// The screen, as egui's painter wants it told.
    pub fn screen(&self) -> ScreenDescriptor {
        ScreenDescriptor {
            size_in_pixels: [self.size.0, self.size.1],
            pixels_per_point: self.pixels_per_point,
        }
    }

    /// Whether they are on a screen of that size.
    pub fn fit(&self, size: (u32, u32), pixels_per_point: f32) -> bool {
        self.size == size && self.pixels_per_point == pixels_per_point
    }

    /// Rectangles that cover them and nothing else, once: x, y, width and height in pixels.
    pub fn rectangles(&self) -> Vec<[u32; 4]> {
        let mut done: Vec<[u32; 4]> = Vec::new();
        for (row, has) in self.has.chunks(self.columns()).enumerate() {
            let mut column = 0;
            for run in has.chunk_by(|a, b| a == b) {
                let [left, right] = [column, column + run.len()].map(|at| at as u32 * TILE);
                let [top, bottom] = [row, row + 1].map(|at| at as u32 * TILE);
                column += run.len();
                if !run[0] {
                    continue;
                }
                let (width, bottom) = (right.min(self.size.0) - left, bottom.min(self.size.1));
                let over = done
                    .iter_mut()
                    .find(|[x, y, wide, high]| (*x, *wide, *y + *high) == (left, width, top));
                match over {
                    Some(over) => over[3] = bottom - over[1],
                    None => done.push([left, top, width, bottom - top]),
                }
            }
        }
        done
    }

    /// The shapes as far as they show in the tiles.
    pub fn cut(&self, shapes: &[ClippedShape]) -> Vec<ClippedShape> {
        let bounds = |shape: &ClippedShape| bounds(shape, self.pixels_per_point);
        let covered: Vec<_> = shapes.iter().map(bounds).collect();
        let mut cut = Vec::new();
        for [x, y, width, height] in self.rectangles() {
            let [x, y, width, height] =
                [x, y, width, height].map(|pixels| pixels as f32 / self.pixels_per_point);
            let part = Rect::from_min_max(pos2(x, y), pos2(x + width, y + height));
            let shown = shapes.iter().zip(&covered);
            let shown = shown.filter(|(_, covered)| covered.intersects(part));
            cut.extend(shown.map(|(shape, _)| ClippedShape {
                clip_rect: shape.clip_rect.intersect(part),
                ..shape.clone()
            }));
        }
        cut
    }

    fn columns(&self) -> usize {
        (self.size.0.div_ceil(TILE) as usize).max(1)
    }

    fn add(&mut self, shape: &ClippedShape) {
        let side = TILE as f32 / self.pixels_per_point;
        let covered = bounds(shape, self.pixels_per_point);
        let columns = self.columns();
        let rows = self.has.len() / columns;
        let from = |least: f32| (least / side).floor().max(0.0) as usize;
        let to = |greatest: f32| ((greatest / side).floor() + 1.0).max(0.0) as usize;
        let [left, top] = [covered.min.x, covered.min.y].map(from);
        let right = to(covered.max.x).min(columns);
        let bottom = to(covered.max.y).min(rows);
        for row in top..bottom {
            for column in left..right {
                self.has[row * columns + column] = true;
            }
        }
    }
}

/// How many pairs from the first on are the same.
fn same<'a>(pairs: impl Iterator<Item = (&'a ClippedShape, &'a ClippedShape)>) -> usize {
    pairs.take_while(|(a, b)| a == b).count()
}

/// What a shape covers, points.
fn bounds(shape: &ClippedShape, pixels_per_point: f32) -> Rect {
    let own = shape.transform_after_tessellation * shape.shape.visual_bounding_rect();
    own.expand(SOFT / pixels_per_point)
        .intersect(shape.clip_rect)
}

#[cfg(test)]
mod tests {
    use egui::{Color32, Shape};

    use super::*;

    const SCREEN: (u32, u32) = (200, 100);

    fn square(x: f32, y: f32, colour: Color32) -> ClippedShape {
        let rect = Rect::from_min_max(pos2(x, y), pos2(x + 4.0, y + 4.0));
        let shape = Shape::rect_filled(rect, 0.0, colour);
        ClippedShape::new(Rect::EVERYTHING, shape)
    }

    fn between(old: &[ClippedShape], new: &[ClippedShape]) -> Vec<[u32; 4]> {
        Tiles::between(SCREEN, 1.0, [old, new]).rectangles()
    }

    #[test]
    fn what_changes_moves_comes_or_goes_is_painted_anew_there_and_nowhere_else() {
        let a = square(8.0, 8.0, Color32::RED);
        let b = square(72.0, 40.0, Color32::RED);
        let c = square(196.0, 96.0, Color32::RED);
        let all = [a.clone(), b.clone(), c.clone()];
        assert_eq!(between(&all, &all), Vec::<[u32; 4]>::new());
        let blue = square(72.0, 40.0, Color32::BLUE);
        let at_b = [64, 32, 32, 32];
        assert_eq!(between(&all, &[a.clone(), blue, c.clone()]), [at_b]);
        assert_eq!(between(&all, &[a.clone(), c.clone()]), [at_b]);
        assert_eq!(between(&[a.clone(), c.clone()], &all), [at_b]);
        let moved = square(8.0, 72.0, Color32::RED);
        let both = [[64, 32, 32, 32], [0, 64, 32, 32]];
        assert_eq!(between(&all, &[a.clone(), moved, c.clone()]), both);
        // The last tiles end with the screen.
        assert_eq!(between(&all, &[a, b]), [[192, 64, 8, 36]]);
    }

    #[test]
    fn rectangles_cover_every_tile_once_and_what_is_cut_stays_in_them() {
        let shapes = [
            square(0.0, 0.0, Color32::RED),
            ClippedShape::new(
                Rect::EVERYTHING,
                Shape::rect_filled(
                    Rect::from_min_max(pos2(40.0, 8.0), pos2(90.0, 60.0)),
                    0.0,
                    Color32::RED,
                ),
            ),
        ];
        for pixels_per_point in [1.0, 2.0] {
            let tiles = Tiles::under(SCREEN, pixels_per_point, &shapes);
            let area = |[_, _, width, height]: [u32; 4]| width * height;
            let sum: u32 = tiles.rectangles().into_iter().map(area).sum();
            assert!(tiles.count() > 4 && sum <= 32 * 32 * tiles.count() as u32);
            let inside = |cut: &ClippedShape| {
                tiles.rectangles().iter().any(|rectangle| {
                    let [x, y, width, height] =
                        rectangle.map(|pixels| pixels as f32 / pixels_per_point);
                    Rect::from_min_max(pos2(x, y), pos2(x + width, y + height))
                        .contains_rect(cut.clip_rect)
                })
            };
            assert!(tiles.cut(&shapes).iter().all(inside));
        }
    }
}
