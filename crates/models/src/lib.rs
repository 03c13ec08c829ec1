//! glTF models as plain data, and the poses of their skeletons. No GPU, no files, no window.
//!
//! [`Model::from_glb`] reads a binary glTF file from memory and refuses with one plain sentence whatever it cannot
//! show faithfully; no bytes make it panic. A model has [`Mesh`]es placed by the nodes of a [`Skeleton`], [`Skin`]s
//! that tie vertices to nodes, and [`Clip`]s that move nodes. A [`Pose`] says where every node is:
//!
//! ```
//! # fn main() -> Result<(), antipode_models::Error> {
//! use antipode_models::{Mask, Model, Pose};
//! # let file = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../assets/models/astronaut.glb"));
//! let model = Model::from_glb(file)?;
//! let skeleton = &model.skeleton;
//! if let (Some(walk), Some(hold), Some(belt)) = (model.clip("walk"), model.clip("hold"), skeleton.find("spine")) {
//!     let mut pose = walk.pose(skeleton, 0.3);
//!     pose.layer(&hold.pose(skeleton, 1.2), &Mask::below(skeleton, belt), 1.0);
//!     let joints = pose.model_matrices(skeleton);
//!     let skinning = model.skins[0].matrices(&joints);
//!     assert_eq!(skinning.len(), model.skins[0].joints.len());
//! }
//! # Ok(()) }
//! ```
//!
//! Axes are the file's, as glTF has them: metres, right-handed, y up, the front towards +z, the right-hand side
//! towards -x. The game's figures look along +x with their right at +z; [`GAME_FROM_FILE`] turns one into the other.
//!
//! The `gltf` crate (MIT or Apache 2.0) parses and validates the JSON. The container and the accessors are read
//! here: version 1.4 of the crate subtracts and multiplies lengths from the file unchecked, which panics, and so does
//! its validation where a mesh refers to positions that are not there, which is why that is looked at before.

mod accessor;
mod bounds;
mod clip;
mod container;
mod curve;
mod error;
mod load;
mod material;
mod mesh;
mod pose;
mod primitive;
mod skeleton;

use glam::Quat;

pub use bounds::Sphere;
pub use clip::{Channel, Clip};
pub use curve::{Curve, Interpolation};
pub use error::Error;
pub use load::{Model, Note, Part};
pub use material::{Material, Texture};
pub use mesh::{Mesh, Primitive, Vertex};
pub use pose::{Mask, Pose};
pub use skeleton::{Joint, Skeleton, Skin, Transform};

/// The turn from the file's axes (front +z) to the game's (front +x, right-hand side +z): a quarter about y.
pub const GAME_FROM_FILE: Quat = Quat::from_xyzw(
    0.0,
    std::f32::consts::FRAC_1_SQRT_2,
    0.0,
    std::f32::consts::FRAC_1_SQRT_2,
);
