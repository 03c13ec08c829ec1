//! A folder of worlds in memory, emptied for each input.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use antipode_storage::{SavesDir, WORLD_FILE};
use tempfile::TempDir;

/// Where a file system in memory is mounted on Linux.
const MEMORY: &str = "/dev/shm";

/// A folder of worlds of its own, gone when this is dropped.
pub struct WorldFolder {
    root: TempDir,
    saves: SavesDir,
}

/// The directory of the world that is tried in it.
pub const VICTIM: &str = "victim";

impl WorldFolder {
    /// Makes an empty one, in memory where the system has such a place.
    ///
    /// # Errors
    /// When no directory can be made.
    pub fn new() -> io::Result<Self> {
        let root = match TempDir::new_in(MEMORY) {
            Ok(root) => root,
            Err(_) => TempDir::new()?,
        };
        let saves = root.path().join("saves");
        fs::create_dir(&saves)?;
        Ok(Self {
            root,
            saves: SavesDir::new(saves),
        })
    }

    /// The worlds.
    pub fn saves(&self) -> &SavesDir {
        &self.saves
    }

    /// A file beside the worlds.
    pub fn beside(&self, name: &str) -> PathBuf {
        self.root.path().join(name)
    }

    /// Leaves one world, [`VICTIM`], with only this file in it.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn plant(&self, file: &str, bytes: &[u8]) -> io::Result<PathBuf> {
        self.empty()?;
        let world = self.saves.path().join(VICTIM);
        fs::create_dir(&world)?;
        fs::write(world.join(file), bytes)?;
        Ok(world)
    }

    /// Leaves one world, [`VICTIM`], with this store.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn plant_store(&self, bytes: &[u8]) -> io::Result<PathBuf> {
        self.plant(WORLD_FILE, bytes)
    }

    /// Takes everything away.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn empty(&self) -> io::Result<()> {
        for entry in fs::read_dir(self.root.path())? {
            let path = entry?.path();
            if path == self.saves.path() {
                empty_folder(&path)?;
            } else {
                remove(&path)?;
            }
        }
        Ok(())
    }
}

fn empty_folder(folder: &Path) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        remove(&entry?.path())?;
    }
    Ok(())
}

fn remove(path: &Path) -> io::Result<()> {
    if fs::symlink_metadata(path)?.is_dir() {
        fs::remove_dir_all(path)
    } else {
        fs::remove_file(path)
    }
}

/// Runs `work` in this thread's own folder of worlds, which is as the last one left it.
///
/// # Errors
/// What `work` says, or that there is no folder.
pub fn with_world_folder<T>(
    work: impl FnOnce(&WorldFolder) -> Result<T, String>,
) -> Result<T, String> {
    use std::cell::OnceCell;
    thread_local! {
        static FOLDER: OnceCell<WorldFolder> = const { OnceCell::new() };
    }
    FOLDER.with(|cell| {
        if cell.get().is_none() {
            let folder =
                WorldFolder::new().map_err(|error| format!("no folder for worlds: {error}"))?;
            let _ = cell.set(folder);
        }
        match cell.get() {
            Some(folder) => work(folder),
            None => Err("no folder for worlds".to_owned()),
        }
    })
}
