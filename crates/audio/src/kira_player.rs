//! Plays with kira: a track for each group, and the beds as loops that never stop.

use std::collections::HashMap;
use std::sync::Arc;
use std::time::Duration;

use kira::backend::Backend;
use kira::sound::static_sound::{StaticSoundData, StaticSoundHandle, StaticSoundSettings};
use kira::track::{TrackBuilder, TrackHandle};
use kira::{AudioManager, AudioManagerSettings, Decibels, Frame, Tween};

use crate::bank::Sample;
use crate::device::{Device, Health};
use crate::player::{Bed, Player, Voice};
use crate::volumes::Group;

/// How long volumes and beds take to change: long enough for no step to be heard in them.
const GLIDE: Duration = Duration::from_millis(250);

/// A player over any backend of kira's.
pub(crate) struct KiraPlayer<B: Backend> {
    manager: AudioManager<B>,
    /// In the order of [`Group::ALL`].
    tracks: Vec<TrackHandle>,
    /// In the order of [`Bed::ALL`].
    beds: Vec<StaticSoundHandle>,
    sounds: HashMap<Sample, StaticSoundData>,
    health: Arc<Health>,
}

/// Opens the system's sound device.
pub(crate) fn open_device() -> Result<Box<dyn Player>, String> {
    let health = Arc::new(Health::default());
    let player = KiraPlayer::<Device>::new(Arc::clone(&health), health)?;
    Ok(Box::new(player))
}

impl<B: Backend<Error: ToString>> KiraPlayer<B> {
    /// Starts playing on a backend; `health` tells later whether it is still of use.
    fn new(settings: B::Settings, health: Arc<Health>) -> Result<Self, String> {
        let manager = AudioManager::<B>::new(AudioManagerSettings {
            backend_settings: settings,
            capacities: kira::Capacities::default(),
            main_track_builder: kira::track::MainTrackBuilder::new().volume(Decibels::SILENCE),
            internal_buffer_size: 128,
        });
        let mut manager = manager.map_err(|error| error.to_string())?;
        let mut tracks = Vec::new();
        for _ in Group::ALL {
            let track = manager.add_sub_track(TrackBuilder::new());
            tracks.push(track.map_err(|error| error.to_string())?);
        }
        let mut sounds = HashMap::new();
        for sample in Sample::all() {
            let sound =
                sound(sample).map_err(|error| format!("{} is damaged: {error}", sample.name()))?;
            sounds.insert(sample, sound);
        }
        let mut beds = Vec::new();
        for bed in Bed::ALL {
            let sound = bed.sound();
            // The table is read by the build, which sees to a loop having one file.
            let looped = sounds[&sound.samples()[0]]
                .loop_region(0.0..)
                .volume(Decibels::SILENCE);
            let handle = tracks[sound.group() as usize].play(looped);
            beds.push(handle.map_err(|error| error.to_string())?);
        }
        Ok(Self {
            manager,
            tracks,
            beds,
            sounds,
            health,
        })
    }
}

impl<B: Backend> Player for KiraPlayer<B> {
    fn play(&mut self, voice: Voice) {
        let Some(sound) = self.sounds.get(&voice.sample) else {
            return;
        };
        let sound = sound
            .volume(decibels(voice.gain))
            .playback_rate(f64::from(voice.rate));
        // Where a hundred sounds play at once, one more is not missed.
        let _ = self.tracks[voice.group as usize].play(sound);
    }

    fn set_bed(&mut self, bed: Bed, gain: f32, rate: f32) {
        let handle = &mut self.beds[bed as usize];
        handle.set_volume(decibels(gain), glide());
        handle.set_playback_rate(f64::from(rate), glide());
    }

    fn set_group(&mut self, group: Group, gain: f32) {
        self.tracks[group as usize].set_volume(decibels(gain), glide());
    }

    fn set_master(&mut self, gain: f32) {
        self.manager
            .main_track()
            .set_volume(decibels(gain), glide());
    }

    fn is_lost(&self) -> bool {
        self.health.is_lost()
    }
}

fn sound(sample: Sample) -> Result<StaticSoundData, crate::WavError> {
    let clip = sample.clip()?;
    Ok(StaticSoundData {
        sample_rate: clip.rate_hz,
        frames: clip.samples.into_iter().map(Frame::from_mono).collect(),
        settings: StaticSoundSettings::default(),
        slice: None,
    })
}

fn glide() -> Tween {
    Tween {
        duration: GLIDE,
        ..Tween::default()
    }
}

/// Decibels of an amplitude; at and below a thousandth kira plays nothing.
fn decibels(gain: f32) -> Decibels {
    if gain > 0.001 {
        Decibels(20.0 * gain.log10())
    } else {
        Decibels::SILENCE
    }
}

#[cfg(test)]
mod tests;
