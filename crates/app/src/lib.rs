//! Antipode: window, input, command line and scripts; wires the other crates together.

pub mod bindings;
pub mod cli;
pub mod controls;
pub mod drawn;
pub mod failure;
pub mod hud;
pub mod lab_command;
pub mod log;
pub mod names;
pub mod output;
pub mod overlay;
pub mod perf;
pub mod picture;
pub mod saves_command;
pub mod script;
pub mod session;
pub mod tour;
pub mod window;
