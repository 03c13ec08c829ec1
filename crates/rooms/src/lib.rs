//! Rooms: a second kind of place beside worlds, of deformed space.
//!
//! A room is a folder: [`files::ROOM_FILE`], which a person can read and compare line by line, and what it names under
//! `models/` and `textures/`. [`read()`] takes the text and refuses, with file, line and field, whatever is not sound;
//! [`write()`] gives it back, always in one order. [`open`](folder::open) reads a whole folder, [`RoomsDir`] is the
//! directory of a player's rooms, and [`shipped`] has those that come with the game. [`meshes`](mesh::meshes) makes
//! triangles of what stands in a room, and [`space()`] the space of its aberrations and portals, which
//! `antipode-deformation` checks.

pub mod aberration;
pub mod bounds;
mod check;
mod check_kind;
mod colour;
mod error;
mod fbx;
pub mod files;
pub mod folder;
mod gltf_parts;
pub mod import;
mod kinds;
mod library;
mod lines;
pub mod mesh;
mod model;
mod open_space;
mod place;
pub mod portal;
mod pose;
mod read;
pub mod room;
pub mod shipped;
pub mod solids;
mod space;
pub mod wording;
pub mod words;
mod write;

pub use aberration::Aberration;
pub use check::{check, check_each, check_so_far, shown};
pub use colour::Colour;
pub use error::{Fault, RoomError};
pub use folder::{Assets, Loaded};
pub use library::{ARCHIVE, ARCHIVE_EXTENSION, RoomSummary, RoomsDir};
pub use model::{ModelPart, RoomModel};
pub use open_space::{SpaceParts, SpaceSoFar, space_in_parts};
pub use place::rooms_dir;
pub use portal::Portal;
pub use pose::{direction, own_pose, poses, rotation};
pub use read::{read, read_so_far};
pub use room::{Object, Room, What};
pub use space::{aberrations, portals, space, space_so_far};
pub use write::{write, write_so_far};
