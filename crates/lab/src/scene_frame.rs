//! A frame that holds nothing but an eye in a space: for what is decided before anything is drawn.

use std::sync::Arc;

use antipode_geometry::{Eye, Strategy};
use antipode_scene::frame::{Content, Frame, Quality, Sky, View};
use glam::{DMat4, DVec4};

use crate::accuracy::projection;

/// The frame at *balanced*, without land, light and fog.
pub fn bare(strategy: Arc<dyn Strategy>, eye: &Eye) -> Frame {
    let (dark, up) = ([0.0; 3], [0.0, 1.0, 0.0]);
    Frame {
        view: View {
            eye: *eye,
            projection: projection(),
            strategy,
            hand: None,
            fog_distance_m: 1e5,
            shows_marks: true,
            contour_bands: false,
            quality: Quality::Balanced,
            isometry: DMat4::IDENTITY,
            cuts: [DVec4::ZERO; View::CUTS],
        },
        mirror: None,
        content: Arc::new(Content {
            sky: Sky {
                top: dark,
                horizon: dark,
                glare: dark,
                stars: 0.0,
                sun_direction: up,
                moon_direction: up,
                key_direction: up,
                key_shadow: 1.0,
                key_colour: dark,
                ambient_sky: dark,
                ambient_ground: dark,
                moon_colour: dark,
                dome: false,
                clouds: 0.0,
                drift: 0.0,
                orbs: None,
            },
            land: Arc::default(),
            figures: Vec::new(),
            lights: antipode_scene::frame::Lights::default(),
            marker: None,
            hit_shapes: Vec::new(),
            time_s: 0.0,
            loaded_world: 1,
        }),
    }
}
