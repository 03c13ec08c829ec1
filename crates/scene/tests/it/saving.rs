//! When a world is saved, what is told of a save that fails, and what a save writes.
#![cfg(unix)]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;

use crate::common::kept::{Kept, build};
use crate::common::{LIMIT, steps};
use antipode_geometry::Geometry;
use antipode_scene::{Actions, Scene};
use antipode_storage::{Batch, LampRecord, Record, RecordKind, WORLD_FILE, WorldStore};

#[test]
fn a_failed_save_is_no_save_until_one_succeeds() {
    let (kept, mut scene) = Kept::new();
    steps(&mut scene, 3, &Actions::default());
    assert!(scene.needs_save());
    kept.take_away();
    scene.save();
    assert!(scene.wait_saved(LIMIT));
    assert!(!scene.is_saved() && scene.needs_save());
    assert!(scene.save_problem().is_some());
    assert_eq!(scene.take_notices().len(), 1);
    scene.save();
    assert!(scene.wait_saved(LIMIT));
    assert!(
        scene.take_notices().is_empty(),
        "the same failure is told once"
    );
    kept.bring_back();
    scene.save();
    assert!(scene.wait_saved(LIMIT));
    assert!(scene.is_saved() && !scene.needs_save() && scene.save_problem().is_none());
    scene.close().unwrap();
}

#[test]
fn an_edit_under_way_is_in_the_save_and_a_later_one_asks_for_another() {
    let (_kept, mut scene) = Kept::new();
    scene.aim(0.0, -0.6);
    scene.step(&build());
    scene.save();
    assert!(!scene.needs_save(), "the save waits for its batch");
    assert!(scene.wait_for_step(LIMIT) && scene.wait_saved(LIMIT));
    assert!(!scene.needs_save());
    scene.step(&build());
    assert!(scene.needs_save());
    scene.save();
    assert!(scene.wait_saved(LIMIT) && scene.is_saved());
    assert!(!scene.needs_save());
}

#[test]
fn a_world_that_is_not_kept_never_needs_a_save() {
    let mut scene = crate::common::scene(Geometry::Euclidean);
    scene.aim(0.0, -0.6);
    steps(&mut scene, 3, &build());
    assert!(!scene.needs_save());
    scene.close().unwrap();
}

#[test]
fn a_close_that_fails_gives_the_world_back_and_can_be_repeated() {
    let (kept, mut scene) = Kept::new();
    scene.aim(0.0, -0.6);
    steps(&mut scene, 5, &build());
    kept.take_away();
    let failure = scene.close().unwrap_err();
    assert!(!failure.to_string().is_empty());
    let mut scene = *failure.scene;
    assert!(scene.save_problem().is_some() && !scene.is_saved());
    steps(&mut scene, 5, &build());
    let (edited, feet) = (scene.probe().chunks.edited, scene.feet());
    assert!(edited > 0);
    kept.bring_back();
    scene.close().unwrap();
    let again = kept.open();
    assert_eq!((again.probe().chunks.edited, again.feet()), (edited, feet));
}

#[test]
fn while_a_script_walks_its_autosaves_are_committed() {
    let (kept, mut scene) = Kept::new();
    let walk = Actions {
        forward: 1.0,
        ..Actions::default()
    };
    // Four seconds: one autosave, whose end is taken by the waits of later steps.
    steps(&mut scene, 240, &walk);
    assert!(scene.wait_saved(LIMIT));
    let copy = kept.dir.path().join("copy");
    fs::create_dir(&copy).unwrap();
    fs::copy(kept.here().join(WORLD_FILE), copy.join(WORLD_FILE)).unwrap();
    let state = WorldStore::open(&copy).unwrap().state().unwrap();
    assert!(state.is_some_and(|state| state.simulated_s > 2.9));
}

/// The keys of the values that the last commit wrote, by the seals in the file: version, mark, kind, length of the key,
/// of the body, number of the commit, checksum, key.
fn written_last(kept: &Kept) -> Vec<String> {
    let bytes = fs::read(kept.here().join(WORLD_FILE)).unwrap();
    let mut commits = BTreeMap::<u64, BTreeSet<String>>::new();
    for at in 0..bytes.len() - 60 {
        let key = &bytes[at + 22..][..usize::from(bytes[at + 5]).min(30)];
        let is_key = key == b"world"
            || key
                .first()
                .is_some_and(|it| usize::from(*it) + 9 == key.len());
        if bytes[at + 2..].starts_with(b"Ap") && is_key {
            let commit = u64::from_le_bytes(bytes[at + 10..at + 18].try_into().unwrap());
            let key = String::from_utf8_lossy(key).replace(|it: char| !it.is_ascii_graphic(), "");
            commits.entry(commit).or_default().insert(key);
        }
    }
    let (_, last) = commits.pop_last().unwrap();
    last.into_iter().collect()
}

