//! How the key light sees the world: the planes that shadow maps are pictures of, and what falls on them.
//!
//! Under a sky the key comes from one direction of the charts' common axes, so that rays of light are straight lines of the
//! charts whatever the map of the picture does, and a map is a parallel picture of them. In a closed world the key comes
//! from a point of the three-sphere. Its rays are great circles, which a central projection from that point makes
//! straight, so a map is a perspective picture of the space itself, with six faces for all directions.

use std::f64::consts::FRAC_PI_2;

use antipode_frame::{Frame, View};
use antipode_geometry::{ChartId, ChartPoint, Eye, Strategy};
use glam::{DMat4, DVec2, DVec3, DVec4};

use super::caster::Caster;
use super::ideal::ideal;
use crate::culling::Ball;

/// Where a parallel picture is measured from: the corner of this grid next to the eye, metres. Sums stay small, and
/// nothing depends on the way that the eye took.
const ANCHOR_M: f64 = 64.0;
/// Room beyond what a map holds in depth, metres: what is built in some seconds.
pub const DEPTH_SLACK_M: f64 = 8.0;
/// Depth of a perspective picture by the cotangent of the distance, in radii: 0.5 + this * cot. Half a metre from the
/// light it would leave 0 to 1 where the radius is 16 m, and one f32 step is 0.05 mm where it is 256 m.
const COTANGENT_DEPTH: f64 = 0.012;
/// Half of the widest map of a face, as a tangent: 72 degrees.
const WIDEST: f64 = 3.0;
/// Faces that see all directions of a point.
pub const FACES: usize = 6;

/// Where the key light comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Light {
    /// From one direction of the common axes: unit vectors towards it and across it, and the point, whole metres, that
    /// pictures are measured from. Where charts have no axes in common it is an ideal point of hyperbolic space, and they are
    /// those of the middle of the anchor's chart; the root of the curvature, 1/m, and else 0.
    Far {
        toward: DVec3,
        across: [DVec3; 2],
        anchor: ChartPoint,
        per_m: f64,
    },
    /// From a point of the unit three-sphere, with three tangents there; the radius in metres.
    Star {
        at: DVec4,
        axes: [DVec4; 3],
        radius_m: f64,
    },
}

/// The four tangents of a point of the three-sphere that a product with unit quaternions gives: orthonormal, and
/// nowhere a jump from point to point.
fn star(at: DVec4, radius_m: f64) -> Light {
    let DVec4 { x, y, z, w } = at;
    let axes = [
        DVec4::new(w, -z, y, -x),
        DVec4::new(z, w, -x, -y),
        DVec4::new(-y, x, w, -z),
    ];
    Light::Star { at, axes, radius_m }
}

/// What a light of one direction is measured by: unit vectors across it.
pub(super) fn across(toward: DVec3) -> [DVec3; 2] {
    // The sun goes round x and the moon round z; an axis that the light never comes near does not spin.
    let axis = if toward.x.abs() < 0.9 {
        DVec3::X
    } else {
        DVec3::Z
    };
    let right = (axis - toward * axis.dot(toward)).normalize();
    [right, toward.cross(right)]
}

fn far(toward: DVec3, eye: ChartPoint) -> Light {
    Light::Far {
        toward,
        across: across(toward),
        anchor: ChartPoint::new(eye.chart, (eye.pos / ANCHOR_M).round() * ANCHOR_M),
        per_m: 0.0,
    }
}

/// The body that a closed world's key light comes from, if one is told.
pub fn key_body(frame: &Frame) -> Option<ChartPoint> {
    let orbs = frame.content.sky.orbs?;
    let is_sun = frame.content.sky.key_direction == frame.content.sky.sun_direction;
    Some(if is_sun { orbs.sun } else { orbs.moon })
}

/// Its point of the unit three-sphere; straight up where none is told.
fn body(frame: &Frame) -> DVec4 {
    let curved = |body| frame.view.strategy.curved(&frame.view.eye, body);
    key_body(frame).map_or(DVec4::Y, curved)
}

