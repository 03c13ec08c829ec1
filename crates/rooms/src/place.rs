//! Where rooms are kept.

use std::fs;
use std::path::{Path, PathBuf};

use antipode_storage::{ROOMS_FOLDER, holds_world, is_saves_dir_named, saves_dir};

use crate::files::ROOM_FILE;

/// Where rooms are kept, by what the command line says of worlds: in `rooms` within a directory that somebody has named,
/// so that all of a game is there, and otherwise in `rooms` beside the directory of worlds.
pub fn rooms_dir(named: Option<&Path>) -> PathBuf {
    let saves = saves_dir(named);
    if is_saves_dir_named(named) {
        rooms_within(&saves)
    } else {
        rooms_beside(&saves)
    }
}

fn rooms_beside(saves: &Path) -> PathBuf {
    match (saves.parent(), saves.file_name()) {
        (Some(parent), Some(_)) => parent.join(ROOMS_FOLDER),
        _ => saves.join(ROOMS_FOLDER),
    }
}

/// Rooms were kept beside every directory of worlds once: those that are there and nowhere else stay in use, and so does
/// that place where a world is called as the folder of rooms is.
fn rooms_within(saves: &Path) -> PathBuf {
    let (within, beside) = (saves.join(ROOMS_FOLDER), rooms_beside(saves));
    let has_room = |dir: &Path| {
        let entries = fs::read_dir(dir).into_iter().flatten().flatten();
        let mut files = entries.map(|it| it.path().join(ROOM_FILE));
        files.any(|it| it.is_file())
    };
    if holds_world(&within) || (!within.exists() && has_room(&beside)) {
        beside
    } else {
        within
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

    use super::*;

    #[test]
    fn a_game_that_nobody_has_placed_has_its_rooms_beside_its_worlds() {
        for (saves, rooms) in [
            ("/home/me/antipode/saves", "/home/me/antipode/rooms"),
            ("saves", "rooms"),
            ("/", "/rooms"),
        ] {
            assert_eq!(rooms_beside(Path::new(saves)), Path::new(rooms));
        }
    }

    #[test]
    fn a_named_directory_has_rooms_within_it_and_old_ones_are_found() {
        let place = tempfile::tempdir().unwrap();
        let saves = place.path().join("mine");
        let (within, beside) = (saves.join("rooms"), place.path().join("rooms"));
        assert_eq!(rooms_dir(Some(&saves)), within);
        // Somebody else's folder of that name.
        fs::create_dir_all(beside.join("kitchen")).unwrap();
        assert_eq!(rooms_dir(Some(&saves)), within);
        fs::write(beside.join("kitchen").join(ROOM_FILE), "").unwrap();
        assert_eq!(rooms_dir(Some(&saves)), beside);
        fs::create_dir_all(&within).unwrap();
        assert_eq!(rooms_dir(Some(&saves)), within);
        fs::write(within.join(antipode_storage::WORLD_FILE), "").unwrap();
        assert_eq!(rooms_dir(Some(&saves)), beside);
    }
}
