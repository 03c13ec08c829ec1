//! Chooses where a new world begins: on high ground, with far land, a car and a figure in the first picture.
//!
//! Places about the middle are tried, the highest first. Of each the land around is surveyed along rays from the eye,
//! and the view is taken that shows most of it far off, with a car and a figure on free ground between. In a closed
//! world one looks away from the middle of the hemisphere or towards it: on these lines alone who keeps his heading
//! walks along a great circle, and comes home.

#[cfg(test)]
mod tests;

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use antipode_geometry::{ChartId, ChartPoint, Eye, Projection, Strategy};
use antipode_terrain::Field;
use glam::{DVec2, DVec3};

use crate::lens::Lens;
use crate::npc::way_to;
use crate::player::{self, Look, Position};
use crate::spawn::standing_at;
use crate::tuning::{FOV_Y_RAD, NEAR_M};

/// Widest that places are looked for about the middle, in metres, and as a share of the way to the equator.
const SEARCH: (f64, f64) = (96.0, 0.4);
/// Rings of places, and places on each.
const RINGS: (u32, u32) = (8, 16);
/// How many of the highest places are looked at closely before the best of them is taken, and how many where none of
/// these has room for a car and somebody: a world is being waited for.
const VIEWS: usize = 8;
const MOST_VIEWS: usize = 24;
/// What a car or somebody in a view is worth, in metres of far land: more than all land.
const THING_WORTH_M: f64 = 1000.0;
/// The ground about a foot may rise so much, in metres.
const STEEPEST_M: f64 = 0.6;
/// Headings that are tried in an open world.
const HEADINGS: u32 = 8;
/// Bearings of the rays to either side, and the angle between two.
const RAYS: i32 = 5;
const RAY_RAD: f64 = 5.0 * PI / 180.0;
/// Where the land is surveyed along a ray, in metres from the eye.
const SURVEY_M: [f64; 13] = [
    3.0, 6.0, 8.0, 10.0, 12.0, 14.0, 17.0, 20.0, 25.0, 32.0, 48.0, 72.0, 100.0,
];
/// From here on land is far, in metres, and so much of it over what is nearer is enough on a ray, in radians.
const FAR_M: f64 = 32.0;
const ENOUGH_RAD: f64 = 4.0 * PI / 180.0;
/// Of these, where a figure and where a car can be made out.
const FIGURE_AT: std::ops::Range<usize> = 1..5;
const CAR_AT: std::ops::Range<usize> = 2..7;
/// Where in the picture things are to be, in halves of its width and height: the display is at its edges, and what is in
/// hand covers what lies to the right of and below a place.
const WITHIN: DVec2 = DVec2::new(0.8, 0.7);
const HAND: DVec2 = DVec2::new(0.1, -0.05);
const ASPECT: f64 = 16.0 / 9.0;
/// Bearings between car and figure, at least, in rays.
const APART_RAYS: i32 = 2;
/// Elevation of the view in a closed world, for the land overhead, in degrees; in an open one, below the land's edge.
const CLOSED_DEG: [f64; 1] = [15.0];
const OPEN_DEG: [f64; 4] = [-4.0, -9.0, -14.0, -20.0];
/// Half of the rectangle that a car stands on, in metres, how far its ground may rise, and what is to be seen of it over
/// the ground.
const CAR_M: DVec2 = DVec2::new(1.9, 0.9);
const CAR_RISE_M: f64 = 0.7;
const CAR_SEEN_M: f64 = 1.0;
/// What is to be seen of a figure over the ground, in metres.
const FIGURE_SEEN_M: f64 = 0.9;
/// Steps of a line of sight, in metres.
const SIGHT_STEP_M: f64 = 0.4;

/// A beginning.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Start {
    pub feet: ChartPoint,
    pub look: Look,
    /// Where a car stands, and its heading in radians.
    pub car: Option<(ChartPoint, f64)>,
    /// Where somebody stands, who looks at the player.
    pub figure: Option<(ChartPoint, f64)>,
}

/// What a search needs to know.
struct Search<'a> {
    field: &'a Field,
    lens: &'a Lens,
    eye_height_m: f64,
    fov_y_rad: f64,
}

/// A place of the survey.
#[derive(Clone, Copy)]
struct Spot {
    ray: i32,
    ring: usize,
    ground: ChartPoint,
}

/// Where a new world begins with a view, seen through that lens by the usual field of view.
pub(crate) fn with_a_view(field: &Field, lens: &Lens, eye_height_m: f64) -> Option<Start> {
    let search = Search {
        field,
        lens,
        eye_height_m,
        fov_y_rad: FOV_Y_RAD,
    };
    search.best()
}

