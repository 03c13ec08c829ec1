//! Rays of the key light, cast at the land's triangles in 64 bits: where light arrives and where it does not.
//!
//! Under a sky they are straight lines of the chart. In a closed world they are great circles through the light's
//! point of the three-sphere, which a central projection from there makes straight (docs/shadows.md): with X' the
//! three coordinates of X across the light and X.s the fourth, a triangle covers X if X' is a sum of its corners' with
//! no negative share, and comes first if it is the nearer, by the cotangent X.s / |X'|.
//!
//! In the hyperbolic world they run to an ideal point, a null vector n = (s, 1) of the eye's. All of a ray's points are
//! p X + t n: what is the same along it is X' = (X.a, X.b, -<n, X>), a and b across s, up to the factor p. So a triangle
//! covers X as above, at Y = X + t n, with t by the fourth coordinate, which is further on for a positive t, by
//! log(1 - 2t <n, X>) / 2 radii, as <Y, Y> = -1 + 2t <n, X>.

use antipode_frame::{Frame, View};
use antipode_geometry::{ChartPoint, Eye};
use glam::{DMat3, DVec2, DVec3, DVec4};

use super::triangles::Triangle;

/// Cells of a table's side.
const CELLS: usize = 512;
/// Faces of a table of all directions.
const FACES: usize = 6;
/// What is nearer to a point than this does not shade it, metres: rounding of places and shares.
const CLEARANCE_M: f64 = 2e-3;

/// How the light sees points.
enum Light {
    Far {
        toward: DVec3,
        across: [DVec3; 2],
    },
    Star {
        at: DVec4,
        axes: [DVec4; 3],
        radius_m: f64,
    },
    Ideal {
        toward: DVec3,
        across: [DVec3; 2],
        radius_m: f64,
    },
}

/// Triangles by the cells of the light's own view.
pub struct Rays<'a> {
    frame: &'a Frame,
    light: Light,
    /// Corners as the light sees them: across, across, height; or X' and X.s or W.
    seen: Vec<[DVec4; 3]>,
    cells: Vec<Vec<u32>>,
    low: DVec2,
    high: DVec2,
}

impl<'a> Rays<'a> {
    pub fn new(frame: &'a Frame, triangles: &[Triangle]) -> Self {
        let light = light_of(frame);
        let own = |t: &Triangle| {
            t.corners
                .map(|c| own(frame, &light, ChartPoint::new(t.chart, c)))
        };
        let seen: Vec<_> = triangles.iter().map(own).collect();
        let (mut low, mut high) = (DVec2::splat(-1.0), DVec2::splat(1.0));
        let mut faces = FACES;
        if !matches!(light, Light::Star { .. }) {
            faces = 1;
            let ends = || seen.iter().flatten().map(|c| on_plane(&light, *c));
            low = ends().fold(DVec2::INFINITY, DVec2::min) - 0.01;
            high = ends().fold(DVec2::NEG_INFINITY, DVec2::max) + 0.01;
        }
        let mut rays = Self {
            frame,
            light,
            seen: Vec::new(),
            cells: vec![Vec::new(); faces * CELLS * CELLS],
            low,
            high,
        };
        for (number, corners) in seen.iter().enumerate() {
            rays.enter(number as u32, corners, faces);
        }
        rays.seen = seen;
        rays
    }

    fn enter(&mut self, number: u32, corners: &[DVec4; 3], faces: usize) {
        for face in 0..faces {
            let Some(at) = all(corners.map(|c| self.on_face(face, c))) else {
                continue;
            };
            let cell = |p: DVec2| (p - self.low) / (self.high - self.low) * CELLS as f64;
            let [a, b, c] = at.map(cell);
            let (low, high) = (a.min(b).min(c) - 1e-6, a.max(b).max(c) + 1e-6);
            if high.min_element() < 0.0 || low.max_element() >= CELLS as f64 {
                continue;
            }
            let last = CELLS - 1;
            let [x0, y0] = [low.x, low.y].map(|v| (v.max(0.0) as usize).min(last));
            let [x1, y1] = [high.x, high.y].map(|v| (v.max(0.0) as usize).min(last));
            for y in y0..=y1 {
                for x in x0..=x1 {
                    self.cells[(face * CELLS + y) * CELLS + x].push(number);
                }
            }
        }
    }

    /// Where a point lies on the plane of a face; nothing where that is far to its side.
    fn on_face(&self, face: usize, c: DVec4) -> Option<DVec2> {
        if !matches!(self.light, Light::Star { .. }) {
            return Some(on_plane(&self.light, c));
        }
        let (axis, sign) = (face / 2, if face.is_multiple_of(2) { 1.0 } else { -1.0 });
        let depth = c[axis] * sign;
        let away = c.truncate().length();
        (depth > 0.3 * away).then(|| DVec2::new(c[(axis + 1) % 3], c[(axis + 2) % 3]) / depth)
    }

