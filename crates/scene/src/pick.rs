//! Finds what the crosshair covers: the first thing on the *geodesic* through the screen's centre.
//!
//! A geodesic is no straight line of the chart (at 13 m they differ by 6 to 12 degrees in a hyperbolic
//! world), so the ray marches along it, un-ports each point and tests the short chart segments between.

use antipode_geometry::{Atlas, ChartPoint, Doorway, Eye, Strategy};
use antipode_physics::PhysicsWorld;
use glam::{DVec3, Vec3Swizzles};

/// Length of one tested segment, in metres. Over half a metre a geodesic leaves its chart chord by under
/// `0.5^2 / (8 R)`, 2 mm at R = 16 m and 8 mm at the 4 m of the strongest bend.
const SEGMENT_M: f64 = 0.5;
/// Longest chord of a segment in the chart, in segments: where a map stretches the chart, segments are shortened.
const LONGEST_CHORD: f64 = 1.5;
/// Most times that a segment is halved for its chord.
const HALVINGS: i32 = 5;
/// The land is there only as far off in an open chart as the reach goes: a pick that leaves it by this share ends.
const CHART_SLACK: f64 = 1.01;

/// What a pick ended on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pick {
    /// The point reached, in the chart that it lies in.
    pub point: ChartPoint,
    /// Its distance along the geodesic in metres of the space.
    pub distance_m: f64,
    /// The eye that sees the point: behind a door another than the one that looks.
    pub eye: Eye,
    /// The door that the geodesic has gone into, if it has.
    pub through: Option<usize>,
    /// Whether something was hit; otherwise the point hangs in the air at the end of the reach.
    pub hit: bool,
}

/// Follows the geodesic that leaves the eye through the screen's centre, up to `reach_m` metres beyond
/// `from_m`, and returns the first ground or the end: where the reach ends, or what the picture shows does.
pub fn pick(
    strategy: &dyn Strategy,
    physics: &PhysicsWorld,
    eye: &Eye,
    from_m: f64,
    reach_m: f64,
) -> Pick {
    pick_among(strategy, physics, None, &|_, _| None, eye, from_m, reach_m)
}

/// Tells where a chart segment first meets something, as a share of its length. Both ends are in one chart.
pub type Meets<'a> = &'a dyn Fn(ChartPoint, ChartPoint) -> Option<f64>;

/// As [`pick`], with more in the way than the ground, and through the first door that is in the way.
pub fn pick_among(
    strategy: &dyn Strategy,
    physics: &PhysicsWorld,
    doors: Option<&Doorway>,
    meets: Meets<'_>,
    eye: &Eye,
    from_m: f64,
    reach_m: f64,
) -> Pick {
    let ahead = DVec3::NEG_Z;
    let end_m = (from_m + reach_m)
        .min(strategy.sight_limit_m(eye))
        .max(from_m);
    let (mut eye, mut through) = (*eye, None);
    let mut near = Reached {
        distance_m: from_m,
        point: strategy.along(&eye, ahead, from_m),
    };
    while near.distance_m < end_m {
        let mut far = next(strategy, &eye, near, end_m);
        if !is_pictured(strategy, &eye, far.point, from_m + reach_m) {
            break;
        }
        let door = doors.filter(|_| through.is_none());
        let door = door.and_then(|pair| Some((pair, pair.met(strategy, near.point, far.point)?)));
        if let Some((_, by)) = door {
            far.distance_m = near.distance_m + by.share * (far.distance_m - near.distance_m);
            far.point = strategy.along(&eye, ahead, far.distance_m);
        }
        let ground = segment_hit(strategy, physics, near.point, far.point);
        let other = meets(near.point, over(strategy, near.point, far.point));
        if let Some(share) = [ground, other].into_iter().flatten().reduce(f64::min) {
            let distance_m = near.distance_m + share * (far.distance_m - near.distance_m);
            return Pick {
                point: strategy.along(&eye, ahead, distance_m),
                distance_m,
                eye,
                through,
                hit: true,
            };
        }
        near = far;
        if let Some((pair, by)) = door {
            eye = pair.eye(strategy, by.leaf, &eye);
            through = Some(by.leaf);
            near.point = strategy.along(&eye, ahead, near.distance_m);
        }
    }
    Pick {
        point: near.point,
        distance_m: near.distance_m,
        eye,
        through,
        hit: false,
    }
}

