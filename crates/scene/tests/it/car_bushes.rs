//! A car among what grows: a trunk stops it, a bush slows it and lets it through, and both bend what is about them.

use antipode_geometry::{BodyFrame, ChartId, ChartPoint, Crossing, Geometry, Strategy};
use antipode_plants::{Age, Species, placed_near};
use antipode_scene::{Actions, CarView, Generator, NpcMode, Scene, SoundEvent, WorldSetup};
use antipode_terrain::Cover;
use glam::DVec3;

use crate::common::cars::{ahead, car, enter, stand_beside, still};
use crate::common::{LIMIT, setup, steps};

/// From so far before a thing cars set out, and so far behind it the way is clear as well, metres.
const RUN_M: f64 = 16.0;
const PAST_M: f64 = 7.0;
/// As near to the way as this nothing else stands, metres.
const CLEAR_M: f64 = 3.2;

fn open(geometry: Geometry, generator: Generator) -> Scene {
    let radius_m = match geometry {
        Geometry::Euclidean | Geometry::Hyperbolic => 20.0,
        Geometry::Spherical => 64.0,
        Geometry::HyperbolicWorld => 120.61,
    };
    let setup = WorldSetup {
        generator,
        radius_m,
        seed: 7,
        ..setup(geometry)
    };
    let mut scene = Scene::open(setup, None).unwrap();
    scene.set_npcs(NpcMode::Off);
    assert!(scene.wait_for_step(LIMIT));
    scene
}

/// Where a thing stands, and a level heading to come from, radians.
#[derive(Clone, Copy, Debug)]
struct Aim {
    root: ChartPoint,
    yaw: f64,
}

impl Aim {
    fn way(&self) -> DVec3 {
        DVec3::new(self.yaw.cos(), 0.0, self.yaw.sin())
    }

    /// How far a car has come past the thing, metres as cars go; before it negative.
    fn past_m(&self, scene: &Scene, car: &CarView) -> f64 {
        self.off(&**scene.strategy(), car.point).dot(self.way())
    }

    /// Where a place is from the thing.
    fn off(&self, space: &dyn Strategy, point: ChartPoint) -> DVec3 {
        BodyFrame::way(space, self.root, point)
    }

    /// Where a car comes to that keeps straight on, so many metres past the thing, and the turn that its heading takes.
    fn on_the_way(&self, space: &dyn Strategy, past_m: f64) -> Crossing {
        BodyFrame::step(space, self.root, self.way() * past_m)
    }
}

/// The one of such things near the middle to which the most level way leads, among those past which nothing else stands.
fn clear_way(scene: &Scene, is_wanted: impl Fn(Species, Age) -> bool) -> Aim {
    let field = scene.field();
    let middle = ChartPoint::new(ChartId::FIRST, DVec3::ZERO);
    let rim_m = scene.strategy().domain(ChartId::FIRST).half_width_m();
    let within_m = (rim_m - RUN_M - 4.0).min(160.0);
    let all: Vec<_> = placed_near(field, middle, within_m + RUN_M).collect();
    let space = &**scene.strategy();
    let height = |at: ChartPoint| field.surface_height(at.chart, at.pos.x, at.pos.z);
    let mut best: Option<(f64, Aim)> = None;
    let wanted = all.iter().filter(|(root, species, age)| {
        is_wanted(*species, *age) && root.pos.with_y(0.0).length() < within_m
    });
    for (root, ..) in wanted {
        for turn in 0..16 {
            let yaw = std::f64::consts::TAU * f64::from(turn) / 16.0;
            let aim = Aim { root: *root, yaw };
            let is_clear = all.iter().filter(|(it, ..)| it != root).all(|(it, ..)| {
                let off = aim.off(space, *it).with_y(0.0);
                let along_m = off.dot(aim.way()).clamp(-RUN_M - 2.0, PAST_M);
                (off - aim.way() * along_m).length() > CLEAR_M
            });
            if !is_clear {
                continue;
            }
            let rise = |m: i32| {
                let at = aim.on_the_way(space, f64::from(m)).point;
                (height(at) - root.pos.y).abs()
            };
            let most_m = (-18..=9).map(rise).fold(0.0, f64::max);
            if best.is_none_or(|(least_m, _)| most_m < least_m) {
                best = Some((most_m, aim));
            }
        }
    }
    let (_, aim) = best.expect("a thing past which nothing else stands");
    aim
}

/// Has the player sit in a car that looks at a thing.
fn at_the_wheel(scene: &mut Scene, aim: Aim) {
    let start = aim.on_the_way(&**scene.strategy(), -RUN_M);
    let [x, _, z] = start.point.pos.to_array();
    let height_m = scene.field().surface_height(start.point.chart, x, z);
    let yaw = aim.yaw - start.turn_rad;
    let start = ChartPoint::new(start.point.chart, DVec3::new(x, height_m + 0.1, z));
    scene.teleport(start.moved(DVec3::new(0.0, 4.0, 0.0)));
    assert!(scene.wait_for_step(LIMIT));
    assert!(scene.spawn_car(start, yaw));
    steps(scene, 120, &still());
    stand_beside(scene, 2.2);
    steps(scene, 1, &enter());
    assert!(scene.is_driving(), "{:?}", scene.take_hints());
    scene.take_sounds();
}

/// Steps until the car has come so far, or for eight seconds.
fn drive_to(scene: &mut Scene, aim: &Aim, past_m: f64, wish: &Actions) {
    for _ in 0..480 {
        if aim.past_m(scene, &car(scene)) >= past_m {
            return;
        }
        steps(scene, 1, wish);
    }
}

