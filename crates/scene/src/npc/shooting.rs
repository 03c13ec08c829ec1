//! Shots at the player: led by its way, only where nothing is between, and never quite exact.

use antipode_geometry::{BodyFrame, ChartPoint};
use antipode_physics::{Ball, meets_capsule};
use glam::DVec3;
use hecs::Entity;

use super::bearing::way;
use super::doors::felt_m;
use super::figure::Npc;
use super::hidden::IN_SIGHT_S;
use super::senses::{Around, Quarry};
use super::tuning::{ASTRAY_RAD, MUZZLE_M_S, SHOOTS_M, SHOTS_EVERY_S};
use crate::actors::Actors;
use crate::aim::aim;
use crate::gun::muzzle_of;
use crate::outbox::Outbox;
use crate::pick::{over_if_near, segment_hit};
use crate::sound::SoundEvent;
use crate::tuning::BULLET;
use crate::world::World;
use crate::{player, projectile};

/// A look this far off the aim hinders a shot, in radians.
const FACES_RAD: f64 = 0.35;
/// Rounds in which the lead is found: each mends the time of flight.
const LEAD_ROUNDS: usize = 3;
/// Of the flight tested before a shot, the length of a piece, in seconds, and the end that is left out, in metres.
const TESTED_S: f64 = 0.08;
const LAST_M: f64 = 0.7;
/// A figure that cannot shoot now looks again so soon, in seconds.
const AGAIN_S: f64 = 0.4;
/// What is aimed at, as a share of the height from the feet.
const AIMS_AT: f64 = 0.6;
/// Shots of others are heard within this distance, in metres.
const HEARD_M: f64 = 40.0;
/// A shot cannot meet anybody who is farther than this from a piece of its way, in metres.
const NEAR_M: f64 = 5.0;
/// Others this far from a shot's way are safe, in metres.
const SAFE_M: f64 = 0.3;

/// A shot to fire.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Shot {
    muzzle: ChartPoint,
    velocity: DVec3,
}

impl Npc<'_> {
    /// Shoots when it is time and the way is clear.
    pub fn shoot(&mut self, around: &Around<'_>) -> Option<Shot> {
        let ready = self.mind.state.shoots() && self.mind.fires_in_s <= 0.0;
        let in_sight = self
            .mind
            .known
            .is_some_and(|known| known.ago_s < IN_SIGHT_S);
        let quarry = around.quarry.filter(|_| ready && in_sight)?;
        // The picture may have changed since it last looked.
        self.hide(around);
        if self.holds_fire() {
            return None;
        }
        let there = way(around.strategy(), self.position.0, quarry.feet);
        let faces = there.heading.dot(self.look.heading()) > FACES_RAD.cos();
        let near = around.apart_m(self.position.0, quarry.feet) < SHOOTS_M;
        if !(faces && near) {
            return None;
        }
        let shot = self.aimed(around, &quarry);
        if !self.is_clear(around, &shot, &quarry) {
            self.mind.fires_in_s = AGAIN_S;
            // Another place may have a clear way.
            self.mind.since_s += 1.0;
            return None;
        }
        self.mind.fires_in_s = self.mind.dice.between(SHOTS_EVERY_S);
        self.mind.fired_s = 0.0;
        Some(Shot {
            velocity: self.mind.astray(shot.velocity, ASTRAY_RAD),
            ..shot
        })
    }

    /// A shot that meets the player where it will be when the bullet comes.
    fn aimed(&self, around: &Around<'_>, quarry: &Quarry) -> Shot {
        let strategy = around.strategy();
        let height_m = around.tuning.eye_height_m();
        let eye = player::eye(self.position, self.look, 0.0, height_m);
        let muzzle = muzzle_of(around.world, &eye);
        let middle = quarry
            .feet
            .moved(DVec3::Y * (AIMS_AT * around.tuning.height_m));
        let aimed = |target| aim(strategy, muzzle, target, MUZZLE_M_S, BULLET.gravity_m_s2);
        let mut velocity = aimed(middle);
        let mut target = middle;
        for _ in 0..LEAD_ROUNDS {
            let level = BodyFrame::way(strategy, muzzle, target);
            let speed_m_s = velocity.with_y(0.0).length().max(1.0);
            let flight_s = level.with_y(0.0).length() / speed_m_s;
            // A fall or a jump is not led: who is in the air is soon down again.
            let gone = quarry.velocity.with_y(0.0) * flight_s;
            let led = BodyFrame::step(strategy, middle, gone).point;
            target = strategy.cross(led).map_or(led, |over| over.point);
            velocity = aimed(target);
        }
        Shot { muzzle, velocity }
    }

    /// Whether a shot would meet neither ground nor a friend before it comes to the player.
    fn is_clear(&self, around: &Around<'_>, shot: &Shot, quarry: &Quarry) -> bool {
        let strategy = around.strategy();
        let away_m = around.apart_m(shot.muzzle, quarry.feet);
        let mut at = shot.muzzle;
        let mut ball = Ball {
            centre: at.pos,
            velocity: shot.velocity,
        };
        let mut gone_m = 0.0;
        while gone_m + LAST_M < away_m {
            let mut after = ball;
            let ground = around.world.physics.for_bodies(strategy, at.chart);
            ground.fall(&mut after, BULLET.gravity_m_s2, TESTED_S);
            let next = ChartPoint::new(at.chart, after.centre);
            gone_m += BodyFrame::way(strategy, at, next).length();
            if segment_hit(strategy, &around.world.physics, at, next).is_some()
                || self.meets_friend(around, at, next)
            {
                return false;
            }
            (at, ball) = (next, after);
            if let Some(crossing) = strategy.cross(at) {
                at = crossing.point;
                ball = Ball {
                    centre: at.pos,
                    velocity: crossing.turn_vector(ball.velocity),
                };
            }
        }
        true
    }

    fn meets_friend(&self, around: &Around<'_>, from: ChartPoint, to: ChartPoint) -> bool {
        let tuning = around.tuning;
        self.others(around).any(|other| {
            let feet = over_if_near(around.strategy(), from, other.point, NEAR_M);
            let Some(feet) = feet.map(|it| it.pos) else {
                return false;
            };
            (feet - from.pos).length_squared() < NEAR_M * NEAR_M
                && meets_capsule(
                    from.pos,
                    to.pos,
                    SAFE_M,
                    feet,
                    tuning.height_m,
                    tuning.radius_m,
                )
                .is_some()
        })
    }
}

/// Fires a shot for a figure.
pub(super) fn fire(
    world: &World,
    actors: &mut Actors,
    outbox: &mut Outbox,
    by: Entity,
    shot: Shot,
) {
    projectile::fire(actors, shot.muzzle, shot.velocity, by);
    let away_m = felt_m(world, actors.feet(), shot.muzzle);
    if away_m < HEARD_M {
        outbox.sounds.push(SoundEvent::Shot);
    }
}
