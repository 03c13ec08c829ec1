//! The list of shapes that can be hit: who is in it, where, and whether it is awake.

use crate::common::{scene, steps};
use antipode_geometry::Geometry;
use antipode_scene::frame::{HitForm, HitShape};
use antipode_scene::{Actions, Item, Scene, Stack};
use glam::DVec3;

/// The player's own body; others may stand about.
fn own(scene: &Scene) -> Option<HitShape> {
    let capsule = |shape: &HitShape| {
        matches!(shape.form, HitForm::Capsule { .. }) && shape.point == scene.feet()
    };
    scene.hit_shapes().into_iter().find(capsule)
}

/// Balls as large as those of things that lie or stand about, not bullets.
fn balls(scene: &Scene) -> Vec<HitShape> {
    let ball =
        |shape: &HitShape| matches!(shape.form, HitForm::Ball { radius_m } if radius_m > 0.1);
    scene.hit_shapes().into_iter().filter(ball).collect()
}

#[test]
fn the_own_body_is_shown_from_behind_only_green_while_it_moves_and_red_at_rest() {
    for geometry in Geometry::ALL {
        let mut scene = scene(geometry);
        steps(&mut scene, 60, &Actions::default());
        assert_eq!(own(&scene), None, "{geometry}");
        let camera = Actions {
            toggle_camera: true,
            ..Actions::default()
        };
        steps(&mut scene, 1, &camera);
        assert!(own(&scene).is_some_and(|own| !own.awake), "{geometry}");
        let walk = Actions {
            forward: 1.0,
            ..Actions::default()
        };
        steps(&mut scene, 10, &walk);
        assert!(own(&scene).is_some_and(|own| own.awake), "{geometry}");
    }
}

#[test]
fn what_flies_is_awake_and_what_has_come_to_rest_is_not() {
    let mut scene = scene(Geometry::Euclidean);
    steps(&mut scene, 30, &Actions::default());
    scene.throw_away(Stack {
        item: Item::Lamp,
        count: 1,
    });
    steps(&mut scene, 2, &Actions::default());
    assert!(balls(&scene).len() == 1 && balls(&scene)[0].awake);
    steps(&mut scene, 240, &Actions::default());
    let lying = balls(&scene);
    assert!(lying.iter().all(|ball| !ball.awake), "{lying:?}");
    let lamp = scene.feet().moved(DVec3::new(3.0, 0.0, 3.0));
    assert!(scene.spawn_lamp(lamp));
    let lamp = balls(&scene)[0];
    assert!(!lamp.awake && lamp.point.pos.y > scene.lamps()[0].foot.point.pos.y);
}

#[test]
fn looking_at_shapes_changes_nothing() {
    let mut scene = scene(Geometry::Spherical);
    scene.spawn_bot(scene.feet().moved(DVec3::new(2.0, 1.0, 0.0)), 0.0, false);
    steps(&mut scene, 20, &Actions::default());
    let before = scene.probe();
    let bots = scene.bots();
    let shown = |bot: &antipode_scene::bot::BotView| {
        let shapes = scene.hit_shapes();
        shapes.iter().any(|shape| shape.point == bot.point)
    };
    assert!(!bots.is_empty() && bots.iter().all(shown));
    assert_eq!(scene.probe(), before);
}
