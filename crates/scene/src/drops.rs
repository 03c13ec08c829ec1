//! Things that were dropped: they fall, lie where they come to rest, and are picked up by walking over them.

use std::f64::consts::FRAC_PI_2;

use antipode_geometry::{Atlas, ChartPoint, Eye};
use antipode_physics::{Ball, BallTuning, Thrown};
use glam::{DQuat, DVec3};

use crate::actors::{Actors, retain};
use crate::frame::Figure;
use crate::ground_changed::OnGround;
use crate::inventory::{Inventory, Stack};
use crate::logs;
use crate::notice::Hint;
use crate::outbox::Outbox;
use crate::pick::over;
use crate::player::Player;
use crate::sound::SoundEvent;
use crate::tuning::{DROP, DROP_SPEED_M_S, MOST_DROPS, PICK_UP_AFTER_S, PICK_UP_M, STEP_S};
use crate::world::World;
use antipode_items::{Item, Lies};
use antipode_terrain::Stock;

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
    /// How far it has rolled about its length, radians.
    rolled_rad: f64,
    /// For how long it has, since it last met the ground out of the air or was woken, seconds; none before.
    rolls_s: Option<f64>,
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
            rolled_rad: 0.0,
            rolls_s: None,
        }
    }

    /// A stack in the air that lies along a level way.
    pub(crate) fn thrown(stack: Stack, point: ChartPoint, velocity: DVec3, along: DVec3) -> Self {
        Self {
            velocity,
            age_s: 0.0,
            rests: false,
            yaw_rad: along.x.atan2(along.z),
            ..Self::lying(stack, point)
        }
    }

    /// The level way along which what rolls lies, and about which it turns.
    fn axis(&self) -> DVec3 {
        DVec3::new(self.yaw_rad.sin(), 0.0, self.yaw_rad.cos())
    }

    /// Whether it rolls at least so fast, m/s.
    pub(crate) fn rolls_at(&self, speed_m_s: f64) -> bool {
        let rolls = !self.rests && self.rolls_s.is_some();
        rolls && self.velocity.length() > speed_m_s
    }

    /// How its ball moves.
    fn tuning(&self) -> BallTuning {
        self.stack.item.rolls_m().map_or(DROP, logs::tuning)
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
    let front = head.front();
    let velocity = front * DROP_SPEED_M_S + DVec3::Y;
    let along = front.cross(DVec3::Y);
    let point = head.point.moved(DVec3::NEG_Y * 0.3);
    actors.enter(Drop::thrown(stack, point, velocity, along));
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
    let turn = DQuat::from_rotation_arc(DVec3::Y, up)
        * DQuat::from_axis_angle(drop.axis(), drop.rolled_rad)
        * DQuat::from_rotation_y(drop.yaw_rad)
        * turn;
    // What rolls does so about its middle.
    let middle_m = item.rolls_m().and(item.stands()).map(|it| it.middle_m);
    let to_origin = match middle_m {
        Some(middle_m) => turn * DVec3::NEG_Y * middle_m,
        None => up * (height_m - DROP.radius_m),
    };
    Figure {
        turn,
        ..Figure::standing(item.into(), drop.point.moved(to_origin), 0.0)
    }
}

/// Lets things fall, and the player pick up those that are near.
pub(crate) fn step(
    world: &mut World,
    actors: &mut Actors,
    player: &mut Player,
    outbox: &mut Outbox,
) {
    let middle = actors
        .feet()
        .moved(DVec3::Y * (0.5 * actors.tuning.height_m));
    for drop in actors.ecs.query_mut::<&mut Drop>() {
        drop.age_s += STEP_S;
        if drop.is_awake(&*world.strategy, middle) {
            drop.fall(world);
        }
    }
    logs::strike(world, actors, player, outbox);
    if !player.picks_up() {
        return;
    }
    let gathers = world.streamer.stock().is_some();
    let mut brought = Stock::default();
    retain(&mut actors.ecs, |drop: &mut Drop| {
        let is_near = drop.is_near(&*world.strategy, middle, PICK_UP_M);
        if !is_near || drop.age_s < PICK_UP_AFTER_S {
            return true;
        }
        let Stack { item, count } = drop.stack;
        match logs::ground_of(item, count).filter(|_| gathers) {
            Some((kind, m3)) => {
                outbox.sounds.push(SoundEvent::PickedUp);
                brought.add(kind, m3);
                false
            }
            None => !drop.is_picked_up(&mut player.inventory, outbox),
        }
    });
    if brought != Stock::default() {
        logs::gain(world, player, &brought);
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
        let before = self.point;
        let ground = world.physics.for_bodies(&*world.strategy, self.point.chart);
        let Thrown { touch, turn_rad } = ground.throw_ball(&mut ball, &self.tuning(), STEP_S);
        self.point.pos = ball.centre;
        self.velocity = ball.velocity;
        // Its axis is told by the angle from z to x.
        self.yaw_rad += turn_rad;
        if let Some(radius_m) = self.stack.item.rolls_m() {
            let axis = self.axis();
            if let Some(touch) = touch {
                let rolls_s = self.rolls_s.get_or_insert(0.0);
                *rolls_s += STEP_S;
                (self.velocity, self.rests) =
                    logs::rolled(self.velocity, axis, touch.normal, *rolls_s);
            }
            // Rolling ahead, it turns about what is ahead turned to the right about the upright.
            let ahead = axis.cross(DVec3::Y);
            self.rolled_rad += self.velocity.dot(ahead) * STEP_S / radius_m;
        } else {
            self.yaw_rad += TURN_RAD_PER_M * STEP_S * self.velocity.with_y(0.0).length();
            self.rests = touch.is_some() && ball.velocity.length() < RESTS_M_S;
        }
        if self.rests {
            self.velocity = DVec3::ZERO;
        }
        let door = world.through_door(before, self.point);
        let along = self.axis();
        if let Some(crossing) = door.or_else(|| world.strategy.cross(self.point)) {
            self.point = crossing.point;
            self.velocity = crossing.turn_vector(self.velocity);
            let along = crossing.turn_vector(along);
            self.yaw_rad = along.x.atan2(along.z);
        }
    }

    /// Goes to the player as far as there is room; returns whether nothing of it is left.
    fn is_picked_up(&mut self, inventory: &mut Inventory, outbox: &mut Outbox) -> bool {
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
        self.rolls_s = None;
    }
}
