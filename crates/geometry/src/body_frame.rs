//! The space about a body as it moves in it: metres of the space from where it is, at its own height.
//!
//! It is [`BodyChart`] with the body at the origin and level lengths scaled by `C(y/R)` of the body's height, so that a metre
//! of it is a metre of the space at the body, in all directions. Level axes are those of the world's frame there, in which
//! headings and velocities are told. Heights are kept to the bit, and so is a place from which nothing goes level.

use glam::{DVec3, Vec3Swizzles};

use crate::spherical::Foot;
use crate::{BodyChart, ChartPoint, Crossing, Strategy, Viewer};

/// Level lengths are not scaled by less than this, so that nothing is infinite a quarter turn up a sphere.
const LEAST_STRETCH: f64 = 0.05;

/// The space about a body at a place, of worlds whose bodies do not move in the chart itself.
#[derive(Debug, Clone, Copy)]
pub struct BodyFrame<'a> {
    space: &'a dyn Strategy,
    chart: BodyChart<'a>,
    /// On a globe, whose charts are known: bodies ask so much that closed forms are worth it.
    globe: Option<Foot>,
    at: ChartPoint,
    radius_m: f64,
    stretch: f64,
}

impl<'a> BodyFrame<'a> {
    /// About a body's place; none where bodies move in the chart ([`crate::Metric::moves_in_chart`]), whose metres are then its
    /// own.
    pub fn of(space: &'a dyn Strategy, at: ChartPoint) -> Option<Self> {
        if space.moves_in_chart() {
            return None;
        }
        let chart = BodyChart::new(space, at);
        let stretch = chart.level_stretch(at.pos.y).max(LEAST_STRETCH);
        let radius_m = space.radius_m();
        let is_globe = space.globe().is_some();
        Some(Self {
            space,
            chart,
            globe: is_globe.then(|| Foot::at(at.pos.xz() / radius_m)),
            at,
            radius_m,
            stretch,
        })
    }

    /// Where places of the body's own chart of the world are, from the body, in metres of the space: to be asked of one place
    /// after another.
    pub fn offsets(&self) -> impl Fn(DVec3) -> DVec3 + use<'_> {
        let mapped = self.globe.is_none().then(|| self.chart.plane_viewer());
        let (per_m, scale) = (self.radius_m.recip(), self.radius_m * self.stretch);
        move |pos| {
            let up_m = pos.y - self.at.pos.y;
            if let Some(foot) = &self.globe {
                let level = foot.offset(pos.xz() * per_m) * scale;
                return DVec3::new(level.x, up_m, level.y);
            }
            let point = ChartPoint::new(self.at.chart, pos.with_y(0.0));
            let level = mapped.as_ref().map_or(DVec3::ZERO, |mapped| mapped(point));
            (level * self.stretch).with_y(up_m)
        }
    }

    /// The way from one place to another as a body at the first has it: metres of the space as long as it is level, and of the
    /// chart where bodies move in that. The shortest way leads along it.
    pub fn way(space: &dyn Strategy, from: ChartPoint, to: ChartPoint) -> DVec3 {
        let to = if from.chart == to.chart {
            to
        } else {
            space.carry_near(to, from).map_or(to, |over| over.point)
        };
        BodyFrame::of(space, from).map_or(to.pos - from.pos, |frame| frame.offsets()(to.pos))
    }

    /// Where a body comes to that goes such a way, and the turn that its directions take; in its chart, past the edge too.
    pub fn step(space: &dyn Strategy, from: ChartPoint, way_m: DVec3) -> Crossing {
        BodyFrame::of(space, from).map_or_else(
            || Crossing::within(from.moved(way_m)),
            |frame| frame.arrival(way_m),
        )
    }

    /// How much farther than here one gets along the plane by a level metre so far over here, metres.
    pub fn level_share(&self, over_m: f64) -> f64 {
        let there = self.chart.level_stretch(self.at.pos.y + over_m);
        self.stretch / there.max(LEAST_STRETCH)
    }

    /// A box of the body's chart of the world that holds all within a box about the body, metres of the space from it, a few
    /// metres wide at most. What the chart's axes bend by within it is allowed for: the square of its width over the radius.
    pub fn chart_box(&self, low: DVec3, high: DVec3) -> (DVec3, DVec3) {
        let [x, z] = [DVec3::X, DVec3::Z].map(|axis| self.in_chart(axis));
        let [middle, half] = [0.5 * (low + high), 0.5 * (high - low)];
        let centre = self.at.pos + x * middle.x + z * middle.z;
        let farthest = low.abs().max(high.abs()).with_y(0.0).length() / self.stretch;
        let level = x.abs() * half.x + z.abs() * half.z;
        let bend = farthest * farthest / self.radius_m;
        let reach = DVec3::new(level.x + bend, half.y, level.z + bend);
        let centre = centre.with_y(self.at.pos.y + middle.y);
        (centre - reach, centre + reach)
    }

    /// A short way from the body (m of the space, or m/s) as the body's chart of the world has it.
    pub fn in_chart(&self, way: DVec3) -> DVec3 {
        let Some(foot) = &self.globe else {
            return self.space.in_chart(self.at, way);
        };
        let level = foot.in_chart(way.xz() / self.stretch);
        DVec3::new(level.x, way.y, level.y)
    }

    /// A normal of the body's chart of the world as a unit normal of the space: what is square to it stays so, as the product
    /// with any way is that of the way in the chart.
    pub fn normal(&self, normal: DVec3) -> DVec3 {
        let columns = DVec3::AXES.map(|axis| self.in_chart(axis));
        DVec3::from_array(columns.map(|it| it.dot(normal))).normalize_or(DVec3::Y)
    }

    /// Where a body is that has come so far from here, metres of the space, and the turn that its directions take, told in the
    /// frame here, to be told in the frame there. It stays in its chart of the world, past the edge too; who crosses is carried
    /// after that ([`crate::Atlas::cross`]).
    pub fn arrival(&self, off: DVec3) -> Crossing {
        let height_m = self.at.pos.y + off.y;
        let level = off.with_y(0.0) / self.stretch;
        if level == DVec3::ZERO {
            return Crossing::within(ChartPoint::new(self.at.chart, self.at.pos.with_y(height_m)));
        }
        if let Some(foot) = &self.globe {
            let (place, turn_rad) = foot.arrival(level.xz() / self.radius_m);
            let place = place * self.radius_m;
            let pos = DVec3::new(place.x, height_m, place.y);
            let point = ChartPoint::new(self.at.chart, pos);
            return Crossing { point, turn_rad };
        }
        let mut arrival = self.chart.arrival(level);
        if arrival.point.chart != self.at.chart
            && let Some(kept) = self.space.carry(arrival.point, self.at.chart)
        {
            arrival = Crossing {
                turn_rad: arrival.turn_rad + kept.turn_rad,
                ..kept
            };
        }
        arrival.point.pos.y = height_m;
        arrival
    }
}

/// Where points of the world are on the plane of a body's chart, metres.
pub(crate) fn plane_place(
    viewer: &Viewer<'_>,
    radius_m: f64,
    sign: f64,
    point: ChartPoint,
) -> DVec3 {
    let view = viewer(point);
    // The foot looks along +x: what is right of it is +z, and what is behind it -x.
    let (x, z) = (-view.z, view.x);
    let level = x.hypot(z);
    let scale = if level <= 0.0 || sign == 0.0 {
        1.0
    } else if sign > 0.0 {
        (level / radius_m).atan2(view.w) * radius_m / level
    } else {
        (level / radius_m).asinh() * radius_m / level
    };
    DVec3::new(x * scale, 0.0, z * scale)
}
