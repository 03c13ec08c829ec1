//! Shows the scene as figures: everyone, what they hold, and things that lie, stand or fly.

use antipode_geometry::{ChartPoint, Eye};
use antipode_items::Item;
use glam::{DQuat, DVec3};
use hecs::Entity;

use crate::bot::Bot;
use crate::car::lights::{seat_figure, show_cars};
use crate::door_astride::show_astride;
use crate::drops::{self, Drop};
use crate::frame::Figure;
use crate::moment::Who;
use crate::npc::mind::Mind;
use crate::pick::over;
use crate::player::{Appearance, Body, Look, Position};
use crate::projectile::Projectile;
use crate::scene::Scene;
use crate::situation::Situation;
use crate::tuning::FIGURE_SEEN_FROM_M;
use crate::world::World;
use crate::{fixture, hand};

/// Ground is looked for from so far above a body's feet, and so far below them, metres.
const KNEES_M: f64 = 0.5;
const DEEPEST_SOLES_M: f64 = 0.4;

/// Everyone but who looks: in first person one does not see oneself, nor from inside one's own suit.
pub(crate) fn figures_seen_by(scene: &Scene, eye: &Eye, sees_player: bool) -> Vec<(Who, Figure)> {
    let now = scene.now();
    let actors = now.actors;
    let head = now.head_through(&scene.picturing()).point;
    let from = over(&*now.world.strategy, head, eye.point);
    let inside_own = from.chart == head.chart && from.pos.distance(head.pos) < FIGURE_SEEN_FROM_M;
    let mut seen = Vec::new();
    for (entity, position, look, appearance, body, bot) in &mut actors.ecs.query::<(
        Entity,
        &Position,
        &Look,
        &Appearance,
        &Body,
        Option<(&Bot, &Mind)>,
    )>() {
        if entity == actors.player && (!sees_player || inside_own) {
            continue;
        }
        let mut figure = Figure {
            posture: appearance.motion.posture(),
            held: appearance.held,
            ..Figure::standing(
                appearance.model,
                soles(now.world, position.0, body),
                look.yaw,
            )
        };
        if entity == actors.player {
            let held = now.player.inventory.held();
            hand::use_in(&scene.shown.hand, held, &mut figure);
            seat_figure(now, &mut figure);
        }
        let mut who = Who::Player {
            drives: actors.cars.driven(),
            dead: now.player.is_dead(),
        };
        if let Some((bot, mind)) = bot {
            mind.show_shot(&mut figure);
            figure.hostile = figure.held.is_some();
            who = Who::Bot {
                id: bot.id,
                dead: bot.dead_s > 0.0,
            };
        }
        seen.push((who, figure));
    }
    show_things(now, &mut seen);
    show_cars(now, &mut seen);
    match &now.world.doors {
        Some(doors) => {
            let cars = actors.car_views();
            show_astride(&*now.world.strategy, doors, &cars, seen)
        }
        None => seen,
    }
}

/// Where the soles of a body are drawn. Its capsule is wider than its feet: on a slope or in a hollow it is carried at
/// its sides, and the ground under its middle is lower.
fn soles(world: &World, feet: ChartPoint, body: &Body) -> ChartPoint {
    if !body.0.grounded {
        return feet;
    }
    let from = feet.moved(DVec3::Y * KNEES_M);
    let most_m = KNEES_M + DEEPEST_SOLES_M;
    let ground = world
        .physics
        .chart(from.chart)
        .cast_ray(from.pos, DVec3::NEG_Y, most_m);
    let ground_m = ground.map_or(KNEES_M, |hit| hit.distance_m);
    from.moved(DVec3::NEG_Y * ground_m.max(KNEES_M))
}

/// What was put down, bullets, and what lies about.
fn show_things(now: Situation<'_>, seen: &mut Vec<(Who, Figure)>) {
    seen.extend(fixture::map(now.actors, |id, it| {
        let figure = fixture::figure(now, it);
        (Who::Fixture(it.item, id), figure)
    }));
    let bullet = |id, bullet: &Projectile| {
        let way = bullet.velocity.normalize_or(DVec3::X);
        let figure = Figure {
            turn: DQuat::from_rotation_arc(DVec3::X, way),
            ..Figure::standing(Item::Bullet.into(), bullet.point, 0.0)
        };
        (Who::Bullet(id), figure)
    };
    seen.extend(now.actors.map(bullet));
    let drop = |id, drop: &Drop| (Who::Drop(id), drops::shown(now.world, now.feet(), drop));
    seen.extend(now.actors.map(drop));
}
