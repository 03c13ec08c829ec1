//! What a picture takes besides the port: what of the space may be in it, and how it is drawn.

use std::f64::consts::PI;

use glam::{DMat4, DVec2, DVec3, DVec4};

use crate::{
    BoundingCylinder, ChartId, ChartPoint, Eye, Frustum, MapShader, Projection, SightCell,
    SpaceUniform,
};

/// How pictures of a space are taken: where in them what is seen lies, how far and in which directions things are seen, what
/// is cut off, and what the shaders are told.
///
/// The law that joins this to [`crate::Map`]: for every eye and point, `view_point(eye, p)` is `chart_matrix(eye, p.chart)`
/// applied to `port(p.pos - reference(eye, p.chart))`, where `port` is the function of that name in the text of
/// [`Optics::shader`], told of [`Optics::port_origin`]. So a space in which the way to a place depends on where the eye is cannot be drawn.
pub trait Optics {
    /// Whether sight lines can miss the ground for ever, so that a sky is seen. It goes with the daylight of
    /// [`Optics::shader`]: that of a sky, or that of orbs among the land.
    fn has_sky(&self) -> bool {
        true
    }

    /// The chart point that positions sent to the GPU are relative to.
    fn reference(&self, eye: &Eye, _chart: ChartId) -> DVec3 {
        eye.point.pos
    }

    /// Nothing farther from the eye than this is drawn, in metres of the space.
    fn sight_limit_m(&self, _eye: &Eye) -> f64 {
        f64::INFINITY
    }

    /// Whether part of the chart box from `min` to `max` metres lies beyond what its chart draws,
    /// so that it must be trimmed.
    fn trims(&self, _eye: &Eye, _chart: ChartId, _min: DVec3, _max: DVec3) -> bool {
        false
    }

    /// The directions in which the chart box from `min` to `max` metres is seen.
    fn sight_cell(&self, eye: &Eye, chart: ChartId, min: DVec3, max: DVec3) -> SightCell;

    /// A cell for all boxes in an upright bounding cylinder: if it is not seen, none of the boxes is. It holds for
    /// boxes whose surrounding circles lie in the bounding cylinder.
    ///
    /// A bounding cylinder is seen at the azimuths of its circle, and as high and low as the square around it.
    fn sight_cell_of(&self, eye: &Eye, cylinder: &BoundingCylinder) -> SightCell {
        let half = DVec3::new(cylinder.radius_m, 0.0, cylinder.radius_m);
        let [min, max] = cylinder.square(half);
        let away = cylinder.middle - DVec2::new(eye.point.pos.x, eye.point.pos.z);
        let apart = away.length() > cylinder.radius_m;
        SightCell {
            azimuth_rad: away.y.atan2(away.x),
            half_width_rad: if apart {
                (cylinder.radius_m / away.length()).asin()
            } else {
                PI
            },
            ..self.sight_cell(eye, cylinder.chart, min, max)
        }
    }

    /// How far a ball of the chart about a point reaches to either side of a totally geodesic sheet through that point,
    /// at most, in view coordinates: there it is `R sinh (d / R)`, d or `R sin (d / R)` for d metres of the space.
    ///
    /// A point of the ball is joined to its middle inside it, and in the space by no more than that length times the
    /// most that the port stretches there. A sheet through the eye with the unit normal n holds `n . view = 0`, and what
    /// is d beside it has `n . view = R sinh (d / R)`: so the ball is behind it where `n . view` of its middle is less
    /// than minus this.
    fn ball_rises_m(&self, _eye: &Eye, _middle: ChartPoint, radius_m: f64) -> f64 {
        radius_m
    }

    /// Whether azimuths about the eye in the chart are those of the picture, so that level
    /// distances tell which of two things in one direction is in front.
    fn keeps_azimuths(&self) -> bool {
        true
    }

    /// The visible region, which cells are tested against.
    fn frustum(&self, eye: &Eye, projection: &Projection) -> Frustum {
        Frustum::new(eye, projection, self.sight_limit_m(eye))
    }

    /// A point of the picture: clip coordinates of a point in view coordinates.
    fn clip_from_view(&self, eye: &Eye, projection: &Projection, view: DVec4) -> DVec4;

    /// What is applied to the ported point, xyz in metres and w without unit, to have view coordinates. Where
    /// [`Optics::port_origin`] matters, to a point of the model about the middle of the eye's chart.
    fn view_matrix(&self, eye: &Eye) -> DMat4;

    /// The isometry, applied after the port, that takes the model of a chart to that of the first one; xyz in metres and
    /// w without unit. Under a sky it is a turn about the upright, by which the shaders turn directions, too.
    ///
    /// It is for worlds whose charts lie near the first: in hyperbolic space it grows as e^d with the distance d from there.
    /// Such a space gives [`Optics::chart_matrix`] by the short way from the eye's chart.
    fn home_matrix(&self, _chart: ChartId) -> DMat4 {
        DMat4::IDENTITY
    }

    /// What is applied to a ported point of a chart to have view coordinates: [`Optics::view_matrix`] of that chart.
    fn chart_matrix(&self, eye: &Eye, chart: ChartId) -> DMat4 {
        self.view_matrix(eye) * self.home_matrix(chart)
    }

    /// What is applied to a ported point of a chart to have it in the model in which the light of the day is told: that of the
    /// first chart or, where [`crate::shader::Daylight::has_axes`] does not hold and there is a sky, that about the middle of
    /// the eye's chart, xyz in metres.
    fn light_matrix(&self, _eye: &Eye, chart: ChartId) -> DMat4 {
        self.home_matrix(chart)
    }

    /// From the model about the middle of a chart to that of another, as [`Optics::light_matrix`] has them: the identity where
    /// all charts have one model.
    fn between(&self, _from: ChartId, _to: ChartId) -> DMat4 {
        DMat4::IDENTITY
    }

    /// Where [`Optics::reference`] lies in its chart, as the text of the map asks for it: `Space` of `shaders/geometry.wgsl`.
    fn port_origin(&self, _eye: &Eye, _chart: ChartId) -> DVec4 {
        DVec4::ZERO
    }

    /// What the shaders of its map are.
    fn shader(&self) -> &'static MapShader;

    /// What the shaders need to know of the space, the eye and the projection.
    fn uniform(&self, eye: &Eye, projection: &Projection) -> SpaceUniform;
}
