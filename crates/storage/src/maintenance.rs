//! Verify and repair: what `antipode saves verify` and `repair` do to one world.

use std::fs;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize, Serializer};

use crate::error::StorageError;
use crate::opening::patiently;
use crate::page_check::{self, Held};
use crate::regular::{Entry, FileId};
use crate::salvage::Salvage;
use crate::turn::Turn;
use crate::world::{self, WorldStore};
use crate::{WORLD_FILE, atomic_file, summary};

/// What reading every value of a world has found.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct VerifyReport {
    /// Name of the world, or its directory if that cannot be read.
    pub world: String,
    /// Edited chunks that are whole.
    pub chunks: usize,
    /// Whether there is a state (player and so on) and it is whole.
    pub has_state: bool,
    /// What is damaged, a sentence each.
    pub problems: Vec<String>,
}

impl VerifyReport {
    /// Whether nothing is damaged.
    pub fn is_sound(&self) -> bool {
        self.problems.is_empty()
    }
}

/// What a repair has done. It passes from one process to another.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct RepairReport {
    /// Name of the world.
    pub world: String,
    /// Edited chunks that the new store holds.
    pub chunks: usize,
    /// Whether the state (player and so on) was salvaged.
    pub has_state: bool,
    /// What is lost or older than it was, a sentence each.
    pub losses: Vec<String>,
    /// Where the damaged file is kept; `None` if there was none: nothing needed repair,
    /// or the file was missing, which `losses` tells then.
    #[serde(serialize_with = "as_shown")]
    pub kept: Option<PathBuf>,
}

/// A path that is no text would keep the whole report from being one.
#[expect(clippy::ref_option, reason = "serde calls it so")]
fn as_shown<S: Serializer>(path: &Option<PathBuf>, to: S) -> Result<S::Ok, S::Error> {
    path.as_deref().map(Path::to_string_lossy).serialize(to)
}

/// Reads and decodes every value in the world of `dir`, after the check of every page that
/// opening makes. A damaged world is a report, not an error; one in use or of a newer game
/// is an error.
pub(crate) fn verify(dir: &Path) -> Result<VerifyReport, StorageError> {
    let mut report = inspect(dir)?.report();
    report.problems.extend(summary::fault(dir));
    Ok(report)
}

/// What a look at every value of a store has found.
pub(crate) struct Inspection {
    /// Name of the world, or its directory if that cannot be read.
    world: String,
    chunks: usize,
    has_state: bool,
    /// What is damaged.
    pub(crate) faults: Vec<StorageError>,
}

/// Looks at every value of the store in `dir`, but not at what is beside it.
pub(crate) fn inspect(dir: &Path) -> Result<Inspection, StorageError> {
    match WorldStore::open_to_read(dir) {
        Ok(world) => Ok(Inspection::of(&world)),
        Err(error) if error.is_damage() => Ok(Inspection {
            world: world::label(dir),
            chunks: 0,
            has_state: false,
            faults: vec![error],
        }),
        Err(error) => Err(error),
    }
}

impl Inspection {
    /// Reads every value of an open world.
    pub(crate) fn of(world: &WorldStore) -> Self {
        let mut found = Self {
            world: world.meta().name,
            chunks: 0,
            has_state: false,
            faults: world.faults(),
        };
        match world.state() {
            Ok(state) => found.has_state = state.is_some(),
            Err(error) => found.note(error),
        }
        match world.edited_chunks() {
            Ok(keys) => {
                for key in keys {
                    match world.chunk(&key) {
                        Ok(_) => found.chunks += 1,
                        Err(error) => found.note(error),
                    }
                }
            }
            Err(error) => found.note(error),
        }
        found
    }

    fn note(&mut self, error: StorageError) {
        let sentence = error.to_string();
        if self
            .faults
            .iter()
            .all(|known| known.to_string() != sentence)
        {
            self.faults.push(error);
        }
    }

    fn report(&self) -> VerifyReport {
        VerifyReport {
            world: self.world.clone(),
            chunks: self.chunks,
            has_state: self.has_state,
            problems: self.faults.iter().map(ToString::to_string).collect(),
        }
    }
}

