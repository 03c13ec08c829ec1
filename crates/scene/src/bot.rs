//! Other figures of the world. They stand, fall with the ground and die; what they want is decided elsewhere.

use antipode_geometry::ChartPoint;
use antipode_physics::{Character, CharacterInput};
use hecs::Entity;

use crate::frame::ModelId;
use crate::ground::chunks_near;
use crate::motion::Doing;
use crate::player::{self, Appearance, Body, Health, Look, Position};
use crate::projectile::Standing;
use crate::scene::Scene;
use crate::tuning::{BOT_HEALTH, BOT_LIES_S, STEP_S};

/// Ground within this distance of a bot must be there before it moves, in metres.
const NEEDED_AROUND_M: f64 = 2.0;

/// A figure that nobody plays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bot {
    /// Its number in this world.
    pub id: u32,
    /// Whether it fights the player.
    pub hostile: bool,
    /// Since it was last hit, seconds.
    pub hit_s_ago: f64,
    /// Since it died, seconds; zero while it lives.
    pub dead_s: f64,
    /// Who hit it last.
    pub(crate) struck_by: Option<Entity>,
}

/// What others may know of a bot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BotView {
    /// The bot.
    pub bot: Bot,
    /// Where its feet are.
    pub point: ChartPoint,
    /// The way it faces, radians.
    pub yaw: f64,
    /// Its health.
    pub health: f64,
}

impl Scene {
    /// Puts a bot with its feet at a point; returns its number.
    pub fn spawn_bot(&mut self, point: ChartPoint, yaw: f64, hostile: bool) -> u32 {
        self.restore_bot(point, yaw, hostile, BOT_HEALTH)
    }

    pub(crate) fn restore_bot(
        &mut self,
        point: ChartPoint,
        yaw: f64,
        hostile: bool,
        health: f64,
    ) -> u32 {
        let id = self.next_bot;
        self.next_bot += 1;
        let origin = self.strategy.chart_origin_m(point.hemisphere);
        let bot = Bot {
            id,
            hostile,
            hit_s_ago: f64::INFINITY,
            dead_s: 0.0,
            struck_by: None,
        };
        self.ecs.spawn((
            bot,
            Position(point),
            Look { yaw, pitch: 0.0 },
            Body(Character::at(point.pos + origin)),
            Health(health),
            Appearance {
                held: hostile.then_some(ModelId::Gun),
                ..Appearance::standing(ModelId::AstronautTeal)
            },
        ));
        self.changed = true;
        id
    }

    /// All bots, by their numbers.
    pub fn bots(&self) -> Vec<BotView> {
        let mut bots: Vec<_> = self
            .ecs
            .query::<(&Bot, &Position, &Look, &Health)>()
            .iter()
            .map(|(bot, position, look, health)| BotView {
                bot: *bot,
                point: position.0,
                yaw: look.yaw,
                health: health.0,
            })
            .collect();
        bots.sort_unstable_by_key(|view| view.bot.id);
        bots
    }

    /// Lets every bot stand, fall or lie for one step, and the dead go.
    pub(crate) fn step_bots(&mut self) {
        let mut gone = Vec::new();
        let strategy = std::sync::Arc::clone(&self.strategy);
        for (entity, bot, position, look, body, health, appearance) in self.ecs.query_mut::<(
            Entity,
            &mut Bot,
            &mut Position,
            &mut Look,
            &mut Body,
            &Health,
            &mut Appearance,
        )>() {
            bot.hit_s_ago += STEP_S;
            let doing = Doing {
                dead: health.0 <= 0.0,
                holds: appearance.held.is_some(),
                ..player::doing(look, body)
            };
            appearance.motion.pass(&doing, STEP_S);
            if health.0 <= 0.0 {
                bot.dead_s += STEP_S;
                if bot.dead_s > BOT_LIES_S {
                    gone.push(entity);
                    continue;
                }
            }
            let near = chunks_near(&*strategy, position.0, NEEDED_AROUND_M);
            if !near.into_iter().all(|coord| self.streamer.is_ready(coord)) {
                continue;
            }
            let origin = strategy.chart_origin_m(position.0.hemisphere);
            body.0.feet = position.0.pos + origin;
            self.physics.move_character(
                &mut body.0,
                &self.tuning,
                &CharacterInput::default(),
                STEP_S,
            );
            position.0.pos = body.0.feet - origin;
            player::cross(&*strategy, position, look, body);
        }
        for entity in gone {
            // It was there a moment ago.
            let _ = self.ecs.despawn(entity);
        }
    }

    /// Everyone who can be struck, where they stand in physics space; the dead and spectators cannot.
    pub(crate) fn standing(&self) -> Vec<Standing> {
        let mut all: Vec<Standing> = self
            .ecs
            .query::<(Entity, &Position, &Health)>()
            .iter()
            .filter(|(entity, _, health)| {
                // Who drives is met by what meets the car.
                let is_there = *entity != self.player || !(self.flying || self.is_driving());
                health.0 > 0.0 && is_there
            })
            .map(|(entity, position, _)| Standing {
                entity,
                feet: position.0.pos + self.strategy.chart_origin_m(position.0.hemisphere),
                height_m: self.tuning.height_m,
                radius_m: self.tuning.radius_m,
            })
            .collect();
        all.sort_unstable_by_key(|it| it.entity.id());
        all
    }
}
