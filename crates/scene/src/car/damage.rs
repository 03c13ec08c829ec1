//! A slow car shoves bodies aside, and a fast one throws and hurts them. Bullets knock cars.

use antipode_geometry::Crossing;
use glam::DVec3;
use hecs::Entity;

use super::Car;
use super::tuning::{
    BODY_KG, BULLET_PUSH_KG, DAMAGE_PER_M_S, HURTS_AGAIN_AFTER_S, SHOVES_BELOW_M_S, THROWN,
    TOUCH_GAP_M,
};
use crate::actors::{ActorId, Actors, one_mut};
use crate::damage::{DamageKind, hurt_bot, hurt_player};
use crate::outbox::Outbox;
use crate::player::{Body, Player};
use crate::projectile::Knock;
use crate::situation::Situation;
use crate::sound::SoundEvent;
use crate::tuning::STEP_S;
use crate::world::World;

/// A car farther than this from someone's feet cannot touch them, in metres.
const FAR_M: f64 = 5.0;

/// A car has met someone.
struct Meeting {
    car: ActorId,
    who: Entity,
    /// Where, in the chart of the car, and the level way from the car there, a unit vector.
    at: DVec3,
    away: DVec3,
    /// The same way in that one's chart.
    own_away: DVec3,
    /// How fast the car comes that way, m/s.
    closing_m_s: f64,
}

/// Lets cars act on those who stand in their way.
pub(super) fn run_over(
    world: &World,
    actors: &mut Actors,
    player: &mut Player,
    outbox: &mut Outbox,
) {
    let hurt = &mut actors.cars.hurt;
    for (_, ago_s) in hurt.iter_mut() {
        *ago_s += STEP_S;
    }
    hurt.retain(|(_, ago_s)| *ago_s < HURTS_AGAIN_AFTER_S);
    let now = Situation::of(world, actors, player);
    for meeting in meetings(now) {
        meet(actors, player, outbox, &meeting);
    }
}

fn meetings(now: Situation<'_>) -> Vec<Meeting> {
    let mut found = Vec::new();
    let standing = now.standing();
    let strategy = &*now.world.strategy;
    for (car, part) in now.actors.car_parts(now.world) {
        let motion = part.motion();
        let images = strategy.images(motion.point(), FAR_M);
        for it in &standing {
            // Half of a car may be beyond an edge, among those whose chart is the next one.
            let is_there = |image: &Crossing| image.point.chart == it.feet.chart;
            let is_near = it.feet.chart == motion.chart || images.iter().any(is_there);
            let carried = is_near.then(|| strategy.carry_near(it.feet, motion.point()));
            let Some(carried) = carried.flatten() else {
                continue;
            };
            let feet = carried.point.pos;
            if feet.distance(motion.place) >= FAR_M {
                continue;
            }
            let (height_m, radius_m) = (it.height_m, it.radius_m);
            let touch = part.touches_capsule(feet, height_m, radius_m, TOUCH_GAP_M);
            if let Some((there_away, velocity)) = touch {
                let (at, away) = part.taken_home(feet + DVec3::Y * (0.5 * height_m), there_away);
                found.push(Meeting {
                    car,
                    who: it.entity,
                    at,
                    away,
                    own_away: carried.rotation().inverse() * there_away,
                    closing_m_s: velocity.dot(there_away),
                });
            }
        }
    }
    found
}

fn meet(actors: &mut Actors, player: &mut Player, outbox: &mut Outbox, meeting: &Meeting) {
    let Meeting {
        who,
        away,
        own_away,
        closing_m_s,
        ..
    } = *meeting;
    let is_fast = closing_m_s > SHOVES_BELOW_M_S;
    if closing_m_s > 0.0
        && let Ok(body) = actors.ecs.query_one_mut::<&mut Body>(who)
    {
        let (ahead, up) = if is_fast { THROWN } else { (0.1, 0.0) };
        let missing = closing_m_s * (1.0 + ahead) - body.0.velocity.dot(own_away);
        body.0.velocity += own_away * missing.max(0.0);
        if is_fast {
            body.0.velocity.y = body.0.velocity.y.max(closing_m_s * up);
            body.0.grounded = false;
        }
    }
    let cars = &mut actors.cars;
    if !is_fast || cars.hurt.iter().any(|(last, _)| *last == who) {
        return;
    }
    cars.hurt.push((who, 0.0));
    let push = away * (-BODY_KG * closing_m_s);
    if let Some(car) = one_mut::<Car>(&mut actors.ecs, meeting.car) {
        cars.physics.push(&mut car.vehicle, meeting.at, push);
    }
    outbox.sounds.push(SoundEvent::Struck);
    let damage = (closing_m_s - SHOVES_BELOW_M_S) * DAMAGE_PER_M_S;
    if who == actors.player {
        hurt_player(
            actors,
            player,
            outbox,
            damage,
            DamageKind::RunOver,
            Some(-own_away),
        );
    } else {
        let by = (cars.driven() == Some(meeting.car)).then_some(actors.player);
        hurt_bot(actors, who, damage, by);
    }
}

/// Deals out what bullets did to cars in a step.
pub(crate) fn take_knocks(actors: &mut Actors, outbox: &mut Outbox, knocks: &[Knock]) {
    for knock in knocks {
        let impulse = knock.velocity * BULLET_PUSH_KG;
        if let Some(car) = one_mut::<Car>(&mut actors.ecs, knock.car) {
            actors
                .cars
                .physics
                .push(&mut car.vehicle, knock.at, impulse);
        }
        outbox.sounds.push(SoundEvent::CarHit);
    }
}
