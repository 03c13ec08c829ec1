//! Players of sounds, and one that only records them.

use crate::bank::{Sample, Sound};
use crate::volumes::Group;

/// How many beds there are.
pub const BEDS: usize = 5;

/// A sound to be played once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Voice {
    /// What.
    pub sample: Sample,
    /// Whose volume it goes by.
    pub group: Group,
    /// Amplitude, 0 to 1.
    pub gain: f32,
    /// How fast it is played: 2 is an octave higher.
    pub rate: f32,
}

/// A sound that goes on and on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Bed {
    /// Wind.
    Wind,
    /// Birds and leaves.
    Day,
    /// Crickets.
    Night,
    /// The engine of the car that is driven.
    Engine,
    /// Its tyres, sliding.
    Tyres,
}

impl Bed {
    /// Every bed.
    pub const ALL: [Self; BEDS] = [
        Self::Wind,
        Self::Day,
        Self::Night,
        Self::Engine,
        Self::Tyres,
    ];

    /// What is heard.
    pub fn sound(self) -> Sound {
        match self {
            Self::Wind => Sound::Wind,
            Self::Day => Sound::Day,
            Self::Night => Sound::Night,
            Self::Engine => Sound::Engine,
            Self::Tyres => Sound::Tyres,
        }
    }
}

/// Makes sounds audible. Nothing here fails: what cannot be played is left out.
pub trait Player {
    /// Plays a sound once.
    fn play(&mut self, voice: Voice);

    /// Lets a bed glide to an amplitude, 0 to 1, and a rate.
    fn set_bed(&mut self, bed: Bed, gain: f32, rate: f32);

    /// Sets the amplitude of a group, 0 to 1.
    fn set_group(&mut self, group: Group, gain: f32);

    /// Sets the amplitude of everything together, 0 to 1.
    fn set_master(&mut self, gain: f32);

    /// Whether it will never be heard again and another is to take its place.
    fn is_lost(&self) -> bool {
        false
    }
}

/// Writes down what it is given instead of playing it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Recorder {
    /// Every sound, in order.
    pub voices: Vec<Voice>,
    /// The last amplitude and rate of each bed, in the order of [`Bed::ALL`].
    pub beds: [(f32, f32); BEDS],
    /// The last amplitude of each group, in the order of [`Group::ALL`].
    pub groups: [f32; 4],
    /// The last amplitude of everything.
    pub master: f32,
}

impl Player for Recorder {
    fn play(&mut self, voice: Voice) {
        self.voices.push(voice);
    }

    fn set_bed(&mut self, bed: Bed, gain: f32, rate: f32) {
        self.beds[bed as usize] = (gain, rate);
    }

    fn set_group(&mut self, group: Group, gain: f32) {
        self.groups[group as usize] = gain;
    }

    fn set_master(&mut self, gain: f32) {
        self.master = gain;
    }
}
