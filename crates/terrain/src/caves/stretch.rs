//! What caves consist of: stretches of hollow about a line, and passages of them.

use glam::DVec3;

use crate::field::Field;

/// Floors lie level so far below the middle, of the radius.
pub(super) const FLOOR: f64 = 0.55;
/// Where a way up has come out of the land its sides begin so far from its middle, of the radius, rise by so much per metre,
/// and go no higher than this over its floor, metres.
const SIDE_FROM: f64 = 0.6;
const SIDE_STEEP: f64 = 0.75;
const SIDE_M: f64 = 6.0;
/// Walls stray by at most this from where stretches say, metres.
pub(crate) const STRAY_M: f64 = 0.9;

/// A piece of a cave: a round hollow about a line, with a level floor.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Stretch {
    pub(super) from: DVec3,
    along: DVec3,
    per_length2: f64,
    /// Height of the line's first end, and how much higher the other is, metres.
    pub(super) height_m: [f64; 2],
    /// The radius at the first end, and how much greater it is at the other, metres.
    pub(super) radius_m: [f64; 2],
    pub is_hall: bool,
    /// Whether it lies open to the sky: then its sides slope, so that who falls in comes out again.
    pub(super) is_open: bool,
}

/// A box of noise space that is asked about.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bounds {
    pub low: DVec3,
    pub high: DVec3,
}

/// A hall, a tunnel or a way up.
#[derive(Debug)]
pub(super) struct Passage {
    pub stretches: Vec<Stretch>,
    pub bounds: Bounds,
}

/// A place about which a cave lies.
#[derive(Debug, Clone, Copy)]
pub(super) struct Knot {
    /// On the ground of noise space.
    pub ground: DVec3,
    pub height_m: f64,
    pub radius_m: f64,
    /// Of the land above, metres.
    pub surface_m: f64,
}

impl Stretch {
    pub(super) fn between(field: &Field, [from, to]: [Knot; 2], is_hall: bool) -> Self {
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
    pub(super) fn end(&self) -> DVec3 {
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

    pub(super) fn widened(&self, by_m: f64) -> Self {
        Self {
            low: self.low - by_m,
            high: self.high + by_m,
        }
    }
}

impl Passage {
    pub(super) fn new(stretches: Vec<Stretch>) -> Self {
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
