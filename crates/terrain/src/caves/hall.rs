//! Halls, the ways up from them, and tunnels between two, as they follow the land above.

use glam::DVec3;

use super::lay::Lay;
use super::layout::{chance, either_way};
use super::over_ground::{on_ground, sideways, sideways_of};
use super::stretch::{FLOOR, Knot, Passage, STRAY_M, Stretch};

/// Of all halls these are great.
const GREAT: f64 = 0.3;
/// Tunnels swing out to either side by at most this of their length, on the whole and in an S.
const BOW: f64 = 0.12;
const SWING: f64 = 0.10;
/// Metres between two knots of a tunnel.
const KNOT_M: f64 = 6.0;
/// Tunnels rise and fall by no more than this per metre.
const STEEPEST: f64 = 0.42;
/// Solid land over a hall or tunnel at least, metres: more than cells of the coarsest level are high, which would lose it else.
/// In closed worlds no more than that of the radius, since they are seen from no farther, and always more than the second.
const COVER_M: f64 = 9.0;
const COVER_SHARE: f64 = 0.08;
const THINNEST_M: f64 = 2.5;
/// And between its floor and bedrock, metres.
const UNDER_M: f64 = 1.8;
/// Narrower is no cave, metres.
const NARROWEST_M: f64 = 1.5;

/// A hall, by its middle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Hall {
    pub key: u64,
    pub ground: DVec3,
    knot: Knot,
}

impl Hall {
    /// That of a place, if there is room for it.
    pub(super) fn new(field: &Lay<'_>, key: u64, ground: DVec3) -> Option<Self> {
        let share = chance(key, 3);
        let radius_m = if chance(key, 4) < GREAT {
            9.0 + 5.0 * share
        } else {
            4.5 + 3.0 * share
        };
        let surface_m = field.land_height(ground);
        let deep_m = cover_m(field) + 1.0 + 8.0 * chance(key, 5);
        let (radius_m, height_m) =
            fitted(field, surface_m, radius_m, surface_m - radius_m - deep_m)?;
        Some(Self {
            key,
            ground,
            knot: Knot {
                ground,
                height_m,
                radius_m,
                surface_m,
            },
        })
    }

    /// The same hall, its place told otherwise.
    pub(super) fn moved(mut self, ground: DVec3) -> Self {
        self.ground = ground;
        self.knot.ground = ground;
        self
    }

    /// The hall itself: longer than wide.
    pub(super) fn hollow(&self, field: &Lay<'_>) -> Passage {
        let turned = either_way(self.key, 6);
        let across = sideways(field, self.ground, turned) * (0.7 * self.knot.radius_m);
        let end = |sign: f64| {
            let ground = on_ground(field, self.ground, across * sign);
            let surface_m = field.land_height(ground).min(self.knot.surface_m);
            let (radius_m, _) = fitted(field, surface_m, self.knot.radius_m, 0.0)?;
            Some(Knot {
                ground,
                // The floor is one.
                height_m: self.leave_m(radius_m),
                radius_m,
                surface_m,
            })
        };
        let ends = [-1.0, 1.0].map(|sign| end(sign).unwrap_or(self.knot));
        Passage::new(vec![Stretch::between(field, ends, true)])
    }

    /// The height of the middle of a tunnel that leaves the hall at its floor.
    fn leave_m(&self, radius_m: f64) -> f64 {
        self.knot.height_m + FLOOR * (radius_m - self.knot.radius_m)
    }

    /// The way up to the surface, where that is lowest about.
    pub(super) fn way_up(&self, field: &Lay<'_>, length_m: f64) -> Passage {
        let around = (0..8).map(|n| {
            let heading = sideways(field, self.ground, f64::from(n) / 4.0 - 1.0);
            (
                heading,
                field.land_height(on_ground(field, self.ground, heading * length_m)),
            )
        });
        let lowest = around.min_by(|a, b| a.1.total_cmp(&b.1));
        let (heading, mouth_m) = lowest.unwrap_or((DVec3::ZERO, self.knot.surface_m));
        let radius_m = 2.2 + 0.9 * chance(self.key, 8);
        let ends = [self.leave_m(radius_m), mouth_m + 0.4 * radius_m];
        let bend =
            sideways_of(field, self.ground, heading) * (0.12 * length_m * either_way(self.key, 9));
        let steps = (length_m / KNOT_M).ceil();
        let mut knots: Vec<Knot> = Vec::new();
        for n in 0..=steps as u32 + 2 {
            let t = f64::from(n) / steps;
            let offset = heading * (length_m * t) + bend * (4.0 * t * (1.0 - t));
            let ground = on_ground(field, self.ground, offset);
            let knot = Knot {
                ground,
                height_m: ends[0] + t * (ends[1] - ends[0]),
                radius_m: radius_m * (1.0 + 0.15 * either_way(self.key, 40 + u64::from(n))),
                surface_m: field.land_height(ground),
            };
            knots.push(knot);
            if knot.height_m - 0.3 * radius_m > knot.surface_m {
                break;
            }
        }
        let pairs = knots
            .windows(2)
            .filter_map(|pair| <[Knot; 2]>::try_from(pair).ok());
        let is_out = |knot: &Knot| knot.height_m + knot.radius_m > knot.surface_m;
        let stretches = pairs.map(|pair| {
            let mut stretch = Stretch::between(field, pair, false);
            stretch.is_open = pair.iter().any(is_out);
            stretch
        });
        Passage::new(stretches.collect())
    }
}

