//! Lists the worlds, and what can be told of each without opening it for play.

use std::ffi::OsString;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::error::StorageError;
use crate::regular::{self, Entry};
use crate::schema::{self, WorldMeta, WorldState};
use crate::slug::slug_of;
use crate::store::{self, META_KEY};
use crate::survey::fault_in;
use crate::world::{WorldStore, label, store_path};
use crate::{MAX_THUMBNAIL_BYTES, THUMBNAIL_FILE, WORLD_FILE, summary};

/// Where worlds are: `explicit` if given, else the environment's `ANTIPODE_SAVES`,
/// else `./saves` if that is a directory, else the platform's place for such data.
pub fn saves_dir(explicit: Option<&Path>) -> PathBuf {
    let environment = environment();
    let local = PathBuf::from("saves");
    let platform = directories::ProjectDirs::from("", "", "antipode")
        .map(|dirs| dirs.data_dir().join("saves"));
    choose_dir(
        explicit,
        environment.map(PathBuf::from),
        local.is_dir().then_some(local),
        platform,
    )
}

/// Whether [`saves_dir`] is one that somebody has named, on the command line or in the environment.
pub fn is_saves_dir_named(explicit: Option<&Path>) -> bool {
    explicit.is_some() || environment().is_some()
}

fn environment() -> Option<OsString> {
    std::env::var_os("ANTIPODE_SAVES").filter(|value| !value.is_empty())
}

fn choose_dir(
    explicit: Option<&Path>,
    environment: Option<PathBuf>,
    local: Option<PathBuf>,
    platform: Option<PathBuf>,
) -> PathBuf {
    let chosen = explicit
        .map(Path::to_path_buf)
        .or(environment)
        .or(local)
        .or(platform);
    chosen.unwrap_or_else(|| PathBuf::from("saves"))
}

/// One line of the list of worlds.
#[derive(Debug, Clone, PartialEq)]
pub struct WorldSummary {
    /// Name of its directory.
    pub slug: String,
    /// What it is; `None` if nothing readable says so.
    pub meta: Option<WorldMeta>,
    /// Space it takes, bytes.
    pub size_bytes: u64,
    /// Its menu picture, if it has one.
    pub thumbnail: Option<PathBuf>,
    /// Whether it is open, here or elsewhere.
    pub in_use: bool,
    /// What is wrong with it and what can be done, as a sentence; `None` if it is sound
    /// as far as a look tells.
    pub problem: Option<String>,
    /// The error that keeps it from being opened, if that is the problem.
    pub error: Option<LookError>,
}

/// Why a look at a world failed. Two are the same if they say the same.
#[derive(Debug, Clone)]
pub struct LookError(Arc<StorageError>);

impl LookError {
    /// The error itself.
    pub fn get(&self) -> &StorageError {
        &self.0
    }
}

impl PartialEq for LookError {
    fn eq(&self, other: &Self) -> bool {
        self.0.to_string() == other.0.to_string()
    }
}

impl WorldSummary {
    /// What to show as its name: the name, or the directory's if that is unreadable.
    pub fn name(&self) -> &str {
        self.meta.as_ref().map_or(&self.slug, |meta| &meta.name)
    }
}

/// A closer look at one world.
#[derive(Debug, Clone, PartialEq)]
pub struct WorldInfo {
    /// The line of the list.
    pub summary: WorldSummary,
    /// Player and so on; `None` if never played or damaged.
    pub state: Option<WorldState>,
    /// How many chunks are edited.
    pub edited_chunks: usize,
    /// The schema version that this game writes.
    pub schema_version: u16,
    /// What is damaged, a sentence each.
    pub problems: Vec<String>,
}

