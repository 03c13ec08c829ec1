//! Draws a frame of a scene into a texture view with wgpu.
//!
//! [`Gpu`] opens an adapter, [`Renderer`] keeps the terrain's meshes on it and draws one
//! [`Frame`](antipode_scene::frame::Frame) after another, [`Offscreen`] is a target that can be read back.
//! Nothing here opens a window, loads a world or asks which space the world is in.

mod astronaut;
mod celestial;
mod chunk_store;
mod error;
mod figures;
mod gpu;
mod marker;
mod mesh_buffers;
mod offscreen;
mod pipelines;
mod plan;
mod renderer;
mod shaders;
mod solids;
mod targets;
mod timing;
mod tonemap;
mod uniforms;

pub use error::RenderError;
pub use gpu::{AdapterChoice, Gpu};
pub use offscreen::Offscreen;
pub use plan::{PlanStats, tolerance_px};
pub use renderer::{DrawStats, Options, Renderer};
