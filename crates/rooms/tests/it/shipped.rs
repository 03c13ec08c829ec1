//! The rooms that come with the game.

use std::collections::HashSet;

use std::sync::Arc;

use antipode_language::{Language, Texts};
use antipode_rooms::aberration::{Aberration, Lengths, stretch_of_thesis};
use antipode_rooms::mesh::{Roundness, meshes};
use antipode_rooms::room::{Object, What};
use antipode_rooms::{Assets, Room, poses, read, shipped, space, write};
use glam::DVec3;

fn rooms() -> Vec<(&'static str, Room)> {
    shipped::ROOMS
        .iter()
        .map(|it| (it.id, it.room().unwrap_or_else(|error| panic!("{error}"))))
        .collect()
}

#[test]
fn every_one_is_sound_and_written_as_the_game_writes() {
    let mut names = HashSet::new();
    for (id, room) in rooms() {
        let text = shipped::find(id).unwrap().text;
        let again = write(&room).unwrap();
        let differs = text.lines().zip(again.lines()).find(|(a, b)| a != b);
        assert!(again == text, "{id}: {differs:?}");
        assert_eq!(read("again", again.as_bytes()).unwrap(), room);
        assert!(
            names.insert(room.name.clone()),
            "two are called {}",
            room.name
        );
    }
    assert_eq!(names.len(), shipped::ROOMS.len());
}

#[test]
fn a_sign_says_in_one_sentence_what_is_strange() {
    for (id, room) in rooms() {
        let sentence = &room.sentence;
        assert!(
            sentence.ends_with('.') && sentence.matches(['.', '!', '?']).count() == 1,
            "{id}: {sentence}"
        );
        let (index, sign) = room.find("sign").unwrap();
        assert!(matches!(&sign.what, What::Sign { text: None, .. }), "{id}");
        // In view of who begins: ahead, within 12 m, its front towards them.
        let pose = poses(&room)[index];
        let away = pose.translation - room.spawn.at;
        assert!(
            away.z < -1.0 && away.length() < 12.0 && away.x.abs() < -away.z,
            "{id}: {away}"
        );
        assert!(pose.transform_vector3(DVec3::X).z > 0.9, "{id}");
    }
}

/// The messages of the game are those of its rooms with this before them.
fn message(key: &str) -> String {
    format!("room-{key}")
}

#[test]
fn all_that_is_read_in_them_is_there_in_every_language() {
    let words = shipped::words();
    for (id, room) in rooms() {
        let own = |key: &str| key.starts_with(&format!("{id}-"));
        let words: Vec<_> = words.iter().filter(|(_, key)| own(key)).collect();
        let is_sign = |it: &&Arc<Object>| matches!(&it.what, What::Sign { text: Some(text), .. } if text.contains(char::is_alphabetic));
        let signs = room.objects.iter().filter(is_sign).count();
        assert_eq!(words.len(), signs + 1, "{id}");
        for language in Language::ALL {
            let texts = Texts::new(language);
            let name = message(&format!("{id}-name"));
            assert!(texts.has_own(&name), "{name} in {language:?}");
            for (text, key) in &words {
                let key = message(key);
                assert!(texts.has_own(&key), "{key} in {language:?}");
                let said = texts.say(&key);
                // As long as any room's may be, with nothing that cannot be shown.
                let told = Room {
                    sentence: said.clone(),
                    ..room.clone()
                };
                antipode_rooms::check(&told).unwrap();
                let is_english = language == Language::English;
                assert_eq!(said == *text, is_english, "{key} in {language:?}");
            }
            let sentence = texts.say(&message(&format!("{id}-sentence")));
            let ends = sentence.chars().filter(|it| ".!?。！？".contains(*it));
            assert!(
                ends.count() == 1 && sentence.ends_with(['.', '。']),
                "{sentence}"
            );
            if language == Language::English {
                assert_eq!(texts.say(&name), room.name);
            }
        }
    }
}

