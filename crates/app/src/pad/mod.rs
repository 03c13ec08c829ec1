//! Gamepads: where their events come from, and what the sticks say.

#[cfg(feature = "gamepad")]
mod gilrs_source;
mod sticks;

use antipode_settings::PadButton;

pub use sticks::{Direction, Feel, Sticks};

/// Something that a gamepad did.
#[derive(Clone, Debug, PartialEq)]
pub enum PadEvent {
    /// It can be used from now on.
    Connected {
        /// What it calls itself.
        name: String,
    },
    /// It has gone.
    Disconnected {
        /// What it called itself.
        name: String,
    },
    /// A button went down or up.
    Button {
        /// Which.
        button: PadButton,
        /// Whether it went down.
        pressed: bool,
    },
    /// A stick moved.
    Stick {
        /// Along which axis.
        axis: Axis,
        /// Where it stands now, -1 to 1, right and away from the player positive.
        value: f32,
    },
}

/// An axis of a stick.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Axis {
    /// Left stick, left to right.
    LeftX,
    /// Left stick, towards the player to away.
    LeftY,
    /// Right stick, left to right.
    RightX,
    /// Right stick, towards the player to away.
    RightY,
}

/// Where events of gamepads come from.
pub trait PadSource {
    /// The next event, if there is one by now.
    fn next(&mut self) -> Option<PadEvent>;
}

/// No gamepads.
impl PadSource for () {
    fn next(&mut self) -> Option<PadEvent> {
        None
    }
}

/// The gamepads of this machine; none where they cannot be read or were left out of this program.
pub fn system() -> Box<dyn PadSource> {
    #[cfg(feature = "gamepad")]
    match gilrs_source::GilrsSource::open() {
        Ok(source) => return Box::new(source),
        Err(why) => tracing::info!("no gamepads: {why}"),
    }
    Box::new(())
}
