//! Draws a [`Frame`](antipode_frame::Frame) into a texture view with wgpu.
//!
//! [`Gpu`] opens an adapter. A [`Renderer`] keeps the terrain's meshes on it and draws one frame after another.
//! [`Offscreen`] is a target that can be read back. For each frame a [`Planner`] decides which chunks are drawn and
//! how, and the renderer then records shadow maps, the scene and the tone map.
//!
//! This crate opens no window and loads no world. It never asks which space a world is in: the frame's strategy
//! brings the shader text of its map.

mod baked;
mod ball;
mod bent_mesh;
mod blend;
mod block_sight;
mod celestial;
mod charts;
mod chunk_store;
mod coarse;
mod culling;
mod draw_list;
mod dust;
mod error;
mod fallen;
mod figure_buffers;
mod figure_draws;
mod figure_pipelines;
mod figures;
mod flash;
mod gpu;
mod hand;
mod heavens;
mod lamps;
mod land_mesh;
mod low_growth;
mod marker;
mod models;
mod offscreen;
mod openings;
mod outlines;
mod page_allocator;
mod pages;
mod parts;
mod pipeline_cache;
mod pipelines;
mod plan;
mod pressers;
mod refinements;
mod renderer;
mod rig;
mod seams;
mod shaders;
mod shades;
mod shadow;
mod subdivision_thread;
mod targets;
mod terrain_pipelines;
mod things;
mod tile;
mod timing;
mod tonemap;
mod touched;
mod uniforms;

pub use bent_mesh::{BentCorners, BentMesh, BentSurface};
pub use error::RenderError;
pub use gpu::{AdapterChoice, Gpu};
pub use hand::{HAND_FOCAL, Held, before_eye, in_hand_of};
pub use offscreen::{Offscreen, PictureReading};
pub use plan::{
    Affine, ChunkChoice, ChunkLand, FramePlan, Ground, LandIndex, PlanStats, Planner, Port, plan,
    tolerance_px,
};
pub use renderer::{DrawStats, FurtherView, Options, Picture, Preset, Renderer, ViewTarget};
pub use rig::HandPose;
pub use shaders::{Shader, Shaders, TERRAIN};
pub use shadow::{ShadowQuality, ShadowStats};
pub use subdivision_thread::Delivery;
pub use tile::Tile;
pub use tonemap::{MirrorPlace, Tonemap};
