//! Flags: planted, found again, named, taken up and kept.

use antipode_geometry::{ChartId, ChartPoint, Geometry};
use antipode_items::Item;
use antipode_scene::flag::LONGEST_NAME;
use antipode_scene::notice::Hint;
use antipode_scene::{Actions, NpcMode, Scene};
use glam::DVec3;

use crate::common::{scene, steps};

fn click(primary: bool) -> Actions {
    Actions {
        primary,
        secondary: !primary,
        ..Actions::default()
    }
}

fn press(scene: &mut Scene, primary: bool) {
    steps(scene, 1, &click(primary));
    steps(scene, 1, &Actions::default());
}

fn hold_flags(scene: &mut Scene) {
    let slots = scene.inventory().slots();
    let is_flag = |slot: &Option<antipode_scene::inventory::Stack>| {
        slot.is_some_and(|it| it.item == Item::Flag)
    };
    let slot = slots.iter().position(is_flag).unwrap();
    scene.inventory_mut().select(slot as u8);
    assert_eq!(scene.inventory().held(), Some(Item::Flag));
}

fn carried(scene: &Scene) -> u32 {
    let stacks = scene.inventory().slots().iter().flatten();
    let flags = stacks.filter(|stack| stack.item == Item::Flag);
    flags.map(|stack| stack.count).sum()
}

#[test]
fn a_flag_is_planted_named_and_taken_up_again_in_every_space() {
    for geometry in Geometry::ALL {
        let mut scene = scene(geometry);
        hold_flags(&mut scene);
        let first = carried(&scene);
        scene.aim(0.3, 1.2);
        press(&mut scene, true);
        assert!(
            scene.take_hints().contains(&Hint::NoPlaceFor(Item::Flag)),
            "{geometry}"
        );
        scene.aim(0.3, -0.5);
        press(&mut scene, true);
        let [planted] = &scene.flag_ways()[..] else {
            panic!("{geometry}: {:?}", scene.flag_ways());
        };
        assert_eq!((planted.name.as_str(), carried(&scene)), ("", first - 1));
        // The way there is the one that the player looked along.
        let off = (planted.heading_rad - 0.3).sin();
        assert!(off.abs() < 0.02, "{geometry}: {off}");
        assert!(
            (1.0..8.0).contains(&planted.distance_m),
            "{geometry}: {planted:?}"
        );
        assert_eq!(scene.take_flag_to_name(), None);
        // A click on it asks for its name and plants no other.
        press(&mut scene, true);
        let asked = scene.take_flag_to_name();
        assert_eq!(
            (asked, scene.flag_ways().len()),
            (Some(planted.id), 1),
            "{geometry}"
        );
        assert!(scene.name_flag(planted.id, "  Home "));
        assert_eq!(scene.probe().flags[0].name, "Home");
        press(&mut scene, false);
        assert_eq!(
            (scene.flag_ways().len(), carried(&scene)),
            (0, first),
            "{geometry}"
        );
        assert!(!scene.name_flag(planted.id, "gone"));
        press(&mut scene, false);
        assert!(
            scene.take_hints().contains(&Hint::NoneThere(Item::Flag)),
            "{geometry}"
        );
    }
}

#[test]
fn who_has_planted_the_last_flag_can_name_it_and_take_it_up_with_an_empty_hand() {
    let mut scene = scene(Geometry::Euclidean);
    hold_flags(&mut scene);
    scene.aim(0.3, -0.5);
    while carried(&scene) > 1 {
        assert!(scene.inventory_mut().take_from(6, false).is_some());
    }
    press(&mut scene, true);
    assert_eq!(
        (scene.inventory().held(), scene.flag_ways().len()),
        (None, 1)
    );
    press(&mut scene, true);
    let id = scene.flag_ways()[0].id;
    assert_eq!(scene.take_flag_to_name(), Some(id));
    press(&mut scene, false);
    assert_eq!((carried(&scene), scene.flag_ways().len()), (1, 0));
    // Nothing is told of an empty hand that points at the ground.
    scene.take_hints();
    assert!(scene.inventory_mut().take_from(9, true).is_some());
    scene.inventory_mut().select(9);
    press(&mut scene, false);
    press(&mut scene, true);
    assert_eq!(scene.take_hints(), []);
}

