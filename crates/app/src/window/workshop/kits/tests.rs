//! Kits put into rooms, where they fit.

#![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

use antipode_room_scene::tuning::SHAPE;
use antipode_rooms::Assets;
use antipode_rooms::aberration::{Axis, Ways};
use antipode_workshop::{Document, find_in};
use glam::DVec2;

use super::*;

fn put_in(room: &Room, id: &str, point: DVec3, front: DVec3) -> Option<Edit> {
    let site = Site {
        point,
        normal: DVec3::Y,
        front,
        snap: &|metres| (metres * 4.0).round() / 4.0,
        ground: &|point| Some(DVec3::new(point.x, 0.0, point.z)),
    };
    put(room, id, &site)
}

/// Where the named thing is, and its front.
fn stands(room: &Room, name: &str) -> (DVec3, DVec3) {
    let (index, _) = room.find(name).unwrap();
    let pose = poses(room)[index];
    (pose.translation, pose.matrix3.x_axis)
}

#[test]
fn every_kit_is_put_in_twice_stands_on_the_ground_and_nothing_of_it_is_wrong() {
    for (id, _) in KITS {
        let mut document = Document::new(Room::new("a"));
        for _ in 0..2 {
            let edit = put_in(document.room(), id, DVec3::NEG_Z * 4.0, DVec3::NEG_Z).unwrap();
            document.edit(&edit).unwrap();
        }
        let room = document.room();
        let all = poses_of(room);
        let lowest = all[1..]
            .iter()
            .map(|it| it.0.y)
            .fold(f64::INFINITY, f64::min);
        assert!((-0.03..0.03).contains(&lowest), "{id}: {lowest}");
        assert!(space_in_parts(room).closed.is_empty(), "{id}");
        let found = find_in(room, &Assets::default(), &SHAPE, &|| true, &mut |_| {});
        // Nobody walks onto the portal over the loop, nor falls by it to anywhere.
        let odd: Vec<_> = found
            .iter()
            .filter(|it| it.is_grave || !(*id == "falling-loop" || it.said.id == "fall-out"))
            .collect();
        assert!(odd.is_empty(), "{id}: {odd:?}");
    }
}

#[test]
fn a_house_has_light_inside_and_is_put_in_without_where_there_are_lamps_enough() {
    let mut document = Document::new(Room::new("a"));
    let lights = |document: &Document| {
        let all = document.room().objects.iter();
        all.filter(|it| matches!(it.what, What::Light { .. }))
            .count()
    };
    for houses in 1..=MOST_LIGHTS + 1 {
        let point = DVec3::X * 12.0 * houses as f64;
        let edit = put_in(document.room(), "house", point, DVec3::NEG_Z).unwrap();
        document.edit(&edit).unwrap();
        assert_eq!(lights(&document), houses.min(MOST_LIGHTS));
    }
}

#[test]
fn a_second_portal_stands_beside_the_first_and_not_before_it() {
    let mut document = Document::new(Room::new("a"));
    for _ in 0..2 {
        let room = document.room();
        // One looks at the ground two metres before the first.
        let point = DVec3::new(0.0, 0.0, 2.0 * room.portals().count() as f64);
        let edit = put_in(room, "portal", point, DVec3::NEG_Z).unwrap();
        document.edit(&edit).unwrap();
    }
    let (first, front) = stands(document.room(), "portal");
    let (second, _) = stands(document.room(), "portal 2");
    let way = second - first;
    assert!((way - front * way.dot(front)).length() > 1.5, "{way}");
}

#[test]
fn nothing_is_put_before_the_door_of_a_house_nor_the_ends_of_a_tunnel() {
    for id in ["portals", "portal", "tunnel-longer", "house"] {
        let mut document = Document::new(Room::new("a"));
        let put = |document: &mut Document, id, point| {
            let edit = put_in(document.room(), id, point, DVec3::NEG_Z).unwrap();
            document.edit(&edit).unwrap();
        };
        put(&mut document, "house", DVec3::ZERO);
        put(&mut document, "tunnel-longer", DVec3::X * 12.0);
        let before = document.room().clone();
        // One looks at the ground two metres before the door, and before the tunnel. Both begin at z = 0.
        for x in [0.0, 12.0] {
            put(&mut document, id, DVec3::new(x, 0.0, 2.0));
        }
        let made = Room {
            objects: document.room().objects[before.objects.len()..].to_vec(),
            ..Room::new("a")
        };
        let stands = poses_of(&made);
        for (x, what) in [(0.0, "door"), (12.0, "end of the tunnel")] {
            let (from, to) = (DVec3::new(x - 0.4, 0.1, 0.1), DVec3::new(x + 0.4, 2.0, 2.4));
            let mut before = stands
                .iter()
                .filter(|(low, high, _)| low.cmplt(to).all() && high.cmpgt(from).all());
            assert_eq!(before.next(), None, "{id} before the {what}");
        }
    }
}

