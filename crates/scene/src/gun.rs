//! The gun: from the muzzle to what the crosshair covers.

use antipode_geometry::{ChartPoint, ChunkCoord, Eye};

use crate::actions::Actions;
use crate::actors::Actors;
use crate::aim::aim;
use crate::crosshair::Crosshair;
use crate::notice::Hint;
use crate::npc::Event;
use crate::outbox::Outbox;
use crate::particles::Effect;
use crate::player::Player;
use crate::projectile::{self, Air, Projectile};
use crate::situation::Situation;
use crate::sound::SoundEvent;
use crate::tuning::{AIM_REACH_M, BULLET, BULLET_SPEED_M_S, MUZZLE_M, SHOT_EVERY_S, STEP_S};
use crate::world::World;
use crate::{car, damage};
use antipode_items::Item;

/// The share of the way to the muzzle that is left when a wall is nearer.
const SHORT_OF_WALL: f64 = 0.9;
/// A bullet so far below the lowest ground, in metres, has missed what was solid and is gone.
const DEEPEST_HOLE_M: f64 = 256.0;

/// Fires when the button goes down with the gun in hand, if there is a bullet.
pub(crate) fn use_in_hand(
    world: &World,
    actors: &mut Actors,
    player: &mut Player,
    outbox: &mut Outbox,
    actions: &Actions,
) {
    player.gun_rests_s = (player.gun_rests_s - STEP_S).max(0.0);
    let pulled = actions.primary && !player.primary_before;
    if !pulled || player.gun_rests_s > 0.0 || player.inventory.held() != Some(Item::Gun) {
        return;
    }
    player.gun_rests_s = SHOT_EVERY_S;
    if !player.inventory.spend(Item::Bullet) {
        outbox.hints.push(Hint::NoBullets);
        outbox.sounds.push(SoundEvent::Clicked);
        return;
    }
    outbox.sounds.push(SoundEvent::Shot);
    outbox.fired = true;
    actors.npcs.events.push(Event::Shot(actors.feet()));
    player.condition.spared_s = 0.0;
    fire(world, actors, player);
}

/// A bullet goes from the muzzle to what the crosshair covers.
fn fire(world: &World, actors: &mut Actors, player: &Player) {
    let now = Situation::of(world, actors, player);
    let (params, mut head) = (now.aiming(), now.head());
    let aimed = Crosshair::aimed(now).ground_or_figure(AIM_REACH_M);
    let mut target = aimed.point;
    let mut muzzle = muzzle_of(world, &head);
    if let Some((doors, leaf)) = world.doors.as_ref().zip(aimed.through) {
        if let Some((_, by)) = world.door_between(head.point, muzzle) {
            // The barrel is through already.
            let out = doors.pass(&*world.strategy, by, muzzle);
            muzzle = out.map_or(muzzle, |out| out.point);
            head = doors.eye(&*params.strategy, leaf, &head);
        } else {
            // It is aimed at where the target would be without the door.
            target = doors.pictured(&*params.strategy, 1 - leaf, &head, target);
        }
    }
    let by = actors.player;
    if params.straight_shots {
        let eye = Eye {
            point: muzzle,
            dial: params.dial,
            lift_m: head.lift_m + muzzle.pos.y - head.point.pos.y,
            ..head
        };
        let pictured = &*params.strategy;
        projectile::fire_straight(actors, pictured, eye, target, BULLET_SPEED_M_S, by);
    } else {
        let velocity = aim(
            &*world.strategy,
            muzzle,
            target,
            BULLET_SPEED_M_S,
            BULLET.gravity_m_s2,
        );
        projectile::fire(actors, muzzle, velocity, by);
    }
}

/// Moves the bullets by one step, and deals out what they do.
pub(crate) fn step_bullets(
    world: &World,
    actors: &mut Actors,
    player: &mut Player,
    outbox: &mut Outbox,
) {
    if actors.count::<Projectile>() == 0 {
        return;
    }
    let now = Situation::of(world, actors, player);
    let standing = now.standing();
    let params = now.aiming();
    let lowest_m = world.ground.height_range_m().0 - DEEPEST_HOLE_M;
    // More bullets than ground is made solid for end where the land is, as those beyond where bodies move do.
    let in_far_ground = |point: ChartPoint| {
        let coord = ChunkCoord::containing(point);
        let is_bare = !world.lets_move(coord) || !world.ground.is_touchable(coord);
        point.pos.y < lowest_m || is_bare && world.ground.untouched_density(point) < 0.0
    };
    let air = Air {
        strategy: &*world.strategy,
        pictured: &*params.strategy,
        physics: &world.physics,
        standing: &standing,
        cars: &actors.car_parts(world),
        in_far_ground: &in_far_ground,
        doors: world.doors.as_ref(),
    };
    let hits = projectile::step(&mut actors.ecs, &air);
    for &(at, up, speed_m_s) in &hits.grounds {
        let struck = Effect::Struck { at, up, speed_m_s };
        outbox.effects.push(struck);
    }
    damage::take_strikes(actors, player, outbox, hits.strikes);
    car::damage::take_knocks(actors, outbox, &hits.knocks);
}

/// The muzzle of a gun held by someone with that eye; short of a wall that one stands close to.
pub(crate) fn muzzle_of(world: &World, head: &Eye) -> ChartPoint {
    let (right, up, ahead) = MUZZLE_M;
    let way = head.right() * right + head.up() * up + head.front() * ahead;
    let length_m = way.length();
    let free = world
        .physics
        .chart(head.point.chart)
        .cast_sphere(head.point.pos, way, BULLET.radius_m, length_m)
        .map_or(1.0, |free_m| SHORT_OF_WALL * free_m / length_m);
    let muzzle = head.point.moved(way * free);
    let over = world.strategy.cross(muzzle);
    over.map_or(muzzle, |crossing| crossing.point)
}
