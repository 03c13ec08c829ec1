//! A field of the inspector that gets a value, as an edit in the words of the document.

use antipode_rooms::aberration::{Aberration, Lengths, stretch_of_thesis};
use antipode_rooms::bounds::STRETCHES;
use antipode_rooms::room::{Checker, Surface};
use antipode_rooms::wording::number;
use antipode_rooms::{Colour, Object, Room, What};
use antipode_ui::workshop::FieldValue;
use antipode_workshop::{Edit, Field};
use glam::DVec3;

use super::changes::footing;
use super::fields::numbers_of;
use super::link::link;

/// The side of the squares of a checker that is new, metres.
const SQUARE_M: f64 = 1.0;
/// Where a fog that is new hides everything, felt metres.
const FOG_M: f64 = 60.0;

/// The edit of what is chosen; of the room itself where that is nothing. None where it has no such field.
pub fn edit(room: &Room, chosen: &[usize], key: &str, value: &FieldValue) -> Option<Edit> {
    if let Some(of_room) = key.strip_prefix("room-") {
        return of_room_field(room, of_room, value);
    }
    if let Some(of_spawn) = key.strip_prefix("spawn-") {
        return of_spawn_field(room, of_spawn, value);
    }
    if key == "to"
        && let (FieldValue::Text(to), [index]) = (value, chosen)
    {
        return Some(link(room, &room.objects[*index].name, to));
    }
    if key == "group"
        && let FieldValue::Text(group) = value
    {
        let names = chosen.iter().map(|index| room.objects[*index].name.clone());
        return Some(Edit::Carry {
            group: (!group.is_empty()).then(|| group.clone()),
            members: names.collect(),
        });
    }
    let edits: Vec<_> = chosen
        .iter()
        .filter_map(|index| {
            let object = &room.objects[*index];
            let mut fields = fields(object, key, value)?;
            if matches!(key, "size" | "radius" | "height" | "box") {
                fields.extend(footing(object, &fields));
            }
            Some(Edit::Change(object.name.clone(), fields))
        })
        .collect();
    (!edits.is_empty()).then_some(Edit::Several(edits))
}

/// The edit that gives a field the value that it has where nothing is said of it.
pub fn reset(room: &Room, chosen: &[usize], key: &str) -> Option<Edit> {
    let usual = usual(key)?;
    if key.starts_with("room-") || key.starts_with("spawn-") {
        let word = key.trim_start_matches("room-");
        if let Some(word) = word.strip_prefix("spawn-") {
            return Some(Edit::Spawn(vec![Field::new(word, usual)]));
        }
        return Some(Edit::Room(vec![Field::new(word, usual)]));
    }
    let edits: Vec<_> = chosen
        .iter()
        .map(|index| {
            let object = &room.objects[*index];
            let fields = match key {
                "times" | "thesis" | "felt" => {
                    fields(object, "times", &FieldValue::Number(0, 1.0)).unwrap_or_default()
                }
                "times-x" | "times-y" | "times-z" | "times-all" => {
                    fields(object, key, &FieldValue::Number(0, 1.0)).unwrap_or_default()
                }
                "texture-file" => vec![Field::new("texture", usual.clone())],
                _ => vec![Field::new(key, usual.clone())],
            };
            Edit::Change(object.name.clone(), fields)
        })
        .collect();
    (!edits.is_empty()).then_some(Edit::Several(edits))
}

/// What a field is where nothing is said of it, in the words of commands.
fn usual(key: &str) -> Option<String> {
    let room = Room::new("");
    Some(match key {
        "at" | "turn" | "spawn-at" => "0,0,0".to_owned(),
        "glow" => "0".to_owned(),
        "scale" | "room-sun-power" | "times" | "times-x" | "times-y" | "times-z" | "times-all"
        | "thesis" | "felt" => "1".to_owned(),
        "colour" => Surface::default().colour.to_string(),
        "checker" | "texture-file" | "room-has-fog" => "none".to_owned(),
        "finish" => "matt".to_owned(),
        "sides" => "walls".to_owned(),
        "ways" => "both".to_owned(),
        "outline" => "off".to_owned(),
        "text" | "room-sentence" => String::new(),
        "spawn-look" => "-90,0".to_owned(),
        "room-gravity" => antipode_rooms::wording::three(room.gravity),
        "room-sky" => room.sky.colour.to_string(),
        "room-light" => number(room.sky.light),
        "room-sun" => "-60,50".to_owned(),
        "room-sun-colour" => "#fff4e0".to_owned(),
        _ => return None,
    })
}

fn joined(values: &[f64]) -> String {
    let words: Vec<_> = values.iter().map(|it| number(*it)).collect();
    words.join(",")
}

