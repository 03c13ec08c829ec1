//! The hyperbolic world: hyperbolic space over a plane in squares, five about every corner, each square a chart.
//!
//! A chart is made when somebody comes to it: its number is that of its tile ([`crate::tiling::TilePath::number`]), so
//! that there are `2^128` of them and none is ever stored. What leads from chart to chart is exact until it is cast.
//! docs/geometry.md says what is missing for a world, and why the charts are what they are.

mod cache;
mod chart;
mod optics;
mod plan;
mod tiles;
mod world;

pub use world::HyperbolicWorld;
