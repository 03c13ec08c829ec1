//! The frame at a foot on the ground sphere, in the chart that the foot is written in: what bodies ask in every step.
//!
//! In units of the radius a place (u, v) of a chart's plane is `n = (s u, c, s v)` of the unit sphere, with c and s the cosine of
//! its distance r from the middle and `sin(r)/r`. The chart's frame there is that of [`crate::kernel::cylindrical`],
//! `E_x = (1 + k u^2, -s u, k u v)` and `E_z = (k u v, -s v, 1 + k v^2)` with `k = (c - 1)/r^2`. Both charts are alike but for a
//! rotation of the sphere, which changes no product, so the foot need not know which one it is in.

use glam::{DVec2, DVec3};

/// Squares of distances from the middle below this have k as a series: there the fraction cancels.
const NEAR_SQUARE: f64 = 1e-2;
/// `asin(t)/t` by powers of t^2, good to 1e-13 up to [`SERIES_SQUARE`].
const ARC: [f64; 9] = [
    1.0,
    1.0 / 6.0,
    3.0 / 40.0,
    5.0 / 112.0,
    35.0 / 1152.0,
    63.0 / 2816.0,
    231.0 / 13312.0,
    143.0 / 10240.0,
    6435.0 / 557_056.0,
];
const SERIES_SQUARE: f64 = 0.04;

/// So near only the first of them count, to 1e-15.
const FIRST_SQUARE: f64 = 3e-3;
const FIRST: usize = 5;
/// `cos r` and `sin(r)/r` by powers of `-r^2`, to 1e-15 up to this square: a fifth of a turn past the equator.
const TERMS: usize = 13;
const MOST_SQUARE: f64 = 4.5;
const COSINE: [f64; TERMS] = factors(0);
const SINE: [f64; TERMS] = factors(1);

/// `1/(2n + first)!` for each n.
const fn factors(first: usize) -> [f64; TERMS] {
    let mut all = [1.0; TERMS];
    let mut n = 1;
    while n < TERMS {
        let last = 2 * n + first;
        all[n] = all[n - 1] / ((last * (last - 1)) as f64);
        n += 1;
    }
    all
}

/// A foot on the unit sphere, with its chart's frame.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Foot {
    at: DVec2,
    n: DVec3,
    x: DVec3,
    z: DVec3,
    /// `sin(r)/r` there: how long a level metre across the way out from the middle is on the plane.
    across: f64,
}

/// A place of a chart's plane on the sphere, and the square of its distance from the middle, radii.
fn on_sphere(at: DVec2) -> (DVec3, f64, f64) {
    let square = at.length_squared();
    let (c, s) = if square < MOST_SQUARE {
        let sum = |parts: &[f64]| {
            parts
                .iter()
                .rev()
                .fold(0.0, |sum, part| part - sum * square)
        };
        (sum(&COSINE), sum(&SINE))
    } else {
        let r = square.sqrt();
        (r.cos(), r.sin() / r)
    };
    (DVec3::new(s * at.x, c, s * at.y), s, square)
}

impl Foot {
    /// At a place of a chart's plane, radii.
    pub fn at(at: DVec2) -> Self {
        let (n, s, square) = on_sphere(at);
        let k = if square < NEAR_SQUARE {
            -0.5 + square * (1.0 / 24.0 - square * (1.0 / 720.0 - square / 40320.0))
        } else {
            (n.y - 1.0) / square
        };
        let both = k * at.x * at.y;
        Self {
            at,
            n,
            x: DVec3::new(1.0 + k * at.x * at.x, -s * at.x, both),
            z: DVec3::new(both, -s * at.y, 1.0 + k * at.y * at.y),
            across: s,
        }
    }

    /// A level way on the plane in the chart's own lengths: along the way out it is as long, across it `1/across` times.
    pub fn in_chart(&self, way: DVec2) -> DVec2 {
        let out = self.at.normalize_or(DVec2::X);
        let away = out * way.dot(out);
        away + (way - away) / self.across
    }

    /// Where a place of the chart's plane is from here: along the great circle there, radii.
    #[inline]
    pub fn offset(&self, at: DVec2) -> DVec2 {
        let (n, ..) = on_sphere(at);
        let way = DVec2::new(n.dot(self.x), n.dot(self.z));
        let square = way.length_squared();
        let ahead = n.dot(self.n);
        let scale = if square < SERIES_SQUARE && ahead > 0.0 {
            let count = if square < FIRST_SQUARE {
                FIRST
            } else {
                ARC.len()
            };
            let parts = ARC[..count].iter().rev();
            parts.fold(0.0, |sum, part| sum * square + part)
        } else {
            let level = square.sqrt();
            if level > 0.0 {
                level.atan2(ahead) / level
            } else {
                1.0
            }
        };
        way * scale
    }

    /// The place of the chart's plane that is so far from here, radii, and the turn that directions take on the way, as in
    /// [`crate::Crossing`].
    pub fn arrival(&self, off: DVec2) -> (DVec2, f64) {
        let away = off.length();
        let ahead = if away > 0.0 { off / away } else { DVec2::X };
        let (sin, cos) = away.sin_cos();
        let way = self.x * ahead.x + self.z * ahead.y;
        let n = self.n * cos + way * sin;
        let level = DVec2::new(n.x, n.z).length();
        let per_level = if level > 0.0 {
            level.atan2(n.y) / level
        } else {
            1.0
        };
        let place = DVec2::new(n.x, n.z) * per_level;
        let there = Self::at(place);
        let on = way * cos - self.n * sin;
        let on = DVec2::new(on.dot(there.x), on.dot(there.z));
        (place, -ahead.perp_dot(on).atan2(ahead.dot(on)))
    }
}
