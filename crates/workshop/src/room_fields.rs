//! The room's own fields in the words of commands: name, sentence, gravity, sky, sun and fog.

use antipode_rooms::bounds::FARTHEST_M;
use antipode_rooms::room::{Fog, Sun};
use antipode_rooms::wording;
use antipode_rooms::words::{colour, number, three, two};
use antipode_rooms::{Colour, Room, shown};

use crate::edit::Field;
use crate::error::{WorkshopError, refuse};

/// What stands for a thing that there is not.
const NONE: &str = "none";
/// All of them.
const KEYS: &str =
    "name, sentence, gravity, sky, light, sun, sun-colour, sun-power, fog and fog-colour";

/// Changes fields of a room.
pub(crate) fn set_room(room: &mut Room, fields: &[Field]) -> Result<(), WorkshopError> {
    for Field { key, value } in fields {
        match key.as_str() {
            "name" => value.trim().clone_into(&mut room.name),
            "sentence" => room.sentence.clone_from(value),
            "gravity" => room.gravity = three(key, value)?,
            "sky" => room.sky.colour = colour(key, value)?,
            "light" => room.sky.light = number(key, value)?,
            _ => set_sun_or_fog(room, key, value)?,
        }
    }
    Ok(())
}

fn set_sun_or_fog(room: &mut Room, key: &str, value: &str) -> Result<(), WorkshopError> {
    let sun = &mut room.sun;
    let fog = &mut room.fog;
    let white = Fog {
        colour: Colour::WHITE,
        reach: FARTHEST_M,
    };
    match key {
        "sun" if value == NONE => *sun = None,
        "sun" => sun.get_or_insert_with(Sun::default).aim = two(key, value)?,
        "sun-colour" => sun.get_or_insert_with(Sun::default).colour = colour(key, value)?,
        "sun-power" => sun.get_or_insert_with(Sun::default).power = number(key, value)?,
        "fog" if value == NONE => *fog = None,
        "fog" => fog.get_or_insert(white).reach = number(key, value)?,
        "fog-colour" => fog.get_or_insert(white).colour = colour(key, value)?,
        _ => return refuse(format!("A room has no {}; it has {KEYS}.", shown(key))),
    }
    Ok(())
}

/// The fields that make a room's own what they are, whatever they were before.
pub fn fields_of(room: &Room) -> Vec<Field> {
    let mut fields = vec![
        Field::new("name", room.name.clone()),
        Field::new("sentence", room.sentence.clone()),
        Field::three("gravity", room.gravity),
        Field::colour("sky", room.sky.colour),
        Field::number("light", room.sky.light),
    ];
    match &room.sun {
        None => fields.push(Field::new("sun", NONE)),
        Some(sun) => fields.extend([
            Field::new("sun", wording::two(sun.aim)),
            Field::colour("sun-colour", sun.colour),
            Field::number("sun-power", sun.power),
        ]),
    }
    match &room.fog {
        None => fields.push(Field::new("fog", NONE)),
        Some(fog) => fields.extend([
            Field::number("fog", fog.reach),
            Field::colour("fog-colour", fog.colour),
        ]),
    }
    fields
}
