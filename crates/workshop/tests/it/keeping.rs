//! A document in its folder: what comes back, and what stays as it was.

use std::fs;
use std::path::Path;

use antipode_rooms::files::ROOM_FILE;
use antipode_rooms::{Object, Room, What, read, write};
use antipode_workshop::{
    Document, Edit, FOLDER, Field, Opened, WorkshopError, read_version, versions,
};
use glam::DVec3;
use tempfile::TempDir;

/// A room with a comment, written by hand.
const BY_HAND: &str = r#"// My own words.
(version: 1, name: "Hut", objects: [
    (name: "floor", at: (0, -0.5, 0), what: Box(size: (20, 1, 20))), // oak
    (name: "wall", at: (0, 1, -5), what: Box(size: (4, 2, 0.2))),
])
"#;

fn folder() -> TempDir {
    let dir = tempfile::tempdir().unwrap();
    fs::write(dir.path().join(ROOM_FILE), BY_HAND).unwrap();
    dir
}

fn open(dir: &TempDir) -> Opened {
    Document::open(dir.path()).unwrap()
}

fn text(dir: &TempDir) -> String {
    fs::read_to_string(dir.path().join(ROOM_FILE)).unwrap()
}

fn moved(z: f64) -> Edit {
    Edit::Change(
        "wall".to_owned(),
        vec![Field::three("at", DVec3::new(0.0, 1.0, z))],
    )
}

fn ball(name: &str) -> Edit {
    Edit::Insert(Object::new(name, DVec3::ZERO, What::Ball { radius: 1.0 }))
}

fn z(document: &Document) -> f64 {
    document.room().find("wall").unwrap().1.at.z
}

#[test]
fn edits_outlive_a_restart_without_being_saved_and_can_be_taken_back_then() {
    let dir = folder();
    {
        let mut it = open(&dir).document;
        it.edit(&moved(-6.0)).unwrap();
        it.edit(&moved(-7.0)).unwrap();
        it.edit(&ball("ball")).unwrap();
        it.undo(1).unwrap();
        it.hide("wall", true);
        it.lock("floor", true);
        assert!(!it.is_saved());
    }
    assert_eq!(text(&dir), BY_HAND, "nothing was saved");
    let opened = open(&dir);
    assert!(opened.is_ahead && !opened.was_changed && opened.aside.is_none());
    let mut it = opened.document;
    assert_eq!(z(&it), -7.0);
    assert_eq!((it.history().made(), it.history().steps().len()), (2, 3));
    assert!(it.is_hidden("wall") && it.is_locked("floor"));
    it.redo(1).unwrap();
    assert!(it.room().find("ball").is_some());
    it.save_now().unwrap();
    assert!(it.is_saved());
    assert_eq!(text(&dir), write(it.room()).unwrap());
    it.undo(3).unwrap();
    assert!(!it.is_saved());
    it.save_now().unwrap();
    assert_eq!(text(&dir), BY_HAND, "comments and all");
}

#[test]
fn what_something_else_has_written_is_a_step_that_can_be_taken_back() {
    let dir = folder();
    {
        let mut it = open(&dir).document;
        it.edit(&moved(-6.0)).unwrap();
        it.save_now().unwrap();
        it.edit(&moved(-7.0)).unwrap();
    }
    let other = BY_HAND.replace("Hut", "Barn");
    fs::write(dir.path().join(ROOM_FILE), &other).unwrap();
    let opened = open(&dir);
    assert!(opened.was_changed && !opened.is_ahead);
    let mut it = opened.document;
    assert_eq!(it.room().name, "Barn");
    assert_eq!(it.history().steps().last().unwrap().said.id, "outside");
    it.save_now().unwrap();
    assert_eq!(text(&dir), other, "what is the same is not written anew");
    it.undo(1).unwrap();
    assert_eq!((it.room().name.as_str(), z(&it)), ("Hut", -7.0));
    drop(it);
    let again = open(&dir);
    assert!(again.is_ahead && !again.was_changed);
}

#[test]
fn files_that_are_not_ours_stay() {
    let dir = folder();
    let own = dir.path().join(FOLDER);
    let strange = [
        dir.path().join("notes.txt"),
        dir.path().join("models/house.blend"),
        own.join("mine.txt"),
        own.join("versions/readme.md"),
        own.join("versions/1.5.ron"),
    ];
    for file in &strange {
        fs::create_dir_all(file.parent().unwrap()).unwrap();
        fs::write(file, "mine").unwrap();
    }
    {
        let mut it = open(&dir).document;
        it.edit(&moved(-6.0)).unwrap();
        it.save_now().unwrap();
    }
    drop(open(&dir));
    for file in &strange {
        assert_eq!(
            fs::read_to_string(file).unwrap(),
            "mine",
            "{}",
            file.display()
        );
    }
    let names: Vec<_> = fs::read_dir(dir.path()).unwrap().flatten().collect();
    assert_eq!(names.len(), 4, "nothing unfinished is left: {names:?}");
}

