//! Plays the sounds of the game.
//!
//! The scene reports what happened ([`antipode_scene::SoundEvent`]) and what surrounds the player. The
//! [`director::Director`] chooses the sounds; it chooses the same ones for the same events. A [`Player`] plays them:
//! either the sound device (feature `device`) or a [`Recorder`] for tests. All of this runs on a thread of its own.
//! The game sends messages to it through [`Audio`] and never waits for it.

mod audio;
mod bank;
#[cfg(feature = "device")]
mod device;
pub mod director;
#[cfg(feature = "device")]
mod kira_player;
mod music;
mod player;
mod studio;
mod volumes;
mod wav;

pub use audio::Audio;
pub use bank::{Sample, Sound};
pub use player::{Bed, Player, Recorder, Voice};
pub use studio::{Cue, Heard, PlayState, Status};
pub use volumes::{Group, Volumes};
pub use wav::{Clip, WavError};
