//! Things that were dropped: they fall, lie where they come to rest, and are picked up by walking over them.

use std::f64::consts::FRAC_PI_2;

use antipode_geometry::{Atlas, ChartPoint, Eye};
use antipode_physics::{Ball, BallTuning};
use glam::{DQuat, DVec3};

use crate::actors::{Actors, retain};
use crate::frame::Figure;
use crate::ground_changed::OnGround;
use crate::inventory::{Inventory, Stack};
use crate::notice::Hint;
use crate::outbox::Outbox;
use crate::pick::over;
use crate::player::Player;
use crate::sound::SoundEvent;
use crate::tuning::{DROP, DROP_SPEED_M_S, MOST_DROPS, PICK_UP_AFTER_S, PICK_UP_M, STEP_S};
use crate::world::World;
use antipode_items::{Item, Lies};

/// How a thing lies on level ground: its turn, and how high its origin is over the ground, metres.
pub fn lying(item: Item) -> (DQuat, f64) {
    let (turn_rad, height_m) = match item.lies() {
        Lies::Upright { height_m } => (0.0, height_m),
        Lies::OnItsSide { height_m } => (FRAC_PI_2, height_m),
    };
    (DQuat::from_rotation_x(turn_rad), height_m)
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

    /// Whether it is nearer than so many metres of the chart to a point.
    fn is_near(&self, strategy: &dyn Atlas, point: ChartPoint, within_m: f64) -> bool {
        let there = over(strategy, self.point, point);
        there.chart == self.point.chart && there.pos.distance(self.point.pos) < within_m
    }

    /// Whether it moves while the player's feet are there.
    pub(crate) fn is_awake(&self, strategy: &dyn Atlas, feet: ChartPoint) -> bool {
        !self.rests && self.is_near(strategy, feet, NEAR_M)
    }
}

/// Throws a stack away, ahead of the player's head. When too many things lie about it goes back into the slots; what
/// finds no room there is thrown all the same.
pub(crate) fn throw_away(
    actors: &mut Actors,
    inventory: &mut Inventory,
    outbox: &mut Outbox,
    head: &Eye,
    mut stack: Stack,
) {
    if actors.count::<Drop>() >= MOST_DROPS {
        outbox.hints.push(Hint::TooManyDrops);
        stack.count = inventory.give(stack.item, stack.count);
        if stack.count == 0 {
            return;
        }
    }
    let mut drop = Drop::lying(stack, head.point.moved(DVec3::NEG_Y * 0.3));
    drop.age_s = 0.0;
    drop.velocity = head.front() * DROP_SPEED_M_S + DVec3::Y;
    drop.rests = false;
    actors.enter(drop);
}

/// A thing as it is shown: on its ball's lowest point, along the slope of the ground where it lies near enough to be
/// looked at, and level while it flies.
pub(crate) fn shown(world: &World, feet: ChartPoint, drop: &Drop) -> Figure {
    let item = drop.stack.item;
    let (turn, height_m) = lying(item);
    let lies = drop.rests && drop.is_near(&*world.strategy, feet, NEAR_M);
    let up = if lies {
        world.ground.normal(drop.point).as_dvec3()
    } else {
        DVec3::Y
    };
    let point = drop.point.moved(up * (height_m - DROP.radius_m));
    Figure {
        turn: DQuat::from_rotation_arc(DVec3::Y, up) * DQuat::from_rotation_y(drop.yaw_rad) * turn,
        ..Figure::standing(item.into(), point, 0.0)
    }
}

/// Lets things fall, and the player pick up those that are near.
pub(crate) fn step(world: &World, actors: &mut Actors, player: &mut Player, outbox: &mut Outbox) {
    let middle = actors
        .feet()
        .moved(DVec3::Y * (0.5 * actors.tuning.height_m));
    for drop in actors.ecs.query_mut::<&mut Drop>() {
        drop.age_s += STEP_S;
        if drop.is_awake(&*world.strategy, middle) {
            drop.fall(world);
        }
    }
    if player.picks_up() {
        retain(&mut actors.ecs, |drop: &mut Drop| {
            let is_near = drop.is_near(&*world.strategy, middle, PICK_UP_M);
            !(is_near && drop.is_picked_up(&mut player.inventory, outbox))
        });
    }
}

impl Drop {
    fn fall(&mut self, world: &World) {
        if world.ground.is_solid(self.point) {
            // Ground was built over it.
            self.point.pos.y += STEP_S * 4.0;
            return;
        }
        let mut ball = Ball {
            centre: self.point.pos,
            velocity: self.velocity,
        };
        let tuning: &BallTuning = &DROP;
        let before = self.point;
        let touch = world
            .physics
            .chart(self.point.chart)
            .throw_ball(&mut ball, tuning, STEP_S);
        self.point.pos = ball.centre;
        self.velocity = ball.velocity;
        self.yaw_rad += TURN_RAD_PER_M * STEP_S * self.velocity.with_y(0.0).length();
        self.rests = touch.is_some() && ball.velocity.length() < RESTS_M_S;
        if self.rests {
            self.velocity = DVec3::ZERO;
        }
        let door = world.through_door(before, self.point, self.velocity);
        let crossed = door.or_else(|| {
            let crossing = world.strategy.cross(self.point)?;
            Some((crossing, crossing.turn_vector(self.velocity)))
        });
        if let Some((crossing, velocity)) = crossed {
            self.point = crossing.point;
            self.velocity = velocity;
        }
    }

    /// Goes to the player as far as there is room; returns whether nothing of it is left.
    fn is_picked_up(&mut self, inventory: &mut Inventory, outbox: &mut Outbox) -> bool {
        if self.age_s < PICK_UP_AFTER_S {
            return false;
        }
        let left = inventory.give(self.stack.item, self.stack.count);
        if left < self.stack.count {
            outbox.sounds.push(SoundEvent::PickedUp);
            let taken = self.stack.count - left;
            tracing::debug!("picked up {taken} {}", self.stack.item.id());
        }
        self.stack.count = left;
        left == 0
    }
}

impl OnGround for Drop {
    fn stands_at(&self) -> ChartPoint {
        self.point
    }

    fn is_falling(&self) -> bool {
        !self.rests
    }

    fn wake(&mut self) {
        self.rests = false;
    }
}
