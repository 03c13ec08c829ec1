//! Tests of how rooms of one's own are opened, kept and gone back in.
#![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

use std::fs;
use std::path::PathBuf;

use super::*;

/// A directory with one room of the player's own, and its folder.
fn with_room() -> (tempfile::TempDir, RoomsDir, PathBuf) {
    let temporary = tempfile::tempdir().unwrap();
    let dir = RoomsDir::new(temporary.path().to_path_buf());
    let slug = dir.make(&Room::new("Hut")).unwrap();
    let folder = dir.path().join(slug);
    (temporary, dir, folder)
}

fn enter(dir: &RoomsDir) -> OpenRoom {
    OpenRoom::enter_with_journal(dir, dir.find("Hut").unwrap()).unwrap()
}

const ADD: [&str; 4] = ["add", "box", "name=stone", "size=1,1,1"];

#[test]
fn a_room_that_is_kept_under_another_name_leaves_the_first_and_its_history_as_they_were() {
    let (_temporary, dir, folder) = with_room();
    let before = fs::read(folder.join("room.ron")).unwrap();
    let mut room = enter(&dir);
    room.edit(&dir, &ADD).unwrap();
    room.save(&dir, Some("Other hut")).unwrap();
    assert_eq!(room.kept.as_ref().unwrap().name, "Other hut");
    room.edit(&dir, &["add", "ball", "name=ball", "radius=1"])
        .unwrap();
    room.save(&dir, None).unwrap();
    drop(room);
    assert_eq!(fs::read(folder.join("room.ron")).unwrap(), before);
    let first = enter(&dir);
    assert_eq!(first.scene.document().history().steps().len(), 1);
    let other = OpenRoom::enter_with_journal(&dir, dir.find("Other hut").unwrap()).unwrap();
    assert!(other.scene.room().find("ball").is_some() && other.notes.is_empty());
    assert!(other.scene.room().find("stone").is_some());
}

#[test]
fn a_room_that_another_window_builds_in_is_walked_through_and_not_written_over() {
    let (_temporary, dir, folder) = with_room();
    let mut first = enter(&dir);
    first.edit(&dir, &ADD).unwrap();
    first.save(&dir, None).unwrap();
    let kept = fs::read(folder.join("room.ron")).unwrap();
    let mut second = enter(&dir);
    assert_eq!(second.notes, [RoomNote::InUse]);
    let why = second.edit(&dir, &["remove", "stone"]).unwrap_err();
    assert!(
        why.to_string().contains("built in by another window"),
        "{why}"
    );
    // As a script does, which knows nothing of journals.
    let mut script = OpenRoom::enter(&dir, dir.find("Hut").unwrap()).unwrap();
    script.edit(&dir, &["remove", "stone"]).unwrap();
    let why = script.save(&dir, None).unwrap_err();
    assert!(why.to_string().contains("Close it there first"), "{why}");
    assert_eq!(fs::read(folder.join("room.ron")).unwrap(), kept);
    script.save(&dir, Some("Copy")).unwrap();
    drop(first);
    script
        .edit(&dir, &["add", "ball", "name=ball", "radius=1"])
        .unwrap();
    script.save(&dir, None).unwrap();
    assert!(enter(&dir).notes.is_empty());
}

#[test]
fn an_older_version_is_opened_as_a_step_that_can_be_taken_back() {
    let (_temporary, dir, folder) = with_room();
    let mut room = enter(&dir);
    let first = folder.join("workshop/versions/951868799.ron");
    fs::copy(folder.join("room.ron"), first).unwrap();
    room.edit(&dir, &ADD).unwrap();
    let why = room.open_older(&dir, 7).unwrap_err();
    assert!(why.to_string().contains("no older version 7"), "{why}");
    let count = room.versions(&dir).len();
    assert_eq!(room.versions(&dir)[count - 1].when_s, 951_868_799);
    room.open_older(&dir, count).unwrap();
    assert!(room.scene.room().find("stone").is_none());
    room.save(&dir, None).unwrap();
    room.edit(&dir, &["undo"]).unwrap();
    assert!(room.scene.room().find("stone").is_some());
    drop(room);
    // Nothing is lost over a restart, whichever of both the file has.
    let mut again = enter(&dir);
    assert_eq!(again.notes, [RoomNote::Ahead]);
    assert!(again.scene.room().find("stone").is_some());
    again.edit(&dir, &["redo"]).unwrap();
    assert!(again.scene.room().find("stone").is_none());
    drop(again);
    fs::write(
        folder.join("room.ron"),
        "(version: 1, name: \"Hut\", objects: [(name: \"new\", what: Group)])",
    )
    .unwrap();
    let changed = enter(&dir);
    assert_eq!(changed.notes, [RoomNote::Changed]);
    assert!(changed.scene.room().find("new").is_some());
    drop(changed);
    let journal = folder.join("workshop/journal");
    let mut bytes = fs::read(&journal).unwrap();
    let middle = bytes.len() / 2;
    bytes[middle] ^= 0x55;
    fs::write(&journal, bytes).unwrap();
    assert!(matches!(enter(&dir).notes[..], [RoomNote::Aside(_), ..]));
}

#[test]
fn a_room_without_older_versions_says_so() {
    let temporary = tempfile::tempdir().unwrap();
    let dir = RoomsDir::new(temporary.path().to_path_buf());
    let mut room = OpenRoom::make(&dir, Some("Hut"), None).unwrap();
    let why = room.open_older(&dir, 1).unwrap_err();
    assert!(why.to_string().contains("no older versions"), "{why}");
}
