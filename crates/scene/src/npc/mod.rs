//! The minds of other figures: what they sense, choose and do. One step of all of them, and what the rest of the scene
//! tells them.

mod bearing;
mod choice;
mod cover;
mod dice;
mod dodge;
mod doors;
mod figure;
mod hidden;
pub(crate) mod mind;
mod navigation;
mod population;
mod seats;
mod senses;
mod shooting;
mod speech;
mod talk;
pub(crate) mod tuning;
mod wounds;

use antipode_geometry::ChartPoint;
use antipode_physics::CharacterInput;
use glam::DVec3;
use hecs::Entity;

use crate::actors::Actors;
use crate::bot::{self, Bot};
use crate::drops::Drop;
use crate::fixture::{self, Fixture};
use crate::inventory::Stack;
use crate::outbox::Outbox;
use crate::player::{self, Body, Player};
use crate::situation::Situation;
use crate::tuning::{BOT_HEALTH, BOT_LIES_S, MOST_DROPS, STEP_S};
use crate::world::World;
use antipode_frame::motion::Doing;
use antipode_items::Item;
pub(crate) use bearing::{ahead as place_ahead, any_heading, apart_m, way_to};
pub(crate) use dice::Dice;
use figure::Npc;
pub(crate) use hidden::hidden_foes;
use mind::Mind;
pub use mind::State;
pub(crate) use navigation::ASKS_M;
pub(crate) use population::send_hostile_away;
use senses::{Around, Quarry};
pub(crate) use senses::{Event, sees, world_view_params};
pub use speech::Speech;
pub(crate) use speech::{is_speaking, speech};
pub use talk::Line;
pub(crate) use talk::talk;
use tuning::{LEAVES_BULLETS, THINKS_EVERY_STEPS};
pub use wounds::Wound;
pub(crate) use wounds::wounds;

/// Height over the ground at which the dead leave what they had, in metres.
const LEAVES_AT_M: f64 = 0.4;

/// What the figures of a world have in common.
#[derive(Debug, Default)]
pub(crate) struct Npcs {
    /// What has happened since they last looked.
    pub events: Vec<Event>,
    /// Steps so far.
    steps: u64,
    /// Whether they come by themselves, and have a mind.
    pub mode: NpcMode,
    /// What was said last.
    said: Option<speech::Said>,
    /// After a world's first peace, too, no hostile figure comes before that time, in seconds.
    peace_until_s: f64,
}

/// What other figures may do in a scene; no part of the world, so nothing of it is saved.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum NpcMode {
    /// They come and go by themselves.
    On,
    /// None comes or goes by itself; those who are there live.
    #[default]
    Off,
    /// Those who are there stand still, as targets do.
    Still,
}

/// Frightens everyone peaceful within `radius_m` metres of a place: they run from it for some seconds.
pub(crate) fn scare(actors: &mut Actors, from: ChartPoint, radius_m: f64) {
    actors.npcs.events.push(Event::Scare(from, radius_m));
}

/// Puts somebody peaceful there who came by himself, and waits for the player whose head is there.
pub(crate) fn let_somebody_wait(
    world: &World,
    actors: &mut Actors,
    head: ChartPoint,
    point: ChartPoint,
    yaw: f64,
) {
    let entity = bot::spawn(world, actors, point, yaw, false, BOT_HEALTH, true);
    if let Ok(mind) = actors.ecs.query_one_mut::<&mut Mind>(entity) {
        mind.listen(head);
    }
}

/// A mind for a figure of that number: what it will choose follows from the world, the number and the time.
pub(crate) fn new_mind(world: &World, id: u32) -> Mind {
    let seeds = [world.setup.seed, u64::from(id), world.simulated_s.to_bits()];
    Mind::new(Dice::new(&seeds))
}

