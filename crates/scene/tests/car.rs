//! What a player notices of the car: getting in and out, driving, its wheels, its lights, and the equator.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "tests fail by panicking"
)]

mod common;

use antipode_geometry::{ChartPoint, Geometry, Hemisphere};
use antipode_scene::frame::ModelId;
use antipode_scene::{Actions, CarView, Hint, NpcMode, Scene, State};
use common::{LIMIT, scene, steps};
use glam::{DQuat, DVec3};

const GEOMETRIES: [Geometry; 3] = [
    Geometry::Euclidean,
    Geometry::Hyperbolic,
    Geometry::Spherical,
];

fn still() -> Actions {
    Actions::default()
}

fn ahead() -> Actions {
    Actions {
        forward: 1.0,
        ..still()
    }
}

fn enter() -> Actions {
    Actions {
        enter_car: true,
        ..still()
    }
}

/// A world with its first car, which has come to rest.
fn with_car(geometry: Geometry) -> Scene {
    let mut scene = scene(geometry);
    scene.give_first_car();
    steps(&mut scene, 150, &still());
    scene
}

fn car(scene: &Scene) -> CarView {
    scene.cars()[0]
}

/// Puts the player so many metres to the car's left, and looks at it.
fn stand_beside(scene: &mut Scene, far_m: f64) {
    let car = car(scene);
    let left = (car.turn * DVec3::NEG_Z).with_y(0.0).normalize();
    let at = car.point.moved(left * far_m + DVec3::Y * 0.3);
    scene.teleport(at);
    assert!(scene.wait_for_step(LIMIT));
    steps(scene, 60, &still());
    let feet = scene.feet();
    let way = car.point.pos - feet.pos;
    scene.aim(way.z.atan2(way.x), -0.2);
}

/// A player at the wheel of a car at rest.
fn driving(geometry: Geometry) -> Scene {
    let mut scene = with_car(geometry);
    stand_beside(&mut scene, 2.0);
    steps(&mut scene, 1, &enter());
    assert!(scene.is_driving(), "{geometry:?} {:?}", scene.take_hints());
    steps(&mut scene, 10, &still());
    scene
}

#[test]
fn a_new_world_has_one_car_near_the_start_on_its_wheels() {
    for geometry in GEOMETRIES {
        let mut scene = with_car(geometry);
        scene.give_first_car();
        assert_eq!(scene.cars().len(), 1);
        let car = car(&scene);
        let far = (car.point.pos - scene.feet().pos).with_y(0.0).length();
        assert!((5.0..16.0).contains(&far), "{geometry:?} {far}");
        assert!(car.wheels.iter().all(|wheel| wheel.contact), "{car:?}");
        assert!((car.turn * DVec3::Y).y > 0.7);
        assert!(scene.probe().car.is_some() && !scene.probe().player.in_car);
    }
}

#[test]
fn it_is_entered_within_four_metres_and_in_view_and_left_beside() {
    for geometry in GEOMETRIES {
        let mut scene = with_car(geometry);
        stand_beside(&mut scene, 2.2);
        let at = car(&scene).point.pos;
        let feet = scene.feet().pos;
        let yaw = (at.z - feet.z).atan2(at.x - feet.x);
        scene.aim(yaw + 3.0, 0.0);
        steps(&mut scene, 1, &enter());
        assert!(!scene.is_driving(), "{geometry:?}: it is behind");
        assert!(scene.take_hints().contains(&Hint::NoCarNear));
        scene.aim(yaw, -0.2);
        steps(&mut scene, 1, &enter());
        assert!(scene.is_driving(), "{geometry:?}");
        assert!(scene.probe().player.in_car);
        steps(
            &mut scene,
            1,
            &Actions {
                leave_car: true,
                ..still()
            },
        );
        assert!(!scene.is_driving());
        assert_eq!(
            scene.surroundings().drive,
            None,
            "no engine is heard on foot"
        );
        let (feet, car) = (scene.feet(), car(&scene));
        let far = (feet.pos - car.point.pos).length();
        assert!(far < 3.5, "{geometry:?} {far}");
        steps(&mut scene, 60, &still());
        let settled = scene.feet().pos;
        assert!(
            settled.y > feet.pos.y - 3.0 && settled.y < feet.pos.y + 0.5,
            "{geometry:?}: not stuck in the ground or the car: {feet:?} {settled}"
        );
        assert!(scene.probe().player.grounded);
        stand_beside(&mut scene, 6.0);
        steps(&mut scene, 1, &enter());
        assert!(!scene.is_driving(), "{geometry:?}: six metres are too far");
    }
}

