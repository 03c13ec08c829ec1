//! Sitting on stones and stumps, by day and now and then: which are fit, and how one sits down and gets up.
//!
//! The clip has its feet on the ground and its seat at one height. So a side of the stone is looked for at which the stone is
//! as high over the ground as that: on a slope a low stone is sat on from below and a high one from above. Who sits is held by
//! the seat, partly within what is solid of the stone, and walks again from where he stood before it.

use antipode_geometry::ChartPoint;
use antipode_plants::{Species, top_m};
use antipode_terrain::Thing;
use glam::{DVec2, DVec3, Vec2};

use super::bearing::{any_heading, toward};
use super::choice::at_pace;
use super::figure::Npc;
use super::mind::{Goal, Sits, State};
use super::navigation::{ASKS_M, WalkableGround};
use super::senses::Around;
use super::tuning::{DAYLIGHT_S, SEATS_M, SITS_AGAIN_S, SITS_FOR_S, SITS_SHARE, STROLL_PACE};
use crate::day::local_time_s;
use crate::felling::{Standing, solids_near};
use crate::pick::over;
use crate::tuning::STEP_S;

/// How high the seat of the clip is over its feet, and how much higher or lower the stone may be, metres.
const SEAT_HIGH_M: f64 = 0.43;
const SEAT_OFF_M: f64 = 0.05;
/// How far from the middle of the stone the seat of the clip comes to lie, its own place, and its feet, metres.
const SEAT_OUT_M: f64 = 0.17;
const SITS_OUT_M: f64 = 0.42;
const FEET_OUT_M: f64 = 0.62;
/// How far about its middle a seat is borne, metres: its height is the mean of what bears it.
const SEAT_WIDE_M: f64 = 0.1;
/// How far from the middle of the stone one stands before sitting down, clear of what is solid, and sets out for, metres.
const STANDS_OUT_M: f64 = 0.85;
const COMES_OUT_M: f64 = 1.45;
/// How near to that one comes by steps, metres.
const COMES_WITHIN_M: f64 = 0.5;
/// Sides of a stone that are tried.
const SIDES: u32 = 16;
/// The ground before a stone may rise and fall by so much, where one stands and where one comes from, metres.
const UNEVEN_M: f64 = 0.12;
const FAR_UNEVEN_M: f64 = 0.5;
/// No other thing is so near to the place before it besides its own radius, and nobody else sits so near, metres.
const ROOM_M: f64 = 0.5;
const OTHERS_M: f64 = 2.0;
/// So near to where one stands before it, metres, and so well turned from it, radians, one sits down.
const THERE_M: f64 = 0.1;
const TURNED_RAD: f64 = 0.15;
/// How long it takes to sit down or get up, and in how long one has to have begun, seconds.
const SITS_DOWN_S: f64 = 0.6;
const BEGINS_S: f64 = 6.0;
/// Who sits looks so far ahead, metres.
const LOOKS_M: f64 = 5.0;
/// Nearer than this to where it was its stone is there, metres.
const SAME_M: f64 = 0.01;

/// A place on a stone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Seat {
    /// The root of the stone.
    stone: ChartPoint,
    /// Where one stands before it, on the ground.
    stand: ChartPoint,
    /// Where a figure is that sits, its feet at the height of the ground before it; in the same chart.
    sit: DVec3,
    /// The way that one who sits looks, a level unit vector of that chart.
    out: DVec3,
    /// How far one has sat down, from 0 to 1.
    down: f64,
}

impl Seat {
    /// Where one is who has sat down as far as that.
    fn place(&self) -> ChartPoint {
        let share = self.down * self.down * (3.0 - 2.0 * self.down);
        ChartPoint::new(self.stand.chart, self.stand.pos.lerp(self.sit, share))
    }

    /// Whether it bears somebody.
    pub fn is_taken(&self) -> bool {
        self.down > 0.0
    }

    /// Where one who is there stands when he has got up.
    pub fn left(&self, there: ChartPoint) -> ChartPoint {
        if self.is_taken() { self.stand } else { there }
    }
}