#[test]
fn a_flag_on_somebodys_shoulders_falls_to_the_ground() {
    let mut scene = scene(Geometry::Euclidean);
    hold_flags(&mut scene);
    let ahead = scene.feet().moved(DVec3::new(2.5, 0.0, 0.0));
    scene.set_npcs(NpcMode::Still);
    scene.spawn_bot(ahead, 0.0, false);
    scene.aim(0.0, -0.02);
    press(&mut scene, true);
    steps(&mut scene, 120, &Actions::default());
    let field = scene.field().clone();
    for flag in scene.probe().flags {
        let foot = ChartPoint::a(DVec3::from_array(flag.pos));
        assert!(field.sample(foot).abs() < 0.3, "{flag:?} over the ground");
    }
}

#[test]
fn a_flag_falls_when_the_ground_below_it_goes() {
    let mut scene = scene(Geometry::Euclidean);
    hold_flags(&mut scene);
    scene.aim(0.3, -0.5);
    press(&mut scene, true);
    let before = scene.probe().flags[0].pos[1];
    scene.inventory_mut().select(3);
    // Below the pole, so that the ground that it stands on is dug.
    steps(&mut scene, 240, &click(true));
    steps(&mut scene, 120, &Actions::default());
    let after = scene.probe().flags[0].pos[1];
    assert!(after < before - 0.5, "{before} {after}");
}

#[test]
fn flags_beyond_the_equator_are_found_along_the_ground() {
    let mut scene = scene(Geometry::Spherical);
    scene.set_flying(true);
    let rim_m = scene.strategy().domain(ChartId::FIRST).radius_m().unwrap();
    scene.teleport(ChartPoint::a(DVec3::new(rim_m - 4.0, 15.0, 0.0)));
    steps(&mut scene, 1, &Actions::default());
    let over = ChartPoint::a(DVec3::new(rim_m + 6.0, 9.0, 0.0));
    let over = scene.strategy().images(over, f64::INFINITY)[0].point;
    assert_ne!(over.chart, ChartId::FIRST);
    assert!(scene.spawn_flag(over, 0.0, "beyond"));
    let way = scene.flag_ways().remove(0);
    assert!(
        (way.distance_m - 10.0).abs() < 1e-6 && way.heading_rad.abs() < 1e-9,
        "{way:?}"
    );
}

#[test]
fn a_world_has_room_for_so_many_flags() {
    let mut scene = scene(Geometry::Euclidean);
    let at = scene.feet();
    let most = Item::Flag.stands().unwrap().most;
    for _ in 0..most {
        assert!(scene.spawn_flag(at, 0.0, ""));
    }
    assert!(!scene.spawn_flag(at, 0.0, ""));
    assert_eq!(scene.flag_ways().len(), most);
}

#[cfg(unix)]
#[test]
fn flags_are_kept_with_their_names_and_take_no_nonsense_from_a_save() {
    let (kept, mut scene) = crate::common::kept::Kept::new();
    let at = scene.feet().moved(DVec3::new(3.0, 0.0, -2.0));
    assert!(scene.spawn_flag(at, 1.25, "Überlingen 湖"));
    assert!(scene.needs_save());
    let before = scene.probe().flags;
    scene.close().unwrap();
    let scene = kept.open();
    assert_eq!(scene.probe().flags, before);
    scene.close().unwrap();
    let state = kept.alter(|state| {
        assert_eq!(state.flags[0].yaw.to_bits(), 1.25f64.to_bits());
        state.flags[0].name = format!("a\n{}", "x".repeat(9000));
        state.flags[0].yaw = f64::NAN;
    });
    assert_eq!(state.flags.len(), 1);
    let scene = kept.open();
    let name = &scene.probe().flags[0].name;
    assert!(
        name.starts_with("a xx") && name.chars().count() <= LONGEST_NAME,
        "{name}"
    );
    scene.close().unwrap();
}
