//! What is found in rooms while they are edited.

use std::sync::Arc;
use std::time::{Duration, Instant};

use antipode_deformation::WalkerShape;
use antipode_rooms::shipped::ROOMS;
use antipode_rooms::{Assets, Room, read};
use antipode_workshop::{Arg, Checker, FINDINGS, Finding, find_in};

/// Who walks in rooms.
const SHAPE: WalkerShape = WalkerShape {
    radius_m: 0.35,
    height_m: 1.8,
    eye_m: 1.27,
    step_m: 0.4,
    steepest_rad: 50.0 * std::f64::consts::PI / 180.0,
};

/// A room with a floor of 20 m and these objects.
fn room(objects: &str) -> Room {
    room_with("", objects)
}

fn room_with(own: &str, objects: &str) -> Room {
    let text = format!(
        "(version: 1, name: \"Hut\", {own} objects: [
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
        let lost = found.iter().find(|it| it.said.id == "unreached");
        assert!(lost.is_none(), "{}: {lost:?}", shipped.id);
    }
}
