//! Renames, duplicates, exports and imports worlds.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use crate::archive::{WORLD_FILES, WORLDS};
use crate::batch::Batch;
use crate::error::StorageError;
use crate::maintenance::Inspection;
use crate::name;
use crate::named_folders::make_file;
use crate::saves::SavesDir;
use crate::schema::WorldMeta;
use crate::scratch::Scratch;
use crate::turn::Turn;
use crate::world::WorldStore;
use crate::{archive, maintenance};

/// How many exported worlds of one directory are told of.
const MOST_ARCHIVES: usize = 200;

/// A file that looks like an exported world by its name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ArchiveFile {
    /// Where it is.
    pub path: PathBuf,
    /// Its length, bytes.
    pub size_bytes: u64,
}

/// The exported worlds in `dir`, newest first, at most 200; none if it cannot be read.
/// Nothing is opened, so nothing is said of whether they are whole.
pub fn archives_in(dir: &Path, extension: &str) -> Vec<ArchiveFile> {
    let entries = fs::read_dir(dir).into_iter().flatten().flatten();
    let mut found: Vec<(SystemTime, ArchiveFile)> = entries
        .filter_map(|entry| {
            let path = entry.path();
            let data = fs::metadata(&path).ok().filter(fs::Metadata::is_file)?;
            let is_archive = path
                .extension()
                .is_some_and(|its| its.eq_ignore_ascii_case(extension));
            let file = ArchiveFile {
                path,
                size_bytes: data.len(),
            };
            is_archive.then(|| (data.modified().unwrap_or(SystemTime::UNIX_EPOCH), file))
        })
        .collect();
    found.sort_by(|a, b| (b.0, &a.1.path).cmp(&(a.0, &b.1.path)));
    found
        .into_iter()
        .map(|(_, file)| file)
        .take(MOST_ARCHIVES)
        .collect()
}

impl SavesDir {
    /// Gives a world another name. Its directory stays, since it may be known elsewhere by that.
    ///
    /// # Errors
    /// [`StorageError::Name`] with the reason, [`StorageError::InUse`] for a world that
    /// is open anywhere, [`StorageError::Busy`], otherwise as [`WorldStore::open`] and
    /// [`WorldStore::commit`].
    pub fn rename(&self, slug: &str, name: &str) -> Result<(), StorageError> {
        let dir = self.world_dir(slug)?;
        let _turn = Turn::wait(self.path())?;
        let worlds = self.list()?;
        let others = worlds.iter().filter(|world| world.slug != slug);
        Self::check_name_among(name, others.map(crate::WorldSummary::name))?;
        rename_store(&WorldStore::open(&dir)?, name.trim())
    }

    /// Makes a second world like the first, under its name with a number, and returns
    /// the name of the new one's directory. It appears whole or not at all.
    ///
    /// # Errors
    /// [`StorageError::InUse`] for a world that is open anywhere,
    /// [`StorageError::Unreadable`] (repair it first), failures of the file system.
    pub fn duplicate(&self, slug: &str) -> Result<String, StorageError> {
        let dir = self.world_dir(slug)?;
        let world = WorldStore::open(&dir)?;
        let scratch = self.scratch("copy")?;
        let name = world.meta().name;
        world
            .copy_to(scratch.path())
            .map_err(|error| error.of_world(&name, scratch.path(), self.path()))?;
        drop(world);
        self.adopt(&scratch)
    }

    /// Writes a world into one file, which must not exist. The file appears whole or not at all.
    ///
    /// # Errors
    /// [`StorageError::InUse`], [`StorageError::Unreadable`] and [`StorageError::Damaged`]
    /// (repair it first), [`StorageError::Exists`], failures of the file system.
    pub fn export(&self, slug: &str, file: &Path) -> Result<(), StorageError> {
        let dir = self.world_dir(slug)?;
        make_file(file, |scratch, packed| {
            // Opening recovers a world that was not closed, in memory, and refuses a damaged one.
            let world = WorldStore::open_to_read(&dir)?;
            // Nobody could import it again.
            if let Some(fault) = Inspection::of(&world).faults.into_iter().next() {
                return Err(fault);
            }
            let name = world.meta().name;
            world
                .copy_to(scratch.path())
                .and_then(|()| archive::pack(&WORLDS, scratch.path(), &WORLD_FILES, packed))
                .map_err(|error| error.of_world(&name, scratch.path(), file))
        })
    }

    /// Adds a world from an exported file and returns its directory's name. Nothing
    /// is overwritten: if its name is taken it gets a number. Every part of it is checked
    /// before it appears in the list.
    ///
    /// # Errors
    /// [`StorageError::Archive`], [`StorageError::Newer`], failures of the file system.
    pub fn import(&self, file: &Path) -> Result<String, StorageError> {
        let scratch = self.scratch("import")?;
        let name = file.display().to_string();
        let said = |error: StorageError| error.of_world(&name, scratch.path(), self.path());
        archive::unpack(&WORLDS, file, scratch.path()).map_err(said)?;
        let adopted = refuse_damaged(scratch.path()).and_then(|()| self.adopt(&scratch));
        adopted.map_err(|error| match error {
            StorageError::NotFound { .. } => no_world(file, "there is none"),
            damaged if damaged.is_damage() => no_world(file, &damaged.damage()),
            // Its name cannot be read then, and its directory here is none.
            StorageError::Newer { found, .. } => StorageError::Newer {
                world: file.display().to_string(),
                found,
            },
            other => said(other),
        })
    }

    /// Makes a world of the finished store in `scratch`, under a name that is free.
    fn adopt(&self, scratch: &Scratch) -> Result<String, StorageError> {
        let world = WorldStore::open(scratch.path())?;
        let _turn = Turn::wait(self.path())?;
        let name = self.free_name(&world.meta().name)?;
        rename_store(&world, &name)?;
        drop(world);
        self.settle(scratch, &name)
    }

    /// A name like `wanted` that may be used: what may be used of it, or that with a number in
    /// the place of the one it may have.
    fn free_name(&self, wanted: &str) -> Result<String, StorageError> {
        let worlds = self.list()?;
        let taken: Vec<&str> = worlds.iter().map(crate::WorldSummary::name).collect();
        Ok(name::free_name(wanted, "World", &taken))
    }
}

fn rename_store(world: &WorldStore, name: &str) -> Result<(), StorageError> {
    let meta = WorldMeta {
        name: name.to_owned(),
        ..world.meta()
    };
    world.commit(&Batch {
        meta: Some(meta),
        ..Batch::default()
    })
}

/// Refuses a world that `verify` would call damaged.
fn refuse_damaged(dir: &Path) -> Result<(), StorageError> {
    match maintenance::inspect(dir)?.faults.into_iter().next() {
        Some(fault) => Err(fault),
        None => Ok(()),
    }
}

fn no_world(archive: &Path, reason: &str) -> StorageError {
    StorageError::Archive {
        path: archive.to_path_buf(),
        reason: format!("the world in it is damaged or missing: {reason}"),
    }
}
