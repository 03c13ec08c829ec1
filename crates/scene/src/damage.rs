//! Damage and healing: falls, shots, death and standing up again.

use antipode_geometry::ChartPoint;
use glam::DVec3;
use hecs::Entity;

use crate::actors::Actors;
use crate::bot::Bot;
use crate::notice::Hint;
use crate::npc::Event;
use crate::outbox::Outbox;
use crate::player::{Appearance, Health, Player, Position};
use crate::projectile::Strike;
use crate::situation::Situation;
use crate::sound::SoundEvent;
use crate::tuning::{
    BULLET_DAMAGE, DEAD_S, FALL_HURTS_FROM_M, FULL_HEALTH, HEALS_AFTER_S, HEALS_PER_S, STEP_S,
};
use crate::world::World;
use crate::{body, npc};

/// How long nobody fights a player who has stood up again from death, seconds: who killed may have come along.
const SPARED_S: f64 = 8.0;

/// What has hurt someone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DamageKind {
    /// A fall.
    Fall,
    /// A bullet.
    Shot,
    /// The car that one drives ran into something.
    Crash,
    /// A car.
    RunOver,
    /// A tree that fell.
    Tree,
}

/// Damage that the player took.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hurt {
    /// How long ago, seconds.
    pub ago_s: f64,
    /// Where the player's feet were.
    at: ChartPoint,
    /// The heading there, radians, from which it came; none for a fall.
    from_rad: Option<f64>,
}

/// How the player is, besides the health itself.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Condition {
    /// Since the last damage, seconds.
    pub unhurt_s: f64,
    /// The last damage, until the player stands up again from death.
    pub hurt: Option<Hurt>,
    /// Since a shot of the player's struck someone, seconds.
    pub struck_s_ago: Option<f64>,
    /// How long the player will still lie dead, seconds.
    pub dead_left_s: Option<f64>,
    /// How long nobody fights a player who has just stood up again, seconds.
    pub spared_s: f64,
}

impl Condition {
    /// How long the player has been dead, seconds.
    pub fn dead_s(&self) -> Option<f64> {
        self.dead_left_s.map(|left_s| DEAD_S - left_s)
    }

    fn pass(&mut self, dt_s: f64) {
        self.unhurt_s += dt_s;
        self.spared_s = (self.spared_s - dt_s).max(0.0);
        if let Some(hurt) = &mut self.hurt {
            hurt.ago_s += dt_s;
        }
        if let Some(ago_s) = &mut self.struck_s_ago {
            *ago_s += dt_s;
        }
    }
}

/// Health that a fall ending at that speed takes: none below eight metres, one at eight, and one for each metre more.
///
/// The height is that from which a free fall ends so fast, `v^2 / 2g`.
pub(crate) fn fall_damage(impact_m_s: f64, gravity_m_s2: f64) -> f64 {
    let height_m = impact_m_s * impact_m_s / (2.0 * gravity_m_s2);
    // A fall is stepped; its last step may end it up to a hundredth short.
    if height_m < 0.99 * FALL_HURTS_FROM_M {
        return 0.0;
    }
    (height_m - FALL_HURTS_FROM_M).max(0.0) + 1.0
}

/// The player's last damage: how long ago it was, seconds, and from which heading of the player's chart it came,
/// radians, if from one.
pub(crate) fn last(now: Situation<'_>) -> Option<(f64, Option<f64>)> {
    let hurt = now.player.condition.hurt?;
    let carried = now.world.strategy.carry_near(hurt.at, now.feet());
    let turned_rad = carried.map_or(0.0, |crossing| crossing.turn_rad);
    Some((hurt.ago_s, hurt.from_rad.map(|from| from - turned_rad)))
}

