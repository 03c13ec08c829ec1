//! From the text of `room.ron` to a [`Room`] that is sound, or to a sentence with file, line and field.

use ron::extensions::Extensions;
use serde::Deserialize;

use crate::bounds::MOST_ROOM_BYTES;
use crate::check::check;
use crate::error::{Fault, RoomError};
use crate::folder::printable;
use crate::lines;
use crate::room::{Room, VERSION};

/// The first that is read of a file, so that what a newer game has in it is no riddle.
#[derive(Deserialize)]
struct Head {
    version: u32,
}

/// Reads a room from bytes. `file` is what sentences call the file. Files that the room names are not looked at.
///
/// # Errors
/// [`RoomError::Text`] for whatever is wrong in the text or in what it says, [`RoomError::Newer`].
pub fn read(file: &str, bytes: &[u8]) -> Result<Room, RoomError> {
    let (room, text) = parse(file, bytes)?;
    check(&room).map_err(|fault| RoomError::Text {
        file: file.to_owned(),
        line: lines::line_of(text, &fault.path),
        fault,
    })?;
    Ok(room)
}

/// The same of a room that was being changed, which need not be sound: what [`crate::write_so_far`] has written.
///
/// # Errors
/// As [`read`], but for what is wrong in what the text says.
pub fn read_so_far(file: &str, bytes: &[u8]) -> Result<Room, RoomError> {
    parse(file, bytes).map(|(room, _)| room)
}

fn parse<'t>(file: &str, bytes: &'t [u8]) -> Result<(Room, &'t str), RoomError> {
    let whole = |reason: String| RoomError::Text {
        file: file.to_owned(),
        line: 1,
        fault: Fault {
            path: String::new(),
            field: "the file".to_owned(),
            reason,
        },
    };
    if bytes.len() as u64 > MOST_ROOM_BYTES {
        return Err(whole(format!(
            "has {} bytes, and at most {MOST_ROOM_BYTES} make sense",
            bytes.len()
        )));
    }
    let text = std::str::from_utf8(bytes).map_err(|error| RoomError::Text {
        file: file.to_owned(),
        line: lines::line_at(bytes, error.valid_up_to()),
        fault: Fault {
            path: String::new(),
            field: "the file".to_owned(),
            reason: "is not text in UTF-8 here".to_owned(),
        },
    })?;
    let refused = |error: &ron::error::SpannedError| unreadable(file, text, error);
    // Of extensions, those that make the file easier to write: `fog: (...)`, `Aberration(half: ...)`.
    let options = ron::Options::default()
        .with_default_extension(Extensions::IMPLICIT_SOME | Extensions::UNWRAP_VARIANT_NEWTYPES);
    let head: Head = options.from_str(text).map_err(|error| refused(&error))?;
    if head.version > VERSION {
        return Err(RoomError::Newer {
            file: file.to_owned(),
            line: lines::line_of(text, "version"),
            found: head.version,
        });
    }
    let room: Room = options.from_str(text).map_err(|error| refused(&error))?;
    Ok((room, text))
}

/// The longest path of a field that is told.
const MOST_PATH_CHARS: usize = 120;

/// What the library could not read, with the field that it stands in.
fn unreadable(file: &str, text: &str, error: &ron::error::SpannedError) -> RoomError {
    let place = error.span.start;
    let at = lines::byte_at(text, place.line, place.col);
    // A name that nobody knows may have any length.
    let path = lines::path_at(text, at).unwrap_or_default();
    let path: String = path.chars().take(MOST_PATH_CHARS).collect();
    let field = if path.is_empty() {
        "the file".to_owned()
    } else {
        path.clone()
    };
    let reason = printable(&error.code.to_string());
    RoomError::Text {
        file: file.to_owned(),
        line: place.line.max(1),
        fault: Fault {
            path,
            field,
            reason: format!("cannot be read: {}", reason.trim_end_matches('.')),
        },
    }
}
