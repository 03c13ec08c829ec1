//! Cars and doors: what stands beyond is run into, and who goes through keeps his speed in the space wherever the other door is.

use antipode_geometry::{ChartId, ChartPoint, Geometry, Leaf};
use antipode_scene::{Actions, CarView, NpcMode, Scene};
use glam::DVec3;

use crate::common::cars::{enter, look_at_car, stand_beside};
use crate::common::doors::{car_at, ground, level_pair, local, put_up, standing, still};
use crate::common::{scene, steps};

/// Drives ahead along a leaf's front, no faster than that.
pub fn on(scene: &Scene, leaf: &Leaf, car: &CarView, fastest_m_s: f64) -> Actions {
    let at = local(scene, leaf, car.point);
    let off_rad = (car.yaw() - leaf.yaw).sin();
    Actions {
        forward: if car.velocity.length() < fastest_m_s {
            1.0
        } else {
            0.0
        },
        strafe: (-0.8 * at.z - 2.5 * off_rad).clamp(-1.0, 1.0),
        ..still()
    }
}

/// Gets into the first car.
pub fn take_the_wheel(scene: &mut Scene) {
    stand_beside(scene, 2.2);
    look_at_car(scene);
    steps(scene, 1, &enter());
    assert!(scene.is_driving(), "{:?}", scene.take_hints());
}

#[test]
fn a_car_that_stands_beyond_a_door_is_run_into_by_the_nose_that_is_through_in_every_space() {
    for geometry in Geometry::ALL {
        let mut scene = scene(geometry);
        scene.set_npcs(NpcMode::Still);
        let doors = level_pair(&mut scene, 6.0);
        let [near, far] = doors.leaves;
        car_at(&mut scene, &near, -4.5, 0.0);
        take_the_wheel(&mut scene);
        // Across the way, its side 0.9 m behind the far leaf.
        car_at(&mut scene, &far, 1.6, 1.57);
        let (mut farthest, mut struck_m_s) = (f64::MIN, 0.0f64);
        for _ in 0..150 {
            let car = scene.cars()[0];
            let at = local(&scene, &near, car.point);
            if at.length() > 9.0 {
                break;
            }
            farthest = farthest.max(at.x);
            let wish = on(&scene, &near, &car, 3.0);
            steps(&mut scene, 1, &wish);
            struck_m_s = struck_m_s.max(scene.cars()[1].velocity.length());
            if struck_m_s > 0.3 {
                break;
            }
        }
        assert!(struck_m_s > 0.3, "{geometry}: {farthest} {struck_m_s}");
        assert!(farthest < -0.2, "{geometry}: met at {farthest}");
    }
}

#[test]
fn a_car_keeps_its_speed_in_the_space_where_a_metre_of_the_chart_is_another() {
    let mut scene = scene(Geometry::Spherical);
    scene.set_npcs(NpcMode::Still);
    let doors = level_pair(&mut scene, 6.0);
    let [near, far] = doors.leaves;
    car_at(&mut scene, &near, -4.5, 0.0);
    take_the_wheel(&mut scene);
    // Cars are told in metres of the space.
    let in_chart_m_s = |scene: &Scene, car: &CarView| {
        let strategy = scene.strategy();
        strategy.in_chart(car.point, car.velocity).length()
    };
    let mut last = [0.0; 2];
    for _ in 0..300 {
        let before = scene.cars()[0];
        let is_in = local(&scene, &near, before.point).x > -1.0;
        let wish = on(&scene, &near, &before, if is_in { 0.0 } else { 4.0 });
        steps(&mut scene, 1, &wish);
        let car = scene.cars()[0];
        let now_m_s = car.velocity.length();
        if local(&scene, &far, car.point).length() < 2.0 {
            let [a, b] = last;
            let changed = (now_m_s / b - b / a).abs();
            let in_chart = in_chart_m_s(&scene, &car) / in_chart_m_s(&scene, &before);
            assert!(changed < 0.01, "{a} {b} {now_m_s}");
            assert!((in_chart - 1.0).abs() > 0.02, "no test: {in_chart}");
            return;
        }
        last = [last[1], now_m_s];
    }
    panic!("it did not go through: {:?}", scene.cars()[0]);
}

#[test]
fn a_bullet_keeps_its_speed_in_the_space_between_leaves_of_other_latitudes_and_heights() {
    for (chart, [x, z], up_m, yaw) in [
        (ChartId::FIRST, [46.0, 5.0], 0.0, 2.6),
        (ChartId::SECOND, [4.0, -3.0], 6.0, -0.7),
        (ChartId::SECOND, [-30.0, -38.0], 2.0, 1.2),
    ] {
        let mut scene = scene(Geometry::Spherical);
        scene.set_npcs(NpcMode::Still);
        let near = standing(&scene, scene.feet().moved(DVec3::new(3.0, 0.0, 1.0)), 0.4);
        let foot = ground(&scene, chart, x, z).moved(DVec3::Y * up_m);
        let leaves = [near, standing(&scene, foot, yaw)];
        put_up(&mut scene, leaves);
        for (from, back) in [(0, 1.0), (1, -1.0)] {
            let way =
                leaves[from].through() * (9.0 * back) + leaves[from].aside() * 2.0 + DVec3::Y * 3.0;
            let start = leaves[from].place(DVec3::new(-0.08 * back, 1.3, 0.0));
            scene.throw_bullet(start, way);
            let thrown_m_s = way.length();
            steps(&mut scene, 1, &still());
            let flown = scene.probe().projectiles.pop().unwrap();
            let there = ChartPoint::new(
                if flown.hemisphere == "B" {
                    ChartId::SECOND
                } else {
                    ChartId::FIRST
                },
                DVec3::from_array(flown.pos),
            );
            let at = local(&scene, &leaves[1 - from], there);
            assert!(at.length() < 2.0, "it did not go through: {at}");
            let velocity = DVec3::from_array(flown.vel);
            let now_m_s = velocity.length();
            let changed = (now_m_s / thrown_m_s - 1.0).abs();
            // Its weight takes a part of a step's 0.33 m/s.
            assert!(changed < 0.013, "{chart:?} {from}: {thrown_m_s} {now_m_s}");
            steps(&mut scene, 60, &still());
        }
    }
}
