//! The program `antipode`: a window, input, the command line and scripts. It joins the other crates to a game.
//!
//! [`cli`] reads the command line. [`window`] plays in a window, [`script`] plays by commands, and both hold a
//! [`session::Session`], which is one open world. [`picture`] draws a world into a file, and [`saves_command`] lists,
//! checks, exports and repairs saves. [`wording`] says what other crates report in the player's language.

pub mod bindings;
pub mod cli;
pub mod common;
pub mod confined;
pub mod console;
pub mod controls;
pub mod crash;
pub mod dates;
pub mod drawn;
pub mod ending;
pub mod failure;
pub mod hud;
mod hud_brush;
pub mod log;
pub mod log_file;
mod mirror;
pub mod names;
pub mod navigator;
pub mod options;
pub mod output;
pub mod overlay;
pub mod pad;
pub mod perf;
pub mod picture;
pub mod room_figures;
pub mod room_picture;
pub mod room_portraits;
pub mod room_texts;
mod rooms;
pub mod rooms_command;
pub mod saves_command;
pub mod screenshots;
pub mod script;
pub mod session;
pub mod surroundings;
pub mod text;
pub mod tour;
pub mod trouble;
pub mod window;
pub mod wording;
