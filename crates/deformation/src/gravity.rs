//! What falls: gravity inside of boxes, and bodies in flight.
//!
//! With felt velocity u the scene's velocity is K u. Of the energy E = |u|^2/2 - g.x the rate is u.(du/dt) - g.(K u), which is
//! nought for du/dt = K^T g. u does not change at a face and x has no jump there, so E is kept through any box; a felt g that
//! were the same everywhere would gain by every loop.
//!
//! A portal that scales by q takes a whole scene, its gravity included, to one q times as large: per own size everything falls as
//! before, so that with x' = m K u the rate is du/dt = K^T g, and |u|^2/2 - g.x/m is kept between portals.

use glam::{DMat3, DQuat, DVec3};

use crate::face::{Crossing, State, cross};
use crate::next::{Next, first_solid, next_event};
use crate::place::Place;
use crate::scene::SceneQuery;
use crate::space::{Space, Traveller};
use crate::trace::{Hit, MAX_EVENTS, What, struck};
use crate::tuning::LONGEST_PART_S;

/// Felt acceleration inside of boxes of product K, of gravity `g` of the scene, m/s^2.
pub fn felt_gravity(k: DMat3, g: DVec3) -> DVec3 {
    k.transpose() * g
}

/// A point that flies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flyer {
    /// Where it is.
    pub place: Place,
    /// Felt velocity in its own axes and sizes, m/s.
    pub velocity: DVec3,
}

impl Flyer {
    /// Flies for `time` seconds, or until it hits something: then that and the time that is left.
    pub fn fly(
        &mut self,
        space: &Space,
        scene: &dyn SceneQuery,
        g: DVec3,
        time: f64,
    ) -> Option<(Hit, f64)> {
        let parts = (time / LONGEST_PART_S).ceil().max(1.0);
        let part = time / parts;
        for done in 0..parts as usize {
            if let Some((hit, left)) = self.fly_part(space, scene, g, part) {
                return Some((hit, left + part * (parts - 1.0 - done as f64)));
            }
        }
        None
    }

    /// The same for a part so short that its parabola is as good as its chord. At a face the clock is set by the energy
    /// rather than by the chord's share: that is what keeps it to rounding.
    fn fly_part(
        &mut self,
        space: &Space,
        scene: &dyn SceneQuery,
        g: DVec3,
        time: f64,
    ) -> Option<(Hit, f64)> {
        let mut left = time;
        for _ in 0..MAX_EVENTS {
            let k = space.carry(&self.place, self.velocity, &Traveller::Body);
            let a = felt_gravity(k, g) / self.place.scale;
            let chord = self.velocity * left + a * (0.5 * left * left);
            let length = chord.length();
            if length == 0.0 {
                self.velocity += a * left;
                return None;
            }
            let v = k * (chord / length);
            let (mut way, next) = next_event(space, &self.place, v, length);
            let hit = first_solid(space, &self.place, v, (way, next), scene);
            way = hit.map_or(way, |hit| hit.time);
            self.place.point += v * way;
            if next == Next::Spent && hit.is_none() {
                self.velocity += a * left;
                return None;
            }
            let passed = time_along(
                self.velocity,
                a,
                chord * (way / length),
                left * way / length,
            )
            .min(left);
            self.velocity += a * passed;
            left -= passed;
            if let Some(hit) = hit {
                let what = What::Object(hit.object, hit.part);
                return Some((struck(k, v, hit.normal, what), left));
            }
            if let Some((normal, what)) = self.meet(space, next) {
                return Some((struck(k, v, normal, what), left));
            }
        }
        None
    }

    /// Goes through what comes next; the wall of a box does not let it.
    fn meet(&mut self, space: &Space, next: Next) -> Option<(DVec3, What)> {
        match next {
            Next::Face {
                number,
                axis,
                enters,
            } => {
                let is_wall = self.cross(space, (number, axis), enters) == Crossing::Wall;
                let normal = space.placed()[number].axes.col(axis);
                is_wall.then_some((normal, What::Wall(number, axis)))
            }
            Next::Portal { number, front } => {
                // Its velocity is that of its own axes and sizes, and stays.
                let mut state = self.state();
                state.pass(space, &mut self.place, number, front);
                None
            }
            Next::Spent => None,
        }
    }

    fn cross(&mut self, space: &Space, face: (usize, usize), enters: bool) -> Crossing {
        let speed = self.velocity.length();
        let mut state = self.state();
        let crossing = cross(space, &mut state, face, enters, &Traveller::Body);
        self.place.stack = state.stack;
        self.velocity = self.place.turn.inverse() * state.w * speed;
        crossing
    }

    fn state(&self) -> State {
        let w = self.place.turn * (self.velocity / self.velocity.length().max(1e-300));
        State {
            w,
            stack: self.place.stack,
            unbent: w,
        }
    }

    /// Takes the axes of the scene for its own again; returns the turn from those that it had.
    pub fn straighten(&mut self) -> DQuat {
        let turn = self.place.straighten();
        self.velocity = turn * self.velocity;
        turn
    }
}

/// The time t in which a body of velocity u and acceleration a has fallen as far along a as `way` leads: of
/// a^2 t^2/2 + (u.a) t = a.way the root next to `about`. Then |u + a t|^2 - |u|^2 = 2 a.way.
fn time_along(u: DVec3, a: DVec3, way: DVec3, about: f64) -> f64 {
    let (square, rate, height) = (a.length_squared(), u.dot(a), a.dot(way));
    if square < 1e-20 {
        return about;
    }
    let root = (rate * rate + 2.0 * square * height).max(0.0).sqrt();
    let times = [(root - rate) / square, (-root - rate) / square];
    let nearer = |t: f64| (t - about).abs();
    let best = if nearer(times[0]) <= nearer(times[1]) {
        times[0]
    } else {
        times[1]
    };
    best.max(0.0)
}
