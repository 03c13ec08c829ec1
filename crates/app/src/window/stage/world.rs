//! Reports on the picture of the world in a frame of the window.

use antipode_render::{DrawStats, Picture};
use antipode_scene::frame::Quality;

use crate::drawn::Drawn;

/// What is known of the last picture of the world.
#[derive(Debug, Default)]
pub struct Pictured {
    drawn: Option<Drawn>,
    gpu_ms: Option<f64>,
}

impl Pictured {
    /// What the last frame of the world was drawn with, and the adapter's own time in milliseconds.
    pub fn told(&self) -> Option<(Drawn, Option<f64>)> {
        self.drawn.map(|drawn| (drawn, self.gpu_ms))
    }

    /// Another adapter draws from now on.
    pub fn forget_times(&mut self) {
        self.gpu_ms = None;
    }

    /// Notes what a frame of that quality was drawn with. Returns whether there is a picture of the world: none before what
    /// it is drawn with is made.
    pub fn note(&mut self, stats: &DrawStats, quality: Quality) -> bool {
        // The time of a frame comes some frames later; until then the last one stands.
        self.gpu_ms = stats.gpu_ms.map(f64::from).or(self.gpu_ms);
        if stats.picture == Picture::New {
            self.drawn = Some(Drawn::new(stats, quality));
        }
        stats.picture != Picture::None
    }
}
