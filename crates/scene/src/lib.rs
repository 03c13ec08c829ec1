//! The world and its rules, advanced one fixed step of 1/60 s at a time.
//!
//! A [`Scene`] is an open world. A host calls [`Scene::step`] with the player's [`Actions`], asks for answers, and
//! takes a [`frame`] to be drawn, the sounds and the notices. The player, figures, cars, lamps, things and bullets
//! are entities with small components (`hecs`). Each rule is a function in the file of its subject. The order of the
//! rules is in `step.rs`.
//!
//! The simulation is a pure function of save, seed and actions. All positions are metres of a flat chart. No rule
//! asks which space the world is in; the strategy ([`antipode_geometry`]) answers wherever that matters.

pub mod actions;
pub mod actors;
mod aim;
mod aimed;
mod answers;
pub mod bearings;
mod between;
mod biome;
mod body;
pub mod bot;
mod brush;
pub mod camera;
pub mod car;
mod circumnavigation;
mod closed_day;
mod crafting;
mod crosshair;
mod crumb;
mod damage;
pub mod day;
mod detail;
mod dip;
mod door;
mod door_astride;
mod door_camera;
mod door_light;
mod door_place;
mod door_sill;
pub mod drops;
mod earthworks;
mod falling;
pub mod felling;
mod fixture;
pub mod flag;
pub mod ground;
mod ground_changed;
mod gun;
mod hand;
mod hit_shapes;
pub mod inventory;
mod keeping;
mod lamp;
pub mod lens;
mod light;
mod logs;
mod moment;
pub mod notice;
mod npc;
mod orders;
mod outbox;
mod particles;
pub mod persist;
mod photo;
pub mod pick;
mod planted;
mod planting;
pub mod player;
mod presentation;
mod pressing;
pub mod probe;
mod probing;
pub mod projectile;
mod reach;
mod restore;
mod scene;
mod setup;
mod shown;
pub mod sighting;
mod situation;
pub mod sound;
mod spawn;
mod start;
mod step;
mod stream;
pub mod survey;
mod tool;
pub mod tuning;
mod viewing;
mod world;

pub use actions::Actions;
pub use aimed::Aim;
pub use antipode_frame as frame;
pub use antipode_items::Item;
pub use antipode_streaming::NotUndone;
pub use antipode_terrain::Generator;
pub use antipode_terrain::Kind;
pub use antipode_terrain::Stock;
pub use between::{Between, Shutter};
pub use brush::{Brush, BrushShape, Choice};
pub use camera::{CameraMode, LookTurn};
pub use car::CarView;
pub use crafting::Recipe;
pub use earthworks::{Earthworks, Heap};
pub use inventory::{Inventory, Stack};
pub use lens::{DialGoals, Lens};
pub use moment::Seen;
pub use notice::{Hint, Notice};
pub use npc::{Line, NpcMode, Speech, State, Wound};
pub use photo::Viewpoint;
pub use probe::Probe;
pub use scene::Scene;
pub use setup::{Mode, SceneError, WorldSetup};
pub use sound::{SoundEvent, Surroundings};
pub use stream::CloseFailure;
pub use viewing::Viewing;
