//! Figures come out of sight around the player and go when they are far and out of sight.

use antipode_geometry::{ChartPoint, ChunkCoord};
use antipode_items::Item;
use antipode_plants::placed_near;
use glam::DVec3;

use super::bearing::{ahead, any_heading, apart_m, toward};
use super::dice::Dice;
use super::tuning::{
    APPEARS_M, GOES_M, HOSTILE_EVERY_S, MOST_HOSTILE, MOST_LIVING, PEACE_S, UNSEEN_RAD,
};
use crate::actors::{ActorId, Actors};
use crate::bot::{self, Bot};
use crate::player::Player;
use crate::setup::Mode;
use crate::situation::Situation;
use crate::tuning::{BODIES_WITHIN_CHUNKS, BOT_HEALTH};
use crate::world::World;

/// Steps between two looks at the figures that are there.
const EVERY_STEPS: u64 = 60;
/// Places that are tried each time.
const TRIES: u32 = 4;
/// Nobody comes nearer to what grows, metres.
const ROOM_M: f64 = 2.0;
/// Gap below the feet of a figure that appears, in metres.
const CLEARANCE_M: f64 = 0.15;
/// How much nearer than the border of where bodies move someone comes, in metres.
const LOADED_SLACK_M: f64 = 12.0;

/// Every second those who are far and not seen go, and one more comes if there are too few.
pub(super) fn come_and_go(world: &World, actors: &mut Actors, player: &Player) {
    if !actors.npcs.steps.is_multiple_of(EVERY_STEPS) {
        return;
    }
    let now = Situation::of(world, actors, player);
    let feet = now.feet();
    let leaves =
        |point: ChartPoint| apart_m(&*world.strategy, feet, point) > GOES_M && !may_see(now, point);
    let (gone, left): (Vec<_>, Vec<_>) = bot::living(actors)
        .into_iter()
        .partition(|view| view.bot.native && leaves(view.point));
    for view in gone {
        actors.remove::<Bot>(ActorId(view.bot.id));
    }
    let closed = world.strategy.is_closed();
    let most = if closed { MOST_LIVING.1 } else { MOST_LIVING.0 };
    if left.len() >= most {
        return;
    }
    let hostile = left.iter().filter(|view| view.fights).count();
    let at_peace = world.simulated_s < PEACE_S || !can_fight(world, player);
    let peaceful = if at_peace {
        most / 2
    } else {
        // The hostile ones' places are kept for them.
        most - MOST_HOSTILE
    };
    if left.len() - hostile < peaceful {
        let_one_come(world, actors, player, false);
    } else if hostile < MOST_HOSTILE
        && !at_peace
        && world.simulated_s >= actors.npcs.peace_until_s
        && let_one_come(world, actors, player, true)
    {
        actors.npcs.peace_until_s = world.simulated_s + HOSTILE_EVERY_S;
    }
}

/// Whether a player can answer a fight: in gathering worlds the gun has to be made first.
fn can_fight(world: &World, player: &Player) -> bool {
    world.setup.mode == Mode::Creative || player.inventory.count(Item::Gun) > 0
}

/// Those who fight are gone when the player stands up again, however they came, and others wait.
pub(crate) fn send_hostile_away(world: &World, actors: &mut Actors) {
    for view in bot::living(actors).iter().filter(|view| view.fights) {
        actors.remove::<Bot>(ActorId(view.bot.id));
    }
    let rest_s = world.simulated_s + HOSTILE_EVERY_S;
    actors.npcs.peace_until_s = actors.npcs.peace_until_s.max(rest_s);
}

/// Tells whether one came.
fn let_one_come(world: &World, actors: &mut Actors, player: &Player, hostile: bool) -> bool {
    let seeds = [world.setup.seed, world.simulated_s.to_bits(), 0x9e3d];
    let mut dice = Dice::new(&seeds);
    let loaded_m = f64::from(BODIES_WITHIN_CHUNKS) * 32.0 - LOADED_SLACK_M;
    let far_m = APPEARS_M.1.min(loaded_m.max(LOADED_SLACK_M));
    let near_m = APPEARS_M.0 * far_m / APPEARS_M.1;
    let now = Situation::of(world, actors, player);
    let place = (0..TRIES).find_map(|_| {
        let heading = any_heading(&*world.strategy, now.feet().chart, dice.heading());
        let away_m = dice.between([near_m, far_m]);
        let mut point = ahead(&*world.strategy, now.feet(), toward(heading), away_m);
        point.pos.y = world.ground.untouched_height(point) + CLEARANCE_M;
        let there = world.lets_move(ChunkCoord::containing(point));
        // By the seed: what is loaded there may differ.
        let is_free = || {
            let field = world.ground.field();
            placed_near(field, point, ROOM_M).next().is_none()
        };
        (there && !may_see(now, point) && is_free()).then_some(point)
    });
    let Some(point) = place else { return false };
    let yaw = any_heading(&*world.strategy, point.chart, dice.heading());
    bot::spawn(world, actors, point, yaw, hostile, BOT_HEALTH, true);
    true
}

/// Whether a place may be in the picture, whatever is before it.
fn may_see(now: Situation<'_>, point: ChartPoint) -> bool {
    let params = now.aiming();
    let eye = now.camera_through(&params).eye;
    let view = params
        .strategy
        .view_point(&eye, point.moved(DVec3::Y))
        .truncate()
        .normalize_or_zero();
    -view.z > UNSEEN_RAD.cos()
}
