//! Things that were dropped: they fall, lie where they come to rest, and are picked up by walking over them.

use std::f64::consts::FRAC_PI_2;

use antipode_geometry::ChartPoint;
use antipode_physics::{Ball, BallTuning};
use glam::{DQuat, DVec3};

use crate::frame::Figure;
use crate::inventory::Stack;
use crate::item::Item;
use crate::notice::Hint;
use crate::scene::Scene;
use crate::sound::SoundEvent;
use crate::tuning::{DROP, DROP_SPEED_M_S, MOST_DROPS, PICK_UP_AFTER_S, PICK_UP_M, STEP_S};

/// How a thing of each model lies on level ground: its turn, and how high its origin is over the ground, metres. Lamps
/// stand, bullets lie as they fly, and what has a grip lies on its side. The heights are half of the models' widths, or
/// where their origin is at the foot, none.
pub fn lying(item: Item) -> (DQuat, f64) {
    let on_its_side = DQuat::from_rotation_x(FRAC_PI_2);
    match item {
        Item::Lamp => (DQuat::IDENTITY, 0.0),
        Item::Bullet => (DQuat::IDENTITY, 0.027),
        Item::Gun => (on_its_side, 0.046),
        Item::PickaxeWood | Item::PickaxeIron | Item::PickaxeDiamond => (on_its_side, 0.036),
    }
}

/// Slower than this after a touch, in m/s, a thing comes to rest.
const RESTS_M_S: f64 = 0.4;
/// How far things turn in flight, radians per metre.
const TURN_RAD_PER_M: f64 = 2.3;
/// Things within this of the player move, in metres: further off there may be nothing to fall on.
const NEAR_M: f64 = 24.0;

/// A stack lying in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drop {
    /// What it is.
    pub stack: Stack,
    /// Its middle.
    pub point: ChartPoint,
    pub(crate) velocity: DVec3,
    pub(crate) age_s: f64,
    pub(crate) rests: bool,
    /// How it is turned about the vertical, radians.
    yaw_rad: f64,
}

impl Drop {
    /// A stack that lies at rest, and may be picked up at once.
    pub fn lying(stack: Stack, point: ChartPoint) -> Self {
        Self {
            stack,
            point,
            velocity: DVec3::ZERO,
            age_s: PICK_UP_AFTER_S,
            rests: true,
            // Nothing is known of it; things side by side are not to lie alike.
            yaw_rad: TURN_RAD_PER_M * (point.pos.x + point.pos.z),
        }
    }

    /// Whether it is near enough to a point to move there.
    fn is_near(&self, point: ChartPoint) -> bool {
        self.point.hemisphere == point.hemisphere && self.point.pos.distance(point.pos) < NEAR_M
    }

    /// Whether it moves while the player's feet are there.
    pub(crate) fn is_awake(&self, feet: ChartPoint) -> bool {
        !self.rests && self.is_near(feet)
    }
}

impl Scene {
    /// Things lying about.
    pub fn drops(&self) -> &[Drop] {
        &self.actors.drops
    }

    /// Throws a stack away, ahead of the player. When too many things lie about it goes back into the slots; what
    /// finds no room there is thrown all the same.
    pub fn throw_away(&mut self, stack: Stack) {
        self.kept.changed = true;
        let mut stack = stack;
        if self.actors.drops.len() >= MOST_DROPS {
            self.outbox.hints.push(Hint::TooManyDrops);
            stack.count = self.player.inventory.give(stack.item, stack.count);
            if stack.count == 0 {
                return;
            }
        }
        let head = self.head();
        let mut drop = Drop::lying(stack, head.point.moved(DVec3::NEG_Y * 0.3));
        drop.age_s = 0.0;
        drop.velocity = head.front() * DROP_SPEED_M_S + DVec3::Y;
        drop.rests = false;
        self.actors.drops.push(drop);
    }

    /// Throws away one of what is in hand, or all of it.
    pub(crate) fn drop_held(&mut self, whole: bool) {
        if let Some(stack) = self.player.inventory.take_held(whole) {
            self.throw_away(stack);
        }
    }

    /// Lets things fall, and the player pick up those that are near.
    pub(crate) fn step_drops(&mut self) {
        if self.actors.drops.is_empty() {
            return;
        }
        let mut drops = std::mem::take(&mut self.actors.drops);
        let middle = self
            .feet()
            .moved(DVec3::Y * (0.5 * self.actors.tuning.height_m));
        for drop in &mut drops {
            drop.age_s += STEP_S;
            if drop.is_near(middle) && (!drop.rests || self.actors.drops_unchecked) {
                self.let_fall(drop);
            }
        }
        if !self.is_dead() {
            drops.retain_mut(|drop| !self.picks_up(drop, middle));
        }
        self.actors.drops_unchecked = false;
        self.actors.drops = drops;
    }

    /// A thing as it is shown: on its ball's lowest point, along the slope of the ground where it lies near enough to be
    /// looked at, and level while it flies.
    pub(crate) fn show_drop(&self, drop: &Drop) -> Figure {
        let item = drop.stack.item;
        let (turn, height_m) = lying(item);
        let lies = drop.rests && drop.is_near(self.feet());
        let up = if lies {
            self.ground_normal(drop.point).as_dvec3()
        } else {
            DVec3::Y
        };
        Figure {
            turn: DQuat::from_rotation_arc(DVec3::Y, up)
                * DQuat::from_rotation_y(drop.yaw_rad)
                * turn,
            ..Figure::standing(
                item.into(),
                drop.point.moved(up * (height_m - DROP.radius_m)),
                0.0,
            )
        }
    }

    fn let_fall(&self, drop: &mut Drop) {
        let origin = self.world.strategy.chart_origin_m(drop.point.hemisphere);
        if self.world.ground.is_solid(drop.point) {
            // Ground was built over it.
            drop.point.pos.y += STEP_S * 4.0;
            drop.rests = false;
            return;
        }
        let mut ball = Ball {
            centre: drop.point.pos + origin,
            velocity: drop.velocity,
        };
        let tuning: &BallTuning = &DROP;
        let touch = self.world.physics.throw_ball(&mut ball, tuning, STEP_S);
        drop.point.pos = ball.centre - origin;
        drop.velocity = ball.velocity;
        drop.yaw_rad += TURN_RAD_PER_M * STEP_S * drop.velocity.with_y(0.0).length();
        drop.rests = touch.is_some() && ball.velocity.length() < RESTS_M_S;
        if drop.rests {
            drop.velocity = DVec3::ZERO;
        }
        if let Some(crossing) = self.world.strategy.cross(drop.point) {
            drop.point = crossing.point;
            drop.velocity = crossing.turn_vector(drop.velocity);
        }
    }

    /// Picks a thing up as far as there is room; returns whether nothing of it is left.
    fn picks_up(&mut self, drop: &mut Drop, middle: ChartPoint) -> bool {
        let is_near = drop.point.hemisphere == middle.hemisphere
            && drop.point.pos.distance(middle.pos) < PICK_UP_M;
        if !is_near || drop.age_s < PICK_UP_AFTER_S || self.player.flying {
            return false;
        }
        let left = self
            .player
            .inventory
            .give(drop.stack.item, drop.stack.count);
        if left < drop.stack.count {
            self.outbox.sounds.push(SoundEvent::PickedUp);
            let taken = drop.stack.count - left;
            tracing::debug!("picked up {taken} {}", drop.stack.item.id());
        }
        drop.stack.count = left;
        left == 0
    }
}
