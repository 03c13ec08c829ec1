//! Seeds: they grow into trees of the land where they are planted, by the days of the world; and those stand, are felled and
//! kept like any other.

use std::sync::Arc;

use antipode_geometry::{ChartPoint, Geometry};
use antipode_scene::{Actions, Generator, Hint, Item, Mode, Scene, WorldSetup};
use antipode_storage::{Batch, PlaceRecord, PlantedRecord, Record, RecordKind, WorldStore};
use glam::DVec3;

use crate::common::{LIMIT, scene, setup, steps};

/// A day of the world, seconds.
const DAY_S: f64 = 600.0;

fn press() -> Actions {
    Actions {
        primary: true,
        ..Actions::default()
    }
}

/// Takes seeds in hand and plants one two metres ahead.
fn plant(scene: &mut Scene) {
    let slots = scene.inventory().slots();
    let slot = slots
        .iter()
        .position(|slot| slot.is_some_and(|it| it.item == Item::Seed));
    let choose = Actions {
        slot: Some(slot.unwrap() as u8),
        ..Actions::default()
    };
    scene.aim(0.0, -0.7);
    steps(scene, 1, &choose);
    steps(scene, 1, &press());
    steps(scene, 1, &Actions::default());
    assert!(scene.settle(LIMIT));
}

fn planted(scene: &Scene) -> (usize, f64) {
    let plants = scene.probe().plants;
    plants.map_or((0, 0.0), |it| (it.planted, it.planted_m))
}

/// Goes where the land is level for some metres ahead.
fn go_where_it_is_level(scene: &mut Scene) {
    let feet = scene.feet();
    let height_m = |at: DVec3| scene.field().surface_height(feet.chart, at.x, at.z);
    let uneven_m = |at: &DVec3| {
        let heights: Vec<_> = (0..9)
            .map(|n| {
                height_m(*at + DVec3::new(f64::from(n % 3) * 1.5, 0.0, f64::from(n / 3) - 1.0))
            })
            .collect();
        let most = heights.iter().copied().fold(f64::MIN, f64::max);
        most - heights.iter().copied().fold(f64::MAX, f64::min)
    };
    let all = (0..900)
        .map(|n| feet.pos + DVec3::new(f64::from(n % 30) - 14.5, 0.0, f64::from(n / 30) - 14.5));
    let at = all
        .min_by(|a, b| uneven_m(a).total_cmp(&uneven_m(b)))
        .unwrap();
    let place = ChartPoint::new(feet.chart, at.with_y(height_m(at) + 0.05));
    scene.teleport(place);
    assert!(scene.settle(LIMIT));
    steps(scene, 30, &Actions::default());
}

#[test]
fn a_seed_is_planted_and_grows_by_the_days_of_the_world() {
    for geometry in Geometry::ALL {
        let mut scene = scene(geometry);
        assert_eq!(planted(&scene), (0, 0.0));
        go_where_it_is_level(&mut scene);
        let seeds = scene.inventory().count(Item::Seed);
        plant(&mut scene);
        let hints = scene.take_hints();
        let (count, sprout_m) = planted(&scene);
        assert_eq!(count, 1, "{geometry:?}: {hints:?}");
        assert!((0.1..1.2).contains(&sprout_m), "{geometry:?}: {sprout_m} m");
        assert_eq!(scene.inventory().count(Item::Seed), seeds - 1);
        assert_eq!(scene.probe().chunks.edited, 0, "no ground was changed");
        // A third of a day.
        steps(
            &mut scene,
            (0.2 * DAY_S * 60.0) as usize,
            &Actions::default(),
        );
        assert!(scene.settle(LIMIT));
        let (count, young_m) = planted(&scene);
        assert!(
            count == 1 && young_m > 1.5 * sprout_m,
            "{geometry:?}: {sprout_m} m, then {young_m} m"
        );
    }
}

