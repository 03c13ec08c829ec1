//! Recovers from a lost surface or a lost adapter: everything on it is made anew, and the game goes on.

use std::collections::VecDeque;
use std::sync::Arc;
use std::time::{Duration, Instant};

use antipode_render::{RenderError, Shaders};

use super::Stage;
use super::canvas::Canvas;
use super::rooms::Rooms;
use crate::failure::Failure;

/// Most times that an adapter is opened anew within [`WITHIN`]: one that is lost more often is broken.
const MOST: usize = 4;
const WITHIN: Duration = Duration::from_mins(1);

/// When the adapter was opened anew of late.
#[derive(Debug, Default)]
pub struct Recoveries {
    at: VecDeque<Instant>,
}

impl Recoveries {
    /// Whether it is worth opening once more.
    fn is_worth_one(&mut self, now: Instant) -> bool {
        self.at
            .retain(|at| now.saturating_duration_since(*at) < WITHIN);
        self.at.push_back(now);
        self.at.len() <= MOST
    }
}

impl Stage {
    /// Why the adapter was lost, if it was.
    pub fn lost(&self) -> Option<String> {
        self.gpu.lost()
    }

    /// Opens an adapter anew after the last one was lost, and puts the interface's textures on it. The
    /// land comes with the next frame, whole.
    ///
    /// # Errors
    /// When none can be opened, or it has been lost too often.
    pub fn recover(&mut self, why: &str) -> Result<(), Failure> {
        for reading in self.screenshots.iter().chain(&self.tile) {
            reading.give_up();
        }
        self.thumbnail = None;
        if !self.recoveries.is_worth_one(Instant::now()) {
            return Err(RenderError::Lost(why.to_owned()).into());
        }
        // A window has one surface at a time.
        self.surface = None;
        let Canvas {
            gpu,
            surface,
            config,
            mut renderer,
            options,
        } = Canvas::open(
            &self.window,
            self.display.clone(),
            self.choice,
            Shaders::default(),
        )?;
        renderer.complete_next();
        self.overlay.move_to(&gpu, config.format);
        self.input
            .set_max_texture_side(gpu.device.limits().max_texture_dimension_2d as usize);
        self.surface = Some(surface);
        self.renderer = renderer;
        self.rooms = Rooms::default();
        self.gpu = gpu;
        self.config = config;
        self.options = options;
        self.pictured.forget_times();
        Ok(())
    }

    /// Makes the surface anew; without one nothing is drawn, and the next frame tries again.
    pub(super) fn remake_surface(&mut self) {
        tracing::warn!("the window's surface was lost and is made anew");
        self.surface = None;
        match self.gpu.instance.create_surface(Arc::clone(&self.window)) {
            Ok(surface) => self.surface = Some(surface),
            Err(error) => tracing::error!("the window gives no surface: {error}"),
        }
        self.configure();
    }

    /// Loses the adapter on purpose.
    pub fn lose_adapter(&self) {
        self.gpu.lose();
    }

    /// Loses the surface on purpose.
    pub fn lose_surface(&mut self) {
        self.loses_surface = true;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_adapter_is_opened_anew_some_times_a_minute_and_then_again_later() {
        let mut recoveries = Recoveries::default();
        let start = Instant::now();
        let at = |s| start + Duration::from_secs(s);
        assert!((0..4).all(|s| recoveries.is_worth_one(at(s))));
        assert!(!recoveries.is_worth_one(at(5)));
        assert!(recoveries.is_worth_one(at(200)));
    }
}
