//! Who walks in a room: what is asked of them in a step, and what comes of it.

use std::f64::consts::{PI, TAU};

use antipode_deformation::{Passage, Place, Traveller, Void, Walker, What, felt_gravity, trace};
use antipode_frame::hand::HandMotion;
use antipode_rooms::direction;
use glam::{DVec2, DVec3};

use crate::bodies::{Around, Bodies, LooseSolids, Owner};
use crate::handling::Grasp;
use crate::hints::RoomHint;
use crate::righting::Righting;
use crate::scene::RoomScene;
use crate::things::{Thing, Things};
use crate::tuning::{
    ACCELERATIONS_M_S2, COYOTE_S, JUMP_BUFFER_S, JUMP_SPEED_M_S, LOST_BELOW_M, LOST_M,
    PITCH_LIMIT_RAD, RADIUS_M, SHAPE, SPRINT_FACTOR, STEP_S, TERMINAL_SPEED_M_S, WALK_SPEED_M_S,
};

/// What is asked of who walks, for one step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Steer {
    /// Forward minus backward, -1 to 1.
    pub forward: f64,
    /// Right minus left, -1 to 1.
    pub strafe: f64,
    /// Sprint held.
    pub sprint: bool,
    /// Jump held.
    pub jump: bool,
    /// Turn to the right, radians.
    pub look_yaw_rad: f64,
    /// Turn upwards, radians.
    pub look_pitch_rad: f64,
    /// Fire held: the gun shoots when it is pressed.
    pub shoot: bool,
    /// Second use held: when it is pressed, a lamp is put down, or the one under the crosshair is taken up.
    pub place: bool,
    /// What is held is thrown; a ball, if nothing is.
    pub throw: bool,
    /// What the crosshair is on is taken up, or what is held let go.
    pub grasp: bool,
}

/// See [`RoomScene::stand_at`]; metres.
const OVER_FACE_M: f64 = 1e-4;

/// Where one looks, radians: 0 is along +x, yaw goes towards +z and pitch upwards.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Look {
    /// About the upright.
    pub yaw_rad: f64,
    /// Above the level.
    pub pitch_rad: f64,
}

impl Look {
    /// Of degrees.
    pub fn of_degrees(aim_deg: DVec2) -> Self {
        let mut look = Self::default();
        look.turn(aim_deg.x.to_radians(), aim_deg.y.to_radians());
        look
    }

    /// Turns to the right and upwards.
    pub fn turn(&mut self, right_rad: f64, up_rad: f64) {
        self.yaw_rad = (self.yaw_rad + right_rad).rem_euclid(TAU);
        self.pitch_rad = (self.pitch_rad + up_rad).clamp(-PITCH_LIMIT_RAD, PITCH_LIMIT_RAD);
    }

    /// At a share of the shorter way from another to this.
    pub fn between(&self, from: &Self, share: f64) -> Self {
        let turn = (self.yaw_rad - from.yaw_rad + PI).rem_euclid(TAU) - PI;
        let mut look = *from;
        look.turn(turn * share, (self.pitch_rad - from.pitch_rad) * share);
        look
    }

    /// In degrees, yaw from -180 to 180.
    pub fn degrees(&self) -> DVec2 {
        let yaw = (self.yaw_rad.to_degrees() + 180.0).rem_euclid(360.0) - 180.0;
        DVec2::new(yaw, self.pitch_rad.to_degrees())
    }

    /// The felt direction, of length 1.
    pub fn front(&self) -> DVec3 {
        direction(self.degrees())
    }

    /// What is ahead and to the right along the ground, each of length 1; `up` is across the ground.
    pub(crate) fn level(&self, up: DVec3) -> (DVec3, DVec3) {
        let ahead = direction(DVec2::new(self.degrees().x, 0.0));
        let ahead = ahead
            .reject_from_normalized(up)
            .normalize_or(up.any_orthonormal_vector());
        (ahead, ahead.cross(up))
    }
}

/// When one may jump: a press is remembered for a while, and so is ground.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Jumps {
    held: bool,
    press_left_s: f64,
    ground_left_s: f64,
}