/// Salvages every readable value of the world in `dir` into a fresh store that
/// takes the place of the damaged one, which stays beside it under another name.
/// A world of which only the summary is left is made anew from that. `scratch` is an
/// empty directory among the worlds.
pub(crate) fn repair(dir: &Path, scratch: &Path) -> Result<RepairReport, StorageError> {
    let path = dir.join(WORLD_FILE);
    let label = world::label(dir);
    let entry = StorageError::at("Reading", &path, Entry::at(&path))?;
    // Held until the new store is in its place: what somebody saved meanwhile would be lost.
    let held = match entry {
        Entry::File { .. } => Some(patiently(|| page_check::hold(&path, &label))?),
        _ => None,
    };
    let before = inspect(dir)?.report();
    if before.is_sound() {
        drop(held);
        return mend_summary(dir, before);
    }
    if let Some(found) = summary::newer_version(dir) {
        return Err(StorageError::Newer {
            world: label,
            found,
        });
    }
    let salvage = match entry {
        Entry::File { .. } => Salvage::of(&path, &label)?,
        _ => Salvage::default(),
    };
    let meta = salvage.meta().cloned().or_else(|| summary::read(dir));
    let Some(meta) = meta else {
        let reason =
            "neither it nor summary.bin says which world it is (its seed and geometry)".to_owned();
        return Err(StorageError::Unsalvageable { path, reason });
    };
    let fresh = scratch.join(WORLD_FILE);
    salvage.write(&fresh, &meta)?;
    let kept = {
        // Two repairs may read at once, but only the first puts something in its place.
        let _turn = dir.parent().map(Turn::wait).transpose()?;
        let now = StorageError::at("Reading", &path, FileId::at(&path))?;
        if now != held.as_ref().map(Held::id) {
            return Err(StorageError::InUse { world: label });
        }
        put_in_place(&path, entry, &fresh)?
    };
    if summary::fault(dir).is_some() {
        set_aside(&summary::path(dir))?;
    }
    if let Ok(bytes) = salvage.sealed_meta(&meta) {
        summary::write(dir, &bytes);
    }
    let mut losses = salvage.losses(&before.problems);
    if !matches!(entry, Entry::File { .. }) {
        losses.push("All edits are lost; the terrain is as the seed made it.".to_owned());
    }
    Ok(RepairReport {
        world: meta.name,
        chunks: salvage.chunks(),
        has_state: salvage.has_state(),
        losses,
        kept,
    })
}

/// Repairs a world whose store is sound: its summary at most.
fn mend_summary(dir: &Path, before: VerifyReport) -> Result<RepairReport, StorageError> {
    let mut report = RepairReport {
        world: before.world,
        chunks: before.chunks,
        has_state: before.has_state,
        losses: Vec::new(),
        kept: None,
    };
    if summary::fault(dir).is_some() {
        let world = WorldStore::open(dir)?;
        let path = summary::path(dir);
        report.kept = Some(set_aside(&path)?);
        let replaced = summary::replace(dir, &world.sealed_meta()?);
        StorageError::at("Writing", &path, replaced)?;
        report
            .losses
            .push("Only the summary was bad; it is written anew and nothing is lost.".to_owned());
    }
    Ok(report)
}

/// Keeps what is at `path` under a free name beside it and puts `fresh` in its place,
/// in one step where it is a file. Where it is
/// kept; `None` if there was nothing.
fn put_in_place(path: &Path, entry: Entry, fresh: &Path) -> Result<Option<PathBuf>, StorageError> {
    let kept = match entry {
        Entry::Missing => None,
        Entry::Other(_) => Some(set_aside(path)?),
        Entry::File { .. } => {
            let kept = free_beside(path);
            if fs::hard_link(path, &kept).is_err() {
                StorageError::at("Keeping", &kept, atomic_file::copy(path, &kept))?;
            }
            Some(kept)
        }
    };
    StorageError::at("Replacing", path, fs::rename(fresh, path))?;
    if let Some(dir) = path.parent() {
        atomic_file::sync_dir(dir);
    }
    Ok(kept)
}

/// Moves what is at `path`, whatever it is, to a free name beside it.
fn set_aside(path: &Path) -> Result<PathBuf, StorageError> {
    let kept = free_beside(path);
    StorageError::at("Keeping", path, fs::rename(path, &kept))?;
    Ok(kept)
}

/// The first name like `path` with `.damaged-N` that nothing has.
pub(crate) fn free_beside(path: &Path) -> PathBuf {
    let mut number = 1;
    loop {
        let mut name = path.as_os_str().to_owned();
        name.push(format!(".damaged-{number}"));
        let candidate = PathBuf::from(name);
        if fs::symlink_metadata(&candidate).is_err() {
            return candidate;
        }
        number += 1;
    }
}
