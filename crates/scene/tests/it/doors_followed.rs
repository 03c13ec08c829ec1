//! Figures and doors: who follows the player, and who goes through for himself.

use antipode_geometry::Geometry;
use antipode_scene::{NpcMode, Scene};
use glam::DVec3;

use crate::common::doors::{ahead, before_the_player, local, still};
use crate::common::steps;

/// Where the first figure is.
fn figure(scene: &Scene) -> antipode_geometry::ChartPoint {
    scene.bots()[0].point
}

#[test]
fn who_fights_the_player_follows_through_the_door_in_every_space() {
    for geometry in Geometry::ALL {
        let (mut scene, pair) = before_the_player(geometry);
        let [near, far] = pair.leaves;
        scene.set_npcs(NpcMode::Off);
        // It stands behind the player, and comes by the way that he takes.
        let behind = near.place(DVec3::new(-3.6, 0.3, 0.4));
        scene.spawn_bot(behind, near.yaw, true);
        steps(&mut scene, 20, &still());
        for _ in 0..75 {
            steps(&mut scene, 1, &ahead());
            scene.set_health(100.0);
        }
        assert!(local(&scene, &far, scene.feet()).x > 1.0, "{geometry}");
        let mut came = false;
        for _ in 0..900 {
            steps(&mut scene, 1, &still());
            scene.set_health(100.0);
            let at = local(&scene, &far, figure(&scene));
            came |= at.x > 0.0 && at.length() < 8.0;
        }
        assert!(came, "{geometry}: {:?}", scene.bots());
    }
}

/// A fighter sees through a door, and what stands right behind a leaf is hidden by what the leaf shows.
#[test]
fn a_leaf_is_looked_through_and_not_past() {
    let (mut scene, pair) = before_the_player(Geometry::Euclidean);
    let [near, far] = pair.leaves;
    scene.set_npcs(NpcMode::Off);
    // On the far side of the far leaf: seen through the door, and nowhere else.
    scene.spawn_bot(far.place(DVec3::new(4.0, 0.5, 0.0)), far.yaw + 3.1, true);
    scene.spawn_bot(near.place(DVec3::new(4.0, 0.5, 0.0)), near.yaw + 3.1, true);
    scene.set_health(100.0);
    steps(&mut scene, 12, &still());
    let states: Vec<_> = scene.probe().bots.iter().map(|bot| bot.state).collect();
    assert!(matches!(states[0], "chase" | "fight"), "{states:?}");
    assert!(!matches!(states[1], "chase" | "fight"), "{states:?}");
}

#[test]
fn who_lives_in_peace_goes_through_for_himself() {
    let (mut scene, pair) = before_the_player(Geometry::Euclidean);
    let [near, far] = pair.leaves;
    scene.set_npcs(NpcMode::Off);
    for at in 0..4 {
        let place = near.place(DVec3::new(-5.0, 0.5, -6.0 + f64::from(at)));
        scene.spawn_bot(place, near.yaw, false);
    }
    let places = |scene: &Scene| -> Vec<DVec3> {
        let all = scene.bots().into_iter();
        all.map(|bot| local(scene, &far, bot.point)).collect()
    };
    let mut came = 0;
    for _ in 0..3600 {
        let before = places(&scene);
        steps(&mut scene, 1, &still());
        let after = places(&scene);
        // Nobody walks so far in a step.
        let leapt = before
            .iter()
            .zip(&after)
            .filter(|(a, b)| a.distance(**b) > 5.0);
        came += leapt.count();
    }
    assert!(came > 0, "{:?}", scene.bots());
}