fn fields(object: &Object, key: &str, value: &FieldValue) -> Option<Vec<Field>> {
    if let What::Aberration(it) = &object.what
        && let Some(fields) = of_lengths(it, key, value)
    {
        return Some(fields);
    }
    let surface = &object.surface;
    let checker = surface.checker;
    let textured = |file: &str, size: f64| match file.trim() {
        "" => Field::new("texture", "none"),
        file => Field::new("texture", format!("{file},{}", number(size))),
    };
    let checkered = |checker: Checker| {
        let size = number(checker.size);
        Field::new("checker", format!("{},{size}", checker.colour))
    };
    Some(vec![match (key, value) {
        ("checker", FieldValue::Switch(false)) => Field::new("checker", "none"),
        ("checker", FieldValue::Switch(true)) => checkered(checker.unwrap_or(Checker {
            colour: Colour::WHITE,
            size: SQUARE_M,
        })),
        ("checker-colour", FieldValue::Colour(rgb)) => checkered(Checker {
            colour: Colour(*rgb),
            ..checker?
        }),
        ("checker-size", FieldValue::Number(_, size)) => checkered(Checker {
            size: *size,
            ..checker?
        }),
        ("texture-file", FieldValue::Text(file)) => textured(file, surface.texture.as_ref()?.size),
        ("texture-size", FieldValue::Number(_, size)) => {
            textured(&surface.texture.as_ref()?.file, *size)
        }
        ("steps", FieldValue::Number(_, steps)) => Field::number(key, steps.round()),
        (_, FieldValue::Number(place, number)) => {
            let mut values = numbers_of(object, key)?;
            *values.get_mut(*place)? = *number;
            if key == "box" {
                let half = DVec3::from_slice(&values) / 2.0;
                return Some(of_half(object, half));
            }
            Field::new(key, joined(&values))
        }
        (_, FieldValue::Colour(rgb)) => Field::colour(key, Colour(*rgb)),
        (_, FieldValue::Text(text)) => Field::new(key, text.clone()),
        (_, FieldValue::Switch(on)) => Field::new(key, if *on { "on" } else { "off" }),
        (_, FieldValue::Misread(_)) => return None,
    }])
}

/// The half sizes of a box; its felt length grows with it.
fn of_half(object: &Object, half: DVec3) -> Vec<Field> {
    let mut fields = vec![Field::three("half", half)];
    if let What::Aberration(it) = &object.what
        && let Lengths::Felt { axis, felt_m } = it.lengths
    {
        let grown = half[axis.index()] / it.half[axis.index()];
        fields.push(Field::number("felt", felt_m * grown));
    }
    fields
}

/// What an aberration does to lengths.
fn of_lengths(it: &Aberration, key: &str, value: &FieldValue) -> Option<Vec<Field>> {
    let clamped = |times: f64| times.clamp(*STRETCHES.start(), *STRETCHES.end());
    match (key, value, it.lengths) {
        ("times", FieldValue::Number(_, times), Lengths::Felt { axis, .. }) => {
            let length = 2.0 * it.half[axis.index()];
            Some(vec![Field::number("felt", length * clamped(*times))])
        }
        ("thesis", FieldValue::Number(_, d), Lengths::Felt { axis, .. }) => {
            let length = 2.0 * it.half[axis.index()];
            let times = clamped(stretch_of_thesis(*d)?);
            Some(vec![Field::number("felt", length * times)])
        }
        ("times-all", FieldValue::Number(_, times), Lengths::Stretch(_)) => {
            let stretch = DVec3::splat(clamped(*times));
            Some(vec![Field::three("stretch", stretch)])
        }
        (
            "times-x" | "times-y" | "times-z",
            FieldValue::Number(_, times),
            Lengths::Stretch(stretch),
        ) => {
            let mut stretch = stretch;
            stretch[["times-x", "times-y", "times-z"]
                .iter()
                .position(|it| *it == key)?] = clamped(*times);
            Some(vec![Field::three("stretch", stretch)])
        }
        ("axis", FieldValue::Text(word), Lengths::Felt { axis, felt_m }) => {
            let times = felt_m / (2.0 * it.half[axis.index()]);
            let new = ["x", "y", "z"].iter().position(|it| it == word)?;
            let felt_m = 2.0 * it.half[new] * times;
            Some(vec![
                Field::new("axis", word.clone()),
                Field::number("felt", felt_m),
            ])
        }
        ("lengths", FieldValue::Text(word), _) if word == "stretch" => {
            // Walls leave no doors where more than one axis is stretched.
            Some(vec![Field::three("stretch", it.stretch())])
        }
        ("lengths", FieldValue::Text(_), _) => {
            let stretch = it.stretch();
            let far = |axis: &usize| (stretch[*axis].ln()).abs();
            let axis = (0..3).max_by(|a, b| far(a).total_cmp(&far(b)))?;
            Some(vec![
                Field::new("axis", ["x", "y", "z"][axis]),
                Field::number("felt", 2.0 * it.half[axis] * stretch[axis]),
            ])
        }
        _ => None,
    }
}

