//! What the game sounds like.
//!
//! The scene tells what happened ([`antipode_scene::SoundEvent`]) and what surrounds the player; the
//! [`director::Director`] decides from it what is to be heard, the same for the same events; a [`Player`] makes it
//! audible. Players are the sound device, behind the feature `device`, and a [`Recorder`] for tests. All of it runs
//! on a thread of its own, which [`Audio`] speaks to and never waits for.

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
pub use studio::{Cue, Heard, Place, Status};
pub use volumes::{Group, Volumes};
pub use wav::{Clip, WavError};
