//! The interface as players see and use it, in every language and size.
#![allow(
    clippy::expect_used,
    clippy::panic,
    clippy::unwrap_used,
    reason = "tests fail by panicking"
)]

mod backpack;
mod common;
mod console;
mod controls;
mod display;
mod focus;
mod fonts;
mod instruments;
mod look;
mod making;
mod menus;
mod names;
mod new_game;
mod newcomers;
mod numbers;
mod photo;
mod rooms;
mod settings;
mod sizes;
mod speech;
mod toasts;
mod workshop;
mod workshop_array;
mod workshop_fields;
mod workshop_newcomers;
mod workshop_stretch;
mod worlds;
