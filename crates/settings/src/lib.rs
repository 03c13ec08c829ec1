//! The player's settings and key bindings, and the file they are kept in.
//!
//! [`fields`] lists every setting with its kind and range, and [`actions`] everything that a key can do: screens,
//! commands and the file are all generated from these two tables. What is shown of them is text by key (`setting-…`,
//! `action-…`), so nothing here speaks a language but the notices for the log.
//!
//! Nothing here knows a window or an adapter. [`Config`] is plain data; [`open`] reads it, and a [`Keeper`] writes
//! it on a thread of its own.

mod action;
mod choice;
mod field;
mod file;
mod input;
mod lesson;
mod pad;
mod profile;
mod profiles;
mod settings;

use std::collections::BTreeSet;

pub use action::{Action, ActionGroup, ActionInfo, actions};
pub use choice::{FrameCap, Language, Map, Msaa, Quality, RenderScale, Shadows};
pub use field::{Field, Given, Group, Kind, SetError, Value, field, fields};
pub use file::{
    Condition, Keeper, Notice, Opened, Reading, SaveProblem, config_path, open, read, write,
};
pub use input::{Input, MouseButton};
pub use lesson::{Done, Lesson, Needs};
pub use pad::PadButton;
pub use profile::{BindError, Conflict, MAX_INPUTS, Profile};
pub use profiles::{MAX_PROFILE_NAME_CHARS, MAX_PROFILES, ProfileError, Profiles};
pub use settings::Settings;

/// Everything that the file keeps.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Config {
    /// The settings.
    pub settings: Settings,
    /// The key bindings.
    pub profiles: Profiles,
    /// What a newcomer has done already of what the hints tell.
    pub learnt: BTreeSet<Lesson>,
}
