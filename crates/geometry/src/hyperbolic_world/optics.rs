//! How pictures of the world are taken.

use std::cell::Cell;
use std::f64::consts::PI;

use glam::{DMat4, DVec2, DVec3, DVec4, Vec3Swizzles};

use super::chart::HIGH_RAD;
use super::plan::plan;
use super::world::{HyperbolicWorld, inverse};
use crate::projection::Depth;
use crate::sight::Axis;
use crate::{
    Atlas, BoundingCylinder, ChartId, ChartPoint, Eye, MapShader, Metric, Optics, Projection,
    SightCell, SpaceUniform, shader,
};

/// Nothing farther than this is drawn, in radii. There a hill of 10 m is a tenth of a pixel high, and within are 7500 tiles; one
/// radius more would be 2.7 times as many.
const SIGHT_RAD: f64 = 8.0;
/// Vertices are rounded to a little less than this, metres.
const ROUNDED_M: f64 = 1e-4;
/// Eyes higher than so many radii over the plane see everything.
const HIGHEST_EYE_RAD: f64 = 6.0;

/// All that [`HyperbolicWorld::foot_sight`] follows from: the radius, x and z by their bits, and the charts.
type FootSight = ([u64; 3], [ChartId; 2]);

impl HyperbolicWorld {
    /// A box of a chart as far as the chart is written; none where that leaves nothing.
    fn written(&self, min: DVec3, max: DVec3) -> Option<[DVec3; 2]> {
        let reach_m = self.chart.reach_m();
        let limit = DVec3::new(reach_m, f64::INFINITY, reach_m);
        let (low, high) = (min.max(-limit), max.min(limit));
        (low.x <= high.x && low.z <= high.z).then_some([low, high])
    }

    /// The corners of a box of a chart's ground plan, in their order, and their mean, in the disc about a place's foot; none where one
    /// of the charts is not there.
    pub(super) fn plan_corners(
        &self,
        at: ChartPoint,
        chart: ChartId,
        low: DVec2,
        high: DVec2,
    ) -> Option<([DVec2; 4], DVec2)> {
        let sight = self.foot_sight(at, chart)?;
        // A multiple of the point has the same place in the disc: (tanh x, 0, tanh z, 1).
        let tanh = |it: DVec2| (it / self.chart.radius_m).to_array().map(f64::tanh);
        let disc = |[a, b]: [f64; 2]| {
            let at = sight * DVec4::new(a, 0.0, b, 1.0);
            DVec2::new(at.x, at.z) / at.w
        };
        let ([x, z], [far_x, far_z]) = (tanh(low), tanh(high));
        let corners = [[x, z], [far_x, z], [far_x, far_z], [x, far_z]].map(disc);
        Some((corners, 0.25 * corners.into_iter().sum::<DVec2>()))
    }

    /// From the model of a chart to the frame at a place's foot; none where one of the charts is not there. A frame asks about each
    /// chart many times in a row, and most of a cell would be this.
    fn foot_sight(&self, at: ChartPoint, chart: ChartId) -> Option<DMat4> {
        thread_local! {
            static LAST: Cell<Option<(FootSight, DMat4)>> = const { Cell::new(None) };
        }
        let [x, z] = at.pos.xz().to_array().map(f64::to_bits);
        let asked = ([self.chart.radius_m.to_bits(), x, z], [chart, at.chart]);
        if let Some((_, known)) = LAST.get().filter(|(of, _)| *of == asked) {
            return Some(known);
        }
        let foot = self.chart.frame(at.pos.with_y(0.0));
        let sight = inverse(foot) * self.tiles.way(chart, at.chart)?;
        LAST.set(Some((asked, sight)));
        Some(sight)
    }

    /// A place as high as eyes can be; what is no number counts as 0.
    fn within_heights(&self, pos: DVec3) -> DVec3 {
        let most_m = HIGH_RAD * self.chart.radius_m;
        let y = if pos.y.is_nan() { 0.0 } else { pos.y };
        pos.with_y(y.clamp(-most_m, most_m))
    }

    /// A matrix on the model in radii, on one with xyz in metres and w without unit.
    fn metres(&self, matrix: DMat4) -> DMat4 {
        let radius_m = self.chart.radius_m;
        let metres = DVec4::new(radius_m, radius_m, radius_m, 1.0);
        DMat4::from_diagonal(metres) * matrix * DMat4::from_diagonal(metres.recip())
    }
}

/// Of the port, [`Optics::reference`] is the eye's own place wherever the chart is written there, so that near the eye nothing
/// cancels; farther off it is over the chart's middle, as high as the eye.
impl Optics for HyperbolicWorld {
    fn reference(&self, eye: &Eye, chart: ChartId) -> DVec3 {
        let place = self.carry(eye.point, chart).map(|it| it.point.pos);
        let reach = DVec2::splat(self.chart.reach_m());
        let written = place.filter(|it| it.xz().abs().cmple(reach).all());
        self.within_heights(written.unwrap_or(eye.point.pos * DVec3::Y))
    }