impl Jumps {
    /// A step passes. Whether one jumps.
    fn step(&mut self, held: bool, grounded: bool) -> bool {
        let fades = |left: f64| (left - STEP_S).max(0.0);
        self.press_left_s = if held && !self.held {
            JUMP_BUFFER_S
        } else {
            fades(self.press_left_s)
        };
        self.ground_left_s = if grounded {
            COYOTE_S
        } else {
            fades(self.ground_left_s)
        };
        self.held = held;
        let jumps = self.press_left_s > 0.0 && self.ground_left_s > 0.0;
        if jumps {
            (self.press_left_s, self.ground_left_s) = (0.0, 0.0);
        }
        jumps
    }
}

impl RoomScene {
    /// One step of [`STEP_S`].
    pub fn step(&mut self, steer: &Steer) {
        self.time_s += STEP_S;
        self.looked = self.look;
        self.look.turn(steer.look_yaw_rad, steer.look_pitch_rad);
        let gravity = self.room().gravity;
        let up = -felt_gravity(self.squeeze_here(), gravity).normalize_or(DVec3::NEG_Y);
        let wish = self.wish(steer, up);
        if self.jumps.step(steer.jump, self.walker.grounded) {
            self.walker.grounded = false;
            let falls = self.walker.body.velocity.dot(up);
            self.walker.body.velocity += up * (JUMP_SPEED_M_S - falls);
        }
        let falls_m_s = -self.walker.body.velocity.dot(up);
        let passed = self.walker.body.place.passage;
        let solids = LooseSolids {
            standing: &self.solids,
            loose: &self.loose,
        };
        self.walker
            .step(&self.space, &solids, wish, gravity, STEP_S);
        let velocity = &mut self.walker.body.velocity;
        *velocity = velocity.clamp_length_max(TERMINAL_SPEED_M_S);
        self.pass_portals(passed);
        self.hold_figure(falls_m_s);
        let solids = LooseSolids {
            standing: &self.solids,
            loose: &self.loose,
        };
        let objects = &self.document.room().objects;
        let is_loose = |what: What| match what {
            What::Object(number, _) => match Owner::numbered(number) {
                Owner::Object(object) => objects[object].mass.is_some(),
                Owner::Thrown(_) | Owner::Walker => true,
            },
            What::Wall(..) => false,
        };
        self.things.step(&self.space, &solids, gravity, is_loose);
        self.push_bodies(steer);
        self.weigh_on_bodies();
        self.push_by_bullets();
        self.carry_held();
        self.move_bodies();
        let is_lost = self.is_lost();
        self.things.keep(|point| !is_lost(point));
        self.use_hands(steer);
        if is_lost(self.walker.body.place.point) {
            self.begin_anew();
            self.hint(RoomHint::FellOut);
        }
    }

    /// What is loose goes on by a step; what falls out of the room is where its file says again.
    fn move_bodies(&mut self) {
        let middle = self.above(&self.walker.body.place, SHAPE.axis_m() / 2.0);
        let mut place = middle;
        let turn = place.straighten();
        let (up, velocity) = (self.felt_up(&middle), self.walker.body.velocity);
        let (up, velocity) = (turn * up, turn * velocity);
        self.bodies.set_who(&self.space, place, up, velocity);
        let around = Around {
            space: &self.space,
            solids: &self.solids,
            g: self.document.room().gravity,
        };
        self.bodies.step(&around);
        self.hear_knocks();
        let is_lost = self.is_lost();
        let found =
            self.bodies
                .find_again((self.document.room(), &self.poses), &self.space, is_lost);
        if found || self.bodies.have_moved() {
            self.loose = self.bodies.solids(&self.space);
        }
    }

    /// The view is turned by the portals of the last step, before which `before` was passed last, and rights itself.
    fn pass_portals(&mut self, before: Passage) {
        self.righting.pass();
        if self.walker.body.place.passage != before {
            self.look = self.righting.turn(&self.look, self.walker.turned());
            self.looked = self.look;
        }
        if self.viewing.reduced_motion {
            self.righting.right_at_once();
            self.walker.eye.right_at_once();
        }
    }

