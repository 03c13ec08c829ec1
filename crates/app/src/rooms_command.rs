//! `antipode rooms`: looking after rooms from the command line.

use std::collections::HashSet;
use std::path::PathBuf;
use std::sync::Arc;

use antipode_rooms::mesh::{Roundness, meshes};
use antipode_rooms::{Loaded, RoomSummary, RoomsDir, What, rooms_dir};
use clap::Subcommand;

use crate::common::Common;
use crate::confined;
use crate::failure::Failure;
use crate::output::line;

/// What can be done with rooms.
#[derive(Debug, Subcommand)]
pub enum RoomsAction {
    /// Every room: the player's own, then those that come with the game.
    List,
    /// Read a room and every file that it names, and say whether it is sound.
    Verify {
        /// The room's name.
        name: String,
    },
    /// Write a room into one file.
    Export {
        /// The room's name.
        name: String,
        /// The file to write.
        file: PathBuf,
    },
    /// Bring a room in from a file.
    Import {
        /// The file to read.
        file: PathBuf,
    },
}

/// Does what was asked with the rooms.
///
/// # Errors
/// When the room is not there or not sound, or the disk or standard output refuses.
pub fn run(action: &RoomsAction, common: &Common) -> Result<(), Failure> {
    let rooms = RoomsDir::new(rooms_dir(common.saves_dir.as_deref()));
    match action {
        RoomsAction::List => rooms.list()?.iter().try_for_each(|it| line(&row(it))),
        RoomsAction::Verify { name } => {
            let loaded = rooms.open(&rooms.find(name)?)?;
            line(&verified(&loaded))
        }
        RoomsAction::Export { name, file } => {
            rooms.export(&rooms.find(name)?, file)?;
            line(&format!("\"{name}\" is written to {}", file.display()))
        }
        RoomsAction::Import { file } => {
            let slug = confined::import_room(&rooms, file)?;
            line(&format!(
                "The room is in {}",
                rooms.path().join(slug).display()
            ))
        }
    }
}

fn row(room: &RoomSummary) -> String {
    let whose = if room.shipped { "the game's" } else { "yours" };
    let state = room.problem.as_deref().unwrap_or("sound");
    format!(
        "{:<40} {whose:<10} {:>5} objects  {state}",
        room.name, room.objects
    )
}

fn verified(loaded: &Loaded) -> String {
    let room = &loaded.room;
    let lights = room
        .objects
        .iter()
        .filter(|it| matches!(it.what, What::Light { .. }))
        .count();
    let solids = meshes(room, &loaded.assets, Roundness::default());
    let mut known = HashSet::new();
    let shapes = solids
        .iter()
        .filter(|it| known.insert(Arc::as_ptr(&it.shape)));
    let triangles: usize = shapes.map(|it| it.shape.triangles.len()).sum();
    format!(
        "\"{}\" is sound: objects {}, aberrations {}, lights {lights}, triangles {triangles}, files {} with {:.2} MB",
        room.name,
        room.objects.len(),
        room.aberrations().count(),
        loaded.files.len(),
        loaded.bytes as f64 / 1e6
    )
}
