//! The directory of rooms: as worlds are made, renamed, doubled, deleted, given away and taken in.

use std::fs;
use std::path::{Path, PathBuf};

use antipode_rooms::room::{Object, What};
use antipode_rooms::{ARCHIVE, Room, RoomsDir, folder, write};
use antipode_storage::{pack_archive, unpack_archive};
use glam::DVec3;
use tempfile::TempDir;

const LAMP: &[u8] = include_bytes!("../../../../assets/models/lamp.glb");

fn place() -> (TempDir, RoomsDir) {
    let dir = tempfile::tempdir().unwrap();
    let rooms = RoomsDir::new(dir.path().join("rooms"));
    (dir, rooms)
}

fn names(rooms: &RoomsDir) -> Vec<String> {
    let own = rooms.list().unwrap().into_iter().filter(|it| !it.shipped);
    own.map(|it| it.name).collect()
}

/// Everything in a directory, hidden things too.
fn entries(dir: &Path) -> Vec<String> {
    let mut names: Vec<_> = fs::read_dir(dir)
        .unwrap()
        .map(|it| it.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names.retain(|it| it != ".antipode.lock");
    names
}

/// A room with a model, made by hand.
fn with_model(rooms: &RoomsDir) -> PathBuf {
    let mut room = Room::new("House");
    let what = What::Model {
        file: "models/lamp.glb".to_owned(),
        scale: 1.0,
    };
    room.push(Object::new("it", DVec3::ZERO, what));
    let dir = rooms.path().join(rooms.make(&Room::new("House")).unwrap());
    fs::create_dir(dir.join("models")).unwrap();
    fs::write(dir.join("models/lamp.glb"), LAMP).unwrap();
    fs::write(dir.join("notes.txt"), "mine").unwrap();
    let text = write(&room).unwrap().replace(
        "    name: \"House\",",
        "    // My house.\n    name: \"House\",",
    );
    fs::write(dir.join("room.ron"), text).unwrap();
    dir
}

#[test]
fn rooms_are_made_found_renamed_doubled_and_deleted() {
    let (_dir, rooms) = place();
    assert_eq!(names(&rooms), Vec::<String>::new());
    let dir = with_model(&rooms);
    assert_eq!(dir.file_name().unwrap(), "house");
    let house = rooms.find("HOUSE").unwrap();
    assert_eq!(
        (house.slug.as_str(), house.objects, house.problem.as_deref()),
        ("house", 2, None)
    );
    let said = rooms.make(&Room::new("house")).unwrap_err().to_string();
    assert_eq!(said, "There is a room called \"House\" already.");
    let copy = rooms.double(&house).unwrap();
    assert_eq!(names(&rooms), ["House", "House 2"]);
    assert!(rooms.path().join(&copy).join("models/lamp.glb").exists());
    assert!(
        !rooms.path().join(&copy).join("notes.txt").exists(),
        "what is no part of the room stays behind"
    );
    rooms.rename(&house, "Barn").unwrap();
    let text = fs::read_to_string(dir.join("room.ron")).unwrap();
    assert!(text.contains("// My house.\n    name: \"Barn\","), "{text}");
    assert!(
        rooms
            .rename(&rooms.find("Barn").unwrap(), "house 2")
            .is_err()
    );
    let said = rooms.rename(&house, " ").unwrap_err().to_string();
    assert!(said.contains("one character"), "{said}");
    rooms.rename(&rooms.find("barn").unwrap(), "BARN").unwrap();
    rooms.delete(&rooms.find("House 2").unwrap()).unwrap();
    assert_eq!(names(&rooms), ["BARN"]);
    assert_eq!(entries(rooms.path()), ["house"]);
    let said = rooms.find("House 2").unwrap_err().to_string();
    assert!(said.contains("no room \"House 2\""), "{said}");
}

#[test]
fn rooms_of_the_game_are_copied_to_be_changed() {
    let (_dir, rooms) = place();
    let shipped = rooms.find("the long house").unwrap();
    assert!(shipped.shipped);
    assert!(
        rooms
            .delete(&shipped)
            .unwrap_err()
            .to_string()
            .contains("comes with the game")
    );
    assert!(
        rooms
            .rename(&shipped, "Mine")
            .unwrap_err()
            .to_string()
            .contains("Make a copy")
    );
    let slug = rooms.double(&shipped).unwrap();
    assert_eq!(names(&rooms), ["The long house 2"]);
    let copy = rooms.find("The long house 2").unwrap();
    let mut room = rooms.open(&copy).unwrap().room;
    room.object_mut(0).surface.glow = 0.5;
    rooms.save(&slug, &room).unwrap();
    assert_eq!(rooms.open(&copy).unwrap().room, room);
    let mut without_file = room.clone();
    let what = What::Model {
        file: "models/none.glb".to_owned(),
        scale: 1.0,
    };
    without_file.push(Object::new("it", DVec3::ZERO, what));
    let said = rooms.save(&slug, &without_file).unwrap_err().to_string();
    assert!(
        said.contains("file of \"it\"") && said.contains("no such file"),
        "{said}"
    );
    assert_eq!(rooms.open(&copy).unwrap().room, room);
    assert_eq!(rooms.find("long-house").unwrap(), shipped);
}

#[test]
fn a_bad_room_is_listed_with_what_is_wrong() {
    let (_dir, rooms) = place();
    with_model(&rooms);
    fs::create_dir(rooms.path().join("bad")).unwrap();
    fs::write(
        rooms.path().join("bad/room.ron"),
        "(\n    version: 1,\n    name: 7,\n)",
    )
    .unwrap();
    let bad = rooms.find("bad").unwrap();
    let problem = bad.problem.clone().unwrap();
    assert!(
        problem.contains("bad/room.ron:3: name cannot be read"),
        "{problem}"
    );
    assert_eq!(names(&rooms), ["bad", "House"]);
    assert_eq!(rooms.open(&bad).unwrap_err().to_string(), problem);
    assert!(rooms.export(&bad, &rooms.path().join("x")).is_err());
    assert_eq!(entries(rooms.path()), ["bad", "house"]);
    rooms.delete(&bad).unwrap();
}

#[test]
fn what_is_exported_can_be_imported_under_a_free_name() {
    let (dir, rooms) = place();
    with_model(&rooms);
    let file = dir.path().join("house.antipode-room");
    rooms.export(&rooms.find("House").unwrap(), &file).unwrap();
    let said = rooms
        .export(&rooms.find("House").unwrap(), &file)
        .unwrap_err()
        .to_string();
    assert!(said.contains("exists already"), "{said}");
    for wanted in ["House 2", "House 3"] {
        let slug = rooms.import(&file).unwrap();
        let before = folder::open(&rooms.path().join("house")).unwrap();
        let after = folder::open(&rooms.path().join(slug)).unwrap();
        assert_eq!(after.room.name, wanted);
        assert_eq!(
            (after.room.objects, after.assets),
            (before.room.objects, before.assets)
        );
    }
    let shipped = dir.path().join("tunnels");
    rooms
        .export(&rooms.find("Four tunnels").unwrap(), &shipped)
        .unwrap();
    rooms.import(&shipped).unwrap();
    assert!(names(&rooms).contains(&"Four tunnels 2".to_owned()));
    assert_eq!(
        entries(dir.path()),
        ["house.antipode-room", "rooms", "tunnels"]
    );
}

/// Names and bytes.
type Files<'a> = &'a [(&'a str, &'a [u8])];

/// An archive of these files, as somebody who means harm would pack them.
fn forged(dir: &Path, files: Files<'_>) -> PathBuf {
    let from = tempfile::tempdir().unwrap();
    for (name, bytes) in files {
        fs::create_dir_all(from.path().join(name).parent().unwrap()).unwrap();
        fs::write(from.path().join(name), bytes).unwrap();
    }
    let mut kind = ARCHIVE;
    kind.most_file_bytes = |_| Some(u64::MAX);
    kind.most_bytes = u64::MAX;
    let archive = dir.join("forged");
    let _ = fs::remove_file(&archive);
    let names: Vec<_> = files.iter().map(|(name, _)| *name).collect();
    pack_archive(&kind, from.path(), &names, &archive).unwrap();
    archive
}

#[test]
fn archives_of_strangers_write_nowhere_else_and_leave_nothing() {
    let (dir, rooms) = place();
    with_model(&rooms);
    let sound = write(&Room::new("Sound")).unwrap();
    let unsound = sound.replace("0, -0.5, 0", "0, -5000, 0");
    let missing = write(&folder::open(&rooms.path().join("house")).unwrap().room).unwrap();
    let zeros = vec![0; 40 << 20];
    let cases: &[(Files<'_>, &str)] = &[
        (&[("other.txt", b"x")], "which no room has"),
        (
            &[
                ("room.ron", sound.as_bytes()),
                ("models/../../evil.glb", b"x"),
            ],
            "which no room has",
        ),
        (
            &[("room.ron", sound.as_bytes()), ("models/run.sh", b"x")],
            "which no room has",
        ),
        (
            &[
                ("room.ron", sound.as_bytes()),
                ("models/a.glb", LAMP),
                ("models/A.glb", LAMP),
            ],
            "\"models/A.glb\" twice",
        ),
        (&[("models/a.glb", LAMP)], "there is no room.ron in it"),
        (
            &[("room.ron", unsound.as_bytes())],
            "room.ron:12: at of \"floor\"",
        ),
        (&[("room.ron", missing.as_bytes())], "there is no such file"),
        (
            &[("room.ron", sound.as_bytes()), ("models/a.glb", &zeros)],
            "at most 33554432 make sense",
        ),
    ];
    for (files, words) in cases {
        let archive = forged(dir.path(), files);
        let said = rooms.import(&archive).unwrap_err().to_string();
        assert!(said.contains(words) && said.contains("forged"), "{said}");
        assert!(!said.contains(".antipode-"), "{said}");
        assert_eq!(entries(rooms.path()), ["house"]);
    }
    // A world is no room, nor is something too long.
    let archive = dir.path().join("x");
    fs::write(&archive, b"ANTIPODE\x01\x00\x00END.").unwrap();
    assert!(
        rooms
            .import(&archive)
            .unwrap_err()
            .to_string()
            .contains("no exported room")
    );
    fs::File::create(&archive)
        .unwrap()
        .set_len((32 << 20) + 1)
        .unwrap();
    assert!(
        rooms
            .import(&archive)
            .unwrap_err()
            .to_string()
            .contains("at most 33554432")
    );
    assert!(
        rooms
            .import(&dir.path().join("nothing"))
            .unwrap_err()
            .to_string()
            .contains("no such file")
    );
}

#[test]
fn bombs_are_refused_before_they_are_unpacked() {
    let (dir, rooms) = place();
    let half = vec![0; 30 << 20];
    let names: Vec<String> = (0..6).map(|it| format!("models/{it}.bin")).collect();
    let files: Vec<(&str, &[u8])> = names
        .iter()
        .map(|it| (it.as_str(), half.as_slice()))
        .collect();
    let archive = forged(dir.path(), &files);
    assert!(fs::metadata(&archive).unwrap().len() < 1 << 20);
    let said = rooms.import(&archive).unwrap_err().to_string();
    assert!(said.contains("no room of this game does"), "{said}");
}

#[test]
fn only_what_the_room_uses_comes_in() {
    let (dir, rooms) = place();
    let sound = write(&Room::new("Sound")).unwrap();
    let archive = forged(
        dir.path(),
        &[("room.ron", sound.as_bytes()), ("models/a.glb", LAMP)],
    );
    let slug = rooms.import(&archive).unwrap();
    assert_eq!(entries(&rooms.path().join(slug)), ["room.ron"]);
    let target = tempfile::tempdir().unwrap();
    assert_eq!(
        unpack_archive(&ARCHIVE, &archive, target.path()).unwrap(),
        ["room.ron", "models/a.glb"]
    );
}
