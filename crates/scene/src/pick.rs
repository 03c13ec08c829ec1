//! What the crosshair covers: the first thing on the *geodesic* through the screen's centre.
//!
//! A geodesic is no straight line of the chart (at 13 m they differ by 6 to 12 degrees in a hyperbolic
//! world), so the ray marches along it, un-ports each point and tests the short chart segments between.

use antipode_geometry::{ChartPoint, Eye, Strategy};
use antipode_physics::PhysicsWorld;
use glam::DVec3;

/// Length of one tested segment, in metres. Over half a metre a geodesic leaves its chart chord by under
/// `0.5^2 / (8 R)`, 2 mm at R = 16 m.
const SEGMENT_M: f64 = 0.5;

/// What a pick ended on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pick {
    /// The point reached, in the chart of the hemisphere it lies in.
    pub point: ChartPoint,
    /// Its distance along the geodesic in metres of the space.
    pub distance_m: f64,
    /// Whether ground was hit; otherwise the point hangs in the air at the end of the reach.
    pub hit: bool,
}

/// Follows the geodesic that leaves the eye through the screen's centre, up to `reach_m` metres beyond
/// `from_m`, and returns the first ground or the end.
pub fn pick(
    strategy: &dyn Strategy,
    physics: &PhysicsWorld,
    eye: &Eye,
    from_m: f64,
    reach_m: f64,
) -> Pick {
    let ahead = DVec3::NEG_Z;
    let end_m = from_m + reach_m;
    let steps = (reach_m / SEGMENT_M).ceil().max(1.0) as u32;
    let mut near = (from_m, strategy.along(eye, ahead, from_m));
    for step in 1..=steps {
        let t = (from_m + f64::from(step) * SEGMENT_M).min(end_m);
        let far = strategy.along(eye, ahead, t);
        if let Some(share) = segment_hit(strategy, physics, near.1, far) {
            let distance_m = near.0 + share * (t - near.0);
            return Pick {
                point: strategy.along(eye, ahead, distance_m),
                distance_m,
                hit: true,
            };
        }
        near = (t, far);
    }
    Pick {
        point: near.1,
        distance_m: end_m,
        hit: false,
    }
}

/// Where the chart segment from `a` to `b` first meets ground, as a share of its length.
/// A segment over the equator is tested in the chart of its start.
fn segment_hit(
    strategy: &dyn Strategy,
    physics: &PhysicsWorld,
    a: ChartPoint,
    b: ChartPoint,
) -> Option<f64> {
    let b = if a.hemisphere == b.hemisphere {
        b
    } else {
        strategy.carry(b).map_or(b, |over| over.point)
    };
    let way = b.pos - a.pos;
    let length = way.length();
    if length < 1e-9 {
        return None;
    }
    let origin = a.pos + strategy.chart_origin_m(a.hemisphere);
    physics
        .cast_ray(origin, way / length, length)
        .map(|hit| (hit.distance_m / length).clamp(0.0, 1.0))
}
