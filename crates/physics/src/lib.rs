//! Rapier behind a small vocabulary of our own.
//!
//! Everything here happens in a chart: metres as `DVec3`, y up. [`PhysicsWorld`] has the
//! [`ChartGround`] of every chart, the terrain of the chunks that are loaded, which
//! answers rays, sphere casts and overlaps; a [`Character`] is plain
//! state that [`BodyGround::move_character`] moves through it. A [`Vehicle`] is a body with wheels that
//! [`VehiclePhysics::step`] moves among copies of the ground near it. Nothing in this crate knows of
//! voxels or drawing, nor how charts hang together: what crosses is carried by the caller. Where a metre of a chart is not one of
//! the space, a [`BodyGround`] has what is near a body in metres of the space.
//!
//! Rapier computes in `f32`. The ground of a chart therefore keeps the true origins in `f64` and gives Rapier
//! positions relative to a floating origin that follows the player
//! ([`ChartGround::recentre`]). The character is computed in `f64` in a frame of its own.

mod air;
mod ball;
mod body_ground;
mod character;
mod chart_ground;
mod collider;
mod lift;
mod loose;
mod mover;
mod patch;
mod rays;
mod triangle;
mod tuning;
mod vehicle;
mod walk;
mod world;

pub use ball::{Ball, BallTuning, Thrown, Touch, meets_capsule};
pub use body_ground::BodyGround;
pub use character::{Character, CharacterInput};
pub use chart_ground::{ChartGround, Obstacle, Solid};
pub use collider::TerrainCollider;
pub use loose::{LooseBlow, LooseBodies, LooseBody, LooseMotion, LooseShape};
pub use rays::RayHit;
pub use tuning::CharacterTuning;
pub use vehicle::{
    Side, Vehicle, VehicleDoors, VehicleInput, VehicleMotion, VehiclePart, VehiclePhysics,
    VehicleTuning, VehicleWheel,
};
pub use world::PhysicsWorld;
