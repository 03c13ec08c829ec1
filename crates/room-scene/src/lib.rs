//! A room that runs. A [`RoomScene`] is made of a [`Loaded`](antipode_rooms::Loaded) room: its aberrations as a space, its
//! solids as triangles, who walks in it and looks, and the [`RayScene`](antipode_rays::RayScene) that pictures are drawn of.
//! It goes on in steps of [`tuning::STEP_S`], so that the same steps lead to the same place, and it is changed by the words of
//! a [`Document`](antipode_workshop::Document). What one does in a room changes nothing in its file.
//!
//! There is no window, no file and no adapter here.

mod bodies;
mod camera;
mod difference;
mod figure;
mod handling;
mod hands;
mod held;
mod hints;
mod light;
mod looks;
mod moment;
mod pick;
mod picture;
mod probe;
mod probe_loose;
mod righting;
mod scene;
mod solids;
mod sounds;
mod things;
pub mod tuning;
mod walk;
pub mod workshop;

pub use difference::{Difference, Lying};
pub use figure::RoomFigure;
pub use held::{InHand, RoomViewing};
pub use hints::RoomHint;
pub use moment::{Moment, Turn};
pub use pick::{Pick, PickEvent};
pub use picture::SignBoard;
pub use probe::{CameraProbe, ObjectProbe, PlayerProbe, RoomProbe, Sizes};
pub use probe_loose::LooseState;
pub use scene::{NoSuchPlace, RoomScene};
pub use solids::Remade;
pub use sounds::RoomSound;
pub use things::{Struck, Thing, ThingKind};
pub use walk::Steer;
