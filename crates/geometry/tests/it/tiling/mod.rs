//! What must hold of the hyperbolic plane's tiling: exact numbers, frames, ways, places and charts.

mod charts;
pub mod common;
mod frames;
mod ground;
mod paths;
mod places;
mod quilt;
mod reference;
