//! The ECS-lite world and its rules, advanced one fixed step at a time.
//!
//! The scene is Euclidean: everything here is authored in chart metres. Which space a world is in is asked
//! nowhere; the strategy answers where it matters.

pub mod actions;
mod aim;
pub mod bearings;
mod body;
pub mod bot;
pub mod camera;
pub mod car;
mod closed_day;
pub mod day;
mod detail;
mod dip;
pub mod drops;
pub mod frame;
pub mod ground;
mod gun;
mod hand;
mod harm;
mod hit_shapes;
pub mod inventory;
pub mod item;
pub mod lamp;
pub mod lens;
mod light;
pub mod motion;
pub mod notice;
mod npc;
pub mod persist;
mod photo;
pub mod pick;
mod pictured;
pub mod player;
pub mod posture;
pub mod probe;
mod probing;
pub mod projectile;
mod reach;
mod scene;
mod setup;
mod shown;
pub mod sound;
mod spawn;
mod step;
mod stream;
pub mod survey;
pub mod tuning;
mod viewing;

pub use actions::Actions;
pub use camera::CameraMode;
pub use car::CarView;
pub use inventory::{Inventory, Stack};
pub use item::Item;
pub use lens::{DialGoals, Lens};
pub use notice::{Hint, Notice};
pub use npc::{Line, NpcMode, Speech, State, Wound};
pub use photo::Viewpoint;
pub use posture::{Clip, Posture};
pub use probe::Probe;
pub use scene::Scene;
pub use setup::{SceneError, WorldSetup};
pub use sound::{SoundEvent, Surroundings};
pub use stream::CloseFailure;
pub use viewing::Viewing;
