//! Wide floors: how much of them is looked at to tell what can be reached, and that nothing small on them is missed.

use std::cell::Cell;

use antipode_rooms::{Assets, Room};
use antipode_workshop::{Arg, Finding, find_in};

use crate::checks::SHAPE;
use crate::large::large;

/// A box whose sides stand along the axes.
fn block(name: &str, at: (f64, f64, f64), size: (f64, f64, f64)) -> String {
    format!(r#"(name: "{name}", at: {at:?}, what: Box(size: {size:?})),"#)
}

/// A floor at y = 0 between two corners, x and z.
fn floor(name: &str, low: (f64, f64), high: (f64, f64)) -> String {
    let at = (
        f64::midpoint(low.0, high.0),
        -0.5,
        f64::midpoint(low.1, high.1),
    );
    block(name, at, (high.0 - low.0, 1.0, high.1 - low.1))
}

/// A floor so wide, the spawn in its middle.
fn wide(edge: f64) -> String {
    floor(
        "floor",
        (-edge / 2.0, -edge / 2.0),
        (edge / 2.0, edge / 2.0),
    )
}

fn room(objects: &str) -> Room {
    let text = format!("(version: 1, name: \"Wide\", objects: [{objects}])");
    antipode_rooms::read_so_far("room.ron", text.as_bytes()).unwrap()
}

/// 1,990 boxes on a part of a floor.
fn boxes() -> String {
    let of = |number: u32| {
        let (x, z) = (f64::from(number % 50), f64::from(number / 50));
        let at = (x * 4.9 + 5.3, 0.6, z * 4.9 + 5.7);
        block(&format!("box {number}"), at, (0.7, 1.2, 0.7))
    };
    (0..1990).map(of).collect()
}

/// A house of 4 x 4 m with a stretched hall in it; `front` tells its front, to +z.
fn house(x: f64, z: f64, stretch: f64, front: &str) -> String {
    let at = |name: &str, dx: f64, y: f64, dz: f64, size| block(name, (x + dx, y, z + dz), size);
    at("back", 0.0, 1.5, -2.0, (4.0, 3.0, 0.2))
        + &at("left", -2.0, 1.5, 0.0, (0.2, 3.0, 4.2))
        + &at("right", 2.0, 1.5, 0.0, (0.2, 3.0, 4.2))
        + &at("roof", 0.0, 3.1, 0.0, (4.4, 0.2, 4.4))
        + &format!(
            r#"(name: "hall", at: ({x}, 1.4, {z}), what: Aberration(half: (1.8, 1.4, 1.8), stretch: ({stretch}, {stretch}, {stretch}), sides: Soft)),
            (name: "front", at: ({x}, 1.5, {}), turn: (90, 0, 0), what: {front}),"#,
            z + 2.0
        )
}

const SHUT: &str = "Box(size: (0.2, 3, 4.2))";
const DOOR: &str = "Arch(size: (0.2, 3, 4.2), opening: (0.9, 2.1))";

/// What is found in a room of these objects, and from how many places it was looked.
fn look(objects: &str) -> (Vec<Finding>, u32) {
    look_at(&room(objects))
}

fn look_at(room: &Room) -> (Vec<Finding>, u32) {
    let places = Cell::new(0);
    let goes_on = || {
        places.set(places.get() + 1);
        true
    };
    let found = find_in(room, &Assets::default(), &SHAPE, &goes_on, &mut |_| {});
    (found, places.get())
}

/// Each finding as its id and the objects that it leads to.
fn told(objects: &str) -> Vec<String> {
    let found = look(objects).0.into_iter();
    found
        .map(|it| format!("{} {}", it.said.id, it.objects.join(" ")))
        .collect()
}

/// How far off one falls out.
fn falls_out_after(objects: &str) -> Option<f64> {
    let found = look(objects).0;
    let it = found.iter().find(|it| it.said.id == "fall-out")?;
    it.said.args.iter().find_map(|(_, arg)| match arg {
        Arg::Number(metres) => Some(*metres),
        Arg::Text(_) => None,
    })
}

/// Of a quarter of a square kilometre there would be a million places at half a metre from each other.
#[test]
fn a_wide_floor_is_looked_at_from_few_places() {
    let places = |objects: &str| look(objects).1;
    assert!(places(&wide(600.0)) < 50);
    let shut = house(-30.0, -30.0, 3.0, SHUT);
    assert!(places(&(wide(600.0) + &shut)) < 2000);
    assert!(places(&(wide(1200.0) + &shut)) < 2000);
    // To what is in the corner one walks past 1,990 boxes.
    let far = house(290.0, 290.0, 3.0, DOOR);
    let (found, places) = look(&(wide(600.0) + &boxes() + &far));
    assert!(found.is_empty(), "{found:?}");
    assert!(places < 3000, "{places}");
}

#[test]
fn a_room_of_two_thousand_objects_is_looked_at_from_few_places() {
    let mut room = room(&wide(600.0));
    room.objects.extend(large().objects);
    // Where one begins.
    room.objects.retain(|it| it.name != "block 611");
    let (found, places) = look_at(&room);
    assert!(found.iter().all(|it| it.said.id == "open-sides"));
    assert!(places < 3000, "{places}");
}

#[test]
fn a_house_anywhere_on_a_wide_floor_is_reached_by_its_door_alone() {
    for (x, z) in [(290.0, 290.0), (-297.0, 296.0), (-200.3, -150.1)] {
        for stretch in [3.0, 0.6] {
            let with = |front| told(&(wide(600.0) + &house(x, z, stretch, front)));
            assert_eq!(with(DOOR), [""; 0], "{x} {z} {stretch}");
            assert_eq!(with(SHUT), ["unreached hall"], "{x} {z} {stretch}");
        }
    }
}

#[test]
fn a_pit_of_a_metre_in_a_wide_floor_is_fallen_into() {
    // Four floors about a pit whose middle is 16 m off.
    let about = floor("west", (-300.0, -300.0), (15.5, 300.0))
        + &floor("east", (16.5, -300.0), (300.0, 300.0))
        + &floor("north", (15.5, -300.0), (16.5, -0.5))
        + &floor("south", (15.5, 0.5), (16.5, 300.0));
    let metres = falls_out_after(&about).unwrap();
    assert!((14.0..19.0).contains(&metres), "{metres}");
    let lid = floor("lid", (15.5, -0.5), (16.5, 0.5));
    assert_eq!(falls_out_after(&(about + &lid)), None);
}

#[test]
fn a_missing_tile_is_fallen_into_and_cracks_between_tiles_are_not() {
    let tiles = |is_there: &dyn Fn(u32) -> bool| -> String {
        let of = |number: u32| {
            let (x, z) = (f64::from(number % 30), f64::from(number / 30));
            let (x, z) = (x * 4.0 - 62.0, z * 4.0 - 62.0);
            floor(&format!("tile {number}"), (x, z), (x + 3.999, z + 3.999))
        };
        (0..900).filter(|it| is_there(*it)).map(of).collect()
    };
    assert_eq!(falls_out_after(&tiles(&|_| true)), None);
    assert!(look(&tiles(&|_| true)).1 < 1000);
    let metres = falls_out_after(&tiles(&|it| it != 30 * 12 + 12)).unwrap();
    assert!((10.0..20.0).contains(&metres), "{metres}");
}

/// Walls of 2 cm about a square of 40 m in which a house is, with a gap in one of them.
#[test]
fn a_thin_wall_is_not_walked_through_and_a_gap_in_it_is() {
    let walled = |gap: f64| {
        let wall = |name: &str, at, size| block(name, at, size);
        let half = (40.0 - gap) / 2.0;
        told(
            &(wide(600.0)
                + &house(100.0, 100.0, 3.0, DOOR)
                + &wall("w", (80.0, 1.0, 100.0), (0.02, 2.0, 40.0))
                + &wall("e", (120.0, 1.0, 100.0), (0.02, 2.0, 40.0))
                + &wall("s", (100.0, 1.0, 120.0), (40.0, 2.0, 0.02))
                + &wall("n", (80.0 + half / 2.0, 1.0, 80.0), (half, 2.0, 0.02))
                + &wall("m", (120.0 - half / 2.0, 1.0, 80.0), (half, 2.0, 0.02))),
        )
    };
    assert_eq!(walled(0.0), ["unreached hall"]);
    assert_eq!(walled(1.0), [""; 0]);
}

#[test]
fn an_island_beyond_a_trench_is_not_reached_until_a_plank_leads_there() {
    let land = floor("land", (-300.0, -300.0), (200.0, 300.0))
        + &floor("island", (201.0, -300.0), (300.0, 300.0))
        + &house(250.0, -250.0, 3.0, DOOR);
    assert_eq!(told(&land), ["unreached hall"]);
    let plank = floor("plank", (200.0, 100.0), (201.0, 100.8));
    assert_eq!(told(&(land + &plank)), [""; 0]);
}

#[test]
fn a_portal_in_the_open_leads_into_a_house_that_is_shut() {
    let shut = wide(600.0) + &house(-150.0, 40.0, 3.0, SHUT);
    let pair = |x: f64, z: f64| {
        format!(
            r#"(name: "out", at: ({x}, 1.1, {z}), what: Portal(size: (1, 2), to: "in")),
            (name: "in", at: (-150, 1, 39), turn: (90, 0, 0), what: Portal(size: (0.8, 1.6), to: "out")),"#
        )
    };
    // Wherever in a cell it stands.
    let near = (0..40).map(|n| (3.0 + f64::from(n) / 40.0, 2.2));
    let far = [(100.0, -80.0), (-256.0, 128.0)];
    for (x, z) in near.chain(far) {
        assert_eq!(told(&(shut.clone() + &pair(x, z))), [""; 0], "{x} {z}");
    }
}

/// Nothing that is solid tells where it is.
#[test]
fn a_stretched_box_in_the_open_is_entered() {
    for (x, z) in [(60.0, 60.0), (-250.0, 10.0), (295.0, -295.0)] {
        let bare = format!(
            r#"(name: "bare", at: ({x}, 1.5, {z}), what: Aberration(half: (1, 1.5, 1), stretch: (2, 2, 2), sides: Soft)),"#
        );
        assert_eq!(told(&(wide(600.0) + &bare)), [""; 0], "{x} {z}");
    }
}

/// The middles of cells lie in the planes of such doorways. Who came out of one and stands beside it has a floor below.
#[test]
fn beside_portals_in_whose_planes_one_walks_nobody_falls() {
    let door = |name: &str, z: f64, to: &str| {
        format!(
            "(name: \"{name}\", at: (3.75, 1.24, {z}), turn: (180, 0, 0), what: Portal(size: (1.6, 2.5), to: \"{to}\")),
             (name: \"{name} left\", at: (3.75, 1.32, {}), what: Box(size: (0.14, 2.64, 0.14))),
             (name: \"{name} right\", at: (3.75, 1.32, {}), what: Box(size: (0.14, 2.64, 0.14))),",
            z - 0.872,
            z + 0.872,
        )
    };
    let doors = door("a", -1.0, "b") + &door("b", 5.0, "a");
    let found = find_in(
        &room(&(wide(200.0) + &doors)),
        &Assets::default(),
        &SHAPE,
        &|| true,
        &mut |_| {},
    );
    assert!(found.is_empty(), "{found:?}");
}