impl Light {
    /// A frame's key light.
    pub fn of(frame: &Frame) -> Self {
        if frame.view.strategy.has_sky() {
            let toward = DVec3::from(frame.content.sky.key_direction.map(f64::from));
            let toward = toward.normalize_or(DVec3::Y);
            if frame.view.strategy.shader().daylight.has_axes {
                far(toward, frame.view.eye.point)
            } else {
                ideal(toward, &frame.view)
            }
        } else {
            star(body(frame), frame.view.strategy.radius_m())
        }
    }

    /// Whether it is an ideal point of hyperbolic space.
    pub fn is_ideal(&self) -> bool {
        matches!(self, Self::Far { per_m, .. } if *per_m > 0.0)
    }

    /// How far the light has turned as one sees it, or gone round its world, radians; infinite from one kind to the other.
    pub fn turn_to(&self, other: &Self, view: &View) -> f64 {
        let angle = |a: DVec3, b: DVec3| 2.0 * (0.5 * a.distance(b)).min(1.0).asin();
        match (self, other) {
            (a, b) if a.is_ideal() && b.is_ideal() => {
                angle(a.toward_from(view), b.toward_from(view))
            }
            (Self::Far { toward: a, .. }, Self::Far { toward: b, .. }) => angle(*a, *b),
            (Self::Star { at: a, .. }, Self::Star { at: b, .. }) => {
                2.0 * (0.5 * a.distance(*b)).min(1.0).asin()
            }
            _ => f64::INFINITY,
        }
    }

    /// Where what stands in a chart is drawn into maps from: the anchor as that chart has it, metres; its middle where maps
    /// are made from the space, and the eye's reference where light is an ideal point. None where the chart does not reach the
    /// anchor.
    pub fn origin(&self, strategy: &dyn Strategy, eye: &Eye, chart: ChartId) -> Option<DVec3> {
        match self {
            Self::Far { .. } if self.is_ideal() => Some(strategy.reference(eye, chart)),
            Self::Far { anchor, .. } => Some(strategy.carry(*anchor, chart)?.point.pos),
            Self::Star { .. } => Some(DVec3::ZERO),
        }
    }

    /// What maps are made from: homogeneous metres from the anchor in the common axes, or the sphere's point, its first
    /// three coordinates in metres. Infinitely far where no way leads from the anchor to the point's chart.
    pub fn base(&self, strategy: &dyn Strategy, point: ChartPoint) -> DVec4 {
        match self {
            Self::Far { anchor, per_m, .. } if *per_m > 0.0 => {
                let about = Eye {
                    point: *anchor,
                    ..Eye::default()
                };
                let x = strategy.curved(&about, point);
                (x.truncate() / *per_m).extend(x.w)
            }
            Self::Far { .. } => {
                let away = |origin| strategy.in_common_axes(point.chart, point.pos - origin);
                let origin = self.origin(strategy, &Eye::default(), point.chart);
                origin.map_or(DVec3::INFINITY, away).extend(1.0)
            }
            Self::Star { radius_m, .. } => {
                let x = strategy.curved(&Eye::default(), point);
                (x.truncate() * *radius_m).extend(x.w)
            }
        }
    }

    /// Rows that take the base to the light's own coordinates: for one far off two across, the height towards it and
    /// 1, or `q = W - s.X/R` of an ideal point s; for a star three metres of the space's coordinates there, and the fourth without unit.
    fn rows(&self) -> [DVec4; 4] {
        match self {
            Self::Far {
                toward,
                across,
                per_m,
                ..
            } => [
                across[0].extend(0.0),
                across[1].extend(0.0),
                toward.extend(0.0),
                (*toward * -per_m).extend(1.0),
            ],
            Self::Star { at, axes, radius_m } => {
                let metres = |axis: &DVec4| axis.truncate().extend(radius_m * axis.w);
                [
                    metres(&axes[0]),
                    metres(&axes[1]),
                    metres(&axes[2]),
                    (at.truncate() / *radius_m).extend(at.w),
                ]
            }
        }
    }

