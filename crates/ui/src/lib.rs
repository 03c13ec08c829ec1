//! The interface: menus and the display over the world, drawn with egui alone.
//!
//! In each frame the game passes in a plain model ([`MenuModel`], [`HudModel`]) and gets back the player's wishes
//! ([`Intent`]). The interface owns no game state and touches no file. A frame calls [`show_hud`] and then
//! [`Shell::show`]; both paint on one layer, so that a menu lies over the display.

mod about;
mod backdrop;
mod backpack;
mod column;
mod console;
mod contrast;
mod controls;
mod dialog;
mod entry;
mod fonts;
mod hud;
mod icons;
mod layout;
mod legible;
mod model;
mod naming;
mod new_game;
mod photo;
mod seed;
mod settings;
mod shell;
mod theme;
mod toasts;
mod trail;
mod widgets;
pub mod workshop;
mod worlds;

pub use about::AboutModel;
pub use backpack::{
    Backpack, BackpackModel, BackpackWish, EarthView, MakingModel, PartView, RecipeView,
};
pub use console::{Completion, Console, LineKind};
pub use contrast::{heighten_contrast, set_calm};
pub use controls::{action_label, first_input_label, input_label, pad_input_label};
pub use hud::{
    BrushForm, BrushModel, BrushRow, CompassModel, CurvatureView, DamageModel, DialKind,
    FigureModel, FlagView, GuidePlace, GuideView, HeapModel, HintModel, HudModel, MapMark,
    MapModel, MarkKind, Relief, ReliefNode, RoomModel, SlotView, SpeechModel, Tint, Tints,
    WoundModel, mirror_place, show_hud, tints_of,
};
pub use legible::{legible, legible_name};
pub use model::{
    Backdrop, GeometryChoice, Intent, MenuModel, ModeChoice, OwnRoom, Screen, ToastKind, WorldRow,
};
pub use naming::Naming;
pub use photo::{FIELD_OF_VIEW_DEG, PhotoModel, PhotoValues, PhotoWishes, photo_panel, show_photo};
pub use seed::{SeedError, parse_seed};
pub use shell::Shell;
pub use theme::apply_theme;
pub use worlds::{ArchiveRow, FolderRow, WorldFiles, WorldsIntent};
