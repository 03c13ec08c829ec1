//! Gathering worlds: what is dug can be built with and made into things, and no more than that.

use std::collections::BTreeMap;
use std::sync::Arc;

use antipode_geometry::Geometry;
use antipode_scene::inventory::SLOTS;
use antipode_scene::{
    Actions, BrushShape, Heap, Hint, Item, Kind, Mode, Recipe, Scene, Stack, WorldSetup,
};
use antipode_storage::WorldStore;

use crate::common::{LIMIT, setup, steps};

fn gathering(geometry: Geometry) -> WorldSetup {
    WorldSetup {
        mode: Mode::Gathering,
        ..setup(geometry)
    }
}

fn scene(geometry: Geometry) -> Scene {
    let mut scene = Scene::open(gathering(geometry), None).unwrap();
    assert!(scene.wait_for_step(LIMIT));
    scene
}

fn dig() -> Actions {
    Actions {
        primary: true,
        ..Actions::default()
    }
}

fn build() -> Actions {
    Actions {
        secondary: true,
        ..Actions::default()
    }
}

fn all_m3(scene: &Scene) -> f64 {
    scene.probe().stock.unwrap().values().sum()
}

fn used_up(hints: &[Hint]) -> usize {
    let is = |hint: &&Hint| matches!(hint, Hint::UsedUp(_));
    hints.iter().filter(is).count()
}

#[test]
fn one_begins_with_little_and_in_a_creative_world_with_everything() {
    let carried = |scene: &Scene| scene.inventory().slots().iter().flatten().count();
    let mut creative = Scene::open(setup(Geometry::Euclidean), None).unwrap();
    assert_eq!(carried(&creative), Item::ALL.len());
    assert_eq!(creative.probe().mode, "creative");
    assert!(creative.stock().is_none() && !creative.give_ground(Kind::Coal, 99.0));
    let recipe = Recipe::of(Item::Lamp).remove(0);
    assert!(!creative.can_make(&recipe) && !creative.make(&recipe));

    let scene = scene(Geometry::Euclidean);
    assert_eq!(scene.inventory().held(), Some(Item::PickaxeWood));
    // A pickaxe, lamps, and breadcrumbs, which nobody makes.
    assert_eq!(carried(&scene), 3);
    let probe = scene.probe();
    assert_eq!(
        (probe.mode, probe.stock),
        ("gathering", Some(BTreeMap::default()))
    );
}

#[test]
fn building_spends_what_was_dug_and_ends_with_it_in_words() {
    for geometry in Geometry::ALL {
        let mut scene = scene(geometry);
        scene.aim(0.3, -0.9);
        steps(&mut scene, 2, &Actions::default());
        scene.take_hints();
        steps(&mut scene, 5, &build());
        assert_eq!(scene.take_hints(), [Hint::UsedUp(None)], "{geometry}");
        assert_eq!(scene.probe().chunks.edited, 0);

        steps(&mut scene, 40, &dig());
        steps(&mut scene, 1, &Actions::default());
        let dug = all_m3(&scene);
        let shown = scene.heaps_shown();
        let stock = *scene.stock().unwrap();
        let is_told = |heap: &Heap| (heap.m3 - stock.of(heap.kind)).abs() < 1e-6;
        assert!(!shown.is_empty() && shown.iter().all(is_told), "{shown:?}");
        let terrain = scene.probe().terrain;
        let told = terrain.dug.values().sum::<f64>() - terrain.built.values().sum::<f64>();
        assert!(dug > 2.0 && (dug - told).abs() < 1e-6, "{dug} {told}");

        // A tower before the feet: more than there is to build with.
        scene.aim(2.5, -0.7);
        scene.take_hints();
        steps(&mut scene, 400, &build());
        assert_eq!(used_up(&scene.take_hints()), 1, "{geometry}");
        let built = scene.probe().terrain.built;
        steps(&mut scene, 5, &build());
        assert_eq!(scene.probe().terrain.built, built);
        let left = all_m3(&scene);
        assert!(left < 0.4 * dug, "{geometry}: {left} of {dug}");
    }
}