/// A tunnel from hall to hall.
pub(super) fn tunnel(field: &Lay<'_>, key: u64, [from, to]: [Hall; 2]) -> Passage {
    let way = to.ground - from.ground;
    let side = sideways_of(field, from.ground, way);
    let length_m = way.length();
    let (bow, swing) = (BOW * either_way(key, 20), SWING * either_way(key, 21));
    let radius_m = 2.1 + 1.6 * chance(key, 22);
    let deep_m = cover_m(field) + 0.5 + 5.0 * chance(key, 23);
    let count = (length_m / KNOT_M).ceil().max(2.0) as usize;
    let mut knots: Vec<Knot> = Vec::with_capacity(count + 1);
    for n in 0..=count {
        let t = n as f64 / count as f64;
        // Both are nothing at the ends, and 1 at most.
        let s = 4.0 * t * (1.0 - t);
        let out_m = length_m * (bow * s + swing * 2.598 * s * (1.0 - 2.0 * t));
        let ground = on_ground(field, from.ground, way * t + side * out_m);
        let radius_m = radius_m * (1.0 + 0.25 * either_way(key, 40 + n as u64));
        let surface_m = field.land_height(ground);
        let height_m = if n == 0 {
            from.leave_m(radius_m)
        } else if n == count {
            to.leave_m(radius_m)
        } else {
            surface_m - radius_m - deep_m
        };
        knots.push(Knot {
            ground,
            height_m,
            radius_m,
            surface_m,
        });
    }
    level_off(&mut knots, length_m / count as f64);
    let fit = |knot: Knot| {
        let (radius_m, height_m) = fitted(field, knot.surface_m, knot.radius_m, knot.height_m)?;
        Some(Knot {
            height_m,
            radius_m,
            ..knot
        })
    };
    let knots: Vec<_> = knots.into_iter().map(fit).collect();
    let pairs = knots.windows(2).filter_map(|pair| match *pair {
        [Some(from), Some(to)] => Some(Stretch::between(field, [from, to], false)),
        _ => None,
    });
    Passage::new(pairs.collect())
}

/// How much solid land there is over caves at least, metres.
fn cover_m(field: &Lay<'_>) -> f64 {
    let closed_m = field
        .closed_radius_m()
        .map(|radius_m| COVER_SHARE * radius_m);
    closed_m.map_or(COVER_M, |it| it.clamp(THINNEST_M, COVER_M))
}

/// Lowers knots so far apart until none is steeper than may be.
fn level_off(knots: &mut [Knot], apart_m: f64) {
    let most_m = STEEPEST * apart_m;
    for n in 1..knots.len() {
        knots[n].height_m = knots[n].height_m.min(knots[n - 1].height_m + most_m);
    }
    for n in (1..knots.len()).rev() {
        knots[n - 1].height_m = knots[n - 1].height_m.min(knots[n].height_m + most_m);
    }
}

/// The radius and height that a cave can have below land so high, as wide and as near the height as there is room for.
fn fitted(field: &Lay<'_>, surface_m: f64, radius_m: f64, height_m: f64) -> Option<(f64, f64)> {
    let Some(limits) = field.strategy().limits() else {
        return Some((radius_m, height_m));
    };
    let floor_m = limits.bedrock_m + UNDER_M;
    let room_m = surface_m - cover_m(field) - STRAY_M - floor_m;
    let radius_m = radius_m.min(room_m / (1.0 + FLOOR));
    let lowest_m = floor_m + FLOOR * radius_m;
    (radius_m >= NARROWEST_M).then(|| (radius_m, height_m.max(lowest_m)))
}
