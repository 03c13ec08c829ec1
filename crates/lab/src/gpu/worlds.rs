//! The three worlds that are drawn: the laboratory's fixed scene, with an empty hand and no marks.

use antipode_geometry::Geometry;
use antipode_scene::frame::Frame;

use crate::speed::scenes::made;
use crate::{LabError, SPACES};

/// Width to height of every picture here.
const ASPECT: f64 = 16.0 / 9.0;

/// A world of one of the spaces.
#[derive(Clone, Debug)]
pub struct World {
    /// Its space.
    pub geometry: Geometry,
    /// What a new player sees of it.
    pub frame: Frame,
}

impl World {
    /// The space's name in tables.
    pub fn name(&self) -> &'static str {
        self.geometry.name()
    }
}

/// The worlds of all spaces, with land to that distance in chunks.
///
/// # Errors
/// When a world cannot be opened, or its land is not made in time.
pub fn all(view_distance: u32) -> Result<Vec<World>, LabError> {
    let worlds = SPACES.into_iter().map(|geometry| {
        let frame = made(geometry, ASPECT, view_distance)?.with_view(|view| {
            view.hand = None;
            view.shows_marks = false;
        });
        Ok(World { geometry, frame })
    });
    worlds.collect()
}
