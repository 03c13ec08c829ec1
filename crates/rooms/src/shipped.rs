//! The rooms that come with the game. They are written by hand, and read as anybody's are.
//!
//! What can be read in them is English in their files. Whoever has words in other languages finds them by their keys
//! ([`words`]), in copies of these rooms, too, as long as nobody has changed what is read there.

use std::sync::LazyLock;

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
    /// The picture of it that lists show: PNG, 320 by 180 pixels.
    pub picture: &'static [u8],
}

macro_rules! rooms {
    ($($id:literal),* $(,)?) => {
        &[$(Shipped {
            id: $id,
            text: include_str!(concat!("../../../assets/rooms/", $id, "/room.ron")),
            picture: include_bytes!(concat!("../../../assets/rooms/", $id, "/picture.png")),
        }),*]
    };
}

/// All of them, in the order in which they are to be visited. There is no other list of them.
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
    "falling-crate",
    "way-back",
];

/// The one of that id.
pub fn find(id: &str) -> Option<&'static Shipped> {
    ROOMS.iter().find(|it| it.id == id)
}

/// What can be read in all of them, word for word as in their files, each with its key. The first call reads them all.
pub fn words() -> &'static [(String, String)] {
    static WORDS: LazyLock<Vec<(String, String)>> =
        LazyLock::new(|| ROOMS.iter().flat_map(Shipped::words).collect());
    &WORDS
}

impl Shipped {
    /// The room.
    ///
    /// # Errors
    /// As [`read()`]; a test sees to it that there is none.
    pub fn room(&self) -> Result<Room, RoomError> {
        read(&format!("{}/{ROOM_FILE}", self.id), self.text.as_bytes())
    }

    /// What can be read in the room, each with its key: `ID-sentence`, and `ID-NAME` for the sign of that name if it has a text
    /// with letters. The room's name is what it is found by and not among them; `ID-name` is the key of what a list may show
    /// in its place.
    fn words(&self) -> Vec<(String, String)> {
        let Ok(room) = self.room() else {
            return Vec::new();
        };
        let key = |what: &str| format!("{}-{what}", self.id);
        let mut words = vec![(room.sentence, key("sentence"))];
        for object in &room.objects {
            if let What::Sign { text: Some(it), .. } = &object.what
                && it.contains(char::is_alphabetic)
            {
                words.push((it.clone(), key(&object.name)));
            }
        }
        words
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
