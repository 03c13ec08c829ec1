//! The cover of a world that has just been opened: it stays until the land near the player is drawn, and then lifts.

use std::time::Duration;

use egui::{Color32, Context, LayerId};

use super::game::Game;
use super::phase::Phase;

/// How long it takes to lift, seconds.
const LIFTS_S: f64 = 0.4;
/// Longest time that counts in one frame, seconds: the first ones are slow.
const LONGEST_S: f64 = 0.05;
const DARK: Color32 = Color32::from_rgb(0x0B, 0x0E, 0x20);

/// How much of the world is covered.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) enum Veil {
    /// The land is being made, or waits to be drawn.
    Down,
    /// The last picture had all land that there is.
    Drawn,
    /// So much of it is left, 1 to 0.
    Lifting(f64),
    /// Gone.
    #[default]
    Up,
}

impl Veil {
    /// Lets time pass in the world behind it.
    fn lift(self, passed: Duration, at_once: bool) -> Self {
        let left = match self {
            _ if at_once => return Self::Up,
            Self::Down | Self::Drawn => 1.0,
            Self::Lifting(left) => left,
            Self::Up => return Self::Up,
        };
        let left = left - passed.as_secs_f64().min(LONGEST_S) / LIFTS_S;
        if left > 0.0 {
            Self::Lifting(left)
        } else {
            Self::Up
        }
    }
}

impl Game {
    /// A picture of what the game is doing was drawn; `whole`: no land that has been made is missing in it.
    pub fn drawn(&mut self, whole: bool) {
        let is_made = |phase: &Phase| match phase {
            Phase::Loading(session) => session.scene.loading_progress() >= 1.0,
            _ => false,
        };
        if whole && self.veil == Veil::Down && is_made(&self.phase) {
            self.veil = Veil::Drawn;
        }
    }

    /// Lifts the veil of a world that is there; what comes after one that was left has none.
    pub(super) fn lift_veil(&mut self, passed: Duration) {
        let at_once = match self.phase {
            Phase::Playing(_) | Phase::Paused(_) if self.veil != Veil::Down => {
                self.config.settings.reduced_motion
            }
            Phase::Menu | Phase::Over => true,
            _ => return,
        };
        self.veil = self.veil.lift(passed, at_once);
    }

    /// Paints what is left of it over the world and under the display.
    pub(super) fn show_veil(&self, context: &Context) {
        if let Veil::Lifting(left) = self.veil {
            let painter = context.layer_painter(LayerId::background());
            let colour = DARK.gamma_multiply(left as f32);
            painter.rect_filled(context.content_rect(), 0, colour);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_lifts_bit_by_bit_however_slow_the_frames_or_at_once() {
        let mut veil = Veil::Drawn;
        let mut frames = 0;
        while veil != Veil::Up {
            let after = veil.lift(Duration::from_secs(1), false);
            assert_ne!(after, veil);
            veil = after;
            frames += 1;
        }
        assert_eq!(frames, (LIFTS_S / LONGEST_S).round() as u32);
        assert_eq!(Veil::Drawn.lift(Duration::ZERO, true), Veil::Up);
        assert_eq!(Veil::Up.lift(Duration::from_secs(1), false), Veil::Up);
    }
}
