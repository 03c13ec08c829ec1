//! Somebody who walks: a column of balls of felt size that goes by `trace`, climbs low steps, stands on gentle slopes,
//! slides along walls and bumps its head.
//!
//! It changes its size at the middle of its lowest ball, about its feet: inside of a box it is s times smaller in the scene.

use glam::{DQuat, DVec3};

use crate::air::fly_part;
use crate::column::Around;
use crate::eye::EyeHeight;
use crate::gravity::Flyer;
use crate::place::Place;
use crate::scene::SceneQuery;
use crate::space::Space;
use crate::tuning::{LEAVES_M_S, LONGEST_PART_S, STRIDE};
use crate::walk::{Walked, walk_part};

/// What a walker is like; lengths are felt metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WalkerShape {
    /// Radius of its balls.
    pub radius_m: f64,
    /// From the feet to the crown, at least twice the radius.
    pub height_m: f64,
    /// Height of the eye above the middle of the lowest ball.
    pub eye_m: f64,
    /// Highest step that is climbed, and deepest that is followed down.
    pub step_m: f64,
    /// Slopes up to this angle carry, radians.
    pub steepest_rad: f64,
}

impl WalkerShape {
    /// From the middle of the lowest ball to that of the highest.
    pub fn axis_m(&self) -> f64 {
        (self.height_m - 2.0 * self.radius_m).max(0.0)
    }

    /// Whether a contact carries: its own direction is gentle enough, as on a ridge, or it is the lip of a gentle face
    /// under the lowest ball, as on a step. Both are told by how upright they are, 0 to 1.
    pub(crate) fn carries(&self, normal_up: f64, face_up: f64, least_lip_up: f64) -> bool {
        let least_up = self.steepest_rad.cos();
        normal_up >= least_up || (face_up >= least_up && normal_up > least_lip_up)
    }
}

/// Somebody who walks.
#[derive(Clone, Debug, PartialEq)]
pub struct Walker {
    /// The middle of its lowest ball and its felt velocity.
    pub body: Flyer,
    /// Whether it stands or walks on something.
    pub grounded: bool,
    /// Where its eye is.
    pub eye: EyeHeight,
    shape: WalkerShape,
    /// Places of the eye and of the middle at the ends of the parts of the last step, its beginning first.
    way: Vec<(Place, Place)>,
    /// How portals have turned it in the last step.
    turned: DQuat,
}

impl Walker {
    /// Somebody who stands in the air at a place.
    pub fn new(place: Place, shape: WalkerShape) -> Self {
        Self {
            body: Flyer {
                place,
                velocity: DVec3::ZERO,
            },
            grounded: false,
            eye: EyeHeight::new(shape.eye_m),
            shape,
            way: Vec::new(),
            turned: DQuat::IDENTITY,
        }
    }

    /// What it is like.
    pub fn shape(&self) -> &WalkerShape {
        &self.shape
    }

    /// The place of the eye; `up` is the scene's.
    pub fn eye_place(&self, space: &Space, up: DVec3) -> Place {
        self.eye.place(space, &self.body.place, up)
    }

    /// Places of the eye and of the middle of the lowest ball, whose turns count from the axes of now, at a share of the way of the last step, 0 at its beginning
    /// and 1 at its end; between two parts of it along the line from one to the other, through faces too.
    pub fn between(&self, space: &Space, up: DVec3, share: f64) -> (Place, Place) {
        let last = (self.eye_place(space, up), self.body.place);
        let Some(parts) = self.way.len().checked_sub(1).filter(|parts| *parts > 0) else {
            return last;
        };
        let along = share.clamp(0.0, 1.0) * parts as f64;
        let part = (along.floor() as usize).min(parts - 1);
        let (from, to) = (&self.way[part], &self.way[part + 1]);
        let share = along - part as f64;
        (
            Place::between(space, &from.0, &to.0, share),
            Place::between(space, &from.1, &to.1, share),
        )
    }

    /// How portals have turned it in the last step: takes directions before to what they are now.
    pub fn turned(&self) -> DQuat {
        self.turned
    }

    /// Forgets the way of the last step, as when the space has changed.
    pub fn stay(&mut self) {
        self.way.clear();
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
        let mut wish = wish;
        let mut eye = self.eye_place(space, up);
        self.way.clear();
        self.way.push((eye, self.body.place));
        for _ in 0..parts as usize {
            let heading = if wish == DVec3::ZERO {
                self.body.velocity
            } else {
                wish
            };
            let around = Around {
                space,
                scene,
                g,
                heading,
            };
            let before = self.body.place;
            self.go(&around, wish, time / parts);
            self.eye.glide(time / parts);
            let place = &self.body.place;
            if place.passage != before.passage {
                self.eye.lean(space, (&before, place), up);
                // What was a fall may lead along the ground now.
                wish = self.body.velocity.reject_from(around.up(place));
            } else if place.stack != before.stack {
                self.eye.keep(space, place, up, eye.point);
            }
            self.eye.duck(space, scene, &self.body.place, up);
            eye = self.eye_place(space, up);
            self.way.push((eye, self.body.place));
        }
        self.straighten();
    }

    /// Takes the axes of the scene for its own again.
    fn straighten(&mut self) {
        self.turned = self.body.straighten();
        self.eye.straighten(self.turned);
        let back = self.turned.inverse();
        for (eye, middle) in &mut self.way {
            eye.turn *= back;
            middle.turn *= back;
        }
    }

    /// Walks while there is ground, else flies.
    fn go(&mut self, around: &Around<'_>, wish: DVec3, time: f64) {
        let up = around.up(&self.body.place);
        let wish = wish - wish.dot(up) * up;
        let rises = self.body.velocity.dot(up);
        if self.grounded && rises < LEAVES_M_S {
            let from = Walked {
                place: self.body.place,
                velocity: wish,
            };
            if let Some(walked) = walk_part(around, &self.shape, &from, time) {
                self.body = Flyer {
                    place: walked.place,
                    velocity: walked.velocity,
                };
                return;
            }
        }
        self.body.velocity = wish + rises * up;
        self.grounded = fly_part(around, &self.shape, &mut self.body, time);
    }
}