/// Takes health from the player. Nobody dies twice, and a spectator is not there to be hurt.
///
/// `from`: the way to where it came from, in the player's chart.
pub(crate) fn hurt_player(
    actors: &mut Actors,
    player: &mut Player,
    outbox: &mut Outbox,
    damage: f64,
    kind: DamageKind,
    from: Option<DVec3>,
) {
    if damage <= 0.0 || player.flying || player.is_dead() {
        return;
    }
    actors.set_health(actors.health() - damage);
    player.condition.unhurt_s = 0.0;
    player.condition.hurt = Some(Hurt {
        ago_s: 0.0,
        at: actors.feet(),
        from_rad: from.map(|way| way.z.atan2(way.x)),
    });
    outbox.sounds.push(SoundEvent::Hurt);
    if let Ok(mut appearance) = actors.ecs.get::<&mut Appearance>(actors.player) {
        appearance.motion.strike();
    }
    if actors.health() <= 0.0 {
        player.condition.dead_left_s = Some(DEAD_S);
        outbox.hints.push(match kind {
            DamageKind::Fall => Hint::DiedOfFall,
            DamageKind::Shot => Hint::DiedOfShot,
            DamageKind::Crash => Hint::DiedOfCrash,
            DamageKind::RunOver => Hint::DiedOfCar,
            DamageKind::Tree => Hint::DiedOfTree,
        });
    }
}

/// Lets a step's time heal the player; returns whether it brings the dead back.
pub(crate) fn heal(actors: &mut Actors, condition: &mut Condition) -> bool {
    condition.pass(STEP_S);
    if let Some(left_s) = condition.dead_left_s {
        let left_s = left_s - STEP_S;
        condition.dead_left_s = Some(left_s).filter(|left_s| *left_s > 0.0);
        return left_s <= 0.0;
    }
    let health = actors.health();
    if condition.unhurt_s >= HEALS_AFTER_S && health < FULL_HEALTH {
        actors.set_health(health + HEALS_PER_S * STEP_S);
    }
    false
}

/// Puts the player back to the start with full health; what was carried stays.
pub(crate) fn respawn(world: &World, actors: &mut Actors, player: &mut Player) {
    actors.set_health(FULL_HEALTH);
    player.condition = Condition {
        spared_s: SPARED_S,
        ..Condition::default()
    };
    let now = Situation::of(world, actors, player);
    let start = now.start();
    body::teleport(world, actors, player, start);
    player.stands_up = true;
    npc::send_hostile_away(world, actors);
}

/// Deals out what bullets did in a step.
pub(crate) fn take_strikes(
    actors: &mut Actors,
    player: &mut Player,
    outbox: &mut Outbox,
    strikes: Vec<Strike>,
) {
    for Strike { entity, by, way } in strikes {
        outbox.sounds.push(SoundEvent::Struck);
        if entity == actors.player {
            let from = Some(-way);
            hurt_player(
                actors,
                player,
                outbox,
                BULLET_DAMAGE,
                DamageKind::Shot,
                from,
            );
        } else {
            if by == actors.player {
                player.condition.struck_s_ago = Some(0.0);
            }
            hurt_bot(actors, entity, BULLET_DAMAGE, Some(by));
        }
    }
}

