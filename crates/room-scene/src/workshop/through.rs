//! A picture through one chain of faces and portals: from its places to those of the room behind the chain, and back.
//!
//! Behind the chain the ray of a place of the picture is x + s v, where x and v are smooth functions of that place
//! ([`Chain`]). A point T of the room is seen where T - x - s v = 0 for some s > 0; its two parts across v are made nought by
//! Newton's method, whose derivatives are differences.

use antipode_deformation::{Chain, Leg, Place, Space, Traveller, Void, trace};
use glam::{DMat2, DQuat, DVec2, DVec3};

use super::sight::Viewpoint;
use crate::scene::RoomScene;
use crate::tuning::PICK_M;

/// Steps of Newton's method at most.
const STEPS: u32 = 24;
/// A place of a picture is found to this share of its half height: less than a thousandth of a pixel.
const NEAR: f64 = 1e-9;
/// By how much a place is moved for a difference.
const ASIDE: f64 = 1e-6;
/// Longest step, in half heights of the picture.
const LONGEST: f64 = 0.5;
/// How far outside of the picture a place may be told, in half heights.
const FARTHEST: f64 = 20.0;

/// A picture through a chain.
#[derive(Clone, Debug)]
pub struct Through<'a> {
    space: &'a Space,
    /// From where.
    pub view: Viewpoint,
    /// Through what.
    pub chain: Chain,
}

impl<'a> Through<'a> {
    /// The picture through that chain.
    pub fn new(space: &'a Space, view: Viewpoint, chain: Chain) -> Self {
        Self { space, view, chain }
    }

    /// The ray behind the chain of a place of the picture.
    pub fn leg(&self, at: DVec2) -> Option<Leg> {
        let w = self.view.direction(at);
        let start = &self.view.start(at);
        self.chain.follow(self.space, start, w, &Traveller::Body)
    }

    /// The point of a line that is seen nearest to a place of the picture. `along` is of length 1.
    pub fn on_line(&self, at: DVec2, origin: DVec3, along: DVec3) -> Option<DVec3> {
        let leg = self.leg(at)?;
        let v = leg.velocity.normalize();
        // The points of two lines that are nearest to each other: with b = a.v, t (1 - b^2) = (x - o).(a - b v).
        let b = along.dot(v);
        let across = 1.0 - b * b;
        if across < 1e-6 {
            return None;
        }
        let mut t = (leg.place.point - origin).dot(along - b * v) / across;
        // Nearest in the room is not nearest in the picture.
        for _ in 0..4 {
            let point = origin + along * t;
            let seen = self.seen_at(point, at)?;
            let step = 1e-4 * (1.0 + t.abs());
            let next = self.seen_at(point + along * step, seen)?;
            let slope = self.view.spread(next - seen) / step;
            let change = self.view.spread(at - seen).dot(slope) / slope.length_squared();
            if !change.is_finite() {
                return None;
            }
            t += change;
        }
        Some(origin + along * t)
    }

    /// The point of a plane that is seen at a place of the picture. `normal` is of length 1.
    pub fn on_plane(&self, at: DVec2, origin: DVec3, normal: DVec3) -> Option<DVec3> {
        let leg = self.leg(at)?;
        let time = (origin - leg.place.point).dot(normal) / leg.velocity.dot(normal);
        let ahead = time.is_finite() && time > 0.0;
        ahead.then(|| leg.place.point + leg.velocity * time)
    }

    /// Where a point of the room is seen, sought from a place of the picture on; none where it is not through this chain.
    pub fn seen_at(&self, point: DVec3, from: DVec2) -> Option<DVec2> {
        if self.is_straight() {
            let at = self.view.place_of(point - self.view.eye.place.point);
            return at.filter(|at| at.abs().max_element() <= FARTHEST);
        }
        let mut at = from;
        for _ in 0..STEPS {
            let off = Off::of(&self.leg(at)?, point);
            let aside = |way: DVec2| Some((off.measure(&self.leg(at + way)?) - off.miss) / ASIDE);
            let slopes = DMat2::from_cols(
                aside(DVec2::new(ASIDE, 0.0))?,
                aside(DVec2::new(0.0, ASIDE))?,
            );
            let step = -(slopes.inverse() * off.miss);
            if !step.is_finite() {
                return None;
            }
            let length = self.view.spread(step).length();
            at += step * (LONGEST / length).min(1.0);
            if at.abs().max_element() > FARTHEST {
                return None;
            }
            if length < NEAR {
                return off.is_ahead.then_some(at);
            }
        }
        None
    }

    /// Whether the rays are straight from an eye in no box: the room is seen in perspective then.
    fn is_straight(&self) -> bool {
        let place = &self.view.eye.place;
        let is_free = place.stack.is_empty() && place.turn == DQuat::IDENTITY;
        self.chain.is_empty() && is_free && place.scale == 1.0
    }

