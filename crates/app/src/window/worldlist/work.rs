//! Jobs with saved worlds that run away from the main thread.

use std::path::{Path, PathBuf};

use antipode_storage::{
    ARCHIVE_EXTENSION, ArchiveFile, StorageError, WorldSummary, archives_in, slug_of,
};

use super::news::{News, shown};
use crate::confined;
use crate::failure::Failure;
use crate::session::Worlds;

/// Where worlds and their exports are.
#[derive(Clone, Debug)]
pub struct WorldLocations {
    worlds: Worlds,
    exports: PathBuf,
    home: Option<PathBuf>,
}

impl WorldLocations {
    /// The worlds, and the player's place for documents.
    pub fn new(worlds: Worlds) -> Self {
        let user = directories::UserDirs::new();
        let home = user.as_ref().map(|user| user.home_dir().to_path_buf());
        let documents = user.as_ref().and_then(|user| user.document_dir());
        let exports = documents
            .map(Path::to_path_buf)
            .or_else(|| home.clone())
            .unwrap_or_else(|| worlds.saves().path().to_path_buf());
        Self {
            worlds,
            exports,
            home,
        }
    }

    /// Where exports go unless the player says otherwise.
    pub fn exports(&self) -> &Path {
        &self.exports
    }

    /// The directory of a world.
    pub fn dir_of(&self, slug: &str) -> PathBuf {
        self.worlds.saves().path().join(slug)
    }

    /// The file that an export of a world of this name is proposed to go to, whether or not there is one already. It
    /// goes by the name: the directory keeps the first one that the world ever had.
    pub fn export_to(&self, name: &str) -> String {
        self.export_file(&slug_of(name)).display().to_string()
    }

    /// The same with a number if need be, so that it is free.
    fn free_export(&self, name: &str) -> String {
        let stem = slug_of(name);
        let mut file = self.export_file(&stem);
        let mut number = 2;
        while std::fs::symlink_metadata(&file).is_ok() {
            file = self.export_file(&format!("{stem}-{number}"));
            number += 1;
        }
        file.display().to_string()
    }

    fn export_file(&self, stem: &str) -> PathBuf {
        self.exports.join(format!("{stem}.{ARCHIVE_EXTENSION}"))
    }

    /// The path that a player means: without quotation marks, `~` for the home directory.
    fn path_of(&self, written: &str) -> PathBuf {
        let written = written.trim();
        let bare = ['"', '\'']
            .into_iter()
            .find_map(|mark| written.strip_prefix(mark)?.strip_suffix(mark));
        let path = PathBuf::from(bare.unwrap_or(written));
        match (path.strip_prefix("~"), &self.home) {
            (Ok(rest), Some(home)) => home.join(rest),
            _ => path,
        }
    }
}

/// A piece of work.
#[derive(Clone, Debug, PartialEq)]
pub enum Job {
    List,
    Delete { slug: String },
    Rename { slug: String, name: String },
    Duplicate { slug: String },
    Export { slug: String, file: String },
    Import { file: String },
    LookAt { slug: String },
    FindArchives,
}

/// What a closer look at a world tells.
#[derive(Clone, Debug, PartialEq)]
pub struct Details {
    /// Chunks changed by hand; `None` where the world does not say.
    pub edits: Option<usize>,
    /// A file that an export can go to.
    pub export_to: String,
}

/// What work has come to.
#[derive(Debug, Default)]
pub struct Outcome {
    pub news: Option<News>,
    pub list: Option<Result<Vec<WorldSummary>, Failure>>,
    pub details: Option<(String, Details)>,
    pub archives: Option<Vec<ArchiveFile>>,
}

impl Job {
    /// Whether the list of worlds comes with it.
    pub fn brings_list(&self) -> bool {
        !matches!(
            self,
            Self::LookAt { .. } | Self::FindArchives | Self::Export { .. }
        )
    }

    /// The world whose store it opens.
    pub fn slug(&self) -> Option<&str> {
        match self {
            Self::Delete { slug }
            | Self::Rename { slug, .. }
            | Self::Duplicate { slug }
            | Self::Export { slug, .. } => Some(slug),
            // A look opens no store.
            Self::List | Self::Import { .. } | Self::LookAt { .. } | Self::FindArchives => None,
        }
    }

    /// Does it.
    pub fn run(&self, locations: &WorldLocations) -> Outcome {
        let mut outcome = Outcome::default();
        match self {
            Self::LookAt { slug } => {
                let saves = locations.worlds.saves();
                let edits = saves.edited_chunks(slug).ok().flatten();
                let world = saves.find_slug(slug).ok();
                let name = world.as_ref().map_or(slug.as_str(), WorldSummary::name);
                let export_to = locations.free_export(name);
                outcome.details = Some((slug.clone(), Details { edits, export_to }));
            }
            Self::FindArchives => outcome.archives = Some(archives_in(&locations.exports)),
            _ => match self.change(locations) {
                Ok(news) => outcome.news = news,
                Err(failure) => outcome.news = Some(News::Failed(failure)),
            },
        }
        if self.brings_list() {
            outcome.list = Some(locations.worlds.list());
        }
        outcome
    }

    /// Changes what is on disk; what there is to tell of it.
    fn change(&self, locations: &WorldLocations) -> Result<Option<News>, Failure> {
        let saves = locations.worlds.saves();
        let name_of =
            |slug: &str| -> Result<_, StorageError> { Ok(shown(&saves.find_slug(slug)?)) };
        Ok(match self {
            Self::Delete { slug } => {
                saves.delete(slug)?;
                None
            }
            Self::Rename { slug, name } => {
                saves.rename(slug, name)?;
                Some(News::Renamed(name_of(slug)?))
            }
            Self::Duplicate { slug } => {
                let made = saves.duplicate(slug)?;
                Some(News::Duplicated(name_of(&made)?))
            }
            Self::Export { slug, file } => {
                let mut file = locations.path_of(file);
                if file.extension().is_none() {
                    file.set_extension(ARCHIVE_EXTENSION);
                }
                saves.export(slug, &file)?;
                Some(News::Exported(file))
            }
            Self::Import { file } => {
                let made = confined::import(saves, &locations.path_of(file))?;
                Some(News::Imported(name_of(&made)?))
            }
            Self::List | Self::LookAt { .. } | Self::FindArchives => None,
        })
    }
}

#[cfg(test)]
impl WorldLocations {
    /// The worlds.
    pub fn worlds(&self) -> &Worlds {
        &self.worlds
    }

    /// The same worlds with another place for exports and home.
    pub fn exporting_to(mut self, exports: &Path) -> Self {
        self.exports = exports.to_path_buf();
        self.home = Some(exports.to_path_buf());
        self
    }

    /// What a player's words are taken for.
    pub fn meant_by(&self, written: &str) -> PathBuf {
        self.path_of(written)
    }
}
