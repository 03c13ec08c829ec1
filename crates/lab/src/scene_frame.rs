//! A frame that holds nothing but an eye in a space: for what is decided before anything is drawn.

use std::sync::Arc;

use antipode_geometry::{Eye, Strategy};
use antipode_scene::frame::{Content, Frame, View};

use crate::accuracy::projection;

/// The frame at *balanced*, without land, light and fog.
pub fn bare(strategy: Arc<dyn Strategy>, eye: &Eye) -> Frame {
    let content = Content {
        loaded_world: 1,
        ..Content::default()
    };
    Frame::new(content, View::new(*eye, projection(), strategy))
}
