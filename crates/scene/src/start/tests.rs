//! What the first picture of a new world shows, seed by seed.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    reason = "tests fail by panicking"
)]

use std::f64::consts::TAU;

use antipode_geometry::{ChartId, Geometry, Projection, strategy};
use antipode_physics::CharacterTuning;
use antipode_plants::placed_near;
use antipode_terrain::Generator;

mod numbers;

use super::places::MOST_VIEWS;
use super::*;
use crate::tuning::{ASPECT, NEAR_M};

/// Seeds asked of each space and radius.
const SEEDS: u64 = 50;

struct World {
    field: Field,
    lens: Lens,
}

impl World {
    fn new(geometry: Geometry, radius_m: f64, seed: u64) -> Self {
        Self::made_by(Generator::default(), geometry, radius_m, seed)
    }

    fn made_by(generator: Generator, geometry: Geometry, radius_m: f64, seed: u64) -> Self {
        Self {
            field: Field::made_by(generator, seed, strategy(geometry, radius_m)),
            lens: Lens::new(strategy(geometry, radius_m)),
        }
    }

    fn search(&self) -> Search<'_> {
        Search {
            field: &self.field,
            lens: &self.lens,
            eye_height_m: CharacterTuning::default().eye_height_m(),
            fov_y_rad: FOV_Y_RAD,
        }
    }

    fn start(&self) -> Start {
        let best = self.search().best();
        best.expect("there is a place to stand on")
    }

    fn eye(&self, start: &Start) -> Eye {
        let height_m = CharacterTuning::default().eye_height_m();
        player::eye(
            &Position(start.feet),
            &start.look,
            self.lens.value(),
            height_m,
        )
    }

    /// Where in the picture of a start a place over the ground is, in halves of its width and height, and how far off:
    /// if no ground lies before it on the geodesic.
    fn seen(&self, start: &Start, ground: ChartPoint, over_m: f64) -> Option<(DVec2, f64)> {
        let pictured = &**self.lens.strategy();
        let eye = self.eye(start);
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

/// How much higher a start is than the land 30 m about it on average, in metres.
fn higher_m(world: &World, start: &Start) -> f64 {
    let ways = (0..16).map(|turn| TAU * f64::from(turn) / 16.0);
    let around = ways.map(|way| {
        let by = DVec3::new(way.cos(), 0.0, way.sin()) * 30.0;
        let at = world.field.strategy().cross(start.feet.moved(by));
        let at = at.map_or(start.feet.moved(by), |it| it.point);
        world.field.surface_height(at.chart, at.pos.x, at.pos.z)
    });
    start.feet.pos.y - around.sum::<f64>() / 16.0
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
            Some((at, _)) if at.x > 0.1 && at.y < -0.05 => {
                return said(&format!("{what} is behind what is in hand: {at}"));
            }
            Some((at, _)) if !inside(at) => return said(&format!("{what} is at {at}")),
            Some((_, away_m)) if away_m > most_m => {
                return said(&format!("{what} is {away_m} m off"));
            }
            Some(_) => {}
        }
    }
    if geometry == Geometry::Spherical && start.look.pitch < 14.9_f64.to_radians() {
        return said("one does not look up to the land overhead");
    }
    None
}

#[test]
fn the_first_picture_of_fifty_seeds_of_each_space_has_a_car_and_somebody() {
    for (geometry, radius_m) in [
        (Geometry::Euclidean, f64::INFINITY),
        (Geometry::Hyperbolic, 20.0),
        (Geometry::Spherical, 16.0),
        (Geometry::Spherical, 32.0),
        (Geometry::Spherical, 100.0),
        (Geometry::Spherical, 256.0),
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
            higher += u32::from(higher_m(&world, &start) > 0.0);
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
        assert_eq!(at.chart, start.feet.chart, "seed {seed}");
        let off_m = (at.pos - start.feet.pos).with_y(0.0).length();
        assert!(off_m < 0.1, "seed {seed}: {off_m} m from home");
    }
}

/// How far off the land is that a ray of the picture meets, by its place in halves of width and height.
fn met_m(world: &World, start: &Start, at: DVec2) -> Option<f64> {
    let pictured = &**world.lens.strategy();
    let eye = world.eye(start);
    let tall = (0.5 * FOV_Y_RAD).tan();
    let direction = DVec3::new(at.x * tall * ASPECT, at.y * tall, -1.0).normalize();
    let rim = world.field.strategy();
    let place = |away_m: f64| {
        let at = pictured.along(&eye, direction, away_m);
        rim.cross(at).map_or(at, |it| it.point)
    };
    // Once round a closed world at most.
    let farthest_m = world
        .field
        .strategy()
        .domain(ChartId::FIRST)
        .radius_m()
        .map_or(240.0, |rim_m| 4.0 * rim_m);
    let step_m = farthest_m / 400.0;
    (1..400)
        .map(|step| f64::from(step) * step_m)
        .find(|away_m| world.field.sample(place(*away_m)) < 0.0)
}

