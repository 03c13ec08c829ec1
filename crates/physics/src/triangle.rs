//! Exact distances between one triangle, a point, and an upright segment or ball, in `f64`.
//!
//! The closest point of a triangle follows Ericson, Real-Time Collision Detection, 5.1.5. The
//! capsule of a character never tilts, so its axis is a vertical segment and most cases shrink to
//! the plane.

use glam::{DVec2, DVec3, Vec3Swizzles as _};

/// Edges whose run is shorter than this (m) count as upright.
const LEAST_RUN_M: f64 = 1e-9;

/// A triangle with its unit normal on the air side and its box.
#[derive(Clone, Debug)]
pub(crate) struct Triangle {
    corners: [DVec3; 3],
    pub normal: DVec3,
    pub min: DVec3,
    pub max: DVec3,
}

/// The nearest points of an upright segment and a triangle.
pub(crate) struct Nearest {
    pub on_axis: DVec3,
    pub on_triangle: DVec3,
    /// The segment goes through the triangle.
    pub pierced: bool,
}

/// Where a ball that comes straight down first touches a triangle.
pub(crate) struct Touch {
    /// Height of the ball's centre.
    pub centre_y: f64,
    /// Height of the point of contact.
    pub contact_y: f64,
}

impl Triangle {
    /// `None` when the corners lie on a line.
    pub fn new(corners: [DVec3; 3]) -> Option<Self> {
        let [a, b, c] = corners;
        let normal = (b - a).cross(c - a).try_normalize()?;
        Some(Self {
            corners,
            normal,
            min: a.min(b).min(c),
            max: a.max(b).max(c),
        })
    }

    fn edges(&self) -> [(DVec3, DVec3); 3] {
        let [a, b, c] = self.corners;
        [(a, b), (b, c), (c, a)]
    }

    /// The point of the triangle nearest to `p`.
    pub fn closest_point(&self, p: DVec3) -> DVec3 {
        let [a, b, c] = self.corners;
        let (ab, ac, ap) = (b - a, c - a, p - a);
        let (d1, d2) = (ab.dot(ap), ac.dot(ap));
        if d1 <= 0.0 && d2 <= 0.0 {
            return a;
        }
        let bp = p - b;
        let (d3, d4) = (ab.dot(bp), ac.dot(bp));
        if d3 >= 0.0 && d4 <= d3 {
            return b;
        }
        let vc = d1 * d4 - d3 * d2;
        if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
            return a + ab * (d1 / (d1 - d3));
        }
        let cp = p - c;
        let (d5, d6) = (ab.dot(cp), ac.dot(cp));
        if d6 >= 0.0 && d5 <= d6 {
            return c;
        }
        let vb = d5 * d2 - d1 * d6;
        if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
            return a + ac * (d2 / (d2 - d6));
        }
        let va = d3 * d6 - d5 * d4;
        if va <= 0.0 && d4 >= d3 && d5 >= d6 {
            return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
        }
        let scale = 1.0 / (va + vb + vc);
        a + ab * (vb * scale) + ac * (vc * scale)
    }

    /// Height of the plane above `at` (x, z) when that lies within the triangle seen from above.
    fn height_at(&self, at: DVec2) -> Option<f64> {
        if self.normal.y.abs() < LEAST_RUN_M {
            return None;
        }
        let turn = self.normal.y.signum();
        // Seen from above with z down the page, counter-clockwise corners have a negative cross.
        let within = self
            .edges()
            .iter()
            .all(|(p, q)| (q.xz() - p.xz()).perp_dot(at - p.xz()) * turn <= 0.0);
        let [a, ..] = self.corners;
        let slide = at - a.xz();
        within.then(|| a.y - (self.normal.x * slide.x + self.normal.z * slide.y) / self.normal.y)
    }

    /// The nearest points of the triangle and the upright segment from `foot` to `top`.
    ///
    /// They are an end of the segment with the whole triangle, or an edge of the triangle at its
    /// own height: a segment that does not go through the triangle is nearest to its inside only
    /// at an end.
    pub fn nearest_to_upright(&self, foot: DVec3, top: DVec3) -> Nearest {
        let at = foot.xz();
        if let Some(y) = self.height_at(at)
            && y > foot.y
            && y < top.y
        {
            let through = DVec3::new(at.x, y, at.y);
            return Nearest {
                on_axis: through,
                on_triangle: through,
                pierced: true,
            };
        }
        let mut best = (foot, self.closest_point(foot));
        let mut best_d2 = best.0.distance_squared(best.1);
        let mut offer = |on_axis: DVec3, on_triangle: DVec3| {
            let d2 = on_axis.distance_squared(on_triangle);
            if d2 < best_d2 {
                (best, best_d2) = ((on_axis, on_triangle), d2);
            }
        };
        offer(top, self.closest_point(top));
        for (p, q) in self.edges() {
            let run = (q - p).xz();
            let run2 = run.length_squared();
            let t = if run2 > LEAST_RUN_M * LEAST_RUN_M {
                ((at - p.xz()).dot(run) / run2).clamp(0.0, 1.0)
            } else {
                0.0
            };
            let on_edge = p + (q - p) * t;
            if on_edge.y > foot.y && on_edge.y < top.y {
                offer(DVec3::new(at.x, on_edge.y, at.y), on_edge);
            } else if run2 <= LEAST_RUN_M * LEAST_RUN_M
                && p.y.min(q.y) < foot.y
                && p.y.max(q.y) > top.y
            {
                offer(foot, DVec3::new(p.x, foot.y, p.z));
            }
        }
        Nearest {
            on_axis: best.0,
            on_triangle: best.1,
            pierced: false,
        }
    }

    /// Where a ball of `radius` that falls straight down over `at` (x, z) touches this triangle
    /// from its upper side; `None` for one that it misses or that faces down.
    pub fn catch_ball(&self, at: DVec2, radius: f64) -> Option<Touch> {
        if self.normal.y < LEAST_RUN_M {
            return None;
        }
        let on_face = at - self.normal.xz() * radius;
        if let Some(contact_y) = self.height_at(on_face) {
            return Some(Touch {
                centre_y: contact_y + self.normal.y * radius,
                contact_y,
            });
        }
        let mut highest: Option<Touch> = None;
        let mut offer = |touch: Option<Touch>| {
            if let Some(touch) = touch
                && highest
                    .as_ref()
                    .is_none_or(|best| touch.centre_y > best.centre_y)
            {
                highest = Some(touch);
            }
        };
        for (p, q) in self.edges() {
            offer(catch_on_edge(p, q, at, radius));
            let rise2 = radius * radius - at.distance_squared(p.xz());
            offer((rise2 >= 0.0).then(|| Touch {
                centre_y: p.y + rise2.sqrt(),
                contact_y: p.y,
            }));
        }
        highest
    }
}

