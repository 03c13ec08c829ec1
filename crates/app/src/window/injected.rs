//! Faults that a test injects on purpose, to see how the game copes.

use std::time::{Duration, Instant};

use antipode_render::Shaders;
use clap::ValueEnum;

use super::stage::Stage;

/// Frames of a world before a fault that is asked for.
const FRAMES_TO_FAULT: u64 = 120;
/// How long a machine sleeps that is asked to.
const SLEEP: Duration = Duration::from_hours(7);

/// What can be broken on purpose while the game runs in its window: two seconds of frames after a world is there, or
/// from the start.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Fault {
    /// A panic of the main thread.
    Panic,
    /// The adapter is lost, and can be opened again.
    LostDevice,
    /// The adapter is lost, and no other can be opened.
    DeadDevice,
    /// The window's surface is lost.
    LostSurface,
    /// The adapter refuses a shader.
    BrokenShader,
    /// The machine sleeps for some hours.
    Suspend,
    /// The window comes to a monitor with twice the pixels.
    Rescale,
}

/// A fault that is asked for, and what it needs to come about.
#[derive(Debug)]
pub struct Injected {
    fault: Option<Fault>,
    frames: u64,
    /// How far the clock is ahead of the real one.
    ahead: Duration,
}

impl Injected {
    /// That fault, or none.
    pub fn new(fault: Option<Fault>) -> Self {
        Self {
            fault,
            frames: 0,
            ahead: Duration::ZERO,
        }
    }

    /// The shaders to draw with.
    pub fn shaders(&self) -> Shaders {
        match self.fault {
            Some(Fault::BrokenShader) => Shaders::with("terrain", "fn vertex( { nothing }"),
            _ => Shaders::default(),
        }
    }

    /// Whether a lost adapter can be opened again.
    pub fn can_recover(&self) -> bool {
        self.fault != Some(Fault::DeadDevice)
    }

    /// What time it is in the game.
    pub fn now(&self) -> Instant {
        Instant::now() + self.ahead
    }

    /// A frame is about to be drawn, of a world or not; what is asked for happens once.
    pub fn frame(&mut self, of_world: bool, stage: &mut Stage) {
        let Some(fault) = self.fault.filter(|_| of_world) else {
            return;
        };
        self.frames += 1;
        if self.frames != FRAMES_TO_FAULT {
            return;
        }
        tracing::warn!("a fault was asked for: {fault:?}");
        match fault {
            Fault::Panic => break_on_purpose(),
            Fault::LostDevice | Fault::DeadDevice => stage.lose_adapter(),
            Fault::LostSurface => stage.lose_surface(),
            Fault::Suspend => self.ahead = SLEEP,
            Fault::Rescale => stage.rescale(2.0),
            Fault::BrokenShader => {}
        }
    }
}

#[allow(clippy::panic, reason = "somebody has asked for it")]
fn break_on_purpose() {
    std::panic::panic_any("the fault that was asked for");
}