fn of_room_field(room: &Room, key: &str, value: &FieldValue) -> Option<Edit> {
    let with = |mut values: Vec<f64>, place: usize, number: f64| {
        *values.get_mut(place)? = number;
        Some(joined(&values))
    };
    let field = match (key, value) {
        ("has-sun", FieldValue::Switch(on)) => {
            Field::new("sun", if *on { "-60,50" } else { "none" })
        }
        ("has-fog", FieldValue::Switch(true)) => Field::number("fog", FOG_M),
        ("has-fog", FieldValue::Switch(false)) => Field::new("fog", "none"),
        ("gravity", FieldValue::Number(place, number)) => Field::new(
            key,
            with(room.gravity.to_array().to_vec(), *place, *number)?,
        ),
        ("sun", FieldValue::Number(place, number)) => Field::new(
            key,
            with(room.sun?.aim.to_array().to_vec(), *place, *number)?,
        ),
        (_, FieldValue::Number(_, number)) => Field::number(key, *number),
        (_, FieldValue::Colour(rgb)) => Field::colour(key, Colour(*rgb)),
        (_, FieldValue::Text(text)) => Field::new(key, text.clone()),
        (_, FieldValue::Switch(_) | FieldValue::Misread(_)) => return None,
    };
    Some(Edit::Room(vec![field]))
}

fn of_spawn_field(room: &Room, key: &str, value: &FieldValue) -> Option<Edit> {
    let FieldValue::Number(place, number) = value else {
        return None;
    };
    let mut values = match key {
        "at" => room.spawn.at.to_array().to_vec(),
        _ => room.spawn.look.to_array().to_vec(),
    };
    *values.get_mut(*place)? = *number;
    Some(Edit::Spawn(vec![Field::new(key, joined(&values))]))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

    use antipode_workshop::Document;

    use super::*;
    use crate::window::workshop::kits::Site;
    use crate::window::workshop::parts::put;

    fn tunnel() -> Document {
        let mut document = Document::new(Room::new("a"));
        for id in ["tunnel", "box"] {
            let x = document.room().objects.len() as f64 * 10.0;
            let site = Site {
                point: DVec3::new(x, 0.0, 0.0),
                normal: DVec3::Y,
                front: DVec3::NEG_Z,
                snap: &|metres| metres,
                ground: &|_| None,
            };
            let edit = put(document.room(), id, &site).unwrap();
            document.edit(&edit).unwrap();
        }
        document
    }

    fn set(document: &mut Document, chosen: &[usize], key: &str, value: &FieldValue) {
        let edit = edit(document.room(), chosen, key, value).unwrap();
        document.edit(&edit).unwrap();
    }

    #[test]
    fn the_thesis_s_number_and_the_slider_and_the_felt_length_say_the_same() {
        let mut document = tunnel();
        let felt =
            |document: &Document| numbers_of(&document.room().objects[1], "felt").unwrap()[0];
        set(&mut document, &[1], "thesis", &FieldValue::Number(0, -0.8));
        assert!((felt(&document) - 20.0).abs() < 1e-9, "{}", felt(&document));
        set(&mut document, &[1], "times", &FieldValue::Number(0, 0.5));
        assert!((felt(&document) - 2.0).abs() < 1e-9);
        set(&mut document, &[1], "box", &FieldValue::Number(2, 8.0));
        assert!(
            (felt(&document) - 4.0).abs() < 1e-9,
            "it grows with the box"
        );
        let reset = reset(document.room(), &[1], "times").unwrap();
        document.edit(&reset).unwrap();
        assert!((felt(&document) - 8.0).abs() < 1e-9);
    }

    #[test]
    fn what_gets_another_height_stands_where_it_stood() {
        let mut document = tunnel();
        let low = |document: &Document, index: usize| {
            let it = &document.room().objects[index];
            it.at.y - crate::window::workshop::chosen::half(&it.what).y
        };
        for (index, key) in [(1, "box"), (2, "size")] {
            let before = low(&document, index);
            set(&mut document, &[index], key, &FieldValue::Number(1, 7.0));
            assert!((low(&document, index) - before).abs() < 1e-9, "{key}");
        }
    }

    #[test]
    fn things_go_into_a_group_and_out_of_it_by_a_list_and_stay_where_they_are() {
        let mut document = tunnel();
        document
            .edit(&Edit::Group {
                name: "house".to_owned(),
                at: DVec3::X,
                members: Vec::new(),
            })
            .unwrap();
        let at = antipode_rooms::poses(document.room())[1];
        let group = |name: &str| FieldValue::Text(name.to_owned());
        set(&mut document, &[1, 2], "group", &group("house"));
        let carried = document.room().objects.iter();
        assert_eq!(carried.filter(|it| it.group.is_some()).count(), 2);
        assert_eq!(antipode_rooms::poses(document.room())[1], at);
        set(&mut document, &[1], "group", &group(""));
        assert_eq!(document.room().objects[1].group, None);
        assert_eq!(antipode_rooms::poses(document.room())[1], at);
    }

    #[test]
    fn several_things_get_one_value_and_keep_the_rest_of_theirs() {
        let mut document = tunnel();
        let before = document.room().clone();
        set(&mut document, &[0, 1, 2], "at", &FieldValue::Number(1, 7.0));
        for (old, new) in before.objects.iter().zip(&document.room().objects) {
            assert_eq!(new.at, DVec3::new(old.at.x, 7.0, old.at.z));
        }
        assert_eq!(document.history().made(), 3, "it is one step");
    }
}
