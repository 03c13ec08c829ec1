//! Digging and building at a door: the brush goes through it.

use antipode_geometry::{Doorway, Geometry, Leaf};
use antipode_scene::{Actions, NpcMode, Scene};
use glam::DVec3;

use crate::common::doors::{before_the_player, leaf, level_strip, local, put_up, standing, still};
use crate::common::{LIMIT, scene, steps};

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
    // Ground is told by samples a metre of the chart apart, so the places are so far from a leaf by those.
    places.map(|(leaf, x, z): (Leaf, f64, f64)| {
        let way = leaf.through() * x + leaf.aside() * z;
        let share = way.length() / leaf.level.in_chart(way).length();
        ground_m(scene, &leaf, x * share, z * share)
    })
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

/// Two leaves that look the same way, one behind the other, and a brush between them whose ball reaches over both.
#[test]
fn of_two_leaves_in_one_brush_each_parts_it() {
    let mut scene = scene(Geometry::Euclidean);
    scene.set_npcs(NpcMode::Still);
    let (foot, yaw) = level_strip(&scene, scene.feet(), 10.0, 5.0);
    let middle = standing(&scene, foot, yaw);
    let leaves = [-1.4, 1.4].map(|x| {
        let at = middle.place(DVec3::X * x);
        leaf(&scene, at.chart, at.pos.x, at.pos.z, yaw)
    });
    put_up(&mut scene, leaves);
    let places = [-2.4, 0.0, 2.4];
    let before = places.map(|x| ground_m(&mut scene, &middle, x, 0.0));
    scene.teleport(middle.place(DVec3::new(0.0, 0.3, 0.0)));
    assert!(scene.wait_for_step(LIMIT));
    steps(&mut scene, 40, &still());
    scene.inventory_mut().select(3);
    scene.aim(yaw, -1.5);
    let dig = Actions {
        primary: true,
        ..still()
    };
    steps(&mut scene, 40, &dig);
    assert!(scene.settle(LIMIT));
    let after = places.map(|x| ground_m(&mut scene, &middle, x, 0.0));
    let dug: Vec<f64> = before.iter().zip(after).map(|(a, b)| a - b).collect();
    assert!(dug[1] > 0.5, "between them: {dug:?}");
    assert!(
        dug[0].abs() < 0.15 && dug[2].abs() < 0.15,
        "behind the leaves: {dug:?}"
    );
}

/// The ring about what is dug goes on in the picture that a leaf shows.
#[test]
fn the_ring_of_a_brush_that_reaches_through_a_leaf_is_seen_on_the_other_side_in_every_space() {
    for geometry in Geometry::ALL {
        let (mut scene, pair) = before_the_player(geometry);
        let [near, far] = pair.leaves;
        scene.inventory_mut().select(3);
        // At the ground half a metre before the leaf.
        scene.aim(near.yaw, -(1.6f64 / 1.5).atan());
        let dig = Actions {
            primary: true,
            ..still()
        };
        steps(&mut scene, 2, &dig);
        let frame = scene.frame(1.2, 1.5, 1);
        let marker = frame.marker().unwrap().point;
        let here = local(&scene, &near, marker);
        assert!(here.x < 0.0 && here.length() < 1.5, "{geometry}: {here}");
        let beyond = frame.openings.iter().find(|it| it.leaf == near).unwrap();
        let shown = frame.seen_by(beyond.view.clone()).marker().unwrap().point;
        let there = local(&scene, &far, shown);
        assert!((there - here).length() < 0.3, "{geometry}: {there} {here}");
    }
}
