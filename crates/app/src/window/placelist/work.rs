//! Jobs with saved worlds and rooms that run away from the main thread.

use std::path::{Path, PathBuf};

use antipode_storage::{ArchiveFile, slug_of};
use antipode_ui::{FolderRow, legible};

use super::news::News;
use super::shelf::{Kept, Shelf};
use crate::failure::Failure;

/// Where places of one kind and their exports are.
#[derive(Clone, Debug)]
pub struct Locations<S> {
    shelf: S,
    exports: PathBuf,
    home: Option<PathBuf>,
}

impl<S: Shelf> Locations<S> {
    /// The shelf, and the player's place for documents.
    pub fn new(shelf: S) -> Self {
        let user = directories::UserDirs::new();
        let home = user.as_ref().map(|user| user.home_dir().to_path_buf());
        let documents = user.as_ref().and_then(|user| user.document_dir());
        let exports = documents
            .map(Path::to_path_buf)
            .or_else(|| home.clone())
            .unwrap_or_else(|| shelf.path().to_path_buf());
        Self {
            shelf,
            exports,
            home,
        }
    }

    /// The shelf.
    pub fn shelf(&self) -> &S {
        &self.shelf
    }

    /// Where exports go unless the player says otherwise.
    pub fn exports(&self) -> &Path {
        &self.exports
    }

    /// The directory of one.
    pub fn dir_of(&self, slug: &str) -> PathBuf {
        self.shelf.path().join(slug)
    }

    /// The file that an export of one of this name is proposed to go to, whether or not there is one already. It
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
        self.exports.join(format!("{stem}.{}", S::EXTENSION))
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
    Delete {
        slug: String,
    },
    Rename {
        slug: String,
        name: String,
    },
    Duplicate {
        slug: String,
    },
    Export {
        slug: String,
        file: String,
    },
    Import {
        file: String,
    },
    LookAt {
        slug: String,
    },
    /// In that folder, or where exports go.
    FindArchives {
        folder: Option<PathBuf>,
    },
}

/// Most folders that are shown of a folder.
const MOST_FOLDERS: usize = 200;

/// Archives in a folder, and where else there may be some.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FoundFiles {
    /// The folder; none before one was looked at.
    pub folder: Option<PathBuf>,
    pub archives: Vec<ArchiveFile>,
    within: Vec<PathBuf>,
    /// Why the folder cannot be read, if it cannot.
    pub unread: Option<String>,
}

impl FoundFiles {
    /// Looks into a folder. Waits for the disk.
    fn of<S: Shelf>(folder: &Path) -> Self {
        let (entries, unread) = match std::fs::read_dir(folder) {
            Ok(entries) => (Some(entries), None),
            Err(why) => (None, Some(why.to_string())),
        };
        let entries = entries.into_iter().flatten().flatten();
        let is_shown = |path: &PathBuf| {
            let name = path.file_name().unwrap_or_default();
            path.is_dir() && !name.to_string_lossy().starts_with('.')
        };
        let mut within: Vec<_> = entries.map(|it| it.path()).filter(is_shown).collect();
        within.sort();
        within.truncate(MOST_FOLDERS);
        Self {
            folder: Some(folder.to_path_buf()),
            archives: S::archives(folder),
            within,
            unread,
        }
    }

    /// The folder above, and those in it.
    pub fn folders(&self) -> Vec<FolderRow> {
        let row = |path: &Path, name: Option<String>| FolderRow {
            path: path.display().to_string(),
            name,
        };
        let above = self.folder.as_deref().and_then(Path::parent);
        let within = self.within.iter().map(|path| {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            row(path, Some(legible(&name).into_owned()))
        });
        above
            .map(|it| row(it, None))
            .into_iter()
            .chain(within)
            .collect()
    }
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
#[derive(Debug)]
pub struct Outcome<K> {
    pub news: Option<News>,
    pub list: Option<Result<Vec<K>, Failure>>,
    pub details: Option<(String, Details)>,
    pub found: Option<FoundFiles>,
}

impl Job {
    /// Whether the list comes with it.
    pub fn brings_list(&self) -> bool {
        !matches!(
            self,
            Self::LookAt { .. } | Self::FindArchives { .. } | Self::Export { .. }
        )
    }

    /// The one whose files it opens.
    pub fn slug(&self) -> Option<&str> {
        match self {
            Self::Delete { slug }
            | Self::Rename { slug, .. }
            | Self::Duplicate { slug }
            | Self::Export { slug, .. } => Some(slug),
            // A look opens no store.
            Self::List | Self::Import { .. } | Self::LookAt { .. } | Self::FindArchives { .. } => {
                None
            }
        }
    }

    /// Does it.
    pub fn run<S: Shelf>(&self, locations: &Locations<S>) -> Outcome<S::Kept> {
        let mut outcome = Outcome {
            news: None,
            list: None,
            details: None,
            found: None,
        };
        match self {
            Self::LookAt { slug } => {
                let edits = locations.shelf.edits(slug);
                let place = locations.shelf.find(slug).ok();
                let name = place.as_ref().map_or(slug.as_str(), Kept::name);
                let export_to = locations.free_export(name);
                outcome.details = Some((slug.clone(), Details { edits, export_to }));
            }
            Self::FindArchives { folder } => {
                let folder = folder.as_deref().unwrap_or(&locations.exports);
                outcome.found = Some(FoundFiles::of::<S>(folder));
            }
            _ => match self.change(locations) {
                Ok(news) => outcome.news = news,
                Err(failure) => outcome.news = Some(News::Failed(failure)),
            },
        }
        if self.brings_list() {
            outcome.list = Some(locations.shelf.list());
        }
        outcome
    }

    /// Changes what is on disk; what there is to tell of it.
    fn change<S: Shelf>(&self, locations: &Locations<S>) -> Result<Option<News>, Failure> {
        let shelf = &locations.shelf;
        let name_of = |slug: &str| -> Result<_, Failure> { Ok(shelf.find(slug)?.shown()) };
        Ok(match self {
            Self::Delete { slug } => {
                shelf.delete(slug)?;
                None
            }
            Self::Rename { slug, name } => {
                shelf.rename(slug, name)?;
                Some(News::Renamed(name_of(slug)?))
            }
            Self::Duplicate { slug } => {
                let made = shelf.duplicate(slug)?;
                Some(News::Duplicated(name_of(&made)?))
            }
            Self::Export { slug, file } => {
                let mut file = locations.path_of(file);
                if file.extension().is_none() {
                    file.set_extension(S::EXTENSION);
                }
                shelf.export(slug, &file)?;
                Some(News::Exported(file))
            }
            Self::Import { file } => {
                let made = shelf.import(&locations.path_of(file))?;
                Some(News::Imported(name_of(&made)?))
            }
            Self::List | Self::LookAt { .. } | Self::FindArchives { .. } => None,
        })
    }
}

#[cfg(test)]
impl<S: Shelf> Locations<S> {
    /// The same shelf with another place for exports and home.
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