    /// The face on which a point is seen, and where on its plane: metres, or tangents of angles.
    pub fn seen(&self, base: DVec4) -> (usize, DVec2) {
        let own = self.rows().map(|row| row.dot(base));
        let face = match self {
            Self::Far { .. } => 0,
            Self::Star { .. } => (0..FACES)
                .max_by(|a, b| ahead(own, *a).total_cmp(&ahead(own, *b)))
                .unwrap_or(0),
        };
        (face, self.on_plane(face, base))
    }

    /// Where a point lies on the plane of a face, which it may be behind.
    pub fn on_plane(&self, face: usize, base: DVec4) -> DVec2 {
        let own = self.rows().map(|row| row.dot(base));
        match self {
            Self::Far { .. } if self.is_ideal() => DVec2::new(own[0], own[1]) / own[3],
            Self::Far { .. } => DVec2::new(own[0], own[1]),
            Self::Star { .. } => {
                let depth = ahead(own, face).max(f64::MIN_POSITIVE);
                let [a, b] = beside(face).map(|axis| own[axis]);
                DVec2::new(a, b) / depth
            }
        }
    }

    /// How long a stretch of `metres` at a point is on the plane of a face, at most.
    pub fn length_on_plane(&self, base: DVec4, metres: f64) -> f64 {
        match self {
            Self::Far { .. } if self.is_ideal() => metres / self.rows()[3].dot(base),
            Self::Far { .. } => metres,
            Self::Star { radius_m, .. } => {
                let [.., w] = self.rows().map(|row| row.dot(base));
                let sine = (1.0 - w * w).max(1e-6).sqrt();
                // A plane is stretched away from its middle.
                let stretch = 1.0 + self.seen(base).1.length_squared();
                (stretch * (metres / radius_m).min(FRAC_PI_2).sin() / sine).min(WIDEST)
            }
        }
    }
}

/// How far ahead of a face something is whose coordinates are `own`.
fn ahead(own: [f64; 4], face: usize) -> f64 {
    if face.is_multiple_of(2) {
        own[face / 2]
    } else {
        -own[face / 2]
    }
}

/// The axes of a face's plane.
fn beside(face: usize) -> [usize; 2] {
    let axis = face / 2;
    [(axis + 1) % 3, (axis + 2) % 3]
}

/// A square on the plane of a face: what one map is a picture of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crop {
    /// The face of a star's light; 0 of one far off.
    pub face: usize,
    /// Its middle.
    pub centre: DVec2,
    /// Half its side.
    pub half: f64,
}

/// The lowest and the highest corner of a part of a face's plane.
pub type Rectangle = [DVec2; 2];

impl Light {
    /// [`Thrown::heights`] of a box on one map.
    pub fn heights(&self, strategy: &dyn Strategy, crop: &Crop, of: &Caster) -> Option<[f64; 2]> {
        self.thrown(strategy, of).heights(crop)
    }

