//! The one trait through which the game knows its space.

use std::f64::consts::PI;
use std::fmt::Debug;
use std::ops::RangeInclusive;
use std::sync::Arc;

use glam::{DMat4, DVec2, DVec3, DVec4};

use crate::kernel::distance;
use crate::{
    Atlas, ChartId, ChartPoint, Drum, Euclidean, Eye, Frustum, Geometry, Horizon, HyperbolicMap,
    MapShader, Projection, Raised, SightCell, SpaceUniform, Spherical,
};

/// Radius of curvature of hyperbolic worlds unless a world says otherwise, in metres.
pub const DEFAULT_HYPERBOLIC_RADIUS_M: f64 = 20.0;
/// Radius of spherical worlds unless a world says otherwise, in metres.
pub const DEFAULT_SPHERE_RADIUS_M: f64 = 32.0;
/// Radii that a player may choose for a spherical world, in metres.
pub const SPHERE_RADIUS_RANGE_M: RangeInclusive<f64> = 16.0..=256.0;
/// Hyperbolic worlds draw nothing farther than this many radii from the eye: past it a
/// hyperboloid coordinate in `f32` has no digits left to order two surfaces by.
pub const FAR_LIMIT_RADII: f64 = 20.0;

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

/// A space: how chart points look from an eye, and what the charts are like.
///
/// View coordinates are x right, y up, z back, in metres, and w without unit.
pub trait Strategy: Atlas + Debug + Send + Sync {
    /// Which of the three spaces this is.
    fn geometry(&self) -> Geometry;

    /// The world's own radius of curvature in metres; infinite in flat space.
    fn radius_m(&self) -> f64;

    /// The world's own curvature per square metre: negative in hyperbolic space, positive in spherical.
    fn curvature_per_m2(&self) -> f64 {
        let magnitude = self.radius_m().powi(-2);
        match self.geometry() {
            Geometry::Hyperbolic => -magnitude,
            Geometry::Euclidean | Geometry::Spherical => magnitude,
        }
    }

    /// Radius of curvature of the picture in metres, at the eye's dial.
    fn radius_at_m(&self, _eye: &Eye) -> f64 {
        self.radius_m()
    }

    /// The player's knob, where the space has one.
    fn dial(&self) -> Option<Dial> {
        None
    }

    /// The point as seen: view coordinates with the eye at (0, 0, 0, 1).
    fn view_point(&self, eye: &Eye, point: ChartPoint) -> DVec4;

    /// [`Strategy::view_point`] of one point after another: what depends on the eye alone is worked out once.
    fn viewer<'a>(&'a self, eye: &'a Eye) -> Viewer<'a> {
        Box::new(move |point| self.view_point(eye, point))
    }

    /// The chart point that is seen at `view`: the inverse of [`Strategy::view_point`].
    fn chart_point(&self, eye: &Eye, view: DVec4) -> ChartPoint;

    /// The point `distance_m` metres along the geodesic that leaves the eye in `direction`, a
    /// unit vector in view coordinates (right, up, back); (0, 0, -1) is straight ahead.
    fn along(&self, eye: &Eye, direction: DVec3, distance_m: f64) -> ChartPoint;

    /// Distance in the space between two points, in metres. In hyperbolic worlds it depends
    /// on the eye, as the port does.
    fn distance_m(&self, a: ChartPoint, b: ChartPoint, eye: &Eye) -> f64;

    /// Distance in the space from the eye to a point in view coordinates, in metres.
    fn eye_distance_m(&self, eye: &Eye, view: DVec4) -> f64;

    /// The point of the model in units of the radius, before any camera: (x, y, z, 1) in chart
    /// metres where the space is flat, the hyperboloid, or the unit three-sphere.
    fn curved(&self, eye: &Eye, point: ChartPoint) -> DVec4;

    /// A surface normal of the chart as a unit covector of the space, in the coordinates of
    /// the chart's frame at the point: its dot product with a light's chart direction is N.L.
    fn port_normal(&self, eye: &Eye, point: ChartPoint, normal: DVec3) -> DVec3;

    /// Whether sight lines can miss the ground for ever, so that a sky is seen.
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

