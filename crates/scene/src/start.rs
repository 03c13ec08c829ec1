//! Chooses where a new world begins: on high ground, with far land, a car and a figure in the first picture.
//!
//! Many places about the middle are tried over the land as it is between columns some metres apart: a place is the better,
//! the more far land is seen over the near along rays from it, and the higher it lies over the land about it. Height alone
//! would not do: hyperbolic land falls away from the top of a wide hill, which hides what is beyond. Of the best the land
//! ahead is surveyed closely, and the view is taken that is worth most, with a car and a figure on free ground between. In a
//! closed world one looks away from the middle of the hemisphere or towards it: on these lines alone who keeps his heading
//! walks along a great circle, and comes home.

mod heights;
mod obstacles;
mod places;
#[cfg(test)]
mod tests;
mod things;

use std::f64::consts::{FRAC_PI_2, PI};

use antipode_geometry::{ChartPoint, Eye, Strategy};
use antipode_terrain::Field;
use glam::{DVec2, DVec3};

use self::places::{Place, far_land};
use crate::lens::Lens;
use crate::player::{self, Look, Position};
use crate::tuning::FOV_Y_RAD;

/// How many of the best places are looked at closely before the best view of them is taken, if it has a car and somebody.
const VIEWS: usize = 8;
/// What a car or somebody in a view is worth, in metres of far land: more than all land.
const THING_WORTH_M: f64 = 1000.0;
/// What far land behind what grows close by is worth less, as a share: one steps aside.
const HIDDEN_WORTH: f64 = 0.1;
/// The ground about a foot may rise so much, in metres.
const STEEPEST_M: f64 = 0.6;
/// Bearings of the rays to either side, and the angle between two.
const RAYS: i32 = 5;
const RAY_RAD: f64 = 5.0 * PI / 180.0;
/// Where the land is surveyed along a ray, in metres from the eye.
const SURVEY_M: [f64; 14] = [
    3.0, 6.0, 8.0, 10.0, 12.0, 14.0, 17.0, 20.0, 25.0, 32.0, 48.0, 72.0, 100.0, 140.0,
];
/// Elevation of the view in a closed world, for the land overhead, in degrees; in an open one, below the land's edge.
const CLOSED_DEG: [f64; 1] = [15.0];
const OPEN_DEG: [f64; 4] = [-4.0, -9.0, -14.0, -20.0];

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
        let y = heights::ground_m(self.field, point.chart, x, z);
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
        for (seen, place) in self.places().into_iter().enumerate() {
            let whole = best.is_some_and(|(_, it)| it.car.is_some() && it.figure.is_some());
            if seen >= VIEWS && whole {
                break;
            }
            for heading in &place.headings {
                let most_m = best.map_or(f64::NEG_INFINITY, |(worth_m, _)| worth_m);
                best = self.view(&place, *heading, most_m).or(best);
            }
        }
        best.map(|(_, start)| start)
    }

    fn eye(&self, feet: ChartPoint, look: Look) -> Eye {
        player::eye(&Position(feet), &look, self.lens.value(), self.eye_height_m)
    }

    /// What a view is worth, in metres, and what is to be seen in it: if it is worth more than so much.
    fn view(&self, place: &Place, yaw: f64, most_m: f64) -> Option<(f64, Start)> {
        let feet = place.feet;
        let level = self.eye(feet, Look { yaw, pitch: 0.0 });
        let spots = self.survey(feet, yaw);
        let (far_m, edge_rad) = self.far_land(&level, &spots);
        let obstacles = self.obstacles(feet);
        let hidden = 1.0 - obstacles.open_share(yaw);
        let land_m = far_m * (1.0 - HIDDEN_WORTH * hidden) + place.rise_worth_m;
        let closed = self.strategy().globe().is_some();
        let pitches = if closed { &CLOSED_DEG[..] } else { &OPEN_DEG };
        let edge_rad = if closed { 0.0 } else { edge_rad.min(0.0) };
        let mut best = None;
        let mut most_m = most_m;
        for pitch in pitches.iter().map(|it| edge_rad + it.to_radians()) {
            if land_m + 2.0 * THING_WORTH_M <= most_m {
                break;
            }
            let look = Look { yaw, pitch };
            let eye = self.eye(feet, look);
            let figure = self.figure(&eye, feet, &spots, &obstacles);
            let car = self.car(
                &eye,
                yaw,
                &spots,
                &obstacles,
                figure.map(|(spot, _)| spot.ray),
            );
            let things = u8::from(car.is_some()) + u8::from(figure.is_some());
            let worth_m = land_m + THING_WORTH_M * f64::from(things);
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

    /// What the far land of a view is worth, in metres as a mean of all rays, and how high the highest land stands, as an
    /// angle from the level.
    fn far_land(&self, level: &Eye, spots: &[Spot]) -> (f64, f64) {
        let (mut worth_m, mut edge_rad) = (0.0, -FRAC_PI_2);
        for ray in spots.as_chunks::<{ SURVEY_M.len() }>().0 {
            let (of_ray_m, highest_rad) = far_land(ray.map(|it| self.rise_rad(level, it.ground)));
            worth_m += of_ray_m;
            edge_rad = edge_rad.max(highest_rad);
        }
        (worth_m / f64::from(2 * RAYS + 1), edge_rad)
    }

    /// How high a place stands in the picture, as an angle from the level.
    fn rise_rad(&self, level: &Eye, place: ChartPoint) -> f64 {
        let view = self.lens.strategy().view_point(level, place);
        view.y.atan2(view.x.hypot(view.z))
    }
}
