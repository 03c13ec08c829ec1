//! Where caves run: halls, the tunnels between them, and the ways in.
//!
//! An open world has a hall in most squares of [`SQUARE_M`], a closed one as many as its size asks for, as far from each other
//! as tries find. From hall to hall run tunnels, and from most a way leads up to the surface where that lies lowest about.
//! All follow the land above: how high that is, is worked out from its noise. So where caves are is a pure function of seed
//! and place, and which can reach into a box is known before any of them is laid out.
//!
//! Places are those of noise space; the height of a place is that of its column in the chart.

use std::collections::HashMap;
use std::sync::{Arc, RwLock};

use antipode_geometry::{ChartId, NoiseFrame};
use glam::DVec3;

use crate::field::Field;
use crate::lattice::stirred;

#[cfg(test)]
#[expect(clippy::expect_used, reason = "tests fail by panicking")]
mod tests;

/// Edge of the squares of open worlds, metres.
const SQUARE_M: f64 = 210.0;
/// Of closed worlds' surface, how much there is for each hall, square metres, and the fewest halls.
const CLOSED_M2: f64 = 12_000.0;
const FEWEST: usize = 3;
/// Tries of a place for a hall of a closed world.
const TRIES: u64 = 12;
/// Halls of closed worlds further from each other have no tunnel, metres.
const FARTHEST_M: f64 = 170.0;
/// Of these parts of all squares there is a hall, of the halls a way up, of the pairs beside each other a tunnel.
const HALLS: f64 = 0.95;
const WAYS_UP: f64 = 0.65;
const TUNNELS: f64 = 0.75;
/// And of the halls these are great.
const GREAT: f64 = 0.3;
/// Tunnels swing out to either side by at most this of their length, on the whole and in an S.
const BOW: f64 = 0.12;
const SWING: f64 = 0.10;
/// Metres between two knots of a tunnel.
const KNOT_M: f64 = 6.0;
/// Halls of closed worlds nearer than this to one with a way up have none of their own, metres.
const WAYS_APART_M: f64 = 250.0;
/// How far from its hall a way in begins, metres, and no further than that of the radius of closed worlds.
const WAY_UP_M: f64 = 52.0;
const WAY_UP_SHARE: f64 = 0.9;
/// Tunnels rise and fall by no more than this per metre.
const STEEPEST: f64 = 0.42;
/// Solid land over a hall or tunnel, and between its floor and bedrock, at least, metres.
const COVER_M: f64 = 2.5;
const UNDER_M: f64 = 1.8;
/// Narrower is no cave, metres.
const NARROWEST_M: f64 = 1.5;
/// Floors lie level so far below the middle, of the radius.
pub(crate) const FLOOR: f64 = 0.55;
/// Where a way up has come out of the land its sides begin so far from its middle, of the radius, rise by so much per metre,
/// and go no higher than this over its floor, metres.
const SIDE_FROM: f64 = 0.6;
const SIDE_STEEP: f64 = 0.75;
const SIDE_M: f64 = 6.0;
/// Walls stray by at most this from where stretches say, metres.
pub(crate) const STRAY_M: f64 = 0.9;

/// Squares that are remembered: those of some kilometres about.
const REMEMBERED: usize = 400;

/// The caves of a world.
#[derive(Debug)]
pub(crate) struct Caves {
    seed: u64,
    /// All of a closed world's.
    closed: Option<Vec<Passage>>,
    /// Of an open one's those that come into squares which somebody has asked for. Nobody waits for it: who finds it taken
    /// lays them out himself.
    squares: RwLock<HashMap<[i64; 2], Arc<[Passage]>>>,
}

/// A hall, a tunnel or a way up.
#[derive(Debug)]
struct Passage {
    stretches: Vec<Stretch>,
    bounds: Bounds,
}

/// A piece of a cave: a round hollow about a line, with a level floor.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Stretch {
    from: DVec3,
    along: DVec3,
    per_length2: f64,
    /// Height of the line's first end, and how much higher the other is, metres.
    height_m: [f64; 2],
    /// The radius at the first end, and how much greater it is at the other, metres.
    radius_m: [f64; 2],
    pub is_hall: bool,
    /// Whether it lies open to the sky: then its sides slope, so that who falls in comes out again.
    is_open: bool,
}

/// A box of noise space that is asked about.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bounds {
    pub low: DVec3,
    pub high: DVec3,
}

/// A place about which a cave lies.
#[derive(Debug, Clone, Copy)]
struct Knot {
    /// On the ground of noise space.
    ground: DVec3,
    height_m: f64,
    radius_m: f64,
    /// Of the land above, metres.
    surface_m: f64,
}

