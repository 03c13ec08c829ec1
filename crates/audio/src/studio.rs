//! Runs on the sound thread: takes messages, keeps a player working, and reports its state.

use std::fmt;

use antipode_scene::{SoundEvent, Surroundings};

use crate::director::Director;
use crate::player::{Player, Recorder};
use crate::volumes::Volumes;

/// Time between two attempts to open a device, in seconds.
const RETRY_S: f64 = 3.0;

/// What is played: nothing, or a world that stands still or goes on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PlayState {
    /// In a menu without a world, or before a world that is being loaded.
    #[default]
    Menu,
    /// In a world that stands still.
    Paused,
    /// In a world.
    World,
}

/// What there was to hear in a frame.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Heard {
    /// What is played: nothing, or a world that stands still or goes on.
    pub play_state: PlayState,
    /// What surrounds the player; none without a world.
    pub surroundings: Option<Surroundings>,
    /// What happened.
    pub events: Vec<SoundEvent>,
}

/// A sound of the interface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cue {
    /// The focus moved, or a slider.
    Moved,
    /// A button was pressed.
    Pressed,
}

/// How it goes with the sound.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Status {
    /// A device is being opened.
    #[default]
    Opening,
    /// It can be heard.
    Playing,
    /// There is no device. One that comes later is taken.
    NoDevice(String),
    /// The device went away. One that comes later is taken.
    Lost,
    /// This program was built without sound.
    LeftOut,
}

impl fmt::Display for Status {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Opening => f.write_str("The sound device is being opened."),
            Self::Playing => f.write_str("Sound is on."),
            Self::NoDevice(why) => write!(
                f,
                "No sound can be played: {why}. The game goes on without."
            ),
            Self::Lost => f.write_str(
                "The sound device has gone. The game goes on without and waits for one.",
            ),
            Self::LeftOut => f.write_str("This game was built without sound."),
        }
    }
}

/// What the game tells the sound thread.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Message {
    Heard(Heard),
    Cue(Cue),
    Volumes(Volumes),
    Muted(bool),
}

/// What opens a device.
pub(crate) type Open = Box<dyn FnMut() -> Result<Box<dyn Player>, String>>;

/// Director and player together.
pub(crate) struct Studio {
    open: Open,
    player: Option<Box<dyn Player>>,
    director: Director,
    status: Status,
    retry_in_s: f64,
}

impl Studio {
    /// A studio that opens its device when time first passes.
    pub fn new(open: Open, volumes: Volumes) -> Self {
        Self {
            open,
            player: None,
            director: Director::new(volumes),
            status: Status::Opening,
            retry_in_s: 0.0,
        }
    }

    /// How the device is, as it was last found.
    pub fn status(&self) -> &Status {
        &self.status
    }

    /// Follows a message. One that is `late`, because a device was being opened, is remembered for what lasts, and
    /// what happened is not heard any more.
    pub fn take(&mut self, message: Message, late: bool) {
        let mut nobody = Recorder::default();
        let player: &mut dyn Player = match &mut self.player {
            Some(player) => player.as_mut(),
            None => &mut nobody,
        };
        match message {
            Message::Heard(mut heard) => {
                if late {
                    heard.events.clear();
                }
                self.director.hear(&heard, player);
            }
            Message::Cue(_) if late => {}
            Message::Cue(cue) => self.director.cue(cue, player),
            Message::Volumes(volumes) => self.director.set_volumes(volumes, player),
            Message::Muted(muted) => self.director.set_muted(muted, player),
        }
    }

    /// Lets time pass, in seconds. Returns whether it tried to open a device, which may take long.
    pub fn advance(&mut self, dt_s: f64) -> bool {
        if self.player.as_ref().is_some_and(|player| player.is_lost()) {
            tracing::info!("the sound device has gone");
            self.player = None;
            self.status = Status::Lost;
            self.retry_in_s = 0.0;
        }
        if let Some(player) = &mut self.player {
            self.director.advance(dt_s, player.as_mut());
            return false;
        }
        self.retry_in_s -= dt_s;
        if self.retry_in_s > 0.0 {
            return false;
        }
        self.try_to_open();
        true
    }

    fn try_to_open(&mut self) {
        match (self.open)() {
            Ok(mut player) => {
                self.director.brief(player.as_mut());
                self.player = Some(player);
                self.status = Status::Playing;
                tracing::info!("sound is on");
            }
            Err(why) => {
                self.retry_in_s = RETRY_S;
                // Said once: later attempts fail in the same way, and a device that went may come back.
                if self.status == Status::Opening {
                    self.status = Status::NoDevice(why);
                    tracing::warn!("{}", self.status);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests;