#[test]
fn it_drives_where_it_points_with_the_player_and_two_runs_are_alike() {
    let run = |geometry| {
        let mut scene = driving(geometry);
        let before = car(&scene);
        steps(&mut scene, 90, &ahead());
        let after = car(&scene);
        (before, after, scene)
    };
    for geometry in GEOMETRIES {
        let (before, after, scene) = run(geometry);
        let way = after.point.pos - before.point.pos;
        let heard = scene.surroundings().drive.unwrap();
        assert_eq!(heard.throttle, 1.0);
        assert!((heard.speed_m_s - after.speed_m_s).abs() < 1e-9 && heard.slide_m_s.is_finite());
        let forwards = way.dot((before.turn * DVec3::X).with_y(0.0).normalize());
        assert!(forwards > 3.0, "{geometry:?} {way}");
        let player = scene.feet();
        assert!(player.pos.distance(after.point.pos) < 1.0);
        assert_eq!(player.hemisphere, after.point.hemisphere);
        let (_, again, _) = run(geometry);
        assert_eq!(after, again, "{geometry:?}");
    }
}

#[test]
fn its_wheels_turn_and_steer_and_the_driver_is_seen() {
    let mut scene = driving(Geometry::Euclidean);
    steps(
        &mut scene,
        45,
        &Actions {
            strafe: 1.0,
            ..ahead()
        },
    );
    let view = car(&scene);
    assert!(view.steer_rad > 0.05, "{view:?}");
    assert!(view.wheels[0].steer_rad > 0.05 && view.wheels[2].steer_rad == 0.0);
    let frame = scene.frame(1.2, 16.0 / 9.0, 1);
    let count = |model| frame.figures.iter().filter(|it| it.model == model).count();
    assert_eq!(count(ModelId::CarBody), 1);
    assert_eq!(count(ModelId::CarWheelLeft), 2);
    assert_eq!(count(ModelId::CarWheelRight), 2);
    let driver = frame
        .figures
        .iter()
        .find(|it| it.model == ModelId::Astronaut)
        .expect("the driver is seen from behind the car");
    assert!(driver.point.pos.distance(view.point.pos) < 0.8);
    let roll = view.wheels[0].roll_rad;
    steps(&mut scene, 3, &ahead());
    assert!(car(&scene).wheels[0].roll_rad != roll);
}

#[test]
fn its_lights_are_switched_and_braking_is_seen_behind() {
    let mut scene = driving(Geometry::Euclidean);
    let lit = |scene: &mut Scene| {
        let lights = scene.frame(1.2, 16.0 / 9.0, 1).lights;
        (lights.beams.len(), lights.lamps)
    };
    assert_eq!(lit(&mut scene).0, 0);
    let switch = Actions {
        toggle_light: true,
        ..still()
    };
    steps(&mut scene, 1, &switch);
    assert!(car(&scene).lights && !scene.flashlight());
    let (beams, tails) = lit(&mut scene);
    assert_eq!((beams, tails.len()), (2, 2));
    steps(&mut scene, 60, &ahead());
    let brake = Actions {
        jump: true,
        ..still()
    };
    steps(&mut scene, 1, &brake);
    let (_, brakes) = lit(&mut scene);
    assert!(brakes[0].colour[0] > 2.0 * tails[0].colour[0]);
    steps(&mut scene, 180, &brake);
    assert!(car(&scene).speed_m_s.abs() < 0.3, "{:?}", car(&scene));
    steps(
        &mut scene,
        1,
        &Actions {
            leave_car: true,
            ..still()
        },
    );
    assert!(car(&scene).lights, "they stay as they were");
    steps(&mut scene, 1, &switch);
    assert!(scene.flashlight() && car(&scene).lights);
}

