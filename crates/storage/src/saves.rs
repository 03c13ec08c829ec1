//! The directory of worlds: lists, finds, makes and deletes them. `transfer` copies, exports and imports them.

use std::fs;
use std::path::{Component, Path, PathBuf};

use crate::error::StorageError;
use crate::listing::{self, WorldInfo, WorldSummary};
use crate::maintenance::{self, RepairReport, VerifyReport};
use crate::name::{self, NameError};
use crate::named_folders::NamedFolders;
use crate::schema::{SCHEMA_VERSION, WorldMeta};
use crate::scratch::{self, Scratch};
use crate::slug::slug_of;
use crate::turn::Turn;
use crate::world::{self, WorldStore};
use crate::{THUMBNAIL_FILE, WORLD_FILE, atomic_file, page_check, store, summary};

/// A directory of worlds. Need not exist until the first world is made.
#[derive(Debug, Clone)]
pub struct SavesDir {
    path: PathBuf,
}

impl SavesDir {
    /// The worlds in `path`.
    pub fn new(path: impl Into<PathBuf>) -> Self {
        Self { path: path.into() }
    }

    /// The directory.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// All worlds, the last played first. Never fails for one bad world: that has a `problem`.
    ///
    /// # Errors
    /// If the directory itself cannot be read; a missing one is empty.
    pub fn list(&self) -> Result<Vec<WorldSummary>, StorageError> {
        scratch::sweep(&self.path);
        let mut worlds: Vec<_> = listing::slugs(&self.path)?
            .into_iter()
            .map(|slug| listing::summarise(&self.path, slug))
            .collect();
        worlds.sort_by_key(|world| {
            let played = world
                .meta
                .as_ref()
                .map_or(0, |meta| meta.last_played_unix_s);
            (std::cmp::Reverse(played), world.slug.clone())
        });
        Ok(worlds)
    }

    /// Finds a world by its name, ignoring case, or by its directory.
    ///
    /// # Errors
    /// [`StorageError::NotFound`], or if the directory cannot be read.
    pub fn find(&self, name_or_slug: &str) -> Result<WorldSummary, StorageError> {
        let wanted = name::folded(name_or_slug);
        let worlds = self.list()?;
        let by_name = worlds
            .iter()
            .find(|world| name::folded(world.name()) == wanted);
        let found = by_name.or_else(|| {
            worlds
                .iter()
                .find(|world| world.slug == name_or_slug.trim())
        });
        found.cloned().ok_or_else(|| self.not_found(name_or_slug))
    }

    /// The world in the directory `slug`.
    ///
    /// # Errors
    /// [`StorageError::NotFound`].
    pub fn find_slug(&self, slug: &str) -> Result<WorldSummary, StorageError> {
        self.world_dir(slug)?;
        Ok(listing::summarise(&self.path, slug.to_owned()))
    }

    /// How many chunks of a world are edited; nothing where it was not closed properly, which only opening it to play
    /// puts right. Looks without opening the store, so that it keeps nobody from playing.
    ///
    /// # Errors
    /// As [`WorldStore::open`].
    pub fn edited_chunks(&self, slug: &str) -> Result<Option<usize>, StorageError> {
        let dir = self.world_dir(slug)?;
        store::peek_chunk_count(&world::store_path(&dir)?, &world::label(&dir))
    }