    /// The felt velocity along the ground that the step brings, on the way to what is asked.
    fn wish(&self, steer: &Steer, up: DVec3) -> DVec3 {
        let (ahead, right) = self.look.level(up);
        let pace = if steer.sprint { SPRINT_FACTOR } else { 1.0 };
        let asked = (ahead * steer.forward + right * steer.strafe).clamp_length_max(1.0);
        let asked = asked * (WALK_SPEED_M_S * pace);
        let has = self.walker.body.velocity.reject_from_normalized(up);
        let (ground, air, idle) = ACCELERATIONS_M_S2;
        let rate = match (self.walker.grounded, asked == DVec3::ZERO) {
            (true, _) => ground,
            (false, false) => air,
            (false, true) => idle,
        };
        has + (asked - has).clamp_length_max(rate * STEP_S)
    }

    /// What has fallen out of the room: farther below all that stands in it than it could come back from, or out of its bounds.
    fn is_lost(&self) -> impl Fn(DVec3) -> bool + use<> {
        let (up, lowest_m) = (self.up(), self.lowest_m - LOST_BELOW_M);
        let has_down = self.room().gravity != DVec3::ZERO;
        move |point| {
            let falls = has_down && up.dot(point) < lowest_m;
            falls || !point.abs().cmple(DVec3::splat(LOST_M)).all()
        }
    }

    /// Puts who walks back to where one begins; what they have done is forgotten.
    pub fn begin_anew(&mut self) {
        let spawn = self.room().spawn;
        self.look = Look::of_degrees(spawn.look);
        self.things = Things::default();
        self.grasp = Grasp::default();
        self.bodies = Bodies::new((self.document.room(), &self.poses), &self.space);
        self.loose = self.bodies.solids(&self.space);
        self.hands = self.hands.begun_anew();
        self.hand = HandMotion::default();
        self.hand_before = None;
        self.stand_at(spawn.at);
    }

    /// Puts the feet of who walks there, at rest.
    pub(crate) fn stand_at(&mut self, feet: DVec3) {
        // A point on a face is outside: who is put on the lower face of a box begins a little above it.
        let over = Place::at(&self.space, feet + OVER_FACE_M * self.up());
        let start = match Place::at(&self.space, feet) {
            on if on.stack == over.stack => on,
            _ => over,
        };
        let middle = self.above(&start, RADIUS_M);
        self.walker = Walker::new(middle, SHAPE);
        self.jumps = Jumps::default();
        self.righting = Righting::default();
        self.looked = self.look;
    }

    /// So many felt metres above a place, or below it.
    pub(crate) fn above(&self, place: &Place, felt_m: f64) -> Place {
        let w = self.felt_up(place) * felt_m.signum();
        trace(&self.space, place, w, felt_m.abs(), &Void, &Traveller::Body).place
    }

    /// Where the feet are, metres of the scene.
    pub fn feet(&self) -> DVec3 {
        self.above(&self.walker.body.place, -RADIUS_M).point
    }

    /// Where the middle of the lowest part of the body is, metres of the scene: a felt radius above the feet.
    pub fn middle(&self) -> DVec3 {
        self.walker.body.place.point
    }

    /// Against gravity; the upright where nothing falls. Of length 1.
    pub fn up(&self) -> DVec3 {
        -self.room().gravity.normalize_or(DVec3::NEG_Y)
    }

    /// Against felt gravity at a place in the axes of who is there, of length 1.
    pub(crate) fn felt_up(&self, place: &Place) -> DVec3 {
        let up = self.up();
        let own = place.turn.inverse() * up;
        let k = self.space.carry(place, own, &Traveller::Body);
        felt_gravity(k, up).normalize_or(own)
    }

    /// The place of the feet at a share of the way of the last step, and where one looks there, degrees of yaw and pitch, by the
    /// axes of who is there.
    pub fn feet_between(&self, share: f64) -> (Place, DVec2) {
        let (_, middle) = self.walker.between(&self.space, self.up(), share);
        let look = self.look.between(&self.looked, share);
        (self.above(&middle, -RADIUS_M), look.degrees())
    }

    /// Bullets, their marks, balls that were thrown and lamps that were put down, the oldest first.
    pub fn things(&self) -> Vec<Thing> {
        self.things_between(1.0)
    }

    /// The same at a share of the way of the last step.
    pub fn things_between(&self, share: f64) -> Vec<Thing> {
        let mut all = self.things.shown(&self.space, share);
        all.extend(self.bodies.thrown_between(&self.space, share));
        all.sort_by_key(|it| it.id);
        all
    }
}
