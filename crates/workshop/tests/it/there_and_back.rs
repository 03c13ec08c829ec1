//! Five hundred edits of every kind by commands, over a save and a restart, all the way back and all the way there again.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use antipode_rooms::files::ROOM_FILE;
use antipode_rooms::wording::words_of;
use antipode_rooms::words::{Pairs, new_object};
use antipode_rooms::{Object, Room, What, check, space_in_parts};
use antipode_workshop::words::{Command, parse};
use antipode_workshop::{Array, Clip, Delta, Document, Edit, Field, Placed, fields_of, make};
use fastrand::Rng;
use glam::DVec3;
use proptest::prelude::*;

const STEPS: usize = 500;
const EACH: usize = 20;
const BEGINNING: &str = r#"// A room with words of its own.
(version: 1, name: "Hut", objects: [
    (name: "floor", at: (0, -0.5, 0), what: Box(size: (200, 1, 200))),
    (name: "hall", at: (0, 5, -30), what: Aberration(half: (2, 2, 4), axis: Z, felt: 40, sides: Soft)), // soft
    (name: "one", at: (0, 2, 20), what: Portal(size: (1, 2), to: "other")),
    (name: "other", at: (9, 2, 20), what: Portal(size: (1, 2), to: "one")),
])
"#;

const KINDS: [&str; 15] = [
    "insert",
    "remove",
    "change",
    "place",
    "rename",
    "group",
    "carry",
    "ungroup",
    "duplicate",
    "array",
    "paste",
    "room",
    "spawn",
    "several",
    "drag",
];

fn place(random: &mut Rng) -> DVec3 {
    let mut one = || (random.f64() * 80.0 - 40.0) * if random.bool() { 1.0 } else { 0.1 };
    DVec3::new(one(), one() + 50.0, one())
}

fn some(room: &Room, random: &mut Rng, is: impl Fn(&Object) -> bool) -> Option<String> {
    let all: Vec<_> = room.objects.iter().filter(|it| is(it)).collect();
    (!all.is_empty()).then(|| all[random.usize(..all.len())].name.clone())
}

/// One to four different objects.
fn several(room: &Room, random: &mut Rng) -> Vec<String> {
    let mut names: Vec<_> = (0..=random.usize(..4))
        .filter_map(|_| some(room, random, |_| true))
        .collect();
    names.sort();
    names.dedup();
    names
}

fn a_word(random: &mut Rng) -> String {
    let words = [
        "post",
        "wall",
        "Säule 2",
        "a b",
        "x.y",
        "lamp-1",
        "none of it",
    ];
    format!(
        "{} {}",
        words[random.usize(..words.len())],
        random.u32(..10_000)
    )
}

fn new(random: &mut Rng) -> Object {
    let what = match random.u8(..6) {
        0 => What::Box {
            size: DVec3::new(1.0, 2.0, 0.1 + random.f64()),
        },
        1 => What::Ball {
            radius: 0.01 + random.f64(),
        },
        2 => What::Stairs {
            size: DVec3::splat(2.0),
            steps: random.u32(1..20),
        },
        3 => What::Sign {
            text: Some("Look; = \"here\"".to_owned()),
            size: glam::DVec2::ONE,
        },
        4 => What::Cylinder {
            radius: 0.1 + random.f64(),
            height: 3.0,
        },
        _ => What::Group,
    };
    let mut object = Object::new(&a_word(random), place(random), what);
    object.turn = DVec3::new(random.f64() * 360.0 - 180.0, random.f64() * 90.0, 10.0);
    object.surface.glow = if random.bool() { 0.0 } else { random.f64() };
    object
}

fn change(room: &Room, random: &mut Rng) -> Option<Edit> {
    let name = some(room, random, |_| true)?;
    let field = match random.u8(..4) {
        0 => Field::three("at", place(random)),
        1 => Field::three(
            "turn",
            DVec3::new(random.f64() * 90.0, random.f64(), -random.f64()),
        ),
        2 => Field::new("colour", format!("#{:06x}", random.u32(..0x100_0000))),
        _ => Field::new("checker", ["#102030,0.5", "none"][random.usize(..2)]),
    };
    Some(Edit::Change(name, vec![field]))
}