#[derive(Debug, Clone, Copy)]
struct Hall {
    key: u64,
    ground: DVec3,
    knot: Knot,
}

/// Chance by a key, each number another: 0 to 1.
fn chance(key: u64, n: u64) -> f64 {
    const UNIT: f64 = 1.0 / (1_u64 << 53) as f64;
    (stirred(key ^ n.wrapping_mul(0x2545_f491_4f6c_dd1d)) >> 11) as f64 * UNIT
}

/// The same, -1 to 1.
fn either_way(key: u64, n: u64) -> f64 {
    2.0 * chance(key, n) - 1.0
}

impl Stretch {
    fn between(field: &Field, [from, to]: [Knot; 2], is_hall: bool) -> Self {
        let [a, b] = [from, to].map(|knot| field.risen(knot.ground, knot.height_m));
        let along = b - a;
        Self {
            from: a,
            along,
            per_length2: along.length_squared().max(1e-9).recip(),
            height_m: [from.height_m, to.height_m - from.height_m],
            radius_m: [from.radius_m, to.radius_m - from.radius_m],
            is_hall,
            is_open: false,
        }
    }

    /// How far within the hollow and over its floor a place is, metres: both are more than zero inside.
    #[inline]
    pub(crate) fn depths(&self, place: DVec3, height_m: f64) -> [f64; 2] {
        let away = place - self.from;
        let t = (away.dot(self.along) * self.per_length2).clamp(0.0, 1.0);
        let radius_m = self.radius_m[0] + t * self.radius_m[1];
        let middle_m = self.height_m[0] + t * self.height_m[1];
        let far2 = (away - self.along * t).length_squared();
        let over_m = height_m - middle_m;
        let floor = over_m + FLOOR * radius_m;
        let mut hollow = radius_m - far2.sqrt();
        if self.is_open {
            let aside_m = (far2 - over_m * over_m).max(0.0).sqrt();
            let flank = SIDE_STEEP * (SIDE_FROM * radius_m - aside_m) + floor;
            hollow = hollow.max((0.8 * flank).min(SIDE_M - floor));
        }
        [hollow, floor]
    }

    /// The place of its other end.
    fn end(&self) -> DVec3 {
        self.from + self.along
    }

    /// The box that holds all places within so many metres of it.
    pub(crate) fn bounds(&self, reach_m: f64) -> Bounds {
        let ends = [self.from, self.end()];
        let mut radius_m = self.radius_m[0].max(self.radius_m[0] + self.radius_m[1]);
        if self.is_open {
            radius_m = (SIDE_FROM * radius_m + SIDE_M / SIDE_STEEP).max(radius_m);
        }
        let reach = DVec3::splat(radius_m + reach_m);
        Bounds {
            low: ends[0].min(ends[1]) - reach,
            high: ends[0].max(ends[1]) + reach,
        }
    }
}

impl Bounds {
    pub(crate) fn meets(&self, other: &Self) -> bool {
        self.low.cmple(other.high).all() && other.low.cmple(self.high).all()
    }

    fn widened(&self, by_m: f64) -> Self {
        Self {
            low: self.low - by_m,
            high: self.high + by_m,
        }
    }
}

impl Passage {
    fn new(stretches: Vec<Stretch>) -> Self {
        let nowhere = Bounds {
            low: DVec3::INFINITY,
            high: DVec3::NEG_INFINITY,
        };
        let bounds = stretches.iter().map(|it| it.bounds(0.0));
        let bounds = bounds.fold(nowhere, |all, next| Bounds {
            low: all.low.min(next.low),
            high: all.high.max(next.high),
        });
        Self { stretches, bounds }
    }
}

impl Caves {
    /// Those of a world whose land this is.
    pub(crate) fn new(seed: u64, field: &Field) -> Self {
        let seed = stirred(seed ^ 0xcafe);
        let radius_m = match field.strategy().noise_frame(ChartId::FIRST) {
            NoiseFrame::Radial { radius_m } => Some(radius_m),
            NoiseFrame::Square(_) | NoiseFrame::Upright => None,
        };
        Self {
            seed,
            closed: radius_m.map(|radius_m| closed_passages(seed, field, radius_m)),
            squares: RwLock::default(),
        }
    }

    /// Calls `take` with each stretch that comes within `reach_m` of a box.
    pub(crate) fn near(
        &self,
        field: &Field,
        bounds: &Bounds,
        reach_m: f64,
        mut take: impl FnMut(&Stretch),
    ) {
        let wanted = bounds.widened(reach_m);
        let mut taken = |passages: &[Passage]| {
            for passage in passages.iter().filter(|it| it.bounds.meets(&wanted)) {
                let near = passage.stretches.iter();
                near.filter(|it| it.bounds(0.0).meets(&wanted))
                    .for_each(&mut take);
            }
        };
        if let Some(all) = &self.closed {
            return taken(all);
        }
        let [first, last] = [wanted.low, wanted.high].map(square_of);
        for i in first[0]..=last[0] {
            for k in first[1]..=last[1] {
                taken(&self.within(field, [i, k]));
            }
        }
    }

