//! Openings of doors: where in a picture they are, and their draws.
//!
//! What is seen through one is a view of its own, drawn before into targets as large as the picture's; the opening shows that
//! pixel by pixel. Its surface lies a little behind the leaf, the more so the nearer the eye is, with walls from the leaf to
//! there: the near plane of an eye that goes through cuts none of it.

use antipode_frame::{Frame, Opening};
use antipode_geometry::Leaf;
use antipode_geometry::doorway::{HALF_WIDTH_M, HEIGHT_M};
use glam::DVec3;
use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{BindGroup, Buffer, BufferUsages, Device, Queue, RenderPass};

use crate::charts::{Charts, offset_of};
use crate::draw_list::DrawCount;
use crate::pipelines::Pipelines;

/// Squares along each side of an opening: where space is curved its edges bow.
const SQUARES: u16 = Opening::SILLS as u16 - 1;
/// How far behind the leaf the surface lies when the eye is in it, and when it is farther off than that, metres. From there it lies
/// before the leaf, and so hides what rounding leaves of who stands behind that.
const DEEPEST_M: f64 = 0.15;
const LEAST_DEEP_M: f64 = -0.002;
/// Openings in a picture.
const MOST: usize = 2;
/// Corners of one: those of the surface, and a rim of them on the leaf.
const CORNERS: usize = (SQUARES as usize + 1).pow(2) + 4 * SQUARES as usize;
/// What is drawn of another side is wider than its opening by so many pixels.
const MARGIN_PX: f64 = 2.0;

/// What an opening shows.
#[derive(Clone, Copy, Debug)]
pub struct Beyond<'a> {
    /// The light of the other side.
    pub light: &'a BindGroup,
    /// Whether it was drawn; else the opening shows haze.
    pub is_drawn: bool,
}

/// The openings of one view.
#[derive(Debug)]
pub struct OpeningDraws {
    vertices: Buffer,
    indices: Buffer,
    index_count: u32,
    /// The numbers of their charts.
    charts: Vec<u32>,
}

impl OpeningDraws {
    /// None yet.
    pub fn new(device: &Device) -> Self {
        let indices = indices();
        Self {
            vertices: device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("openings"),
                size: (MOST * CORNERS * size_of::<[f32; 3]>()) as u64,
                usage: BufferUsages::VERTEX | BufferUsages::COPY_DST,
                mapped_at_creation: false,
            }),
            index_count: indices.len() as u32,
            indices: device.create_buffer_init(&BufferInitDescriptor {
                label: Some("opening indices"),
                contents: bytemuck::cast_slice(&indices),
                usage: BufferUsages::INDEX,
            }),
            charts: Vec::new(),
        }
    }

    /// Takes a frame's openings.
    pub fn prepare(&mut self, queue: &Queue, frame: &Frame, charts: &mut Charts) {
        self.charts.clear();
        let mut all: Vec<[f32; 3]> = Vec::new();
        for opening in frame.openings.iter().take(MOST) {
            let leaf = &opening.leaf;
            self.charts.push(charts.number(leaf.foot.chart));
            let corner =
                |local| -> [f32; 3] { offset_of(frame, leaf.place(local)).as_vec3().into() };
            all.extend(
                corners(away_m(frame, leaf), &opening.sill_m)
                    .into_iter()
                    .map(corner),
            );
        }
        if !all.is_empty() {
            queue.write_buffer(&self.vertices, 0, bytemuck::cast_slice(&all));
        }
    }

    /// Draws them, each with what lies beyond it; returns what that took.
    pub fn draw(
        &self,
        pass: &mut RenderPass<'_>,
        charts: &Charts,
        pipelines: &Pipelines,
        beyond: &[Beyond<'_>],
    ) -> DrawCount {
        let mut count = DrawCount::default();
        for ((at, chart), beyond) in (0..).zip(&self.charts).zip(beyond) {
            charts.bind(pass, *chart);
            pass.set_pipeline(if beyond.is_drawn {
                &pipelines.opening
            } else {
                &pipelines.opening_haze
            });
            pass.set_bind_group(2, beyond.light, &[]);
            pass.set_vertex_buffer(0, self.vertices.slice(..));
            pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint16);
            pass.draw_indexed(0..self.index_count, at * CORNERS as i32, 0..1);
            count.draws += 1;
            count.triangles += self.index_count as usize / 3;
        }
        count
    }
}

/// How far the eye is through a leaf, along the way that its front looks, metres of the chart; far where it is in no chart
/// that reaches the leaf.
fn away_m(frame: &Frame, leaf: &Leaf) -> f64 {
    let view = &frame.view;
    let there = view.strategy.carry_near(view.eye.point, leaf.foot);
    there.map_or(f64::INFINITY, |it| leaf.local(it.point.pos).x)
}

