//! A walker: a ball of felt radius that goes by `trace`, slides along solids and stands on gentle slopes.
//!
//! Solids are met in felt metres about the ball's middle: corners are carried there by A = K^-1, K being that of the boxes
//! that the middle is in, and the ball is a ball there. Inside of a box it is therefore s times smaller in the scene.

use glam::{DMat3, DVec3};

use crate::eye::EyeHeight;
use crate::gravity::{Flyer, felt_gravity};
use crate::scene::{SceneQuery, Void};
use crate::space::{Space, Traveller};
use crate::trace::{Place, trace};
use crate::tuning::{LONGEST_PART_S, STEEPEST_RAD, STRIDE};

/// What a walker is like.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WalkerShape {
    /// Felt radius, metres.
    pub radius_m: f64,
    /// Felt height of the eye above the ball's middle, metres.
    pub eye_m: f64,
}

/// Somebody who walks.
#[derive(Clone, Debug, PartialEq)]
pub struct Walker {
    /// Its middle and its felt velocity.
    pub body: Flyer,
    /// Felt normal of the ground that it stands on.
    pub ground: Option<DVec3>,
    /// Where its eye is.
    pub eye: EyeHeight,
    shape: WalkerShape,
}

impl Walker {
    /// Somebody who stands in the air at a place.
    pub fn new(place: Place, shape: WalkerShape) -> Self {
        Self {
            body: Flyer {
                place,
                velocity: DVec3::ZERO,
            },
            ground: None,
            eye: EyeHeight::new(shape.eye_m),
            shape,
        }
    }

    /// The place of the eye; `up` is the scene's.
    pub fn eye_place(&self, space: &Space, up: DVec3) -> Place {
        self.eye.place(space, &self.body.place, up)
    }

    /// Goes on for `time` seconds at felt velocity `wish`, m/s along the ground, under gravity `g` of the scene, m/s^2.
    pub fn step(
        &mut self,
        space: &Space,
        scene: &dyn SceneQuery,
        wish: DVec3,
        g: DVec3,
        time: f64,
    ) {
        let speed = self.body.velocity.length().max(wish.length()) + g.length() * time;
        let by_way = time * speed / (self.shape.radius_m * STRIDE);
        let parts = (time / LONGEST_PART_S).max(by_way).ceil().clamp(1.0, 1e4);
        let up = -g.normalize_or(DVec3::NEG_Y);
        for _ in 0..parts as usize {
            let before = (self.body, self.eye_place(space, up).point);
            self.go(space, wish, g, time / parts);
            if !self.clear(space, scene, g) {
                // Too big for what it came into.
                self.body = Flyer {
                    velocity: DVec3::ZERO,
                    ..before.0
                };
            }
            self.eye.glide(time / parts);
            if self.body.place.stack != before.0.place.stack {
                self.eye.keep(space, &self.body.place, up, before.1);
            }
        }
    }

    /// Moves as if there were no solids.
    fn go(&mut self, space: &Space, wish: DVec3, g: DVec3, time: f64) {
        let k = space.squeeze(&self.body.place.stack, self.body.velocity, &Traveller::Body);
        let up = -felt_gravity(k, g).normalize_or(DVec3::NEG_Y);
        match self.ground {
            // On the ground nothing pulls along it.
            Some(normal) if self.body.velocity.dot(normal) < 0.1 => {
                let along = wish - wish.dot(normal) * normal;
                self.body.velocity = along - normal * (felt_gravity(k, g).length() * time);
                self.body.fly(space, &Void, DVec3::ZERO, time);
            }
            _ => {
                let fall = self.body.velocity.dot(up);
                self.body.velocity = wish - wish.dot(up) * up + fall * up;
                self.body.fly(space, &Void, g, time);
            }
        }
    }

    /// Moves out of all solids and keeps what it has of velocity along them; whether it could.
    fn clear(&mut self, space: &Space, scene: &dyn SceneQuery, g: DVec3) -> bool {
        let slack = 1e-6 * self.shape.radius_m;
        self.ground = None;
        for _ in 0..12 {
            let k = space.squeeze(&self.body.place.stack, self.body.velocity, &Traveller::Body);
            let Some(out) = self
                .deepest(space, scene, k)
                .filter(|out| out.length() > slack)
            else {
                return true;
            };
            let normal = out.normalize();
            let up = -felt_gravity(k, g).normalize_or(DVec3::NEG_Y);
            if normal.dot(up) > STEEPEST_RAD.cos() {
                self.ground = Some(normal);
            }
            self.body.velocity -= self.body.velocity.dot(normal).min(0.0) * normal;
            let path = trace(
                space,
                &self.body.place,
                normal,
                out.length(),
                &Void,
                &Traveller::Body,
            );
            self.body.place = path.place;
        }
        false
    }

    /// How far and which way, in felt metres, it must go to be out of the solid that it is deepest in.
    fn deepest(&self, space: &Space, scene: &dyn SceneQuery, k: DMat3) -> Option<DVec3> {
        let (centre, radius) = (self.body.place.point, self.shape.radius_m);
        let into_felt = k.inverse();
        let rows = k.transpose();
        let reach = radius
            * DVec3::new(
                rows.x_axis.length(),
                rows.y_axis.length(),
                rows.z_axis.length(),
            );
        let mut nearest = (radius, None);
        let mut look = |corners: [DVec3; 3]| {
            let felt = corners.map(|corner| into_felt * (corner - centre));
            let closest = closest_to_origin(felt);
            let away = closest.length();
            if away < nearest.0 {
                let normal = if away > 1e-9 * radius {
                    -closest / away
                } else {
                    (felt[1] - felt[0])
                        .cross(felt[2] - felt[0])
                        .normalize_or(DVec3::Y)
                };
                nearest = (away, Some(normal));
            }
        };
        scene.near(centre - reach, centre + reach, &mut look);
        space.walls_near(centre - reach, centre + reach, &mut look);
        nearest.1.map(|normal| normal * (radius - nearest.0))
    }
}

/// The point of a triangle next to the origin (C. Ericson, Real-Time Collision Detection, 5.1.5).
fn closest_to_origin([a, b, c]: [DVec3; 3]) -> DVec3 {
    let (ab, ac) = (b - a, c - a);
    let (d1, d2) = (-ab.dot(a), -ac.dot(a));
    if d1 <= 0.0 && d2 <= 0.0 {
        return a;
    }
    let (d3, d4) = (-ab.dot(b), -ac.dot(b));
    if d3 >= 0.0 && d4 <= d3 {
        return b;
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return a + ab * (d1 / (d1 - d3));
    }
    let (d5, d6) = (-ab.dot(c), -ac.dot(c));
    if d6 >= 0.0 && d5 <= d6 {
        return c;
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        return a + ac * (d2 / (d2 - d6));
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 >= d3 && d5 >= d6 {
        return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
    }
    let whole = va + vb + vc;
    if whole == 0.0 {
        return a;
    }
    a + ab * (vb / whole) + ac * (vc / whole)
}
