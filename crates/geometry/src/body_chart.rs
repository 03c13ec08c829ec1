//! A chart of a body's own: the ground about it, true to length where it stands.
//!
//! It is the cylindrical chart ([`crate::charts::cylindrical`]) about the body's foot, on the plane y = 0 right below or above
//! it: straight lines through the body are geodesics of that plane, carried up, and level lengths at its height y are the
//! same in all directions, `C(y/R)` metres of the space for each of the chart; C is the cosine of the space's curvature, S
//! its sine. At a distance r along the plane a length across the way out is `S(r/R)/(r/R)` times as long as here: at 10 m
//! 1.0046 in hyperbolic space of R = 60 m, 0.984 on a sphere of 32 m. So a body that walks, jumps and turns in it goes as fast
//! and as straight as it should wherever it is, and a step from one chart of the world to another is a change of address.
//!
//! The world's own charts need only tell where a point is seen ([`Map::view_point`]) and the inverse, in a space whose
//! picture does not depend on the eye's dial: hyperbolic in squares, flat, or a sphere. Through the lens of a hyperbolic
//! world, land is flat, and this is not for it.

use glam::{DVec3, DVec4};

use crate::body_frame::plane_place;
use crate::charts::cylindrical;
use crate::scalar::{atan_k, cos_s, sinc_s};
use crate::{ChartPoint, Crossing, Curvature, Eye, Strategy};

/// How far behind a body the place lies by which it is told how charts are turned, in radii: as far as its direction is exact.
const BACK_RAD: f64 = 0.25;
/// The same where space is flat, metres.
const BACK_M: f64 = 16.0;

/// The chart of a body at a place. It holds no more than where the body is and what the space is, and is made anew when the
/// body has moved.
#[derive(Debug, Clone, Copy)]
pub struct BodyChart<'a> {
    space: &'a dyn Strategy,
    /// Level, at the foot, looking along +x of the frame there.
    foot: Eye,
    curvature: Curvature,
}

impl<'a> BodyChart<'a> {
    /// About a body's place, whose height does not matter. Axes are those of the frame at the foot, in which directions of
    /// the world's chart at the body are told, too.
    pub fn new(space: &'a dyn Strategy, body: ChartPoint) -> Self {
        let foot = Eye {
            point: ChartPoint::new(body.chart, body.pos.with_y(0.0)),
            ..Eye::default()
        };
        Self {
            space,
            foot,
            curvature: space.curvature(),
        }
    }

    /// Where points on the plane y = 0 are in this chart: [`Self::pos`] of one after another, for which what depends on the foot
    /// alone is worked out once.
    pub(crate) fn plane_viewer(&self) -> impl Fn(ChartPoint) -> DVec3 + use<'_> {
        let viewer = self.space.viewer(&self.foot);
        let Curvature { sign, radius_m, .. } = self.curvature;
        move |point| plane_place(&viewer, radius_m, sign, point)
    }

    /// How many metres of the space a level metre of the chart is at a height in metres, over the foot: `C(y/R)`, not
    /// less than 0.
    pub fn level_stretch(&self, height_m: f64) -> f64 {
        let c = self.curvature;
        cos_s(c.sign, height_m * c.per_m).max(0.0)
    }

    /// How many times as long as near the foot a level length across the way out is at a distance along the plane, metres:
    /// how far the chart is from true there.
    pub fn stretch_across(&self, away_m: f64) -> f64 {
        let c = self.curvature;
        sinc_s(c.sign, away_m * c.per_m)
    }

    /// Where a point of the world is in this chart: metres, y the height over the plane. Off by 1e-15 radii times the cosh
    /// of its distance.
    pub fn pos(&self, point: ChartPoint) -> DVec3 {
        let c = self.curvature;
        let view = self.space.view_point(&self.foot, point);
        let at = self.foot.to_chart(view.truncate());
        let level = at.x.hypot(at.z);
        let (y, r) = if c.sign > 0.0 {
            let kappa = c.per_m2();
            let out = level.hypot(view.w * c.radius_m) * c.per_m;
            (atan_k(kappa, at.y, out), atan_k(kappa, level, view.w))
        } else if c.sign < 0.0 {
            let [sinh_y, sinh_r] = [at.y, level].map(|it| it * c.per_m);
            let sinh_r = sinh_r / 1.0_f64.hypot(sinh_y);
            (sinh_y.asinh() * c.radius_m, sinh_r.asinh() * c.radius_m)
        } else {
            (at.y, level)
        };
        let scale = if level > 0.0 { r / level } else { 1.0 };
        DVec3::new(at.x * scale, y, at.z * scale)
    }

    /// The point of the world at a place in this chart, in the world's chart that it belongs to: the inverse of
    /// [`Self::pos`]. On a sphere places farther than half round, or higher than a quarter, come round.
    pub fn point(&self, pos: DVec3) -> ChartPoint {
        let c = self.curvature;
        let at = if c.sign == 0.0 {
            pos.extend(1.0)
        } else {
            let unit = cylindrical(c.sign, pos * c.per_m);
            (unit.truncate() * c.radius_m).extend(unit.w)
        };
        let view: DVec4 = self.foot.to_view(at.truncate()).extend(at.w);
        self.space.chart_point(&self.foot, view)
    }

    /// The point of the world at a place in this chart, and the turn that directions take which are told in this chart's frame
    /// there, to be told in the frame of that point: as in [`Crossing`], of a heading, a velocity and an orientation.
    ///
    /// A place behind the foot, on the line through both, is straight back in this chart. As the other has its direction, so
    /// are all turned.
    pub fn arrival(&self, pos: DVec3) -> Crossing {
        let point = self.point(pos);
        let level = pos.with_y(0.0);
        let ahead = level.normalize_or(DVec3::X);
        let back_m = if self.curvature.sign == 0.0 {
            BACK_M
        } else {
            BACK_RAD * self.curvature.radius_m
        };
        let behind = self.point(-ahead * back_m);
        let there = Eye {
            point: ChartPoint::new(point.chart, point.pos.with_y(0.0)),
            ..Eye::default()
        };
        let view = self.space.view_point(&there, behind);
        let seen = -there.to_chart(view.truncate());
        let sin = ahead.x * seen.z - ahead.z * seen.x;
        let cos = ahead.x * seen.x + ahead.z * seen.z;
        Crossing {
            point,
            turn_rad: -sin.atan2(cos),
        }
    }

    /// Where a body comes to that goes from a place by a way in metres of the space as it is at its height, along the frame
    /// there; y is up. Straight on it is a geodesic of the level, whatever charts of the world it leads over. Vectors of the
    /// body are to be turned by the turn. As long as it would not cross ([`crate::Atlas::cross`]) it keeps its chart.
    pub fn step(space: &'a dyn Strategy, from: ChartPoint, way_m: DVec3) -> Crossing {
        let chart = Self::new(space, from);
        let stretch = chart.level_stretch(from.pos.y);
        let level = if stretch > 0.0 {
            way_m / stretch
        } else {
            DVec3::ZERO
        };
        let arrival = chart.arrival(level.with_y(from.pos.y + way_m.y));
        if arrival.point.chart == from.chart {
            return arrival;
        }
        let kept = space.carry(arrival.point, from.chart);
        match kept.filter(|it| space.cross(it.point).is_none()) {
            Some(kept) => Crossing {
                turn_rad: arrival.turn_rad + kept.turn_rad,
                ..kept
            },
            None => arrival,
        }
    }
}