fn placed(room: &Room, random: &mut Rng) -> Vec<Placed> {
    let names = several(room, random).into_iter();
    let placed = names.map(|name| {
        let (moves, turns) = [(true, false), (false, true), (true, true)][random.usize(..3)];
        Placed {
            name,
            at: moves.then(|| place(random)),
            turn: turns.then(|| DVec3::new(random.f64() * 90.0, random.f64(), 0.1)),
        }
    });
    placed.collect()
}

/// An edit of that kind, if the room has what it needs.
fn edit(kind: &str, room: &Room, random: &mut Rng) -> Option<Edit> {
    let is_group = |it: &Object| it.what == What::Group;
    let by = DVec3::new(random.f64(), random.f64(), 1.5);
    Some(match kind {
        "insert" => Edit::Insert(new(random)),
        "remove" => Edit::Remove(several(room, random)),
        "change" | "drag" => change(room, random)?,
        "place" => Edit::Place(placed(room, random)),
        "rename" => Edit::rename(&some(room, random, |_| true)?, &a_word(random)),
        "group" => Edit::Group {
            name: a_word(random),
            at: place(random),
            members: several(room, random),
        },
        "carry" => Edit::Carry {
            group: some(room, random, is_group).filter(|_| random.u8(..4) > 0),
            members: several(room, random),
        },
        "ungroup" => Edit::Ungroup(vec![some(room, random, is_group)?]),
        "duplicate" => Edit::Duplicate {
            names: several(room, random),
            by,
        },
        "array" => Edit::Array(Array {
            names: several(room, random),
            count: random.u32(1..4),
            step: by,
            turn_deg: [0.0, 30.0][random.usize(..2)],
            about: random.bool().then_some(DVec3::new(1.0, 0.0, 2.0)),
        }),
        "paste" => Edit::Paste {
            clip: Clip::of(room, &several(room, random)),
            by,
            is_part: false,
        },
        "room" => {
            let fields = [
                "gravity=0,-1.625,0",
                "sun=none",
                "sun=10,20",
                "fog=300",
                "fog=none",
                "light=0.75",
                "sentence=So; it = is",
                "sky=#123456",
            ];
            let (key, value) = fields[random.usize(..fields.len())].split_once('=')?;
            Edit::Room(vec![Field::new(key, value)])
        }
        "spawn" => Edit::Spawn(vec![
            Field::three("at", place(random)),
            Field::new("look", "30,-5"),
        ]),
        _ => Edit::Several(vec![
            change(room, random)?,
            Edit::Insert(new(random)),
            change(room, random)?,
        ]),
    })
}

/// Makes an edit of that kind, by the words of a command where it has them; whether it was a step.
fn done(document: &mut Document, kind: &str, random: &mut Rng) -> bool {
    let Some(edit) = edit(kind, document.room(), random) else {
        return false;
    };
    let made = document.history().made();
    if kind == "drag" {
        document.begin_drag();
        for _ in 0..3 {
            if let Some(edit) = change(document.room_before_drag(), random) {
                let _ = document.drag(&edit);
            }
        }
        let _ = document.drag(&edit);
        document.end_drag();
        return document.history().made() > made;
    }
    let words = edit.words(document.room());
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let Command::Edit(read) = parse(document.room(), &words).unwrap() else {
        panic!("{words:?}");
    };
    let both = [make(document.room(), &edit), make(document.room(), &read)];
    match &both {
        [Ok(a), Ok(b)] => assert_eq!(a, b, "{words:?}"),
        [Err(_), Err(_)] => {}
        other => panic!("{words:?}: {other:?}"),
    }
    document.command(&words).is_ok() && document.history().made() > made
}

/// Takes away what does not fit, so that the room can be saved.
fn mend(document: &mut Document) {
    while check(document.room()).is_err() {
        let closed = space_in_parts(document.room()).closed;
        let names = closed
            .iter()
            .map(|(index, _)| document.room().objects[*index].name.clone());
        let names = names.collect::<BTreeSet<_>>().into_iter().collect();
        document.edit(&Edit::Remove(names)).unwrap();
    }
}

fn files(dir: &Path) -> BTreeMap<String, Vec<u8>> {
    let entries = fs::read_dir(dir).unwrap().flatten();
    let files = entries.filter(|it| it.path().is_file());
    files
        .map(|it| {
            (
                it.file_name().into_string().unwrap(),
                fs::read(it.path()).unwrap(),
            )
        })
        .collect()
}

