//! Chooses what a figure does. It avoids cars first; then come fear, fighting and peaceful life, in that order.

use antipode_geometry::ChartPoint;
use glam::DVec3;

use super::bearing::{ahead, any_heading, toward, way};
use super::figure::Npc;
use super::mind::{Goal, Known, Sits, State};
use super::senses::{Around, Event, Quarry};
use super::tuning::{
    ANGRY_S, ASIDE_M, CHASE_PACE, DUSK_S, FIGHT_PACE, FLEE_PACE, FLEES_AT_HEALTH, FLEES_BY_M,
    FLEES_S, GIVES_UP_S, HEARS_SHOTS_M, KEEPS_M, KEEPS_SIGHT_M, KEEPS_SLACK_M, LAMP_M, NOTICES_M,
    SCARED_S, SEES_FRIENDS_M, SITS_M, STROLL_PACE, UNDER_FIRE_S, WALKS_M, WATCHES_M, WATCHES_S,
};
use crate::day::local_time_s;
use crate::fixture::Fixture;

/// How near to a goal is there, in metres.
const THERE_M: f64 = 0.8;
/// Slower than this, in m/s, a player does not come along.
const COMES_M_S: f64 = 1.0;
/// How long someone steps aside, in seconds, and how far, in metres.
const ASIDE_S: f64 = 1.2;
const ASIDE_BY_M: f64 = 2.0;
/// How far one goes round the player in a fight, in metres, and how often, in seconds.
const ROUND_M: f64 = 3.0;
const ROUND_EVERY_S: f64 = 3.0;
/// How far from another one stops to meet it, in metres.
const MEETS_M: f64 = 1.8;
/// Headings tried for a place with a view.
const VIEWS: u32 = 5;
/// The golden angle, in radians: it spreads those who sit around a lamp.
const GOLDEN_RAD: f64 = 2.399_963;

