//! Bounds the directions in which a box of the chart is seen by a cell of azimuths and slopes.
//!
//! Every map but the sphere's second chart turns about the upright through the eye, so it keeps
//! azimuths: a point's picture has its chart azimuth, and a slope (rise over level distance, as the
//! eye sees them) that grows with its height. A box is therefore seen inside a product of an
//! azimuth range and a slope range, and whether the picture's pyramid touches that cell is decided
//! exactly, plane by plane. The same slopes say what stands behind the skyline of nearer land.

use std::f64::consts::PI;

use glam::{DVec2, DVec3};

use crate::ChartId;
use crate::scalar::{acos_k, cos_k, sin_k};

/// A cell of directions about the upright through the eye, in the chart's axes at the eye.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SightCell {
    /// The middle azimuth in radians, from +x towards +z.
    pub azimuth_rad: f64,
    /// How far the cell goes to either side of it; pi is all around.
    pub half_width_rad: f64,
    /// Least and greatest level distance from the eye, in metres along the chart or the sheet.
    pub level_m: [f64; 2],
    /// Least and greatest slope; infinite straight down and up, and crossed in an empty cell.
    pub slope: [f64; 2],
    /// No point of the box is nearer to the eye than this, in metres of the space.
    pub nearest_m: f64,
}

/// An upright bounding cylinder of the chart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoundingCylinder {
    /// The chart it lies in.
    pub chart: ChartId,
    /// The middle of its circle, x and z in metres.
    pub middle: DVec2,
    /// Radius of its circle, in metres.
    pub radius_m: f64,
    /// Where it begins and ends, in metres of y.
    pub heights_m: [f64; 2],
}

impl BoundingCylinder {
    /// Least and greatest corner of as high a box that goes that far to each side.
    pub fn square(&self, half: DVec3) -> [DVec3; 2] {
        let at = |y: f64| DVec3::new(self.middle.x, y, self.middle.y);
        [at(self.heights_m[0]) - half, at(self.heights_m[1]) + half]
    }
}

impl SightCell {
    /// The cell of what is never seen.
    pub const NOWHERE: Self = Self {
        azimuth_rad: 0.0,
        half_width_rad: 0.0,
        level_m: [f64::INFINITY; 2],
        slope: [f64::INFINITY, f64::NEG_INFINITY],
        nearest_m: f64::INFINITY,
    };

    /// The cell of what may be seen anywhere.
    pub const EVERYWHERE: Self = Self {
        azimuth_rad: 0.0,
        half_width_rad: PI,
        level_m: [0.0, f64::INFINITY],
        slope: [f64::NEG_INFINITY, f64::INFINITY],
        nearest_m: 0.0,
    };

    /// Whether nothing of the box is ever seen.
    pub fn is_empty(&self) -> bool {
        self.slope[0] > self.slope[1]
    }

    /// Whether a direction in the chart's axes at the eye lies in the cell, or within
    /// `slack_rad` radians of it.
    pub fn holds(&self, direction: DVec3, slack_rad: f64) -> bool {
        let elevation = direction.y.atan2(direction.x.hypot(direction.z));
        let aside = turn(direction.z.atan2(direction.x) - self.azimuth_rad).abs();
        let [low, high] = self.slope.map(f64::atan);
        (aside <= self.half_width_rad + slack_rad || self.half_width_rad >= PI)
            && (low - slack_rad..=high + slack_rad).contains(&elevation)
    }

    /// The greatest value that a plane through the eye takes in the cell, at unit level distance.
    pub(crate) fn greatest(&self, side: &Side) -> f64 {
        let away = turn(self.azimuth_rad - side.azimuth_rad).abs();
        let level = side.level * (away - self.half_width_rad).max(0.0).cos();
        let steepest = self.slope[usize::from(side.rise > 0.0)];
        if side.rise == 0.0 {
            level
        } else {
            level + side.rise * steepest
        }
    }
}

