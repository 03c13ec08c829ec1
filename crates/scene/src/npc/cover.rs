//! Cover in a fight: who was hit or is aimed at by a shot goes behind a trunk or a large stone near by, hides there for some
//! seconds, looks out to shoot by turns, and fights on.

use antipode_geometry::ChartPoint;
use glam::DVec3;

use super::bearing::way;
use super::choice::at_pace;
use super::figure::Npc;
use super::mind::{Known, State};
use super::navigation::WalkableGround;
use super::senses::Around;
use super::tuning::{
    CHASE_PACE, COVER_M, COVERS_AGAIN_S, COVERS_FOR_S, HIDES_S, LOOKS_OUT_S, UNDER_FIRE_S,
};
use crate::felling::solids_near;
use crate::pick::over;

/// What one hides behind is at least so stout and so high, metres.
const STOUT_M: f64 = 0.19;
const HIGH_M: f64 = 1.5;
/// A thing that is as near to a root is that one, metres.
const SAME_M: f64 = 0.01;
/// How far behind it one hides, from its middle at least and besides its radius, so that ways lead there, metres.
const BEHIND_M: (f64, f64) = (0.95, 0.6);
/// How far to the side one looks out, besides its radius, metres.
const ASIDE_M: f64 = 0.75;
/// Nearer to the foe than this nothing is cover, metres.
const FOE_M: f64 = 5.0;
/// Others are not so near to where one hides, metres.
const OTHERS_M: f64 = 1.5;
/// What is looked at closely, of all that is near: a search is not free.
const MOST_TRIED: usize = 3;
/// Nearer to its place than this one goes there straight, metres.
const STRAIGHT_M: f64 = 1.2;
/// How fast one runs there, by which it is told when one is there, m/s.
const RUNS_M_S: f64 = 3.5;
/// What is hidden is the middle of a body, as a share of its height.
const MIDDLE: f64 = 0.5;
/// A shot is meant for who is within this of where the player looks, radians; it is looked for again after so long, seconds.
const AIMED_RAD: f64 = 0.2;
const AGAIN_S: f64 = 1.5;

/// What is hidden behind.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Cover {
    /// Its root and its radius, metres.
    root: ChartPoint,
    radius_m: f64,
    /// When one is there and when one has hidden enough, in seconds since one set out.
    from_s: f64,
    until_s: f64,
}

impl Cover {
    /// The place behind it as seen from a foe, so far to a side, metres.
    fn place(&self, around: &Around<'_>, foe: ChartPoint, aside_m: f64) -> ChartPoint {
        let away = -way(around.strategy(), self.root, foe).heading;
        let (least_m, more_m) = BEHIND_M;
        let side = DVec3::new(-away.z, 0.0, away.x);
        let by = away * least_m.max(self.radius_m + more_m) + side * aside_m;
        let place = self.root.moved(by);
        around.strategy().cross(place).map_or(place, |it| it.point)
    }
}

