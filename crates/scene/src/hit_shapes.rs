//! The shapes by which things are hit and stand on the ground, as a list to be drawn.

use antipode_physics::Character;
use glam::DVec3;
use hecs::Entity;

use crate::camera::CameraMode;
use crate::drops::Drop;
use crate::fixture;
use crate::frame::{HitForm, HitShape};
use crate::player::{Body, Health, Position};
use crate::projectile::Projectile;
use crate::situation::Situation;
use crate::tuning::{BULLET, DROP};

/// Slower than this a body is at rest, in metres per second.
const RESTS_M_S: f64 = 0.02;
/// A body whose ground within this distance is not there waits for it, in metres.
const GROUND_WITHIN_M: f64 = 2.0;

/// Everything that can be hit or stands on the ground; in first person without the player's own body, inside of
/// which one looks.
pub(crate) fn hit_shapes(now: Situation<'_>) -> Vec<HitShape> {
    let mut shapes = bodies(now);
    let ball = |radius_m, point, awake| HitShape::upright(HitForm::Ball { radius_m }, point, awake);
    shapes.extend(fixture::map(now.actors, |_, it| {
        let ([low_m, high_m], radius_m) = (it.stands.heights_m, it.stands.radius_m);
        let (height_m, awake) = (high_m - low_m, it.foot.falls());
        let over_foot = |up_m| it.foot.point.moved(DVec3::Y * up_m);
        if height_m > 2.0 * radius_m {
            let form = HitForm::Capsule { height_m, radius_m };
            HitShape::upright(form, over_foot(low_m), awake)
        } else {
            ball(radius_m, over_foot(low_m + radius_m), awake)
        }
    }));
    let bullet = |_, it: &Projectile| {
        let flies = it.velocity.length() > RESTS_M_S;
        ball(BULLET.radius_m, it.point, flies)
    };
    shapes.extend(now.actors.map(bullet));
    let drop = |_, it: &Drop| {
        ball(
            DROP.radius_m,
            it.point,
            it.is_awake(&*now.world.strategy, now.feet()),
        )
    };
    shapes.extend(now.actors.map(drop));
    shapes
}

/// Everyone alive, in the order in which they came.
fn bodies(now: Situation<'_>) -> Vec<HitShape> {
    let Situation {
        world,
        actors,
        player,
    } = now;
    let sees_own = player.gaze.camera != CameraMode::First && !player.flying;
    let form = HitForm::Capsule {
        height_m: actors.tuning.height_m,
        radius_m: actors.tuning.radius_m,
    };
    let mut query = actors.ecs.query::<(Entity, &Position, &Body, &Health)>();
    let mut bodies: Vec<_> = query
        .iter()
        .filter(|(entity, _, _, health)| health.0 > 0.0 && (*entity != actors.player || sees_own))
        .map(|(entity, position, body, _)| {
            let is_there = world.is_firm_around(position.0, GROUND_WITHIN_M);
            let awake = is_there && moves(&body.0);
            (entity.id(), HitShape::upright(form, position.0, awake))
        })
        .collect();
    bodies.sort_unstable_by_key(|(id, _)| *id);
    bodies.into_iter().map(|(_, shape)| shape).collect()
}

fn moves(body: &Character) -> bool {
    !body.grounded || body.velocity.length() > RESTS_M_S
}
