//! A world and the directory of worlds, as the game uses them.

use std::fs;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::common::{batch, key, meta, samples, state};
use antipode_storage::{
    Batch, ChunkKey, LampRecord, NameError, Record, RecordKind, SavesDir, StorageError,
    THUMBNAIL_FILE, WORLD_FILE, WorldMeta, WorldStore,
};
use tempfile::TempDir;

fn saves() -> (TempDir, SavesDir) {
    let dir = tempfile::tempdir().unwrap();
    let saves = SavesDir::new(dir.path().join("deep/saves"));
    (dir, saves)
}

fn entries(saves: &SavesDir) -> Vec<String> {
    let mut names: Vec<_> = fs::read_dir(saves.path())
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        // The lock of the directory stays.
        .filter(|name| name != ".antipode.lock")
        .collect();
    names.sort();
    names
}

#[test]
fn everything_committed_comes_back() {
    let (_dir, saves) = saves();
    let (slug, world) = saves.create(&meta("My World")).unwrap();
    assert_eq!(slug, "my-world");
    assert_eq!(
        (world.meta(), world.state().unwrap()),
        (meta("My World"), None)
    );
    assert_eq!(world.edited_chunks().unwrap(), []);
    world.commit(&batch(3, 1)).unwrap();
    let changed = WorldMeta {
        played_s: 9.5,
        ..meta("My World")
    };
    let second = Batch {
        meta: Some(changed.clone()),
        records: antipode_storage::RecordChanges::new(),
        chunks: vec![(key(-7), samples(-7, 2)), (key(1), samples(1, 2))],
        kinds: std::collections::BTreeMap::new(),
    };
    world.commit(&second).unwrap();
    drop(world);
    let world = saves.open(&slug).unwrap();
    assert_eq!(world.meta(), changed);
    assert_eq!(world.state().unwrap(), Some(state(1.0)));
    assert_eq!(
        world.edited_chunks().unwrap(),
        [key(-7), key(0), key(1), key(2)]
    );
    assert_eq!(world.chunk(&key(0)).unwrap(), Some(samples(0, 1)));
    assert_eq!(world.chunk(&key(1)).unwrap(), Some(samples(1, 2)));
    assert_eq!(world.chunk(&key(9)).unwrap(), None);
    assert_eq!(world.problems(), Vec::<String>::new());
}

/// A key in a chart that is neither of the two hemispheres.
fn far(x: i32) -> ChunkKey {
    ChunkKey {
        chart: u128::MAX / 3 + x as u128,
        ..key(x)
    }
}

#[test]
fn land_and_things_of_charts_without_number_come_back_through_doubles_archives_and_repairs() {
    let (_dir, saves) = saves();
    let (slug, world) = saves.create(&meta("Wide")).unwrap();
    let kind = RecordKind::Lamp;
    let lamp = LampRecord {
        chart: u128::MAX / 7,
        pos: [1.0, 2.0, 3.0],
    };
    let mut things = batch(2, 1);
    things
        .records
        .insert(kind.numbered(9), Some(Record::Lamp(lamp.clone())));
    things
        .chunks
        .extend([(far(4), samples(4, 1)), (far(5), samples(5, 1))]);
    world.commit(&things).unwrap();
    let again = Batch {
        chunks: vec![(far(5), samples(5, 2))],
        ..Batch::default()
    };
    world.commit(&again).unwrap();
    drop(world);
    let holds_all = |slug: &str| {
        assert!(saves.verify(slug).unwrap().is_sound());
        assert_eq!(saves.edited_chunks(slug).unwrap(), Some(4));
        let world = saves.open(slug).unwrap();
        let keys = [key(0), key(1), far(4), far(5)];
        assert_eq!(world.edited_chunks().unwrap(), keys);
        assert_eq!(world.chunk(&far(4)).unwrap(), Some(samples(4, 1)));
        assert_eq!(world.chunk(&far(5)).unwrap(), Some(samples(5, 2)));
        let records = world.records().unwrap().known;
        assert_eq!(records[&kind.numbered(9)], Record::Lamp(lamp.clone()));
        assert_eq!(world.problems(), Vec::<String>::new());
    };
    holds_all(&slug);
    let archive = saves.path().join("wide.antipode");
    saves.export(&slug, &archive).unwrap();
    holds_all(&saves.import(&archive).unwrap());
    let file = saves.path().join(&slug).join(WORLD_FILE);
    let mut bytes = fs::read(&file).unwrap();
    bytes[..4096].fill(0xff);
    fs::write(&file, bytes).unwrap();
    let report = saves.repair(&slug).unwrap();
    assert_eq!((report.chunks, report.has_state), (4, true));
    holds_all(&slug);
}