    /// What comes into a square of an open world.
    fn within(&self, field: &Field, square: [i64; 2]) -> Arc<[Passage]> {
        if let Ok(known) = self.squares.try_read()
            && let Some(passages) = known.get(&square)
        {
            return passages.clone();
        }
        let seed = self.seed;
        let passages: Arc<[Passage]> = Open { seed, field }.within(square).into();
        if let Ok(mut known) = self.squares.try_write() {
            if known.len() >= REMEMBERED {
                known.clear();
            }
            known.insert(square, passages.clone());
        }
        passages
    }
}

/// The square that a place of an open world lies in.
fn square_of(place: DVec3) -> [i64; 2] {
    [place.x, place.z].map(|c| (c / SQUARE_M).floor() as i64)
}

/// The caves of an open world.
struct Open<'a> {
    seed: u64,
    field: &'a Field,
}

impl Open<'_> {
    fn key(&self, i: i64, k: i64) -> u64 {
        stirred(stirred(self.seed ^ i.cast_unsigned()) ^ k.cast_unsigned())
    }

    /// Where in a square a hall lies, if there is one.
    fn place(&self, i: i64, k: i64) -> Option<(u64, DVec3)> {
        let key = self.key(i, k);
        let at = |n, square: i64| (square as f64 + 0.5 + 0.32 * either_way(key, n)) * SQUARE_M;
        let place = DVec3::new(at(1, i), 0.0, at(2, k));
        (chance(key, 0) < HALLS).then_some((key, place))
    }

    /// What comes into a square. What belongs to one leaves that and the next by less than a square.
    fn within(&self, [i, k]: [i64; 2]) -> Vec<Passage> {
        let near = (-1..=1).flat_map(|di| (-1..=1).map(move |dk| [i + di, k + dk]));
        let mut found: Vec<_> = near.flat_map(|square| self.passages(square)).collect();
        found.retain(|passage| {
            let [low, high] = [passage.bounds.low, passage.bounds.high].map(square_of);
            (low[0]..=high[0]).contains(&i) && (low[1]..=high[1]).contains(&k)
        });
        found
    }

    /// What belongs to a square: its hall, the way up from there, and tunnels to the next two squares' halls.
    fn passages(&self, [i, k]: [i64; 2]) -> Vec<Passage> {
        let field = self.field;
        let hall = |i, k| {
            let (key, place) = self.place(i, k)?;
            Hall::new(field, key, place)
        };
        let Some(here) = hall(i, k) else {
            return Vec::new();
        };
        let mut found = vec![here.hollow(field)];
        if chance(here.key, 7) < WAYS_UP {
            found.push(here.way_up(field, WAY_UP_M));
        }
        for (n, (di, dk)) in [(1, 0), (0, 1)].into_iter().enumerate() {
            if chance(here.key, 10 + n as u64) < TUNNELS
                && let Some(other) = hall(i + di, k + dk)
            {
                found.push(tunnel(field, here.key ^ n as u64, [here, other]));
            }
        }
        found
    }
}

/// All caves of a closed world.
fn closed_passages(seed: u64, field: &Field, radius_m: f64) -> Vec<Passage> {
    let count = (4.0 * std::f64::consts::PI * radius_m * radius_m / CLOSED_M2).round() as usize;
    let mut halls: Vec<Hall> = Vec::new();
    for n in 0..count.max(FEWEST) as u64 {
        let key = stirred(seed ^ n);
        let tries = (0..TRIES).map(|n| direction(stirred(key ^ n)) * radius_m);
        let nearest = |hall: &Hall| {
            let far = halls
                .iter()
                .map(|it| it.ground.distance_squared(hall.ground));
            far.fold(f64::INFINITY, f64::min)
        };
        let fitting = tries.filter_map(|place| Hall::new(field, key, place));
        halls.extend(fitting.max_by(|a, b| nearest(a).total_cmp(&nearest(b))));
    }
    let mut found = Vec::new();
    let mut ways: Vec<DVec3> = Vec::new();
    for (n, hall) in halls.iter().enumerate() {
        found.push(hall.hollow(field));
        if ways
            .iter()
            .all(|other| other.distance(hall.ground) >= WAYS_APART_M)
        {
            ways.push(hall.ground);
            found.push(hall.way_up(field, WAY_UP_M.min(WAY_UP_SHARE * radius_m)));
        }
        let far = |other: &&Hall| other.ground.distance(hall.ground);
        let mut others: Vec<&Hall> = halls.iter().skip(n + 1).collect();
        others.retain(|other| far(other) < FARTHEST_M);
        others.sort_by(|a, b| far(a).total_cmp(&far(b)));
        for (other, n) in others.into_iter().take(2).zip(0..) {
            if chance(hall.key, 10 + n) < TUNNELS {
                found.push(tunnel(field, hall.key ^ n, [*hall, *other]));
            }
        }
    }
    found
}

