//! What there is to say of a file: as a key with arguments for the player, and as an English sentence for the log.

use std::path::PathBuf;

use thiserror::Error;

use crate::profiles::ProfileError;

/// Something of the file that was not as it should be. The game goes on in every case.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum Notice {
    /// It is damaged. What could be read of it is used.
    #[error(
        "The settings file was damaged. The game uses the settings that it could read and the defaults of the others, and keeps the damaged file as {}.", kept.display()
    )]
    Damaged {
        /// Where it is now.
        kept: PathBuf,
    },
    /// A newer version of the game wrote it.
    #[error(
        "The settings file comes from a newer version of the game. The game uses the settings that it knows, and keeps the file as {}.", kept.display()
    )]
    Newer {
        /// Where it is now.
        kept: PathBuf,
    },
    /// An older version of the game wrote it.
    #[error(
        "The settings file came from an older version and has been updated. The old file is kept as {}.", kept.display()
    )]
    Older {
        /// Where it is now.
        kept: PathBuf,
    },
    /// Some of it could not be used; the other notices say what.
    #[error("The original settings file is kept as {}.", kept.display())]
    Kept {
        /// Where it is now.
        kept: PathBuf,
    },
    /// A setting has a value that it cannot have.
    #[error(
        "The setting {id} has its default value, because the value {given} in the file is not allowed."
    )]
    Value {
        /// The setting.
        id: &'static str,
        /// What the file says, shortened.
        given: String,
    },
    /// There is no setting or action of that name.
    #[error("The settings file names \"{name}\", which this version does not know.")]
    Unknown {
        /// The name.
        name: String,
    },
    /// An action is bound to something that is no input.
    #[error("The action {action} is bound to {given}, which is no key, button or wheel.")]
    Input {
        /// The action's id.
        action: &'static str,
        /// What the file says, shortened.
        given: String,
    },
    /// A profile of key bindings could not be taken in.
    #[error("The key profile \"{name}\" is left out: {why}.")]
    Profile {
        /// Its name, shortened.
        name: String,
        /// Why.
        why: ProfileError,
    },
    /// The file could not be read at all, so nothing is written over it.
    #[error("The settings file {} could not be read ({why}). The game uses the defaults, and changes are not saved.", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        why: String,
    },
    /// The file could not be put aside, so nothing is written over it.
    #[error("The settings file {} could not be put aside ({why}). It is left as it is, and changes are not saved.", path.display())]
    Stuck {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        why: String,
    },
    /// The system has no directory for settings.
    #[error(
        "The system has no folder for settings, so changes are not saved. --config FILE chooses a file."
    )]
    NoPlace,
}

impl Notice {
    /// Key of its text.
    pub fn text_key(&self) -> &'static str {
        match self {
            Self::Damaged { .. } => "settings-file-damaged",
            Self::Newer { .. } => "settings-file-newer",
            Self::Older { .. } => "settings-file-older",
            Self::Kept { .. } => "settings-file-kept",
            Self::Value { .. } => "settings-file-value",
            Self::Unknown { .. } => "settings-file-unknown",
            Self::Input { .. } => "settings-file-input",
            Self::Profile { .. } => "settings-file-profile",
            Self::Unreadable { .. } => "settings-file-unreadable",
            Self::Stuck { .. } => "settings-file-stuck",
            Self::NoPlace => "settings-file-no-place",
        }
    }

    /// What its text is given: names and words.
    pub fn text_arguments(&self) -> Vec<(&'static str, String)> {
        match self {
            Self::Damaged { kept }
            | Self::Newer { kept }
            | Self::Older { kept }
            | Self::Kept { kept } => vec![("file", kept.display().to_string())],
            Self::Value { id, given } => vec![("name", (*id).to_owned()), ("value", given.clone())],
            Self::Unknown { name } | Self::Profile { name, .. } => vec![("name", name.clone())],
            Self::Input { action, given } => {
                vec![("name", (*action).to_owned()), ("value", given.clone())]
            }
            Self::Unreadable { path, why } | Self::Stuck { path, why } => {
                vec![
                    ("file", path.display().to_string()),
                    ("reason", why.clone()),
                ]
            }
            Self::NoPlace => Vec::new(),
        }
    }
}

/// Why the settings could not be saved. They stay in effect until the game ends, and the next change tries again.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("The settings could not be saved to {} ({why}). They stay in effect until the game ends.", path.display())]
pub struct SaveProblem {
    /// The file.
    pub path: PathBuf,
    /// The system's reason.
    pub why: String,
}

impl SaveProblem {
    /// Key of its text.
    pub fn text_key(&self) -> &'static str {
        "settings-file-unsaved"
    }

    /// What its text is given.
    pub fn text_arguments(&self) -> Vec<(&'static str, String)> {
        vec![
            ("file", self.path.display().to_string()),
            ("reason", self.why.clone()),
        ]
    }
}
