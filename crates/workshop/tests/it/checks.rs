//! What is found in rooms while they are edited.

use std::sync::Arc;
use std::time::{Duration, Instant};

use antipode_deformation::WalkerShape;
use antipode_rooms::shipped::ROOMS;
use antipode_rooms::{Assets, Room};
use antipode_workshop::{Arg, Checker, FINDINGS, Finding, find_in};

/// Who walks in rooms.
pub const SHAPE: WalkerShape = WalkerShape {
    radius_m: 0.35,
    height_m: 1.8,
    eye_m: 1.27,
    step_m: 0.4,
    steepest_rad: 50.0 * std::f64::consts::PI / 180.0,
};

/// A room with a floor of 20 m and these objects.
fn room(objects: &str) -> Room {
    let text = format!(
        "(version: 1, name: \"Hut\", objects: [
            (name: \"floor\", at: (0, -0.5, 0), what: Box(size: (20, 1, 20))),
            {objects}
        ])"
    );
    antipode_rooms::read_so_far("room.ron", text.as_bytes()).unwrap()
}

fn found(room: &Room) -> Vec<Finding> {
    let found = find_in(room, &Assets::default(), &SHAPE, &|| true, &mut |_| {});
    for it in &found {
        assert!(FINDINGS.contains(&it.said.id.as_str()), "{it:?}");
        assert!(
            it.objects.iter().all(|name| room.find(name).is_some()),
            "{it:?}"
        );
    }
    found
}

/// Each finding as its id and the objects that it leads to.
fn told(room: &Room) -> Vec<String> {
    let found = found(room);
    found
        .iter()
        .map(|it| format!("{} {}", it.said.id, it.objects.join(" ")))
        .collect()
}

/// The rim of the floor of 20 m, so that nobody falls off.
const FENCE: &str = r#"
    (name: "n", at: (0, 1, -10), what: Box(size: (20, 2, 0.2))), (name: "s", at: (0, 1, 10), what: Box(size: (20, 2, 0.2))),
    (name: "w", at: (-10, 1, 0), what: Box(size: (0.2, 2, 20))), (name: "e", at: (10, 1, 0), what: Box(size: (0.2, 2, 20))),
"#;

fn fenced(objects: &str) -> Room {
    room(&(FENCE.to_owned() + objects))
}

#[test]
fn rooms_of_the_game_have_nothing_that_does_not_work() {
    for shipped in ROOMS {
        let loaded = shipped.loaded().unwrap();
        let before = Instant::now();
        let found = find_in(&loaded.room, &loaded.assets, &SHAPE, &|| true, &mut |_| {});
        println!("{} in {:?}", shipped.id, before.elapsed());
        for it in &found {
            println!("  {it:?}");
        }
        assert!(
            found.iter().all(|it| !it.is_grave),
            "{}: {found:?}",
            shipped.id
        );
        let ids: Vec<_> = found.iter().map(|it| it.said.id.as_str()).collect();
        assert!(!ids.contains(&"open-sides"), "{}: {ids:?}", shipped.id);
        let lost: Vec<_> = found
            .iter()
            .filter(|it| it.said.id == "unreached")
            .collect();
        assert!(lost.is_empty(), "{}: {lost:?}", shipped.id);
    }
}

/// What is told of a spawn, by its id and how many metres.
fn of_spawn(room: &Room) -> Option<(String, Option<f64>)> {
    let found = found(room);
    let it = found.iter().find(|it| it.said.id.starts_with("spawn"))?;
    let metres = it.said.args.iter().find_map(|(_, arg)| match arg {
        Arg::Number(metres) => Some(*metres),
        Arg::Text(_) => None,
    });
    assert!(it.is_grave && it.at == room.spawn.at);
    Some((it.said.id.clone(), metres))
}