#[test]
fn nobody_begins_in_a_solid_or_an_aberration() {
    for (id, room) in rooms() {
        let body = room.spawn.at + DVec3::Y * 0.9;
        for mesh in meshes(&room, &Assets::default(), Roundness::default()) {
            let within = mesh.pose.inverse().transform_point3(body);
            let most = mesh
                .shape
                .positions
                .iter()
                .copied()
                .reduce(DVec3::max)
                .unwrap();
            let least = mesh
                .shape
                .positions
                .iter()
                .copied()
                .reduce(DVec3::min)
                .unwrap();
            let outside = within.cmplt(least - 0.4).any() || within.cmpgt(most + 0.4).any();
            assert!(
                outside || mesh.object == 0,
                "{id}: {}",
                room.objects[mesh.object].name
            );
        }
        let places = antipode_rooms::aberrations(&room);
        let strange = places.len() + room.portals().count();
        assert!(strange > 0, "{id} is not strange");
        for (_, place) in places {
            let within = place.turn.inverse() * (body - place.centre);
            assert!(within.abs().cmpgt(place.half + 0.4).any(), "{id}");
        }
    }
}

fn aberration(room: &Room, name: &str) -> Aberration {
    match room.find(name).unwrap().1.what {
        What::Aberration(it) => it,
        _ => panic!("{name}"),
    }
}

#[test]
fn the_tunnels_are_those_of_the_thesis() {
    let room = shipped::find("four-tunnels").unwrap().room().unwrap();
    for (name, axis, d) in [
        ("shorter", 2, 2.0),
        ("longer", 2, -0.8),
        ("narrower", 0, 0.7),
        ("lower", 1, 0.8),
    ] {
        let it = aberration(&room, name);
        assert_eq!(it.half * 2.0, DVec3::new(9.5, 10.5, 79.0), "{name}");
        let mut wanted = DVec3::ONE;
        wanted[axis] = stretch_of_thesis(d).unwrap();
        assert!(
            (it.stretch() - wanted).length() < 1e-6,
            "{name}: {}",
            it.stretch()
        );
    }
    let room = shipped::find("thesis-room").unwrap().room().unwrap();
    assert_eq!(
        aberration(&room, "room").lengths,
        Lengths::Stretch(DVec3::new(0.5, 0.5, 1.0))
    );
}

#[test]
fn signs_tell_the_truth() {
    let of = |id: &str| shipped::find(id).unwrap().room().unwrap();
    let corridor = aberration(&of("long-house"), "corridor");
    assert_eq!((corridor.stretch().z * corridor.half.z * 2.0).round(), 79.0);
    let hall = aberration(&of("big-house"), "hall");
    assert_eq!(hall.stretch().x * hall.half.x * 2.0, 12.0);
    assert_eq!(hall.stretch().y, 2.0);
    let twelve = of("twelve-rooms");
    assert_eq!(twelve.aberrations().count(), 12);
    for (_, it) in twelve.aberrations() {
        let felt = it.stretch() * it.half * 2.0;
        assert!(
            (felt.x - 5.0).abs() < 0.1 && (felt.z - 5.0).abs() < 0.1,
            "{felt}"
        );
    }
    for place in antipode_rooms::aberrations(&twelve) {
        let corner = (place.1.centre - DVec3::new(0.0, 1.25, -10.0)).abs() + place.1.half;
        assert!(corner.x <= 2.5 && corner.z <= 2.5);
    }
    let growing = space(&of("growing-hall")).unwrap();
    for portal in growing.portals() {
        let times = portal.scale.max(portal.scale.recip());
        assert!((times - 2.0).abs() < 1e-9, "{}", portal.portal.name);
    }
    let stair = of("endless-stair");
    let is_sixteen = |it: &What| matches!(it, What::Stairs { steps: 16, .. });
    assert!(stair.objects.iter().any(|it| is_sixteen(&it.what)));
    let shaft = space(&of("bottomless-shaft")).unwrap();
    let [bottom, top] = shaft.portals() else {
        panic!("{shaft:?}")
    };
    // Nothing is turned on the way, and it is eight metres deep.
    assert!(!bottom.is_turned());
    assert!((top.portal.at.y - bottom.portal.at.y - 8.0).abs() < 0.05);
    let nested = of("nested-boxes");
    assert_eq!(nested.aberrations().count(), 4);
    assert!(
        nested
            .aberrations()
            .all(|(_, it)| it.stretch() == DVec3::splat(2.0))
    );
}