/// A car at the wheel of which the player drives towards the equator along that azimuth, turned aside by an angle.
fn bound_for_the_equator(seed: u64, azimuth: f64, aside: f64) -> Scene {
    let mut scene = {
        let setup = antipode_scene::WorldSetup {
            seed,
            ..common::setup(Geometry::Spherical)
        };
        let mut scene = Scene::open(setup, None).unwrap();
        assert!(scene.wait_for_step(LIMIT));
        scene
    };
    let rim_m = scene.strategy().rim_m().unwrap();
    let from_m = rim_m - 24.0;
    let out = DVec3::new(azimuth.cos(), 0.0, azimuth.sin());
    let at = ChartPoint::new(Hemisphere::A, out * from_m + DVec3::Y * 12.0);
    assert!(scene.spawn_car(at, azimuth + aside));
    scene.teleport(at.moved(DVec3::Y * 6.0));
    assert!(scene.wait_for_step(LIMIT));
    steps(&mut scene, 120, &still());
    stand_beside(&mut scene, 2.2);
    steps(&mut scene, 1, &enter());
    scene
}

/// Steps about a crossing: the last two in the old chart, the one that ended in the new chart, and the next two.
struct Crossed {
    before: [CarView; 2],
    over: CarView,
    after: [CarView; 2],
    /// The way the chart turned.
    turn_rad: f64,
}

/// Drives until the car has changed charts.
fn cross(scene: &mut Scene, wish: Actions) -> Option<Crossed> {
    let mut before = [car(scene); 2];
    for _ in 0..600 {
        steps(scene, 1, &wish);
        let over = car(scene);
        if over.point.hemisphere != before[1].point.hemisphere {
            let turn_rad = scene.strategy().carry(before[1].point)?.turn_rad;
            let next = |scene: &mut Scene| {
                steps(scene, 1, &wish);
                car(scene)
            };
            let after = [next(scene), next(scene)];
            return Some(Crossed {
                before,
                over,
                after,
                turn_rad,
            });
        }
        before = [before[1], over];
    }
    None
}

/// How much one thing changes from step to step, and how much that change changes.
fn jerks(crossed: &Crossed) -> (f64, usize, f64) {
    let level = |car: &CarView| car.velocity.length();
    let speeds: Vec<f64> = crossed
        .before
        .iter()
        .chain([&crossed.over])
        .chain(&crossed.after)
        .map(level)
        .collect();
    let changes: Vec<f64> = speeds.windows(2).map(|w| w[1] - w[0]).collect();
    let jerk = changes
        .windows(2)
        .map(|w| (w[1] - w[0]).abs())
        .fold(0.0, f64::max);
    let lost = (0..4)
        .filter(|&i| {
            crossed.before[1].wheels[i].contact
                && crossed.over.wheels[i].contact
                && !crossed.after[0].wheels[i].contact
        })
        .count();
    let spring = (0..4)
        .map(|i| {
            (crossed.after[0].wheels[i].compression_m - crossed.over.wheels[i].compression_m).abs()
        })
        .fold(0.0, f64::max);
    (jerk / speeds[1], lost, spring)
}

/// Drives over the equator in many directions on the rough land as it is. Wheels jump there and the body bumps, so what
/// happens in the step of the crossing is held against what happens in every other step.
#[test]
fn over_the_equator_nothing_jerks_that_would_not_jerk_elsewhere() {
    let (mut crossings, mut lost, mut worse) = (0, 0, 0);
    for (seed, azimuth, aside) in [
        (3, 0.89, 0.6),
        (3, 1.67, 0.0),
        (4, 0.89, 0.6),
        (5, 5.59, 0.6),
        (6, 2.46, 0.6),
        (6, 3.24, 0.6),
        (6, 4.03, 0.0),
        (6, 5.59, 0.0),
        (7, 0.10, 0.6),
        (7, 4.81, 0.0),
        (8, 3.24, 0.0),
        (9, 3.24, 0.0),
    ] {
        let mut scene = bound_for_the_equator(seed, azimuth, aside);
        assert!(scene.is_driving(), "{seed} {azimuth}");
        let crossed = cross(&mut scene, ahead()).expect("it gets there");
        let (jerk, gone, _) = jerks(&crossed);
        crossings += 1;
        lost += gone;
        worse += usize::from(jerk > 0.01);
        let heading = |car: &CarView| car.turn * DVec3::X;
        let kept = DQuat::from_rotation_y(crossed.turn_rad) * heading(&crossed.before[1]);
        let turned = kept.dot(heading(&crossed.over)).clamp(-1.0, 1.0).acos();
        assert!(turned < 0.04, "{seed} {azimuth}: {turned} rad in a step");
        let player = scene.feet();
        assert_eq!(player.hemisphere, crossed.over.point.hemisphere);
    }
    assert_eq!((crossings, lost), (12, 0));
    assert!(worse <= 1, "{worse} of {crossings}");
}

