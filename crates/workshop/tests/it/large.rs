//! A room of as many objects as there may be: how long edits keep the thread that makes them.

use std::fs;
use std::time::{Duration, Instant};

use antipode_rooms::bounds::MOST_OBJECTS;
use antipode_rooms::files::ROOM_FILE;
use antipode_rooms::{Room, read, write};
use antipode_workshop::{Array, Clip, Document, Edit, Field};
use glam::DVec3;

/// What the window's thread has for an edit.
const BUDGET: Duration = Duration::from_millis(8);

/// 1,990 objects: 200 aberrations, 64 portals, 100 groups of three balls, and blocks.
pub fn large() -> Room {
    let mut objects = Vec::new();
    let mut add = |name: String, rest: String| {
        let number = objects.len();
        let (x, z) = ((number % 50) as f64, (number / 50) as f64);
        let at = format!("({}, 2, {})", x * 10.0 - 250.0, z * 10.0 - 250.0);
        objects.push(format!("(name: \"{name}\", at: {at}, {rest})"));
    };
    let hall =
        "turn: (20, 0, 0), what: Aberration(half: (2, 1, 3), axis: Z, felt: 30, sides: Soft)";
    for number in 0..200 {
        add(format!("hall {number}"), hall.to_owned());
    }
    for number in 0..64 {
        let portal = format!("what: Portal(size: (1, 2), to: \"door {}\")", number ^ 1);
        add(format!("door {number}"), portal);
    }
    for group in 0..100 {
        add(
            format!("group {group}"),
            "turn: (5, 0, 0), what: Group".to_owned(),
        );
        for part in 0..3 {
            let ball =
                format!("what: Ball(radius: 0.3), group: \"group {group}\", surface: (glow: 0.5)");
            add(format!("part {group} {part}"), ball);
        }
    }
    let block = "what: Box(size: (1, 1, 1)), surface: (colour: \"#102030\", checker: (colour: \"#ffffff\"))";
    for number in 0..MOST_OBJECTS - 10 - 664 {
        add(format!("block {number}"), block.to_owned());
    }
    let text = format!(
        "(version: 1, name: \"Large\", objects: [{}])",
        objects.join(",\n")
    );
    read(ROOM_FILE, text.as_bytes()).unwrap()
}

fn names(room: &Room, of: &str) -> Vec<String> {
    let all = room.objects.iter().map(|it| it.name.clone());
    all.filter(|it| it.starts_with(of)).collect()
}

/// Every kind of edit, the worst of it as to how much it touches.
fn edits(room: &Room) -> Vec<(&'static str, Edit)> {
    let all: Vec<String> = room.objects.iter().map(|it| it.name.clone()).collect();
    let blocks = names(room, "block");
    let by = DVec3::new(0.0, 3.0, 0.0);
    let at = |name: &String| {
        Edit::Change(
            name.clone(),
            vec![Field::three("at", DVec3::new(1.0, 90.0, 1.0))],
        )
    };
    vec![
        ("move one", at(&blocks[3])),
        ("move an aberration", at(&"hall 7".to_owned())),
        ("move a portal", at(&"door 7".to_owned())),
        (
            "colour 2,000",
            Edit::change_all(&all, &Field::new("glow", "0.25")),
        ),
        ("rename", Edit::rename("group 5", "house")),
        (
            "group 1,000",
            Edit::Group {
                name: "all".to_owned(),
                at: by,
                members: blocks[..1000].to_vec(),
            },
        ),
        (
            "carry out 1,000",
            Edit::Carry {
                group: None,
                members: blocks[..1000].to_vec(),
            },
        ),
        (
            "ungroup 99",
            Edit::Ungroup(names(room, "group")[6..].to_vec()),
        ),
        ("remove 900", Edit::Remove(blocks[..900].to_vec())),
        (
            "duplicate 500",
            Edit::Duplicate {
                names: blocks[900..].iter().take(500).cloned().collect(),
                by,
            },
        ),
        (
            "array 200",
            Edit::Array(Array {
                names: vec![blocks[950].clone()],
                count: 200,
                step: by / 3.0,
                turn_deg: 5.0,
                about: Some(DVec3::ZERO),
            }),
        ),
        (
            "paste 100",
            Edit::Paste {
                clip: Clip::of(
                    room,
                    &blocks[950..].iter().take(100).cloned().collect::<Vec<_>>(),
                ),
                by,
                is_part: false,
            },
        ),
        ("gravity", Edit::Room(vec![Field::new("gravity", "0,-1,0")])),
    ]
}

/// Prints; `cargo test --release -p antipode-workshop large -- --nocapture`. Asserts with slack, since others use the machine.
#[test]
fn every_edit_of_a_room_of_two_thousand_objects_is_made_between_two_frames() {
    let dir = tempfile::tempdir().unwrap();
    fs::write(dir.path().join(ROOM_FILE), write(&large()).unwrap()).unwrap();
    let mut it = Document::open(dir.path()).unwrap().document;
    let mut slowest = Duration::ZERO;
    for (what, edit) in edits(&it.room_shared()) {
        let mut best = Duration::MAX;
        for _ in 0..3 {
            let before = Instant::now();
            it.edit(&edit).unwrap();
            let there = before.elapsed();
            let before = Instant::now();
            it.undo(1).unwrap();
            best = best.min(there.max(before.elapsed()));
        }
        it.redo(1).unwrap();
        println!("{what}: {best:?} with {} objects", it.room().objects.len());
        slowest = slowest.max(best);
    }
    println!("the slowest: {slowest:?} of {BUDGET:?}");
    assert!(slowest < 3 * BUDGET, "{slowest:?}");
}
