//! What hands do in a room: shoot, throw, put lamps down and take them up.

use antipode_deformation::{Flyer, Place, Trace, Traveller, Void, trace};
use antipode_rays::MAX_LAMPS;
use antipode_rooms::What as Kind;
use glam::{DMat3, DVec3};

use crate::hints::RoomHint;
use crate::scene::RoomScene;
use crate::sounds::RoomSound;
use crate::things::{Thing, ThingKind};
use crate::tuning::{
    AIM_REACH_M, BULLET_SPEED_M_S, LAMP_BODY_M, LAMP_GRIP_M, MOST_BALLS, MUZZLE_M, REACH_M,
    SHOT_EVERY_S, STEP_S, THROW_RISE, THROW_SPEED_M_S, THROWN,
};
use crate::walk::Steer;

/// So many pulls of the trigger are remembered while the gun rests: who pulls twice within a slow frame shoots twice.
const MOST_PULLS: u32 = 3;
/// The share of the way to the muzzle that is left when a wall is nearer.
const SHORT_OF_WALL: f64 = 0.9;
/// How often a shot is aimed anew, and how near it has to come, felt metres.
const AIMS: usize = 20;
const AIMED_M: f64 = 0.0005;
/// What is nearer than this, felt metres, is not aimed at from the muzzle.
const NEAREST_AIM_M: f64 = 1.0;
/// Places on a way at which it is asked how space is stretched.
const SAMPLES: u32 = 16;
/// A shot is aimed at a place so far before what it is to hit, felt metres.
const SHORT_OF_TARGET_M: f64 = 0.1;

/// What hands have done.
#[derive(Clone, Copy, Debug, Default)]
pub struct Hands {
    shoots: bool,
    places: bool,
    /// Pulls of the trigger that the gun has not answered: it rests after a shot.
    pulls: u32,
    /// Until the gun shoots again, seconds.
    gun_rests_s: f64,
}

impl Hands {
    /// Who begins anew with a button down has not pressed it again.
    pub fn begun_anew(self) -> Self {
        Self {
            shoots: self.shoots,
            places: self.places,
            ..Self::default()
        }
    }
}

impl RoomScene {
    /// Does what hands are asked for in a step.
    pub(crate) fn use_hands(&mut self, steer: &Steer) {
        let before = self.hands;
        let pulled = u32::from(steer.shoot && !before.shoots);
        self.hands = Hands {
            shoots: steer.shoot,
            places: steer.place,
            pulls: (before.pulls + pulled).min(MOST_PULLS),
            gun_rests_s: (before.gun_rests_s - STEP_S).max(0.0),
        };
        if self.hands.pulls > 0 && self.hands.gun_rests_s <= 0.0 {
            self.hands.pulls -= 1;
            self.hands.gun_rests_s = SHOT_EVERY_S;
            let shot = self.shot();
            self.things.shoot(shot);
            self.hand.fire();
            self.sound(RoomSound::Shot);
        }
        if steer.grasp {
            self.grasp();
        }
        if steer.throw && !self.hurl() {
            let thrown = self.thrown();
            let number = self.things.count_one();
            self.bodies.throw(&self.space, number, thrown, MOST_BALLS);
        }
        if steer.place && !before.places {
            self.use_lamp();
        }
    }

    /// What the eye sees along its front within a felt reach.
    fn sight(&self, reach: f64) -> (Place, DVec3, Trace) {
        let eye = self.walker.eye_place(&self.space, self.up());
        let front = self.look.front();
        let path = trace(
            &self.space,
            &eye,
            front,
            reach,
            &self.all_solids(),
            &Traveller::Body,
        );
        (eye, front, path)
    }

    /// A place beside the eye, felt metres to the right, up and ahead, short of what is in the way.
    pub(crate) fn beside(
        &self,
        eye: &Place,
        front: DVec3,
        (right, up, ahead): (f64, f64, f64),
    ) -> Place {
        let side = front.cross(DVec3::Y).normalize_or(DVec3::X);
        let way = side * right + side.cross(front) * up + front * ahead;
        let (length, w) = (way.length(), way.normalize_or(front));
        let solids = self.all_solids();
        let all = |longest: f64| trace(&self.space, eye, w, longest, &solids, &Traveller::Body);
        let path = all(length);
        if path.hit().is_some() {
            return all(SHORT_OF_WALL * path.length).place;
        }
        path.place
    }

