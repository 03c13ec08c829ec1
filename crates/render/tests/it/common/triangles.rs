//! The triangles that a picture of the land shows, in the chart, and which of them each pixel shows: by the formulas of
//! the geometry crate in 64 bits, without the adapter.

use antipode_frame::{Frame, Land};
use antipode_geometry::{ChartId, ChartPoint, ChunkCoord};
use antipode_terrain::Level;
use glam::{DVec2, DVec3, DVec4, IVec3};
use std::collections::BTreeMap;

/// Places this far past the equator are left to the other chart, metres.
const PAST_RIM_M: f64 = 0.05;
/// An edge that strays more than this from its true picture is cut, pixels.
const STRAY_PX: f64 = 0.2;
const MOST_CUTS: usize = 6;
/// A seam is drawn beside a finer neighbour across this face.
const FACES: [IVec3; 6] = [
    IVec3::NEG_X,
    IVec3::X,
    IVec3::NEG_Y,
    IVec3::Y,
    IVec3::NEG_Z,
    IVec3::Z,
];

/// A triangle of the land, counter-clockwise seen from the air.
#[derive(Clone, Copy, Debug)]
pub struct Triangle {
    pub chart: ChartId,
    pub corners: [DVec3; 3],
    /// Unit normals of the vertices.
    pub normals: [DVec3; 3],
    pub is_seam: bool,
}

impl Triangle {
    pub fn face_normal(&self) -> DVec3 {
        let [a, b, c] = self.corners;
        (b - a).cross(c - a).normalize_or(DVec3::Y)
    }

    pub fn at(&self, weights: DVec3) -> DVec3 {
        let [a, b, c] = self.corners;
        a * weights.x + b * weights.y + c * weights.z
    }

    pub fn normal_at(&self, weights: DVec3) -> DVec3 {
        let [a, b, c] = self.normals;
        (a * weights.x + b * weights.y + c * weights.z).normalize_or(DVec3::Y)
    }
}

/// The triangles of all land.
pub fn triangles(land: &Land) -> Vec<Triangle> {
    let meshes: BTreeMap<_, _> = land.meshes().collect();
    let mut found = Vec::new();
    for (coord, mesh) in &meshes {
        let mut add = |indices: &[u32], is_seam| {
            for corners in indices.as_chunks::<3>().0 {
                let vertices = corners.map(|i| mesh.vertices[i as usize]);
                found.push(Triangle {
                    chart: coord.chart,
                    corners: vertices.map(|v| coord.origin() + v.position().as_dvec3()),
                    normals: vertices.map(|v| v.normal().as_dvec3()),
                    is_seam,
                });
            }
        };
        add(mesh.surface_indices(), false);
        for (face, step) in FACES.into_iter().enumerate() {
            let beside = ChunkCoord {
                index: coord.index + step,
                ..*coord
            };
            let is_finer = |level: Level| level < mesh.level;
            if meshes.get(&beside).is_some_and(|m| is_finer(m.level)) {
                add(mesh.seam_indices(face), true);
            }
        }
    }
    found
}

/// What a pixel shows.
#[derive(Clone, Copy, Debug)]
pub struct Seen {
    /// Which triangle, by its place in the list.
    pub triangle: u32,
    /// Shares of its corners in the place that is seen.
    pub weights: DVec3,
    depth: f64,
}

impl Seen {
    /// As the picture's depth: linear over a plane.
    pub fn depth(&self) -> f64 {
        self.depth
    }
}

/// Which triangle each pixel of a picture shows; none where that is the sky.
pub struct Surface {
    pub size: (u32, u32),
    pub pixels: Vec<Option<Seen>>,
}

#[derive(Clone, Copy)]
struct Corner {
    clip: DVec4,
    chart: DVec3,
    weights: DVec3,
}

impl Surface {
    /// Looks at triangles as a frame does.
    pub fn of(frame: &Frame, triangles: &[Triangle], size: (u32, u32)) -> Self {
        let mut surface = Self {
            size,
            pixels: vec![None; (size.0 * size.1) as usize],
        };
        let viewer = frame.view.strategy.viewer(&frame.view.eye);
        for (number, triangle) in triangles.iter().enumerate() {
            let clip = |chart| {
                let view = viewer(ChartPoint::new(triangle.chart, chart));
                frame
                    .view
                    .strategy
                    .clip_from_view(&frame.view.eye, &frame.view.projection, view)
            };
            let unit = [DVec3::X, DVec3::Y, DVec3::Z];
            let corner = |i: usize| Corner {
                clip: clip(triangle.corners[i]),
                chart: triangle.corners[i],
                weights: unit[i],
            };
            surface.cut(
                frame,
                number as u32,
                [corner(0), corner(1), corner(2)],
                &clip,
                0,
            );
        }
        surface
    }