/// Lets everyone live one step, the dead lie and go, and others come.
pub(crate) fn step(world: &World, actors: &mut Actors, player: &Player, outbox: &mut Outbox) {
    actors.npcs.steps += 1;
    let (steps, mode) = (actors.npcs.steps, actors.npcs.mode);
    let events = std::mem::take(&mut actors.npcs.events);
    let now = Situation::of(world, actors, player);
    let living = bot::living(actors);
    let quarry = quarry(now);
    let picture = quarry.as_ref().and_then(|_| hidden::other_picture(now));
    let cars = actors.car_views().into_iter();
    let cars: Vec<_> = cars.filter_map(|car| Some((car, car.comes()?))).collect();
    let lamps = fixture::map(actors, |_, it| it.item.shines().then(|| it.clone()));
    let lamps: Vec<Fixture> = lamps.into_iter().flatten().collect();
    for (id, entity) in figures_in_order(actors) {
        let Ok(mut npc) = actors.ecs.query_one_mut::<Npc<'_>>(entity) else {
            continue;
        };
        let around = Around {
            world,
            tuning: &actors.tuning,
            quarry,
            picture: picture.as_ref(),
            living: &living,
            cars: &cars,
            lamps: &lamps,
            events: &events,
        };
        if npc.health.0 <= 0.0 {
            let left = npc.lie(&around);
            let gone = npc.bot.dead_s > BOT_LIES_S;
            if let Some(drop) = left.filter(|_| actors.count::<Drop>() < MOST_DROPS) {
                actors.enter(drop);
            }
            if gone {
                // It was there a moment ago.
                let _ = actors.ecs.despawn(entity);
            }
            continue;
        }
        npc.bot.hit_s_ago += STEP_S;
        if mode == NpcMode::Still {
            npc.advance(&around, &CharacterInput::default());
            continue;
        }
        let thinks = (steps + u64::from(id)).is_multiple_of(THINKS_EVERY_STEPS);
        npc.live(&around, thinks);
        if let Some(shot) = npc.shoot(&around) {
            shooting::fire(world, actors, outbox, entity, shot);
        }
    }
    if mode == NpcMode::On {
        population::come_and_go(world, actors, player);
    }
}

fn figures_in_order(actors: &Actors) -> Vec<(u32, Entity)> {
    let mut query = actors.ecs.query::<(Entity, &Bot)>();
    let mut all: Vec<_> = query.iter().map(|(entity, bot)| (bot.id, entity)).collect();
    all.sort_unstable_by_key(|(id, _)| *id);
    all
}

/// The player, unless dead, invulnerable or a spectator.
fn quarry(now: Situation<'_>) -> Option<Quarry> {
    let player = now.player;
    let is_fair = !player.flying && !player.is_dead() && player.condition.spared_s <= 0.0;
    is_fair.then(|| {
        let body = now.actors.ecs.get::<&Body>(now.actors.player);
        Quarry {
            feet: now.feet(),
            velocity: body.map_or(DVec3::ZERO, |body| body.0.velocity),
            head: now.head_through(&world_view_params(now.world)),
        }
    })
}

impl Npc<'_> {
    /// Lies dead for a step. Returns the bullets that a figure leaves in the step in which it dies; fighters leave more.
    fn lie(&mut self, around: &Around<'_>) -> Option<Drop> {
        let dies = self.mind.state != State::Dead;
        if let Some(seat) = self.mind.seat.take() {
            self.position.0 = seat.left(self.position.0);
        }
        self.mind.enter(State::Dead);
        self.bot.dead_s += STEP_S;
        let doing = Doing {
            dead: true,
            holds: self.appearance.held.is_some(),
            ..player::doing(self.look, self.body)
        };
        self.appearance.motion.pass(&doing, STEP_S);
        self.settle(around, &CharacterInput::default());
        player::cross(around.strategy(), self.position, self.look, self.body);
        dies.then(|| self.leave_bullets())
    }

    fn leave_bullets(&mut self) -> Drop {
        let [fighters, others] = LEAVES_BULLETS;
        let range = if self.fights() { fighters } else { others };
        let stack = Stack {
            item: Item::Bullet,
            count: self.mind.dice.whole(range),
        };
        let point = self.position.0.moved(DVec3::Y * LEAVES_AT_M);
        let mut drop = Drop::lying(stack, point);
        drop.rests = false;
        drop
    }
}
