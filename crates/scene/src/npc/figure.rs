//! One figure in one step: it takes in what happened, thinks when it is its turn, and moves.

use antipode_geometry::{BodyFrame, ChartPoint};
use antipode_items::Item;
use antipode_physics::CharacterInput;
use glam::DVec3;
use hecs::{Entity, Query};

use super::bearing::{ahead, way};
use super::doors::Detour;
use super::mind::{Mind, Sits, State};
use super::navigation::{ASKS_M, BLOCKED_M, LOOKS_M, WalkableGround};
use super::senses::{Around, Event};
use super::tuning::{FIGHT_PACE, HEALS_AFTER_S, HEALS_PER_S, STROLL_PACE, TURNS_RAD_S};
use crate::bot::{Bot, BotView};
use crate::damage::fall_damage;
use crate::door;
use crate::felling;
use crate::frame::ModelId;
use crate::pick::over_if_near;
use crate::player::{self, Appearance, Body, Health, Look, Position, wrap_angle};
use crate::tuning::{BOT_HEALTH, STEP_S};
use antipode_frame::motion::Doing;

/// Ground within this distance must be there before one moves, in metres.
const NEEDED_AROUND_M: f64 = 2.0;
/// A step of a way is taken this near to it, in metres.
const STEP_THERE_M: f64 = 0.4;
/// Plans are made anew after so long, in seconds: those that reached their goal, and those that did not.
const PLANS_EVERY_S: (f64, f64) = (1.0, 2.0);
/// A chunk whose middle is within this of one may have what a plan asks about: half a chunk's diagonal more, in metres.
const CHANGED_M: f64 = ASKS_M + 28.0;
/// A figure that does not get on by this distance, in metres, within this time, in seconds, is stuck.
const GETS_ON_M: f64 = 0.35;
const STUCK_AFTER_S: f64 = 1.2;
/// A figure that is stuck has no way so far ahead of it, in metres.
const BLOCKED_AHEAD_M: f64 = 0.9;
/// How long a place that was no way is not tried again, in seconds.
const BLOCKED_S: f64 = 8.0;
/// Where exactly to be is gone to straight from so far, in metres.
const SPOT_FROM_M: f64 = 2.0;
/// How far from what is solid the middle of a body passes it, in metres.
const BESIDE_M: f64 = 0.45;
/// So often in a row stuck, one gives a goal up.
const STUCK_TIMES: u32 = 3;
/// Nearer than this others are kept away from, in metres.
const ROOM_M: f64 = 0.9;

/// A figure that lives its step.
#[derive(Query)]
pub(crate) struct Npc<'a> {
    pub entity: Entity,
    pub bot: &'a mut Bot,
    pub position: &'a mut Position,
    pub look: &'a mut Look,
    pub body: &'a mut Body,
    pub health: &'a mut Health,
    pub appearance: &'a mut Appearance,
    pub mind: &'a mut Mind,
}

