//! Rapier behind a small vocabulary of our own.
//!
//! Everything here happens in *physics space*: chart metres as `DVec3`, y up, every chart of the
//! world standing at its own place in the one flat space. [`PhysicsWorld`] holds the terrain of the
//! chunks that are loaded and answers rays, sphere casts and overlaps; a [`Character`] is plain
//! state that [`PhysicsWorld::move_character`] moves through it. A [`Vehicle`] is a body with wheels that
//! [`VehiclePhysics::step`] moves among copies of the ground near it. Nothing in this crate knows of
//! curvature, voxels or drawing.
//!
//! Rapier computes in `f32`. The world therefore keeps the true origins in `f64` and gives Rapier
//! positions relative to a floating origin that follows the player
//! ([`PhysicsWorld::recentre`]). The character is computed in `f64` in a frame of its own.

mod air;
mod ball;
mod character;
mod collider;
mod lift;
mod mover;
mod patch;
mod rays;
mod triangle;
mod tuning;
mod vehicle;
mod walk;
mod world;

pub use ball::{Ball, BallTuning, Touch, meets_capsule};
pub use character::{Character, CharacterInput};
pub use collider::TerrainCollider;
pub use rays::RayHit;
pub use tuning::CharacterTuning;
pub use vehicle::{
    Vehicle, VehicleInput, VehicleMotion, VehiclePhysics, VehicleTuning, VehicleWheel,
};
pub use world::{Obstacle, PhysicsWorld};
