//! How exact the kernels are: against golden files, at branches, at the extremes, and bit for bit.

mod branches;
mod coverage;
mod extremes;
mod functions;
pub mod golden;
mod hyperbolic_world;
mod kernels;
mod repeatable;
mod sources;
mod stale;
mod tiling;
