//! One triangle, in felt metres, beside a ball: which point of it is nearest, and where a ball that comes down is caught.

use glam::{DVec2, DVec3, Vec3Swizzles as _};

/// Edges whose run is shorter than this, metres, count as upright.
const LEAST_RUN_M: f64 = 1e-9;

/// Where a ball that comes straight down over the origin first touches a triangle; y is up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch {
    /// Height of the ball's middle, metres.
    pub centre_y: f64,
    /// Height of the point of contact, metres.
    pub contact_y: f64,
    /// How upright the triangle's face is: y of its normal of length 1.
    pub face_up: f64,
}

/// Where a ball that falls straight down over the origin touches this triangle from its upper side; none for one that it
/// misses or that faces down.
pub fn catch_ball(corners: [DVec3; 3], radius: f64) -> Option<Touch> {
    let [a, b, c] = corners;
    let face = (b - a).cross(c - a).try_normalize()?;
    if face.y < LEAST_RUN_M {
        return None;
    }
    let touch = |centre_y: f64, contact_y: f64| Touch {
        centre_y,
        contact_y,
        face_up: face.y,
    };
    let edges = [(a, b), (b, c), (c, a)];
    let on_face = -face.xz() * radius;
    // Seen from above with z down the page, anticlockwise corners have a negative cross product.
    let is_within = edges
        .iter()
        .all(|(p, q)| (q.xz() - p.xz()).perp_dot(on_face - p.xz()) <= 0.0);
    if is_within {
        let slide = on_face - a.xz();
        let contact_y = a.y - (face.x * slide.x + face.z * slide.y) / face.y;
        return Some(touch(contact_y + face.y * radius, contact_y));
    }
    let on_edges = edges.iter().filter_map(|(p, q)| on_edge(*p, *q, radius));
    let on_corners = corners.iter().filter_map(|p| {
        let rise2 = radius * radius - p.xz().length_squared();
        (rise2 >= 0.0).then(|| (p.y + rise2.sqrt(), p.y))
    });
    on_edges
        .chain(on_corners)
        .max_by(|one, other| one.0.total_cmp(&other.0))
        .map(|(centre_y, contact_y)| touch(centre_y, contact_y))
}

/// Heights of the middle and of the contact where the ball comes to rest on the line from p to q. The middle
/// w = -p + y e_y, seen from p, is `radius` away from the line along u: |w|^2 - (w.u)^2 = r^2, a quadratic in y whose
/// upper root counts where its foot lies between p and q.
fn on_edge(p: DVec3, q: DVec3, radius: f64) -> Option<(f64, f64)> {
    let length = p.distance(q);
    let u = (q - p) / length;
    let from: DVec2 = -p.xz();
    let along = from.dot(u.xz());
    let a = u.xz().length_squared();
    let half_b = along * u.y;
    let c = from.length_squared() - along * along - radius * radius;
    let root2 = half_b * half_b - a * c;
    if a < LEAST_RUN_M || root2 < 0.0 {
        return None;
    }
    let y = (half_b + root2.sqrt()) / a;
    let foot = along + y * u.y;
    (0.0..=length)
        .contains(&foot)
        .then_some((p.y + y, p.y + foot * u.y))
}

/// The point of a triangle next to the origin (C. Ericson, Real-Time Collision Detection, 5.1.5).
pub fn closest_to_origin([a, b, c]: [DVec3; 3]) -> DVec3 {
    let (ab, ac) = (b - a, c - a);
    let (d1, d2) = (-ab.dot(a), -ac.dot(a));
    if d1 <= 0.0 && d2 <= 0.0 {
        return a;
    }
    let (d3, d4) = (-ab.dot(b), -ac.dot(b));
    if d3 >= 0.0 && d4 <= d3 {
        return b;
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return a + ab * (d1 / (d1 - d3));
    }
    let (d5, d6) = (-ab.dot(c), -ac.dot(c));
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
    let whole = va + vb + vc;
    if whole == 0.0 {
        return a;
    }
    a + ab * (vb / whole) + ac * (vc / whole)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn triangles() -> impl Iterator<Item = [DVec3; 3]> {
        let value = |n: i32| f64::from((n * n * 31 + n * 17).rem_euclid(2003) - 1001) / 700.0;
        (0..40).map(move |i| {
            let corner =
                |k: i32| DVec3::new(value(9 * i + k), value(9 * i + k + 1), value(9 * i + k + 2));
            let [a, b, c] = [corner(0), corner(3), corner(6)];
            if (b - a).cross(c - a).y > 0.0 {
                [a, b, c]
            } else {
                [a, c, b]
            }
        })
    }

    /// Points all over a triangle.
    fn samples([a, b, c]: [DVec3; 3]) -> impl Iterator<Item = DVec3> {
        (0..=120).flat_map(move |i| {
            (0..=120 - i).map(move |j| {
                a + (b - a) * (f64::from(i) / 120.0) + (c - a) * (f64::from(j) / 120.0)
            })
        })
    }

    #[test]
    fn a_falling_ball_is_caught_where_a_search_says() {
        let radius = 0.6;
        let mut caught = 0;
        for triangle in triangles() {
            let found = samples(triangle)
                .filter_map(|p| {
                    let rise2 = radius * radius - p.xz().length_squared();
                    (rise2 >= 0.0).then(|| p.y + rise2.sqrt())
                })
                .fold(f64::MIN, f64::max);
            match catch_ball(triangle, radius) {
                Some(touch) => {
                    caught += 1;
                    let is_near = touch.centre_y >= found - 1e-9 && found > touch.centre_y - 0.05;
                    assert!(is_near, "{touch:?} {found} {triangle:?}");
                }
                None => assert!(found == f64::MIN, "{found} {triangle:?}"),
            }
        }
        assert!(caught > 10, "{caught}");
    }

    #[test]
    fn no_point_of_a_triangle_is_nearer_than_the_nearest() {
        for triangle in triangles() {
            let nearest = closest_to_origin(triangle).length();
            let found = samples(triangle)
                .map(DVec3::length)
                .fold(f64::MAX, f64::min);
            assert!(
                nearest <= found + 1e-9 && found < nearest + 0.03,
                "{nearest} {found}"
            );
        }
    }
}
