//! What an aberration or a portal does, in words: to the view, to size and to speed.

use antipode_deformation::Space;
use antipode_language::{Texts, Value};
use antipode_rooms::aberration::{Aberration, Lengths, Sides};
use antipode_rooms::portal::{Opening, Portal};
use antipode_rooms::{Room, What};

/// What differs less is not told, as a share.
const NOTICED: f64 = 0.01;
/// How fast one walks, metres a second.
const WALK_M_S: f64 = antipode_room_scene::tuning::WALK_SPEED_M_S;

fn short(length: f64) -> Value<'static> {
    Value::decimals(length, if length < 10.0 { 2 } else { 0 })
}

/// What an aberration does: sentences, and whether each is a warning.
pub fn told(texts: &Texts, it: &Aberration) -> Vec<(String, bool)> {
    let stretch = it.stretch();
    let mut all = Vec::new();
    if let Lengths::Felt { axis, felt_m } = it.lengths {
        let length = 2.0 * it.half[axis.index()];
        let values = [
            ("outside", short(length)),
            ("inside", short(felt_m)),
            ("before", Value::decimals(length / WALK_M_S, 1)),
            ("seconds", Value::decimals(felt_m / WALK_M_S, 1)),
        ];
        all.push((texts.say_with("workshop-told-felt", &values), false));
    }
    let (least, most) = (stretch.min_element(), stretch.max_element());
    if (most / least - 1.0).abs() < NOTICED && (most - 1.0).abs() > NOTICED {
        let larger = most > 1.0;
        let times = if larger { most } else { 1.0 / most };
        let values = [("times", Value::decimals(times, 1))];
        let key = if larger {
            "workshop-told-smaller"
        } else {
            "workshop-told-larger"
        };
        all.push((texts.say_with(key, &values), false));
    }
    let key = match it.sides {
        Sides::Walls => "workshop-told-walls",
        Sides::Soft => "workshop-told-soft",
        Sides::Snell => "workshop-told-snell",
        Sides::Legacy { .. } => "workshop-told-legacy",
    };
    all.push((texts.say(key), matches!(it.sides, Sides::Legacy { .. })));
    let doors = it.doors();
    if it.sides == Sides::Walls && doors == [false; 3] {
        all.push((texts.say("workshop-told-no-door"), true));
    }
    if it.sides == Sides::Soft {
        add_soft(texts, stretch, &mut all);
    }
    all
}

/// A face across one axis is astigmatic where the stretches of the other two differ, and compresses grazing views where they are
/// not 1.
fn add_soft(texts: &Texts, stretch: glam::DVec3, all: &mut Vec<(String, bool)>) {
    let along = |axis: usize| (stretch[(axis + 1) % 3], stretch[(axis + 2) % 3]);
    let differ = |a: f64, b: f64| (a / b - 1.0).abs() > NOTICED;
    let is_astigmatic = (0..3).any(|axis| {
        let (a, b) = along(axis);
        differ(a, b)
    });
    let grazes = (0..3).any(|axis| {
        let (a, b) = along(axis);
        differ(a, 1.0) && differ(b, 1.0)
    });
    if is_astigmatic {
        all.push((texts.say("workshop-told-astigmatic"), true));
    } else if grazes {
        all.push((texts.say("workshop-told-grazing"), false));
    }
}

/// What a portal does to who passes, and whether that is a warning.
pub fn of_portal(texts: &Texts, room: &Room, space: &Space, name: &str) -> (String, bool) {
    let Some(own) = portal(room, name) else {
        return (String::new(), false);
    };
    let to = own.to.as_str();
    let portals = space.portals();
    let Some(placed) = portals.iter().find(|it| it.portal.name == name) else {
        return (
            texts.say_with(misfit(room, name, own), &[("name", to.into())]),
            true,
        );
    };
    if name == to {
        return (texts.say("workshop-told-itself"), false);
    }
    let scale = placed.scale;
    let values = |times: f64| [("name", to.into()), ("times", Value::decimals(times, 2))];
    let told = if (scale - 1.0).abs() < NOTICED {
        texts.say_with("workshop-told-alike", &values(1.0)[..1])
    } else if scale > 1.0 {
        texts.say_with("workshop-told-grows", &values(scale))
    } else {
        texts.say_with("workshop-told-shrinks", &values(1.0 / scale))
    };
    (told, false)
}

/// Why a portal is closed.
fn misfit(room: &Room, name: &str, own: &Portal) -> &'static str {
    let Some(other) = portal(room, &own.to) else {
        return "workshop-told-no-partner";
    };
    if other.to != name {
        return "workshop-told-one-way";
    }
    if other.sides != own.sides {
        return "workshop-told-other-sides";
    }
    let shape = |it: &Portal| match &it.opening {
        Opening::Size(size) => size.x / size.y,
        Opening::Polygon(_) => 0.0,
    };
    if (shape(own) - shape(other)).abs() > 1e-6 {
        return "workshop-told-not-similar";
    }
    "workshop-told-ill-placed"
}

fn portal<'r>(room: &'r Room, name: &str) -> Option<&'r Portal> {
    match &room.find(name)?.1.what {
        What::Portal(it) => Some(it),
        _ => None,
    }
}
