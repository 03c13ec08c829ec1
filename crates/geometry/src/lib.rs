//! Curved-space mathematics: charts, spaces, views, projections, crossings.
//!
//! The game's world is authored, simulated and saved in flat *chart* metres with y up. Only the
//! last step, the port, is curved: a [`Strategy`] turns a [`ChartPoint`] into a point of a
//! Euclidean, hyperbolic or spherical space as seen by an [`Eye`]. Everything here is `f64`;
//! it is cast once, when a [`SpaceUniform`] is made for `shaders/geometry.wgsl`, which mirrors
//! this crate. There is no input, no output and no GPU here.
//!
//! A space is made of four traits: [`Atlas`], [`Map`], [`Optics`] and [`Metric`]. Each space has a folder:
//! `flat`, `hyperbolic` (of two maps) and `spherical`. What several share lies beside the folders, and
//! the arithmetic that shaders mirror in [`kernel`]. A fourth space is a folder beside these, with its
//! `ENTRY`, and a variant of [`Geometry`] (`kind.rs`). [`tiling`] is the hyperbolic plane in squares, in exact numbers, and
//! [`HyperbolicWorld`] the space over it, of which the game makes no world yet. [`BodyChart`] is a chart about a body, in any
//! space, and [`BodyFrame`] what the body moves in there.
//!
//! Conventions: column vectors; view coordinates are x right, y up, z back, with xyz in metres
//! and w without unit, so that the flat limit is regular; the eye is at (0, 0, 0, 1).

mod atlas;
mod body_chart;
mod body_frame;
mod chart;
pub mod charts;
mod chunk;
mod chunk_cube;
pub mod doorway;
mod eye;
mod flat;
mod frustum;
mod hyperbolic;
mod hyperbolic_world;
pub mod kernel;
mod kind;
mod level_map;
mod map;
mod metric;
mod optics;
pub mod pace;
mod point;
mod projection;
pub mod real;
pub mod scalar;
pub mod shader;
mod sight;
mod spherical;
mod strategy;
pub mod tiled;
pub mod tiling;
mod triangle;
mod uniform;
mod view_mode;

pub use atlas::{Atlas, Domain, HeightLimits, NoiseFrame, NoiseQuilt, SquareFrame};
pub use body_chart::BodyChart;
pub use body_frame::BodyFrame;
pub use chart::{ChartId, ParseChartError};
pub use chunk::{CHUNK_CELLS, ChunkCoord};
pub use chunk_cube::ChunkCube;
pub use doorway::{Doorway, Leaf, Passing};
pub use eye::Eye;
pub use flat::Euclidean;
pub use frustum::{Frustum, side_normals};
pub use hyperbolic::{DEFAULT_HYPERBOLIC_RADIUS_M, FAR_LIMIT_RADII, Horizon, Raised};
pub use hyperbolic_world::HyperbolicWorld;
pub use kind::{
    Geometry, HyperbolicMap, ParseGeometryError, ParseMapError, Radii, picture, strategy,
};
pub use level_map::LevelMap;
pub use map::{Dial, Map, Viewer};
pub use metric::{Curvature, Metric};
pub use optics::Optics;
pub use point::{ChartPoint, Crossing};
pub use projection::{Depth, Projection};
pub use real::Real;
pub use shader::MapShader;
pub use sight::{BoundingCylinder, SightCell, azimuth_spread};
pub use spherical::{DEFAULT_SPHERE_RADIUS_M, Globe, Spherical};
pub use strategy::Strategy;
pub use tiled::{Away, Joins, Tiled};
pub use triangle::{equilateral_angle_sum_rad, square_gap_m};
pub use uniform::SpaceUniform;
pub use view_mode::ViewMode;

/// The shader text that all maps share: `struct Space` and what is made of a map's own functions, whose text
/// ([`MapShader`]) is to be appended. It has no entry point and no binding.
pub const WGSL: &str = concat!(
    include_str!("../../../shaders/trigonometry.wgsl"),
    include_str!("../../../shaders/geometry.wgsl"),
);