    /// What a box throws, to be asked about several maps.
    pub fn thrown<'a>(&'a self, strategy: &'a dyn Strategy, of: &'a Caster) -> Thrown<'a> {
        let (middle, rises_m) = if self.is_ideal() {
            Self::ball_about(strategy, of)
        } else {
            (ChartPoint::new(of.chart, of.middle()), 0.0)
        };
        Thrown {
            light: self,
            strategy,
            of,
            base: self.base(strategy, middle),
            rises_m,
        }
    }

    /// The heights towards the light between which a ball lies, if any of it may fall on a crop. A star's maps hold all
    /// distances.
    pub fn ball_heights(
        &self,
        strategy: &dyn Strategy,
        crop: &Crop,
        ball: &Ball,
    ) -> Option<[f64; 2]> {
        let base = self.base(strategy, ball.middle);
        match self {
            Self::Far { .. } if self.is_ideal() => {
                let rises_m = strategy.ball_rises_m(&Eye::default(), ball.middle, ball.radius_m);
                self.heights_of(strategy, crop, (base, rises_m))
            }
            Self::Far { toward, .. } => {
                let away = (self.on_plane(0, base) - crop.centre).abs();
                let height = toward.dot(base.truncate());
                let falls = away.max_element() <= crop.half + ball.radius_m;
                falls.then_some([height - ball.radius_m, height + ball.radius_m])
            }
            // Ways of the space are no longer than those of the chart.
            Self::Star { radius_m, .. } => {
                let size = (ball.radius_m / radius_m).min(1.5).sin();
                self.is_in_sight(crop, base, size).then_some([0.0, 1.0])
            }
        }
    }

    /// Whether the square about a box's corners meets a crop, seen from a star; `true` where a corner lies behind.
    fn corners_meet(&self, strategy: &dyn Strategy, crop: &Crop, of: &Caster) -> bool {
        let [from, to] = [crop.centre - crop.half, crop.centre + crop.half];
        let rectangle = self.rectangle(strategy, crop.face, of);
        rectangle.is_none_or(|[low, high]| low.cmple(to).all() && high.cmpge(from).all())
    }

    /// A rectangle of a face's plane that holds all of a box; none where some of it lies far to the side of a star's
    /// face, or behind.
    ///
    /// Between its corners the box bulges by no more than the sagitta of its diagonal, d^2 / 8R.
    pub fn rectangle(
        &self,
        strategy: &dyn Strategy,
        face: usize,
        of: &Caster,
    ) -> Option<Rectangle> {
        let radius_m = match self {
            Self::Far { .. } if self.is_ideal() => {
                let (middle, rises_m) = Self::ball_about(strategy, of);
                let base = self.base(strategy, middle);
                let spread = self.length_on_plane(base, rises_m);
                return Some([-spread, spread].map(|by| self.on_plane(0, base) + by));
            }
            Self::Far { across, .. } => {
                let middle = ChartPoint::new(of.chart, of.middle());
                let at = self.on_plane(0, self.base(strategy, middle));
                let reach = strategy.in_common_axes(of.chart, of.reach()).abs();
                let spread = DVec2::from(across.map(|way| way.abs().dot(reach)));
                return Some([at - spread, at + spread]);
            }
            Self::Star { radius_m, .. } => *radius_m,
        };
        let bulge_m = (of.max - of.min).length_squared() / (8.0 * radius_m);
        let [mut low, mut high] = [DVec2::INFINITY, DVec2::NEG_INFINITY];
        let rows = self.rows();
        for corner in 0..8_u32 {
            let choose = |axis: usize| {
                let ends = [of.min[axis], of.max[axis]];
                ends[(corner >> axis & 1) as usize]
            };
            let pos = DVec3::new(choose(0), choose(1), choose(2));
            let base = self.base(strategy, ChartPoint::new(of.chart, pos));
            let own = rows.map(|row| row.dot(base));
            let away = DVec3::new(own[0], own[1], own[2]).length();
            let depth = ahead(own, face);
            if depth < 0.2 * away {
                return None;
            }
            let [a, b] = beside(face).map(|axis| own[axis]);
            let at = DVec2::new(a, b) / depth;
            // As in `length_on_plane`: a plane is stretched away from its middle.
            let stretch = 1.0 + at.length_squared();
            let spread = stretch * (bulge_m / radius_m).min(1.5).sin() / away.max(1e-3 * radius_m)
                * radius_m;
            low = low.min(at - spread);
            high = high.max(at + spread);
        }
        Some([low, high])
    }

    /// Whether a ball about a point, given by the sine of its radius over the space's, falls on a crop. The cone of
    /// great circles that touch it has the sine of its radius over that of its distance for its own.
    fn is_in_sight(&self, crop: &Crop, base: DVec4, size: f64) -> bool {
        let own = self.rows().map(|row| row.dot(base));
        let away = DVec3::new(own[0], own[1], own[2]).length();
        let sine = (1.0 - own[3] * own[3]).max(0.0).sqrt();
        if sine <= size {
            return true;
        }
        let cone = size / sine;
        let depth = ahead(own, crop.face) / away;
        let [a, b] = beside(crop.face).map(|axis| own[axis] / away);
        let inside = |along: f64, edge: f64, sign: f64| {
            sign * (depth * edge - along) / (1.0 + edge * edge).sqrt() >= -cone
        };
        let between = |along: f64, centre: f64| {
            inside(along, centre + crop.half, 1.0) && inside(along, centre - crop.half, -1.0)
        };
        between(a, crop.centre.x) && between(b, crop.centre.y)
    }

    /// The matrix from the base to clip coordinates of a map of `crop` that holds `heights`: depth is greater nearer
    /// to the light.
    pub fn clip(&self, crop: &Crop, heights: [f64; 2]) -> DMat4 {
        let rows = self.rows();
        let (plane, depth, w) = match self {
            Self::Far { .. } => {
                let [low, high] = [heights[0] - DEPTH_SLACK_M, heights[1] + DEPTH_SLACK_M];
                let depth = (rows[2] - rows[3] * low) / (high - low);
                ([rows[0], rows[1]], depth, rows[3])
            }
            Self::Star { radius_m, .. } => {
                let sign = if crop.face.is_multiple_of(2) {
                    1.0
                } else {
                    -1.0
                };
                let w = rows[crop.face / 2] * sign;
                let depth = w * 0.5 + rows[3] * (COTANGENT_DEPTH * radius_m);
                (beside(crop.face).map(|axis| rows[axis]), depth, w)
            }
        };
        let x = (plane[0] - w * crop.centre.x) / crop.half;
        let y = (plane[1] - w * crop.centre.y) / crop.half;
        DMat4::from_cols(x, y, depth, w).transpose()
    }

    /// Depth of a map of `crop` and `heights` for the length of a texel of `size` on its plane, where clip
    /// coordinates have w = 1.
    pub fn texel_depth(&self, crop: &Crop, heights: [f64; 2], size: u32) -> f64 {
        let texel = 2.0 * crop.half / f64::from(size);
        match self {
            Self::Far { .. } => texel / (heights[1] - heights[0] + 2.0 * DEPTH_SLACK_M),
            Self::Star { radius_m, .. } => COTANGENT_DEPTH * radius_m * texel,
        }
    }
}

