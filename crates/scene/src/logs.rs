//! Logs and stones: what felled trees and broken boulders leave lying. They roll downhill, strike whom they meet, and are
//! picked up like all that lies about: in gathering worlds as the kind of ground that they are of.

use antipode_geometry::ChartPoint;
use antipode_items::Item;
use antipode_physics::BallTuning;
use antipode_terrain::{Kind, Stock};
use glam::DVec3;
use hecs::Entity;

use crate::actors::Actors;
use crate::bot::Bot;
use crate::damage::{DamageKind, hurt_bot, hurt_player};
use crate::drops::Drop;
use crate::inventory::Stack;
use crate::notice::Hint;
use crate::outbox::Outbox;
use crate::pick::over;
use crate::player::{Health, Player, Position};
use crate::tuning::{DROP, MOST_DROPS};
use crate::world::World;

/// Share of its speed that what rolls keeps in a step on the ground: 0.985 to the power of 60 is 0.4 a second.
const ROLLS_ON: f64 = 0.985;
/// Share of its speed along its own length that it keeps in a step: it slides badly.
const SLIDES_ON: f64 = 0.8;
/// The part of the ground's unit normal across it, to either side, on which it stays lying: a slope of six degrees.
const STAYS: f64 = 0.1;
/// It comes to rest below this, m/s, and at the latest after so many seconds.
const RESTS_M_S: f64 = 0.15;
const RESTS_AFTER_S: f64 = 30.0;
/// Slower than this, m/s, it strikes nobody; each of those takes that much health.
const STRIKES_M_S: f64 = 2.5;
const DAMAGE_PER_M_S: f64 = 0.8;
/// Whom it strikes: so far from it over the plan, and from so far below to so far above somebody's feet, metres.
const STRUCK_M: f64 = 0.55;
const STRUCK_UP_M: [f64; 2] = [-0.4, 1.2];
/// The share of its speed that it keeps when it strikes somebody.
const KEEPS: f64 = 0.25;
/// At most so many pieces lie about of one tree; each is a stack.
const MOST_PIECES: u32 = 5;

/// How what rolls moves.
pub(crate) fn tuning(radius_m: f64) -> BallTuning {
    BallTuning {
        radius_m,
        bounce: 0.2,
        slide: ROLLS_ON,
        ..DROP
    }
}

/// What a touch of the ground does to what rolls about an axis: its velocity after it, and whether it has come to rest.
pub(crate) fn rolled(velocity: DVec3, axis: DVec3, normal: DVec3, for_s: f64) -> (DVec3, bool) {
    let along = axis * velocity.dot(axis);
    let velocity = velocity - along * (1.0 - SLIDES_ON);
    let across = axis.cross(DVec3::Y).normalize_or(DVec3::X);
    let lies = normal.dot(across).abs() < STAYS && normal.y > 0.5;
    let rests = velocity.length() < RESTS_M_S && lies;
    (velocity, rests || for_s > RESTS_AFTER_S)
}

/// Leaves so many of a thing lying about in a few pieces. Each lies where `piece` says, by its number
/// and its share of the whole, with a velocity and along a level way. Returns how many find no room among all that lies about.
pub(crate) fn leave(
    actors: &mut Actors,
    item: Item,
    count: u32,
    piece: impl Fn(u32, f64) -> (ChartPoint, DVec3, DVec3),
) -> u32 {
    let pieces = count.min(MOST_PIECES);
    let mut left = count;
    for n in 0..pieces {
        if actors.count::<Drop>() >= MOST_DROPS {
            break;
        }
        let count = left / (pieces - n);
        let (point, velocity, along) = piece(n, (f64::from(n) + 0.5) / f64::from(pieces));
        let stack = Stack { item, count };
        actors.enter(Drop::thrown(stack, point, velocity, along));
        left -= count;
    }
    left
}

/// How many pieces of an item there are in so many cubic metres of what it is of.
pub(crate) fn pieces_in(item: Item, m3: f64) -> u32 {
    let each = item.is_of();
    each.map_or(0, |(_, each_m3)| (m3 / each_m3).round() as u32)
}

/// What so many of an item are to who gathers; nothing of what stays what it is.
pub(crate) fn ground_of(item: Item, count: u32) -> Option<(Kind, f64)> {
    let (kind, m3) = item.is_of()?;
    Some((Kind::of_name(kind)?, m3 * f64::from(count)))
}

