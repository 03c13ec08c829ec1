//! Where a view could be had from: places over the land about, and the headings in which most of it is far off.

use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::ops::RangeInclusive;

use antipode_geometry::{ChartId, ChartPoint, Eye};
use glam::{DVec2, DVec3};

use super::heights::Land;
use super::{STEEPEST_M, SURVEY_M, Search};
use crate::npc::place_ahead;
use crate::player::{Look, wrap_angle};
use crate::spawn::standing_at;

/// Widest that places are looked for about the middle, in metres, and as a share of the way to the edge of the chart: that to
/// an equator, past which land looks down on where one is, and any other.
const SEARCH: (f64, f64) = (96.0, 0.4);
const SEARCH_SQUARE: f64 = 0.9;
/// Rings of places, and places on each.
const RINGS: (u32, u32) = (8, 16);
/// The same farther out, where none of those has so much far land, in metres: an open world always has some.
const WIDE_RINGS: (u32, u32) = (16, 24);
const ENOUGH_M: f64 = 130.0;
/// How many of the best places are looked at closely at most: a world is being waited for.
pub(super) const MOST_VIEWS: usize = 24;
/// Rays round a place, of which those in a picture make a view, and how many of a view's are to either side of its middle.
const ROUND: i32 = 36;
const SIDE: i32 = 3;
const APART_RAD: f64 = TAU / ROUND as f64;
/// Of a place so many headings are tried, which are apart by so many rays.
const HEADINGS: usize = 3;
const APART_RAYS: i32 = 2;
/// How far from what grows one begins, metres.
const FEET_ROOM_M: f64 = 0.8;
/// From here on land is far, in metres, and so much of it over what is nearer is enough on a ray, in radians.
const FAR_M: f64 = 32.0;
const ENOUGH_RAD: f64 = 6.0 * PI / 180.0;
/// How far about a place the land is that it is to stand over, in metres and as a share of the way to the equator; and
/// what a metre over that is worth in metres of far land, up to so many.
const ABOUT: (f64, f64) = (30.0, 0.25);
const ABOUT_TURNS: u32 = 8;
const RISE_WORTH: f64 = 8.0;
const MOST_RISE_M: f64 = 4.0;

/// A place to stand on.
#[derive(Clone)]
pub(super) struct Place {
    pub feet: ChartPoint,
    /// What the far land of the best heading is worth, in metres.
    pub far_m: f64,
    /// What it is worth that it lies higher than the land about it, in metres of far land.
    pub rise_worth_m: f64,
    /// To look in, the best first.
    pub headings: Vec<f64>,
}

impl Place {
    fn worth_m(&self) -> f64 {
        self.far_m + self.rise_worth_m
    }
}

/// What is seen along rays from a place: what it is worth, and how high the highest land stands, as an angle from the level.
struct Rays<'a, 'b> {
    search: &'a Search<'b>,
    level: Eye,
    feet: ChartPoint,
    first_rad: f64,
    seen: [Option<(f64, f64)>; ROUND as usize],
}

impl Rays<'_, '_> {
    fn worth_m(&mut self, land: &mut Land<'_>, n: i32) -> f64 {
        let n = n.rem_euclid(ROUND);
        if let Some((worth_m, _)) = self.seen[n as usize] {
            return worth_m;
        }
        let bearing = self.first_rad + f64::from(n) * APART_RAD;
        let way = DVec3::new(bearing.cos(), 0.0, bearing.sin());
        let strategy = self.search.strategy();
        let rises = SURVEY_M.map(|away_m| {
            let at = place_ahead(strategy, self.feet, way, away_m);
            self.search.rise_rad(&self.level, land.ground(at))
        });
        let seen = far_land(rises);
        self.seen[n as usize] = Some(seen);
        seen.0
    }
}

