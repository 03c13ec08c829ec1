//! What edits make of a room, as one who builds with them sees it.

use antipode_rooms::{Object, Room, What, poses, read_so_far};
use antipode_workshop::{Arg, Array, Clip, Document, Edit, Field, Placed, WorkshopError};
use glam::{DAffine3, DVec3};

const ROOM: &str = r#"(version: 1, name: "Hut", objects: [
    (name: "post", at: (1, 2, 3), turn: (30, 0, 0), what: Box(size: (1, 2, 0.2))),
    (name: "house", at: (10, 0, 0), turn: (90, 0, 0), what: Group),
    (name: "wall", at: (0, 1, -5), group: "house", what: Box(size: (4, 2, 0.2))),
    (name: "wing", at: (0, 0, 4), turn: (45, 0, 0), group: "house", what: Group),
    (name: "lamp", at: (0, 3, 1), turn: (0, 10, 20), group: "wing", what: Light(power: 2)),
    (name: "here", at: (0, 1.25, -6), what: Portal(size: (1, 2), to: "there")),
    (name: "there", at: (30, 1.25, 0), what: Portal(size: (1, 2), to: "here")),
])"#;

fn document() -> Document {
    Document::new(read_so_far("room.ron", ROOM.as_bytes()).unwrap())
}

fn names(names: &[&str]) -> Vec<String> {
    names.iter().map(|it| (*it).to_owned()).collect()
}

fn pose(room: &Room, name: &str) -> DAffine3 {
    poses(room)[room.find(name).unwrap().0]
}

#[track_caller]
fn is_near(a: DAffine3, b: DAffine3) {
    let far = a.translation.distance(b.translation);
    let turned = (a.matrix3 - b.matrix3)
        .to_cols_array()
        .into_iter()
        .fold(0.0, |most: f64, it| most.max(it.abs()));
    assert!(far < 1e-5 && turned < 1e-6, "{a:?} {b:?}");
}

fn to(room: &Room, name: &str) -> String {
    let What::Portal(it) = &room.find(name).unwrap().1.what else {
        panic!("{name} is no portal");
    };
    it.to.clone()
}

#[test]
fn copies_of_a_pair_lead_to_each_other_and_a_copy_of_one_to_itself() {
    let mut it = document();
    let by = DVec3::new(0.0, 4.0, 0.0);
    it.edit(&Edit::Duplicate {
        names: names(&["here", "there"]),
        by,
    })
    .unwrap();
    let room = it.room();
    assert_eq!(
        (to(room, "here 2"), to(room, "there 2")),
        ("there 2".to_owned(), "here 2".to_owned())
    );
    assert_eq!(
        (to(room, "here"), to(room, "there")),
        ("there".to_owned(), "here".to_owned())
    );
    assert_eq!(
        pose(room, "here 2").translation,
        DVec3::new(0.0, 5.25, -6.0)
    );
    assert_eq!(it.selection(), names(&["here 2", "there 2"]));
    it.edit(&Edit::Duplicate {
        names: names(&["here"]),
        by: by * 2.0,
    })
    .unwrap();
    assert_eq!(to(it.room(), "here 3"), "here 3");
    assert!(
        antipode_rooms::check(it.room()).is_ok(),
        "what leads to itself is sound"
    );
    // In another room, by the clipboard's text.
    it.select(names(&["here", "there", "house"]));
    let clip = Clip::parse(&it.copy().text()).unwrap();
    let mut other = Document::new(Room::new("Other"));
    for (is_part, id) in [(true, "add"), (false, "paste")] {
        other.undo(1).ok();
        let (clip, by) = (clip.clone(), DVec3::ZERO);
        other.edit(&Edit::Paste { clip, by, is_part }).unwrap();
        assert_eq!(other.history().steps()[0].said.id, id);
    }
    assert_eq!(
        (to(other.room(), "here"), to(other.room(), "there")),
        ("there".to_owned(), "here".to_owned())
    );
    is_near(pose(other.room(), "lamp"), pose(it.room(), "lamp"));
    assert!(Clip::parse("no room").is_err());
}

