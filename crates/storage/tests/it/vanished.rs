//! An open world whose directory is deleted, moved or replaced: no commit may seem
//! to have succeeded.
#![cfg(unix)]

use std::fs;

use crate::common::{batch, key, meta, samples, state};
use antipode_storage::{Batch, SavesDir, StorageError, WORLD_FILE, WorldStore};
use tempfile::TempDir;

fn opened() -> (TempDir, SavesDir, WorldStore) {
    let dir = tempfile::tempdir().unwrap();
    let saves = SavesDir::new(dir.path().join("saves"));
    let (_, world) = saves.create(&meta("W")).unwrap();
    world.commit(&batch(2, 1)).unwrap();
    (dir, saves, world)
}

fn assert_gone(saves: &SavesDir, world: &WorldStore) {
    let path = saves.path().join("w").join(WORLD_FILE);
    let with_meta = Batch {
        meta: Some(meta("W")),
        ..Batch::default()
    };
    let refusals = [
        world.commit(&batch(2, 2)),
        world.commit(&with_meta),
        world.write_thumbnail(b"png"),
    ];
    for refusal in refusals.map(Result::unwrap_err) {
        assert!(
            matches!(&refusal, StorageError::Vanished { path: gone } if *gone == path),
            "{refusal}"
        );
        let sentence = refusal.to_string();
        assert!(
            sentence.contains(path.to_str().unwrap()) && sentence.contains("Move the folder back"),
            "{sentence}"
        );
    }
}

#[test]
fn deleted_with_all_saves_it_is_said_at_every_commit() {
    let (_dir, saves, world) = opened();
    fs::remove_dir_all(saves.path()).unwrap();
    assert_gone(&saves, &world);
    assert_gone(&saves, &world);
    assert!(!saves.path().exists(), "nothing is made in its place");
    // What was committed can be read on.
    assert_eq!(world.chunk(&key(1)).unwrap(), Some(samples(1, 1)));
}

#[test]
fn moved_away_it_takes_no_commit_and_moved_back_it_takes_them_again() {
    let (dir, saves, world) = opened();
    let [here, away] = [saves.path().join("w"), dir.path().join("away")];
    fs::rename(&here, &away).unwrap();
    assert_gone(&saves, &world);
    fs::rename(&away, &here).unwrap();
    world.commit(&batch(2, 3)).unwrap();
    drop(world);
    let world = saves.open("w").unwrap();
    assert_eq!(world.state().unwrap(), Some(state(3.0)));
    assert_eq!(world.chunk(&key(1)).unwrap(), Some(samples(1, 3)));
}

#[test]
fn another_file_in_its_place_is_not_written_to() {
    let (dir, saves, world) = opened();
    let path = saves.path().join("w").join(WORLD_FILE);
    fs::rename(&path, dir.path().join("away")).unwrap();
    drop(WorldStore::create(&dir.path().join("other"), &meta("Other")).unwrap());
    fs::rename(dir.path().join("other").join(WORLD_FILE), &path).unwrap();
    let before = fs::read(&path).unwrap();
    assert_gone(&saves, &world);
    assert_eq!(fs::read(&path).unwrap(), before);
}

#[test]
fn deleted_while_commits_run_the_last_good_one_was_before_that() {
    let (_dir, saves, world) = opened();
    let refused = std::thread::scope(|scope| {
        let committing = scope.spawn(|| {
            // Ends by the deletion below, whenever that comes.
            (2..)
                .map(|commit| world.commit(&batch(2, commit)))
                .find_map(Result::err)
        });
        fs::remove_dir_all(saves.path()).unwrap();
        committing.join().unwrap()
    });
    assert!(
        matches!(refused, Some(StorageError::Vanished { .. })),
        "{refused:?}"
    );
}