#[test]
fn a_new_world_takes_little_room_and_edits_add_little() {
    let (_dir, saves) = saves();
    let (slug, world) = saves.create(&meta("Small")).unwrap();
    drop(world);
    let size = saves.list().unwrap()[0].size_bytes;
    assert!(size <= 1_100_000, "a new world takes {size} bytes");
    let path = saves.path().join("out");
    saves.export(&slug, &path).unwrap();
    assert!(fs::metadata(path).unwrap().len() < 20_000);
}

#[test]
fn a_chunk_of_a_wrong_size_is_refused_and_changes_nothing() {
    let (_dir, saves) = saves();
    let (_, world) = saves.create(&meta("Foo")).unwrap();
    let wrong = Batch {
        records: (&state(5.0)).into(),
        chunks: vec![(key(0), vec![1; 10])],
        ..Batch::default()
    };
    let error = world.commit(&wrong).unwrap_err();
    assert!(matches!(error, StorageError::Unstorable { .. }), "{error}");
    assert_eq!(world.state().unwrap(), None);
}

#[test]
fn the_list_is_newest_first_and_survives_bad_worlds() {
    let (_dir, saves) = saves();
    assert_eq!(saves.list().unwrap(), []);
    for (name, played) in [("Old", 10), ("New", 30), ("Bad", 20)] {
        let meta = WorldMeta {
            last_played_unix_s: played,
            ..meta(name)
        };
        saves.create(&meta).unwrap();
    }
    fs::write(saves.path().join("bad").join(WORLD_FILE), b"rubbish").unwrap();
    fs::create_dir(saves.path().join("no-world")).unwrap();
    fs::write(saves.path().join("README.md"), b"text").unwrap();
    let open = saves.open("old").unwrap();
    open.write_thumbnail(b"png").unwrap();
    let list = saves.list().unwrap();
    let names: Vec<_> = list
        .iter()
        .map(antipode_storage::WorldSummary::name)
        .collect();
    assert_eq!(names, ["New", "Bad", "Old"]);
    let problems: Vec<_> = list.iter().map(|world| world.problem.is_some()).collect();
    assert_eq!(problems, [false, true, false]);
    assert!(
        list[1]
            .problem
            .as_ref()
            .unwrap()
            .contains("no save of this game")
    );
    let in_use: Vec<_> = list.iter().map(|world| world.in_use).collect();
    assert_eq!(in_use, [false, false, true]);
    assert_eq!(
        list[2].thumbnail,
        Some(saves.path().join("old").join(THUMBNAIL_FILE))
    );
    assert_eq!(list[0].thumbnail, None);
}

#[test]
fn names_are_found_and_kept_apart_ignoring_case() {
    let (_dir, saves) = saves();
    saves.create(&meta("Żółw")).unwrap();
    let (slug, _) = saves.create(&meta("  żółw 2 ")).unwrap();
    assert_eq!(slug, "w-2");
    let taken = saves.check_name("ŻÓŁW ");
    assert_eq!(
        taken,
        Err(NameError::Taken {
            existing: "Żółw".to_owned()
        })
    );
    assert!(matches!(
        saves.create(&meta("żółw")),
        Err(StorageError::Name(_))
    ));
    assert_eq!(saves.check_name("Żółw 3"), Ok(()));
    assert_eq!(saves.find("żÓłW").unwrap().slug, "w");
    assert_eq!(saves.find("w-2").unwrap().name(), "żółw 2");
    let missing = saves.find("nobody").unwrap_err().to_string();
    assert!(missing.contains("no world \"nobody\""), "{missing}");
    assert_eq!(entries(&saves), ["w", "w-2"]);
}

#[test]
fn different_names_of_one_slug_get_numbers() {
    let (_dir, saves) = saves();
    let slugs = ["a b", "a-b", "a.b", "CON", "世界", "界世"]
        .map(|name| saves.create(&meta(name)).unwrap().0);
    assert_eq!(
        slugs,
        ["a-b", "a-b-2", "a-b-3", "con-world", "world", "world-2"]
    );
}

#[test]
fn a_world_in_use_is_refused_to_others_and_not_deleted() {
    let (_dir, saves) = saves();
    let (slug, world) = saves.create(&meta("Busy")).unwrap();
    world.commit(&batch(1, 1)).unwrap();
    let refusals = [
        saves.open(&slug).map(drop).unwrap_err(),
        saves.delete(&slug).unwrap_err(),
        saves.repair(&slug).map(drop).unwrap_err(),
        saves.export(&slug, &saves.path().join("out")).unwrap_err(),
    ];
    for refusal in refusals {
        assert!(matches!(refusal, StorageError::InUse { .. }), "{refusal}");
        assert!(refusal.to_string().contains("\"Busy\""), "{refusal}");
    }
    drop(world);
    assert_eq!(
        saves.open(&slug).unwrap().chunk(&key(0)).unwrap(),
        Some(samples(0, 1))
    );
    saves.delete(&slug).unwrap();
    assert_eq!(entries(&saves), Vec::<String>::new());
}