#[test]
fn a_wooden_pickaxe_leaves_copper_and_says_so_and_iron_digs_it() {
    let mut scene = scene(Geometry::Euclidean);
    assert!(scene.give_ground(Kind::Copper, 500.0));
    scene.aim(0.3, -0.9);
    scene.inventory_mut().put(0, one(Item::PickaxeDiamond));
    steps(&mut scene, 60, &build());
    steps(&mut scene, 1, &Actions::default());
    scene.inventory_mut().put(0, one(Item::PickaxeWood));
    let before = scene.probe().stock.unwrap()["copper"];
    assert!(before < 490.0, "{before}");
    scene.take_hints();
    assert_eq!(scene.probe().terrain.kind_ahead, Some("copper"));
    steps(&mut scene, 60, &dig());
    let hints = scene.take_hints();
    assert!(hints.contains(&Hint::TooHard(Kind::Copper)), "{hints:?}");
    assert_eq!(hints.len(), 1, "{hints:?}");
    let with_wood = scene.probe().stock.unwrap()["copper"] - before;
    steps(&mut scene, 1, &Actions::default());
    scene.inventory_mut().put(0, one(Item::PickaxeIron));
    steps(&mut scene, 60, &dig());
    steps(&mut scene, 1, &Actions::default());
    let with_iron = scene.probe().stock.unwrap()["copper"] - before;
    assert_eq!(scene.take_hints(), []);
    assert!(
        with_wood.abs() < 0.05 && with_iron > 1.0,
        "{with_wood} {with_iron}"
    );
}

#[test]
fn only_who_has_no_coal_is_told_that_he_dug_deep_in_vain() {
    for coal_m3 in [0.0, 50.0] {
        let mut scene = scene(Geometry::Euclidean);
        scene.give_ground(Kind::Slate, 400.0);
        scene.give_ground(Kind::Coal, coal_m3);
        scene.inventory_mut().put(0, one(Item::PickaxeDiamond));
        scene.set_built_kind(Some(Kind::Slate));
        scene.aim(0.3, -0.9);
        let mut told = 0;
        for _ in 0..6 {
            steps(&mut scene, 60, &build());
            steps(&mut scene, 60, &dig());
            let hints = scene.take_hints();
            told += hints
                .iter()
                .filter(|hint| **hint == Hint::NoCoalYet)
                .count();
        }
        let dug = scene.probe().terrain.dug["slate"];
        assert!(dug > 60.0, "{dug} m3 of slate");
        assert_eq!(told, usize::from(coal_m3 == 0.0));
    }
}

fn one(item: Item) -> Stack {
    Stack { item, count: 1 }
}

#[test]
fn things_are_made_of_ground_and_a_full_backpack_drops_them() {
    let mut scene = scene(Geometry::Euclidean);
    let recipe = Recipe::of(Item::PickaxeIron).remove(0);
    assert!(!scene.make(&recipe) && scene.inventory().count(Item::PickaxeIron) == 0);
    for (kind, m3) in &recipe.parts {
        assert!(scene.give_ground(*kind, 2.5 * m3));
    }
    assert!(scene.can_make(&recipe) && scene.make(&recipe));
    assert_eq!(scene.inventory().count(Item::PickaxeIron), 1);
    assert_eq!(scene.take_hints(), [Hint::Made(Item::PickaxeIron, 1)]);
    for slot in 0..SLOTS {
        scene.inventory_mut().put(slot, one(Item::Gun));
    }
    assert!(scene.make(&recipe) && !scene.make(&recipe));
    assert_eq!(scene.inventory().count(Item::PickaxeIron), 0);
    let drops = scene.probe().drops;
    assert_eq!(drops.len(), 1);
    let spent = recipe.parts.iter().map(|(kind, m3)| {
        let left = scene.stock().unwrap().of(*kind);
        (left - 0.5 * m3).abs()
    });
    assert!(spent.fold(0.0, f64::max) < 1e-9);
}

