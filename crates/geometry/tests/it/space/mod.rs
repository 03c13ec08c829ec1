//! What must hold of the curved spaces: golden values, identities and round trips.

mod atlas;
pub mod common;
mod cone;
mod crossing;
mod culling;
mod golden;
mod horizon;
mod limits;
mod picking;
mod round_trip;
mod shader;
mod theses;
