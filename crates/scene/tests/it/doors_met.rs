//! A car that stands in a door is met on both sides of it, and nowhere else, by bullets and by all who walk.

use antipode_geometry::{Geometry, Leaf};
use antipode_scene::{Actions, NpcMode, Scene};
use glam::DVec3;

use crate::common::doors::{ahead, car_at, ground, level_pair, local, open_pair, still};
use crate::common::{LIMIT, roomy_scene, scene, steps};
use crate::doors_driven::{on, take_the_wheel};

/// The middle of the car that stands in a door is there in the axes of the leaf, and its nose 1.5 m farther on.
const MIDDLE_M: f64 = -0.6;

/// A world of a pair with a parked car in its first leaf, which looks through it.
fn with_car_in_a_door(geometry: Geometry) -> (Scene, [Leaf; 2]) {
    let mut scene = roomy_scene(geometry);
    scene.set_npcs(NpcMode::Still);
    let leaves = open_pair(&mut scene, 6.0).leaves;
    car_at(&mut scene, &leaves[0], MIDDLE_M, 0.0);
    let at = local(&scene, &leaves[0], scene.cars()[0].point);
    assert!((at.x - MIDDLE_M).abs() < 0.15, "{geometry}: {at}");
    (scene, leaves)
}

/// So far along each leaf there is something of it to be met, or there would be, were it not on the other side.
fn places(leaves: &[Leaf; 2]) -> [(Leaf, f64, bool); 4] {
    let [near, far] = *leaves;
    [
        (near, -1.3, true),
        (near, 0.55, false),
        (far, 0.55, true),
        (far, -1.3, false),
    ]
}

#[test]
fn a_bullet_meets_the_part_of_a_car_that_is_there_and_gives_the_car_its_push_in_every_space() {
    for geometry in Geometry::ALL {
        let (mut scene, leaves) = with_car_in_a_door(geometry);
        let up_m = local(&scene, &leaves[0], scene.cars()[0].point).y + 0.6;
        for (leaf, x, is_met) in places(&leaves) {
            let start = leaf.place(DVec3::new(x, up_m, -1.6));
            scene.throw_bullet(start, leaf.aside() * 30.0);
            let mut pushed_m_s = 0.0f64;
            for _ in 0..6 {
                steps(&mut scene, 1, &still());
                let velocity = scene.cars()[0].velocity;
                pushed_m_s = pushed_m_s.max(velocity.dot(leaves[0].aside()));
            }
            let bullet = scene.projectiles().last().unwrap().1.point;
            let z = local(&scene, &leaf, bullet).z;
            assert_eq!(z < -0.5, is_met, "{geometry}: at {x} it came to {z}");
            assert!(is_met || z > 0.9, "{geometry}: at {x} it came to {z}");
            assert_eq!(pushed_m_s > 1e-3, is_met, "{geometry} {x}: {pushed_m_s}");
            steps(&mut scene, 200, &still());
        }
    }
}

#[test]
fn who_walks_is_stopped_by_the_part_of_a_car_that_is_there_in_every_space() {
    for geometry in Geometry::ALL {
        let (mut scene, leaves) = with_car_in_a_door(geometry);
        for (leaf, x, is_met) in places(&leaves) {
            let at = leaf.place(DVec3::new(x, 0.0, -2.0));
            let at = ground(&scene, at.chart, at.pos.x, at.pos.z);
            scene.teleport(at.moved(DVec3::Y * 0.1));
            assert!(scene.wait_for_step(LIMIT));
            steps(&mut scene, 20, &still());
            let way = leaf.aside();
            scene.aim(way.z.atan2(way.x), 0.0);
            let mut z = f64::MIN;
            for _ in 0..90 {
                steps(&mut scene, 1, &ahead());
                z = z.max(local(&scene, &leaf, scene.feet()).z);
            }
            // The car is 1.4 m wide, and somebody 0.7 m.
            assert_eq!(z < -0.8, is_met, "{geometry}: at {x} he came to {z}");
            assert!(is_met || z > 1.0, "{geometry}: at {x} he came to {z}");
        }
    }
}

#[test]
fn a_nose_that_comes_out_of_a_door_runs_into_who_stands_there_and_not_into_who_is_behind_the_leaf()
{
    for geometry in Geometry::ALL {
        let mut scene = scene(geometry);
        scene.set_npcs(NpcMode::Still);
        let leaves = level_pair(&mut scene, 6.0).leaves;
        car_at(&mut scene, &leaves[0], -4.5, 0.0);
        take_the_wheel(&mut scene);
        let people = leaves.map(|leaf| {
            let at = leaf.place(DVec3::X * 1.2);
            let at = ground(&scene, at.chart, at.pos.x, at.pos.z);
            scene.spawn_bot(at.moved(DVec3::Y * 0.05), leaf.yaw, false)
        });
        steps(&mut scene, 30, &still());
        let place = |scene: &Scene, who: usize| {
            let bots = scene.bots();
            let bot = bots.iter().find(|it| it.bot.id == people[who]).unwrap();
            local(scene, &leaves[who], bot.point)
        };
        let before = [place(&scene, 0), place(&scene, 1)];
        let mut x = f64::MIN;
        for _ in 0..240 {
            let car = scene.cars()[0];
            let at = local(&scene, &leaves[0], car.point);
            if at.length() > 9.0 || place(&scene, 1).x > before[1].x + 0.1 {
                break;
            }
            x = x.max(at.x);
            let wish: Actions = on(&scene, &leaves[0], &car, 2.0);
            steps(&mut scene, 1, &wish);
        }
        let moved_m = place(&scene, 1).x - before[1].x;
        assert!(x < -0.2 && moved_m > 0.05, "{geometry}: {x} {moved_m}");
        let unmoved_m = (place(&scene, 0) - before[0]).length();
        assert!(unmoved_m < 0.02, "{geometry}: {unmoved_m}");
    }
}
