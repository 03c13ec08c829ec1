//! The hyperbolic plane tiled by squares, five about every corner, in whole numbers.
//!
//! Lengths are in radii of curvature. The cosine of the distance between the centres of neighbouring squares is the
//! golden ratio `phi` exactly, hence its sine is `sqrt(phi)`. With x and z in units of `sqrt(phi)` the moves from tile
//! to tile are matrices of numbers `a + b phi` ([`Golden`]), which are added and multiplied without rounding. So a tile
//! is known by its centre ([`Tile`]) whichever way one comes to it, and the way from one tile to another is exact until it
//! is cast ([`Isometry`]).
//!
//! Vectors of the plane are (x, z, w), w the one of time; points of the space, in `f64`, are (X, Y, Z, W) as everywhere in
//! this crate, on the sheet `W^2 - X^2 - Y^2 - Z^2 = 1`, Y the sine of the height over the plane. Moves of the plane
//! leave Y as it is. Derivations are in docs/geometry.md.

mod chart;
mod disc;
mod error;
mod frame;
mod golden;
mod isometry;
mod number;
mod path;
mod place;
pub mod quilt;
mod side;
mod tile;
mod wide;

pub use chart::{cylindrical_chart, equiangular_chart, equiangular_point};
pub use disc::rings;
pub use error::TilingError;
pub use frame::{Crossed, Frame};
pub use golden::Golden;
pub use isometry::Isometry;
pub use number::MOST_STEPS;
pub use path::TilePath;
pub use place::Place;
pub use side::Side;
pub use tile::{APOTHEM, CORNER_DISTANCE, EDGE_TANH, HALF_EDGE, TILE_AREA, Tile};
