//! Digging and building at a door: the brush goes through it.

use antipode_geometry::{Doorway, Geometry, Leaf};
use antipode_scene::{Actions, Scene};
use glam::DVec3;

use crate::common::doors::{before_the_player, still};
use crate::common::{LIMIT, steps};

/// The height of the ground at a place of a leaf's axes, over its foot.
fn ground_m(scene: &mut Scene, leaf: &Leaf, x: f64, z: f64) -> f64 {
    scene.teleport(leaf.place(DVec3::new(x, 7.0, z)));
    scene.ground_height().unwrap() - leaf.foot.pos.y
}

/// The ground before and behind either leaf, and beside the near one.
fn surveyed(scene: &mut Scene, pair: &Doorway) -> [f64; 5] {
    let [near, far] = pair.leaves;
    let places = [
        (near, -1.0, 0.0),
        (near, 1.0, 0.0),
        (far, 1.0, 0.0),
        (far, -1.0, 0.0),
        (near, 0.3, 2.0),
    ];
    places.map(|(leaf, x, z)| ground_m(scene, &leaf, x, z))
}

#[test]
fn a_brush_before_a_door_changes_the_ground_beyond_it_and_not_what_the_leaf_hides() {
    for geometry in Geometry::ALL {
        for sign in [1.0, -1.0] {
            let (mut scene, pair) = before_the_player(geometry);
            let [near, _] = pair.leaves;
            let stand = near.place(DVec3::new(-3.5, 1.0, 0.0));
            let before = surveyed(&mut scene, &pair);
            scene.teleport(stand);
            assert!(scene.wait_for_step(LIMIT));
            steps(&mut scene, 40, &still());
            scene.inventory_mut().select(3);
            // At the ground half a metre before the leaf.
            scene.aim(near.yaw, -(1.6f64 / 3.0).atan());
            let work = Actions {
                primary: sign > 0.0,
                secondary: sign < 0.0,
                ..still()
            };
            steps(&mut scene, 45, &work);
            assert!(scene.settle(LIMIT));
            let after = surveyed(&mut scene, &pair);
            let changed: Vec<f64> = before
                .iter()
                .zip(after)
                .map(|(a, b)| sign * (a - b))
                .collect();
            let told = format!("{geometry} {sign}: {changed:?}");
            assert!(changed[0] > 0.4, "before the near leaf: {told}");
            assert!(changed[1].abs() < 0.15, "hidden behind it: {told}");
            assert!(changed[2] > 0.3, "beyond the far leaf: {told}");
            assert!(changed[3].abs() < 0.15, "before the far leaf: {told}");
            assert!(
                changed[4] > 0.1,
                "beside the door the ground goes on: {told}"
            );
        }
    }
}
