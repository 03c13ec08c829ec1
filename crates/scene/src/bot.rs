//! Other figures of the world as what they are: put there, looked at, struck. What they want and do is in `npc`.

use antipode_geometry::ChartPoint;
use antipode_items::Item;
use antipode_physics::Character;
use hecs::Entity;

use crate::actors::Actors;
use crate::frame::ModelId;
use crate::npc::mind::Mind;
use crate::npc::{State, new_mind};
use crate::player::{Appearance, Body, Health, Look, Position};
use crate::world::World;

/// A figure that nobody plays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bot {
    /// Its number in this world.
    pub id: u32,
    /// Whether it fights the player by nature.
    pub hostile: bool,
    /// Whether it came by itself, and may go so.
    pub native: bool,
    /// Since it was last hit, seconds.
    pub hit_s_ago: f64,
    /// Since it died, seconds; zero while it lives.
    pub dead_s: f64,
    /// The last one that hit it.
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
    /// What it is doing.
    pub state: State,
    /// Whether it fights the player now.
    pub fights: bool,
    /// For how long yet it is angry, seconds.
    pub angry_s: f64,
}

/// Puts a bot with its feet at a point; `native`: whether it came by itself.
pub(crate) fn spawn(
    world: &World,
    actors: &mut Actors,
    point: ChartPoint,
    yaw: f64,
    hostile: bool,
    health: f64,
    native: bool,
) -> Entity {
    let id = actors.give_number::<Bot>();
    let bot = Bot {
        id: id.0,
        hostile,
        native,
        hit_s_ago: f64::INFINITY,
        dead_s: 0.0,
        struck_by: None,
    };
    actors.ecs.spawn((
        id,
        bot,
        new_mind(world, id.0),
        Position(point),
        Look { yaw, pitch: 0.0 },
        Body(Character::at(point.pos)),
        Health(health),
        Appearance {
            held: hostile.then_some(ModelId::Item(Item::Gun)),
            ..Appearance::standing(ModelId::AstronautTeal)
        },
    ))
}

/// The living, by their numbers.
pub(crate) fn living(actors: &Actors) -> Vec<BotView> {
    let mut all = views(actors);
    all.retain(|view| view.health > 0.0);
    all
}

/// All bots, by their numbers.
pub(crate) fn views(actors: &Actors) -> Vec<BotView> {
    let mut bots: Vec<_> = actors
        .ecs
        .query::<(&Bot, &Position, &Look, &Health, &Mind)>()
        .iter()
        .map(|(bot, position, look, health, mind)| BotView {
            bot: *bot,
            point: position.0,
            yaw: look.yaw,
            health: health.0,
            state: mind.state,
            fights: bot.hostile || mind.angry_s > 0.0,
            angry_s: mind.angry_s,
        })
        .collect();
    bots.sort_unstable_by_key(|view| view.bot.id);
    bots
}