/// Whether a wheel lets go of the ground from one step to the next.
fn let_go(before: &CarView, after: &CarView) -> bool {
    let wheels = before.wheels.iter().zip(&after.wheels);
    wheels
        .into_iter()
        .any(|(before, after)| before.contact && !after.contact)
}

/// On rough land wheels let go now and then. They do so no more often in the step over the equator than in others.
#[test]
#[ignore = "takes minutes; for who changes the crossing or the vehicle"]
fn over_the_equator_wheels_let_go_no_more_often_than_elsewhere() {
    let (mut over, mut over_lost, mut other, mut other_lost) = (0, 0, 0, 0);
    for seed in 3..13 {
        for turn in 0..16 {
            let azimuth = 0.1 + std::f64::consts::FRAC_PI_8 * f64::from(turn);
            let aside = if turn % 2 == 0 { 0.0 } else { 0.6 };
            let mut scene = bound_for_the_equator(seed, azimuth, aside);
            if !scene.is_driving() {
                continue;
            }
            let mut last = car(&scene);
            let mut left = 600;
            while left > 0 {
                left -= 1;
                steps(&mut scene, 1, &ahead());
                let now = car(&scene);
                let crosses = now.point.hemisphere != last.point.hemisphere;
                if crosses {
                    // In the step that ends beyond, the wheels still touched the old chart's land.
                    let step = now;
                    steps(&mut scene, 1, &ahead());
                    over += 1;
                    over_lost += usize::from(let_go(&step, &car(&scene)));
                    left = left.min(60);
                } else if now.velocity.length() > 4.0 {
                    other += 1;
                    other_lost += usize::from(let_go(&last, &now));
                }
                last = car(&scene);
            }
        }
    }
    let share = |lost: usize, all: usize| lost as f64 / all as f64;
    let (there, elsewhere) = (share(over_lost, over), share(other_lost, other));
    println!("{over_lost} of {over} steps over the equator, {other_lost} of {other} others");
    assert!(over > 80, "{over}");
    assert!(there < 1.5 * elsewhere, "{there} against {elsewhere}");
}

/// A careless driver: full force, and the wheel thrown about, until the car lies on its side or roof.
fn roll_over(scene: &mut Scene) -> bool {
    for second in 0..400 {
        let strafe = [0.0, 1.0, 1.0, -1.0][second % 4];
        let wish = Actions {
            sprint: true,
            strafe,
            ..ahead()
        };
        steps(scene, 60, &wish);
        let up = |scene: &Scene| (car(scene).turn * DVec3::Y).y;
        if up(scene) < 0.1 {
            steps(scene, 180, &still());
            if up(scene) < 0.3 {
                return true;
            }
        }
    }
    false
}

#[test]
fn it_can_roll_over_and_is_set_upright_with_its_heading_and_lights_kept() {
    let mut scene = driving(Geometry::Spherical);
    scene.set_npcs(NpcMode::Still);
    steps(
        &mut scene,
        1,
        &Actions {
            toggle_light: true,
            ..still()
        },
    );
    assert!(roll_over(&mut scene), "{:?}", car(&scene));
    let lies = car(&scene);
    let flip = Actions {
        flip_car: true,
        ..still()
    };
    steps(&mut scene, 1, &flip);
    steps(&mut scene, 90, &still());
    let stands = car(&scene);
    assert!((stands.turn * DVec3::Y).y > 0.6, "{stands:?}");
    assert!(scene.is_driving() && stands.lights && scene.cars().len() == 1);
    let ahead_of = |car: &CarView| (car.turn * DVec3::X).with_y(0.0);
    if ahead_of(&lies).length() > 0.5 && lies.point.hemisphere == stands.point.hemisphere {
        let kept = ahead_of(&lies)
            .normalize()
            .dot(ahead_of(&stands).normalize());
        assert!(kept > 0.8, "{kept}");
    }
}