impl Search<'_> {
    fn strategy(&self) -> &dyn Strategy {
        &**self.lens.world()
    }

    fn ground(&self, point: ChartPoint) -> ChartPoint {
        let point = self.strategy().cross(point).map_or(point, |it| it.point);
        let (x, z) = (point.pos.x, point.pos.z);
        let y = self.field.surface_height(point.chart, x, z);
        ChartPoint::new(point.chart, point.pos.with_y(y))
    }

    /// How far the ground about a place spreads in height, in metres.
    fn spread_m(&self, at: ChartPoint, half: DVec2, yaw: f64) -> f64 {
        let (sin, cos) = yaw.sin_cos();
        let corners = [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)].map(|(a, b)| {
            let (x, z) = (a * half.x, b * half.y);
            let by = DVec3::new(x * cos - z * sin, 0.0, x * sin + z * cos);
            self.ground(at.moved(by)).pos.y
        });
        let high = corners.into_iter().fold(at.pos.y, f64::max);
        high - corners.into_iter().fold(at.pos.y, f64::min)
    }

    /// The best beginning: with a car and somebody where that can be had.
    fn best(&self) -> Option<Start> {
        let mut best: Option<(f64, Start)> = None;
        for (seen, (feet, headings)) in self.places().into_iter().enumerate() {
            let whole = best.is_some_and(|(_, it)| it.car.is_some() && it.figure.is_some());
            if seen >= VIEWS && whole {
                break;
            }
            for heading in headings {
                let most_m = best.map_or(0.0, |(worth_m, _)| worth_m);
                best = self.view(feet, heading, most_m).or(best);
            }
        }
        best.map(|(_, start)| start)
    }

    /// Places to stand on, the highest first, and the headings to look in.
    fn places(&self) -> Vec<(ChartPoint, Vec<f64>)> {
        let edge_m = self.strategy().domain(ChartId::FIRST).half_width_m();
        let reach_m = (SEARCH.1 * edge_m).min(SEARCH.0);
        let mut places = Vec::new();
        for ring in 0..=RINGS.0 {
            let turns = if ring == 0 { 1 } else { RINGS.1 };
            for turn in 0..turns {
                let angle = TAU * f64::from(turn) / f64::from(turns);
                let away_m = reach_m * f64::from(ring) / f64::from(RINGS.0);
                let (x, z) = (away_m * angle.cos(), away_m * angle.sin());
                let feet = standing_at(self.field, x, z);
                if self.spread_m(self.ground(feet), DVec2::splat(0.7), 0.0) > STEEPEST_M {
                    continue;
                }
                let headings = if self.strategy().globe().is_some() && ring > 0 {
                    vec![angle, player::wrap_angle(angle + PI)]
                } else {
                    let all = 0..HEADINGS;
                    all.map(|it| player::wrap_angle(TAU * f64::from(it) / f64::from(HEADINGS)))
                        .collect()
                };
                places.push((feet, headings));
            }
        }
        places.sort_by(|(a, _), (b, _)| b.pos.y.total_cmp(&a.pos.y));
        places.truncate(MOST_VIEWS);
        places
    }

    fn eye(&self, feet: ChartPoint, look: Look) -> Eye {
        player::eye(&Position(feet), &look, self.lens.value(), self.eye_height_m)
    }

    /// What a view is worth, in metres, and what is to be seen in it: if it is worth more than so much.
    fn view(&self, feet: ChartPoint, yaw: f64, most_m: f64) -> Option<(f64, Start)> {
        let level = self.eye(feet, Look { yaw, pitch: 0.0 });
        let spots = self.survey(feet, yaw);
        let (far_m, edge_rad) = self.far_land(&level, &spots);
        let closed = self.strategy().globe().is_some();
        let pitches = if closed { &CLOSED_DEG[..] } else { &OPEN_DEG };
        let edge_rad = if closed { 0.0 } else { edge_rad.min(0.0) };
        let mut best = None;
        let mut most_m = most_m;
        for pitch in pitches.iter().map(|it| edge_rad + it.to_radians()) {
            if far_m + 2.0 * THING_WORTH_M <= most_m {
                break;
            }
            let look = Look { yaw, pitch };
            let eye = self.eye(feet, look);
            let figure = self.figure(&eye, feet, &spots);
            let car = self.car(&eye, yaw, &spots, figure.map(|(spot, _)| spot.ray));
            let things = u8::from(car.is_some()) + u8::from(figure.is_some());
            let worth_m = far_m + THING_WORTH_M * f64::from(things);
            if worth_m > most_m {
                most_m = worth_m;
                let figure = figure.map(|(spot, yaw)| (spot.ground.moved(DVec3::Y * 0.15), yaw));
                let start = Start {
                    feet,
                    look,
                    car,
                    figure,
                };
                best = Some((worth_m, start));
            }
        }
        best
    }

    /// The ground along rays ahead.
    fn survey(&self, feet: ChartPoint, yaw: f64) -> Vec<Spot> {
        let mut spots = Vec::new();
        for ray in -RAYS..=RAYS {
            let bearing = yaw + f64::from(ray) * RAY_RAD;
            let way = DVec3::new(bearing.cos(), 0.0, bearing.sin());
            for (ring, away_m) in SURVEY_M.into_iter().enumerate() {
                let ground =
                    self.ground(crate::npc::place_ahead(self.strategy(), feet, way, away_m));
                spots.push(Spot { ray, ring, ground });
            }
        }
        spots
    }

    /// What the far land of a view is worth: how far off land is seen over what is nearer, in metres as a mean of all
    /// rays, and as much again where enough of it is seen. And how high the highest land stands, as an angle from the
    /// level.
    fn far_land(&self, level: &Eye, spots: &[Spot]) -> (f64, f64) {
        let mut worth = 0.0;
        let mut edge_rad = -FRAC_PI_2;
        for ray in -RAYS..=RAYS {
            let (mut most_m, mut near_rad, mut highest_rad) = (0.0, -FRAC_PI_2, -FRAC_PI_2);
            for spot in spots.iter().filter(|spot| spot.ray == ray) {
                let view = self.lens.strategy().view_point(level, spot.ground);
                let rise_rad = view.y.atan2(view.x.hypot(view.z));
                if rise_rad > highest_rad {
                    (most_m, highest_rad) = (SURVEY_M[spot.ring], rise_rad);
                }
                if SURVEY_M[spot.ring] < FAR_M {
                    near_rad = highest_rad;
                }
            }
            let enough = ((highest_rad - near_rad) / ENOUGH_RAD).min(1.0);
            worth += most_m * (1.0 + enough);
            edge_rad = edge_rad.max(highest_rad);
        }
        (worth / f64::from(2 * RAYS + 1), edge_rad)
    }

    /// Somebody who is seen, and the way he looks at the player.
    fn figure(&self, eye: &Eye, feet: ChartPoint, spots: &[Spot]) -> Option<(Spot, f64)> {
        let fits = |spot: &&Spot| {
            FIGURE_AT.contains(&spot.ring)
                && spot.ray != 0
                && self.spread_m(spot.ground, DVec2::splat(0.5), 0.0) < STEEPEST_M
                && self.is_seen(eye, spot.ground, FIGURE_SEEN_M)
                && self.is_seen(eye, spot.ground, 2.0 * FIGURE_SEEN_M)
        };
        let spot = spots.iter().find(fits)?;
        let back = way_to(self.strategy(), spot.ground, feet);
        Some((*spot, back.z.atan2(back.x)))
    }

    /// A car that is seen from its side.
    fn car(
        &self,
        eye: &Eye,
        yaw: f64,
        spots: &[Spot],
        figure: Option<i32>,
    ) -> Option<(ChartPoint, f64)> {
        let heading = player::wrap_angle(yaw + 0.3 * PI);
        let fits = |spot: &&Spot| {
            CAR_AT.contains(&spot.ring)
                && figure.is_none_or(|ray| (ray - spot.ray).abs() >= APART_RAYS)
                && self.is_seen(eye, spot.ground, CAR_SEEN_M)
                && self.spread_m(spot.ground, CAR_M, heading) < CAR_RISE_M
        };
        let spot = spots.iter().rev().find(fits)?;
        Some((spot.ground, heading))
    }

    /// Whether a place so far over the ground is in the picture, and no ground before it.
    fn is_seen(&self, eye: &Eye, ground: ChartPoint, over_m: f64) -> bool {
        let strategy = &**self.lens.strategy();
        let place = ground.moved(DVec3::Y * over_m);
        let view = strategy.view_point(eye, place);
        let projection = Projection::new(self.fov_y_rad, ASPECT, NEAR_M);
        let x = projection.sx * view.x / -view.z;
        let y = projection.sy * view.y / -view.z;
        if view.z >= 0.0 || x.abs() > WITHIN.x || y.abs() > WITHIN.y {
            return false;
        }
        if x > HAND.x && y < HAND.y {
            return false;
        }
        let away_m = strategy.eye_distance_m(eye, view);
        let direction = view.truncate().normalize_or_zero();
        let steps = (away_m / SIGHT_STEP_M).ceil() as u32;
        (1..steps).all(|step| {
            let at = strategy.along(eye, direction, f64::from(step) * SIGHT_STEP_M);
            self.field.sample(at) > 0.0
        })
    }
}
