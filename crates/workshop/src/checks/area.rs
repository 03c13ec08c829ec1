//! What of a level square is left when triangles are taken away from it: whether a floor has holes.

use glam::DVec3;

/// Pieces of an area at most: of a floor in more it is not told whether it has holes.
const MOST_PIECES: usize = 100;
/// Less is no piece, square metres.
const LEAST_M2: f64 = 1e-9;

/// A level area, as convex polygons. Heights are no matter.
pub(crate) struct Area(Vec<Vec<DVec3>>);

impl Area {
    /// A rectangle between two corners.
    pub fn rectangle(low: DVec3, high: DVec3) -> Self {
        let corner = |x, z| DVec3::new(x, low.y, z);
        Self(vec![vec![
            corner(low.x, low.z),
            corner(high.x, low.z),
            corner(high.x, high.z),
            corner(low.x, high.z),
        ]])
    }

    /// Takes away what is above or below a convex polygon; false if that makes too many pieces.
    pub fn take_away(&mut self, polygon: &[DVec3]) -> bool {
        let area = signed_m2(polygon);
        if area.abs() < LEAST_M2 {
            return true;
        }
        // Where cuts met there are sides that are points, but for rounding.
        let is_side = |it: &(DVec3, DVec3)| it.0.distance_squared(it.1) > LEAST_M2 * LEAST_M2;
        let sides: Vec<_> = sides(polygon)
            .filter(is_side)
            .map(|(a, b)| {
                let inward = (b - a).cross(DVec3::Y) * -area.signum();
                (inward.with_y(0.0), inward.dot(a.with_y(0.0)))
            })
            .collect();
        let mut left = Vec::new();
        for mut piece in std::mem::take(&mut self.0) {
            for (inward, least) in &sides {
                let outer = cut(&piece, -*inward, -*least);
                if signed_m2(&outer).abs() >= LEAST_M2 {
                    left.push(outer);
                }
                piece = cut(&piece, *inward, *least);
            }
        }
        self.0 = left;
        self.0.len() <= MOST_PIECES
    }

    /// How much is left, square metres.
    pub fn m2(&self) -> f64 {
        self.0.iter().map(|it| signed_m2(it).abs()).sum()
    }
}

/// What of a convex polygon is in a box.
pub(crate) fn clipped(polygon: &[DVec3], low: DVec3, high: DVec3) -> Vec<DVec3> {
    let mut left = polygon.to_vec();
    for (axis, n) in DVec3::AXES.into_iter().enumerate() {
        left = cut(&left, n, low[axis]);
        left = cut(&left, -n, -high[axis]);
    }
    left
}

/// What of a convex polygon has at least so much along a direction (I. E. Sutherland and G. W. Hodgman, 1974).
fn cut(polygon: &[DVec3], along: DVec3, least: f64) -> Vec<DVec3> {
    let mut left = Vec::with_capacity(polygon.len() + 1);
    for (a, b) in sides(polygon) {
        let (from, to) = (along.dot(a) - least, along.dot(b) - least);
        if from >= 0.0 {
            left.push(a);
        }
        if (from < 0.0) != (to < 0.0) {
            left.push(a.lerp(b, from / (from - to)));
        }
    }
    left
}

fn sides(polygon: &[DVec3]) -> impl Iterator<Item = (DVec3, DVec3)> + '_ {
    let next = polygon.iter().cycle().skip(1);
    polygon.iter().copied().zip(next.copied())
}

/// The area of a polygon as seen from above, above nought one way around.
fn signed_m2(polygon: &[DVec3]) -> f64 {
    let Some(first) = polygon.first() else {
        return 0.0;
    };
    let twice = sides(polygon).map(|(a, b)| (a - first).cross(b - first).y);
    twice.sum::<f64>() / 2.0
}
