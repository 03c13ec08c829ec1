//! The words of `room`, and of the commands that change a room.

use antipode_storage::SavesDir;

use super::{number, quoted};

/// What `room` does.
#[derive(Clone, Debug, PartialEq)]
pub enum RoomOrder {
    /// Make a room and enter it.
    New {
        /// Its name; without one it is not kept.
        name: Option<String>,
        /// What falls in it is drawn this way, m/s^2; as on Earth when left out.
        gravity: Option<[f64; 3]>,
    },
    /// Enter a room.
    Load(String),
    /// Keep the open room, under another name if there is one.
    Save(Option<String>),
    /// Delete a room.
    Delete(String),
    /// Print the rooms.
    List,
    /// Print the older versions of the open room.
    Versions,
    /// Go back to the older version of that number, 1 for the newest.
    Older(usize),
}

/// What `room` can do.
pub const ROOM_ACTS: [&str; 8] = [
    "new", "load", "save", "delete", "list", "versions", "older", "set",
];

/// The words after `room`.
pub(super) fn room(words: &[&str]) -> Result<RoomOrder, String> {
    let Some((act, rest)) = words.split_first() else {
        return Err("\"room\" has too few words; say what to do with rooms".to_owned());
    };
    match (*act, rest) {
        ("new", options) => new_room(options),
        ("load", [name]) => Ok(RoomOrder::Load(known_name(name)?)),
        ("save", []) => Ok(RoomOrder::Save(None)),
        ("save", [name]) => Ok(RoomOrder::Save(Some(new_name(plain(name))?))),
        ("delete", [name]) => Ok(RoomOrder::Delete(known_name(name)?)),
        ("list", []) => Ok(RoomOrder::List),
        ("versions", []) => Ok(RoomOrder::Versions),
        ("older", [word]) => match word.parse() {
            Ok(number @ 1..=1000) => Ok(RoomOrder::Older(number)),
            _ => Err(format!(
                "{} is no number of an older version; \"room versions\" tells them",
                quoted(word)
            )),
        },
        (act, _) if ROOM_ACTS.contains(&act) => Err(format!(
            "\"room {act}\" has too few, too many or unknown arguments"
        )),
        (act, _) => Err(format!(
            "with rooms nothing is done by {}; there are {}",
            quoted(act),
            ROOM_ACTS.join(", ")
        )),
    }
}

fn new_room(options: &[&str]) -> Result<RoomOrder, String> {
    let (mut name, mut gravity) = (None, None);
    for option in options {
        match option.split_once('=') {
            Some(("name", value)) => name = Some(new_name(value)?),
            Some(("gravity", value)) => gravity = Some(three(value)?),
            _ => return Err(format!("{} is none of name=, gravity=", quoted(option))),
        }
    }
    Ok(RoomOrder::New { name, gravity })
}

/// A name with or without `name=` before it.
fn plain(word: &str) -> &str {
    word.strip_prefix("name=").unwrap_or(word)
}

fn known_name(word: &str) -> Result<String, String> {
    let name = plain(word);
    if name.len() > 1000 {
        return Err(format!("no room is called {}", quoted(name)));
    }
    Ok(name.to_owned())
}

fn new_name(name: &str) -> Result<String, String> {
    match SavesDir::check_name_among(name, []) {
        Ok(()) => Ok(name.to_owned()),
        Err(error) => Err(format!("name={} will not do: {error}", quoted(name))),
    }
}

fn three(text: &str) -> Result<[f64; 3], String> {
    let parts: Vec<_> = text.split(',').collect();
    let [x, y, z] = parts[..] else {
        return Err(format!("{} is not three numbers, X,Y,Z", quoted(text)));
    };
    let [x, y, z] = [x, y, z].map(|part| number(part, -100.0, 100.0));
    Ok([x?, y?, z?])
}
