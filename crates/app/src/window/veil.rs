//! The cover of a world that has just been opened: it stays until the land near the player is drawn, and then lifts.

use std::time::Duration;

use egui::{Color32, Context, LayerId};

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
    pub fn lift(self, passed: Duration, at_once: bool) -> Self {
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

    /// Paints what is left of it over the world and under the display.
    pub fn show(self, context: &Context) {
        if let Self::Lifting(left) = self {
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
