//! The stones where five squares meet: one bumps into them from each square, tools do not fell them, and saves know nothing of
//! them.

use std::sync::Arc;

use antipode_geometry::tiled::about_corner;
use antipode_geometry::{ChartId, ChartPoint, Eye, Geometry};
use antipode_plants::{Species, placed_near};
use antipode_scene::{Actions, Generator, Item, Scene, WorldSetup};
use antipode_storage::{RecordKind, WorldStore};
use glam::{DVec2, DVec3};

use crate::common::figures::{SECOND, look_at};
use crate::common::{LIMIT, setup, steps};

fn squares(radius_m: f64) -> WorldSetup {
    WorldSetup {
        generator: Generator::Planted,
        radius_m,
        seed: 7,
        ..setup(Geometry::HyperbolicWorld)
    }
}

fn open(setup: WorldSetup) -> Scene {
    let mut scene = Scene::open(setup, None).unwrap();
    assert!(scene.wait_for_step(LIMIT));
    scene
}

/// The ground at a place so far from a corner of a square, on the way to its middle, metres of its chart.
fn before_corner(scene: &Scene, (chart, corner): (ChartId, u8), away_m: f64) -> ChartPoint {
    let half_m = scene.strategy().domain(chart).half_width_m();
    let out = DVec2::from_angle(f64::from(2 * corner + 1) * std::f64::consts::FRAC_PI_4);
    let at = out * (half_m * std::f64::consts::SQRT_2 - away_m);
    let y = scene.field().surface_height(chart, at.x, at.y);
    ChartPoint::new(chart, DVec3::new(at.x, y + 0.05, at.y))
}

/// The root of the stone at a corner of the first square.
fn stone_at(scene: &Scene, corner: u8) -> ChartPoint {
    let about = before_corner(scene, (ChartId::FIRST, corner), 0.0);
    let mut stones = placed_near(scene.field(), about, 0.5);
    let (root, species, _) = stones.next().expect("a stone is at the corner");
    assert_eq!(species, Species::CornerStone);
    root
}

/// Puts the player so far before a corner of a square, with his look at a point so high over the root of its stone.
fn stand_before(scene: &mut Scene, at: (ChartId, u8), root: ChartPoint, [away_m, up_m]: [f64; 2]) {
    let feet = before_corner(scene, at, away_m);
    scene.teleport(feet);
    assert!(scene.settle(LIMIT));
    look_at(scene, root.moved(DVec3::Y * up_m));
    steps(scene, 2, &Actions::default());
}

/// How far the feet are from the upright line through a root, metres.
fn away_m(scene: &Scene, root: ChartPoint) -> f64 {
    let level = |at: ChartPoint| ChartPoint::new(at.chart, at.pos.with_y(0.0));
    let (feet, root) = (level(scene.feet()), level(root));
    scene.strategy().distance_m(feet, root, &Eye::default())
}

fn primary() -> Actions {
    Actions {
        slot: Some(2),
        primary: true,
        ..Actions::default()
    }
}

/// Digs before a corner of a square, which one stands before, until its stone is gone; returns in how many strokes.
fn dig_away(scene: &mut Scene, at: (ChartId, u8)) -> usize {
    let foot = before_corner(scene, at, 0.6);
    for stroke in 1..=60 {
        look_at(scene, foot.moved(DVec3::Y * -0.3));
        steps(scene, SECOND / 2, &primary());
        steps(scene, 2, &Actions::default());
        assert!(scene.settle(LIMIT));
        let plants = scene.probe().plants.unwrap();
        if !plants.near.contains_key("corner stone") {
            return stroke;
        }
    }
    panic!("it still stands");
}

fn undo(scene: &mut Scene, strokes: usize) {
    for _ in 0..strokes {
        let undo = Actions {
            undo: true,
            ..Actions::default()
        };
        steps(scene, 1, &undo);
        steps(scene, 2, &Actions::default());
        assert!(scene.settle(LIMIT));
    }
}

#[test]
fn from_each_of_five_squares_one_sees_what_it_is_and_bumps_into_it() {
    for radius_m in [30.152, 60.305] {
        let mut scene = open(squares(radius_m));
        let root = stone_at(&scene, 0);
        let space = Arc::clone(scene.strategy());
        let about = about_corner(space.tiled().unwrap(), ChartId::FIRST, 0);
        assert_eq!(about.len(), 5);
        for at in about {
            stand_before(&mut scene, at, root, [2.0, 1.1]);
            let told = format!("{radius_m} {at:?} {:?}", scene.feet());
            let plants = scene.probe().plants.unwrap();
            assert_eq!(plants.ahead, Some("corner stone"), "{told}");
            assert_eq!(plants.near.get("corner stone"), Some(&1), "{told}");
            let ahead = Actions {
                forward: 1.0,
                ..Actions::default()
            };
            steps(&mut scene, 2 * SECOND, &ahead);
            let away_m = away_m(&scene, root);
            println!("{told}: {away_m} m");
            assert!((0.5..1.0).contains(&away_m), "{told}: {away_m} m");
        }
    }
}