#[test]
fn nothing_half_made_appears() {
    let (_dir, saves) = saves();
    assert!(saves.create(&meta("")).is_err());
    assert!(saves.list().unwrap().is_empty());
    // A file where the directory should be: making must fail and leave nothing.
    let blocked = SavesDir::new(saves.path().join("file"));
    fs::create_dir_all(saves.path()).unwrap();
    fs::write(blocked.path(), b"").unwrap();
    let error = blocked
        .create(&meta("Foo"))
        .map(drop)
        .unwrap_err()
        .to_string();
    assert!(error.contains("file"), "{error}");
    assert_eq!(entries(&saves), ["file"]);
    assert!(matches!(
        WorldStore::open(&saves.path().join("none")),
        Err(StorageError::NotFound { .. })
    ));
}

#[test]
fn export_and_import_carry_a_world_and_overwrite_nothing() {
    let (_dir, saves) = saves();
    let (slug, world) = saves.create(&meta("Travel")).unwrap();
    world.commit(&batch(4, 3)).unwrap();
    world.write_thumbnail(b"png").unwrap();
    drop(world);
    let file = saves.path().join("travel.antipode-world");
    saves.export(&slug, &file).unwrap();
    assert!(matches!(
        saves.export(&slug, &file),
        Err(StorageError::Exists { .. })
    ));
    let imported = saves.import(&file).unwrap();
    assert_eq!(imported, "travel-2");
    let again = saves.import(&file).unwrap();
    let world = saves.open(&again).unwrap();
    assert_eq!(world.meta(), meta("Travel 3"));
    assert_eq!(world.state().unwrap(), Some(state(3.0)));
    assert_eq!(world.chunk(&key(2)).unwrap(), Some(samples(2, 3)));
    assert_eq!(
        fs::read(saves.thumbnail_path(&again).unwrap()).unwrap(),
        b"png"
    );
    assert_eq!(saves.open(&slug).unwrap().meta().name, "Travel");
    assert_eq!(saves.find("Travel 2").unwrap().slug, imported);
}

#[test]
fn an_archive_of_rubbish_is_refused_and_leaves_nothing() {
    let (_dir, saves) = saves();
    let outside = tempfile::tempdir().unwrap();
    let file: PathBuf = outside.path().join("x");
    fs::write(&file, b"rubbish that is longer than any header would be").unwrap();
    let error = saves.import(&file).unwrap_err().to_string();
    assert!(error.contains("no exported world"), "{error}");
    assert!(saves.import(&outside.path().join("missing")).is_err());
    assert_eq!(entries(&saves), Vec::<String>::new());
}

#[test]
fn info_and_verify_of_a_sound_world() {
    let (_dir, saves) = saves();
    let (slug, world) = saves.create(&meta("Sound")).unwrap();
    world.commit(&batch(5, 1)).unwrap();
    drop(world);
    let info = saves.info(&slug).unwrap();
    assert_eq!(
        (info.edited_chunks, info.state, info.problems.len()),
        (5, Some(state(1.0)), 0)
    );
    let report = saves.verify(&slug).unwrap();
    assert!(report.is_sound() && report.has_state, "{report:?}");
    assert_eq!((report.chunks, report.world.as_str()), (5, "Sound"));
    let repair = saves.repair(&slug).unwrap();
    assert_eq!((repair.kept, repair.chunks), (None, 5));
}

#[test]
fn a_list_made_meanwhile_keeps_no_world_from_being_opened() {
    let (_dir, saves) = saves();
    let (slug, world) = saves.create(&meta("Looked at")).unwrap();
    drop(world);
    let done = AtomicBool::new(false);
    std::thread::scope(|scope| {
        scope.spawn(|| {
            while !done.load(Ordering::Relaxed) {
                saves.list().unwrap();
                // Lists are not made one into the other, or nobody could ever get in.
                std::thread::sleep(std::time::Duration::from_millis(2));
            }
        });
        let opened: Vec<_> = (0..100).map(|_| saves.open(&slug).map(drop)).collect();
        done.store(true, Ordering::Relaxed);
        let refused = opened.iter().filter(|result| result.is_err()).count();
        assert_eq!(refused, 0);
    });
}