/// Gives who gathers some ground, and shows it as what a stroke brings. In creative worlds nothing is gathered.
pub(crate) fn gain(world: &mut World, player: &mut Player, brought: &Stock) {
    if world.streamer.spend(&brought.negative()) {
        player.presses += 1;
        let now_s = world.simulated_s;
        let nothing = antipode_terrain::Earth::default();
        player
            .earthworks
            .enter(player.presses, &nothing, brought, now_s);
    }
}

/// Gives the player at once what finds no room among all that lies about: to who gathers as ground.
pub(crate) fn take_in(
    world: &mut World,
    player: &mut Player,
    outbox: &mut Outbox,
    item: Item,
    count: u32,
) {
    if count == 0 {
        return;
    }
    let gathers = world.streamer.stock().is_some();
    if let Some((kind, m3)) = ground_of(item, count).filter(|_| gathers) {
        let mut brought = Stock::default();
        brought.add(kind, m3);
        gain(world, player, &brought);
    } else if player.inventory.give(item, count) > 0 {
        outbox.hints.push(Hint::TooManyDrops);
    }
}

/// Strikes whom something runs into that rolls fast: not while it has not met the ground yet, so that nobody is struck by what he
/// throws down before him.
pub(crate) fn strike(world: &World, actors: &mut Actors, player: &mut Player, outbox: &mut Outbox) {
    let fast: Vec<(Entity, Drop)> = {
        let mut drops = actors.ecs.query::<(Entity, &Drop)>();
        let rolling = drops.iter().filter(|(_, it)| {
            it.rolls_at(STRIKES_M_S) && it.is_awake(&*world.strategy, actors.feet())
        });
        rolling.map(|(entity, it)| (entity, *it)).collect()
    };
    for (entity, it) in fast {
        let strategy = &*world.strategy;
        let meets = |feet: ChartPoint| {
            let from = it.point.pos - over(strategy, it.point, feet).pos;
            let [low_m, high_m] = STRUCK_UP_M;
            from.with_y(0.0).length() < STRUCK_M && (low_m..high_m).contains(&from.y)
        };
        let struck: Vec<Entity> = {
            let mut bots = actors.ecs.query::<(Entity, &Bot, &Position, &Health)>();
            let living = bots.iter().filter(|(.., health)| health.0 > 0.0);
            let met = living.filter(|(_, _, position, _)| meets(position.0));
            met.map(|(entity, ..)| entity).collect()
        };
        let strikes_player = meets(actors.feet()) && !actors.cars.is_driving();
        if struck.is_empty() && !strikes_player {
            continue;
        }
        let damage = DAMAGE_PER_M_S * it.velocity.length();
        for entity in struck {
            hurt_bot(actors, entity, damage, None);
        }
        if strikes_player {
            let from = Some(-it.velocity.normalize_or(DVec3::X));
            hurt_player(actors, player, outbox, damage, DamageKind::Tree, from);
        }
        if let Ok(mut drop) = actors.ecs.get::<&mut Drop>(entity) {
            drop.velocity *= KEEPS;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What lies across the slope rolls on, what lies along it slides to a stop, and what lies level stays.
    #[test]
    fn it_rolls_about_its_length_only() {
        let slope = DVec3::new(0.3, 0.9, 0.0).normalize();
        let downhill = DVec3::new(1.0, -0.3, 0.0);
        let (rolls, rests) = rolled(downhill, DVec3::Z, slope, 1.0);
        assert!(!rests && rolls == downhill);
        let (slides, _) = rolled(downhill, DVec3::X, slope, 1.0);
        assert!(slides.length() < 0.9 * downhill.length());
        let slow = 0.01 * DVec3::X;
        assert!(!rolled(slow, DVec3::Z, slope, 1.0).1, "it begins to roll");
        assert!(rolled(slow, DVec3::Z, DVec3::Y, 1.0).1);
        assert!(
            rolled(downhill, DVec3::Z, slope, 31.0).1,
            "it ends some day"
        );
    }

    #[test]
    fn pieces_are_as_many_as_there_is_of_their_kind() {
        assert_eq!(pieces_in(Item::Log, 1.24), 12);
        assert_eq!(pieces_in(Item::Gun, 1.24), 0);
        let (kind, m3) = ground_of(Item::Log, 12).unwrap_or((Kind::Rock, 0.0));
        assert!(kind == Kind::Wood && (m3 - 1.2).abs() < 1e-9);
        assert_eq!(ground_of(Item::Lamp, 1), None);
        let named = Item::ALL.into_iter().filter(|item| item.is_of().is_some());
        assert!(named.clone().all(|item| ground_of(item, 1).is_some()));
        assert!(named.count() > 1);
    }
}
