//! Maps points of charts to view coordinates of an eye, and back.

use glam::{DVec3, DVec4};

use crate::{ChartPoint, Eye, ViewMode};

/// The range of the knob that a space offers the player.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dial {
    /// Least value.
    pub min: f64,
    /// Greatest value.
    pub max: f64,
    /// Value of a new world.
    pub default: f64,
}

/// View coordinates of chart points, for one eye.
pub type Viewer<'a> = Box<dyn Fn(ChartPoint) -> DVec4 + 'a>;

/// How the charts lie in the space as an eye sees it: each point of a chart in view coordinates, and each place in view as
/// a point of a chart. View coordinates are x right, y up, z back, in metres, and w without unit.
pub trait Map {
    /// Through what a world of this space can be looked at: first as a new world is, and as all but the player always see
    /// it.
    fn view_modes(&self) -> &'static [ViewMode] {
        &[ViewMode::Plain]
    }

    /// The point as seen: view coordinates with the eye at (0, 0, 0, 1).
    fn view_point(&self, eye: &Eye, point: ChartPoint) -> DVec4;

    /// [`Map::view_point`] of one point after another: what depends on the eye alone is worked out once.
    fn viewer<'a>(&'a self, eye: &'a Eye) -> Viewer<'a> {
        Box::new(move |point| self.view_point(eye, point))
    }

    /// The chart point that is seen at `view`: the inverse of [`Map::view_point`].
    fn chart_point(&self, eye: &Eye, view: DVec4) -> ChartPoint;

    /// The point `distance_m` metres along the geodesic that leaves the eye in `direction`, a
    /// unit vector in view coordinates (right, up, back); (0, 0, -1) is straight ahead.
    fn along(&self, eye: &Eye, direction: DVec3, distance_m: f64) -> ChartPoint;

    /// The point on the model: (x, y, z, 1) in metres where the space is flat; in radii the hyperboloid or the unit
    /// three-sphere. Maps that slide the world under the eye (raised, horizon) give it relative to the eye; others
    /// ignore the eye.
    fn curved(&self, eye: &Eye, point: ChartPoint) -> DVec4;

    /// A surface normal of the chart as a unit covector of the space, in the coordinates of
    /// the chart's frame at the point: its dot product with a light's chart direction is N.L.
    fn port_normal(&self, eye: &Eye, point: ChartPoint, normal: DVec3) -> DVec3;
}
