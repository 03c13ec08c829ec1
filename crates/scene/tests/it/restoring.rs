//! What comes back of a world that was saved: as it was, and as much as there is of one that is damaged, forged, or of
//! another version.
#![cfg(unix)]

use std::fs;
use std::path::Path;
use std::sync::Arc;

use crate::common::kept::{Kept, build};
use crate::common::{setup, steps};
use antipode_geometry::Geometry;
use antipode_scene::{Actions, Scene, WorldSetup};
use antipode_storage::{
    Batch, CarRecord, DropRecord, FixtureRecord, LampRecord, Record, RecordKey, RecordKind,
    SavesDir, SlotRecord, WORLD_FILE, WorldState, WorldStore,
};

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
    let state = kept.alter(|state| state.map = "mercator".to_owned());
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
    let state = kept.alter(|state| {
        state.inventory.push(SlotRecord {
            slot: 20,
            item: "warp-core".to_owned(),
            count: 3,
        });
        state.drops.push(DropRecord {
            chart: 0,
            pos: [1.0, 2.0, 3.0],
            item: "portal".to_owned(),
            count: 2,
        });
    });
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
    kept.alter(alter);
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

#[test]
fn worlds_of_every_version_are_played_and_saved_whole() {
    for version in 1..=10 {
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

/// A later game may have spaces with more charts than this one knows.
#[test]
fn what_lies_in_a_chart_that_the_space_has_not_is_left_in_the_save() {
    let (kept, scene) = Kept::new();
    scene.close().unwrap();
    let lamp = RecordKind::Lamp.numbered(77);
    let far = Record::Lamp(LampRecord {
        chart: 1 << 90,
        pos: [1.0, 20.0, 3.0],
    });
    let put = |key: RecordKey, record: Record| {
        let batch = Batch {
            records: [(key, Some(record))].into(),
            ..Batch::default()
        };
        let store = WorldStore::open(&kept.here()).unwrap();
        store.commit(&batch).unwrap();
    };
    put(lamp, far.clone());
    let mut scene = kept.open();
    assert!(scene.lamps().is_empty());
    steps(&mut scene, 60, &build());
    scene.close().unwrap();
    let store = WorldStore::open(&kept.here()).unwrap();
    let mut records = store.records().unwrap().known;
    assert_eq!(records.get(&lamp), Some(&far));
    // Where the player is the world cannot be shown, and nothing of it may change.
    let me = RecordKind::Player.numbered(0);
    let Some(Record::Player(mut player)) = records.remove(&me) else {
        panic!("a player");
    };
    player.body.chart = 1 << 90;
    drop(store);
    put(me, Record::Player(player));
    let store = Arc::new(WorldStore::open(&kept.here()).unwrap());
    let refused = Scene::open(setup(Geometry::Euclidean), Some(store)).unwrap_err();
    assert!(refused.to_string().contains("newer"), "{refused}");
    let store = WorldStore::open(&kept.here()).unwrap();
    let records = store.records().unwrap().known;
    assert_eq!(records.get(&lamp), Some(&far));
    assert!(matches!(&records[&me], Record::Player(kept) if kept.body.chart == 1 << 90));
}

/// Items that stand came after lamps and flags, and are kept under their ids.
#[test]
fn what_stands_is_taken_in_by_its_id_and_what_cannot_stand_is_left_in_the_save() {
    let (kept, scene) = Kept::new();
    scene.close().unwrap();
    let fixture = |id: u32, item: &str| {
        let record = Record::Fixture(FixtureRecord {
            chart: 0,
            pos: [1.0, 20.0, 3.0],
            yaw: 0.5,
            name: "Here".to_owned(),
            item: item.to_owned(),
        });
        (RecordKind::Fixture.numbered(id), record)
    };
    let all = [fixture(3, "flag"), fixture(4, "gun"), fixture(5, "unicorn")];
    let batch = Batch {
        records: all.clone().map(|(key, record)| (key, Some(record))).into(),
        ..Batch::default()
    };
    WorldStore::open(&kept.here())
        .unwrap()
        .commit(&batch)
        .unwrap();
    let mut scene = kept.open();
    let names: Vec<_> = scene.flag_ways().into_iter().map(|way| way.name).collect();
    assert_eq!(names, ["Here"]);
    let notices = scene.take_notices();
    let unknown: Vec<_> = notices.iter().map(ToString::to_string).collect();
    assert!(
        unknown.len() == 1 && unknown[0].contains("unicorn"),
        "{unknown:?}"
    );
    steps(&mut scene, 60, &build());
    scene.close().unwrap();
    let records = WorldStore::open(&kept.here())
        .unwrap()
        .records()
        .unwrap()
        .known;
    let [flag, gun, unicorn] = all;
    assert!(!records.contains_key(&flag.0), "it is kept as a flag now");
    let flags = records.values().filter_map(|record| match record {
        Record::Flag(it) => Some(it.name.as_str()),
        _ => None,
    });
    assert!(flags.eq(["Here"]));
    assert_eq!(records.get(&gun.0), Some(&gun.1));
    assert_eq!(records.get(&unicorn.0), Some(&unicorn.1));
}
