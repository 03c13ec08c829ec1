//! Curved-space mathematics: charts, strategies, views, projections, crossings.
//!
//! The game's world is authored, simulated and saved in flat *chart* metres with y up. Only the
//! last step, the port, is curved: a [`Strategy`] turns a [`ChartPoint`] into a point of a
//! Euclidean, hyperbolic or spherical space as seen by an [`Eye`]. Everything here is `f64`;
//! it is cast once, when a [`SpaceUniform`] is made for `shaders/geometry.wgsl`, which mirrors
//! this crate. There is no input, no output and no GPU here.
//!
//! Conventions: column vectors; view coordinates are x right, y up, z back, with xyz in metres
//! and w without unit, so that the flat limit is regular; the eye is at (0, 0, 0, 1).

mod atlas;
mod chart;
pub mod charts;
mod chunk;
mod chunk_cube;
mod euclidean;
mod eye;
mod frustum;
mod horizon;
pub mod kernel;
mod kind;
mod point;
mod projection;
mod raised;
pub mod real;
pub mod scalar;
pub mod shader;
mod sight;
mod spherical;
mod strategy;
mod triangle;
mod uniform;

pub use atlas::{Atlas, Domain, HeightLimits, NoiseFrame, SquareFrame};
pub use chart::{ChartId, ParseChartError};
pub use chunk::{CHUNK_CELLS, ChunkCoord};
pub use chunk_cube::ChunkCube;
pub use euclidean::Euclidean;
pub use eye::Eye;
pub use frustum::{Frustum, side_normals};
pub use horizon::Horizon;
pub use kind::{Geometry, HyperbolicMap, ParseGeometryError, ParseMapError};
pub use point::{ChartPoint, Crossing};
pub use projection::{Depth, Projection};
pub use raised::Raised;
pub use real::Real;
pub use shader::MapShader;
pub use sight::{Drum, SightCell, azimuth_spread};
pub use spherical::Spherical;
pub use strategy::{
    DEFAULT_HYPERBOLIC_RADIUS_M, DEFAULT_SPHERE_RADIUS_M, Dial, FAR_LIMIT_RADII,
    SPHERE_RADIUS_RANGE_M, Strategy, Viewer, picture, strategy,
};
pub use triangle::equilateral_angle_sum_rad;
pub use uniform::SpaceUniform;

/// The shader text that all maps share: `struct Space` and what is made of a map's own functions, whose text
/// ([`MapShader`]) is to be appended. It has no entry point and no binding.
pub const WGSL: &str = concat!(
    include_str!("../../../shaders/trigonometry.wgsl"),
    include_str!("../../../shaders/geometry.wgsl"),
);
