//! The minds of other figures: what they sense, choose and do. One step of all of them, and what the rest of the scene
//! tells them.

mod bearing;
mod choice;
mod dice;
mod dodge;
mod figure;
mod hidden;
pub(crate) mod mind;
mod navigation;
mod population;
mod senses;
mod shooting;
mod speech;
mod talk;
pub(crate) mod tuning;
mod wounds;

use std::sync::Arc;

use antipode_geometry::ChartPoint;
use antipode_physics::CharacterInput;
use hecs::Entity;

use crate::bot::Bot;
use crate::drops::Drop;
use crate::inventory::Stack;
use crate::item::Item;
use crate::motion::Doing;
use crate::player::{self, Appearance, Body, Health, Look, Position};
use crate::scene::Scene;
use crate::tuning::{BOT_LIES_S, MOST_DROPS, STEP_S};
pub(crate) use bearing::{ahead as place_ahead, way_to};
use dice::Dice;
use figure::Npc;
use mind::Mind;
pub use mind::State;
pub(crate) use navigation::ASKS_M;
use senses::{Around, Other, Quarry};
pub(crate) use senses::{Event, sees};
pub use speech::Speech;
pub use talk::Line;
use tuning::{LEAVES_BULLETS, THINKS_EVERY_STEPS};
pub use wounds::Wound;

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

impl Scene {
    /// Says what other figures may do. Off in a scene that was just opened.
    pub fn set_npcs(&mut self, mode: NpcMode) {
        self.actors.npcs.mode = mode;
    }

    /// Frightens everyone peaceful within `radius_m` metres of a place: they run from it for some seconds.
    pub fn scare(&mut self, from: ChartPoint, radius_m: f64) {
        self.actors.npcs.events.push(Event::Scare(from, radius_m));
    }

    /// Puts somebody peaceful there who came by himself, and waits for the player.
    pub(crate) fn let_somebody_wait(&mut self, point: ChartPoint, yaw: f64) {
        let id = self.spawn_bot(point, yaw, false);
        self.restore_mind(id, 0.0, true);
        let head = self.head().point;
        let minds = self.actors.ecs.query_mut::<(&Bot, &mut Mind)>();
        for (_, mind) in minds.into_iter().filter(|(bot, _)| bot.id == id) {
            mind.listen(head);
        }
    }

    /// A mind for a figure of that number: what it will choose follows from the world, the number and the time.
    pub(crate) fn new_mind(&self, id: u32) -> Mind {
        let seeds = [
            self.world.setup.seed,
            u64::from(id),
            self.world.simulated_s.to_bits(),
        ];
        Mind::new(Dice::new(&seeds))
    }

    /// Lets everyone live one step, the dead lie and go, and others come.
    pub(crate) fn step_bots(&mut self) {
        self.actors.npcs.steps += 1;
        let steps = self.actors.npcs.steps;
        let events = std::mem::take(&mut self.actors.npcs.events);
        let others = self.others();
        let quarry = self.quarry();
        let picture = quarry.as_ref().and_then(|_| self.other_picture());
        let cars = self.cars().into_iter();
        let cars: Vec<_> = cars.filter_map(|car| Some((car, car.comes()?))).collect();
        for (id, entity) in self.figures_in_order() {
            let Some(mut npc) = self.take_npc(entity) else {
                continue;
            };
            let around = Around {
                scene: self,
                quarry,
                picture: picture.as_ref(),
                others: &others,
                cars: &cars,
                events: &events,
            };
            if npc.health <= 0.0 {
                let dies = npc.lie(&around);
                let gone = npc.bot.dead_s > BOT_LIES_S;
                if dies {
                    self.leave_bullets(&mut npc);
                }
                self.give_back(npc);
                if gone {
                    // It was there a moment ago.
                    let _ = self.actors.ecs.despawn(entity);
                }
                continue;
            }
            npc.bot.hit_s_ago += STEP_S;
            let shot = if self.actors.npcs.mode == NpcMode::Still {
                npc.advance(&around, &CharacterInput::default());
                None
            } else {
                let thinks = (steps + u64::from(id)).is_multiple_of(THINKS_EVERY_STEPS);
                npc.live(&around, thinks);
                npc.shoot(&around)
            };
            self.give_back(npc);
            if let Some(shot) = shot {
                self.fire_for(entity, shot);
            }
        }
        if self.actors.npcs.mode == NpcMode::On {
            self.come_and_go(steps);
        }
    }