#[test]
fn a_trunk_stops_a_car() {
    for geometry in Geometry::ALL {
        let mut scene = open(geometry, Generator::Planted);
        let is_stout = |species: Species, age: Age| {
            let stout = species.trunk(age).is_some_and(|it| it.radius_m > 0.15);
            species.is_tree() && age == Age::Grown && stout
        };
        let aim = clear_way(&scene, is_stout);
        at_the_wheel(&mut scene, aim);
        drive_to(&mut scene, &aim, 0.0, &ahead());
        let car = car(&scene);
        let past_m = aim.past_m(&scene, &car);
        assert!(
            (-4.0..-1.6).contains(&past_m) && car.velocity.length() < 0.5,
            "{geometry:?}: {past_m} m past it at {} m/s",
            car.velocity.length()
        );
    }
}

/// What became of a car that coasted through a bush, or over the same land without one.
struct Passed {
    before: CarView,
    after: CarView,
    past_m: f64,
    rustled: usize,
    leaves: usize,
}

fn pass(geometry: Geometry, generator: Generator, aim: Aim) -> Passed {
    let mut scene = open(geometry, generator);
    at_the_wheel(&mut scene, aim);
    drive_to(&mut scene, &aim, -3.5, &ahead());
    let before = car(&scene);
    let mut leaves = 0;
    for _ in 0..300 {
        if aim.past_m(&scene, &car(&scene)) >= 3.5 {
            break;
        }
        steps(&mut scene, 1, &still());
        leaves = leaves.max(scene.probe().particles.chips);
    }
    let is_rustle = |it: &SoundEvent| {
        matches!(
            it,
            SoundEvent::Step {
                cover: Cover::Grass,
                ..
            }
        )
    };
    let sounds = scene.take_sounds();
    let after = car(&scene);
    Passed {
        before,
        after,
        past_m: aim.past_m(&scene, &after),
        rustled: sounds.iter().filter(|it| is_rustle(it)).count(),
        leaves,
    }
}

#[test]
fn a_bush_slows_a_car_rustles_loses_leaves_and_lets_it_through() {
    for geometry in Geometry::ALL {
        let scene = open(geometry, Generator::Planted);
        let aim = clear_way(&scene, |species, age| {
            species == Species::Bush && age == Age::Grown
        });
        drop(scene);
        let with = pass(geometry, Generator::Planted, aim);
        let without = pass(geometry, Generator::Climates, aim);
        assert_eq!(with.before, without.before, "{geometry:?}: the same drive");
        let speed = |it: &Passed| it.after.velocity.length();
        let share = speed(&with) / speed(&without);
        assert!((0.55..0.93).contains(&share), "{geometry:?}: {share}");
        assert!(with.past_m >= 3.5, "{geometry:?}: it is through");
        assert!(
            (1..8).contains(&with.rustled),
            "{geometry:?}: {}",
            with.rustled
        );
        assert!(with.leaves > 3, "{geometry:?}: {}", with.leaves);
        assert_eq!((without.rustled, without.leaves), (0, 0), "{geometry:?}");
        let again = pass(geometry, Generator::Planted, aim);
        assert_eq!(again.after, with.after, "{geometry:?}: two runs are alike");
    }
}

#[test]
fn a_car_that_stands_in_a_bush_hears_nothing_of_it_and_is_not_moved() {
    let scene = open(Geometry::Euclidean, Generator::Planted);
    let aim = clear_way(&scene, |species, age| {
        species == Species::Bush && age == Age::Grown
    });
    let mut scene = scene;
    scene.teleport(aim.root.moved(DVec3::new(0.0, 4.0, 0.0)));
    assert!(scene.wait_for_step(LIMIT));
    assert!(scene.spawn_car(aim.root.moved(DVec3::Y * 0.1), aim.yaw));
    steps(&mut scene, 200, &still());
    let view = car(&scene);
    assert!(
        view.rests && view.point.pos.distance(aim.root.pos) < 1.0,
        "{view:?}"
    );
    assert!(!scene.take_sounds().iter().any(|it| matches!(
        it,
        SoundEvent::Step {
            cover: Cover::Grass,
            ..
        }
    )));
}

#[test]
fn grass_is_pressed_by_cars_and_by_the_feet_of_who_looks_and_of_who_is_seen() {
    for geometry in Geometry::ALL {
        let mut scene = open(geometry, Generator::Planted);
        let at = scene.feet();
        let id = scene.spawn_bot(at.moved(DVec3::new(3.0, 1.0, 0.0)), 0.0, false);
        assert!(scene.spawn_car(at.moved(DVec3::new(-6.0, 2.0, 0.0)), 0.4));
        steps(&mut scene, 120, &still());
        let frame = scene.frame(1.2, 1.7, 1);
        let is_there = |point: ChartPoint| {
            let near =
                |it: &ChartPoint| it.chart == point.chart && it.pos.distance(point.pos) < 0.4;
            let mut all = frame.content.pressers.iter();
            all.find(|it| near(&it.point)).copied()
        };
        let car = car(&scene);
        let (own, under) = (is_there(scene.feet()), is_there(car.point));
        let bot = crate::common::figures::bot(&scene, id);
        assert!(
            own.is_some() && is_there(bot.point).is_some(),
            "{geometry:?}"
        );
        let under = under.unwrap();
        assert_eq!(frame.content.pressers.len(), 3, "{geometry:?}");
        let along = under.along.normalize();
        assert!(
            along.dot(car.turn * DVec3::X) > 0.999,
            "{geometry:?}: {along}"
        );
        assert!(under.reach_m > own.unwrap().reach_m);
    }
}
