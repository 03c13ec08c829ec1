//! Flat space: the chart itself, seen with an ordinary camera.

use glam::{DMat3, DMat4, DVec3, DVec4};

use crate::projection::Depth;
use crate::sight::Axis;
use crate::{
    Atlas, ChartId, ChartPoint, Curvature, Eye, Map, MapShader, Metric, Optics, Projection,
    SightCell, SpaceUniform, ViewMode, shader,
};

/// Flat space.
#[derive(Debug, Clone, Copy, Default)]
pub struct Euclidean;

/// The camera's rotation: chart directions to (right, up, back).
pub(crate) fn rotation(eye: &Eye) -> DMat3 {
    DMat3::from_cols(eye.right(), eye.up(), -eye.front()).transpose()
}

impl Atlas for Euclidean {}

impl Map for Euclidean {
    fn view_modes(&self) -> &'static [ViewMode] {
        &[ViewMode::Plain, ViewMode::Bent]
    }

    fn view_point(&self, eye: &Eye, point: ChartPoint) -> DVec4 {
        eye.to_view(point.pos - eye.point.pos).extend(1.0)
    }

    fn chart_point(&self, eye: &Eye, view: DVec4) -> ChartPoint {
        ChartPoint::a(eye.point.pos + eye.to_chart(view.truncate()))
    }

    fn along(&self, eye: &Eye, direction: DVec3, distance_m: f64) -> ChartPoint {
        self.chart_point(eye, (direction * distance_m).extend(1.0))
    }

    fn curved(&self, _eye: &Eye, point: ChartPoint) -> DVec4 {
        point.pos.extend(1.0)
    }

    fn port_normal(&self, _eye: &Eye, _point: ChartPoint, normal: DVec3) -> DVec3 {
        normal.normalize_or_zero()
    }
}

impl Metric for Euclidean {
    fn curvature(&self) -> Curvature {
        Curvature::FLAT
    }

    fn distance_m(&self, a: ChartPoint, b: ChartPoint, _eye: &Eye) -> f64 {
        a.pos.distance(b.pos)
    }
}

impl Optics for Euclidean {
    fn sight_cell(&self, eye: &Eye, _chart: ChartId, min: DVec3, max: DVec3) -> SightCell {
        let (low, high) = (min - eye.point.pos, max - eye.point.pos);
        Axis::new(0.0, 0.0).cell_of_box(low, high, f64::INFINITY, f64::INFINITY)
    }

    fn clip_from_view(&self, _eye: &Eye, projection: &Projection, view: DVec4) -> DVec4 {
        projection.clip(Depth::Reciprocal, view)
    }

    fn view_matrix(&self, eye: &Eye) -> DMat4 {
        DMat4::from_mat3(rotation(eye))
    }

    fn uniform(&self, eye: &Eye, projection: &Projection) -> SpaceUniform {
        let view = self.view_matrix(eye);
        SpaceUniform::new(view, projection, f64::INFINITY, 0.0, 0.0)
    }

    fn shader(&self) -> &'static MapShader {
        &shader::FLAT
    }
}