    fn sight_limit_m(&self, _eye: &Eye) -> f64 {
        SIGHT_RAD * self.chart.radius_m
    }

    /// Squares end where chunks do: what reaches over that by no more than vertices are rounded to is not cut.
    fn trims(&self, _eye: &Eye, chart: ChartId, min: DVec3, max: DVec3) -> bool {
        self.domain(chart).most_outside_m(min.xz(), max.xz()) > ROUNDED_M
    }

    /// Of what the chart is written for.
    fn sight_cell(&self, eye: &Eye, chart: ChartId, min: DVec3, max: DVec3) -> SightCell {
        let radius_m = self.chart.radius_m;
        if eye.point.pos.y.abs() > HIGHEST_EYE_RAD * radius_m {
            return SightCell::EVERYWHERE;
        }
        let Some([min, max]) = self.written(min, max) else {
            return SightCell::NOWHERE;
        };
        let Some((corners, middle)) = self.plan_corners(eye.point, chart, min.xz(), max.xz())
        else {
            return SightCell::NOWHERE;
        };
        let plan = plan(corners, middle, radius_m);
        Axis::new(-radius_m.powi(-2), eye.point.pos.y).cell(&plan, [min.y, max.y])
    }

    fn sight_cell_of(&self, eye: &Eye, cylinder: &BoundingCylinder) -> SightCell {
        let [min, max] = cylinder.square(DVec3::new(cylinder.radius_m, 0.0, cylinder.radius_m));
        self.sight_cell(eye, cylinder.chart, min, max)
    }

    /// A metre of the chart is at most so long as at the corner of the ball's surroundings farthest out and highest.
    fn ball_rises_m(&self, _eye: &Eye, middle: ChartPoint, radius_m: f64) -> f64 {
        let highest = (middle.pos.y.abs() + radius_m) / self.chart.radius_m;
        let stretch = self.chart.most_stretch(middle.pos, radius_m) * highest.cosh();
        self.chart.radius_m * (radius_m * stretch / self.chart.radius_m).sinh()
    }

    /// Those of other charts are not.
    fn keeps_azimuths(&self) -> bool {
        false
    }

    /// `d` in its `n/d` is R sinh of the distance along the ray ahead: it falls to any distance, and is linear over triangles,
    /// whose planes the port keeps.
    fn clip_from_view(&self, _eye: &Eye, projection: &Projection, view: DVec4) -> DVec4 {
        projection.clip(Depth::Reciprocal, view)
    }

    fn view_matrix(&self, eye: &Eye) -> DMat4 {
        self.metres(inverse(self.pose(eye)))
    }

    /// From far charts it is large and of no use to `f32`; what is drawn goes by [`Optics::chart_matrix`].
    fn home_matrix(&self, chart: ChartId) -> DMat4 {
        let way = self.tiles.way(chart, ChartId::FIRST);
        self.metres(way.unwrap_or(DMat4::IDENTITY))
    }

    /// By the short way from the eye's chart. What is in a chart that is not there is taken behind the eye.
    fn chart_matrix(&self, eye: &Eye, chart: ChartId) -> DMat4 {
        let behind = DMat4::from_rotation_y(PI);
        let sight = self.sight(eye, chart);
        let own = |sight| sight * self.chart.frame(self.reference(eye, chart));
        self.metres(sight.map_or(behind, own))
    }

    fn light_matrix(&self, eye: &Eye, chart: ChartId) -> DMat4 {
        let way = self.tiles.way(chart, eye.point.chart);
        let own = self.chart.frame(self.reference(eye, chart));
        self.metres(way.unwrap_or(DMat4::IDENTITY) * own)
    }

    fn between(&self, from: ChartId, to: ChartId) -> DMat4 {
        let way = self.tiles.way(from, to);
        self.metres(way.unwrap_or(DMat4::IDENTITY))
    }

    /// X/W and Z/W of the reference, and its W on the ground.
    fn port_origin(&self, eye: &Eye, chart: ChartId) -> DVec4 {
        let at = self.chart.point(self.reference(eye, chart).with_y(0.0));
        DVec4::new(at.x / at.w, at.z / at.w, at.w, 0.0)
    }

    fn uniform(&self, eye: &Eye, projection: &Projection) -> SpaceUniform {
        let view = self.view_matrix(eye);
        let height = self.reference(eye, eye.point.chart).y / self.chart.radius_m;
        SpaceUniform::new(view, projection, self.radius_m(), -1.0, height)
    }

    fn shader(&self) -> &'static MapShader {
        &shader::SQUARES
    }
}