impl Npc<'_> {
    /// A shot was heard: one who fights and stands where the player looks takes it for his own.
    pub(super) fn mind_shot(&mut self, around: &Around<'_>) {
        let Some(quarry) = around.quarry.as_ref().filter(|_| self.fights()) else {
            return;
        };
        let there = way(around.strategy(), quarry.feet, self.position.0).heading;
        if there.dot(quarry.head.front().with_y(0.0).normalize_or_zero()) > AIMED_RAD.cos() {
            self.mind.under_fire_s = UNDER_FIRE_S;
        }
    }

    /// Goes into cover, or stays there; whether it does.
    pub(super) fn covers(&mut self, around: &Around<'_>, known: Known) -> bool {
        if self.mind.state != State::Cover {
            let wants = self.mind.under_fire_s > 0.0 && self.mind.covers_again_s <= 0.0;
            let cover = if wants {
                self.cover(around, known)
            } else {
                None
            };
            let Some(cover) = cover else { return false };
            self.mind.enter(State::Cover);
            self.mind.cover = Some(cover);
        }
        let cover = self.mind.cover.filter(|cover| {
            let is_gone = self.knows_things(around)
                && solids_near(around.world, cover.root, SAME_M)
                    .iter()
                    .all(|it| it.solid_m().is_none_or(|(_, high_m)| high_m < HIGH_M));
            let is_close = around.apart_m(self.position.0, known.feet) < FOE_M;
            self.mind.since_s < cover.until_s && !is_close && !is_gone
        });
        let Some(cover) = cover else {
            self.mind.cover = None;
            self.mind.covers_again_s = COVERS_AGAIN_S;
            return false;
        };
        self.hide_behind(around, cover, known);
        true
    }

    /// Hides and looks out by turns, always on the far side from where the foe is known to be.
    fn hide_behind(&mut self, around: &Around<'_>, cover: Cover, known: Known) {
        let hidden_s = self.mind.since_s - cover.from_s;
        let looks_out = hidden_s.rem_euclid(HIDES_S + LOOKS_OUT_S) > HIDES_S && hidden_s > 0.0;
        let aside_m = if looks_out {
            self.mind.side * (cover.radius_m + ASIDE_M)
        } else {
            0.0
        };
        let spot = cover.place(around, known.feet, aside_m);
        let there = over(around.strategy(), self.position.0, spot).pos - self.position.0.pos;
        if there.with_y(0.0).length() > STRAIGHT_M {
            self.mind.follow(at_pace(spot, CHASE_PACE));
        } else {
            self.mind.halt();
        }
        self.mind.spot = Some(spot);
    }

    /// The nearest thing that hides from the foe, and that there is a way behind.
    fn cover(&mut self, around: &Around<'_>, known: Known) -> Option<Cover> {
        let world = around.world;
        if !world.setup.generator.has_things() || !self.knows_things(around) {
            return None;
        }
        self.mind.covers_again_s = AGAIN_S;
        let lasts_s = self.mind.dice.between(COVERS_FOR_S);
        let solids = solids_near(world, self.position.0, COVER_M);
        let stout = solids.iter().filter_map(|it| {
            let (radius_m, height_m) = it.solid_m()?;
            (radius_m >= STOUT_M && height_m >= HIGH_M).then_some((it.root(), radius_m))
        });
        let known_as = |(root, radius_m): (ChartPoint, f64)| {
            let cover = Cover {
                root,
                radius_m,
                from_s: 0.0,
                until_s: lasts_s,
            };
            let place = cover.place(around, known.feet, 0.0);
            let away_m = around.apart_m(self.position.0, place);
            let is_free = self
                .others(around)
                .all(|it| around.apart_m(it.point, place) > OTHERS_M);
            let foe_m = around.apart_m(known.feet, place);
            (is_free && foe_m > FOE_M.max(away_m)).then_some((away_m, cover, place))
        };
        let mut all: Vec<_> = stout.filter_map(known_as).collect();
        all.sort_by(|(a, ..), (b, ..)| a.total_cmp(b));
        let near = all.into_iter().take(MOST_TRIED);
        let mut hiding = near.filter(|(_, _, place)| self.is_hidden_way(around, known, *place));
        let (away_m, cover, _) = hiding.next()?;
        let from_s = away_m / RUNS_M_S;
        Some(Cover {
            from_s,
            until_s: from_s + lasts_s,
            ..cover
        })
    }

    /// Whether the foe does not see the middle of who stands at a place, and a way leads there.
    fn is_hidden_way(&self, around: &Around<'_>, known: Known, place: ChartPoint) -> bool {
        let blocked = self.no_way(around);
        let land = WalkableGround {
            strategy: around.strategy(),
            ground: &around.world.ground,
            blocked: &blocked,
        };
        let Some(stand) = land.stand(place) else {
            return false;
        };
        let middle = stand.moved(DVec3::Y * (MIDDLE * around.tuning.height_m));
        if around.sees_place(known.feet, middle) {
            return false;
        }
        let route = land.route(self.position.0, stand);
        route.is_some_and(|route| route.reaches)
    }
}
