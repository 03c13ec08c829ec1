//! Distances and curvature of a space.

use glam::{DVec3, DVec4};

use crate::kernel::distance;
use crate::{ChartPoint, Eye, Geometry};

/// A curvature that is the same everywhere, with all that follows from it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Curvature {
    /// -1 where space is hyperbolic, 0 where it is flat, +1 where it is spherical.
    pub sign: f64,
    /// Its root, per metre; 0 where flat.
    pub per_m: f64,
    /// Radius of curvature in metres; infinite where flat.
    pub radius_m: f64,
}

impl Curvature {
    /// None.
    pub const FLAT: Self = Self {
        sign: 0.0,
        per_m: 0.0,
        radius_m: f64::INFINITY,
    };

    /// That of a radius in metres, positive and finite.
    pub(crate) fn of_radius(sign: f64, radius_m: f64) -> Self {
        Self {
            sign,
            per_m: 1.0 / radius_m,
            radius_m,
        }
    }

    /// So much per square metre.
    pub(crate) fn of_kappa(kappa: f64) -> Self {
        let per_m = kappa.abs().sqrt();
        Self {
            sign: if kappa == 0.0 { 0.0 } else { kappa.signum() },
            per_m,
            radius_m: 1.0 / per_m,
        }
    }

    /// How much it is per square metre: negative in hyperbolic space, positive in spherical.
    pub fn per_m2(self) -> f64 {
        self.sign * self.radius_m.powi(-2)
    }

    /// Which of the three oldest spaces has it.
    fn geometry(self) -> Geometry {
        if self.sign < 0.0 {
            Geometry::Hyperbolic
        } else if self.sign > 0.0 {
            Geometry::Spherical
        } else {
            Geometry::Euclidean
        }
    }
}

/// Lengths of a space: its curvature, and how far two of its points are apart. Where the player's dial bends the picture,
/// lengths go by the eye's, as the port does.
pub trait Metric {
    /// The world's own curvature.
    fn curvature(&self) -> Curvature;

    /// That of the picture, at the eye's dial.
    fn curvature_at(&self, _eye: &Eye) -> Curvature {
        self.curvature()
    }

    /// Distance in the space between two points, in metres.
    fn distance_m(&self, a: ChartPoint, b: ChartPoint, eye: &Eye) -> f64;

    /// Distance in the space from the eye to a point in view coordinates, in metres.
    fn eye_distance_m(&self, eye: &Eye, view: DVec4) -> f64 {
        let it = self.curvature_at(eye);
        distance::from_eye(it.sign, it.per_m, it.radius_m, view.to_array())
    }

    /// Whether bodies move in the chart itself and know no other metre than its own: where space is flat, and where land is, seen
    /// through a lens. Where it is not so, each moves in a chart of its own ([`crate::BodyFrame`]).
    fn moves_in_chart(&self) -> bool {
        true
    }

    /// A velocity of the chart at a point in metres of the space along the axes of the chart's frame there. The same where
    /// bodies know no other metre than the chart's.
    fn in_frame(&self, _at: ChartPoint, velocity: DVec3) -> DVec3 {
        velocity
    }

    /// The inverse of [`Metric::in_frame`].
    fn in_chart(&self, _at: ChartPoint, velocity: DVec3) -> DVec3 {
        velocity
    }

    /// Radius of [`Metric::curvature`] in metres.
    fn radius_m(&self) -> f64 {
        self.curvature().radius_m
    }

    /// Radius of [`Metric::curvature_at`] in metres.
    fn radius_at_m(&self, eye: &Eye) -> f64 {
        self.curvature_at(eye).radius_m
    }

    /// Which of the spaces this is: that of its curvature alone, unless it says another.
    fn geometry(&self) -> Geometry {
        self.curvature().geometry()
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