#[test]
fn what_is_carried_elsewhere_stays_where_it_is() {
    let mut it = document();
    let before = it.room().clone();
    let all = ["post", "wall", "lamp", "wing"];
    for edit in [
        Edit::Carry {
            group: Some("wing".to_owned()),
            members: names(&["post", "wall"]),
        },
        Edit::Carry {
            group: None,
            members: names(&["post", "lamp"]),
        },
        Edit::Group {
            name: "all".to_owned(),
            at: DVec3::new(1.0, 2.0, 3.0),
            members: names(&["post", "house"]),
        },
        Edit::Ungroup(names(&["house", "wing"])),
    ] {
        it.edit(&edit).unwrap();
        for name in all.iter().filter(|name| it.room().find(name).is_some()) {
            is_near(pose(it.room(), name), pose(&before, name));
        }
    }
    let group = |name: &str| it.room().find(name).unwrap().1.group.clone();
    assert_eq!(
        (group("wall"), group("lamp")),
        (Some("all".to_owned()), None)
    );
    assert_eq!(group("post"), Some("all".to_owned()));
    it.undo(4).unwrap();
    assert_eq!(*it.room(), before, "every digit");
    let round = Edit::Carry {
        group: Some("wing".to_owned()),
        members: names(&["house"]),
    };
    assert!(
        it.edit(&round)
            .unwrap_err()
            .to_string()
            .contains("carries itself")
    );
}

#[test]
fn arrays_go_in_rows_and_in_rings() {
    let mut it = document();
    let row = Array {
        names: names(&["lamp"]),
        count: 3,
        step: DVec3::X,
        turn_deg: 0.0,
        about: None,
    };
    let at = |it: &Document, name: &str| pose(it.room(), name).translation;
    let start = at(&it, "lamp");
    it.edit(&Edit::Array(row.clone())).unwrap();
    for (number, name) in (1..=3).zip(["lamp 2", "lamp 3", "lamp 4"]) {
        let expected = start + DVec3::X * f64::from(number);
        assert!(
            at(&it, name).distance(expected) < 1e-5,
            "along the room's axes, not the group's"
        );
    }
    let ring = Array {
        names: names(&["post"]),
        count: 3,
        step: DVec3::ZERO,
        turn_deg: 90.0,
        about: Some(DVec3::ZERO),
    };
    it.edit(&Edit::Array(ring)).unwrap();
    // A yaw of 90 degrees takes +x to +z.
    let expected = [(-3.0, 1.0), (-1.0, -3.0), (3.0, -1.0)];
    for ((x, z), name) in expected.into_iter().zip(["post 2", "post 3", "post 4"]) {
        assert!(
            at(&it, name).distance(DVec3::new(x, 2.0, z)) < 1e-5,
            "{name}"
        );
    }
    assert_eq!(
        it.room().find("post 2").unwrap().1.turn,
        DVec3::new(120.0, 0.0, 0.0)
    );
    let none = Edit::Array(Array { count: 0, ..row });
    assert!(it.edit(&none).is_err());
}

#[test]
fn what_is_locked_is_not_changed_but_copied_and_undone() {
    let mut it = document();
    let up = |name: &str| Edit::Change(name.to_owned(), vec![Field::new("at", "0,9,0")]);
    it.edit(&up("lamp")).unwrap();
    it.lock("house", true);
    for edit in [
        up("house"),
        up("lamp"),
        Edit::Remove(names(&["post", "wall"])),
        Edit::Carry {
            group: None,
            members: names(&["wing"]),
        },
        Edit::Several(vec![up("post"), up("wall")]),
        Edit::Place(vec![placed("wall", Some(DVec3::Y), None)]),
    ] {
        assert!(
            matches!(it.edit(&edit), Err(WorkshopError::Locked(_))),
            "{edit:?}"
        );
    }
    assert!(
        matches!(it.command(&["remove", "house"]), Err(WorkshopError::Locked(name)) if name == "house")
    );
    it.begin_drag();
    assert!(it.drag(&up("lamp")).is_err());
    it.end_drag();
    it.edit(&Edit::Duplicate {
        names: names(&["lamp"]),
        by: DVec3::X,
    })
    .unwrap();
    it.undo(2).unwrap();
    assert_eq!(
        it.room().find("lamp").unwrap().1.at,
        DVec3::new(0.0, 3.0, 1.0)
    );
    it.lock("house", false);
    it.edit(&up("wall")).unwrap();
}

#[test]
fn names_are_followed_by_links_groups_and_what_is_selected() {
    let mut it = document();
    it.select(names(&["here", "house"]));
    it.lock("post", true);
    it.edit(&Edit::rename("here", "door")).unwrap();
    it.edit(&Edit::rename("house", "barn")).unwrap();
    assert_eq!(to(it.room(), "there"), "door");
    assert_eq!(
        it.room().find("wall").unwrap().1.group.as_deref(),
        Some("barn")
    );
    assert_eq!(it.selection(), names(&["door", "barn"]));
    it.undo(2).unwrap();
    assert_eq!(it.selection(), names(&["here", "house"]));
    it.edit(&Edit::Remove(names(&["house"]))).unwrap();
    assert_eq!(it.selection(), names(&["here"]));
    assert!(it.room().find("lamp").is_none() && it.is_locked("post"));
}