/// A box in a light: what of that is the same on all maps.
#[derive(Debug)]
pub struct Thrown<'a> {
    light: &'a Light,
    strategy: &'a dyn Strategy,
    of: &'a Caster,
    /// Of its middle.
    base: DVec4,
    /// Of the ball that holds it, where the light is an ideal point.
    rises_m: f64,
}

impl Thrown<'_> {
    /// The heights towards the light between which it lies, if any of it falls on a crop. A star's maps hold all distances.
    pub fn heights(&self, crop: &Crop) -> Option<[f64; 2]> {
        let (light, base, reach) = (self.light, self.base, self.of.reach());
        match light {
            Light::Far { .. } if light.is_ideal() => {
                light.heights_of(self.strategy, crop, (base, self.rises_m))
            }
            Light::Far { toward, across, .. } => {
                let turned = self.strategy.in_common_axes(self.of.chart, reach);
                let spread = |way: &DVec3| way.abs().dot(turned.abs());
                let at = light.on_plane(0, base) - crop.centre;
                let apart = (at.x.abs() - spread(&across[0])).max(at.y.abs() - spread(&across[1]));
                let height = toward.dot(base.truncate());
                let own = spread(toward);
                (apart <= crop.half).then_some([height - own, height + own])
            }
            Light::Star { radius_m, .. } => {
                // Ways of the space are no longer than those of the chart.
                let size = (reach.length() / radius_m).min(1.5).sin();
                let is_seen = light.is_in_sight(crop, base, size)
                    && light.corners_meet(self.strategy, crop, self.of);
                is_seen.then_some([0.0, 1.0])
            }
        }
    }
}

#[cfg(test)]
mod tests;
