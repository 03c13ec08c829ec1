//! What is seen of doors, and through them.

use antipode_geometry::Geometry;
use antipode_geometry::doorway::{BELOW_FOOT_M, HALF_WIDTH_M, HEIGHT_M};
use antipode_scene::Actions;
use glam::DVec3;

use crate::common::doors::{ahead, before_the_player, local, still};
use crate::common::{LIMIT, steps};

/// From behind one sees who has gone through a door through that door, from feet to head, however steeply one looks down; and as
/// far back as the arm is long.
#[test]
fn the_camera_behind_looks_back_through_the_door_at_who_has_gone_through() {
    for geometry in Geometry::ALL {
        for pitch in [-0.35, 0.0] {
            let (mut scene, pair) = before_the_player(geometry);
            let [near, far] = pair.leaves;
            let toggle = Actions {
                toggle_camera: true,
                ..still()
            };
            steps(&mut scene, 1, &toggle);
            scene.aim(near.yaw, pitch);
            let mut looked = 0;
            for _ in 0..90 {
                steps(&mut scene, 1, &ahead());
                let walker = local(&scene, &far, scene.feet());
                if walker.length() > 4.0 || !(0.05..1.4).contains(&walker.x) {
                    continue;
                }
                looked += 1;
                let camera = local(&scene, &near, scene.eye().point);
                assert!(
                    camera.x < 0.0 && camera.length() < 7.0,
                    "{geometry} {pitch}: at {walker} beyond the door it is seen from {camera}"
                );
                for up_m in [0.3, 0.9, 1.6] {
                    let seen = walker + DVec3::Y * up_m;
                    let at = camera.lerp(seen, camera.x / (camera.x - seen.x));
                    let is_in =
                        at.z.abs() < HALF_WIDTH_M && (-BELOW_FOOT_M..HEIGHT_M).contains(&at.y);
                    assert!(
                        is_in,
                        "{geometry} {pitch}: {up_m} up of {walker} from {camera} at {at}"
                    );
                }
            }
            assert!(looked > 5, "{geometry} {pitch}");
        }
    }
}

/// What lies behind the far leaf is on another side: ground there keeps no camera from its place.
#[test]
fn ground_behind_the_far_leaf_is_not_in_the_cameras_way() {
    let (mut scene, pair) = before_the_player(Geometry::Euclidean);
    let [near, far] = pair.leaves;
    let stand = near.place(DVec3::X * -1.5);
    let from = far.place(DVec3::X * -8.0);
    scene.teleport(from.moved(DVec3::Y * 0.5));
    assert!(scene.wait_for_step(LIMIT));
    scene.inventory_mut().select(3);
    scene.aim(far.yaw, -0.35);
    let build = Actions {
        secondary: true,
        ..still()
    };
    steps(&mut scene, 150, &build);
    let hill = far.place(DVec3::new(-3.2, 9.0, 0.0));
    scene.teleport(hill);
    let top_m = scene.ground_height().unwrap();
    assert!(top_m > far.foot.pos.y + 2.2, "{top_m} {}", far.foot.pos.y);
    scene.teleport(stand.moved(DVec3::Y * 0.2));
    assert!(scene.wait_for_step(LIMIT));
    let toggle = Actions {
        toggle_camera: true,
        ..still()
    };
    steps(&mut scene, 1, &toggle);
    scene.aim(near.yaw, 0.0);
    while local(&scene, &far, scene.feet()).length() > 1.0 {
        steps(&mut scene, 1, &ahead());
    }
    let camera = local(&scene, &near, scene.eye().point);
    assert!(camera.x < -3.0, "{camera}");
}