#[test]
fn nothing_is_planted_beside_a_tree_or_out_of_reach_and_it_is_said() {
    let mut scene = scene(Geometry::Euclidean);
    plant(&mut scene);
    let seeds = scene.inventory().count(Item::Seed);
    plant(&mut scene);
    assert_eq!(planted(&scene).0, 1, "one stands there already");
    assert!(scene.take_hints().contains(&Hint::NoPlaceFor(Item::Seed)));
    scene.aim(0.0, 1.0);
    steps(&mut scene, 1, &press());
    assert_eq!(planted(&scene).0, 1, "that is the sky");
    // Faster than a worker shows what was planted.
    scene.aim(1.6, -0.7);
    for _ in 0..4 {
        scene.step(&press());
        scene.step(&Actions::default());
    }
    assert!(planted(&scene).0 <= 2, "one beside another");
    assert_eq!(
        scene.inventory().count(Item::Seed) + planted(&scene).0 as u32 - 1,
        seeds
    );
}

fn gathering() -> WorldSetup {
    WorldSetup {
        mode: Mode::Gathering,
        generator: Generator::OneBiome,
        ..setup(Geometry::Euclidean)
    }
}

/// A kept world in which trees were planted so many days ago, two metres ahead and then four metres apart.
fn kept(dir: &std::path::Path, days: &[f64]) -> (Scene, ChartPoint) {
    let here = dir.join("world");
    let setup = gathering();
    let feet = {
        let mut scene = Scene::open(setup.clone(), None).unwrap();
        assert!(scene.wait_for_step(LIMIT));
        steps(&mut scene, 60, &Actions::default());
        scene.feet()
    };
    let field = Scene::open(setup.clone(), None).unwrap();
    let store = WorldStore::create(&here, &setup.to_meta()).unwrap();
    let records = days.iter().zip(0..).map(|(days, n)| {
        let at = feet.pos + DVec3::new(2.0 + 4.0 * f64::from(n), 0.0, 0.0);
        let y = field.field().surface_height(feet.chart, at.x, at.z);
        let record = PlantedRecord {
            place: PlaceRecord {
                chart: feet.chart.number(),
                pos: at.with_y(y - 0.04).to_array(),
            },
            species: 1,
            since_s: -days * DAY_S,
            felled_s: None,
        };
        let key = RecordKind::Planted.numbered(n as u32 + 1);
        (key, Some(Record::Planted(record)))
    });
    let batch = Batch {
        records: records.collect(),
        ..Batch::default()
    };
    store.commit(&batch).unwrap();
    drop(store);
    (open(&here), feet)
}

fn open(here: &std::path::Path) -> Scene {
    let store = WorldStore::open(here).unwrap();
    let setup = WorldSetup::from_meta(&store.meta(), 2).unwrap();
    let mut scene = Scene::open(setup, Some(Arc::new(store))).unwrap();
    assert!(scene.wait_for_step(LIMIT) && scene.settle(LIMIT));
    scene
}

#[test]
fn what_was_planted_is_kept_as_old_as_it_is_and_felled_like_any_tree() {
    let dir = tempfile::tempdir().unwrap();
    let (mut scene, _) = kept(dir.path(), &[3.0, 10.0]);
    let (count, tallest_m) = planted(&scene);
    assert_eq!(count, 2);
    assert!(
        (9.0..14.0).contains(&tallest_m),
        "an old oak: {tallest_m} m"
    );
    let plants = scene.probe().plants.unwrap();
    assert_eq!(plants.near["oak"], 2);
    // The first stands two metres ahead: a grown oak. Who goes on leaves its stump all the same.
    scene.aim(0.0, -0.1);
    steps(&mut scene, 1, &Actions::default());
    assert_eq!(scene.probe().plants.unwrap().ahead, Some("oak"));
    for _ in 0..1000 {
        steps(&mut scene, 1, &press());
        if planted(&scene).0 == 1 {
            break;
        }
    }
    steps(&mut scene, 60, &press());
    steps(&mut scene, 340, &Actions::default());
    let plants = scene.probe().plants.unwrap();
    assert_eq!((plants.planted, plants.falling), (1, 0));
    assert_eq!(plants.near.get("stump"), Some(&1));
    let drops = scene.probe().drops;
    assert!(drops.iter().any(|it| it.stack.item == Item::Log));
    scene.close().unwrap();

    // Days later the stump is that of the tree that was felled.
    let here = dir.path().join("world");
    let store = WorldStore::open(&here).unwrap();
    let mut batch = Batch::default();
    for (id, record) in records_of_store(&store) {
        let earlier = PlantedRecord {
            since_s: record.since_s - 10.0 * DAY_S,
            felled_s: record.felled_s.map(|felled_s| felled_s - 10.0 * DAY_S),
            ..record
        };
        let key = RecordKind::Planted.numbered(id);
        batch.records.insert(key, Some(Record::Planted(earlier)));
    }
    store.commit(&batch).unwrap();
    drop(store);
    let again = open(&here);
    let plants = again.probe().plants.unwrap();
    assert_eq!((plants.planted, plants.near["oak"]), (1, 1));
    assert_eq!(plants.near.get("stump"), Some(&1), "it stays felled");
    assert_eq!(again.probe().chunks.edited, 0);
}