    /// A cell that holds those of all chart boxes inside an upright drum whose circles about their
    /// own middles are inside too, so that a drum that is not seen tells that none of them is.
    ///
    /// A drum is seen at the azimuths of its circle, and as high and low as the square around it.
    fn sight_cell_of(&self, eye: &Eye, drum: &Drum) -> SightCell {
        let half = DVec3::new(drum.radius_m, 0.0, drum.radius_m);
        let [min, max] = drum.square(half);
        let away = drum.middle - DVec2::new(eye.point.pos.x, eye.point.pos.z);
        let apart = away.length() > drum.radius_m;
        SightCell {
            azimuth_rad: away.y.atan2(away.x),
            half_width_rad: if apart {
                (drum.radius_m / away.length()).asin()
            } else {
                PI
            },
            ..self.sight_cell(eye, drum.chart, min, max)
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

    /// What is applied to the ported point, xyz in metres and w without unit, to have view coordinates.
    fn view_matrix(&self, eye: &Eye) -> DMat4;

    /// The isometry, applied after the port, that takes the model of a chart to that of the first one; xyz in metres and
    /// w without unit.
    fn home_matrix(&self, _chart: ChartId) -> DMat4 {
        DMat4::IDENTITY
    }

    /// What is applied to a ported point of a chart to have view coordinates: [`Strategy::view_matrix`] of that chart.
    fn chart_matrix(&self, eye: &Eye, chart: ChartId) -> DMat4 {
        self.view_matrix(eye) * self.home_matrix(chart)
    }

    /// What the shaders of its map are.
    fn shader(&self) -> &'static MapShader;

    /// What the shaders need to know of the space, the eye and the projection.
    fn uniform(&self, eye: &Eye, projection: &Projection) -> SpaceUniform;
}

/// The space of that kind and radius in metres.
///
/// Flat space ignores the radius. A radius that is not a positive number is replaced by the
/// default one; menus and commands check [`SPHERE_RADIUS_RANGE_M`] before.
pub fn strategy(geometry: Geometry, radius_m: f64) -> Arc<dyn Strategy> {
    let radius_or = |default_m: f64| {
        if radius_m.is_finite() && radius_m > 0.0 {
            radius_m
        } else {
            default_m
        }
    };
    match geometry {
        Geometry::Euclidean => Arc::new(Euclidean),
        Geometry::Hyperbolic => Arc::new(Raised::new(radius_or(DEFAULT_HYPERBOLIC_RADIUS_M))),
        Geometry::Spherical => Arc::new(Spherical::new(radius_or(DEFAULT_SPHERE_RADIUS_M))),
    }
}

/// The strategy that pictures of a world are taken with: in hyperbolic worlds through the given
/// map, in flat ones bent by the eye's dial or not. Everything that is not about the picture is as
/// in [`strategy`] of the same geometry and radius.
pub fn picture(
    geometry: Geometry,
    radius_m: f64,
    map: HyperbolicMap,
    bend: bool,
) -> Arc<dyn Strategy> {
    let world = strategy(geometry, radius_m);
    match geometry {
        Geometry::Hyperbolic if map == HyperbolicMap::Horizon => {
            Arc::new(Horizon::hyperbolic(world.radius_m()))
        }
        Geometry::Euclidean if bend => Arc::new(Horizon::bent()),
        _ => world,
    }
}

/// Distance between two points in view coordinates, in metres, in a space of curvature `kappa`
/// per square metre.
///
/// Hyperbolic from the distances to the eye and the angle between, so that it holds far off too;
/// spherical from the chords to the point and to its antipode.
pub(crate) fn distance_between_views_m(kappa: f64, views: [DVec4; 2]) -> f64 {
    let k = kappa.abs().sqrt();
    if kappa == 0.0 {
        return views[0].truncate().distance(views[1].truncate());
    }
    let [a, b] = views.map(|v| (v.truncate() * k).extend(v.w));
    if kappa > 0.0 {
        return distance::spherical(a.to_array(), b.to_array()) / k;
    }
    distance::hyperbolic_far(a.truncate().to_array(), b.truncate().to_array()) / k
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_useless_radius_becomes_the_default() {
        for radius in [0.0, -3.0, f64::NAN, f64::INFINITY] {
            let sphere = strategy(Geometry::Spherical, radius);
            assert_eq!(sphere.radius_m(), DEFAULT_SPHERE_RADIUS_M);
            let raised = strategy(Geometry::Hyperbolic, radius);
            assert_eq!(raised.radius_m(), DEFAULT_HYPERBOLIC_RADIUS_M);
        }
        assert_eq!(strategy(Geometry::Spherical, 48.0).radius_m(), 48.0);
        assert_eq!(
            strategy(Geometry::Euclidean, 48.0).radius_m(),
            f64::INFINITY
        );
    }

    #[test]
    fn only_the_sphere_has_a_rim_limits_and_no_sky() {
        for geometry in Geometry::ALL {
            let space = strategy(geometry, 32.0);
            let sphere = geometry == Geometry::Spherical;
            assert_eq!(space.geometry(), geometry);
            assert_eq!(space.all_charts().is_some(), sphere);
            assert_eq!(space.limits().is_some(), sphere);
            assert_eq!(space.has_sky(), !sphere);
            assert_eq!(space.dial().is_some(), geometry == Geometry::Hyperbolic);
        }
    }
}