#[test]
fn a_tunnel_that_is_put_in_from_within_a_house_stands_beside_it_on_the_ground() {
    let mut document = Document::new(Room::new("a"));
    let house = put_in(document.room(), "house", DVec3::ZERO, DVec3::NEG_Z).unwrap();
    document.edit(&house).unwrap();
    let (inside, _) = stands(document.room(), "house");
    let site = Site {
        point: inside + DVec3::Y * 0.009,
        normal: DVec3::Y,
        front: DVec3::NEG_Z,
        snap: &|metres| (metres * 4.0).round() / 4.0,
        ground: &|point| Some(DVec3::new(point.x, 0.0, point.z)),
    };
    let tunnel = crate::window::workshop::parts::put(document.room(), "tunnel", &site).unwrap();
    document.edit(&tunnel).unwrap();
    let made = document.room().find("tunnel").unwrap().1;
    let away = (made.at - inside).abs();
    assert!(away.x > 3.2 || away.z > 4.2, "{away}");
    assert!((made.at.y - 1.25).abs() < 1e-9, "{}", made.at);
}

#[test]
fn a_house_turns_its_door_to_who_looks_and_one_walks_into_twice_the_room() {
    for (front, door) in [
        (DVec3::NEG_Z, DVec3::Z),
        (DVec3::X, DVec3::NEG_X),
        (DVec3::Z, DVec3::NEG_Z),
    ] {
        let room = Room::new("a");
        let edit = put_in(&room, "house", DVec3::ZERO, front).unwrap();
        let made = make(&room, &edit).unwrap();
        let (at, faces) = stands(&made, "house front");
        assert!(faces.distance(door) < 1e-9, "{front}: {faces}");
        let (house, _) = stands(&made, "house");
        assert!((at - house).dot(door) > 2.0, "{front}: {at}");
        assert!(house.dot(front) > 2.0, "it stands on who looks: {house}");
        let space = space_in_parts(&made).space;
        let inside = antipode_deformation::Place::at(&space, house + DVec3::Y);
        assert_eq!(inside.stack.len(), 1);
    }
}

#[test]
fn the_second_portal_stands_over_no_side_of_a_box_and_in_nothing() {
    let mut room = Room::new("a");
    let hall = What::Aberration(Aberration {
        half: DVec3::new(2.0, 2.0, 2.0),
        lengths: Lengths::Felt {
            axis: Axis::Z,
            felt_m: 20.0,
        },
        sides: Sides::Walls,
        ways: Ways::Both,
        outline: false,
    });
    // One of its sides is where the second of the pair would stand, and a wall on the other side.
    let at = DVec3::new(5.0, 2.0, -4.0);
    room.push(Object::new("tunnel", at, hall));
    let wall = What::Box {
        size: DVec3::new(2.0, 3.0, 1.0),
    };
    let at = DVec3::new(-6.0, 1.5, -4.0);
    room.push(Object::new("wall", at, wall));
    let edit = put_in(&room, "portals", DVec3::NEG_Z * 4.0, DVec3::NEG_Z).unwrap();
    let made = make(&room, &edit).unwrap();
    assert!(space_in_parts(&made).closed.is_empty());
    let (first, _) = stands(&made, "portal");
    let (second, _) = stands(&made, "portal 2");
    assert!(first.distance(second) > 3.0);
    for door in [first, second] {
        let flat = DVec2::new(door.x, door.z);
        assert!(
            (flat.x - 5.0).abs() > 2.8 || (flat.y + 4.0).abs() > 2.0,
            "{door}"
        );
        assert!(
            (flat.x + 6.0).abs() > 1.8 || (flat.y + 4.0).abs() > 0.5,
            "{door}"
        );
    }
}
