//! The rooms that come with the game. They are written by hand, and read as anybody's are.
//!
//! What can be read in them is English in their files. Whoever has words in other languages gives them by their keys
//! ([`Shipped::reword`]); a room's copy, which is its player's own, has those of the file.

use crate::error::RoomError;
use crate::files::ROOM_FILE;
use crate::folder::{Assets, Loaded};
use crate::read::read;
use crate::room::{Room, What};

/// A room that comes with the game.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shipped {
    /// What it is known by: words of the letters a to z with `-` between them.
    pub id: &'static str,
    /// The text of its file.
    pub text: &'static str,
}

macro_rules! rooms {
    ($($id:literal),* $(,)?) => {
        &[$(Shipped { id: $id, text: include_str!(concat!("../../../assets/rooms/", $id, "/room.ron")) }),*]
    };
}

/// All of them, in the order in which they are to be visited.
pub const ROOMS: &[Shipped] = rooms![
    "long-house",
    "big-house",
    "twelve-rooms",
    "nested-boxes",
    "four-tunnels",
    "thesis-room",
    "two-portals",
    "closet-flat",
    "six-portals",
    "endless-stair",
    "growing-hall",
    "door-to-itself",
    "bottomless-shaft",
];

/// The one of that id.
pub fn find(id: &str) -> Option<&'static Shipped> {
    ROOMS.iter().find(|it| it.id == id)
}

impl Shipped {
    /// The room.
    ///
    /// # Errors
    /// As [`read()`]; a test sees to it that there is none.
    pub fn room(&self) -> Result<Room, RoomError> {
        read(&format!("{}/{ROOM_FILE}", self.id), self.text.as_bytes())
    }

    /// Gives what can be read in the room in the words that `say` has for its key, and leaves what it has none for. Keys are
    /// `ID-sentence`, and `ID-NAME` for the sign of that name if it has a text with letters. The room's name is what it
    /// is found by and stays; `ID-name` is the key of what a list may show in its place.
    pub fn reword(&self, room: &mut Room, say: impl Fn(&str) -> Option<String>) {
        let ask = |what: &str, text: &mut String| {
            if let Some(words) = say(&format!("{}-{what}", self.id)) {
                *text = words;
            }
        };
        ask("sentence", &mut room.sentence);
        for object in &mut room.objects {
            if let What::Sign {
                text: Some(text), ..
            } = &mut object.what
                && text.contains(char::is_alphabetic)
            {
                ask(&object.name, text);
            }
        }
    }

    /// The room with all that it needs; those of the game have no files besides.
    ///
    /// # Errors
    /// As [`Shipped::room`].
    pub fn loaded(&self) -> Result<Loaded, RoomError> {
        Ok(Loaded {
            room: self.room()?,
            assets: Assets::default(),
            files: vec![ROOM_FILE.to_owned()],
            bytes: self.text.len() as u64,
        })
    }
}
