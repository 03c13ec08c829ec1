//! What an editor of rooms asks of a room: a free camera, what a pixel shows, where a place is seen, and what a drag of the
//! pointer means in the room. All of it goes by the paths that light takes, through aberrations and portals, and changes
//! nothing.
//!
//! Places of a picture are from -1 at its left and its bottom to 1, as in [`Eye::direction`](antipode_rays::Eye::direction).

mod camera;
mod drag;
mod handles;
mod sight;
mod snap;
mod through;

pub use camera::{Facing, FreeCamera};
pub use drag::{Change, Drag};
pub use handles::{Handle, HandleLine, Handles, Held, Tool};
pub use sight::{Sight, Viewpoint};
pub use snap::Snap;
pub use through::Through;