/// A point of the geodesic, and its distance along it.
#[derive(Clone, Copy)]
struct Reached {
    distance_m: f64,
    point: ChartPoint,
}

/// The end of the segment that begins at `near`.
fn next(strategy: &dyn Strategy, eye: &Eye, near: Reached, end_m: f64) -> Reached {
    let at = |length_m: f64| {
        let distance_m = (near.distance_m + length_m).min(end_m);
        let point = strategy.along(eye, DVec3::NEG_Z, distance_m);
        Reached { distance_m, point }
    };
    let is_short = |far: &Reached| {
        let chord = over(strategy, near.point, far.point).pos - near.point.pos;
        chord.length() <= LONGEST_CHORD * SEGMENT_M
    };
    let shorter = (1..HALVINGS).map(|halving| SEGMENT_M * 0.5_f64.powi(halving));
    std::iter::once(SEGMENT_M)
        .chain(shorter)
        .map(at)
        .find(is_short)
        .unwrap_or_else(|| at(SEGMENT_M * 0.5_f64.powi(HALVINGS)))
}

/// Whether a point of the geodesic is in the picture and in land that is waited for. A chart that goes on in
/// another ends nowhere; an open one ends where its map would cover the space a second time.
fn is_pictured(strategy: &dyn Strategy, eye: &Eye, point: ChartPoint, reach_m: f64) -> bool {
    let away_m = || over(strategy, eye.point, point).pos.distance(eye.point.pos);
    strategy.is_closed()
        || (away_m() <= CHART_SLACK * reach_m
            && !strategy.trims(eye, point.chart, point.pos, point.pos))
}

/// `b` in the chart of `a`, where the shortest way from `a` leads: as written there, and farther off as far away as it is.
pub(crate) fn over(strategy: &dyn Atlas, a: ChartPoint, b: ChartPoint) -> ChartPoint {
    // Every figure asks this of every other in every step.
    if a.chart == b.chart {
        return b;
    }
    if let Some(over) = strategy.carry_near(b, a) {
        return over.point;
    }
    // Where `a`'s chart is not written so far, `b`'s numbers would be those of a place of it all the same.
    let way = strategy.tiled().and_then(|tiled| tiled.level_way_m(a, b));
    way.map_or(b, |way| ChartPoint::new(a.chart, a.pos + way))
}

/// Into a chart's own ground one who has crossed its edge comes back so far at most without crossing again, metres.
const PAST_EDGE_M: f64 = 0.25;

/// As [`over`], or nothing where in the chart of `a` it is farther off than `within_m` metres. In a world in tiles that is known of
/// nearly all pairs without carrying any, and what `a`'s chart is not written for is never near.
pub(crate) fn over_if_near(
    strategy: &dyn Strategy,
    a: ChartPoint,
    b: ChartPoint,
    within_m: f64,
) -> Option<ChartPoint> {
    if a.chart == b.chart || strategy.tiled().is_none() {
        return Some(over(strategy, a, b));
    }
    let inside_m = -strategy.domain(a.chart).outside_m(a.pos.xz());
    if inside_m > within_m + PAST_EDGE_M {
        return None;
    }
    strategy.carry_near(b, a).map(|over| over.point)
}

/// Where the chart segment from `a` to `b` first meets ground, as a share of its length.
/// A segment over the edge of a chart is tested in the chart of its start.
pub(crate) fn segment_hit(
    strategy: &dyn Atlas,
    physics: &PhysicsWorld,
    a: ChartPoint,
    b: ChartPoint,
) -> Option<f64> {
    let way = over(strategy, a, b).pos - a.pos;
    let length = way.length();
    if length < 1e-9 {
        return None;
    }
    physics
        .chart(a.chart)
        .cast_ray(a.pos, way / length, length)
        .map(|hit| (hit.distance_m / length).clamp(0.0, 1.0))
}
