//! What a player notices of the car: getting in and out, driving, its wheels, its lights, and whom it meets.

use crate::common::cars::{ahead, car, driving, enter, stand_beside, still, with_car};
use crate::common::steps;
use antipode_geometry::{ChartPoint, Geometry};
use antipode_scene::frame::ModelId;
use antipode_scene::{Actions, Hint, NpcMode, Scene, State};
use glam::DVec3;

const GEOMETRIES: [Geometry; 3] = [
    Geometry::Euclidean,
    Geometry::Hyperbolic,
    Geometry::Spherical,
];

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
        assert!(scene.take_hints().contains(&Hint::LookAtCar));
        scene.aim(yaw, -0.2);
        steps(&mut scene, 1, &enter());
        assert!(scene.is_driving(), "{geometry:?}");
        assert_eq!(scene.take_hints(), [Hint::AtTheWheel]);
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
fn a_far_car_is_spoken_of_while_it_is_seen_and_not_behind_a_hill() {
    let mut scene = with_car(Geometry::Euclidean);
    scene.set_npcs(NpcMode::Off);
    stand_beside(&mut scene, 14.0);
    let (at, feet) = (car(&scene).point.pos, scene.feet().pos);
    let yaw = (at.z - feet.z).atan2(at.x - feet.x);
    scene.aim(yaw, 0.0);
    scene.take_hints();
    steps(&mut scene, 1, &enter());
    assert_eq!(scene.take_hints(), [Hint::CarTooFar]);
    let build = Actions {
        slot: Some(3),
        secondary: true,
        ..still()
    };
    scene.aim(yaw, -0.25);
    steps(&mut scene, 180, &build);
    scene.aim(yaw, 0.0);
    steps(&mut scene, 30, &still());
    scene.take_hints();
    steps(&mut scene, 1, &enter());
    assert_eq!(scene.take_hints(), [Hint::NoCarNear]);
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
        assert_eq!(player.chart, after.point.chart);
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
    let count = |model| {
        frame
            .content
            .figures
            .iter()
            .filter(|it| it.model == model)
            .count()
    };
    assert_eq!(count(ModelId::CarBody), 1);
    assert_eq!(count(ModelId::CarWheelLeft), 2);
    assert_eq!(count(ModelId::CarWheelRight), 2);
    let driver = frame
        .content
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
        let content = scene.frame(1.2, 16.0 / 9.0, 1).content;
        (content.lights.beams.len(), content.lights.lamps.clone())
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

/// Where the car of a world comes by when it is driven like that and has come so far, in metres: on a hillside that is
/// not straight ahead.
fn on_its_way(geometry: Geometry, wish: &Actions, far_m: f64) -> ChartPoint {
    let mut scene = driving(geometry);
    scene.set_npcs(NpcMode::Off);
    let from = car(&scene).point.pos;
    for _ in 0..600 {
        steps(&mut scene, 1, wish);
        let at = car(&scene).point;
        if at.pos.distance(from) > far_m {
            return at;
        }
    }
    panic!("it never gets there");
}

#[test]
fn who_is_run_over_is_hurt_and_the_car_goes_on() {
    let wish = Actions {
        sprint: true,
        ..ahead()
    };
    let at = on_its_way(Geometry::Euclidean, &wish, 9.0);
    let mut scene = driving(Geometry::Euclidean);
    scene.set_npcs(NpcMode::Still);
    let view = car(&scene);
    let id = scene.spawn_bot(at.moved(DVec3::Y), 0.0, false);
    steps(&mut scene, 90, &still());
    let health = |scene: &Scene| {
        let bots = scene.bots();
        bots.iter().find(|it| it.bot.id == id).map(|it| it.health)
    };
    assert_eq!(health(&scene), Some(3.0), "a standing car hurts nobody");
    steps(&mut scene, 100, &wish);
    assert!(
        health(&scene).is_none_or(|left| left < 3.0),
        "{:?}",
        scene.bots()
    );
    assert!(car(&scene).point.pos.distance(view.point.pos) > 9.0);
}

/// What it costs of health to get out of a car as soon as it is as fast as that, in m/s.
fn damage_of_leaving_at(speed_m_s: f64) -> f64 {
    let mut scene = driving(Geometry::Euclidean);
    scene.set_npcs(NpcMode::Off);
    let wish = Actions {
        sprint: true,
        ..ahead()
    };
    for _ in 0..1200 {
        let is_due = car(&scene).velocity.length() >= speed_m_s;
        let leave_car = is_due && scene.is_driving();
        let asked = Actions { leave_car, ..wish };
        let before = scene.health();
        steps(&mut scene, 1, &asked);
        if !scene.is_driving() {
            return before - scene.health();
        }
    }
    panic!("it never is so fast, or there is never room");
}

#[test]
fn who_gets_out_of_a_fast_car_is_hurt() {
    assert_eq!(damage_of_leaving_at(12.0), 0.0);
    let damage = damage_of_leaving_at(20.0);
    assert!((5.0..10.0).contains(&damage), "{damage}");
}

#[test]
fn who_stands_in_its_way_runs_from_it_and_who_stands_by_a_parked_one_does_not() {
    for geometry in GEOMETRIES {
        let mut scene = driving(geometry);
        scene.set_npcs(NpcMode::Off);
        let at = on_its_way(geometry, &ahead(), 24.0);
        let id = scene.spawn_bot(at.moved(DVec3::Y * 0.5), 0.0, false);
        let bot = |scene: &Scene| crate::common::figures::bot(scene, id);
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
        assert_ne!(crate::common::figures::bot(&scene, id).state, State::Aside);
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
    // A walker who meets a car stands in front of it.
    stand_beside(&mut scene, 3.0);
    steps(&mut scene, 120, &ahead());
    let side = scene.feet().pos - car(&scene).point.pos;
    assert!(side.with_y(0.0).length() > 0.9, "{side}");
}