impl Npc<'_> {
    /// Lives one step; `thinks`: whether it is its turn to.
    pub fn live(&mut self, around: &Around<'_>, thinks: bool) {
        self.mind.pass();
        self.heal();
        self.notice(around);
        if thinks {
            self.perceive(around);
            self.hide(around);
            self.choose(around);
            self.plan(around);
        }
        let input = self.steer(around);
        self.face(around);
        self.appearance.held = self.fights().then_some(ModelId::Item(Item::Gun));
        self.advance(around, &input);
    }

    fn heal(&mut self) {
        if self.bot.hit_s_ago > HEALS_AFTER_S && self.health.0 < BOT_HEALTH {
            self.health.0 = (self.health.0 + HEALS_PER_S * STEP_S).min(BOT_HEALTH);
        }
    }

    /// Finds a way to the goal when there is none yet, or it is old.
    fn plan(&mut self, around: &Around<'_>) {
        let Some(goal) = self.mind.goal else { return };
        let there = way(around.strategy(), self.position.0, goal.point);
        let detour = around.detour(self.position.0, goal.point);
        if detour.is_none() && there.level_m < goal.within_m {
            self.arrive(around, goal.sits);
            return;
        }
        let stale_s = if self.mind.steps.is_empty() {
            PLANS_EVERY_S.0.min(0.5)
        } else {
            PLANS_EVERY_S.1
        };
        let changed = around
            .events
            .iter()
            .any(|event| matches!(*event, Event::Ground(at) if around.apart_m(self.position.0, at) < CHANGED_M));
        // While somebody digs the ground changes many times a second.
        let stale_s = if changed {
            PLANS_EVERY_S.0.min(0.25)
        } else {
            stale_s
        };
        if self.mind.planned_s < stale_s || !self.body.0.grounded {
            return;
        }
        // What a plan asks about must be there; else it would depend on how quickly it comes.
        let world = around.world;
        if !world.is_firm_around(self.position.0, ASKS_M) {
            return;
        }
        let blocked = self.no_way(around);
        let land = WalkableGround {
            strategy: around.strategy(),
            ground: &world.ground,
            blocked: &blocked,
        };
        self.mind.planned_s = 0.0;
        let target = match detour {
            Some(Detour {
                before: None,
                beyond,
            }) => {
                self.mind.steps = vec![beyond];
                return;
            }
            Some(Detour {
                before: Some(before),
                ..
            }) => before,
            None => goal.point,
        };
        match land.route(self.position.0, target) {
            Some(route) => self.mind.steps = route.steps,
            None => self.find_no_way(),
        }
    }

    /// Places about that are no way, and how far about them there is none: what stands there, with the width of a body.
    pub(super) fn no_way(&self, around: &Around<'_>) -> Vec<(ChartPoint, f64)> {
        let spots = self.mind.blocked.iter().map(|(spot, _)| (*spot, BLOCKED_M));
        let solids = felling::solids_near(around.world, self.position.0, LOOKS_M);
        let solids = solids.iter().map(|it| {
            let (radius_m, _) = it.solid_m().unwrap_or_default();
            (it.root(), BLOCKED_M.max(radius_m + BESIDE_M))
        });
        spots.chain(solids).collect()
    }

    fn arrive(&mut self, around: &Around<'_>, sits: Option<Sits>) {
        self.mind.halt();
        match (self.mind.state, sits) {
            (State::Wander, Some(Sits::Lamp(lamp))) => {
                self.mind.enter(State::Sit);
                self.mind.face = Some(lamp);
            }
            (State::Wander, Some(Sits::Stone(seat))) => {
                self.take_seat(seat, around.tuning.eye_height_m());
            }
            (State::Wander, None) => {
                self.mind.rest();
                // A figure that has met somebody looks at that one.
                self.mind.face = self
                    .others(around)
                    .find(|other| around.apart_m(self.position.0, other.point) < 3.0)
                    .map(|other| other.point.moved(DVec3::Y * around.tuning.eye_height_m()));
            }
            _ => {}
        }
    }

    /// No way leads nearer to the goal: in peace another is chosen, in a fight it is tried again later.
    fn find_no_way(&mut self) {
        self.mind.steps.clear();
        self.mind.stuck += 1;
        match self.mind.state {
            State::Wander | State::Aside => self.mind.rest(),
            _ if self.mind.stuck > STUCK_TIMES => {
                self.mind.goal = None;
                self.mind.side = -self.mind.side;
                self.mind.stuck = 0;
            }
            _ => {}
        }
    }

    /// What the body is asked to do to follow the way.
    fn steer(&mut self, around: &Around<'_>) -> CharacterInput {
        let mut input = CharacterInput::default();
        let room = self.room(around);
        let pace = self.mind.goal.map_or(0.0, |goal| goal.pace);
        while let Some(step) = self.mind.steps.last().copied() {
            let there = way(around.strategy(), self.position.0, step);
            if there.level_m < STEP_THERE_M {
                self.mind.steps.pop();
                continue;
            }
            input.wish = there.heading * pace.min(1.0);
            break;
        }
        if input.wish == DVec3::ZERO {
            input.wish = self.to_spot(around);
            self.mind.anchor = None;
        } else {
            self.watch_progress(around);
        }
        input.wish = (input.wish + room).clamp_length_max(1.0);
        if pace > 1.0 && input.wish != DVec3::ZERO {
            // Faster than a walk is a share of a sprint.
            input.sprint = true;
            input.wish *= pace / around.tuning.sprint_factor;
        }
        input
    }

    /// Straight on to exactly where it wants to be, slower and slower.
    fn to_spot(&self, around: &Around<'_>) -> DVec3 {
        let Some(spot) = self.mind.spot else {
            return DVec3::ZERO;
        };
        let off = BodyFrame::way(around.strategy(), self.position.0, spot).with_y(0.0);
        let pace = if self.mind.state == State::Sit {
            STROLL_PACE
        } else {
            FIGHT_PACE
        };
        if off.length() < SPOT_FROM_M {
            off.clamp_length_max(pace)
        } else {
            DVec3::ZERO
        }
    }

    /// All other figures that live.
    pub fn others<'b>(&self, around: &Around<'b>) -> impl Iterator<Item = &'b BotView> + use<'b> {
        let id = self.bot.id;
        around.living.iter().filter(move |it| it.bot.id != id)
    }

    /// Which way to give room to others who stand too close, and how much.
    fn room(&self, around: &Around<'_>) -> DVec3 {
        let player = around.quarry.iter().map(|quarry| quarry.feet);
        let others = self.others(around);
        // A metre of a tile's chart is up to 1.45 of the space.
        let is_tiled = around.strategy().tiled().is_some();
        let mut push = DVec3::ZERO;
        for point in others.map(|it| it.point).chain(player) {
            let own = self.position.0;
            let Some(near) = over_if_near(around.strategy(), own, point, ROOM_M) else {
                continue;
            };
            let away = own.pos - near.pos;
            let away = if is_tiled {
                around.strategy().in_frame(own, away)
            } else {
                away
            };
            let level_m = away.with_y(0.0).length();
            if level_m < ROOM_M && away.y.abs() < 1.8 {
                push += away.with_y(0.0).normalize_or(DVec3::X) * (0.6 * (1.0 - level_m / ROOM_M));
            }
        }
        push.clamp_length_max(0.5)
    }

    /// Notes whether it gets on. A figure that does not get on looks for a way round in the next step, and gives up in the end.
    fn watch_progress(&mut self, around: &Around<'_>) {
        let anchor = *self.mind.anchor.get_or_insert(self.position.0);
        if around.apart_m(anchor, self.position.0) > GETS_ON_M {
            self.mind.anchor = Some(self.position.0);
            self.mind.stuck_s = 0.0;
            return;
        }
        self.mind.stuck_s += STEP_S;
        if self.mind.stuck_s < STUCK_AFTER_S {
            return;
        }
        self.mind.stuck_s = 0.0;
        self.mind.anchor = None;
        if let Some(step) = self.mind.steps.last() {
            let heading = way(around.strategy(), self.position.0, *step).heading;
            let before = ahead(around.strategy(), self.position.0, heading, BLOCKED_AHEAD_M);
            self.mind.blocked.push((before, BLOCKED_S));
        }
        self.mind.planned_s = f64::INFINITY;
        self.find_no_way();
    }

    /// Turns towards what it looks at, or goes to.
    fn face(&mut self, around: &Around<'_>) {
        let looked_at = self.mind.face.map(|place| {
            let detour = around.detour(self.position.0, place);
            detour.map_or(place, |detour| {
                detour.beyond.moved(DVec3::Y * around.tuning.eye_height_m())
            })
        });
        let (heading, rise) = if let Some(place) = looked_at {
            let there = way(around.strategy(), self.position.0, place);
            let eyes_m = self.position.0.pos.y + around.tuning.eye_height_m();
            let rise = (place.pos.y - eyes_m).atan2(there.level_m.max(0.5));
            (there.heading, rise)
        } else {
            let velocity = self.body.0.velocity.with_y(0.0);
            let goes = velocity.length() > 0.3;
            (if goes { velocity } else { DVec3::ZERO }, 0.0)
        };
        let most = TURNS_RAD_S * STEP_S;
        if heading != DVec3::ZERO {
            let off = wrap_angle(heading.z.atan2(heading.x) - self.look.yaw);
            self.look.yaw = wrap_angle(self.look.yaw + off.clamp(-most, most));
        }
        self.look.pitch += (rise - self.look.pitch).clamp(-most, most);
    }

    /// Moves the body through the world, and the clips with it.
    pub fn advance(&mut self, around: &Around<'_>, input: &CharacterInput) {
        let strategy = around.strategy();
        let doing = Doing {
            holds: self.appearance.held.is_some(),
            sits: self.mind.state == State::Sit
                && self.mind.seat.is_none_or(|seat| seat.is_taken()),
            perches: self.mind.seat.is_some(),
            ..player::doing(self.look, self.body)
        };
        self.appearance.motion.pass(&doing, STEP_S);
        if self.sits(around) {
            return;
        }
        let before = self.position.0;
        self.settle(around, input);
        self.bear_fall(around);
        if door::pass(around.world, before, self.position, self.look, self.body).is_some() {
            // What was planned leads from where it was.
            self.mind.steps.clear();
            self.mind.anchor = None;
            self.mind.planned_s = f64::INFINITY;
        }
        player::cross(strategy, self.position, self.look, self.body);
    }

    /// Falls hurt it as they hurt the player, but for the one it came by: who sets a figure down need not know the ground.
    fn bear_fall(&mut self, around: &Around<'_>) {
        let body = &self.body.0;
        if !self.mind.has_landed {
            self.mind.has_landed = body.grounded;
            return;
        }
        let damage = fall_damage(body.hardest_m_s(), around.tuning.gravity_m_s2);
        if damage > 0.0 && self.health.0 > 0.0 {
            self.health.0 = (self.health.0 - damage).max(0.0);
            self.bot.hit_s_ago = 0.0;
            self.appearance.motion.strike();
        }
    }

    /// Whether its middle is in rock, as when ground was built over it.
    fn is_buried(&self, around: &Around<'_>) -> bool {
        let middle_m = 0.5 * around.tuning.height_m;
        let middle = self.position.0.moved(DVec3::Y * middle_m);
        around.world.ground.is_solid(middle)
    }

    /// Lets the body stand, go or fall where the ground is there.
    pub fn settle(&mut self, around: &Around<'_>, input: &CharacterInput) {
        let world = around.world;
        if !world.is_firm_around(self.position.0, NEEDED_AROUND_M) {
            // It waits, and what ended its last move does not end another one.
            (self.body.0.impact_m_s, self.body.0.scrape_m_s) = (0.0, 0.0);
            return;
        }
        let chart = self.position.0.chart;
        self.body.0.feet = self.position.0.pos;
        let physics = world.physics.for_bodies(around.strategy(), chart);
        if self.is_buried(around) {
            let ground = &world.ground;
            let solid = |at: DVec3| ground.is_solid(ChartPoint::new(chart, at));
            physics.lift_out_sized(&mut self.body.0, around.tuning, &solid);
        }
        let turn_rad = physics.move_character(&mut self.body.0, around.tuning, input, STEP_S);
        self.position.0.pos = self.body.0.feet;
        self.look.follow(turn_rad);
    }
}