/// Takes health from a bot; `by` is who did it, if anybody.
pub(crate) fn hurt_bot(actors: &mut Actors, entity: Entity, damage: f64, by: Option<Entity>) {
    let parts = actors
        .ecs
        .query_one_mut::<(&mut Bot, &mut Health, &mut Appearance, &Position)>(entity);
    if let Ok((bot, health, appearance, position)) = parts {
        appearance.motion.strike();
        health.0 = (health.0 - damage).max(0.0);
        bot.struck_by = by.or(bot.struck_by);
        bot.hit_s_ago = 0.0;
        let at = position.0;
        actors.npcs.events.push(Event::Hit {
            victim: entity,
            at,
            by_player: by == Some(actors.player),
        });
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use std::f64::consts::{FRAC_PI_2, PI, TAU};

    use antipode_geometry::{ChartId, Geometry};
    use antipode_terrain::Generator;

    use super::*;
    use crate::Scene;
    use crate::npc::mind::Mind;
    use crate::setup::WorldSetup;

    fn scene(geometry: Geometry) -> Scene {
        made_by(Generator::default(), geometry)
    }

    fn made_by(generator: Generator, geometry: Geometry) -> Scene {
        let setup = WorldSetup {
            name: "Test".to_owned(),
            seed: 3,
            geometry,
            radius_m: 32.0,
            generator,
            mode: crate::setup::Mode::default(),
            view_distance: 1,
        };
        Scene::open(setup, None).unwrap()
    }

    fn strike(scene: &mut Scene, way: DVec3) {
        let sim = &mut scene.sim;
        let (entity, by) = (sim.actors.player, sim.actors.player);
        let strikes = vec![Strike { entity, by, way }];
        take_strikes(&mut sim.actors, &mut sim.player, &mut sim.outbox, strikes);
    }

    fn hurt(scene: &mut Scene, damage: f64, kind: DamageKind) {
        let sim = &mut scene.sim;
        let (actors, player, outbox) = (&mut sim.actors, &mut sim.player, &mut sim.outbox);
        hurt_player(actors, player, outbox, damage, kind, None);
    }

    /// Heals for a step.
    fn pass(scene: &mut Scene) {
        let sim = &mut scene.sim;
        if heal(&mut sim.actors, &mut sim.player.condition) {
            respawn(&sim.world, &mut sim.actors, &mut sim.player);
        }
    }

    #[test]
    fn who_stands_up_again_finds_none_of_those_who_fight_however_they_came_and_all_others() {
        let mut scene = scene(Geometry::Euclidean);
        assert!(scene.settle(std::time::Duration::from_mins(2)));
        scene.set_npcs(crate::NpcMode::Still);
        let near = scene.feet().moved(DVec3::new(9.0, 1.0, 0.0));
        let [fighter, peaceful, put_there, angry, put_there_in_peace] =
            [true, false, true, false, false].map(|hostile| scene.spawn_bot(near, 0.0, hostile));
        for (bot, mind) in scene.sim.actors.ecs.query_mut::<(&mut Bot, &mut Mind)>() {
            bot.native = [fighter, peaceful].contains(&bot.id);
            mind.angry_s = if bot.id == angry { 30.0 } else { 0.0 };
        }
        hurt(&mut scene, 2.0 * FULL_HEALTH, DamageKind::Shot);
        assert!(scene.is_dead() && scene.bots().len() == 5);
        for _ in 0..=(DEAD_S / STEP_S).ceil() as usize {
            pass(&mut scene);
        }
        assert!(!scene.is_dead());
        let left: Vec<_> = scene.bots().iter().map(|view| view.bot.id).collect();
        assert_eq!(left, [peaceful, put_there_in_peace], "{put_there}");
    }

    /// Far off the land of the start is gone, and in view of it there is land that carries nobody.
    #[test]
    fn who_stands_up_again_does_not_walk_before_the_ground_is_solid() {
        let limit = std::time::Duration::from_mins(2);
        let ahead = crate::Actions {
            forward: 1.0,
            ..crate::Actions::default()
        };
        for (away_m, is_in_view) in [(100.0, true), (900.0, false)] {
            let mut scene = scene(Geometry::Euclidean);
            scene.set_view_distance(6);
            assert!(scene.settle(limit));
            let start = scene.feet();
            scene.teleport(start.moved(DVec3::new(away_m, 30.0, 0.0)));
            assert!(scene.settle(limit));
            let under = antipode_geometry::ChunkCoord::containing(start);
            let land = scene.sim.world.ground.land();
            let is_there = land.meshes().any(|(coord, _)| coord == under);
            assert_eq!(is_there, is_in_view);
            hurt(&mut scene, 2.0 * FULL_HEALTH, DamageKind::Shot);
            while scene.is_dead() {
                scene.step(&crate::Actions::default());
            }
            let stood_up = scene.feet();
            assert!(!scene.is_ground_ready() && stood_up.pos.distance(start.pos) < 5.0);
            for _ in 0..120 {
                scene.step(&ahead);
                assert_eq!(scene.feet(), stood_up, "{away_m}");
            }
            assert!(scene.wait_for_step(limit));
            for _ in 0..60 {
                scene.step(&ahead);
                assert!(scene.wait_for_step(limit));
            }
            let way = scene.feet().pos - stood_up.pos;
            assert!(way.with_y(0.0).length() > 1.0 && way.y.abs() < 3.0, "{way}");
        }
    }

    #[test]
    fn falls_hurt_figures_but_for_the_one_they_came_by() {
        // There the ground is level, so that it takes the whole of a fall.
        let mut scene = made_by(Generator::OneBiome, Geometry::Euclidean);
        assert!(scene.settle(std::time::Duration::from_mins(2)));
        let from = |height_m: f64| scene.feet().moved(DVec3::new(5.0, height_m, 0.0));
        let [high, low] = [from(16.0), from(0.0)];
        let id = scene.spawn_bot(high, 0.0, false);
        let stand = |scene: &mut Scene| {
            for _ in 0..200 {
                scene.step(&crate::Actions::default());
            }
            let bots = scene.bots();
            let view = bots.iter().find(|view| view.bot.id == id);
            view.map(|view| (view.point, view.health)).unwrap()
        };
        let (ground, whole) = stand(&mut scene);
        assert!((whole - crate::tuning::BOT_HEALTH).abs() < 1e-9);
        assert!(ground.pos.y < low.pos.y + 5.0);
        for (height_m, damage) in [(7.0, 0.0), (8.5, 1.5)] {
            let found = scene
                .sim
                .actors
                .ecs
                .query_mut::<(&Bot, &mut Position, &mut Health)>();
            for (_, position, health) in found {
                position.0.pos.y = ground.pos.y + height_m;
                health.0 = crate::tuning::BOT_HEALTH;
            }
            let (_, left) = stand(&mut scene);
            let lost = crate::tuning::BOT_HEALTH - left;
            assert!((lost - damage).abs() < 0.3, "{height_m} m: {lost}");
        }
    }

    #[test]
    fn damage_is_told_with_where_it_came_from_and_ages() {
        let mut scene = scene(Geometry::Euclidean);
        assert_eq!(scene.last_hurt(), None);
        strike(&mut scene, DVec3::new(-30.0, -5.0, 0.0));
        assert_eq!(
            scene.last_hurt(),
            Some((0.0, Some(0.0))),
            "it flew along -x"
        );
        strike(&mut scene, DVec3::new(0.0, 2.0, 12.0));
        assert_eq!(scene.last_hurt(), Some((0.0, Some(-FRAC_PI_2))));
        for _ in 0..30 {
            pass(&mut scene);
        }
        assert!(
            scene
                .last_hurt()
                .is_some_and(|(ago_s, _)| (ago_s - 0.5).abs() < 1e-9)
        );
        hurt(&mut scene, 2.0, DamageKind::Fall);
        assert_eq!(scene.last_hurt(), Some((0.0, None)));
        assert_eq!(scene.struck_s_ago(), None, "nobody else was struck");
    }

    #[test]
    fn over_the_equator_damage_still_comes_from_where_it_came_from() {
        let mut scene = scene(Geometry::Spherical);
        let rim_m = scene
            .sim
            .world
            .strategy
            .domain(ChartId::FIRST)
            .radius_m()
            .unwrap();
        // So near that either chart keeps it.
        let way = DVec3::new(0.6, 0.0, 0.8) * (rim_m - 0.05);
        scene.teleport(ChartPoint::a(way.with_y(20.0)));
        let way = DVec3::new(9.0, 0.0, 31.0);
        strike(&mut scene, way);
        let over = scene
            .sim
            .world
            .strategy
            .carry(scene.feet(), ChartId::SECOND)
            .unwrap();
        scene.teleport(over.point);
        assert_eq!(scene.feet().chart, over.point.chart);
        let from = -over.turn_vector(way);
        let (_, told) = scene.last_hurt().unwrap();
        let off = (told.unwrap() - from.z.atan2(from.x) + PI).rem_euclid(TAU) - PI;
        assert!(off.abs() < 1e-9, "{off}");
    }

    #[test]
    fn falls_hurt_from_eight_metres_by_one_for_each_metre() {
        let speed = |height_m: f64| (2.0 * 20.0 * height_m).sqrt();
        let damage = |height_m: f64| fall_damage(speed(height_m), 20.0);
        assert_eq!(damage(7.5).to_bits(), 0.0f64.to_bits());
        assert!((damage(8.0) - 1.0).abs() < 1e-9);
        assert!((damage(12.0) - 5.0).abs() < 1e-9);
        assert!(damage(27.1) > FULL_HEALTH);
    }
}
