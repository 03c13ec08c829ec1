//! What the first picture of a new world shows, seed by seed.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    reason = "tests fail by panicking"
)]

use antipode_geometry::{Geometry, strategy};
use antipode_physics::CharacterTuning;

use super::*;
use crate::tuning::FOV_Y_RAD;

const SEEDS: u64 = 50;

struct World {
    field: Field,
    lens: Lens,
}

impl World {
    fn new(geometry: Geometry, radius_m: f64, seed: u64) -> Self {
        Self {
            field: Field::new(seed, strategy(geometry, radius_m)),
            lens: Lens::new(geometry, radius_m),
        }
    }

    fn start(&self) -> Start {
        let search = Search {
            field: &self.field,
            lens: &self.lens,
            eye_height_m: CharacterTuning::default().eye_height_m(),
            fov_y_rad: FOV_Y_RAD,
        };
        search.best().expect("there is a place to stand on")
    }

    /// Where in the picture of a start a place over the ground is, in halves of its width and height, and how far off:
    /// if no ground lies before it on the geodesic.
    fn seen(&self, start: &Start, ground: ChartPoint, over_m: f64) -> Option<(DVec2, f64)> {
        let pictured = &**self.lens.strategy();
        let height_m = CharacterTuning::default().eye_height_m();
        let eye = player::eye(
            &Position(start.feet),
            &start.look,
            self.lens.value(),
            height_m,
        );
        let view = pictured.view_point(&eye, ground.moved(DVec3::Y * over_m));
        let projection = Projection::new(FOV_Y_RAD, ASPECT, NEAR_M);
        let clip = pictured.clip_from_view(&eye, &projection, view);
        let away_m = pictured.eye_distance_m(&eye, view);
        let direction = view.truncate().normalize();
        let free = (1..(away_m / 0.1) as u32).all(|step| {
            let at = pictured.along(&eye, direction, 0.1 * f64::from(step));
            self.field.sample(at) > 0.0
        });
        (clip.w > 0.0 && free).then(|| (DVec2::new(clip.x, clip.y) / clip.w, away_m))
    }
}

/// What is wrong with the first picture of a world, if anything.
fn lack(geometry: Geometry, radius_m: f64, seed: u64) -> Option<String> {
    let world = World::new(geometry, radius_m, seed);
    let start = world.start();
    let said = |words: &str| Some(format!("{geometry} {radius_m} m, seed {seed}: {words}"));
    let inside = |at: DVec2| at.x.abs() < 0.9 && at.y.abs() < 0.9;
    let Some((car, _)) = start.car else {
        return said("no car");
    };
    let Some((figure, _)) = start.figure else {
        return said("nobody");
    };
    for (what, ground, over_m, most_m) in [
        ("the car", car, 1.0, 30.0),
        ("the figure", figure, 1.2, 18.0),
    ] {
        match world.seen(&start, ground, over_m) {
            None => return said(&format!("{what} is hidden")),
            Some((at, _)) if !inside(at) => return said(&format!("{what} is at {at}")),
            Some((_, away_m)) if away_m > most_m => {
                return said(&format!("{what} is {away_m} m off"));
            }
            Some(_) => {}
        }
    }
    if geometry == Geometry::Spherical && start.look.pitch < 6.0_f64.to_radians() {
        return said("one does not look up");
    }
    None
}

#[test]
fn the_first_picture_of_fifty_seeds_of_each_space_has_a_car_and_somebody() {
    for (geometry, radius_m) in [
        (Geometry::Euclidean, f64::INFINITY),
        (Geometry::Hyperbolic, 20.0),
        (Geometry::Spherical, 100.0),
    ] {
        let lacks: Vec<_> = (0..SEEDS)
            .filter_map(|seed| lack(geometry, radius_m, seed))
            .collect();
        assert!(lacks.is_empty(), "{lacks:#?}");
    }
}

#[test]
fn a_new_world_begins_higher_than_the_land_about_is_and_the_same_each_time() {
    for geometry in Geometry::ALL {
        let mut higher = 0;
        for seed in 0..12 {
            let world = World::new(geometry, 100.0, seed);
            let start = world.start();
            assert_eq!(start, world.start());
            let ways = (0..16).map(|turn| TAU * f64::from(turn) / 16.0);
            let around = ways.map(|way| {
                let by = DVec3::new(way.cos(), 0.0, way.sin()) * 30.0;
                let at = world.field.strategy().cross(start.feet.moved(by));
                let at = at.map_or(start.feet.moved(by), |it| it.point);
                world
                    .field
                    .surface_height(at.hemisphere, at.pos.x, at.pos.z)
            });
            higher += u32::from(start.feet.pos.y > around.sum::<f64>() / 16.0);
        }
        assert!(higher >= 11, "{geometry}: {higher} of 12");
    }
}

#[test]
fn who_walks_straight_on_from_the_start_of_a_closed_world_comes_home() {
    for (seed, radius_m) in [(1, 100.0), (5, 100.0), (7, 32.0), (12, 256.0)] {
        let world = World::new(Geometry::Spherical, radius_m, seed);
        let start = world.start();
        let space = world.field.strategy();
        let (mut at, mut yaw) = (start.feet, start.look.yaw);
        let steps = 20_000;
        for _ in 0..steps {
            let by = TAU * radius_m / f64::from(steps);
            at = at.moved(DVec3::new(yaw.cos(), 0.0, yaw.sin()) * by);
            if let Some(crossing) = space.cross(at) {
                at = crossing.point;
                yaw -= crossing.turn_rad;
            }
        }
        assert_eq!(at.hemisphere, start.feet.hemisphere, "seed {seed}");
        let off_m = (at.pos - start.feet.pos).with_y(0.0).length();
        assert!(off_m < 0.1, "seed {seed}: {off_m} m from home");
    }
}
