//! The models of the screens about worlds and rooms, and their intents.

/// A file that may be an exported world or room.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ArchiveRow {
    /// Where it is, which intents carry back.
    pub file: String,
    /// Its name without the directory.
    pub name: String,
    /// Its length, e.g. "1.2 MB".
    pub size: String,
}

/// A folder in which exported worlds or rooms may be.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FolderRow {
    /// Where it is, which intents carry back.
    pub path: String,
    /// Its name; none for the one in which the folder shown is.
    pub name: Option<String>,
}

/// What is known of worlds or rooms in files.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WorldFiles {
    /// Where exports go and are looked for.
    pub dir: String,
    /// What is there, newest first.
    pub archives: Vec<ArchiveRow>,
    /// Folders in which there may be more: the one that this one is in, and those in it.
    pub folders: Vec<FolderRow>,
    /// Why nothing can be told of that place, as a sentence.
    pub problem: Option<String>,
    /// What is being done with the saves just now, in words.
    pub work: Option<String>,
}

/// What the player asks for concerning saved worlds or rooms.
#[derive(Clone, Debug, PartialEq)]
pub enum WorldsIntent {
    /// Look closer at a world: fills [`crate::WorldRow::edits`] and [`crate::WorldRow::export_to`].
    LookAt {
        /// [`crate::WorldRow::slug`].
        slug: String,
    },
    /// Give a world another name.
    Rename {
        /// [`crate::WorldRow::slug`].
        slug: String,
        /// Checked by [`crate::MenuModel::check_rename`], without surrounding blanks.
        name: String,
    },
    /// Make a second world like this one.
    Duplicate {
        /// [`crate::WorldRow::slug`].
        slug: String,
    },
    /// Write a world into a file.
    Export {
        /// [`crate::WorldRow::slug`].
        slug: String,
        /// As the player wrote it, not empty.
        file: String,
    },
    /// Show a world's directory in the system's own way.
    OpenFolder {
        /// [`crate::WorldRow::slug`].
        slug: String,
    },
    /// Look for exported worlds: fills [`WorldFiles::archives`].
    FindArchives,
    /// Look for them in a folder.
    FindIn {
        /// [`FolderRow::path`].
        folder: String,
    },
    /// Make a world of a file.
    Import {
        /// As the player wrote it, not empty.
        file: String,
    },
}
