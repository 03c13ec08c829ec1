//! A ball that is thrown: it keeps its felt size, flies, bounces, rolls and comes to rest.
//!
//! Its middle flies by [`Flyer`], so that |u|^2/2 - g.x is kept through any box. Where it is found to reach into something it
//! is moved out, by dx in the scene. That it should have met it sooner, or has grown where it left a box, costs what the
//! way is worth: |u|^2 falls by 2 g.(-dx), first of what goes into the surface. So it gains nothing anywhere, and what
//! it cannot pay for it does not do.

use glam::{DQuat, DVec3};

use crate::column::Around;
use crate::gravity::Flyer;
use crate::place::Place;
use crate::scene::SceneQuery;
use crate::space::Space;
use crate::tuning::{
    FASTEST_M_S, LEAST_BOUNCE_M_S, LEFT_OVER_M, LONGEST_PART_S, PUSHES, RESTS_AFTER_S,
    RESTS_BELOW_M_S, STRIDE, TOUCH_M,
};

/// What a ball is like.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BallShape {
    /// Felt radius, metres.
    pub radius_m: f64,
    /// Share of the speed into a surface that comes back out of it, 0 to 1.
    pub bounce: f64,
    /// Share of the speed along a surface that a bounce leaves, 0 to 1.
    pub slide: f64,
    /// What it loses of its speed where it rolls, felt metres per second squared.
    pub rolling_m_s2: f64,
}

/// A ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    /// Its middle and its felt velocity.
    pub body: Flyer,
    /// How it is turned in the axes of the scene, as it feels.
    pub turn: DQuat,
    shape: BallShape,
    /// How long it has been slow, seconds.
    slow_s: f64,
}

impl Ball {
    /// A ball that leaves a hand.
    pub fn thrown(place: Place, velocity: DVec3, shape: BallShape) -> Self {
        Self {
            body: Flyer { place, velocity },
            turn: DQuat::IDENTITY,
            shape,
            slow_s: 0.0,
        }
    }

    /// Whether it lies still; it does until [`Ball::wake`].
    pub fn rests(&self) -> bool {
        self.slow_s >= RESTS_AFTER_S
    }

    /// What it lies on may have gone.
    pub fn wake(&mut self) {
        self.slow_s = 0.0;
    }

    /// Goes on for `time` seconds under gravity `g` of the scene, m/s^2.
    pub fn step(&mut self, space: &Space, scene: &dyn SceneQuery, g: DVec3, time: f64) {
        if self.rests() {
            return;
        }
        let speed = self.body.velocity.length() + g.length() * time;
        let by_way = time * speed / (self.shape.radius_m * STRIDE);
        let parts = (time / LONGEST_PART_S).max(by_way).ceil().clamp(1.0, 1e4);
        for _ in 0..parts as usize {
            let around = Around {
                space,
                scene,
                g,
                heading: self.body.velocity,
            };
            self.go(&around, time / parts);
            if self.body.velocity.length() < RESTS_BELOW_M_S {
                self.slow_s += time / parts;
            } else {
                self.slow_s = 0.0;
            }
        }
        if self.rests() {
            self.body.velocity = DVec3::ZERO;
        }
        self.body.velocity = self.body.velocity.clamp_length_max(FASTEST_M_S);
        self.turn = self.body.straighten() * self.turn;
    }

    /// Goes on for a part of a step.
    fn go(&mut self, around: &Around<'_>, time: f64) {
        let before = self.body;
        let mut touches = false;
        // Its middle goes through nothing, however close to something it was let go.
        if let Some((hit, _)) = self.body.fly(around.space, around.scene, around.g, time) {
            self.turn_off(hit.felt_normal, 0.0);
            self.body.place = around.carried(&self.body.place, hit.felt_normal * TOUCH_M);
            touches = true;
        }
        for _ in 0..PUSHES {
            let frame = around.frame(&self.body.place);
            let Some(contact) = around.in_ball(&frame, self.shape.radius_m, TOUCH_M) else {
                break;
            };
            touches = true;
            let normal = frame.upright.transpose() * contact.normal;
            let from = self.body.place;
            self.body.place = around.carried(&from, normal * contact.depth);
            let gained = gained(&from, &self.body.place, around.g);
            if !self.turn_off(normal, gained) {
                self.go_back(&before);
                return;
            }
            self.roll(normal, time);
        }
        let frame = around.frame(&self.body.place);
        if touches
            && around
                .in_ball(&frame, self.shape.radius_m, LEFT_OVER_M)
                .is_some()
        {
            self.go_back(&before);
        }
    }

    /// There is no way on.
    fn go_back(&mut self, before: &Flyer) {
        self.body = Flyer {
            place: before.place,
            velocity: -self.shape.bounce * before.velocity,
        };
    }

    /// Leaves a surface of that felt normal after it was moved out of it, at a gain of `gained` J/kg; whether it had as
    /// much to give.
    fn turn_off(&mut self, normal: DVec3, gained: f64) -> bool {
        let velocity = self.body.velocity;
        let into = -velocity.dot(normal);
        let along = velocity + into * normal;
        let square = into.max(0.0).powi(2) - 2.0 * gained;
        if into > 0.0 && square >= 0.0 {
            let into = square.sqrt();
            self.body.velocity = if into > LEAST_BOUNCE_M_S {
                along * self.shape.slide + normal * (into * self.shape.bounce)
            } else {
                along
            };
            return true;
        }
        let owed = -square;
        let rest = if into > 0.0 { along } else { velocity };
        let left = rest.length_squared() - owed;
        // To rounding it owes nothing where it lies.
        self.body.velocity = rest.normalize_or_zero() * left.max(0.0).sqrt();
        left >= -1e-6
    }

    /// Is slowed and turned by what it rolls on.
    fn roll(&mut self, normal: DVec3, time: f64) {
        let speed = self.body.velocity.length();
        let left = (speed - self.shape.rolling_m_s2 * time).max(0.0);
        self.body.velocity *= left / speed.max(1e-12);
        let axis = normal.cross(self.body.velocity);
        let spun = DQuat::from_scaled_axis(axis * (time / self.shape.radius_m));
        self.turn = (spun * self.turn).normalize();
    }
}

/// What a push from one place to another is worth, J/kg of the ball's own size. One through a portal is worth nothing.
fn gained(from: &Place, to: &Place, g: DVec3) -> f64 {
    if from.passage != to.passage {
        return 0.0;
    }
    -g.dot(to.point - from.point) / to.scale
}
