//! What can be put into a room by a click.

use antipode_language::Texts;
use antipode_rooms::aberration::{Aberration, Axis, Lengths, Sides, Ways};
use antipode_rooms::portal::{Opening, Portal};
use antipode_rooms::room::Surface;
use antipode_rooms::{Colour, Object, Room, What};
use antipode_ui::workshop::PartRow;
use antipode_workshop::Edit;
use glam::{DVec2, DVec3};

use super::chosen::half;
use super::rows::free_name;

/// How far apart the two of a new pair of portals stand, metres.
const APART_M: f64 = 6.0;
/// How far above the ground portals stand, metres: they may not touch the sides of an aberration that ends there.
const LIFTED_M: f64 = 0.005;
/// Every part, by its word.
pub const PARTS: [&str; 14] = [
    "box", "wall", "floor", "pyramid", "ramp", "stairs", "arch", "cylinder", "ball", "light",
    "sign", "tunnel", "hall", "portals",
];

/// The list of them.
pub fn rows(texts: &Texts) -> Vec<PartRow> {
    let row = |id: &str| PartRow {
        id: id.to_owned(),
        label: texts.say(&format!("workshop-part-{id}")),
        about: texts.say(&format!("workshop-about-{id}")),
    };
    PARTS.into_iter().map(row).collect()
}

/// Puts a part onto a surface; `snap` gives a length on the grid.
pub fn put(
    room: &Room,
    id: &str,
    (point, normal): (DVec3, DVec3),
    snap: impl Fn(f64) -> f64,
) -> Option<Edit> {
    let what = what(id)?;
    let on_grid = |at: DVec3| DVec3::new(snap(at.x), at.y, snap(at.z));
    let out = normal.abs().dot(half(&what));
    let at = tidy(
        on_grid(point) * (DVec3::ONE - normal.abs().round())
            + point * normal.abs().round()
            + normal * out,
    );
    if id == "portals" {
        return Some(pair(room, at + LIFTED_M * DVec3::Y));
    }
    let mut object = Object::new(&free_name(room, id), at, what);
    object.surface = surface(id);
    if id == "sign" {
        object.turn.x = 90.0;
    }
    Some(Edit::Insert(object))
}

fn tidy(v: DVec3) -> DVec3 {
    v.map(|one| (one * 1e4).round() / 1e4 + 0.0)
}

fn surface(id: &str) -> Surface {
    let colour = match id {
        "wall" | "tunnel" => Colour([0xc9, 0x8a, 0x5e]),
        "floor" => Colour([0x9a, 0xa0, 0x94]),
        "stairs" | "ramp" => Colour([0x8f, 0x9b, 0xb0]),
        _ => return Surface::default(),
    };
    Surface {
        colour,
        ..Surface::default()
    }
}

fn what(id: &str) -> Option<What> {
    Some(match id {
        "box" => What::Box { size: DVec3::ONE },
        "wall" => What::Box {
            size: DVec3::new(4.0, 2.5, 0.25),
        },
        "floor" => What::Box {
            size: DVec3::new(4.0, 0.25, 4.0),
        },
        "pyramid" => What::Pyramid {
            size: DVec3::splat(2.0),
        },
        "ramp" => What::Ramp {
            size: DVec3::new(3.0, 1.0, 1.5),
        },
        "stairs" => What::Stairs {
            size: DVec3::new(3.0, 2.0, 1.5),
            steps: 8,
        },
        "arch" => What::Arch {
            size: DVec3::new(0.5, 3.0, 3.0),
            opening: DVec2::new(1.5, 2.25),
        },
        "cylinder" => What::Cylinder {
            radius: 0.5,
            height: 2.0,
        },
        "ball" => What::Ball { radius: 0.5 },
        "light" => What::Light {
            colour: Colour([0xff, 0xe0, 0xb0]),
            power: 6.0,
        },
        "sign" => What::Sign {
            text: None,
            size: DVec2::new(2.4, 0.8),
        },
        "tunnel" => What::Aberration(Aberration {
            half: DVec3::new(1.0, 1.25, 2.0),
            lengths: Lengths::Felt {
                axis: Axis::Z,
                felt_m: 20.0,
            },
            sides: Sides::Walls,
            ways: Ways::Both,
            outline: false,
        }),
        "hall" => What::Aberration(Aberration {
            half: DVec3::new(2.0, 1.5, 2.0),
            lengths: Lengths::Stretch(DVec3::splat(2.0)),
            sides: Sides::Soft,
            ways: Ways::Both,
            outline: false,
        }),
        "portals" => What::Portal(door("")),
        _ => return None,
    })
}

fn door(to: &str) -> Portal {
    Portal {
        opening: Opening::Size(DVec2::new(1.6, 2.5)),
        to: to.to_owned(),
        sides: 1,
    }
}

/// Two portals that lead to each other, both with their fronts to +z.
fn pair(room: &Room, at: DVec3) -> Edit {
    let first = free_name(room, "door");
    // The next name that is free beside the first.
    let mut names = (2..10_000).map(|number| format!("door {number}"));
    let is_free = |name: &String| *name != first && room.find(name).is_none();
    let second = names.find(is_free).unwrap_or_default();
    let portal = |name: &str, to: &str, at: DVec3| {
        let mut object = Object::new(name, at, What::Portal(door(to)));
        object.turn.x = 90.0;
        Edit::Insert(object)
    };
    Edit::Several(vec![
        portal(&first, &second, at),
        portal(&second, &first, at + DVec3::X * APART_M),
    ])
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

    use antipode_workshop::Document;

    use super::*;

    #[test]
    fn every_part_can_be_put_in_twice_and_stands_on_the_ground() {
        let mut document = Document::new(Room::new("a"));
        for id in PARTS.into_iter().chain(PARTS) {
            let x = document.room().objects.len() as f64 * 8.0 - 120.0;
            let ground = (DVec3::new(x + 0.07, 0.0, -5.1), DVec3::Y);
            let edit = put(document.room(), id, ground, f64::round).unwrap();
            document.edit(&edit).unwrap();
            let made = document.room().objects.last().unwrap();
            let lowest = made.at.y - half(&made.what).y;
            let lifted = if id == "portals" { LIFTED_M } else { 0.0 };
            assert!((lowest - lifted).abs() < 1e-9, "{id}: {lowest}");
            assert_eq!(made.at.z, -5.0, "{id}");
        }
        assert!(antipode_rooms::space(document.room()).is_ok());
    }
}
