//! A world on disk: what is told of a save, of one that fails, and of one that is damaged.
#![cfg(unix)]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::common::{LIMIT, setup, steps};
use antipode_geometry::Geometry;
use antipode_scene::{Actions, Scene, WorldSetup};
use antipode_storage::{
    Batch, CarRecord, DropRecord, LampRecord, Record, RecordKind, SavesDir, SlotRecord, WORLD_FILE,
    WorldState, WorldStore,
};
use tempfile::TempDir;

/// A kept world that can be moved away so that its commits fail, and back.
struct Kept {
    dir: TempDir,
}

impl Kept {
    fn new() -> (Self, Scene) {
        let kept = Self {
            dir: tempfile::tempdir().unwrap(),
        };
        let setup = setup(Geometry::Euclidean);
        let store = WorldStore::create(&kept.here(), &setup.to_meta()).unwrap();
        let mut scene = Scene::open(setup, Some(Arc::new(store))).unwrap();
        assert!(scene.wait_for_step(LIMIT));
        (kept, scene)
    }

    fn here(&self) -> PathBuf {
        self.dir.path().join("world")
    }

    fn take_away(&self) {
        fs::rename(self.here(), self.dir.path().join("away")).unwrap();
    }

    fn bring_back(&self) {
        fs::rename(self.dir.path().join("away"), self.here()).unwrap();
    }

    fn open(&self) -> Scene {
        let store = WorldStore::open(&self.here()).unwrap();
        let mut scene = Scene::open(setup(Geometry::Euclidean), Some(Arc::new(store))).unwrap();
        assert!(scene.wait_for_step(LIMIT));
        scene
    }
}

fn build() -> Actions {
    Actions {
        secondary: true,
        ..Actions::default()
    }
}

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

/// Flips a bit in every copy of the player's record, as a bad disk does. Inside a record the key stands 20 bytes
/// after its mark.
fn damage_state(dir: &Path) {
    let path = dir.join(WORLD_FILE);
    let mut bytes = fs::read(&path).unwrap();
    let found: Vec<usize> = (20..bytes.len() - 30)
        .filter(|&at| bytes[at..].starts_with(b"\x06player") && bytes[at - 20..].starts_with(b"Ap"))
        .collect();
    assert!(!found.is_empty());
    for at in found {
        bytes[at + 20] ^= 0x10;
    }
    fs::write(path, bytes).unwrap();
}

#[test]
fn a_damaged_player_costs_the_player_and_not_the_world() {
    let (kept, mut scene) = Kept::new();
    let start = scene.feet();
    scene.aim(0.0, -0.6);
    let act = Actions {
        forward: 1.0,
        ..build()
    };
    steps(&mut scene, 60, &act);
    let edited = scene.probe().chunks.edited;
    scene.close().unwrap();
    damage_state(&kept.here());
    let damaged = fs::metadata(kept.here().join(WORLD_FILE)).unwrap().len();
    let mut again = kept.open();
    assert_eq!(again.probe().chunks.edited, edited);
    let copy = kept.here().join(format!("{WORLD_FILE}.damaged-1"));
    assert_eq!(fs::metadata(copy).unwrap().len(), damaged, "for a repair");
    assert!(again.simulated_s() > 0.9, "what was played is known yet");
    let home_m = (again.feet().pos - start.pos).length();
    assert!(home_m < 12.0, "a fresh player, {home_m} m from the start");
    let notices = again.take_notices();
    assert!(
        notices
            .iter()
            .any(|notice| notice.to_string().contains("damaged")),
        "{notices:?}"
    );
    again.close().unwrap();
    assert!(kept.open().take_notices().is_empty());
}

#[test]
fn the_picture_of_a_world_comes_back_with_it() {
    let (kept, mut scene) = Kept::new();
    let turn = Actions {
        turn_map: true,
        dial: -7.0,
        ..Actions::default()
    };
    steps(&mut scene, 2, &turn);
    steps(&mut scene, 1, &turn);
    let (bend, goals) = (scene.lens().bend(), scene.lens().goals());
    assert_eq!((bend, goals.bend), (Some(-14.0), -14.0));
    scene.close().unwrap();
    let mut again = kept.open();
    assert_eq!((again.lens().bend(), again.lens().goals()), (bend, goals));
    assert_eq!(again.eye().dial, -14.0, "at rest at once");
    assert!(again.take_notices().is_empty() && again.take_hints().is_empty());
}

#[test]
fn a_map_this_version_does_not_know_costs_the_map_alone() {
    let (kept, scene) = Kept::new();
    scene.close().unwrap();
    let store = WorldStore::open(&kept.here()).unwrap();
    let state = WorldState {
        map: "mercator".to_owned(),
        ..store.state().unwrap().unwrap()
    };
    let batch = Batch {
        records: (&state).into(),
        ..Batch::default()
    };
    store.commit(&batch).unwrap();
    drop(store);
    let mut again = kept.open();
    let notices = again.take_notices();
    assert!(
        notices
            .iter()
            .any(|said| said.to_string().contains("mercator")),
        "{notices:?}"
    );
    assert_eq!(again.probe().player.pos, state.player.pos);
}

#[test]
fn a_player_saved_in_rock_stands_on_it_after_loading() {
    let (kept, mut scene) = Kept::new();
    scene.set_flying(true);
    let mut deep = scene.feet();
    deep.pos.y -= 30.0;
    scene.teleport(deep);
    steps(&mut scene, 2, &Actions::default());
    scene.set_flying(false);
    scene.close().unwrap();
    let mut again = kept.open();
    assert!(again.feet().pos.y > deep.pos.y + 10.0);
    steps(&mut again, 60, &Actions::default());
    assert!(again.probe().player.grounded);
}