impl Npc<'_> {
    /// A seat near by, for who feels like it. Nothing is asked of the dice where there is none.
    pub(super) fn stone(&mut self, around: &Around<'_>) -> Option<Goal> {
        let is_due = self.mind.sits_again_s <= 0.0 && self.is_day(around);
        if !is_due || !around.world.setup.generator.has_things() {
            return None;
        }
        let solids = solids_near(around.world, self.position.0, ASKS_M);
        let seat = self.nearest_seat(around, &solids)?;
        if self.mind.dice.unit() > SITS_SHARE {
            return None;
        }
        let out_m = seat.out * (COMES_OUT_M - STANDS_OUT_M);
        let before = seat.stand.moved(out_m);
        let before = around
            .strategy()
            .cross(before)
            .map_or(before, |it| it.point);
        Some(Goal {
            within_m: COMES_WITHIN_M,
            sits: Some(Sits::Stone(seat)),
            ..at_pace(before, STROLL_PACE)
        })
    }

    /// Whether all land is there on which something may stand that is asked for: else it is waited for, so that choices do
    /// not depend on how fast it comes.
    pub(super) fn knows_things(&self, around: &Around<'_>) -> bool {
        let world = around.world;
        !world.setup.generator.has_things() || world.is_firm_around(self.position.0, ASKS_M)
    }

    fn is_day(&self, around: &Around<'_>) -> bool {
        let time_s = around.world.time_of_day_s;
        let local_s = local_time_s(time_s, around.strategy(), self.position.0);
        local_s.is_none_or(|local_s| (DAYLIGHT_S.0..DAYLIGHT_S.1).contains(&local_s))
    }

    fn nearest_seat(&self, around: &Around<'_>, solids: &[Standing]) -> Option<Seat> {
        let near = |it: &&Standing| around.apart_m(self.position.0, it.root()) < SEATS_M;
        let is_low = |it: &&Standing| {
            matches!(
                it.species,
                Species::Boulder | Species::Stump | Species::Stalk
            )
        };
        let is_free = |it: &&Standing| self.is_free(around, it.root());
        let low = solids.iter().filter(is_low).filter(near).filter(is_free);
        let mut low: Vec<_> = low
            .map(|it| (around.apart_m(self.position.0, it.root()), it))
            .collect();
        low.sort_by(|(a, _), (b, _)| a.total_cmp(b));
        low.into_iter()
            .find_map(|(_, it)| self.side(around, it, solids))
    }

    /// Whether nobody else is at a stone.
    fn is_free(&self, around: &Around<'_>, stone: ChartPoint) -> bool {
        self.others(around)
            .all(|other| around.apart_m(other.point, stone) > OTHERS_M)
    }

    /// The side of a stone on which it is as high as a seat: of those the first by the clock from the way to the figure.
    fn side(&self, around: &Around<'_>, it: &Standing, solids: &[Standing]) -> Option<Seat> {
        let root = it.root();
        let (_, height_m) = it.solid_m()?;
        if height_m > SEAT_HIGH_M + UNEVEN_M + SEAT_OFF_M {
            return None;
        }
        let first = any_heading(around.strategy(), root.chart, 0.0);
        let ways = (0..SIDES)
            .map(|n| toward(first + f64::from(n) * std::f64::consts::TAU / f64::from(SIDES)));
        let own = over(around.strategy(), root, self.position.0).pos - root.pos;
        let mut ways: Vec<_> = ways.collect();
        ways.sort_by(|a, b| b.dot(own).total_cmp(&a.dot(own)));
        let is_free = |stand: ChartPoint| {
            solids
                .iter()
                .filter(|other| other.root() != root)
                .all(|other| {
                    let (radius_m, _) = other.solid_m().unwrap_or_default();
                    around.apart_m(stand, other.root()) > radius_m + ROOM_M
                })
        };
        let seats = ways
            .into_iter()
            .filter_map(|out| seat(around, root, &it.thing, out));
        seats.into_iter().find(|seat| is_free(seat.stand))
    }

    /// Goes to where it sits down.
    pub(super) fn take_seat(&mut self, seat: Seat, eye_height_m: f64) {
        self.mind.enter(State::Sit);
        self.mind.lasts_s = self.mind.dice.between(SITS_FOR_S);
        self.mind.spot = Some(seat.stand);
        self.mind.face = Some(
            seat.stand
                .moved(seat.out * LOOKS_M + DVec3::Y * eye_height_m),
        );
        self.mind.seat = Some(seat);
    }

    /// Whether it goes on sitting on its stone.
    pub(super) fn keeps_seat(&self, around: &Around<'_>, seat: &Seat) -> bool {
        let comes =
            !seat.is_taken() && self.mind.since_s < BEGINS_S && self.is_free(around, seat.stone);
        let stays = seat.is_taken() && self.mind.since_s < self.mind.lasts_s;
        let is_there = || {
            if !self.knows_things(around) {
                return true;
            }
            let at = solids_near(around.world, seat.stone, SAME_M);
            at.iter().any(|it| it.species >= Species::Stump)
        };
        // Who sits may have the ground dug away from under his feet.
        let is_firm = || {
            around
                .world
                .ground
                .is_solid(seat.stand.moved(DVec3::NEG_Y * 0.3))
        };
        (comes || stays) && is_there() && is_firm()
    }

    /// Sits down, stays and gets up by a step; whether the seat holds the body.
    pub(super) fn sits(&mut self, around: &Around<'_>) -> bool {
        let Some(mut seat) = self.mind.seat else {
            return false;
        };
        let stays = self.mind.state == State::Sit;
        if !seat.is_taken() && (!stays || !self.is_before(around, &mut seat)) {
            self.mind.seat = stays.then_some(seat);
            return false;
        }
        let by = STEP_S / SITS_DOWN_S;
        seat.down = (seat.down + if stays { by } else { -by }).clamp(0.0, 1.0);
        self.position.0 = seat.place();
        let body = &mut self.body.0;
        (body.feet, body.velocity, body.grounded) = (self.position.0.pos, DVec3::ZERO, true);
        (body.impact_m_s, body.scrape_m_s) = (0.0, 0.0);
        self.mind.sits_again_s = SITS_AGAIN_S;
        self.mind.seat = Some(seat).filter(Seat::is_taken);
        self.mind.planned_s = f64::INFINITY;
        true
    }

    /// Whether it stands before its seat and is turned from it. The seat is moved to the chart and the height that it has.
    fn is_before(&self, around: &Around<'_>, seat: &mut Seat) -> bool {
        let feet = self.position.0;
        let [stand, stone] =
            [seat.stand, seat.stone].map(|it| over(around.strategy(), feet, it).pos);
        let out = (stand - stone).with_y(0.0).normalize_or(seat.out);
        let off = stand - feet.pos;
        let is_there = off.with_y(0.0).length() < THERE_M && off.y.abs() < SEAT_OFF_M + UNEVEN_M;
        if !is_there || out.dot(self.look.heading()) < TURNED_RAD.cos() {
            return false;
        }
        let y = seat.sit.y - off.y;
        *seat = Seat {
            stand: feet,
            sit: (stone + out * SITS_OUT_M).with_y(y),
            out,
            ..*seat
        };
        true
    }
}

