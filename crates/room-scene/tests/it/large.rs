//! A room of as many objects as there may be: what an edit of it makes anew, and how long it keeps the thread that makes it.

use std::time::{Duration, Instant};

use antipode_room_scene::RoomScene;
use antipode_rooms::bounds::MOST_OBJECTS;
use antipode_rooms::files::ROOM_FILE;
use antipode_rooms::{Assets, Room, read};
use antipode_workshop::{Document, Edit, Field};
use glam::DVec3;

/// 1,990 objects of all kinds, most of them blocks: 120 aberrations, 40 portals, 100 groups of three balls, 60 loose crates.
fn large() -> Room {
    let mut objects = Vec::new();
    let mut add = |kind: &str, count: usize, rest: &dyn Fn(usize) -> String| {
        for number in 0..count {
            let place = objects.len();
            let (x, z) = ((place % 50) as f64, (place / 50) as f64);
            let at = format!("({}, 2, {})", x * 10.0 - 250.0, z * 10.0 - 250.0);
            let rest = rest(number);
            objects.push(format!("(name: \"{kind} {number}\", at: {at}, {rest})"));
        }
    };
    add("hall", 120, &|number| {
        let sides = if number % 2 == 0 { "Soft" } else { "Walls" };
        format!("what: Aberration(half: (2, 1, 3), axis: Z, felt: 30, sides: {sides})")
    });
    add("door", 40, &|number| {
        format!("what: Portal(size: (1, 2), to: \"door {}\")", number ^ 1)
    });
    add("group", 100, &|_| "turn: (5, 0, 0), what: Group".to_owned());
    add("ball", 300, &|number| {
        format!(
            "what: Ball(radius: 0.3), group: \"group {}\", surface: (glow: 0.5)",
            number / 3
        )
    });
    add("crate", 60, &|_| {
        "what: Box(size: (0.6, 0.6, 0.6)), mass: 12".to_owned()
    });
    add("post", 60, &|_| {
        "what: Cylinder(radius: 0.3, height: 2)".to_owned()
    });
    add("stair", 60, &|_| {
        "what: Stairs(size: (3, 2, 1.5), steps: 12)".to_owned()
    });
    add("gate", 60, &|_| {
        "what: Arch(size: (0.5, 3, 3), opening: (1.5, 2.25))".to_owned()
    });
    let block = "what: Box(size: (1, 1, 1)), surface: (checker: (colour: \"#ffffff\"))";
    add("block", MOST_OBJECTS - 10 - 800, &|_| block.to_owned());
    let text = objects.join(",\n");
    let text = format!("(version: 1, name: \"Large\", objects: [{text}])");
    read(ROOM_FILE, text.as_bytes()).unwrap()
}

fn names(kind: &str, range: std::ops::Range<usize>) -> Vec<String> {
    range.map(|it| format!("{kind} {it}")).collect()
}

/// Ordinary edits, each of one thing or of what a hand has chosen.
fn edits() -> Vec<(&'static str, Edit)> {
    let change = |name: &str, fields: Vec<Field>| Edit::Change(name.to_owned(), fields);
    let at = |name: &str| change(name, vec![Field::three("at", DVec3::new(1.0, 90.0, 1.0))]);
    let by = DVec3::new(0.0, 3.0, 0.0);
    vec![
        ("move a block", at("block 7")),
        (
            "turn a group",
            change(
                "group 9",
                vec![Field::three("turn", DVec3::new(30.0, 0.0, 0.0))],
            ),
        ),
        (
            "colour",
            change("block 8", vec![Field::new("colour", "#205080")]),
        ),
        (
            "size",
            change(
                "block 9",
                vec![Field::three("size", DVec3::new(2.0, 1.0, 0.5))],
            ),
        ),
        (
            "size a ball",
            change("ball 9", vec![Field::number("radius", 0.7)]),
        ),
        ("move a hall", at("hall 5")),
        (
            "stretch a hall",
            change("hall 6", vec![Field::number("felt", 20.0)]),
        ),
        ("move a portal", at("door 7")),
        ("rename", Edit::rename("block 10", "brick")),
        ("remove", Edit::Remove(names("block", 20..21))),
        ("remove first", Edit::Remove(names("hall", 0..1))),
        (
            "double 100",
            Edit::Duplicate {
                names: names("block", 30..40),
                by,
            },
        ),
        (
            "group 50",
            Edit::Group {
                name: "all".to_owned(),
                at: by,
                members: names("block", 100..150),
            },
        ),
        (
            "colour 1000",
            Edit::change_all(&names("block", 150..1150), &Field::new("colour", "#205080")),
        ),
        ("gravity", Edit::Room(vec![Field::new("gravity", "0,-1,0")])),
    ]
}

fn none(_: &Room) -> Result<Assets, antipode_rooms::RoomError> {
    panic!("no file is to be read")
}