#[test]
fn who_is_run_over_is_hurt_and_the_car_goes_on() {
    let mut scene = driving(Geometry::Euclidean);
    scene.set_npcs(NpcMode::Still);
    let view = car(&scene);
    let way = (view.turn * DVec3::X).with_y(0.0).normalize();
    let at = view.point.moved(way * 9.0 + DVec3::Y * 3.0);
    let id = scene.spawn_bot(at, 0.0, false);
    steps(&mut scene, 90, &still());
    let health = |scene: &Scene| {
        let bots = scene.bots();
        bots.iter().find(|it| it.bot.id == id).map(|it| it.health)
    };
    assert_eq!(health(&scene), Some(3.0), "a standing car hurts nobody");
    let wish = Actions {
        sprint: true,
        ..ahead()
    };
    steps(&mut scene, 100, &wish);
    assert!(
        health(&scene).is_none_or(|left| left < 3.0),
        "{:?}",
        scene.bots()
    );
    assert!(car(&scene).point.pos.distance(view.point.pos) > 9.0);
}

#[test]
fn who_stands_in_its_way_runs_from_it_and_who_stands_by_a_parked_one_does_not() {
    for geometry in GEOMETRIES {
        let mut scene = driving(geometry);
        scene.set_npcs(NpcMode::Off);
        let view = car(&scene);
        let way = (view.turn * DVec3::X).with_y(0.0).normalize();
        let at = common::figures::beside(&scene, 24.0 * way.x, 24.0 * way.z);
        let id = scene.spawn_bot(at, 0.0, false);
        let bot = |scene: &Scene| common::figures::bot(scene, id);
        let mut ran = false;
        for _ in 0..240 {
            steps(&mut scene, 1, &ahead());
            ran |= bot(&scene).state == State::Aside;
        }
        assert!(ran, "{geometry:?}");
        assert_eq!(
            bot(&scene).health.to_bits(),
            3.0_f64.to_bits(),
            "{geometry:?}"
        );
    }
    let mut scene = with_car(Geometry::Euclidean);
    let view = car(&scene);
    let at = view.point.moved((view.turn * DVec3::X).with_y(0.0) * 3.5);
    let id = scene.spawn_bot(at, 0.0, false);
    for _ in 0..60 {
        steps(&mut scene, 1, &still());
        assert_ne!(common::figures::bot(&scene, id).state, State::Aside);
    }
}

#[test]
fn a_bullet_rocks_a_parked_car_and_stops_there() {
    let mut scene = with_car(Geometry::Euclidean);
    scene.set_npcs(NpcMode::Still);
    stand_beside(&mut scene, 2.4);
    assert!(car(&scene).rests);
    scene.inventory_mut().select(0);
    let target = car(&scene).place(DVec3::Y * 0.8).pos;
    let eye = scene.head().point.pos;
    let way = target - eye;
    scene.aim(way.z.atan2(way.x), (way.y / way.length()).asin());
    steps(
        &mut scene,
        1,
        &Actions {
            primary: true,
            ..still()
        },
    );
    let mut most_m_s = 0.0f64;
    for _ in 0..40 {
        steps(&mut scene, 1, &still());
        most_m_s = most_m_s.max(car(&scene).velocity.length());
    }
    assert!(most_m_s > 0.1, "{most_m_s}");
}

#[test]
fn a_second_car_can_be_put_in_and_both_are_solid() {
    let mut scene = with_car(Geometry::Euclidean);
    let first = car(&scene);
    let way = (first.turn * DVec3::X).with_y(0.0).normalize();
    assert!(scene.spawn_car(first.point.moved(way * 8.0), 0.0));
    steps(&mut scene, 120, &still());
    let cars = scene.cars();
    assert_eq!(cars.len(), 2);
    assert!(cars[1].wheels.iter().filter(|it| it.contact).count() >= 3);
    // Both come to rest though one stood still before the other: who rests does not wake its neighbour.
    let beside = first.point.moved(way * 4.5 + DVec3::Y);
    assert!(scene.spawn_car(beside, 0.0));
    steps(&mut scene, 600, &still());
    assert!(
        scene.cars().iter().all(|car| car.rests),
        "{:?}",
        scene.cars()
    );
    // Who walks against a car stands in front of it.
    stand_beside(&mut scene, 3.0);
    steps(&mut scene, 120, &ahead());
    let side = scene.feet().pos - car(&scene).point.pos;
    assert!(side.with_y(0.0).length() > 0.9, "{side}");
}
