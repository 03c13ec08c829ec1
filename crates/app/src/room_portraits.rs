//! The menu's pictures of the rooms that come with the game.

macro_rules! portraits {
    ($($id:literal),* $(,)?) => {
        &[$(($id, include_bytes!(concat!("../../../assets/rooms/", $id, "/picture.png")))),*]
    };
}

/// By the room's id: PNG, 320 by 180 pixels.
const ALL: &[(&str, &[u8])] = portraits![
    "long-house",
    "big-house",
    "twelve-rooms",
    "nested-boxes",
    "four-tunnels",
    "thesis-room",
    "two-portals",
    "closet-flat",
    "six-portals",
    "growing-hall",
    "door-to-itself",
    "bottomless-shaft",
];

/// The picture of a room of the game.
pub fn of(id: &str) -> Option<&'static [u8]> {
    ALL.iter()
        .find(|(known, _)| *known == id)
        .map(|(_, bytes)| *bytes)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

    use antipode_rooms::shipped;
    use image::GenericImageView as _;

    use super::*;

    #[test]
    fn every_room_of_the_game_has_a_picture_of_the_menus_size() {
        for room in shipped::ROOMS {
            let bytes = of(room.id).unwrap_or_else(|| panic!("{} has none", room.id));
            assert!(bytes.len() < 80_000, "{}", room.id);
            let picture = image::load_from_memory(bytes).unwrap();
            assert_eq!(picture.dimensions(), (320, 180), "{}", room.id);
        }
    }
}
