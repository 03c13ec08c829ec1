//! What grows about a place where a world might begin: nobody begins behind a trunk.

use antipode_geometry::ChartPoint;
use antipode_plants::placed_near;
use glam::DVec2;

use super::{RAY_RAD, RAYS, Search};
use crate::player::wrap_angle;

/// How far about a place things stand in the way of a view, metres.
const REACH_M: f64 = 24.0;
/// What stands nearer covers so much of a picture that the land behind it is not seen, metres.
const CLOSE_M: f64 = 8.0;
/// What has its crown over this height is seen past, but for its trunk, metres.
const UNDER_M: f64 = 2.4;

/// How far from the middle of who walks what is solid has to be, metres.
const PASSES_M: f64 = 0.4;

/// How far a car that drives off goes straight on, and how far from its middle what is solid has to be then, metres.
const DRIVES_M: f64 = 7.0;
const HALF_CAR_M: f64 = 1.1;

/// A thing as it stands in the way.
#[derive(Debug)]
struct Obstacle {
    /// From the place, metres of the plan.
    at: DVec2,
    /// What cannot be passed.
    trunk_m: f64,
    /// What cannot be looked through.
    blind_m: f64,
}

/// All things about a place.
#[derive(Debug)]
pub(super) struct Obstacles {
    from: ChartPoint,
    all: Vec<Obstacle>,
}

impl Search<'_> {
    /// What grows about a place.
    pub(super) fn obstacles(&self, from: ChartPoint) -> Obstacles {
        let found = placed_near(self.field, from, REACH_M);
        let all = found.map(|(root, species, age)| {
            let way = root.pos - from.pos;
            let trunk = species.trunk(age);
            let is_seen_under = trunk.is_some_and(|trunk| trunk.height_m > UNDER_M);
            let trunk_m = trunk.map_or(0.0, |trunk| trunk.radius_m);
            Obstacle {
                at: DVec2::new(way.x, way.z),
                trunk_m,
                blind_m: if is_seen_under {
                    trunk_m
                } else {
                    species.radius_m(age)
                },
            }
        });
        Obstacles {
            from,
            all: all.collect(),
        }
    }
}

impl Obstacles {
    /// Whether nothing stands within so many metres of a place.
    pub(super) fn leave(&self, place: ChartPoint, room_m: f64) -> bool {
        let at = self.plan(place);
        let mut all = self.all.iter();
        at.is_none_or(|at| all.all(|it| it.at.distance(at) > it.trunk_m + room_m))
    }

    /// Whether that holds of a place, and nothing stands in the way of who looks there or comes from there.
    pub(super) fn shows(&self, place: ChartPoint, room_m: f64) -> bool {
        let Some(at) = self.plan(place) else {
            return true;
        };
        let away_m = at.length();
        let is_past = |it: &Obstacle| {
            let along = it.at.dot(at) / away_m.max(1e-6);
            let across_m = (it.at.perp_dot(at) / away_m.max(1e-6)).abs();
            let passes_m = if it.trunk_m > 0.0 {
                it.trunk_m + PASSES_M
            } else {
                0.0
            };
            (0.0..away_m).contains(&along) && across_m < it.blind_m.max(passes_m)
        };
        self.leave(place, room_m) && !self.all.iter().any(is_past)
    }

    /// Whether a car that stands somewhere can drive off straight, ahead or back.
    pub(super) fn let_drive(&self, place: ChartPoint, heading: f64) -> bool {
        let Some(at) = self.plan(place) else {
            return true;
        };
        let is_free = |way: DVec2| {
            let mut solid = self.all.iter().filter(|it| it.trunk_m > 0.0);
            solid.all(|it| {
                let along_m = (it.at - at).dot(way).clamp(0.0, DRIVES_M);
                it.at.distance(at + way * along_m) > it.trunk_m + HALF_CAR_M
            })
        };
        let ahead = DVec2::from_angle(heading);
        is_free(ahead) || is_free(-ahead)
    }

    /// The share of the rays of a view on which nothing close by is in the way.
    pub(super) fn open_share(&self, yaw: f64) -> f64 {
        let is_open = |ray: &i32| {
            let bearing = yaw + f64::from(*ray) * RAY_RAD;
            let is_on = |it: &Obstacle| {
                let off = wrap_angle(it.at.y.atan2(it.at.x) - bearing).abs();
                off < (it.blind_m / it.at.length().max(it.blind_m)).asin()
            };
            let mut close = self.all.iter().filter(|it| it.at.length() < CLOSE_M);
            !close.any(is_on)
        };
        let open = (-RAYS..=RAYS).filter(is_open).count();
        open as f64 / f64::from(2 * RAYS + 1)
    }

    /// A place of the same chart from the middle.
    fn plan(&self, place: ChartPoint) -> Option<DVec2> {
        let way = place.pos - self.from.pos;
        (place.chart == self.from.chart).then_some(DVec2::new(way.x, way.z))
    }
}