/// The seat on a side of a stone, if the stone is as high there over the ground before it as the clip sits.
fn seat(around: &Around<'_>, root: ChartPoint, thing: &Thing, out: DVec3) -> Option<Seat> {
    let land = WalkableGround {
        strategy: around.strategy(),
        ground: &around.world.ground,
        blocked: &[],
    };
    let at = |out_m: f64| land.stand(root.moved(out * out_m));
    let [feet, stand, before] = [FEET_OUT_M, STANDS_OUT_M, COMES_OUT_M].map(at);
    let ground_m = feet?.pos.y;
    let stand = stand?;
    let [near_m, far_m] = [stand, before?].map(|it| (it.pos.y - ground_m).abs());
    if near_m > UNEVEN_M || far_m > FAR_UNEVEN_M {
        return None;
    }
    let seat = DVec2::new(out.x, out.z) * SEAT_OUT_M;
    let across = DVec2::new(-out.z, out.x) * SEAT_WIDE_M;
    let along = seat.normalize_or_zero() * SEAT_WIDE_M;
    let borne = [
        seat,
        seat + across,
        seat - across,
        seat + along,
        seat - along,
    ];
    let mut sum_m = 0.0;
    for at in borne {
        sum_m += f64::from(top_m(thing, Vec2::new(at.x as f32, at.y as f32))?);
    }
    let high_m = root.pos.y + sum_m / borne.len() as f64 - ground_m;
    let stone = over(around.strategy(), stand, root).pos;
    let out = (stand.pos - stone).with_y(0.0).normalize_or(out);
    ((high_m - SEAT_HIGH_M).abs() < SEAT_OFF_M).then_some(Seat {
        stone: root,
        stand,
        sit: (stone + out * SITS_OUT_M).with_y(ground_m),
        out,
        down: 0.0,
    })
}