/// The corners of an opening in the leaf's own axes, for an eye so far through it and a sill so high: its surface row by row, then
/// the rim.
fn corners(away_m: f64, sill_m: &[f64; Opening::SILLS]) -> Vec<DVec3> {
    let deep_m = (DEEPEST_M - away_m.abs()).clamp(LEAST_DEEP_M, DEEPEST_M);
    let behind_m = if away_m < 0.0 { deep_m } else { -deep_m };
    let share = |at: u16| f64::from(at) / f64::from(SQUARES);
    let at = |x: f64, row: u16, column: u16| {
        let low_m = sill_m[usize::from(column)];
        let y = low_m + share(row) * (HEIGHT_M - low_m);
        DVec3::new(x, y, (2.0 * share(column) - 1.0) * HALF_WIDTH_M)
    };
    let rows = (0..=SQUARES).flat_map(|row| (0..=SQUARES).map(move |column| (row, column)));
    let surface = rows.map(|(row, column)| at(behind_m, row, column));
    let rim = rim().map(|(row, column)| at(0.0, row, column));
    surface.chain(rim).collect()
}

/// The corners about the surface, in their order.
fn rim() -> impl Iterator<Item = (u16, u16)> {
    let side = 0..SQUARES;
    let low = side.clone().map(|at| (0, at));
    let right = side.clone().map(|at| (at, SQUARES));
    let high = side.clone().map(|at| (SQUARES, SQUARES - at));
    let left = side.map(|at| (SQUARES - at, 0));
    low.chain(right).chain(high).chain(left)
}

fn indices() -> Vec<u16> {
    let wide = SQUARES + 1;
    let number = |(row, column): (u16, u16)| row * wide + column;
    let mut all = Vec::new();
    let mut square = |[a, b, c, d]: [u16; 4]| all.extend([a, b, c, a, c, d]);
    for row in 0..SQUARES {
        for column in 0..SQUARES {
            let low = number((row, column));
            square([low, low + 1, low + wide + 1, low + wide]);
        }
    }
    let about: Vec<_> = rim().map(number).collect();
    let first = wide * wide;
    let count = about.len() as u16;
    for (at, behind) in (0..count).zip(&about) {
        let next = (at + 1) % count;
        square([*behind, about[usize::from(next)], first + next, first + at]);
    }
    all
}

/// The part of a picture `size` pixels large that an opening takes, from its upper left corner: x, y, width and height. None
/// where it is out of the picture, or the fog hides it.
pub fn place_of(frame: &Frame, opening: &Opening, size: (u32, u32)) -> Option<[u32; 4]> {
    let view = &frame.view;
    let (strategy, eye) = (&*view.strategy, &view.eye);
    let middle = view.point(opening.leaf.place(DVec3::Y));
    if strategy.eye_distance_m(eye, middle) > f64::from(view.fog_distance_m) {
        return None;
    }
    let all = corners(away_m(frame, &opening.leaf), &opening.sill_m).into_iter();
    let clips: Vec<_> = all
        .map(|local| {
            let seen = view.point(opening.leaf.place(local));
            strategy.clip_from_view(eye, &view.projection, seen)
        })
        .collect();
    let before = clips.iter().filter(|clip| clip.w > 1e-3).count();
    if before == 0 {
        return None;
    }
    let (width, height) = (f64::from(size.0), f64::from(size.1));
    if before < clips.len() {
        return Some([0, 0, size.0, size.1]);
    }
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for clip in clips {
        let at = [
            (0.5 + 0.5 * clip.x / clip.w) * width,
            (0.5 - 0.5 * clip.y / clip.w) * height,
        ];
        for axis in 0..2 {
            low[axis] = low[axis].min(at[axis]);
            high[axis] = high[axis].max(at[axis]);
        }
    }
    let [left, top] = [0, 1].map(|axis| (low[axis] - MARGIN_PX).floor().max(0.0));
    let right = (high[0] + MARGIN_PX).ceil().min(width);
    let bottom = (high[1] + MARGIN_PX).ceil().min(height);
    let is_in = right > left && bottom > top;
    is_in.then(|| [left, top, right - left, bottom - top].map(|side| side as u32))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_opening_is_a_closed_box_behind_the_leaf_but_for_its_front() {
        for (away_m, deep_m) in [(-4.0, LEAST_DEEP_M), (-0.01, 0.14), (0.05, -0.1)] {
            let all = corners(away_m, &[-1.1; Opening::SILLS]);
            assert_eq!(all.len(), CORNERS);
            let (surface, rim) = all.split_at((usize::from(SQUARES) + 1).pow(2));
            assert!(surface.iter().all(|it| (it.x - deep_m).abs() < 1e-12));
            assert!(rim.iter().all(|it| it.x == 0.0));
            // Each edge is shared by two triangles, but for those of the front.
            let mut edges = std::collections::BTreeMap::new();
            for three in indices().chunks_exact(3) {
                for (a, b) in [(0, 1), (1, 2), (2, 0)] {
                    let (a, b) = (three[a].min(three[b]), three[a].max(three[b]));
                    *edges.entry((a, b)).or_insert(0) += 1;
                }
            }
            let first = surface.len() as u16;
            for ((a, b), count) in edges {
                let is_front = a >= first && b >= first;
                assert_eq!(count, if is_front { 1 } else { 2 }, "{a} {b}");
            }
        }
    }
}