/// A plane through the eye by its unit normal, in the chart's axes at the eye.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Side {
    azimuth_rad: f64,
    level: f64,
    rise: f64,
}

impl Side {
    /// The plane of a unit normal.
    pub fn new(normal: DVec3) -> Self {
        Self {
            azimuth_rad: normal.z.atan2(normal.x),
            level: normal.x.hypot(normal.z),
            rise: normal.y,
        }
    }
}

/// An angle brought to [-pi, pi].
pub(crate) fn turn(angle: f64) -> f64 {
    angle - (angle / (2.0 * PI)).round() * 2.0 * PI
}

/// How far a rectangle from `low` to `high` that does not hold the origin reaches to either side of its middle, seen
/// from there: the least and the greatest azimuth of a corner less that of the middle, in radians.
pub fn azimuth_spread(low: DVec2, high: DVec2) -> [f64; 2] {
    let middle = 0.5 * (low + high);
    let corners = [
        low,
        DVec2::new(high.x, low.y),
        high,
        DVec2::new(low.x, high.y),
    ];
    let [mut first, mut last] = [low; 2];
    for corner in corners {
        // The corners lie within a half turn, so that each is to one side of each other.
        if first.perp_dot(corner) < 0.0 {
            first = corner;
        }
        if last.perp_dot(corner) > 0.0 {
            last = corner;
        }
    }
    [first, last].map(|corner| middle.perp_dot(corner).atan2(middle.dot(corner)))
}

/// The ground plan of something, seen from the upright through the eye.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Plan {
    pub azimuth_rad: f64,
    pub half_width_rad: f64,
    pub level_m: [f64; 2],
}

impl Plan {
    /// The plan of a box from `low` to `high`, relative to the eye.
    pub fn of_box(low: DVec3, high: DVec3) -> Self {
        let (low, high) = (DVec2::new(low.x, low.z), DVec2::new(high.x, high.z));
        let nearest = DVec2::ZERO.clamp(low, high).length();
        let level_m = [nearest, low.abs().max(high.abs()).length()];
        if nearest == 0.0 {
            return Self {
                azimuth_rad: 0.0,
                half_width_rad: PI,
                level_m,
            };
        }
        let middle = 0.5 * (low + high);
        let [first, last] = azimuth_spread(low, high);
        Self {
            azimuth_rad: middle.y.atan2(middle.x),
            half_width_rad: last.max(-first),
            level_m,
        }
    }
}

/// The slopes of a box whose points have heights and level distances in the given ranges, told in whatever form `slope` takes, so that
/// sines are taken once.
///
/// `slope(y, r)` grows with y; along r it turns at most once, at `turns(y)`, if that lies between.
pub(crate) fn slope_range<Y, R>(
    [low, high]: &[Y; 2],
    [near, far]: &[R; 2],
    slope: impl Fn(&Y, &R) -> f64,
    turns: impl Fn(&Y) -> Option<R>,
) -> [f64; 2] {
    let ends = |y: &Y| {
        let turned = turns(y).map_or(f64::NAN, |r| slope(y, &r));
        [slope(y, near), slope(y, far), turned]
    };
    [
        ends(low).into_iter().fold(f64::INFINITY, f64::min),
        ends(high).into_iter().fold(f64::NEG_INFINITY, f64::max),
    ]
}

/// A level distance, metres, with its sine and cosine of a curvature.
struct Level {
    r: f64,
    sin: f64,
    cos: f64,
}

/// The upright through an eye `height_m` over a totally geodesic sheet, in a space of curvature
/// `kappa` per square metre.
///
/// A point at height y and level distance r is seen at the slope
/// `(T(y) C(h) - S(h) C(r)) / S(r)`, with S, C and T the sine, cosine and tangent of that
/// curvature; along r that turns where `C(r) = T(h) / T(y)`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Axis {
    kappa: f64,
    height_m: f64,
    sin_h: f64,
    cos_h: f64,
}

