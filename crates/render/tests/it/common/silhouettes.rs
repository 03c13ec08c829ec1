//! Where a picture of the land has edges: where land that is seen ends and other land, or the sky, begins behind it.

use std::collections::HashMap;

use antipode_frame::Frame;
use antipode_geometry::{ChartId, ChartPoint};
use glam::{DVec2, DVec3, DVec4};

use super::triangles::{Surface, Triangle};

/// Parts into which the edge of a triangle is cut, as it is bent in a picture of a curved space.
const PARTS: u32 = 8;

/// The pixels next to edges.
pub struct Silhouettes {
    size: (u32, u32),
    marked: Vec<bool>,
}

/// A corner, bit for bit as its neighbours have it.
type Corner = (bool, [u64; 3]);

#[derive(Default)]
struct Sides {
    seen: u32,
    turned: u32,
    ends: [DVec3; 2],
}

impl Silhouettes {
    /// Marks what lies within `reach` pixels of an edge that no nearer land hides.
    pub fn of(frame: &Frame, triangles: &[Triangle], surface: &Surface, reach: i32) -> Self {
        let size = surface.size;
        let mut found = Self {
            size,
            marked: vec![false; (size.0 * size.1) as usize],
        };
        let viewer = frame.view.strategy.viewer(&frame.view.eye);
        let clip = |chart, at| {
            let view = viewer(ChartPoint::new(chart, at));
            frame
                .view
                .strategy
                .clip_from_view(&frame.view.eye, &frame.view.projection, view)
        };
        for ((is_b, _), sides) in by_edge(triangles, &clip, surface) {
            if sides.seen == 0 || sides.turned == 0 {
                continue;
            }
            let chart = if is_b {
                ChartId::SECOND
            } else {
                ChartId::FIRST
            };
            let [a, b] = sides.ends;
            let ends = [clip(chart, a), clip(chart, b)];
            let length = on_screen(size, ends[0]).distance(on_screen(size, ends[1]));
            let parts = PARTS.max((length.min(4096.0) * 2.0) as u32);
            for part in 0..=parts {
                let at = a.lerp(b, f64::from(part) / f64::from(parts));
                found.mark(surface, clip(chart, at), reach);
            }
        }
        found
    }

    pub fn is_near(&self, x: u32, y: u32) -> bool {
        self.marked[(y * self.size.0 + x) as usize]
    }

    fn mark(&mut self, surface: &Surface, clip: DVec4, reach: i32) {
        if clip.w <= 0.0 {
            return;
        }
        let at = on_screen(self.size, clip);
        let depth = clip.z / clip.w;
        let inside = |x: i32, y: i32| {
            (0..self.size.0 as i32).contains(&x) && (0..self.size.1 as i32).contains(&y)
        };
        let (x, y) = (at.x.floor() as i32, at.y.floor() as i32);
        let around = |reach: i32| {
            (-reach..=reach).flat_map(move |j| (-reach..=reach).map(move |i| (x + i, y + j)))
        };
        let is_shown = around(1).filter(|(x, y)| inside(*x, *y)).any(|(x, y)| {
            surface
                .get(x as u32, y as u32)
                .is_none_or(|seen| seen.depth() <= depth + 1e-9)
        });
        if !is_shown {
            return;
        }
        let near: Vec<_> = around(reach).filter(|(x, y)| inside(*x, *y)).collect();
        for (x, y) in near {
            self.marked[(y as u32 * self.size.0 + x as u32) as usize] = true;
        }
    }
}

fn on_screen(size: (u32, u32), clip: DVec4) -> DVec2 {
    let at = DVec2::new(clip.x, -clip.y) / clip.w;
    (at * 0.5 + 0.5) * DVec2::new(f64::from(size.0), f64::from(size.1))
}

/// For each edge, how many of its triangles are seen from their front and how many from behind.
fn by_edge(
    triangles: &[Triangle],
    clip: &dyn Fn(ChartId, DVec3) -> DVec4,
    surface: &Surface,
) -> HashMap<(bool, [Corner; 2]), Sides> {
    let mut edges: HashMap<_, Sides> = HashMap::new();
    // A seam is less than a pixel high, and land goes on past it.
    for triangle in triangles.iter().filter(|t| !t.is_seam) {
        let clips = triangle.corners.map(|c| clip(triangle.chart, c));
        if clips.iter().any(|c| c.w <= 0.0) {
            continue;
        }
        let [a, b, c] = clips.map(|c| on_screen(surface.size, c));
        let is_seen = (b - a).perp_dot(c - a) < 0.0;
        let is_b = triangle.chart == ChartId::SECOND;
        let keys = triangle
            .corners
            .map(|c| (is_b, c.to_array().map(f64::to_bits)));
        for (i, j) in [(0, 1), (1, 2), (2, 0)] {
            let key = if keys[i] < keys[j] {
                [keys[i], keys[j]]
            } else {
                [keys[j], keys[i]]
            };
            let sides = edges.entry((is_b, key)).or_default();
            sides.ends = [triangle.corners[i], triangle.corners[j]];
            sides.seen += u32::from(is_seen);
            sides.turned += u32::from(!is_seen);
        }
    }
    edges
}