    /// A bullet at the muzzle, on its way to what the crosshair covers.
    fn shot(&self) -> Flyer {
        let (eye, front, sight) = self.sight(AIM_REACH_M);
        // Short of it, so that what it is on does not end the flights by which the shot is aimed.
        let short = (sight.length - SHORT_OF_TARGET_M).max(0.0);
        let body = Traveller::Body;
        let target = trace(&self.space, &eye, front, short, &Void, &body).place;
        let muzzle = self.beside(&eye, front, MUZZLE_M);
        let gravity = self.room().gravity;
        let time = (short - MUZZLE_M.2).max(0.05) / BULLET_SPEED_M_S;
        let mut body = Flyer {
            place: muzzle,
            velocity: front * BULLET_SPEED_M_S,
        };
        let mean = self.mean_squeeze(&eye, front, short);
        // What is nearer than the muzzle is shot at from the eye, as is what faces bend the way to too much.
        let aims = if short < NEAREST_AIM_M { 0 } else { AIMS };
        for _ in 0..aims {
            let mut flown = body;
            flown.fly(&self.space, &Void, gravity, time);
            let off = mean.inverse() * (target.point - flown.place.point);
            if off.length() < AIMED_M {
                return body;
            }
            body.velocity += off / time;
        }
        let up = eye.turn.inverse() * -self.room().gravity * (0.5 * short / BULLET_SPEED_M_S);
        Flyer {
            place: eye,
            velocity: front * BULLET_SPEED_M_S + up,
        }
    }

    /// What a felt metre is in the scene on the way from a place on, on average: what a change of velocity there is worth at the end, for each second.
    fn mean_squeeze(&self, from: &Place, front: DVec3, length: f64) -> DMat3 {
        let body = Traveller::Body;
        let of = |sample: u32| {
            let along = length * (f64::from(sample) + 0.5) / f64::from(SAMPLES);
            let path = trace(&self.space, from, front, along, &Void, &body);
            self.space.carry(&path.place, front, &body)
        };
        let end = trace(&self.space, from, front, length, &Void, &body).place;
        if end.passage != from.passage {
            // Behind a portal it is what is there that counts.
            return self.space.carry(&end, front, &body);
        }
        (0..SAMPLES).map(of).sum::<DMat3>() * (1.0 / f64::from(SAMPLES))
    }

    fn thrown(&self) -> Flyer {
        let (eye, front, _) = self.sight(0.0);
        let hand = (0.0, -THROWN.radius_m, 3.0 * THROWN.radius_m);
        let up = -self.room().gravity.normalize_or_zero();
        Flyer {
            place: self.beside(&eye, front, hand),
            velocity: (front + up * THROW_RISE) * THROW_SPEED_M_S + self.walker.body.velocity,
        }
    }

    /// Takes up the lamp that the crosshair is on, or puts one down where it points.
    fn use_lamp(&mut self) {
        let (eye, front, sight) = self.sight(REACH_M);
        if let Some(lamp) = self.lamp_on(&eye, front, sight.length) {
            self.things.remove(lamp);
            return;
        }
        let own = self.room().objects.iter();
        let own = own.filter(|it| matches!(it.what, Kind::Light { .. }));
        let most = MAX_LAMPS.saturating_sub(own.count());
        let Some(hit) = sight.hit() else {
            self.hint(RoomHint::NoPlaceForLamp);
            return;
        };
        if most == 0 {
            self.hint(RoomHint::TooManyLamps);
            return;
        }
        let normal = hit.felt_normal;
        let path = trace(
            &self.space,
            &sight.place,
            normal,
            LAMP_BODY_M,
            &Void,
            &Traveller::Body,
        );
        let mut place = path.place;
        let normal = place.straighten() * normal;
        self.things.put_lamp(place, normal, most);
    }

    /// The lamp nearest to the eye that its way passes within a grip, nearer than `longest`.
    fn lamp_on(&self, eye: &Place, front: DVec3, longest: f64) -> Option<u64> {
        let mut at = *eye;
        let mut gone = 0.0;
        let all = self.things.shown(&self.space, 1.0);
        let lamps: Vec<_> = all.iter().filter(|it| it.kind == ThingKind::Lamp).collect();
        while gone <= longest {
            let gripped = |it: &&&Thing| {
                let k = self.space.carry(&at, front, &Traveller::Body);
                let off = k.inverse() * (it.place.point - at.point);
                it.place.stack == at.stack && off.length() <= LAMP_GRIP_M
            };
            if let Some(lamp) = lamps.iter().find(gripped) {
                return Some(lamp.id);
            }
            let stride = 0.5 * LAMP_GRIP_M;
            at = trace(&self.space, &at, front, stride, &Void, &Traveller::Body).place;
            gone += stride;
        }
        None
    }
}
