//! Draws deformed rooms by tracing rays on the adapter.
//!
//! A [`RayScene`] is meshes, materials, instances of meshes, aberrations and lights, in plain types. [`Rays::upload`] puts it
//! into the adapter's memory as a [`Loaded`] scene, with a hierarchy of boxes for each mesh that is made once and kept, and one
//! over all instances that is made anew whenever they move. [`Rays::draw`] traces every pixel of a [`Picture`] in one
//! compute pass of 8 x 8 groups: its light, linear and unclamped as the game's tone map takes it, and beside it what is seen
//! at each pixel and how many felt metres off. Where [`Options::raster`] allows it, a raster finds what the eye's rays meet, and the
//! same pass goes on from there.
//!
//! Light goes by the rule of `antipode-deformation`, which `shaders/rays` mirrors in `f32`; [`Prober`] traces lists of rays by
//! the same text, to compare both. Nothing here opens a window or an adapter.

mod baked;
mod crowd;
mod error;
mod frame;
mod kinds;
mod loaded;
mod mesh;
mod options;
mod packed;
mod packed_portals;
mod picture;
mod prepared;
mod prober;
mod raster;
mod rastered;
mod rays;
mod scene;
mod shaders;
mod texels;
mod textures;
mod top;
mod tree;
mod trees;

pub use error::RaysError;
pub use loaded::Loaded;
pub use mesh::Mesh;
pub use options::{Options, Outlines, View};
pub use picture::{Picture, Pixel, Seen};
pub use prepared::Shader;
pub use prober::{Answer, Outcome, ProbeRay, Prober};
pub use rays::Rays;
pub use scene::{
    Eye, Instance, Lamp, MAX_LAMPS, Material, Mover, Outline, Pattern, RayScene, Sky, Sun,
    TextureImage, WALL_DEFAULT,
};
pub use shaders::{PICTURE, PROBE, RASTER, RASTERED};
