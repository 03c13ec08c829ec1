//! Breadcrumbs: laid by who walks with the button held, shown on the map, followed back.

use antipode_geometry::{ChartPoint, Eye, Geometry};
use antipode_scene::bearings::LandmarkKind;
use antipode_scene::{Actions, Item, NpcMode};
use glam::DVec3;

use crate::common::{scene, steps};

/// Over all land, metres.
const HIGH_M: f64 = 40.0;

#[test]
fn who_walks_with_the_button_held_lays_a_trail_and_is_led_back_along_it() {
    for geometry in Geometry::ALL {
        let mut scene = scene(geometry);
        scene.set_npcs(NpcMode::Off);
        steps(&mut scene, 30, &Actions::default());
        let slots = scene.inventory().slots();
        let place = slots
            .iter()
            .position(|slot| slot.is_some_and(|stack| stack.item == Item::Crumb))
            .expect("a new player has some");
        scene.inventory_mut().swap(place as u8, 0);
        let had = scene.inventory().count(Item::Crumb);
        let lay = Actions {
            slot: Some(0),
            primary: true,
            forward: 1.0,
            ..Actions::default()
        };
        let begun = scene.feet();
        steps(&mut scene, 600, &lay);
        let laid = had - scene.inventory().count(Item::Crumb);
        // Ten seconds at 4.5 m/s, and one where the crosshair met the ground; rough ground slows.
        assert!((4..=9).contains(&laid), "{geometry}: {laid}");
        let marks = scene.landmarks(45.0);
        let crumbs = marks.iter().filter(|it| it.kind == LandmarkKind::Crumb);
        assert!(crumbs.count() >= 4, "{geometry}");
        // Back over what one fell down from.
        scene.set_flying(true);
        let end = scene.feet();
        scene.teleport(ChartPoint::new(end.chart, end.pos.with_y(HIGH_M)));
        let mut legs = 0;
        while let Some(way) = scene.way_back() {
            scene.aim(way.heading_rad, 0.0);
            let walk = Actions {
                forward: 1.0,
                ..Actions::default()
            };
            steps(&mut scene, 6, &walk);
            legs += 1;
            assert!(legs < 400, "{geometry}: {way:?}");
        }
        let level = |point: ChartPoint| ChartPoint::new(point.chart, point.pos.with_y(0.0));
        let eye = Eye {
            point: level(begun),
            ..Eye::default()
        };
        let there = level(scene.feet());
        let off_m = scene.strategy().distance_m(eye.point, there, &eye);
        // The first one lay where the crosshair met the ground.
        assert!(off_m < 13.0, "{geometry}: {off_m}");
    }
}

/// One goes on into a dead end, back, and another way from the third on.
#[test]
fn a_way_that_leaves_another_leads_back_to_it_and_not_over_land() {
    let mut scene = scene(Geometry::Euclidean);
    scene.set_npcs(NpcMode::Off);
    scene.set_flying(true);
    let at = |x: f64, z: f64| ChartPoint::a(DVec3::new(x, HIGH_M, z));
    let dead_end = (0..8).map(|step| at(7.0 * f64::from(step), 0.0));
    let branch = (1..6).map(|step| at(14.0, 7.0 * f64::from(step)));
    for place in dead_end.chain(branch) {
        assert!(scene.put_up(Item::Crumb, place, 0.0, ""));
    }
    scene.teleport(at(14.0, 35.0));
    let mut legs = 0;
    while let Some(way) = scene.way_back() {
        let feet = scene.feet().pos;
        let on_way = (feet.x - 14.0).abs() < 2.5 || feet.z.abs() < 2.5 && feet.x < 16.0;
        assert!(on_way, "{feet}");
        let ahead = DVec3::new(way.heading_rad.cos(), 0.0, way.heading_rad.sin());
        scene.teleport(scene.feet().moved(ahead));
        legs += 1;
        assert!(legs < 80, "{way:?} {feet}");
    }
    assert!(scene.feet().pos.with_y(0.0).length() < 6.0);
}

#[test]
fn with_one_button_held_the_other_still_takes_up() {
    let mut scene = scene(Geometry::Euclidean);
    scene.set_npcs(NpcMode::Off);
    steps(&mut scene, 30, &Actions::default());
    scene.aim(0.3, -0.9);
    let slots = scene.inventory().slots();
    let is_lamp =
        |slot: &Option<antipode_scene::Stack>| slot.is_some_and(|it| it.item == Item::Lamp);
    let slot = slots.iter().position(is_lamp).map(|place| place as u8);
    let put = Actions {
        slot,
        primary: true,
        ..Actions::default()
    };
    steps(&mut scene, 1, &put);
    assert_eq!(scene.lamps().len(), 1);
    let take = Actions {
        secondary: true,
        ..put
    };
    steps(&mut scene, 2, &take);
    assert_eq!(scene.lamps().len(), 0);
}
