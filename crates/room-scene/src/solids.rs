//! What one meets in a room, as it is known to whoever looks at rooms.

pub use antipode_rooms::solids::{standing, triangles};