    /// Whether a new world may be called `name` when the worlds of the given names are there. Reads no
    /// disk, so a form can ask with every letter typed.
    ///
    /// # Errors
    /// The reason in words.
    pub fn check_name_among<'a>(
        name: &str,
        taken: impl IntoIterator<Item = &'a str>,
    ) -> Result<(), NameError> {
        name::check(name)?;
        let wanted = name::folded(name);
        match taken
            .into_iter()
            .find(|existing| name::folded(existing) == wanted)
        {
            Some(existing) => Err(NameError::Taken {
                existing: existing.to_owned(),
            }),
            None => Ok(()),
        }
    }

    /// Whether a new world may have this name.
    ///
    /// # Errors
    /// The reason in words, for the form. An unreadable directory is no reason here:
    /// making the world will say so.
    pub fn check_name(&self, name: &str) -> Result<(), NameError> {
        name::check(name)?;
        let worlds = self.list().unwrap_or_default();
        Self::check_name_among(name, worlds.iter().map(WorldSummary::name))
    }

    /// Makes a world, or nothing: it appears whole, under a directory made from its
    /// name. Blanks around the name are dropped.
    ///
    /// # Errors
    /// [`StorageError::Name`], [`StorageError::Busy`], failures of the file system.
    pub fn create(&self, meta: &WorldMeta) -> Result<(String, WorldStore), StorageError> {
        let _turn = Turn::wait(&self.path)?;
        self.check_name(&meta.name)?;
        let meta = WorldMeta {
            name: meta.name.trim().to_owned(),
            ..meta.clone()
        };
        let scratch = self.scratch("new")?;
        let made = WorldStore::create(scratch.path(), &meta).map_err(|error| {
            let place = self.path.join(slug_of(&meta.name));
            error.of_world(&meta.name, scratch.path(), &place)
        });
        drop(made?);
        let slug = self.settle(&scratch, &meta.name)?;
        let world = self.open(&slug)?;
        Ok((slug, world))
    }

    /// Opens a world by its directory.
    ///
    /// # Errors
    /// As [`WorldStore::open`].
    pub fn open(&self, slug: &str) -> Result<WorldStore, StorageError> {
        WorldStore::open(&self.world_dir(slug)?)
    }

    /// Deletes a world for good. It is moved aside first, so one that is half deleted when the
    /// game is killed is never listed; what cannot be removed is put back where it was.
    ///
    /// # Errors
    /// [`StorageError::InUse`] for a world that is open, here or elsewhere;
    /// [`StorageError::NotReadable`] for a directory that nobody can look into, which may be
    /// somebody else's; failures of the file system.
    pub fn delete(&self, slug: &str) -> Result<(), StorageError> {
        self.delete_while(slug, || {})
    }

    /// Deletes a world; `meanwhile` is what a test has others do before it is gone.
    fn delete_while(&self, slug: &str, meanwhile: impl FnOnce()) -> Result<(), StorageError> {
        let dir = self.world_dir(slug)?;
        if !StorageError::at("Reading", &dir, listing::shows_world(&dir))? {
            return Err(self.not_found(slug));
        }
        let name = world::label(&dir);
        // Held until it is out of the way, or somebody who opens it now would play in what is being deleted.
        let held = match page_check::hold(&dir.join(WORLD_FILE), &name) {
            Ok(held) => Some(held),
            Err(error @ StorageError::InUse { .. }) => return Err(error),
            // Any other fault of it is no matter.
            Err(_) => None,
        };
        meanwhile();
        let aside = self.scratch("trash")?;
        let moved = aside.path().join(slug);
        let said = |error| StorageError::io("Deleting", &dir, error).of_world(&name, &dir, &dir);
        // Windows moves no directory in which a file is open, which keeps it from others as well.
        let held = held.filter(|_| !cfg!(windows));
        fs::rename(&dir, &moved).map_err(said)?;
        drop(held);
        atomic_file::sync_dir(&self.path);
        fs::remove_dir_all(&moved).map_err(|error| {
            // Failing, it stays in the hidden directory, which the next sweep tries to remove.
            let _ = fs::rename(&moved, &dir);
            said(error)
        })
    }

    /// A closer look at a world.
    ///
    /// # Errors
    /// As [`WorldStore::open`] but for damage, which is in `problems`.
    pub fn info(&self, slug: &str) -> Result<WorldInfo, StorageError> {
        let dir = self.world_dir(slug)?;
        let summary = listing::summarise(&self.path, slug.to_owned());
        let mut info = WorldInfo {
            summary,
            state: None,
            edited_chunks: 0,
            schema_version: SCHEMA_VERSION,
            problems: Vec::new(),
        };
        match WorldStore::open_to_read(&dir) {
            Ok(world) => {
                info.problems = world.problems();
                info.problems.extend(summary::fault(&dir));
                info.state = world.state().unwrap_or_default();
                info.edited_chunks = world.edited_chunks().map_or(0, |keys| keys.len());
            }
            Err(error) if error.is_damage() => info.problems.push(error.to_string()),
            Err(error) => return Err(error),
        }
        Ok(info)
    }

    /// Reads every value of a world and says what is damaged.
    ///
    /// # Errors
    /// As [`WorldStore::open`] but for damage, which is in the report.
    pub fn verify(&self, slug: &str) -> Result<VerifyReport, StorageError> {
        maintenance::verify(&self.world_dir(slug)?)
    }

    /// Salvages what is readable of a damaged world into a fresh store, and keeps the
    /// damaged file beside it. A sound world is left as it is.
    ///
    /// # Errors
    /// [`StorageError::Unsalvageable`] (nothing is changed then),
    /// [`StorageError::InUse`], [`StorageError::Newer`], failures of the file system.
    pub fn repair(&self, slug: &str) -> Result<RepairReport, StorageError> {
        let dir = self.world_dir(slug)?;
        let scratch = self.scratch("repair")?;
        maintenance::repair(&dir, scratch.path())
            .map_err(|error| error.of_world(&world::label(&dir), scratch.path(), &dir))
    }

    /// Where a world's menu picture is or would be.
    ///
    /// # Errors
    /// [`StorageError::NotFound`].
    pub fn thumbnail_path(&self, slug: &str) -> Result<PathBuf, StorageError> {
        Ok(self.world_dir(slug)?.join(THUMBNAIL_FILE))
    }

    /// A hidden directory among the worlds, which are made room for if need be.
    pub(crate) fn scratch(&self, purpose: &str) -> Result<Scratch, StorageError> {
        NamedFolders::new(&self.path).scratch(purpose)
    }

    fn not_found(&self, world: &str) -> StorageError {
        StorageError::NotFound {
            world: world.to_owned(),
            dir: self.path.clone(),
        }
    }

    /// The directory of an existing world. A slug is one plain directory name.
    pub(crate) fn world_dir(&self, slug: &str) -> Result<PathBuf, StorageError> {
        let mut parts = Path::new(slug).components();
        let plain = matches!((parts.next(), parts.next()), (Some(Component::Normal(part)), None) if part == slug);
        let dir = self.path.join(slug);
        if plain && !slug.starts_with('.') && listing::holds_world(&dir) {
            Ok(dir)
        } else if self.path.is_file() {
            let path = self.path.clone();
            Err(StorageError::NotADirectory { path })
        } else {
            Err(self.not_found(slug))
        }
    }

    /// Moves a finished world to the first free directory name for `name`.
    pub(crate) fn settle(&self, scratch: &Scratch, name: &str) -> Result<String, StorageError> {
        NamedFolders::new(&self.path).settle(scratch, name, "world")
    }
}