    /// How many metres of the room at a point are as wide in the picture as its half height, along the widest of three axes.
    pub fn metres_across(&self, point: DVec3, from: DVec2) -> Option<f64> {
        let at = self.seen_at(point, from)?;
        let leg = self.leg(at)?;
        let far = (point - leg.place.point).length().max(1e-3);
        let step = 1e-4 * far;
        let widths = DVec3::AXES.map(|axis| {
            let next = self.seen_at(point + axis * step, at);
            next.map_or(0.0, |next| self.view.apart(at, next))
        });
        let width = widths.into_iter().fold(0.0, f64::max);
        (width > 0.0).then(|| step / width)
    }
}

/// By how much a ray misses a point, across the ray.
struct Off {
    point: DVec3,
    across: [DVec3; 2],
    /// Along the ray.
    along: DVec3,
    miss: DVec2,
    is_ahead: bool,
}

impl Off {
    fn of(leg: &Leg, point: DVec3) -> Self {
        let along = leg.velocity.normalize();
        let across: [DVec3; 2] = along.any_orthonormal_pair().into();
        let mut off = Self {
            point,
            across,
            along,
            miss: DVec2::ZERO,
            is_ahead: (point - leg.place.point).dot(along) > 0.0,
        };
        off.miss = off.measure(leg);
        off
    }

    /// The same of a ray near by.
    fn measure(&self, leg: &Leg) -> DVec2 {
        let to = self.point - leg.place.point;
        let rest = to - leg.velocity * (to.dot(self.along) / leg.velocity.dot(self.along));
        DVec2::new(rest.dot(self.across[0]), rest.dot(self.across[1]))
    }
}

impl RoomScene {
    /// The picture through a chain.
    pub fn through(&self, view: &Viewpoint, chain: Chain) -> Through<'_> {
        Through::new(&self.space, *view, chain)
    }

    /// The nearest way by which a point of the room could be seen if nothing stood before it, and where in the picture. The way
    /// is the straight one, and the aberrations that it goes through; none where that does not lead there. What is `beside` is gone
    /// by as if it were not there: an aberration, by its place among the objects, is itself held from outside, and so are those of a group.
    pub fn way_to(
        &self,
        view: &Viewpoint,
        point: DVec3,
        beside: &[usize],
    ) -> Option<(Through<'_>, DVec2)> {
        let boxes = self.boxes.iter().enumerate();
        let own: Vec<usize> = boxes
            .filter(|(_, object)| beside.contains(object))
            .map(|(number, _)| number)
            .collect();
        let start = &view.eye.place;
        let wanted = Place::at(&self.space, point);
        let k = self.space.carry(start, view.eye.front, &Traveller::Body);
        let mut at = view.place_of(k.inverse() * (point - start.point))?;
        let mut chain = Chain::default();
        for _ in 0..8 {
            let (found, nearest) = self.chain_near(view, at, (&wanted, &own))?;
            let through = self.through(view, found.clone());
            let seen = through.seen_at(point, at).unwrap_or(nearest);
            let settled = found == chain && view.apart(seen, at) < NEAR.sqrt();
            (chain, at) = (found, seen);
            if settled {
                break;
            }
        }
        let through = self.through(view, chain);
        let at = through.seen_at(point, at)?;
        Some((through, at))
    }

    /// The part of the way of a place of the picture that ends in the boxes in which a place is and comes nearest to it.
    fn chain_near(
        &self,
        view: &Viewpoint,
        at: DVec2,
        (wanted, beside): (&Place, &[usize]),
    ) -> Option<(Chain, DVec2)> {
        let around = |number: &usize| !beside.contains(number);
        let boxes: Vec<_> = wanted.stack.iter().filter(around).collect();
        let start = &view.start(at);
        let w = view.direction(at);
        let who = Traveller::Body;
        let path = trace(&self.space, start, w, PICK_M, &Void, &who);
        let whole = Chain::of(&self.space, start, &path);
        let lengths = (0..=whole.len()).filter_map(|count| {
            let chain = whole.first(count);
            let leg = chain.follow(&self.space, start, w, &who)?;
            let stack = leg.place.stack.iter().filter(around);
            if !stack.eq(boxes.iter().copied()) {
                return None;
            }
            let to = wanted.point - leg.place.point;
            // Of ways that miss it alike the shortest is meant.
            let miss = to.reject_from(leg.velocity).length() + NEAR * count as f64;
            Some((miss, chain))
        });
        let best = lengths.min_by(|a, b| a.0.total_cmp(&b.0));
        best.map(|(_, chain)| (chain, at))
    }
}