fn reopened(document: Document, dir: &Path) -> Document {
    drop(document);
    let opened = Document::open(dir).unwrap();
    assert!(!opened.was_changed && opened.aside.is_none());
    opened.document
}

#[test]
fn five_hundred_edits_of_every_kind_lead_back_and_there_again_byte_for_byte() {
    let dir = tempfile::tempdir().unwrap();
    let dir = dir.path();
    fs::write(dir.join(ROOM_FILE), BEGINNING).unwrap();
    fs::write(dir.join("notes.txt"), "mine").unwrap();
    let beginning = files(dir);
    let mut random = Rng::with_seed(24);
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    let mut it = Document::open(dir).unwrap().document;
    while it.history().made() < STEPS {
        let left = KINDS
            .iter()
            .filter(|kind| counts.get(*kind).is_none_or(|it| *it < EACH));
        let left: Vec<_> = left.collect();
        let kind = match left.as_slice() {
            _ if it.room().objects.len() > 150 => "remove",
            [] => KINDS[random.usize(..KINDS.len())],
            left => left[random.usize(..left.len())],
        };
        if done(&mut it, kind, &mut random) {
            *counts.entry(kind).or_default() += 1;
            if it.history().made() == STEPS / 2 {
                mend(&mut it);
                it.save_now().unwrap();
                let made = it.history().made();
                it = reopened(it, dir);
                assert_eq!(it.history().made(), made);
            }
        }
    }
    assert!(KINDS.iter().all(|kind| counts[kind] >= EACH), "{counts:?}");
    mend(&mut it);
    let (end_room, made) = (it.room_shared(), it.history().made());
    it.save_now().unwrap();
    let end = files(dir);
    assert_ne!(beginning, end);
    it = reopened(it, dir);
    for _ in 0..made {
        it.undo(1).unwrap();
    }
    assert!(it.undo(1).is_err());
    it.save_now().unwrap();
    assert_eq!(files(dir), beginning);
    it = reopened(it, dir);
    for _ in 0..made {
        it.redo(1).unwrap();
    }
    assert_eq!(*it.room(), *end_room);
    it.save_now().unwrap();
    assert_eq!(files(dir), end);
}

#[test]
fn a_room_has_fields_that_make_it_again() {
    let mut room = Room::new("A");
    for sun in ["none", "5,6"] {
        let edit = Edit::Room(vec![
            Field::new("sun", sun),
            Field::new("fog", "50"),
            Field::new("sun-power", "3"),
        ]);
        room = make(&room, &edit).unwrap();
        let other = make(&Room::new("B"), &Edit::Room(fields_of(&room))).unwrap();
        assert_eq!(
            Room {
                objects: Vec::new(),
                ..other
            },
            Room {
                objects: Vec::new(),
                ..room.clone()
            }
        );
    }
}

#[test]
fn objects_of_the_rooms_of_the_game_have_words_that_make_them_again() {
    for shipped in antipode_rooms::shipped::ROOMS {
        for object in &shipped.room().unwrap().objects {
            let words = words_of(object);
            let pairs = words.iter().map(|(key, value)| (*key, value.as_str()));
            let made = new_object(object.what.kind(), &Pairs::from_pairs(pairs).unwrap()).unwrap();
            assert_eq!(made, **object, "{words:?}");
        }
    }
}

fn room_of(objects: &[(u8, u8)]) -> Room {
    let mut room = Room::new("A");
    room.objects.clear();
    for (name, radius) in objects {
        let name = format!("o{name}");
        if room.find(&name).is_none() {
            let radius = f64::from(*radius) + 1.0;
            room.push(Object::new(&name, DVec3::ZERO, What::Ball { radius }));
        }
    }
    room
}

proptest! {
    #[test]
    fn a_difference_leads_there_and_back(
        old in prop::collection::vec((0..9_u8, 0..3_u8), 0..9),
        new in prop::collection::vec((0..9_u8, 0..3_u8), 0..9),
    ) {
        let (old, new) = (room_of(&old), room_of(&new));
        let delta = Delta::between(&old, &new);
        let mut room = old.clone();
        delta.make(&mut room);
        prop_assert_eq!(&room, &new);
        delta.take_back(&mut room);
        prop_assert_eq!(&room, &old);
        prop_assert_eq!(delta.is_empty(), old == new);
    }
}