/// Names of the directories in `saves` that hold a world.
pub(crate) fn slugs(saves: &Path) -> Result<Vec<String>, StorageError> {
    let entries = match fs::read_dir(saves) {
        Ok(entries) => entries,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Vec::new()),
        Err(error) => return Err(StorageError::place("Reading", saves, error)),
    };
    let mut slugs = Vec::new();
    for entry in entries {
        let entry = StorageError::at("Reading", saves, entry)?;
        let Ok(slug) = entry.file_name().into_string() else {
            continue;
        };
        if !slug.starts_with('.') && holds_world(&entry.path()) {
            slugs.push(slug);
        }
    }
    Ok(slugs)
}

/// Whether a directory is a world's, sound or not: everything that is done with
/// worlds goes by this, so that none is listed and then not found. One that cannot be looked into
/// may be a world if it is called as one, and its line says what is wrong; `lost+found` is none.
pub fn holds_world(dir: &Path) -> bool {
    shows_world(dir).unwrap_or_else(|_| {
        let name = dir.file_name().and_then(|name| name.to_str());
        name.is_some_and(|name| slug_of(name) == name)
    })
}

/// Whether there is a world in a directory for certain; an error if nobody can look.
pub(crate) fn shows_world(dir: &Path) -> io::Result<bool> {
    match fs::symlink_metadata(dir.join(WORLD_FILE)) {
        Ok(_) => Ok(true),
        Err(error) if regular::is_absent(&error) => Ok(summary::is_there(dir)),
        Err(error) => Err(error),
    }
}

/// Looks at one world; never fails, a bad world has a `problem`.
pub(crate) fn summarise(saves: &Path, slug: String) -> WorldSummary {
    let dir = saves.join(&slug);
    let thumbnail = Some(dir.join(THUMBNAIL_FILE)).filter(
        |path| matches!(fs::symlink_metadata(path), Ok(data) if data.is_file() && data.len() <= MAX_THUMBNAIL_BYTES),
    );
    let size_bytes = fs::read_dir(&dir).map_or(0, |entries| {
        entries
            .flatten()
            .map(|entry| match Entry::at(&entry.path()) {
                Ok(Entry::File { bytes }) => bytes,
                _ => 0,
            })
            .sum()
    });
    let (meta, in_use, error) = match look(&dir) {
        Ok(meta) => (Some(meta), false, None),
        Err(StorageError::InUse { .. }) => (summary::read(&dir), true, None),
        Err(error) => (summary::read(&dir), false, Some(error)),
    };
    let problem = match &error {
        Some(error) => Some(error.to_string()),
        None if in_use => None,
        None => summary::fault(&dir),
    };
    WorldSummary {
        slug,
        meta,
        size_bytes,
        thumbnail,
        in_use,
        problem,
        error: error.map(|error| LookError(Arc::new(error))),
    }
}

/// What a world is, without changing it where possible.
fn look(dir: &Path) -> Result<WorldMeta, StorageError> {
    let path = store_path(dir)?;
    let label = label(dir);
    match store::peek_meta(&path, &label)? {
        Some(bytes) => schema::read(&bytes, META_KEY.as_bytes())
            .map_err(|fault| fault_in(&label, "what the world is", fault)),
        // Not closed properly: playing will recover it, and a look need not wait for that.
        None => summary::read(dir).map_or_else(
            || WorldStore::open_to_read(dir).map(|world| world.meta()),
            Ok,
        ),
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
    fn the_directory_is_chosen_in_the_documented_order() {
        let [a, b, c, d] = ["a", "b", "c", "d"].map(PathBuf::from);
        let some = |path: &PathBuf| Some(path.clone());
        assert_eq!(choose_dir(Some(&a), some(&b), some(&c), some(&d)), a);
        assert_eq!(choose_dir(None, some(&b), some(&c), some(&d)), b);
        assert_eq!(choose_dir(None, None, some(&c), some(&d)), c);
        assert_eq!(choose_dir(None, None, None, some(&d)), d);
        assert_eq!(choose_dir(None, None, None, None), PathBuf::from("saves"));
        assert_eq!(saves_dir(Some(&a)), a);
        assert!(is_saves_dir_named(Some(&a)));
    }
}
