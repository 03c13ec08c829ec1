//! The interface: menus and heads-up display.
//!
//! It draws with egui alone. Each frame the game hands it a plain model
//! ([`MenuModel`], [`HudModel`]) and gets back what the player asked for
//! ([`Intent`]); it owns no game state and touches no file. A frame goes
//! [`show_hud`], then [`Shell::show`]: both paint on one layer, so a menu lies
//! over the display.

mod backdrop;
mod column;
mod controls;
mod dialog;
mod hud;
mod layout;
mod model;
mod new_game;
mod seed;
mod shell;
mod theme;
mod toasts;
mod widgets;
mod worlds;

pub use hud::{CurvatureView, DialKind, FigureModel, HudModel, SlotIcon, SlotView, show_hud};
pub use model::{Binding, GeometryChoice, Intent, MenuModel, Screen, ToastKind, WorldRow};
pub use seed::{SeedError, parse_seed};
pub use shell::Shell;
pub use theme::apply_theme;
