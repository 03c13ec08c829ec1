//! What digging yields, and the way back from a stroke: what a player sees of them.

use antipode_geometry::Geometry;
use antipode_scene::tuning::FULL_HEALTH;
use antipode_scene::{Actions, BrushShape, Choice, Hint, Kind, NotUndone, Scene};

use crate::common::{scene, steps};
use glam::DVec3;

fn dig() -> Actions {
    Actions {
        slot: Some(3),
        primary: true,
        ..Actions::default()
    }
}

fn undo(scene: &mut Scene) -> Vec<Hint> {
    let undo = Actions {
        undo: true,
        ..Actions::default()
    };
    scene.take_hints();
    steps(scene, 1, &undo);
    steps(scene, 2, &Actions::default());
    scene.take_hints()
}

#[test]
fn a_stroke_yields_what_was_there_and_undone_gives_it_back() {
    for geometry in Geometry::ALL {
        let mut scene = scene(geometry);
        scene.aim(0.3, -0.9);
        steps(&mut scene, 2, &Actions::default());
        let height = scene.ground_height();
        assert!(scene.probe().terrain.dug.is_empty() && scene.heaps_shown().is_empty());

        steps(&mut scene, 30, &dig());
        steps(&mut scene, 1, &Actions::default());
        let dug: f64 = scene.probe().terrain.dug.values().sum();
        assert!(dug > 1.0, "{geometry}: {dug}");
        let shown = scene.heaps_shown();
        assert!(shown[0].m3 > 0.5 && shown[0].m3 <= dug, "{shown:?}");
        let first = scene.probe().terrain.dug;

        // A second stroke is shown by itself and counted with the first.
        scene.aim(1.4, -0.9);
        steps(&mut scene, 10, &dig());
        steps(&mut scene, 1, &Actions::default());
        let both: f64 = scene.probe().terrain.dug.values().sum();
        let second: f64 = scene.heaps_shown().iter().map(|heap| heap.m3).sum();
        assert!(
            both > dug && second <= both - dug + 1e-6,
            "{second} of {both}"
        );

        assert_eq!(undo(&mut scene), [Hint::Undone]);
        let left = scene.probe().terrain.dug;
        for (kind, m3) in &first {
            assert!((left[kind] - m3).abs() < 1e-6, "{kind}: {left:?}");
        }
        assert_eq!(undo(&mut scene), [Hint::Undone]);
        assert!(scene.probe().terrain.dug.is_empty());
        assert_eq!(scene.probe().chunks.edited, 0);
        let none = NotUndone::NoneLeft;
        assert_eq!(undo(&mut scene), [Hint::NotUndone(none)]);
        assert!(scene.ground_height().is_some() && height.is_some());
    }
}

#[test]
fn who_stands_in_a_pit_is_lifted_out_where_its_ground_returns() {
    for geometry in Geometry::ALL {
        let mut scene = scene(geometry);
        let top = scene.feet().pos.y;
        scene.aim(0.3, -1.5);
        steps(&mut scene, 120, &dig());
        steps(&mut scene, 60, &Actions::default());
        assert!(scene.feet().pos.y < top - 1.0, "{geometry}: in the pit");
        assert_eq!(undo(&mut scene), [Hint::Undone]);
        steps(&mut scene, 60, &Actions::default());
        let feet = scene.feet().pos.y;
        assert!((feet - top).abs() < 0.3, "{geometry}: {feet} m of {top} m");
    }
}

/// Where one began, one may have dug a shaft; who stands up again there does not fall into it.
#[test]
fn who_dies_stands_up_beside_the_shaft_that_he_dug_where_he_began() {
    for geometry in Geometry::ALL {
        let mut scene = scene(geometry);
        let start = scene.feet();
        scene.aim(0.3, -1.5);
        steps(&mut scene, 900, &dig());
        let deep_m = start.pos.y - scene.feet().pos.y;
        assert!(deep_m > 6.0, "{geometry}: {deep_m} m");
        scene.teleport(start.moved(DVec3::new(0.0, 60.0, 0.0)));
        while !scene.is_dead() {
            steps(&mut scene, 1, &Actions::default());
        }
        while scene.is_dead() {
            steps(&mut scene, 1, &Actions::default());
        }
        steps(&mut scene, 120, &Actions::default());
        let feet = scene.feet().pos;
        let off_m = (feet - start.pos).with_y(0.0).length();
        let surface_m = scene.field().surface_height(start.chart, feet.x, feet.z);
        assert!((1.0..36.0).contains(&off_m), "{geometry}: {off_m} m off");
        assert!(
            (feet.y - surface_m).abs() < 2.0,
            "{geometry}: {feet} at {surface_m} m"
        );
        assert_eq!(scene.health(), FULL_HEALTH, "{geometry}: unhurt");
    }
}

#[test]
fn shapes_and_kinds_are_chosen_without_the_console() {
    let mut scene = scene(Geometry::Euclidean);
    scene.aim(0.3, -0.9);
    let choose = |shape_step, kind_step, take_kind| Actions {
        shape_step,
        kind_step,
        take_kind,
        ..Actions::default()
    };
    assert_eq!(scene.brush_chosen(), None);
    steps(&mut scene, 1, &choose(1, 0, false));
    assert_eq!(scene.brush().shape, BrushShape::Box);
    assert_eq!(scene.brush_chosen(), Some(Choice::Shape));
    steps(&mut scene, 1, &choose(0, -1, false));
    assert_eq!(scene.brush().kind, Some(Kind::Wood));
    assert_eq!(scene.brush_chosen(), Some(Choice::Kind));

    steps(&mut scene, 1, &choose(0, 0, true));
    let ahead = scene.probe().terrain.kind_ahead.unwrap();
    assert_eq!(scene.probe().marker.kind, Some(ahead));
    scene.aim(0.3, 1.4);
    steps(&mut scene, 1, &choose(0, 0, true));
    assert_eq!(scene.brush().kind, None, "of the sky nothing is built");
    steps(&mut scene, 130, &Actions::default());
    assert_eq!(scene.brush_chosen(), None);
}
