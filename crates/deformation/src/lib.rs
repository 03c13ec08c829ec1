//! Deformed space: boxes inside of which space is longer or shorter than it looks from outside, and what goes through them.
//!
//! The scene is Euclidean and in metres. An [`Aberration`] is a box in it, with stretches s along its own axes: one metre of
//! scene along axis i feels like s_i metres inside. With R the box's turn, K = R diag(1/s) R^T takes felt displacements to
//! those of the scene, so that a traveller of felt direction w, |w| = 1, moves at v = K w. The felt direction does not change
//! at a face, and v is never normalised: the parameter along a path is then felt length, in metres for rays and, times the
//! speed, in seconds for bodies. `docs/deformation.md` of the project has the derivation and its limits.
//!
//! A [`Portal`] is a polygon through which one sees and goes out of another, turned and scaled as the pair says.
//!
//! [`trace`] alone moves anything: rays of light, walkers, cameras, what is thrown, and picks. Which boxes a traveller is in
//! is kept in a [`Stack`] and never asked of its place again. Everything is `f64`; `shaders/rays/trace.wgsl` mirrors
//! `event.rs`, `face.rs`, `next.rs`, `portal.rs` and `trace.rs` in `f32`. There is no input, no output and no GPU here.

mod aberration;
mod air;
mod bvh;
mod chain;
mod column;
mod cut;
mod error;
mod event;
mod eye;
mod face;
mod gravity;
mod lamp;
mod legacy;
mod next;
mod overlap;
mod place;
mod portal;
mod portal_check;
mod scene;
mod solids;
mod space;
mod stack;
mod sun;
mod trace;
mod triangle;
mod triangles;
mod tuning;
mod walk;
mod walker;

pub use aberration::{Aberration, Exit, Sides, Ways, stretch_of_legacy};
pub use bvh::{Bvh, BvhNode};
pub use chain::{Chain, Leg};
pub use cut::{half, show_cut};
pub use error::SpaceError;
pub use event::{crossing_in, crossing_out};
pub use eye::EyeHeight;
pub use gravity::{Flyer, felt_gravity};
pub use lamp::{LampPath, lamp_paths};
pub use legacy::PictureCorners;
pub use place::{Passage, Place};
pub use portal::{MAX_CORNERS, MAX_PORTALS, PlacedPortal, Portal};
pub use scene::{SceneHit, SceneQuery, Void};
pub use solids::{Form, Solids, Standing};
pub use space::{MAX_ABERRATIONS, MAX_DEPTH, Placed, Space, Traveller};
pub use stack::Stack;
pub use sun::{sun_is_seen, sun_ways};
pub use trace::{End, Event, EventKind, Hit, MAX_EVENTS, Trace, What, felt_normal, trace};
pub use triangles::{Triangle, Triangles};
pub use walker::{Walker, WalkerShape};