#[test]
fn a_drag_is_one_step_that_counts_from_its_beginning() {
    let mut it = document();
    let before = it.room().clone();
    let moved = |x: f64| {
        Edit::Change(
            "post".to_owned(),
            vec![Field::three("at", DVec3::new(x, 2.0, 3.0))],
        )
    };
    it.begin_drag();
    assert!(!it.end_drag(), "nothing was done");
    it.begin_drag();
    for x in 0..50 {
        it.drag(&moved(f64::from(x))).unwrap();
    }
    assert!(it.drag(&moved(5000.0)).is_err(), "that far is nothing");
    assert_eq!(it.room().find("post").unwrap().1.at.x, 49.0);
    assert!(it.end_drag());
    assert_eq!(it.history().made(), 1);
    it.undo(1).unwrap();
    assert_eq!(*it.room(), before);
    it.begin_drag();
    it.drag(&moved(7.0)).unwrap();
    it.cancel_drag();
    assert_eq!(*it.room(), before);
    assert_eq!(
        it.history().steps().len(),
        1,
        "what was undone can be made again"
    );
    it.redo(1).unwrap();
    it.begin_drag();
    it.drag(&moved(8.0)).unwrap();
    it.edit(&Edit::Remove(names(&["wall"]))).unwrap();
    let said: Vec<_> = it
        .history()
        .steps()
        .iter()
        .map(|it| it.said.id.as_str())
        .collect();
    assert_eq!(
        said,
        ["move", "move", "remove"],
        "a drag that is left ends as a step"
    );
}

#[test]
fn steps_are_told_and_one_goes_to_any_of_them() {
    let mut it = document();
    let several = Edit::change_all(&names(&["post", "wall"]), &Field::new("colour", "#010203"));
    it.edit(&several).unwrap();
    it.edit(&Edit::rename("post", "pole")).unwrap();
    it.edit(&Edit::Insert(Object::new(
        "ball",
        DVec3::ZERO,
        What::Ball { radius: 1.0 },
    )))
    .unwrap();
    let told: Vec<_> = it
        .history()
        .steps()
        .iter()
        .map(|it| it.said.clone())
        .collect();
    assert_eq!(
        (
            told[0].id.as_str(),
            told[1].id.as_str(),
            told[2].id.as_str()
        ),
        ("surface", "rename", "add")
    );
    assert!(
        told[0]
            .args
            .contains(&("count".to_owned(), Arg::Number(2.0)))
    );
    assert!(
        told[1]
            .args
            .contains(&("new".to_owned(), Arg::Text("pole".to_owned())))
    );
    let end = it.room().clone();
    it.jump(1).unwrap();
    assert!(it.room().find("post").is_some() && it.room().find("ball").is_none());
    assert_eq!(
        it.room().find("wall").unwrap().1.surface.colour.to_string(),
        "#010203"
    );
    it.jump(99).unwrap();
    assert_eq!(*it.room(), end);
    it.jump(0).unwrap();
    assert_eq!(*it.room(), *document().room());
}

#[test]
fn what_was_planned_of_an_older_room_is_refused() {
    let mut it = document();
    let plan = it.plan(&Edit::Remove(names(&["post"]))).unwrap();
    it.edit(&Edit::Remove(names(&["wall"]))).unwrap();
    assert!(
        it.commit(plan)
            .unwrap_err()
            .to_string()
            .contains("meanwhile")
    );
    assert!(it.room().find("post").is_some());
}

fn placed(name: &str, at: Option<DVec3>, turn: Option<DVec3>) -> Placed {
    let name = name.to_owned();
    Placed { name, at, turn }
}

#[test]
fn what_is_put_elsewhere_is_told_as_a_change_of_its_fields_is() {
    let (at, turn) = (Some(DVec3::Y), Some(DVec3::new(30.0, 0.0, 0.0)));
    for (at, turn, id) in [(at, None, "move"), (None, turn, "turn"), (at, turn, "pose")] {
        let mut one = document();
        let mut other = one.clone();
        let edit = Edit::Place(vec![placed("lamp", at, turn), placed("wall", at, turn)]);
        let words = edit.words(one.room());
        one.edit(&edit).unwrap();
        other
            .command(&words.iter().map(String::as_str).collect::<Vec<_>>())
            .unwrap();
        assert_eq!(one.history().steps(), other.history().steps());
        assert_eq!(one.history().steps()[0].said.id, id);
    }
    let nobody = Edit::Place(vec![placed("nobody", at, None)]);
    assert!(document().edit(&nobody).is_err());
}