    fn figures_in_order(&self) -> Vec<(u32, Entity)> {
        let mut all: Vec<_> = self
            .actors
            .ecs
            .query::<(Entity, &Bot)>()
            .iter()
            .map(|(entity, bot)| (bot.id, entity))
            .collect();
        all.sort_unstable_by_key(|(id, _)| *id);
        all
    }

    fn others(&self) -> Vec<Other> {
        let mut all: Vec<_> = self
            .actors
            .ecs
            .query::<(Entity, &Bot, &Position, &Health, &Mind)>()
            .iter()
            .filter(|(.., health, _)| health.0 > 0.0)
            .map(|(entity, bot, position, _, mind)| Other {
                entity,
                id: bot.id,
                point: position.0,
                fights: bot.hostile || mind.angry_s > 0.0,
                native: bot.native,
            })
            .collect();
        all.sort_unstable_by_key(|other| other.id);
        all
    }

    /// The player, unless dead, spared or a spectator.
    fn quarry(&self) -> Option<Quarry> {
        let (position, _, body, _) = self.player_parts();
        let is_fair =
            !self.player.flying && !self.is_dead() && self.player.condition.spared_s <= 0.0;
        is_fair.then(|| Quarry {
            head: self.head_through(&self.world_optics()),
            feet: position.0,
            velocity: body.0.velocity,
        })
    }

    /// A figure out of the world; its mind is left behind empty until it is given back.
    fn take_npc(&mut self, entity: Entity) -> Option<Npc> {
        let empty = Mind::new(Dice::new(&[]));
        let (bot, position, look, body, health, appearance, mind) = self
            .actors
            .ecs
            .query_one_mut::<(
                &Bot,
                &Position,
                &Look,
                &Body,
                &Health,
                &Appearance,
                &mut Mind,
            )>(entity)
            .ok()?;
        Some(Npc {
            entity,
            bot: *bot,
            point: position.0,
            look: *look,
            body: body.clone(),
            health: health.0,
            appearance: *appearance,
            mind: std::mem::replace(mind, empty),
        })
    }

    fn give_back(&mut self, npc: Npc) {
        let components = (
            npc.bot,
            Position(npc.point),
            npc.look,
            npc.body,
            Health(npc.health),
            npc.appearance,
            npc.mind,
        );
        // It was there a moment ago.
        let _ = self.actors.ecs.insert(npc.entity, components);
    }

    /// The dead leave bullets, more who fought.
    fn leave_bullets(&mut self, npc: &mut Npc) {
        let [fighters, others] = LEAVES_BULLETS;
        let count = npc
            .mind
            .dice
            .whole(if npc.fights() { fighters } else { others });
        if self.actors.count::<Drop>() >= MOST_DROPS {
            return;
        }
        let stack = Stack {
            item: Item::Bullet,
            count,
        };
        let point = npc.point.moved(glam::DVec3::Y * LEAVES_AT_M);
        let mut drop = Drop::lying(stack, point);
        drop.rests = false;
        self.actors.enter(drop);
        self.kept.changed = true;
    }
}

impl Npc {
    /// Lies dead for a step; returns whether it died in it.
    fn lie(&mut self, around: &Around<'_>) -> bool {
        let dies = self.mind.state != State::Dead;
        self.mind.enter(State::Dead);
        self.bot.dead_s += STEP_S;
        let doing = Doing {
            dead: true,
            holds: self.appearance.held.is_some(),
            ..player::doing(&self.look, &self.body)
        };
        self.appearance.motion.pass(&doing, STEP_S);
        self.settle(around, &CharacterInput::default());
        let strategy = Arc::clone(&around.scene.world.strategy);
        let mut position = Position(self.point);
        player::cross(&*strategy, &mut position, &mut self.look, &mut self.body);
        self.point = position.0;
        dies
    }
}