/// The brush that levels moves ground and needs none.
#[test]
fn ground_is_levelled_without_any_in_store() {
    let mut scene = scene(Geometry::Euclidean);
    let flatten = BrushShape::ALL
        .iter()
        .position(|it| *it == BrushShape::Flatten);
    let choose = Actions {
        shape_step: flatten.unwrap() as i32,
        ..Actions::default()
    };
    scene.aim(0.3, -0.6);
    steps(&mut scene, 1, &choose);
    steps(&mut scene, 60, &dig());
    steps(&mut scene, 1, &Actions::default());
    assert!(scene.probe().chunks.edited > 0);
    assert!(scene.take_hints().is_empty() && all_m3(&scene) >= 0.0);
}

#[test]
fn what_was_gathered_and_the_mode_are_kept_with_the_last_stroke_before_leaving() {
    let dir = tempfile::tempdir().unwrap();
    let here = dir.path().join("world");
    let setup = gathering(Geometry::Euclidean);
    let store = WorldStore::create(&here, &setup.to_meta()).unwrap();
    let mut scene = Scene::open(setup, Some(Arc::new(store))).unwrap();
    assert!(scene.wait_for_step(LIMIT));
    scene.aim(0.3, -0.9);
    assert!(scene.give_ground(Kind::Crystal, 12.0));
    steps(&mut scene, 20, &dig());
    // Nobody waits for these strokes.
    (0..20).for_each(|_| scene.step(&dig()));
    scene.close().unwrap();

    let open = || {
        let store = WorldStore::open(&here).unwrap();
        let setup = WorldSetup::from_meta(&store.meta(), 2).unwrap();
        assert_eq!(setup.mode, Mode::Gathering);
        let mut scene = Scene::open(setup, Some(Arc::new(store))).unwrap();
        assert!(scene.wait_for_step(LIMIT));
        scene
    };
    let mut again = open();
    let kept = again.probe().stock.unwrap();
    assert!((kept["crystal"] - 12.0).abs() < 1e-9, "{kept:?}");
    // As much is missing in the pit: filled, it takes what it gave.
    let dug = all_m3(&again) - 12.0;
    let flat = Scene::open(gathering(Geometry::Euclidean), None).map(|mut flat| {
        assert!(flat.wait_for_step(LIMIT));
        flat.aim(0.3, -0.9);
        steps(&mut flat, 40, &dig());
        steps(&mut flat, 1, &Actions::default());
        all_m3(&flat)
    });
    assert!((dug - flat.unwrap()).abs() < 0.05 * dug, "{dug}");
    // What is made is spent in the save, too.
    let recipe = Recipe::of(Item::Lamp).remove(0);
    for (kind, m3) in &recipe.parts {
        assert!(again.give_ground(*kind, *m3));
    }
    let lamps = again.inventory().count(Item::Lamp);
    assert!(again.make(&recipe));
    let before = again.probe().stock;
    again.close().unwrap();
    let last = open();
    assert_eq!(last.probe().stock, before);
    assert_eq!(
        last.inventory().count(Item::Lamp),
        lamps + recipe.made.count
    );
}

#[test]
fn who_digs_deep_without_finding_coal_is_told_once_where_it_lies() {
    let told = |first: Kind| {
        let mut scene = scene(Geometry::Euclidean);
        scene.inventory_mut().put(0, one(Item::PickaxeDiamond));
        scene.aim(0.3, -0.6);
        let mut told = 0;
        for kind in [first, Kind::Slate, Kind::Slate] {
            assert!(scene.give_ground(kind, 1000.0 - scene.stock().unwrap().of(kind)));
            // Of what there is most of.
            steps(&mut scene, 60, &build());
            steps(&mut scene, 60, &dig());
            steps(&mut scene, 1, &Actions::default());
            let hints = scene.take_hints().into_iter();
            told += hints.filter(|hint| *hint == Hint::NoCoalYet).count();
            assert!(scene.give_ground(kind, -0.9 * scene.stock().unwrap().of(kind)));
        }
        let dug = scene.probe().terrain.dug;
        assert!(dug["slate"] > 80.0, "{dug:?}");
        told
    };
    assert_eq!(told(Kind::Slate), 1);
    assert_eq!(told(Kind::Coal), 0, "coal was found");
}
