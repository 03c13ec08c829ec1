//! The player's settings and key bindings, and the file that keeps them.
//!
//! [`fields`] lists every setting with its kind and range, and [`actions`] lists everything that a key can do. The
//! menus, `set` of scripts and console, and the file follow from these two tables. Their texts have keys (`setting-…`,
//! `action-…`), so only the notices for the log are in English.
//!
//! This crate knows no window and no adapter. [`Config`] is plain data; [`open`] reads it, and a [`Keeper`] writes it
//! on a thread of its own.

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
pub use choice::{FrameCap, Language, Map, Msaa, Quality, RenderScale, Shadows, Surfaces};
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
    /// How the panes of the workshop lie, as its interface writes it; empty for how they lie at first.
    pub panes: String,
}