    /// The first triangle between a point and the light, and how far before the point it stands, metres.
    pub fn hit(&self, point: ChartPoint, own_triangle: u32) -> Option<(u32, f64)> {
        let at = own(self.frame, &self.light, point);
        let faces = self.cells.len() / (CELLS * CELLS);
        let face = (0..faces).max_by(|a, b| {
            let ahead = |f: usize| {
                if f.is_multiple_of(2) {
                    at[f / 2]
                } else {
                    -at[f / 2]
                }
            };
            ahead(*a).total_cmp(&ahead(*b))
        })?;
        let cell = (self.on_face(face, at)? - self.low) / (self.high - self.low) * CELLS as f64;
        let [x, y] = [cell.x, cell.y].map(|v| (v.max(0.0) as usize).min(CELLS - 1));
        let candidates = &self.cells[(face * CELLS + y) * CELLS + x];
        let ahead_m = |number: &u32| {
            let ahead_m = self.ahead_m(&self.seen[*number as usize], at)?;
            (*number != own_triangle && ahead_m > CLEARANCE_M).then_some((*number, ahead_m))
        };
        candidates
            .iter()
            .filter_map(ahead_m)
            .min_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// How far before a point a triangle stands that covers it, metres; negative behind it.
    fn ahead_m(&self, [a, b, c]: &[DVec4; 3], at: DVec4) -> Option<f64> {
        let slack = -1e-9;
        match &self.light {
            Light::Far { .. } => {
                let flat = |v: &DVec4| DVec2::new(v.x - at.x, v.y - at.y);
                let [p, q, r] = [a, b, c].map(flat);
                let area = (q - p).perp_dot(r - p);
                if area.abs() < 1e-12 {
                    return None;
                }
                let shares = [q.perp_dot(r), r.perp_dot(p), p.perp_dot(q)].map(|s| s / area);
                if shares.iter().any(|s| *s < slack) {
                    return None;
                }
                Some(a.z * shares[0] + b.z * shares[1] + c.z * shares[2] - at.z)
            }
            Light::Star { radius_m, .. } | Light::Ideal { radius_m, .. } => {
                let matrix = DMat3::from_cols(a.truncate(), b.truncate(), c.truncate());
                if matrix.determinant().abs() < 1e-18 {
                    return None;
                }
                let shares = matrix.inverse() * at.truncate();
                if shares.min_element() < slack {
                    return None;
                }
                let first = shares.dot(DVec3::new(a.w, b.w, c.w));
                if matches!(self.light, Light::Ideal { .. }) {
                    return Some(0.5 * radius_m * (2.0 * (first - at.w) * at.z).ln_1p());
                }
                // Both lie on one great circle: X' of the point and first, as far from the light as these say.
                let away = at.truncate().length();
                let angle = |fourth: f64| away.atan2(fourth);
                Some((angle(at.w) - angle(first)) * radius_m)
            }
        }
    }

    /// Whether a triangle turns its front to the light.
    pub fn is_faced(&self, triangle: u32) -> bool {
        let [a, b, c] = self.seen[triangle as usize];
        match self.light {
            Light::Far { .. } => {
                let [p, q, r] = [a, b, c].map(|v| DVec2::new(v.x, v.y));
                (q - p).perp_dot(r - p) > 0.0
            }
            Light::Star { .. } | Light::Ideal { .. } => {
                let columns = [a, b, c].map(DVec4::truncate);
                let volume =
                    DMat3::from_cols_array_2d(&columns.map(|c| c.to_array())).determinant();
                // The third is along the way from the star, and of an ideal light across it.
                matches!(self.light, Light::Ideal { .. }) == (volume > 0.0)
            }
        }
    }
}

/// Where a point lies across a light that all rays run up to: in the half space over a plane, for an ideal one.
fn on_plane(light: &Light, c: DVec4) -> DVec2 {
    let at = DVec2::new(c.x, c.y);
    if matches!(light, Light::Ideal { .. }) {
        at / c.z
    } else {
        at
    }
}

fn all(at: [Option<DVec2>; 3]) -> Option<[DVec2; 3]> {
    let [a, b, c] = at;
    Some([a?, b?, c?])
}

/// What the key light comes from, as the renderer takes it.
fn light_of(frame: &Frame) -> Light {
    let Some(orbs) = frame.content.sky.orbs else {
        let toward = DVec3::from(frame.content.sky.key_direction.map(f64::from)).normalize();
        let across = |toward: DVec3| {
            let right = toward.any_orthonormal_vector();
            [right, toward.cross(right)]
        };
        let View { strategy, eye, .. } = &frame.view;
        if strategy.tiled().is_none() {
            return Light::Far {
                toward,
                across: across(toward),
            };
        }
        let axes = DVec3::AXES.map(|axis| axis * strategy.in_sky_axes(eye.point, axis).dot(toward));
        let toward = eye.to_view(axes.into_iter().sum());
        return Light::Ideal {
            toward,
            across: across(toward),
            radius_m: strategy.radius_m(),
        };
    };
    let is_sun = frame.content.sky.key_direction == frame.content.sky.sun_direction;
    let body = if is_sun { orbs.sun } else { orbs.moon };
    let at = frame.view.strategy.curved(&Eye::default(), body);
    let DVec4 { x, y, z, w } = at;
    Light::Star {
        at,
        axes: [
            DVec4::new(w, -z, y, -x),
            DVec4::new(z, w, -x, -y),
            DVec4::new(-y, x, w, -z),
        ],
        radius_m: frame.view.strategy.radius_m(),
    }
}

fn own(frame: &Frame, light: &Light, point: ChartPoint) -> DVec4 {
    match light {
        Light::Far { toward, across } => {
            let p = point.pos;
            DVec4::new(p.dot(across[0]), p.dot(across[1]), p.dot(*toward), 1.0)
        }
        Light::Ideal {
            toward,
            across: [right, up],
            radius_m,
        } => {
            let view = frame.view.strategy.view_point(&frame.view.eye, point);
            let x = view.truncate() / *radius_m;
            DVec4::new(x.dot(*right), x.dot(*up), view.w - x.dot(*toward), view.w)
        }
        Light::Star { at, axes, .. } => {
            let x = frame.view.strategy.curved(&Eye::default(), point);
            let [a, b, c] = axes.map(|axis| axis.dot(x));
            DVec4::new(a, b, c, x.dot(*at))
        }
    }
}