/// A unit vector by a key, all as likely: a place in the ball, as long as it is not near the middle.
fn direction(key: u64) -> DVec3 {
    let at = |n: u64| DVec3::from([0, 1, 2].map(|axis| either_way(key, 3 * n + axis)));
    let tries = (0..16).map(at);
    let mut within = tries.filter(|at| (0.01..1.0).contains(&at.length_squared()));
    within.next().unwrap_or(DVec3::Y).normalize()
}

impl Hall {
    /// That of a place, if there is room for it.
    fn new(field: &Field, key: u64, ground: DVec3) -> Option<Self> {
        let share = chance(key, 3);
        let radius_m = if chance(key, 4) < GREAT {
            9.0 + 5.0 * share
        } else {
            4.5 + 3.0 * share
        };
        let surface_m = field.land_height(ground);
        let deep_m = COVER_M + 2.0 + 9.0 * chance(key, 5);
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

    /// The hall itself: longer than wide.
    fn hollow(&self, field: &Field) -> Passage {
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
    fn way_up(&self, field: &Field, length_m: f64) -> Passage {
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
        let stretches = pairs.map(|pair| Stretch {
            is_open: pair.iter().any(is_out),
            ..Stretch::between(field, pair, false)
        });
        Passage::new(stretches.collect())
    }
}

/// A tunnel from hall to hall.
fn tunnel(field: &Field, key: u64, [from, to]: [Hall; 2]) -> Passage {
    let way = to.ground - from.ground;
    let side = sideways_of(field, from.ground, way);
    let length_m = way.length();
    let (bow, swing) = (BOW * either_way(key, 20), SWING * either_way(key, 21));
    let radius_m = 2.1 + 1.6 * chance(key, 22);
    let deep_m = COVER_M + 1.0 + 6.0 * chance(key, 23);
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
            radius_m,
            height_m,
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
fn fitted(field: &Field, surface_m: f64, radius_m: f64, height_m: f64) -> Option<(f64, f64)> {
    let Some(limits) = field.strategy().limits() else {
        return Some((radius_m, height_m));
    };
    let floor_m = limits.bedrock_m + UNDER_M;
    let room_m = surface_m - COVER_M - STRAY_M - floor_m;
    let radius_m = radius_m.min(room_m / (1.0 + FLOOR));
    let lowest_m = floor_m + FLOOR * radius_m;
    (radius_m >= NARROWEST_M).then(|| (radius_m, height_m.max(lowest_m)))
}

/// The unit vectors of two directions on the ground that are square to each other.
fn axes(field: &Field, ground: DVec3) -> [DVec3; 2] {
    match field.strategy().noise_frame(ChartId::FIRST) {
        NoiseFrame::Radial { .. } => {
            let x = ground.any_orthogonal_vector().normalize();
            [x, ground.normalize().cross(x)]
        }
        NoiseFrame::Square(_) | NoiseFrame::Upright => [DVec3::X, DVec3::Z],
    }
}

/// About a unit vector along the ground, by how far it is turned in halves of a turn, -1 to 1.
fn sideways(field: &Field, ground: DVec3, turned: f64) -> DVec3 {
    let [x, z] = axes(field, ground);
    // Round a square: exact on every machine, which sines are not.
    let at = 4.0 * turned;
    let corner = |at: f64| (2.0 - (at.rem_euclid(8.0) - 4.0).abs()).clamp(-1.0, 1.0);
    (x * corner(at) + z * corner(at - 2.0)).normalize()
}

/// A unit vector along the ground square to another.
fn sideways_of(field: &Field, ground: DVec3, way: DVec3) -> DVec3 {
    let [x, z] = axes(field, ground);
    (z * way.dot(x) - x * way.dot(z)).normalize_or_zero()
}

/// The place on the ground so far from another.
fn on_ground(field: &Field, ground: DVec3, offset: DVec3) -> DVec3 {
    match field.strategy().noise_frame(ChartId::FIRST) {
        NoiseFrame::Radial { radius_m } => (ground + offset).normalize() * radius_m,
        NoiseFrame::Square(_) | NoiseFrame::Upright => ground + offset,
    }
}
