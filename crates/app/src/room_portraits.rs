//! The menu's pictures of the rooms that come with the game.

use antipode_rooms::shipped;

/// The picture of a room of the game.
pub fn of(id: &str) -> Option<&'static [u8]> {
    shipped::find(id).map(|room| room.picture)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]

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