impl Axis {
    /// The upright through an eye that high over the sheet, in metres.
    pub fn new(kappa: f64, height_m: f64) -> Self {
        Self {
            kappa,
            height_m,
            sin_h: sin_k(kappa, height_m),
            cos_h: cos_k(kappa, height_m),
        }
    }

    fn tan(&self, y: f64) -> f64 {
        sin_k(self.kappa, y) / cos_k(self.kappa, y)
    }

    fn level(&self, r: f64) -> Level {
        let (sin, cos) = (sin_k(self.kappa, r), cos_k(self.kappa, r));
        Level { r, sin, cos }
    }

    /// The slope at which a height of that tangent is seen.
    fn slope(&self, tan: f64, level: &Level) -> f64 {
        let rise = tan * self.cos_h - self.sin_h * level.cos;
        // On the upright itself, and at the far side of a sphere, all is straight up or down.
        if level.sin <= 1e-9 * (1.0 + level.r.abs()) {
            f64::INFINITY.copysign(rise)
        } else {
            rise / level.sin
        }
    }

    /// Where that slope turns.
    fn turns(&self, tan: f64) -> Option<f64> {
        acos_k(self.kappa, self.sin_h / (tan * self.cos_h))
    }

    /// A lower bound on the distance to what lies at these heights from `level_m` on.
    ///
    /// Where curvature is not positive the chart never exceeds the space's own distances. On a
    /// sphere `cos d = cos y cos h cos r + sin y sin h`, greatest at the nearest r and at the
    /// height whose tangent is `tan h / cos r`.
    fn nearest_m(&self, heights: [f64; 2], level_m: f64) -> f64 {
        if self.kappa <= 0.0 {
            let up = (heights[0] - self.height_m).max(self.height_m - heights[1]);
            return level_m.hypot(up.max(0.0));
        }
        let k = self.kappa.sqrt();
        let (h, r) = (k * self.height_m, k * level_m);
        let (along, up) = (h.cos() * r.cos(), h.sin());
        let best = up.atan2(along);
        let [low, high] = heights.map(|y| k * y);
        let y = if (low..=high).contains(&best) {
            best
        } else if (low - best).cos() > (high - best).cos() {
            low
        } else {
            high
        };
        // The same distance from half angles, which keeps its digits as the sphere grows.
        let climb = (0.5 * (y - h)).sin();
        let across = (0.5 * r).sin();
        let half = (climb * climb + y.cos() * h.cos() * across * across)
            .max(0.0)
            .sqrt();
        2.0 * half.min(1.0).asin() / k
    }

    /// The cell of what lies over a plan between two heights over the sheet.
    pub fn cell(&self, plan: &Plan, heights: [f64; 2]) -> SightCell {
        SightCell {
            azimuth_rad: plan.azimuth_rad,
            half_width_rad: plan.half_width_rad,
            level_m: plan.level_m,
            slope: slope_range(
                &heights.map(|y| self.tan(y)),
                &plan.level_m.map(|r| self.level(r)),
                |tan, level| self.slope(*tan, level),
                |tan| {
                    let [near, far] = plan.level_m;
                    let turn = self.turns(*tan);
                    turn.filter(|r| (near..=far).contains(r))
                        .map(|r| self.level(r))
                },
            ),
            nearest_m: self.nearest_m(heights, plan.level_m[0]),
        }
    }

    /// The cell of a box from `low` to `high` metres from the eye, as far as it lies within the
    /// given level distance from the eye and height over or under the sheet.
    pub fn cell_of_box(&self, low: DVec3, high: DVec3, level_m: f64, upright_m: f64) -> SightCell {
        let mut plan = Plan::of_box(low, high);
        let heights = [low.y, high.y].map(|y| y + self.height_m);
        if plan.level_m[0] > level_m || heights[0] > upright_m || heights[1] < -upright_m {
            return SightCell::NOWHERE;
        }
        plan.level_m[1] = plan.level_m[1].min(level_m);
        self.cell(&plan, heights.map(|y| y.clamp(-upright_m, upright_m)))
    }
}