#[test]
fn who_begins_in_rock_or_in_the_air_is_told() {
    let mut it = fenced(r#"(name: "rock", at: (4, 1, 0), what: Box(size: (3, 2, 3)))"#);
    assert_eq!(told(&it), [""; 0]);
    it.spawn.at.x = 4.5;
    assert_eq!(told(&it), ["spawn-in-solid rock"]);
    it.spawn.at = glam::DVec3::new(0.0, 3.25, 0.0);
    assert_eq!(of_spawn(&it), Some(("spawn-in-air".to_owned(), Some(3.3))));
    it.spawn.at.x = 40.0;
    assert_eq!(
        of_spawn(&it),
        Some(("spawn-in-air".to_owned(), Some(0.0))),
        "there is no ground"
    );
    it.gravity = glam::DVec3::ZERO;
    assert_eq!(of_spawn(&it), None, "nothing draws");
    // On the ground under a table one begins well, and in the middle between two walls as well.
    let it = fenced(r#"(name: "table", at: (0, 2.2, 0), what: Box(size: (3, 0.2, 3)))"#);
    assert_eq!(of_spawn(&it), None);
}

#[test]
fn tunnels_with_open_sides_are_told_unless_something_covers_them() {
    let tunnel = |sides: &str, walls: &str| {
        let it = format!(
            r#"(name: "hall", at: (4, 1.3, 0), what: Aberration(half: (1, 1.28, 4), axis: Z, felt: 40, sides: {sides})), {walls}"#
        );
        told(&fenced(&it))
    };
    let walls = r#"(name: "left", at: (2.9, 1.3, 0), what: Box(size: (0.2, 2.6, 8))),
        (name: "right", at: (5.1, 1.3, 0), what: Box(size: (0.2, 2.6, 8))),"#;
    let roof = r#"(name: "roof", at: (4, 2.7, 0), what: Box(size: (2, 0.2, 8))),"#;
    for sides in ["Soft", "Snell"] {
        assert_eq!(tunnel(sides, ""), ["open-sides hall"]);
        assert_eq!(tunnel(sides, walls), ["open-sides hall"], "from above");
        assert_eq!(tunnel(sides, &format!("{walls}{roof}")), [""; 0]);
    }
    assert_eq!(tunnel("Walls", ""), [""; 0], "it has its own");
}

#[test]
fn what_does_not_fit_is_told_once_with_who_has_a_part_in_it() {
    let soft = |name: &str, turn: u8| {
        format!(
            r#"(name: "{name}", at: (4, 1, 0), turn: ({turn}, 0, 0), what: Aberration(half: (2, 0.9, 1), stretch: (2, 2, 2), sides: Soft)),"#
        )
    };
    assert_eq!(
        told(&fenced(&(soft("a", 0) + &soft("b", 30)))),
        ["not-parallel b a"]
    );
    let portal = |name: &str, x: u8, size: &str, to: &str| {
        format!(
            r#"(name: "{name}", at: ({x}, 1.5, -3), turn: (90, 0, 0), what: Portal(size: {size}, to: "{to}")),"#
        )
    };
    let two = |size: &str, to: &str| {
        told(&fenced(
            &(portal("a", 1, "(1, 2)", "b") + &portal("b", 4, size, to)),
        ))
    };
    assert_eq!(two("(1, 2)", "a"), [""; 0]);
    assert_eq!(two("(2, 2)", "a"), ["not-similar a b"]);
    assert_eq!(two("(1, 2)", "b"), ["one-way a b"], "b leads to itself");
    assert_eq!(
        told(&fenced(&portal("a", 1, "(1, 2)", "z"))),
        ["no-partner a"]
    );
    let into = portal("a", 4, "(6, 1)", "a") + &soft("box", 0).replace("(4, 1, 0)", "(4, 1, -3)");
    assert_eq!(told(&fenced(&into)), ["over-side a box"]);
}

#[test]
fn where_one_falls_out_near_the_beginning_is_told() {
    assert_eq!(told(&room("")), ["fall-out "]);
    assert_eq!(told(&fenced("")), [""; 0]);
    let found = found(&room(
        FENCE
            .split_once('\n')
            .unwrap()
            .1
            .split_once("(name: \"s\"")
            .unwrap()
            .0,
    ));
    assert!(
        found
            .iter()
            .any(|it| it.said.id == "fall-out" && !it.is_grave)
    );
    // A floor as new rooms have it ends so far off that it is meant so.
    assert!(found_in_new().is_empty());
}

fn found_in_new() -> Vec<Finding> {
    found(&Room::new("New"))
}

/// A house of 4 x 4 m with a hall in it, on a floor that high; its front, to +z, is left out.
fn house(floor_m: f64) -> String {
    let at = |name: &str, x: f64, y: f64, z: f64, size: &str| {
        format!(
            r#"(name: "{name}", at: ({x}, {}, {z}), what: Box(size: {size})),"#,
            y + floor_m
        )
    };
    at("back", 4.0, 1.5, -2.0, "(4, 3, 0.2)")
        + &at("left", 2.0, 1.5, 0.0, "(0.2, 3, 4.2)")
        + &at("right", 6.0, 1.5, 0.0, "(0.2, 3, 4.2)")
        + &at("roof", 4.0, 3.1, 0.0, "(4.4, 0.2, 4.4)")
        + &format!(
            r#"(name: "hall", at: (4, {}, 0), what: Aberration(half: (1.8, 1.4, 1.8), stretch: (3, 3, 3), sides: Soft)),"#,
            1.4 + floor_m
        )
}

#[test]
fn parts_that_nobody_can_walk_to_are_told() {
    let front = |gate: &str| {
        format!(r#"(name: "front", at: (4, 1.5, 2), turn: (90, 0, 0), what: {gate}),"#)
    };
    let shut = front("Box(size: (0.2, 3, 4.2))");
    assert_eq!(told(&fenced(&(house(0.0) + &shut))), ["unreached hall"]);
    let door = front("Arch(size: (0.2, 3, 4.2), opening: (0.9, 2.1))");
    assert_eq!(told(&fenced(&(house(0.0) + &door))), [""; 0]);
    let low = front("Arch(size: (0.2, 3, 4.2), opening: (0.9, 1.2))");
    assert_eq!(
        told(&fenced(&(house(0.0) + &low))),
        ["unreached hall"],
        "nobody creeps"
    );
    let pair = r#"(name: "out", at: (-4, 1.1, 0), what: Portal(size: (1, 2), to: "in")),
        (name: "in", at: (4, 1, -1), turn: (90, 0, 0), what: Portal(size: (0.8, 1.6), to: "out")),"#;
    assert_eq!(
        told(&fenced(&(house(0.0) + &shut + pair))),
        [""; 0],
        "one goes by the portals"
    );
}

#[test]
fn steps_are_climbed_and_walls_are_not() {
    let high = house(2.0) + r#"(name: "rock", at: (4, 1, 1), what: Box(size: (6, 2, 8))),"#;
    assert_eq!(told(&fenced(&high)), ["unreached hall"]);
    let stairs = high.clone()
        + r#"(name: "stairs", at: (4, 1, 7), turn: (-90, 0, 0), what: Stairs(size: (4, 2, 2), steps: 7)),"#;
    assert_eq!(told(&fenced(&stairs)), [""; 0]);
    let ramp = high
        + r#"(name: "ramp", at: (4, 1, 6.5), turn: (-90, 0, 0), what: Ramp(size: (3, 2, 2))),"#;
    assert_eq!(told(&fenced(&ramp)), [""; 0]);
}

/// A lawn of 200 m with 400 posts on it, and a house that is shut.
fn wide() -> Room {
    let mut text =
        house(0.0) + r#"(name: "front", at: (4, 1.5, 2), what: Box(size: (4.2, 3, 0.2))),"#;
    for number in 0..400 {
        let (x, z) = (
            f64::from(number % 20) * 9.5 - 95.0,
            f64::from(number / 20) * 9.5 - 99.0,
        );
        let post = format!(
            r#"(name: "post {number}", at: ({x}, 1, {z}), what: Cylinder(radius: 0.3, height: 2)),"#
        );
        text.push_str(&post);
    }
    let mut room = room(&text);
    room.objects[0] = Room::new("x").objects[0].clone();
    room
}

#[test]
fn a_newer_room_ends_the_look_at_an_older_one_and_all_is_told_soon() {
    let checker = Checker::start(SHAPE).unwrap();
    let room = Arc::new(wide());
    for revision in 1..=20 {
        checker.look(revision, room.clone(), Assets::default());
        std::thread::sleep(Duration::from_millis(5));
    }
    let asked = Instant::now();
    let mut first = None;
    let all = loop {
        std::thread::sleep(Duration::from_millis(2));
        let Some(findings) = checker.poll() else {
            assert!(asked.elapsed() < Duration::from_mins(1));
            continue;
        };
        assert_eq!(findings.revision, 20);
        first.get_or_insert(asked.elapsed());
        if findings.is_all {
            break findings;
        }
    };
    println!("first after {first:?}, all after {:?}", asked.elapsed());
    let ids: Vec<_> = all.findings.iter().map(|it| it.said.id.as_str()).collect();
    assert_eq!(ids, ["unreached"]);
}

/// A tunnel of 2 by 2.5 by 4 m with walls, its middle there, leading along an axis.
fn tunnel(name: &str, at: &str, axis: char) -> String {
    format!(
        r#"(name: "{name}", at: {at}, what: Aberration(half: (1, 1.25, 2), axis: {axis}, felt: 20, sides: Walls)),"#
    )
}

#[test]
fn a_wall_across_another_tunnel_is_told_and_tunnels_one_behind_the_other_are_well() {
    let with =
        |at: &str, axis| fenced(&(tunnel("a", "(0, 1.25, 0)", 'Z') + &tunnel("b", at, axis)));
    // As a copy is put in beside what it was copied from.
    assert_eq!(told(&with("(0.25, 1.25, 0.25)", 'Z')), ["walls-across a b"]);
    assert_eq!(told(&with("(0, 1.25, 0)", 'Z')), ["same-place b a"]);
    // One through the walls of the other.
    assert!(told(&with("(1, 1.25, 1)", 'X')).contains(&"walls-across a b".to_owned()));
    // In a row, each end a little in the next.
    assert_eq!(told(&with("(0, 1.25, 3.9)", 'Z')), [""; 0]);
    assert_eq!(told(&with("(5, 1.25, 0)", 'Z')), [""; 0]);
}

#[test]
fn a_tunnel_in_a_hall_is_well() {
    let hall = r#"(name: "hall", at: (0, 1.5, 0), what: Aberration(half: (5, 1.5, 5), stretch: (2, 2, 2), sides: Soft)),"#;
    let room = fenced(&(hall.to_owned() + &tunnel("a", "(0, 1.25, 0)", 'Z')));
    assert!(
        told(&room)
            .iter()
            .all(|it| !it.starts_with("walls") && !it.starts_with("same"))
    );
}

/// A shaft without end about a pillar that nobody climbs: who falls past it can steer onto it, and so comes before the portal
/// that hangs over it.
#[test]
fn who_falls_without_end_comes_to_what_is_before_the_portals() {
    let shaft = r#"
        (name: "low", at: (0, 0.02, -4), turn: (90, 90, 0), what: Portal(size: (3, 3), to: "high")),
        (name: "high", at: (0, 10, -4), turn: (-90, -90, 0), what: Portal(size: (3, 3), to: "low")),
        (name: "pillar", at: (0, 4, -4), what: Box(size: (0.8, 7, 0.8))),"#;
    assert_eq!(told(&fenced(shaft)), [""; 0]);
    // A floor over the lower portal: nobody falls.
    let lid = r#"(name: "lid", at: (0, 0.2, -4), what: Box(size: (3.4, 0.1, 3.4))),"#;
    let closed = told(&fenced(&(shaft.to_owned() + lid)));
    assert!(closed.iter().any(|it| it == "unreached high"), "{closed:?}");
}