#[test]
fn a_world_that_says_it_has_an_impossible_radius_is_refused_in_words() {
    for (geometry, radius_m) in [
        ("spherical", 1e9),
        ("spherical", f64::NAN),
        ("hyperbolic", 0.0),
    ] {
        let meta = antipode_storage::WorldMeta {
            name: "Odd".into(),
            geometry: geometry.into(),
            radius_m,
            ..antipode_storage::WorldMeta::default()
        };
        let refused = WorldSetup::from_meta(&meta, 3).unwrap_err();
        let words = refused.to_string();
        assert!(words.contains("radius") && words.contains("Odd"), "{words}");
    }
}

#[test]
fn things_of_a_newer_version_go_back_into_the_save_as_they_came() {
    let (kept, scene) = Kept::new();
    scene.close().unwrap();
    let store = WorldStore::open(&kept.here()).unwrap();
    let mut state = store.state().unwrap().unwrap();
    state.inventory.push(SlotRecord {
        slot: 20,
        item: "warp-core".to_owned(),
        count: 3,
    });
    state.drops.push(DropRecord {
        hemisphere: 0,
        pos: [1.0, 2.0, 3.0],
        item: "portal".to_owned(),
        count: 2,
    });
    let batch = Batch {
        records: (&state).into(),
        ..Batch::default()
    };
    store.commit(&batch).unwrap();
    drop(store);
    for _ in 0..2 {
        let mut again = kept.open();
        let notices = again.take_notices();
        for item in ["warp-core", "portal"] {
            let told = notices.iter().filter(|it| it.to_string().contains(item));
            assert_eq!(told.count(), 1, "{notices:?}");
        }
        steps(&mut again, 2, &build());
        again.close().unwrap();
    }
    let kept = WorldStore::open(&kept.here())
        .unwrap()
        .state()
        .unwrap()
        .unwrap();
    assert_eq!(kept.inventory, state.inventory);
    assert_eq!(kept.drops, state.drops);
}

/// A world opened with a state that somebody has changed.
fn altered(alter: impl FnOnce(&mut WorldState)) -> (Kept, Scene) {
    let (kept, scene) = Kept::new();
    scene.close().unwrap();
    let store = WorldStore::open(&kept.here()).unwrap();
    let mut state = store.state().unwrap().unwrap();
    alter(&mut state);
    let batch = Batch {
        records: (&state).into(),
        ..Batch::default()
    };
    store.commit(&batch).unwrap();
    drop(store);
    let again = kept.open();
    (kept, again)
}

#[test]
fn no_speed_in_a_save_is_more_than_ground_can_be_made_for() {
    let (_kept, mut scene) = altered(|state| {
        state.player.vel = [1e300, 0.0, -1e300];
        state.player.flying = true;
    });
    let from = scene.feet().pos;
    steps(&mut scene, 60, &Actions::default());
    assert!(scene.feet().pos.distance(from) < 150.0);
}

#[test]
fn a_world_as_old_as_the_sun_is_still_saved_by_itself() {
    let (_kept, mut scene) = altered(|state| state.simulated_s = 1e17);
    let before_s = scene.simulated_s();
    steps(&mut scene, 60, &Actions::default());
    assert!((scene.simulated_s() - before_s - 1.0).abs() < 0.01);
}

#[test]
fn who_is_far_from_the_car_in_a_save_does_not_drive_it() {
    let car = |pos| CarRecord {
        pos,
        turn: [0.0, 0.0, 0.0, 1.0],
        ..CarRecord::default()
    };
    for (away_m, drives) in [(1.0, true), (500.0, false)] {
        let (_kept, scene) = altered(|state| {
            let [x, y, z] = state.player.pos;
            state.cars = vec![car([x + away_m, y, z])];
            state.driving = Some(0);
        });
        assert_eq!(scene.is_driving(), drives, "{away_m} m away");
    }
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
        let lamp = LampRecord { hemisphere: 0, pos };
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
        let lamps = scene.lamps().into_iter().map(|lamp| lamp.point);
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

#[test]
fn worlds_of_every_version_are_played_and_saved_whole() {
    for version in 1..=7 {
        let dir = tempfile::tempdir().unwrap();
        let saves = SavesDir::new(dir.path());
        let file = format!(
            "{}/../../tests/saves/v{version}/v{version}.antipode-world",
            env!("CARGO_MANIFEST_DIR")
        );
        let slug = saves.import(Path::new(&file)).unwrap();
        let look = || {
            let store = saves.open(&slug).unwrap();
            assert_eq!(store.problems(), Vec::<String>::new(), "version {version}");
            let keys = store.edited_chunks().unwrap();
            let land: Vec<_> = keys.iter().map(|key| store.chunk(key).unwrap()).collect();
            (store.state().unwrap().unwrap(), keys, land)
        };
        let before = look();
        let store = saves.open(&slug).unwrap();
        let setup = WorldSetup::from_meta(&store.meta(), 3).unwrap();
        let mut scene = Scene::open(setup, Some(Arc::new(store))).unwrap();
        assert_eq!(scene.take_notices(), [], "version {version}");
        scene.step(&Actions::default());
        scene.close().unwrap();
        let after = look();
        assert_eq!((&after.1, &after.2), (&before.1, &before.2));
        assert_eq!(after.1.len(), 2, "chunks");
        let things = |state: &WorldState| {
            let lists = [state.lamps.len(), state.drops.len(), state.bots.len()];
            (lists, state.cars.len(), state.inventory.clone())
        };
        assert_eq!(things(&after.0), things(&before.0), "version {version}");
        assert!(after.0.simulated_s > before.0.simulated_s);
        assert!(saves.verify(&slug).unwrap().is_sound());
    }
}