/// `cargo test --release -p antipode-room-scene large -- --ignored --nocapture`.
#[test]
#[ignore = "prints times"]
fn print_how_long_each_edit_keeps_the_thread() {
    let begin = Instant::now();
    let mut scene = RoomScene::of(Document::new(large()), Assets::default());
    println!("opened in {:?}", begin.elapsed());
    let mut slowest = Duration::ZERO;
    for (what, edit) in edits() {
        let mut best = [Duration::MAX; 4];
        for _ in 0..3 {
            let begin = Instant::now();
            let plan = scene.document().plan(&edit).unwrap();
            let planned = begin.elapsed();
            scene.make(plan, none).unwrap();
            let made = begin.elapsed().saturating_sub(planned);
            let begin = Instant::now();
            let drawn = scene.clone();
            let copied = begin.elapsed();
            drop(drawn);
            let plan = scene.document().plan_undo(1).unwrap();
            scene.make(plan, none).unwrap();
            let undone = begin.elapsed().saturating_sub(copied);
            for (best, now) in best.iter_mut().zip([planned, made, copied, undone]) {
                *best = (*best).min(now);
            }
        }
        let [planned, made, copied, undone] = best;
        println!(
            "{what}: planned {planned:?}, made {made:?}, copied {copied:?}, undone {undone:?}"
        );
        slowest = slowest.max(planned + made + copied);
    }
    println!("the slowest: {slowest:?}");
    let begin = Instant::now();
    let scene = scene
        .ray_scene(|_| Ok::<_, ()>(image::RgbaImage::new(4, 4)))
        .unwrap();
    println!(
        "ray scene of {} instances: {:?}",
        scene.instances.len(),
        begin.elapsed()
    );
}

#[test]
fn an_edit_makes_anew_only_what_it_changes() {
    let mut scene = RoomScene::of(Document::new(large()), Assets::default());
    let begin = scene.remade();
    assert!(
        begin.shapes < 10,
        "what looks alike is made once: {begin:?}"
    );
    for (what, edit) in edits() {
        let before = scene.remade();
        let plan = scene.document().plan(&edit).unwrap();
        scene.make(plan, none).unwrap();
        let after = scene.remade();
        // Those that get another size, and what space is made of.
        let shapes = usize::from(what.starts_with("size"));
        let spaces =
            usize::from(what.contains("hall") || what.contains("portal") || what == "remove first");
        assert_eq!(after.shapes - before.shapes, shapes, "{what}");
        assert_eq!(after.forms - before.forms, shapes, "{what}");
        assert_eq!(after.spaces - before.spaces, spaces, "{what}");
    }
}

/// What is kept from before an edit is what one would make of the room as it is.
#[test]
fn an_edited_room_is_met_as_the_same_room_opened_anew_is() {
    let mut scene = RoomScene::of(Document::new(large()), Assets::default());
    for (what, edit) in edits() {
        let plan = scene.document().plan(&edit).unwrap();
        scene.make(plan, none).unwrap();
        let anew = RoomScene::of(Document::new(scene.room().clone()), Assets::default());
        for number in 0..60 {
            let number = f64::from(number);
            let from = DVec3::new(number * 8.0 - 240.0, 2.2, number * 6.5 - 200.0);
            let (mut one, mut other) = (scene.clone(), anew.clone());
            for it in [&mut one, &mut other] {
                it.teleport(from).unwrap();
                it.aim(number * 37.0, number - 30.0);
            }
            assert_eq!(one.pick(), other.pick(), "{what} from {from}");
        }
    }
}

/// Aberrations are known by their places among the objects, and these move up where one before them goes.
#[test]
fn what_goes_before_an_aberration_leaves_it_its_name() {
    let text = "(version: 1, name: \"Two\", objects: [\
        (name: \"post\", at: (90, 2, 0), what: Box(size: (1, 1, 1))), \
        (name: \"hall\", at: (0, 2, 0), what: Aberration(half: (2, 3, 3), axis: Z, felt: 30, sides: Walls)), \
        (name: \"stone\", at: (0, 2, 90), what: Box(size: (1, 1, 1)))])";
    let room: Room = read(ROOM_FILE, text.as_bytes()).unwrap();
    let mut scene = RoomScene::of(Document::new(room), Assets::default());
    scene.teleport(DVec3::new(-6.0, 2.0, 0.0)).unwrap();
    scene.aim(0.0, 0.0);
    let before = scene.pick();
    assert_eq!(before.object.as_deref(), Some("hall"));
    let spaces = scene.remade().spaces;
    let plan = scene
        .document()
        .plan(&Edit::Remove(vec!["post".to_owned()]))
        .unwrap();
    scene.make(plan, none).unwrap();
    assert_eq!(scene.remade().spaces, spaces, "its space is kept");
    assert_eq!(scene.pick(), before);
}