#[test]
fn a_step_of_walking_saves_the_player_and_the_time_and_nothing_of_a_hundred_thousand_others() {
    let lamp = |id: u32| {
        let pos = [f64::from(id % 300), 500.0, f64::from(id / 300)];
        let lamp = LampRecord { chart: 0, pos };
        (RecordKind::Lamp.numbered(id), Some(Record::Lamp(lamp)))
    };
    let walk = Actions {
        forward: 1.0,
        ..Actions::default()
    };
    for lamps in [0, 100_000] {
        let (kept, scene) = Kept::new();
        scene.close().unwrap();
        let store = WorldStore::open(&kept.here()).unwrap();
        let batch = Batch {
            records: (0..lamps).map(lamp).collect(),
            ..Batch::default()
        };
        store.commit(&batch).unwrap();
        drop(store);
        let mut again = kept.open();
        for _ in 0..2 {
            steps(&mut again, 20, &walk);
            again.save();
            assert!(again.wait_saved(LIMIT) && again.is_saved());
            assert_eq!(written_last(&kept), ["course", "player", "world"]);
        }
        let walked = again.feet();
        again.close().unwrap();
        let store = WorldStore::open(&kept.here()).unwrap();
        let known = store.records().unwrap().known;
        let here = (0..lamps).filter(|id| known.get(&lamp(*id).0) == lamp(*id).1.as_ref());
        assert_eq!(here.count(), lamps as usize, "those beyond the limit too");
        drop(store);
        assert_eq!(kept.open().feet(), walked);
    }
}

/// The keys of a kind in the save, in order.
fn numbers(kept: &Kept, kind: RecordKind) -> Vec<u32> {
    let known = WorldStore::open(&kept.here()).unwrap().records().unwrap();
    let keys = known.known.keys().filter(|key| key.kind == kind);
    keys.map(|key| key.id).collect()
}

#[test]
fn things_keep_their_numbers_and_what_is_gone_is_gone() {
    let (kept, mut scene) = Kept::new();
    let at = scene.feet();
    let beside = |x: f64| at.moved(glam::DVec3::new(x, 3.0, 0.0));
    for x in [4.0, 6.0, 8.0] {
        scene.spawn_bot(beside(x), 0.5, false);
        assert!(scene.spawn_lamp(beside(-x)));
    }
    assert!(scene.spawn_car(beside(12.0), 0.0) && scene.spawn_car(beside(20.0), 0.0));
    scene.inventory_mut().select(5);
    let throw = Actions {
        drop_one: true,
        ..Actions::default()
    };
    steps(&mut scene, 2, &throw);
    steps(&mut scene, 2, &Actions::default());
    scene.close().unwrap();
    assert_eq!(numbers(&kept, RecordKind::Figure), [0, 1, 2]);
    assert_eq!(numbers(&kept, RecordKind::Lamp), [0, 1, 2]);
    assert_eq!(numbers(&kept, RecordKind::Drop), [0, 1]);
    assert_eq!(numbers(&kept, RecordKind::Car), [0, 1]);
    let store = WorldStore::open(&kept.here()).unwrap();
    let gone = [
        RecordKind::Figure.numbered(1),
        RecordKind::Lamp.numbered(0),
        RecordKind::Drop.numbered(0),
        RecordKind::Car.numbered(0),
    ];
    let batch = Batch {
        records: gone.map(|key| (key, None)).into(),
        ..Batch::default()
    };
    store.commit(&batch).unwrap();
    drop(store);
    let mut again = kept.open();
    let ids: Vec<_> = again.bots().iter().map(|view| view.bot.id).collect();
    assert_eq!(ids, [0, 2]);
    again.spawn_bot(beside(10.0), 0.0, true);
    assert!(again.spawn_lamp(beside(-10.0)) && again.spawn_car(beside(-20.0), 0.0));
    let places = |scene: &Scene| -> Vec<_> {
        let lamps = scene.lamps().into_iter().map(|lamp| lamp.foot.point);
        lamps.collect()
    };
    let (lamps, cars) = (places(&again), again.cars().len());
    again.close().unwrap();
    assert_eq!(numbers(&kept, RecordKind::Figure), [0, 2, 3]);
    assert_eq!(numbers(&kept, RecordKind::Lamp), [1, 2, 3]);
    assert_eq!(numbers(&kept, RecordKind::Drop), [1]);
    assert_eq!(numbers(&kept, RecordKind::Car), [1, 2]);
    let mut last = kept.open();
    assert_eq!(places(&last), lamps);
    assert_eq!((last.cars().len(), last.drops().len()), (cars, 1));
    last.teleport(last.drops()[0].point);
    steps(&mut last, 60, &Actions::default());
    assert_eq!(last.drops().len(), 0, "picked up");
    last.close().unwrap();
    assert_eq!(numbers(&kept, RecordKind::Drop), []);
}