#[test]
fn what_was_planted_falls_when_its_ground_is_dug_away() {
    let dir = tempfile::tempdir().unwrap();
    let (mut scene, _) = kept(dir.path(), &[0.9]);
    assert_eq!(planted(&scene).0, 1);
    // At the ground beside it.
    scene.aim(0.35, -0.65);
    for _ in 0..600 {
        scene.step(&press());
        assert!(scene.settle(LIMIT));
        if planted(&scene).0 == 0 {
            break;
        }
    }
    assert_eq!(planted(&scene).0, 0, "it stands on nothing");
    steps(&mut scene, 400, &Actions::default());
    let near = scene.probe().plants.map(|it| it.near);
    assert!(near.is_none_or(|near| !near.contains_key("stump")));
    scene.close().unwrap();
    assert!(
        records_of(&dir.path().join("world")).is_empty(),
        "nothing is left of it"
    );
}

/// Records of others: numbers that are none, kinds that there are not, places out of this world.
#[test]
fn what_cannot_have_been_planted_is_left_out() {
    let dir = tempfile::tempdir().unwrap();
    let here = dir.path().join("world");
    let store = WorldStore::create(&here, &gathering().to_meta()).unwrap();
    let place = |pos: [f64; 3], chart: u128| PlaceRecord { chart, pos };
    let good = PlantedRecord {
        place: place([3.0, 0.0, 3.0], 0),
        species: 1,
        since_s: 0.0,
        felled_s: None,
    };
    let bad = [
        PlantedRecord {
            species: 200,
            ..good.clone()
        },
        PlantedRecord {
            species: 32,
            ..good.clone()
        },
        PlantedRecord {
            place: place([f64::NAN, 0.0, 0.0], 0),
            ..good.clone()
        },
        PlantedRecord {
            place: place([1e300, 0.0, 0.0], 0),
            ..good.clone()
        },
        PlantedRecord {
            place: place([0.0; 3], 77),
            ..good.clone()
        },
        PlantedRecord {
            since_s: f64::NAN,
            felled_s: None,
            ..good.clone()
        },
    ];
    // Of those the far one, the last and the good one can be.
    let all = bad.into_iter().chain([good]).zip(1..);
    let records = all.map(|(record, n)| {
        let key = RecordKind::Planted.numbered(n);
        (key, Some(Record::Planted(record)))
    });
    let batch = Batch {
        records: records.collect(),
        ..Batch::default()
    };
    store.commit(&batch).unwrap();
    drop(store);
    let mut scene = open(&here);
    // What lies too far out is at the edge of the world; two are at one place, which only a file can say.
    assert_eq!(planted(&scene).0, 3);
    go_where_it_is_level(&mut scene);
    assert_eq!(scene.inventory_mut().give(Item::Seed, 3), 0);
    plant(&mut scene);
    assert_eq!(planted(&scene).0, 4, "{:?}", scene.take_hints());
    scene.close().unwrap();
    let ids: Vec<u32> = records_of(&here).into_iter().map(|(id, _)| id).collect();
    let is_new = ids.last().is_some_and(|id| *id > 7);
    assert!(
        ids.len() == 8 && is_new,
        "a record has taken another's number: {ids:?}"
    );
}

/// What a save has of what was planted.
fn records_of(here: &std::path::Path) -> Vec<(u32, PlantedRecord)> {
    records_of_store(&WorldStore::open(here).unwrap())
}

fn records_of_store(store: &WorldStore) -> Vec<(u32, PlantedRecord)> {
    let known = store.records().unwrap().known;
    let planted = known.into_iter().filter_map(|(key, record)| match record {
        Record::Planted(it) => Some((key.id, it)),
        _ => None,
    });
    planted.collect()
}