impl Npc<'_> {
    /// Whether it fights the player.
    pub fn fights(&self) -> bool {
        self.bot.hostile || self.mind.angry_s > 0.0
    }

    /// Takes in what has happened in the step before.
    pub fn notice(&mut self, around: &Around<'_>) {
        for event in around.events {
            match *event {
                Event::Shot(at) if around.felt_m(self.position.0, at) < HEARS_SHOTS_M => {
                    self.hear_shot(at);
                    self.mind_shot(around);
                }
                Event::Hit {
                    victim,
                    at,
                    by_player,
                } => self.notice_hit(around, victim == self.entity, at, by_player),
                Event::Scare(at, radius_m) => {
                    if !self.fights() && around.felt_m(self.position.0, at) < radius_m {
                        self.mind.fear = Some((at, SCARED_S));
                    }
                }
                Event::Shot(_) | Event::Ground(_) => {}
            }
        }
    }

    fn hear_shot(&mut self, at: ChartPoint) {
        if !self.fights() {
            if matches!(self.mind.state, State::Idle | State::Wander) {
                self.mind.enter(State::Watch);
                self.mind.face = Some(at);
                self.mind.lasts_s = WATCHES_S[0];
            }
        } else if self.mind.known.is_none_or(|known| known.ago_s > 0.5) {
            self.mind.known = Some(Known {
                feet: at,
                ago_s: 0.5,
            });
        }
    }

    /// A figure gets angry when the player hits it, or a friend that it sees. It runs away when anybody else hits it.
    fn notice_hit(&mut self, around: &Around<'_>, own: bool, at: ChartPoint, by_player: bool) {
        if !by_player {
            if own && !self.fights() {
                self.mind.fear = Some((at, SCARED_S));
            }
            return;
        }
        let Some(quarry) = &around.quarry else { return };
        if own {
            self.mind.under_fire_s = UNDER_FIRE_S;
        }
        let angers = own
            || around.apart_m(self.position.0, at) < SEES_FRIENDS_M
                && around.sees_place(self.position.0, at.moved(DVec3::Y));
        if !angers {
            return;
        }
        if !self.bot.hostile {
            self.mind.angry_s = ANGRY_S;
        }
        // A bullet tells where it came from.
        self.mind.known = Some(Known {
            feet: quarry.feet,
            ago_s: 0.0,
        });
    }

    /// Looks for the player, where that is someone to fight.
    pub fn perceive(&mut self, around: &Around<'_>) {
        let fights = self.fights();
        let Some(quarry) = around.quarry.as_ref().filter(|_| fights) else {
            self.mind.known = None;
            return;
        };
        let away_m = around.felt_m(self.position.0, quarry.feet);
        let alert = self.mind.state.is_combat() || self.mind.known.is_some();
        let far_m = if alert { KEEPS_SIGHT_M } else { NOTICES_M };
        let seen = away_m < far_m
            && (alert || around.is_before(self.position.0, self.look, quarry.feet))
            && around.sees_player(quarry, self.position.0);
        if seen {
            self.mind.known = Some(Known {
                feet: quarry.feet,
                ago_s: 0.0,
            });
        } else if self
            .mind
            .known
            .is_some_and(|known| known.ago_s > GIVES_UP_S)
        {
            self.mind.known = None;
        }
    }

    /// Chooses what to do.
    pub fn choose(&mut self, around: &Around<'_>) {
        if self.dodges(around) {
            return;
        }
        if let Some(from) = self.feared() {
            self.flee(around, from);
        } else if let (Some(known), Some(quarry)) = (self.mind.known, &around.quarry) {
            self.fight(around, known, quarry);
        } else {
            if self.mind.state.is_combat() || self.mind.state == State::Flee {
                self.mind.rest();
            }
            self.live_in_peace(around);
        }
    }

    /// What it runs from: a scare, or with little health whom it fights.
    fn feared(&self) -> Option<ChartPoint> {
        let weak = self.health.0 <= FLEES_AT_HEALTH && self.bot.hit_s_ago < FLEES_S;
        let foe = self.mind.known.map(|known| known.feet);
        self.mind
            .fear
            .map(|(from, _)| from)
            .or(foe.filter(|_| weak))
    }

    fn flee(&mut self, around: &Around<'_>, from: ChartPoint) {
        self.mind.enter(State::Flee);
        self.mind.face = None;
        if self.mind.goal.is_some() && self.mind.planned_s < 1.5 {
            return;
        }
        let away = -way(around.strategy(), self.position.0, from).heading;
        // Straight away at first; who finds no way so tries more and more to a side.
        let turn = 0.6 * f64::from(self.mind.stuck) * self.mind.side;
        let heading = glam::DQuat::from_rotation_y(turn) * away;
        let point = ahead(around.strategy(), self.position.0, heading, FLEES_BY_M);
        self.mind.go(at_pace(point, FLEE_PACE));
    }

    fn fight(&mut self, around: &Around<'_>, known: Known, quarry: &Quarry) {
        self.mind.face = Some(known.feet.moved(DVec3::Y * around.tuning.eye_height_m()));
        if self.covers(around, known) {
            return;
        }
        if known.ago_s > 0.3 {
            self.search(around, known);
            return;
        }
        let away_m = around.apart_m(self.position.0, quarry.feet);
        let (near_m, far_m) = KEEPS_M;
        let chases = self.mind.state == State::Chase;
        let far_m = if chases { far_m - KEEPS_SLACK_M } else { far_m };
        if away_m > far_m {
            self.mind.enter(State::Chase);
            self.mind.follow(Goal {
                point: quarry.feet,
                within_m: near_m + KEEPS_SLACK_M,
                pace: CHASE_PACE,
                sits: None,
            });
            return;
        }
        self.mind.enter(State::Fight);
        let toward = way(around.strategy(), self.position.0, quarry.feet).heading;
        if away_m < near_m {
            let point = ahead(
                around.strategy(),
                self.position.0,
                -toward,
                near_m - away_m + 2.0,
            );
            self.mind.follow(at_pace(point, CHASE_PACE));
        } else if self.mind.goal.is_none() && self.mind.since_s > ROUND_EVERY_S {
            self.mind.since_s = 0.0;
            if self.mind.dice.unit() < 0.3 {
                self.mind.side = -self.mind.side;
            }
            let aside = DVec3::new(-toward.z, 0.0, toward.x) * self.mind.side;
            let point = ahead(around.strategy(), self.position.0, aside, ROUND_M);
            self.mind.go(at_pace(point, FIGHT_PACE));
        }
    }

    /// Goes where the player was last known to be, and looks around there.
    fn search(&mut self, around: &Around<'_>, known: Known) {
        self.mind.enter(State::Search);
        if around.apart_m(self.position.0, known.feet) > 2.0 {
            self.mind.follow(Goal {
                point: known.feet,
                within_m: 1.5,
                pace: CHASE_PACE,
                sits: None,
            });
            return;
        }
        let angle = f64::from((self.mind.since_s / 1.2) as u32) * GOLDEN_RAD;
        let looks = self.toward(around, angle) * 4.0 + DVec3::Y * 1.6;
        self.mind.face = Some(self.position.0.moved(looks));
    }

    fn live_in_peace(&mut self, around: &Around<'_>) {
        if self.minds_player(around) {
            return;
        }
        let dusk = self.is_dusk(around);
        let over = self.mind.since_s > self.mind.lasts_s;
        match self.mind.state {
            State::Sit if self.mind.seat.is_some() => {
                let seat = self.mind.seat.filter(|seat| self.keeps_seat(around, seat));
                if seat.is_none() {
                    self.mind.rest();
                }
            }
            State::Sit => {
                let stands = self
                    .mind
                    .face
                    .and_then(|glow| nearest_lamp(around, glow))
                    .is_some_and(|(_, away_m)| away_m < 1.0);
                if !dusk || !stands {
                    self.mind.rest();
                }
            }
            State::Aside if self.mind.since_s < ASIDE_S && self.mind.goal.is_some() => {}
            State::Wander if self.mind.goal.is_some() => {
                let sits = self.mind.goal.and_then(|goal| goal.sits);
                if matches!(sits, Some(Sits::Lamp(_))) && !dusk {
                    self.mind.rest();
                }
            }
            State::Idle | State::Watch if !over => {}
            State::Idle => self.set_out(around, dusk),
            _ => self.mind.rest(),
        }
    }

    /// Whether it is dusk where the figure is.
    fn is_dusk(&self, around: &Around<'_>) -> bool {
        let time_s = around.world.time_of_day_s;
        local_time_s(time_s, around.strategy(), self.position.0)
            .is_some_and(|local_s| (DUSK_S.0..DUSK_S.1).contains(&local_s))
    }

    /// Makes room for a player who comes close, and looks at him. A figure that fights does not.
    fn minds_player(&mut self, around: &Around<'_>) -> bool {
        let Some(quarry) = around.quarry.as_ref().filter(|_| !self.fights()) else {
            return false;
        };
        let there = way(around.strategy(), quarry.feet, self.position.0);
        let away_m = around.apart_m(self.position.0, quarry.feet);
        let comes_m_s = quarry.velocity.dot(there.heading);
        let is_in_the_way = self.mind.state != State::Aside && self.mind.seat.is_none();
        if away_m < ASIDE_M && comes_m_s > COMES_M_S && is_in_the_way {
            let back = way(around.strategy(), self.position.0, quarry.feet).heading;
            let side = DVec3::new(-back.z, 0.0, back.x) * self.mind.side;
            let heading = (side - back * 0.3).normalize_or(side);
            let point = ahead(around.strategy(), self.position.0, heading, ASIDE_BY_M);
            self.mind.enter(State::Aside);
            self.mind.face = Some(quarry.head.point);
            self.mind.go(at_pace(point, FIGHT_PACE));
            return true;
        }
        let rests = matches!(self.mind.state, State::Idle | State::Wander);
        if rests
            && self.mind.bored_s <= 0.0
            && away_m < WATCHES_M
            && around.is_before(self.position.0, self.look, quarry.feet)
            && around.sees_player(quarry, self.position.0)
        {
            self.mind.watch(quarry.head.point);
            return true;
        }
        if self.mind.state == State::Watch && away_m < WATCHES_M {
            // The eyes follow the one that it looks at.
            self.mind.face = Some(quarry.head.point);
        }
        false
    }

    /// Chooses where to go next: at dusk to a lamp, by day perhaps to a stone, else to a view, to somebody, or for a stroll.
    fn set_out(&mut self, around: &Around<'_>, dusk: bool) {
        if !self.knows_things(around) {
            return;
        }
        if let Some(stone) = self.stone(around) {
            self.mind.enter(State::Wander);
            self.mind.face = None;
            self.mind.go(stone);
            return;
        }
        let seat = if dusk { self.seat(around) } else { None };
        let roll = self.mind.dice.unit();
        let beyond = self.beyond_a_door(around);
        let goal = match seat {
            Some((lamp, seat)) => Goal {
                sits: Some(Sits::Lamp(lamp)),
                ..strolling(seat)
            },
            None if beyond.is_some() => strolling(beyond.unwrap_or(self.position.0)),
            None if roll < 0.35 => strolling(self.viewpoint(around)),
            None if roll < 0.6 => self.company(around).unwrap_or_else(|| {
                let point = self.somewhere(around);
                strolling(point)
            }),
            None => {
                let point = self.somewhere(around);
                strolling(point)
            }
        };
        self.mind.enter(State::Wander);
        self.mind.face = None;
        self.mind.go(goal);
    }

    /// The way of a heading that comes from no place.
    fn toward(&self, around: &Around<'_>, yaw_rad: f64) -> DVec3 {
        let chart = self.position.0.chart;
        toward(any_heading(around.strategy(), chart, yaw_rad))
    }

    fn somewhere(&mut self, around: &Around<'_>) -> ChartPoint {
        let thrown = self.mind.dice.heading();
        let heading = self.toward(around, thrown);
        let far_m = self.mind.dice.between(WALKS_M);
        ahead(around.strategy(), self.position.0, heading, far_m)
    }

    /// The highest of some places around.
    fn viewpoint(&mut self, around: &Around<'_>) -> ChartPoint {
        let ground = &around.world.ground;
        let first = self.mind.dice.heading();
        let far_m = self.mind.dice.between(WALKS_M);
        let mut best = (f64::NEG_INFINITY, self.position.0);
        for index in 0..VIEWS {
            let turn = f64::from(index) * std::f64::consts::TAU / f64::from(VIEWS);
            let heading = self.toward(around, first + turn);
            let point = ahead(around.strategy(), self.position.0, heading, far_m);
            let height_m = ground.untouched_height(point);
            if height_m > best.0 {
                best = (height_m, point);
            }
        }
        best.1
    }

    /// The nearest other one in peace.
    fn company(&self, around: &Around<'_>) -> Option<Goal> {
        self.others(around)
            .filter(|other| !other.fights && !self.fights())
            .map(|other| (around.felt_m(self.position.0, other.point), other.point))
            .filter(|(away_m, _)| (2.0 * MEETS_M..LAMP_M).contains(away_m))
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .map(|(_, point)| Goal {
                within_m: MEETS_M,
                ..strolling(point)
            })
    }

    /// The nearest lamp's glass, and a seat by it of this one's own.
    fn seat(&self, around: &Around<'_>) -> Option<(ChartPoint, ChartPoint)> {
        let (lamp, _) =
            nearest_lamp(around, self.position.0).filter(|(_, away_m)| *away_m < LAMP_M)?;
        let turn = f64::from(self.bot.id) * GOLDEN_RAD;
        let heading = toward(any_heading(around.strategy(), lamp.foot.point.chart, turn));
        let seat = ahead(around.strategy(), lamp.foot.point, heading, SITS_M);
        Some((lamp.glow(), seat))
    }
}

fn strolling(point: ChartPoint) -> Goal {
    at_pace(point, STROLL_PACE)
}

/// A place to go to at a pace.
pub(super) fn at_pace(point: ChartPoint, pace: f64) -> Goal {
    Goal {
        point,
        within_m: THERE_M,
        pace,
        sits: None,
    }
}

/// The lamp nearest to a place, and how far it is.
fn nearest_lamp<'a>(around: &Around<'a>, place: ChartPoint) -> Option<(&'a Fixture, f64)> {
    let lamps = around.lamps.iter();
    lamps
        .map(|lamp| (lamp, around.apart_m(place, lamp.foot.point)))
        .min_by(|a, b| a.1.total_cmp(&b.1))
}