/// How near to the upright line through a root one comes, straight ahead for two seconds, metres.
fn nearest_m(scene: &mut Scene, root: ChartPoint) -> f64 {
    let ahead = Actions {
        forward: 1.0,
        ..Actions::default()
    };
    let mut nearest_m = f64::INFINITY;
    for _ in 0..2 * SECOND {
        steps(scene, 1, &ahead);
        nearest_m = nearest_m.min(away_m(scene, root));
    }
    nearest_m
}

#[test]
fn a_tool_fells_no_corner_stone_and_it_is_there_again_with_its_ground() {
    let mut scene = open(squares(60.305));
    let root = stone_at(&scene, 0);
    // In a square that the stone is not of.
    let space = Arc::clone(scene.strategy());
    let at = about_corner(space.tiled().unwrap(), ChartId::FIRST, 0)[2];
    let stones = |scene: &Scene| {
        let plants = scene.probe().plants.unwrap();
        (plants.near.get("corner stone").copied(), plants.felled)
    };
    stand_before(&mut scene, at, root, [1.6, 1.4]);
    assert_eq!(scene.probe().plants.unwrap().ahead, Some("corner stone"));
    steps(&mut scene, 6 * SECOND, &primary());
    assert_eq!(stones(&scene), (Some(1), 0));
    let strokes = dig_away(&mut scene, at);
    assert_eq!(stones(&scene), (None, 0), "its ground is gone");
    let drops = scene.probe().drops;
    assert!(!drops.iter().any(|it| it.stack.item == Item::Stone));
    undo(&mut scene, strokes);
    assert_eq!(stones(&scene), (Some(1), 0), "its ground is there again");
    for at in about_corner(space.tiled().unwrap(), ChartId::FIRST, 0) {
        stand_before(&mut scene, at, root, [2.0, 1.1]);
        let nearest_m = nearest_m(&mut scene, root);
        assert!((0.5..1.0).contains(&nearest_m), "{at:?}: {nearest_m} m");
    }
}

#[test]
fn who_stands_where_a_corner_stone_comes_back_can_go_on() {
    for off in [DVec3::ZERO, DVec3::new(-0.3, 0.0, -0.1)] {
        let mut scene = open(squares(60.305));
        let root = stone_at(&scene, 0);
        stand_before(&mut scene, (ChartId::FIRST, 0), root, [1.6, 1.4]);
        let strokes = dig_away(&mut scene, (ChartId::FIRST, 0));
        scene.teleport(root.moved(off - DVec3::Y * 0.3));
        steps(&mut scene, SECOND, &Actions::default());
        undo(&mut scene, strokes);
        let plants = scene.probe().plants.unwrap();
        assert_eq!(plants.near.get("corner stone"), Some(&1));
        steps(&mut scene, SECOND, &Actions::default());
        println!("{} m", away_m(&scene, root));
        let begun = scene.feet();
        for turn in [0.0, 1.6, 3.1, 4.7] {
            scene.aim(turn, 0.0);
            let ahead = Actions {
                forward: 1.0,
                jump: true,
                ..Actions::default()
            };
            steps(&mut scene, SECOND, &ahead);
            println!("{turn}: {} m", away_m(&scene, root));
        }
        let gone_m = scene
            .strategy()
            .distance_m(begun, scene.feet(), &Eye::default());
        assert!(away_m(&scene, root) > 0.5 && gone_m > 0.3, "{gone_m}");
    }
}

#[test]
fn where_a_corner_stone_has_no_ground_nothing_is_in_the_way_from_any_square() {
    let mut scene = open(squares(60.305));
    let root = stone_at(&scene, 0);
    let space = Arc::clone(scene.strategy());
    let about = about_corner(space.tiled().unwrap(), ChartId::FIRST, 0);
    stand_before(&mut scene, about[2], root, [1.6, 1.4]);
    dig_away(&mut scene, about[2]);
    for at in about {
        stand_before(&mut scene, at, root, [2.0, 1.1]);
        let nearest_m = nearest_m(&mut scene, root);
        assert!(nearest_m < 0.3, "{at:?}: {nearest_m} m");
    }
}

#[test]
fn a_save_holds_nothing_of_corner_stones() {
    let dir = tempfile::tempdir().unwrap();
    let here = dir.path().join("world");
    let setup = squares(60.305);
    let store = WorldStore::create(&here, &setup.to_meta()).unwrap();
    let mut scene = Scene::open(setup, Some(Arc::new(store))).unwrap();
    assert!(scene.wait_for_step(LIMIT));
    let root = stone_at(&scene, 0);
    stand_before(&mut scene, (ChartId::FIRST, 0), root, [2.0, 1.0]);
    let near = |scene: &Scene| {
        let plants = scene.probe().plants.unwrap();
        plants.near.get("corner stone").copied()
    };
    assert_eq!(near(&scene), Some(1));
    scene.close().unwrap();

    let store = WorldStore::open(&here).unwrap();
    let known = store.records().unwrap().known;
    let is_of_plants = |kind| matches!(kind, RecordKind::Felled | RecordKind::Planted);
    assert!(!known.keys().any(|key| is_of_plants(key.kind)));
    let setup = WorldSetup::from_meta(&store.meta(), 2).unwrap();
    let mut again = Scene::open(setup, Some(Arc::new(store))).unwrap();
    assert!(again.wait_for_step(LIMIT) && again.settle(LIMIT));
    assert_eq!((near(&again), again.probe().chunks.edited), (Some(1), 0));
}