    pub fn get(&self, x: u32, y: u32) -> Option<&Seen> {
        self.pixels[(y * self.size.0 + x) as usize].as_ref()
    }

    fn on_screen(&self, clip: DVec4) -> DVec2 {
        let at = DVec2::new(clip.x, -clip.y) / clip.w;
        (at * 0.5 + 0.5) * DVec2::new(f64::from(self.size.0), f64::from(self.size.1))
    }

    fn cut(
        &mut self,
        frame: &Frame,
        number: u32,
        corners: [Corner; 3],
        clip: &dyn Fn(DVec3) -> DVec4,
        cuts: usize,
    ) {
        let near = frame.view.projection.near_m * 0.5;
        let ahead = corners.map(|c| c.clip.w > near);
        if !ahead.contains(&true) {
            return;
        }
        let is_whole = !ahead.contains(&false);
        if is_whole {
            // Far outside on one side.
            let outside =
                |f: &dyn Fn(DVec4) -> f64| corners.iter().all(|c| f(c.clip) > 1.1 * c.clip.w);
            if outside(&|c| c.x) || outside(&|c| -c.x) || outside(&|c| c.y) || outside(&|c| -c.y) {
                return;
            }
        }
        let between = |a: &Corner, b: &Corner| {
            let chart = a.chart.midpoint(b.chart);
            Corner {
                clip: clip(chart),
                chart,
                weights: a.weights.midpoint(b.weights),
            }
        };
        let [a, b, c] = corners;
        let middles = [between(&a, &b), between(&b, &c), between(&c, &a)];
        let strays = |m: &Corner, a: &Corner, b: &Corner| {
            let straight = (a.clip + b.clip) * 0.5;
            m.clip.w <= near || self.on_screen(m.clip).distance(self.on_screen(straight)) > STRAY_PX
        };
        let [ab, bc, ca] = middles;
        let needs = !is_whole || strays(&ab, &a, &b) || strays(&bc, &b, &c) || strays(&ca, &c, &a);
        if needs && cuts < MOST_CUTS {
            for part in [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]] {
                self.cut(frame, number, part, clip, cuts + 1);
            }
        } else if is_whole {
            self.draw(frame, number, &corners);
        }
    }

    fn draw(&mut self, frame: &Frame, number: u32, corners: &[Corner; 3]) {
        let at = corners.map(|c| self.on_screen(c.clip));
        let area = (at[1] - at[0]).perp_dot(at[2] - at[0]);
        // Down the picture is positive: what is seen from the front runs with the clock.
        if area >= 0.0 {
            return;
        }
        let low = at[0].min(at[1]).min(at[2]).max(DVec2::ZERO);
        let high = at[0].max(at[1]).max(at[2]);
        let (width, height) = self.size;
        let ends = [high.x.min(f64::from(width)), high.y.min(f64::from(height))];
        for y in low.y as u32..ends[1].ceil().max(0.0) as u32 {
            for x in low.x as u32..ends[0].ceil().max(0.0) as u32 {
                let p = DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
                let share = |i: usize, j: usize| (at[i] - p).perp_dot(at[j] - p) / area;
                let flat = DVec3::new(share(1, 2), share(2, 0), share(0, 1));
                if flat.min_element() < 0.0 {
                    continue;
                }
                let depths = corners.map(|c| c.clip.z / c.clip.w);
                let depth = flat.dot(DVec3::from(depths));
                let slot = &mut self.pixels[(y * width + x) as usize];
                if slot.is_some_and(|seen| seen.depth >= depth) {
                    continue;
                }
                let parts = flat / DVec3::from(corners.map(|c| c.clip.w));
                let parts = parts / parts.element_sum();
                let chart = corners[0].chart * parts.x
                    + corners[1].chart * parts.y
                    + corners[2].chart * parts.z;
                let rim_m = frame.view.strategy.domain(ChartId::FIRST).radius_m();
                if rim_m.is_some_and(|rim_m| chart.x.hypot(chart.z) > rim_m + PAST_RIM_M) {
                    continue;
                }
                let weights = corners[0].weights * parts.x
                    + corners[1].weights * parts.y
                    + corners[2].weights * parts.z;
                *slot = Some(Seen {
                    triangle: number,
                    weights,
                    depth,
                });
            }
        }
    }
}