#[test]
fn the_first_picture_shows_far_land_and_in_closed_worlds_land_overhead() {
    let columns: [f64; 5] = [-0.8, -0.4, 0.0, 0.4, 0.8];
    let rows = [
        -0.6, -0.4, -0.2, -0.1, 0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8,
    ];
    // Hyperbolic land drops away on all sides: from most heights little of it is far.
    for (geometry, radius_m, median_m, most_m) in [
        (Geometry::Euclidean, f64::INFINITY, 60.0, 100.0),
        (Geometry::Hyperbolic, 20.0, 10.0, 25.0),
        (Geometry::Spherical, 16.0, 22.0, 25.0),
        (Geometry::Spherical, 32.0, 45.0, 50.0),
        (Geometry::Spherical, 100.0, 150.0, 150.0),
        (Geometry::Spherical, 256.0, 400.0, 400.0),
    ] {
        for seed in 0..SEEDS {
            let world = World::new(geometry, radius_m, seed);
            let start = world.start();
            let mut far_m = Vec::new();
            let mut above = 0;
            for x in columns {
                let met = rows.map(|y| met_m(&world, &start, DVec2::new(x, y)));
                far_m.push(met.iter().flatten().copied().fold(0.0, f64::max));
                above += met[5..].iter().flatten().count();
            }
            far_m.sort_by(f64::total_cmp);
            let said =
                format!("{geometry} {radius_m} m, seed {seed}: {far_m:.0?} m, {above} of 40");
            assert!(far_m[2] >= median_m && far_m[4] >= most_m, "{said}");
            assert!(geometry != Geometry::Spherical || above >= 36, "{said}");
        }
    }
}

/// Of eleven columns of the picture, how many show at least one hundredth and a half of its height of land that is 32
/// metres of the chart off or farther.
fn far_columns(world: &World, start: &Start) -> usize {
    let pictured = &**world.lens.strategy();
    let eye = world.eye(start);
    let tall = (0.5 * FOV_Y_RAD).tan();
    let shows_far = |x: f64, y: f64| {
        let direction = DVec3::new(x * tall * ASPECT, y * tall, -1.0).normalize();
        let mut away_m = 1.0_f64;
        while away_m < 160.0 {
            let at = pictured.along(&eye, direction, away_m);
            if world.field.sample(at) < 0.0 {
                return (at.pos - start.feet.pos).with_y(0.0).length() > 32.0;
            }
            away_m += (0.01 * away_m).max(0.3);
        }
        false
    };
    (-5..=5)
        .map(|column| 0.17 * f64::from(column))
        .filter(|x| (-16..=16).any(|row| shows_far(*x, 0.03 * f64::from(row))))
        .count()
}

#[test]
fn far_land_is_seen_over_the_near_in_hyperbolic_worlds_too() {
    let mut columns = Vec::new();
    for seed in 0..SEEDS {
        let world = World::new(Geometry::Hyperbolic, 20.0, seed);
        let seen = far_columns(&world, &world.start());
        assert!(seen >= 3, "seed {seed}: {seen} of 11 columns");
        columns.push(seen);
    }
    columns.sort_unstable();
    assert!(columns[columns.len() / 2] >= 7, "{columns:?}");
}

#[test]
fn a_search_that_finds_no_room_for_a_car_and_somebody_gives_up_soon() {
    for geometry in Geometry::ALL {
        let world = World::new(geometry, 100.0, 5);
        // Through a slit nothing is in the picture.
        let search = Search {
            fov_y_rad: 1e-9,
            ..world.search()
        };
        assert!(search.places().len() <= MOST_VIEWS);
        let start = search.best().expect("there is a place to stand on");
        assert!(start.car.is_none() && start.figure.is_none(), "{geometry}");
    }
}

/// How far from a straight way what is solid near its first end is at least, metres.
fn room_m(world: &World, from: ChartPoint, way: DVec3) -> f64 {
    let length_m = way.length();
    let ahead = way / length_m.max(1e-9);
    let found = placed_near(&world.field, from, length_m + 6.0);
    let rooms = found.filter_map(|(root, species, age)| {
        let at = (root.pos - from.pos).with_y(0.0);
        let nearest = ahead * at.dot(ahead).clamp(0.0, length_m);
        Some(at.distance(nearest) - species.trunk(age)?.radius_m)
    });
    rooms.fold(f64::INFINITY, f64::min)
}

#[test]
fn nothing_stands_in_the_way_of_who_begins_of_somebody_who_comes_and_of_the_car() {
    let (mut seen, mut drives) = (0, 0);
    for (geometry, radius_m) in [
        (Geometry::Euclidean, f64::INFINITY),
        (Geometry::Hyperbolic, 20.0),
        (Geometry::Spherical, 100.0),
    ] {
        for seed in 0..20 {
            let world = World::made_by(Generator::Planted, geometry, radius_m, seed);
            let start = world.start();
            let said = format!("{geometry}, seed {seed}");
            assert!(room_m(&world, start.feet, DVec3::ZERO) > 0.7, "{said}");
            let (Some((car, heading)), Some((figure, _))) = (start.car, start.figure) else {
                continue;
            };
            let to = |there: ChartPoint| (there.pos - start.feet.pos).with_y(0.0);
            if [car, figure].iter().any(|it| it.chart != start.feet.chart) {
                continue;
            }
            let comes_m = room_m(&world, start.feet, to(figure));
            assert!(comes_m > 0.35, "{said}: he passes a trunk by {comes_m} m");
            let stands_m = room_m(&world, car, DVec3::ZERO);
            assert!(stands_m > 2.9, "{said}: the car is {stands_m} m from one");
            let off = DVec3::new(heading.cos(), 0.0, heading.sin()) * 7.0;
            let off_m = [off, -off].map(|off| room_m(&world, car, off));
            seen += 1;
            drives += usize::from(off_m[0].max(off_m[1]) > 1.0);
        }
    }
    println!("{drives} of {seen} cars drive off straight");
    assert!(seen > 50 && drives == seen, "{drives} of {seen}");
}