/// Whether a way meets a triangle: T. Möller and B. Trumbore (1997), with the way as long as the ray.
fn meets(from: DVec3, to: DVec3, [a, b, c]: [DVec3; 3]) -> bool {
    let (along, first, second) = (to - from, b - a, c - a);
    let across = along.cross(second);
    let determinant = first.dot(across);
    if determinant.abs() < 1e-12 {
        return false;
    }
    let off = from - a;
    let u = off.dot(across) / determinant;
    let turned = off.cross(first);
    let v = along.dot(turned) / determinant;
    let t = second.dot(turned) / determinant;
    u >= 0.0 && v >= 0.0 && u + v <= 1.0 && (0.0..=1.0).contains(&t)
}

#[test]
fn who_walks_upright_gets_in() {
    // Where one stands outside, and where inside, on the ground.
    let ways = [
        (
            "long-house",
            DVec3::new(0.0, 0.0, -6.5),
            DVec3::new(0.0, 0.0, -17.5),
        ),
        (
            "big-house",
            DVec3::new(0.0, 0.0, -6.5),
            DVec3::new(0.0, 0.0, -9.0),
        ),
        (
            "nested-boxes",
            DVec3::new(0.0, 0.0, -4.0),
            DVec3::new(0.0, 0.0, -9.0),
        ),
        (
            "four-tunnels",
            DVec3::new(-24.0, 0.0, -18.0),
            DVec3::new(-24.0, 0.0, -103.0),
        ),
        (
            "four-tunnels",
            DVec3::new(-8.0, 0.0, -18.0),
            DVec3::new(-8.0, 0.0, -103.0),
        ),
        (
            "four-tunnels",
            DVec3::new(8.0, 0.0, -18.0),
            DVec3::new(8.0, 0.0, -103.0),
        ),
        (
            "four-tunnels",
            DVec3::new(24.0, 0.0, -18.0),
            DVec3::new(24.0, 0.0, -103.0),
        ),
        (
            "thesis-room",
            DVec3::new(0.0, 0.0, -6.0),
            DVec3::new(0.0, 0.0, -15.0),
        ),
        (
            "thesis-room",
            DVec3::new(1.2, 0.0, -19.0),
            DVec3::new(1.2, 0.0, -22.0),
        ),
        (
            "two-portals",
            DVec3::new(0.0, 0.0, -5.0),
            DVec3::new(0.0, 0.0, -7.9),
        ),
        (
            "closet-flat",
            DVec3::new(0.0, 0.0, -4.0),
            DVec3::new(0.0, 0.0, -6.0),
        ),
        (
            "growing-hall",
            DVec3::new(0.0, 0.0, -4.0),
            DVec3::new(0.0, 0.0, -8.5),
        ),
        (
            "door-to-itself",
            DVec3::new(0.0, 0.0, -3.0),
            DVec3::new(0.0, 0.0, -5.9),
        ),
    ];
    let rooms = rooms();
    let twelve = &rooms
        .iter()
        .find(|(id, _)| *id == "twelve-rooms")
        .unwrap()
        .1;
    let doors = twelve
        .objects
        .iter()
        .zip(poses(twelve))
        .filter(|(it, _)| it.name.starts_with("door-"));
    let through = doors.map(|(_, pose)| {
        let (at, ahead) = (
            pose.translation.with_y(0.0),
            pose.transform_vector3(DVec3::X),
        );
        ("twelve-rooms", at + ahead, at - ahead * 0.3)
    });
    let ways: Vec<_> = ways.into_iter().chain(through).collect();
    assert_eq!(ways.len(), 13 + 12);
    for (id, from, to) in ways {
        let room = &rooms.iter().find(|(it, _)| *it == id).unwrap().1;
        let aside = (to - from).normalize().cross(DVec3::Y) * 0.35;
        for mesh in meshes(room, &Assets::default(), Roundness::default()) {
            for corners in &mesh.shape.triangles {
                let triangle = corners.map(|it| {
                    mesh.pose
                        .transform_point3(mesh.shape.positions[it as usize])
                });
                for (side, height) in [
                    (-1.0, 0.4),
                    (0.0, 0.4),
                    (1.0, 0.4),
                    (-1.0, 1.4),
                    (0.0, 1.8),
                    (1.0, 1.4),
                ] {
                    let off = aside * side + DVec3::Y * height;
                    let name = &room.objects[mesh.object].name;
                    assert!(
                        !meets(from + off, to + off, triangle),
                        "{id}: {name} is in the way at {height} m"
                    );
                }
            }
        }
    }
}