impl Search<'_> {
    /// Places to stand on, the best first.
    pub(super) fn places(&self) -> Vec<Place> {
        let edge_m = self.strategy().domain(ChartId::FIRST).half_width_m();
        let mut land = Land::new(self.field);
        let mut places = self.surveyed(&mut land, edge_m, 0..=RINGS.0);
        let has_far_land = places.iter().any(|it| it.far_m >= ENOUGH_M);
        if !has_far_land && SEARCH.0 <= self.search_share() * edge_m {
            places.extend(self.surveyed(&mut land, edge_m, RINGS.0 + 1..=WIDE_RINGS.0));
        }
        places.sort_by(|a, b| b.worth_m().total_cmp(&a.worth_m()));
        let stood_on = places.into_iter().filter_map(|place| {
            let ChartPoint { pos, .. } = place.feet;
            let feet = standing_at(self.field, pos.x, pos.z);
            let is_level = self.spread_m(self.ground(feet), DVec2::splat(0.7), 0.0) <= STEEPEST_M;
            let is_free = self.obstacles(feet).leave(feet, FEET_ROOM_M);
            (is_level && is_free).then_some(Place { feet, ..place })
        });
        stood_on.take(MOST_VIEWS).collect()
    }

    /// How far places are looked for, as a share of the way to the edge of the chart.
    fn search_share(&self) -> f64 {
        match self.strategy().globe() {
            Some(_) => SEARCH.1,
            None => SEARCH_SQUARE,
        }
    }

    /// The places on rings about the middle.
    fn surveyed(&self, land: &mut Land<'_>, edge_m: f64, rings: RangeInclusive<u32>) -> Vec<Place> {
        let reach_m = (self.search_share() * edge_m).min(SEARCH.0);
        let about_m = (ABOUT.1 * edge_m).min(ABOUT.0);
        let mut places = Vec::new();
        for ring in rings {
            let turns = match ring {
                0 => 1,
                _ if ring <= RINGS.0 => RINGS.1,
                _ => WIDE_RINGS.1,
            };
            for turn in 0..turns {
                let angle = TAU * f64::from(turn) / f64::from(turns);
                let away_m = reach_m * f64::from(ring) / f64::from(RINGS.0);
                let by = DVec3::new(angle.cos(), 0.0, angle.sin()) * away_m;
                let feet = land.ground(ChartPoint::a(by));
                let rise_m = rise_m(land, feet, about_m);
                let on_line = (ring > 0 && self.strategy().globe().is_some()).then_some(angle);
                let (far_m, headings) = self.headings(land, feet, on_line);
                places.push(Place {
                    feet,
                    far_m,
                    rise_worth_m: RISE_WORTH * rise_m.min(MOST_RISE_M),
                    headings,
                });
            }
        }
        places
    }

    /// What the far land of the best heading at a place is worth, and which headings are the best: of those on a line to
    /// both sides, if there is one.
    fn headings(
        &self,
        land: &mut Land<'_>,
        feet: ChartPoint,
        line: Option<f64>,
    ) -> (f64, Vec<f64>) {
        let mut rays = Rays {
            search: self,
            level: self.eye(
                feet,
                Look {
                    yaw: 0.0,
                    pitch: 0.0,
                },
            ),
            feet,
            first_rad: line.unwrap_or_default(),
            seen: [None; ROUND as usize],
        };
        let step = if line.is_some() { ROUND / 2 } else { 1 };
        let mut views = Vec::new();
        for middle in (0..ROUND).step_by(step as usize) {
            let sum: f64 = (-SIDE..=SIDE).map(|n| rays.worth_m(land, middle + n)).sum();
            views.push((sum / f64::from(2 * SIDE + 1), middle));
        }
        views.sort_by(|(a, _), (b, _)| b.total_cmp(a));
        let far_m = views.first().map_or(0.0, |(far_m, _)| *far_m);
        let mut chosen: Vec<i32> = Vec::new();
        for (_, middle) in views {
            let is_apart = |it: &i32| {
                let by = (middle - it).rem_euclid(ROUND);
                by.min(ROUND - by) >= APART_RAYS
            };
            if chosen.len() < HEADINGS && chosen.iter().all(is_apart) {
                chosen.push(middle);
            }
        }
        let heading = |n: i32| wrap_angle(rays.first_rad + f64::from(n) * APART_RAD);
        (far_m, chosen.into_iter().map(heading).collect())
    }
}

/// How much higher a place is than the land about it on average, in metres.
fn rise_m(land: &mut Land<'_>, feet: ChartPoint, about_m: f64) -> f64 {
    let turns = (0..ABOUT_TURNS).map(|turn| TAU * f64::from(turn) / f64::from(ABOUT_TURNS));
    let heights = turns.map(|turn| {
        let by = DVec3::new(turn.cos(), 0.0, turn.sin()) * about_m;
        land.ground(feet.moved(by)).pos.y
    });
    feet.pos.y - heights.sum::<f64>() / f64::from(ABOUT_TURNS)
}

/// What the far land of a ray is worth: how far off land is seen over what is nearer, in metres, and as much again where
/// enough of it is seen. And how high the highest land stands.
pub(super) fn far_land(rises_rad: [f64; SURVEY_M.len()]) -> (f64, f64) {
    let (mut most_m, mut near_rad, mut highest_rad) = (0.0, -FRAC_PI_2, -FRAC_PI_2);
    for (away_m, rise_rad) in SURVEY_M.into_iter().zip(rises_rad) {
        if rise_rad > highest_rad {
            (most_m, highest_rad) = (away_m, rise_rad);
        }
        if away_m < FAR_M {
            near_rad = highest_rad;
        }
    }
    let enough = ((highest_rad - near_rad) / ENOUGH_RAD).min(1.0);
    (most_m * (1.0 + enough), highest_rad)
}
