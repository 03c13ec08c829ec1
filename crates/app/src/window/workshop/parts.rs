//! What can be put into a room by a click.

use antipode_language::Texts;
use antipode_rooms::aberration::{Aberration, Axis, Lengths, Sides, Ways};
use antipode_rooms::room::Surface;
use antipode_rooms::{Colour, Object, Room, What};
use antipode_ui::workshop::PartRow;
use antipode_workshop::Edit;
use glam::{DVec2, DVec3};

use super::chosen::half;
use super::kits::{self, KITS, Site};
use super::rows::free_name;

/// Every part, by its word: first those that no other builder has.
pub const PARTS: [&str; 16] = [
    "house", "tunnel", "portals", "portal", "hall", "box", "wall", "floor", "stairs", "ramp",
    "arch", "pyramid", "cylinder", "ball", "light", "sign",
];

/// The list of them.
pub fn rows(texts: &Texts) -> Vec<PartRow> {
    let row = |id: &str| PartRow {
        id: id.to_owned(),
        label: texts.say(&format!("workshop-part-{id}")),
        about: texts.say(&format!("workshop-about-{id}")),
        picture: None,
    };
    PARTS.into_iter().map(row).collect()
}

/// Puts a part onto a surface.
pub fn put(room: &Room, id: &str, site: &Site<'_>) -> Option<Edit> {
    if KITS.iter().any(|(kit, _)| *kit == id) {
        return kits::put(room, id, site);
    }
    let Site {
        point,
        normal,
        snap,
        ..
    } = *site;
    let what = what(id)?;
    // Space that something else stands in by chance would be the odd one of both.
    if matches!(what, What::Aberration(_)) {
        let mut object = Object::new(&free_name(room, id), DVec3::ZERO, what);
        object.surface = surface(id);
        return kits::put_alone(room, object, site);
    }
    let mut half = half(&what);
    let mut turn = DVec3::ZERO;
    if matches!(id, "sign" | "arch") {
        // Its front is +x, which is turned to who looks.
        turn.x = 90.0 + kits::quarter(site.front);
        if (turn.x / 90.0).round() as i64 % 2 != 0 {
            half = DVec3::new(half.z, half.y, half.x);
        }
    }
    let on_grid = |at: DVec3| DVec3::new(snap(at.x), at.y, snap(at.z));
    let out = normal.abs().dot(half);
    let mut at = on_grid(point) * (DVec3::ONE - normal.abs().round())
        + point * normal.abs().round()
        + normal * out;
    // By a wall it stands on the ground, and hangs where it is light.
    let hangs = matches!(id, "sign" | "light");
    if normal.y.abs() < 0.5
        // No ceiling just above is meant.
        && let Some(ground) = (site.ground)(at - DVec3::Y)
    {
        let lowest = ground.y + half.y;
        at.y = if hangs { at.y.max(lowest) } else { lowest };
    }
    let mut object = Object::new(&free_name(room, id), tidy(at), what);
    object.surface = surface(id);
    object.turn = turn;
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
        // Not as the floor is on which they mostly stand.
        "box" => Colour([0xd4, 0xae, 0x5c]),
        "arch" => Colour([0xc2, 0xa4, 0x86]),
        "pyramid" => Colour([0xb0, 0x86, 0xbf]),
        "cylinder" => Colour([0x74, 0x9f, 0xc4]),
        "ball" => Colour([0xc8, 0x6c, 0x66]),
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
            outline: true,
        }),
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

    use antipode_workshop::Document;

    use super::*;

    #[test]
    fn every_part_can_be_put_in_twice_and_stands_on_the_ground() {
        let mut document = Document::new(Room::new("a"));
        let alone = PARTS.into_iter().filter(|id| what(id).is_some());
        for id in alone.clone().chain(alone) {
            let x = document.room().objects.len() as f64 * 8.0 - 120.0;
            let site = Site {
                point: DVec3::new(x + 0.07, 0.0, -5.1),
                normal: DVec3::Y,
                front: DVec3::NEG_Z,
                snap: &f64::round,
                ground: &|_| None,
            };
            let edit = put(document.room(), id, &site).unwrap();
            document.edit(&edit).unwrap();
            let made = document.room().objects.last().unwrap();
            let lowest = made.at.y - half(&made.what).y;
            assert!(lowest.abs() < 1e-9, "{id}: {lowest}");
            // Space begins there, as kits do.
            let depth = match made.what {
                What::Aberration(_) => half(&made.what).z,
                _ => 0.0,
            };
            assert_eq!(made.at.z + depth, -5.0, "{id}");
        }
        assert!(antipode_rooms::space(document.room()).is_ok());
    }

    #[test]
    fn every_part_is_a_thing_or_a_kit() {
        for id in PARTS {
            let is_kit = KITS.iter().any(|(kit, _)| *kit == id);
            assert!(is_kit != what(id).is_some(), "{id}");
        }
    }
}
