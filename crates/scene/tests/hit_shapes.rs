//! The list of shapes that can be hit: who is in it, where, and whether it is awake.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "tests fail by panicking"
)]

mod common;

use antipode_geometry::Geometry;
use antipode_scene::frame::{HitForm, HitShape};
use antipode_scene::{Actions, Item, Scene, Stack};
use common::{scene, steps};
use glam::DVec3;

fn capsules(scene: &Scene) -> Vec<HitShape> {
    let capsule = |shape: &HitShape| matches!(shape.form, HitForm::Capsule { .. });
    scene.hit_shapes().into_iter().filter(capsule).collect()
}

fn balls(scene: &Scene) -> Vec<HitShape> {
    let ball = |shape: &HitShape| matches!(shape.form, HitForm::Ball { .. });
    scene.hit_shapes().into_iter().filter(ball).collect()
}

#[test]
fn the_own_body_is_shown_from_behind_only_green_while_it_moves_and_red_at_rest() {
    for geometry in Geometry::ALL {
        let mut scene = scene(geometry);
        steps(&mut scene, 60, &Actions::default());
        assert!(scene.hit_shapes().is_empty(), "{geometry}");
        let camera = Actions {
            toggle_camera: true,
            ..Actions::default()
        };
        steps(&mut scene, 1, &camera);
        let [own] = capsules(&scene)[..] else {
            panic!("{geometry}: {:?}", scene.hit_shapes())
        };
        assert!(!own.awake && own.point == scene.feet(), "{geometry}");
        let walk = Actions {
            forward: 1.0,
            ..Actions::default()
        };
        steps(&mut scene, 10, &walk);
        let [own] = capsules(&scene)[..] else {
            panic!("{geometry}")
        };
        assert!(own.awake && own.point == scene.feet(), "{geometry}");
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
    assert!(!lamp.awake && lamp.point.pos.y > scene.lamps()[0].point.pos.y);
}

#[test]
fn looking_at_shapes_changes_nothing() {
    let mut scene = scene(Geometry::Spherical);
    scene.spawn_bot(scene.feet().moved(DVec3::new(2.0, 1.0, 0.0)), 0.0, false);
    steps(&mut scene, 20, &Actions::default());
    let before = scene.probe();
    assert_eq!(capsules(&scene).len(), 1);
    assert_eq!(scene.probe(), before);
}