#[cfg(test)]
mod tests {
    #![allow(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        reason = "tests fail by panicking"
    )]

    use super::*;

    #[test]
    fn names_are_checked_against_others_without_a_directory() {
        let check = |name: &str| SavesDir::check_name_among(name, ["Straße", "other"]);
        assert_eq!(check("Third"), Ok(()));
        assert_eq!(check("Othe"), Ok(()));
        for name in ["Straße", " STRASSE ", "strasse"] {
            let existing = "Straße".to_owned();
            assert_eq!(check(name), Err(NameError::Taken { existing }), "{name}");
        }
        assert_eq!(check(""), Err(NameError::Empty));
        assert_eq!(
            SavesDir::check_name_among("other", std::iter::empty()),
            Ok(())
        );
    }

    #[test]
    fn nobody_opens_a_world_while_it_is_being_deleted() {
        let dir = tempfile::tempdir().unwrap();
        let saves = SavesDir::new(dir.path().join("saves"));
        let meta = WorldMeta {
            name: "Going".to_owned(),
            ..WorldMeta::default()
        };
        let (slug, world) = saves.create(&meta).unwrap();
        drop(world);
        let mut opened = None;
        saves
            .delete_while(&slug, || opened = Some(saves.open(&slug).map(drop)))
            .unwrap();
        assert!(
            matches!(opened, Some(Err(StorageError::InUse { .. }))),
            "{opened:?}"
        );
        assert!(!saves.path().join(slug).exists());
    }

    #[test]
    fn only_plain_directory_names_are_slugs() {
        let dir = tempfile::tempdir().unwrap();
        let saves = SavesDir::new(dir.path().join("saves"));
        drop(
            WorldStore::create(
                &dir.path().join("outside"),
                &WorldMeta {
                    name: "x".to_owned(),
                    ..WorldMeta::default()
                },
            )
            .unwrap(),
        );
        for slug in [
            "../outside",
            "..",
            ".",
            "",
            "a/../../outside",
            "saves/../outside",
            "missing",
        ] {
            assert!(
                matches!(saves.open(slug), Err(StorageError::NotFound { .. })),
                "{slug}"
            );
            assert!(
                matches!(saves.delete(slug), Err(StorageError::NotFound { .. })),
                "{slug}"
            );
        }
        assert!(dir.path().join("outside").join(WORLD_FILE).exists());
    }
}
