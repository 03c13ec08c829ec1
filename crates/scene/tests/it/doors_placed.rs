//! Where a door can be put up: the player sees how it will stand before it does, and is told what is against a place.

use antipode_geometry::Geometry;
use antipode_items::Item;
use antipode_scene::frame::{Figure, ModelId, Presence};
use antipode_scene::notice::{Hint, Unfit};
use antipode_scene::{Actions, NpcMode, Scene};
use glam::DVec3;

use crate::common::doors::{ground, level_strip, press, still};
use crate::common::{LIMIT, scene, steps};

/// The door that is shown where it would stand.
fn foreseen(scene: &mut Scene) -> Option<Figure> {
    let frame = scene.frame(1.2, 1.5, 1);
    let figures = frame.content.figures.iter();
    let mut shown = figures.filter(|it| it.presence != Presence::Real);
    let door = shown.next().copied();
    assert!(door.is_none_or(|it| it.model == ModelId::Item(Item::Door)));
    assert!(shown.next().is_none());
    door
}

fn with_a_door(geometry: Geometry) -> Scene {
    let mut scene = scene(geometry);
    scene.set_npcs(NpcMode::Still);
    let (at, yaw) = level_strip(&scene, scene.feet(), 8.0, 2.5);
    let stand = at.pos - 2.5 * DVec3::new(yaw.cos(), 0.0, yaw.sin());
    let stand = ground(&scene, at.chart, stand.x, stand.z);
    scene.teleport(stand.moved(DVec3::Y * 0.2));
    assert!(scene.wait_for_step(LIMIT));
    steps(&mut scene, 30, &still());
    scene.aim(yaw, -0.5);
    take_in_hand(&mut scene);
    scene
}

fn take_in_hand(scene: &mut Scene) {
    let slots = scene.inventory().slots();
    let slot = slots
        .iter()
        .position(|slot| slot.is_some_and(|it| it.item == Item::Door));
    scene.inventory_mut().select(slot.unwrap() as u8);
    steps(scene, 1, &still());
}

#[test]
fn a_door_is_shown_where_it_would_stand_and_then_stands_there_in_every_space() {
    for geometry in Geometry::ALL {
        let mut scene = with_a_door(geometry);
        let shown = foreseen(&mut scene).unwrap();
        let is_possible = shown.presence == Presence::Possible;
        assert_eq!(scene.against_placing(), None, "{geometry}");
        press(&mut scene, true);
        assert!(is_possible, "{geometry}: {:?}", scene.take_hints());
        let stands = scene.frame(1.2, 1.5, 1);
        let is_there = |it: &Figure| {
            it.presence == Presence::Real
                && it.model == shown.model
                && it.point.pos.distance(shown.point.pos) < 1e-9
                && it.turn.angle_between(shown.turn) < 1e-6
        };
        assert!(stands.content.figures.iter().any(is_there), "{geometry}");
        // The next one would stand right in it.
        steps(&mut scene, 1, &still());
        assert_eq!(foreseen(&mut scene).unwrap().presence, Presence::Barred);
        assert_eq!(scene.against_placing(), Some(Unfit::Crowded));
        scene.take_hints();
        press(&mut scene, true);
        assert_eq!(scene.take_hints(), [Hint::Unfit(Unfit::Crowded)]);
        assert_eq!(scene.probe().doors.len(), 1);
        scene.aim(scene.eye().yaw, 1.0);
        steps(&mut scene, 1, &still());
        assert!(foreseen(&mut scene).is_none(), "no ground is there");
    }
}

#[test]
fn on_a_slope_and_before_a_wall_it_is_red_and_a_click_says_why() {
    let mut scene = with_a_door(Geometry::Euclidean);
    let yaw = scene.eye().yaw;
    scene.inventory_mut().select(3);
    let build = Actions {
        secondary: true,
        ..still()
    };
    // A heap a metre wide, whose sides are steep.
    let narrow = Actions {
        brush_step: -10,
        ..still()
    };
    steps(&mut scene, 1, &narrow);
    steps(&mut scene, 150, &build);
    take_in_hand(&mut scene);
    scene.take_hints();
    let mut why = std::collections::BTreeSet::new();
    for at in 0..24 {
        let (turn, pitch) = (f64::from(at % 6) - 2.5, -0.6 + 0.2 * f64::from(at / 6));
        scene.aim(yaw + 0.12 * turn, pitch);
        steps(&mut scene, 1, &still());
        let Some(shown) = foreseen(&mut scene) else {
            continue;
        };
        if shown.presence == Presence::Possible {
            // Its posts reach into the ground on either side.
            for z in [-1.04, 1.04] {
                let post = shown.point.moved(shown.turn * DVec3::new(0.0, 0.4, z));
                scene.teleport(post);
                let ground_m = scene.ground_height().unwrap();
                let over_m = shown.point.pos.y - ground_m;
                assert!(over_m < 1.15, "a post hangs {over_m} m over the ground");
            }
            continue;
        }
        press(&mut scene, true);
        for hint in scene.take_hints() {
            why.insert(hint.to_string());
        }
    }
    assert!(scene.probe().doors.is_empty());
    assert!(
        why.contains(&Hint::Unfit(Unfit::Steep).to_string()),
        "{why:?}"
    );
}