/// The ball's centre w = w0 + y e_y from p is `radius` away from the line p + s u:
/// |w|^2 - (w.u)^2 = r^2, a quadratic in y whose upper root counts where s is on the edge.
fn catch_on_edge(p: DVec3, q: DVec3, at: DVec2, radius: f64) -> Option<Touch> {
    let length = p.distance(q);
    let u = (q - p) / length;
    let w0 = at - p.xz();
    let along = w0.dot(u.xz());
    let a = u.xz().length_squared();
    let half_b = along * u.y;
    let c = w0.length_squared() - along * along - radius * radius;
    let root2 = half_b * half_b - a * c;
    if a < LEAST_RUN_M || root2 < 0.0 {
        return None;
    }
    let y = (half_b + root2.sqrt()) / a;
    let s = along + y * u.y;
    (0.0..=length).contains(&s).then_some(Touch {
        centre_y: p.y + y,
        contact_y: p.y + s * u.y,
    })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use super::*;

    fn triangles() -> impl Iterator<Item = Triangle> {
        let value = |n: i32| f64::from((n * n * 31 + n * 17).rem_euclid(2003) - 1001) / 700.0;
        (0..40).map(move |i| {
            let corner =
                |k: i32| DVec3::new(value(9 * i + k), value(9 * i + k + 1), value(9 * i + k + 2));
            let corners = [corner(0), corner(3), corner(6)];
            let upward = (corners[1] - corners[0]).cross(corners[2] - corners[0]).y > 0.0;
            Triangle::new(if upward {
                corners
            } else {
                [corners[0], corners[2], corners[1]]
            })
            .unwrap()
        })
    }

    /// Points all over a triangle.
    fn samples(triangle: &Triangle) -> impl Iterator<Item = DVec3> {
        const CUTS: i32 = 120;
        let [a, b, c] = triangle.corners;
        (0..=CUTS).flat_map(move |i| {
            let u = f64::from(i) / f64::from(CUTS);
            (0..=CUTS - i)
                .map(move |j| a + (b - a) * u + (c - a) * (f64::from(j) / f64::from(CUTS)))
        })
    }

    #[test]
    fn the_nearest_points_of_an_axis_are_those_that_a_search_finds() {
        let (foot, top) = (DVec3::new(0.2, -0.4, -0.1), DVec3::new(0.2, 0.7, -0.1));
        for triangle in triangles() {
            let nearest = triangle.nearest_to_upright(foot, top);
            let found = samples(&triangle)
                .map(|p| p.distance(DVec3::new(foot.x, p.y.clamp(foot.y, top.y), foot.z)))
                .fold(f64::MAX, f64::min);
            let distance = nearest.on_axis.distance(nearest.on_triangle);
            assert!(
                distance <= found + 1e-9 && found < distance + 0.03,
                "{distance} {found} {triangle:?}"
            );
            assert_eq!(nearest.pierced, distance == 0.0);
        }
    }

    #[test]
    fn an_upright_edge_beside_the_whole_axis_is_found() {
        let corners = [
            DVec3::new(1.0, -5.0, 0.0),
            DVec3::new(1.0, 5.0, 0.0),
            DVec3::new(2.0, 0.0, 1.0),
        ];
        let nearest = Triangle::new(corners)
            .unwrap()
            .nearest_to_upright(DVec3::ZERO, DVec3::Y);
        assert!((nearest.on_axis.distance(nearest.on_triangle) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn a_falling_ball_is_caught_where_a_search_says() {
        let (at, radius) = (DVec2::new(0.2, -0.1), 0.6);
        let mut caught = 0;
        for triangle in triangles() {
            let found = samples(&triangle)
                .filter_map(|p| {
                    let rise2 = radius * radius - at.distance_squared(p.xz());
                    (rise2 >= 0.0).then(|| p.y + rise2.sqrt())
                })
                .fold(f64::MIN, f64::max);
            match triangle.catch_ball(at, radius) {
                Some(touch) => {
                    caught += 1;
                    let near = touch.centre_y >= found - 1e-9 && found > touch.centre_y - 0.05;
                    assert!(near, "{} {found} {triangle:?}", touch.centre_y);
                }
                None => assert!(found == f64::MIN, "{found} {triangle:?}"),
            }
        }
        assert!(caught > 10, "{caught}");
    }
}