#[test]
fn a_room_is_edited_in_one_place_at_a_time() {
    let dir = folder();
    let first = open(&dir);
    assert!(matches!(
        Document::open(dir.path()),
        Err(WorkshopError::InUse(_))
    ));
    drop(first);
    assert!(Document::open(dir.path()).is_ok());
}

#[test]
fn a_drag_that_never_ended_is_a_step() {
    let dir = folder();
    {
        let mut it = open(&dir).document;
        it.begin_drag();
        it.drag(&moved(-6.0)).unwrap();
    }
    let it = open(&dir).document;
    assert_eq!((z(&it), it.history().made()), (-6.0, 1));
    drop(it);
    assert_eq!(open(&dir).document.history().made(), 1);
    {
        let mut it = open(&dir).document;
        it.begin_drag();
        it.drag(&moved(-9.0)).unwrap();
        it.cancel_drag();
    }
    let it = open(&dir).document;
    assert_eq!(
        (z(&it), it.history().made()),
        (-6.0, 1),
        "it was taken back"
    );
}

#[test]
fn a_journal_cut_or_changed_anywhere_gives_what_was_before_and_goes_on() {
    let dir = folder();
    let journal = dir.path().join(FOLDER).join("journal");
    {
        let mut it = open(&dir).document;
        for number in 1..=6 {
            it.edit(&moved(-f64::from(number))).unwrap();
        }
    }
    let whole = fs::read(&journal).unwrap();
    let mut random = fastrand::Rng::with_seed(5);
    for round in 0..60 {
        let mut bytes = whole.clone();
        let is_cut = round % 2 == 0;
        let at = random.usize(bytes.len() / 3..bytes.len());
        if is_cut {
            bytes.truncate(at);
        } else {
            bytes[at] ^= 0x55;
        }
        fs::write(&journal, &bytes).unwrap();
        let opened = open(&dir);
        let mut it = opened.document;
        let made = it.history().made();
        assert!(made < 6, "{at}");
        let expected = if made == 0 { -5.0 } else { -(made as f64) };
        assert_eq!(z(&it), expected, "{at}");
        match &opened.aside {
            None => assert!(is_cut),
            Some(aside) => {
                assert_eq!(fs::read(aside).unwrap(), bytes);
                fs::remove_file(aside).unwrap();
            }
        }
        it.edit(&ball("more")).unwrap();
        drop(it);
        let it = open(&dir).document;
        assert!(it.room().find("more").is_some() && it.history().made() == made + 1);
    }
}

#[test]
fn an_older_version_is_opened_as_a_step() {
    let dir = folder();
    {
        let mut it = open(&dir).document;
        it.edit(&moved(-6.0)).unwrap();
    }
    let mut it = open(&dir).document;
    it.edit(&moved(-7.0)).unwrap();
    let newest = versions(dir.path())[0];
    let old = read_version(dir.path(), newest).unwrap();
    assert_eq!(old.find("wall").unwrap().1.at.z, -6.0);
    let plan = it
        .plan_room(old, antipode_workshop::Said::new("version"))
        .unwrap();
    it.commit(plan).unwrap();
    assert_eq!(z(&it), -6.0);
    it.undo(1).unwrap();
    assert_eq!(z(&it), -7.0);
}

#[test]
fn what_cannot_be_saved_is_told_and_kept_in_the_journal() {
    let dir = folder();
    let mut it = open(&dir).document;
    it.command(&[
        "add",
        "portal",
        "name=door",
        "at=0,1,3",
        "size=1,2",
        "to=other",
    ])
    .unwrap();
    let said = it.save_now().unwrap_err().to_string();
    assert!(said.contains("\"door\""), "{said}");
    assert_eq!(text(&dir), BY_HAND);
    drop(it);
    assert!(open(&dir).document.room().find("door").is_some());
}

#[test]
fn the_newest_thousand_steps_outlive_a_journal_that_has_grown_long() {
    let dir = folder();
    {
        let mut it = open(&dir).document;
        for number in 0..2100 {
            it.edit(&moved(-f64::from(number) / 4.0)).unwrap();
        }
    }
    let length = |dir: &Path| {
        fs::metadata(dir.join(FOLDER).join("journal"))
            .unwrap()
            .len()
    };
    let before = length(dir.path());
    let mut it = open(&dir).document;
    assert!(length(dir.path()) < before * 2 / 3);
    assert_eq!(it.history().made(), 1000);
    it.undo(1000).unwrap();
    assert_eq!(z(&it), -1099.0 / 4.0);
    it.redo(1000).unwrap();
    assert_eq!(z(&it), -2099.0 / 4.0);
    drop(it);
    assert_eq!(open(&dir).document.history().made(), 1000);
}

#[test]
fn a_room_of_the_file_is_a_room_again() {
    let dir = folder();
    let it = open(&dir).document;
    let room: Room = read(ROOM_FILE, BY_HAND.as_bytes()).unwrap();
    assert_eq!(*it.room(), room);
    assert!(it.is_saved());
}
