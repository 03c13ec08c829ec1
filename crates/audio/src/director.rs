//! Decides what is to be heard: voices for events, levels of the beds, and when the music plays.
//!
//! Nothing here is random or asks for the time: the same events and the same passing of time are heard the same.

use antipode_scene::sound::Drive;
use antipode_scene::{SoundEvent, Surroundings};
use antipode_terrain::Cover;

use crate::bank::Sample;
use crate::music::Music;
use crate::player::{BEDS, Bed, Player, Voice};
use crate::studio::{Cue, Heard, PlayState};
use crate::volumes::{Group, Volumes};

/// Loudest step, in amplitude, and the speed in m/s at which it is reached.
const STEP: (f32, f64) = (0.55, 8.0);
/// Fall, in m/s, that is heard as loud as can be, and the one from which it sounds hard.
const LANDING_M_S: (f64, f64) = (16.0, 9.0);
/// Wind on the lowest ground, and what height and speed add to it at most.
const WIND: (f32, f32, f32) = (0.06, 0.30, 0.55);
/// Speeds in m/s at which one's own motion is first heard as wind, and is as loud as can be.
const WIND_SPEED_M_S: (f64, f64) = (6.0, 40.0);
const BED_GAIN: f32 = 0.2;
/// An idle engine, and what the pedal and speed add to it at most, in amplitude.
const ENGINE: (f32, f32, f32) = (0.14, 0.16, 0.12);
/// How fast the engine's loop is played at rest and at the speed in m/s at which it is highest.
const ENGINE_RATE: (f32, f32) = (0.7, 2.1);
const ENGINE_TOP_M_S: f64 = 30.0;
/// The loudest tyres, and the speeds over the ground in m/s from which and at which they slide so.
const TYRES: f32 = 0.35;
const SLIDE_M_S: (f64, f64) = (1.5, 9.0);
/// What is left of the beds behind the pause menu.
const PAUSED_SHARE: f32 = 0.35;
/// Beds that changed by less are left as they are.
const AUDIBLE_CHANGE: f32 = 0.01;

/// Turns what the game tells into what a player plays.
#[derive(Debug)]
pub struct Director {
    play_state: PlayState,
    surroundings: Surroundings,
    volumes: Volumes,
    muted: bool,
    /// What the player was last told of each bed.
    beds: [(f32, f32); BEDS],
    music: Music,
    /// Sounds so far, to take variants in turn.
    count: u32,
}

impl Director {
    /// A director for the main menu.
    pub fn new(volumes: Volumes) -> Self {
        Self {
            play_state: PlayState::Menu,
            surroundings: Surroundings::default(),
            volumes,
            muted: false,
            beds: [(0.0, 1.0); BEDS],
            music: Music::default(),
            count: 0,
        }
    }

    /// Tells a player who has just come all that lasts.
    pub fn brief(&mut self, player: &mut dyn Player) {
        for group in Group::ALL {
            player.set_group(group, self.volumes.gain(group));
        }
        player.set_master(self.master());
        for (bed, (gain, rate)) in Bed::ALL.into_iter().zip(self.beds) {
            player.set_bed(bed, gain, rate);
        }
    }

    /// Sets the volumes.
    pub fn set_volumes(&mut self, volumes: Volumes, player: &mut dyn Player) {
        self.volumes = volumes;
        self.brief(player);
    }

    /// Makes everything silent, or audible again.
    pub fn set_muted(&mut self, muted: bool, player: &mut dyn Player) {
        self.muted = muted;
        player.set_master(self.master());
    }

    /// Takes in what the scene told in a frame.
    pub fn hear(&mut self, heard: &Heard, player: &mut dyn Player) {
        self.play_state = heard.play_state;
        if let Some(surroundings) = heard.surroundings {
            self.surroundings = surroundings;
        }
        for event in &heard.events {
            let voice = self.voice(event);
            player.play(voice);
        }
        self.lay_beds(player);
    }

    /// Plays a sound of the interface.
    pub fn cue(&mut self, cue: Cue, player: &mut dyn Player) {
        let (sample, gain) = match cue {
            Cue::Moved => (Sample::Tick, 0.35),
            Cue::Pressed => (Sample::Press, 0.5),
        };
        player.play(interface(sample, gain));
    }

    /// Lets time pass, in seconds.
    pub fn advance(&mut self, dt_s: f64, player: &mut dyn Player) {
        let night = self.play_state != PlayState::Menu && self.surroundings.day < 0.5;
        self.music.advance(dt_s, night, |voice| player.play(voice));
    }

    fn master(&self) -> f32 {
        if self.muted {
            0.0
        } else {
            self.volumes.master_gain()
        }
    }

    fn voice(&mut self, event: &SoundEvent) -> Voice {
        self.count = self.count.wrapping_add(1);
        let effect = |sample, gain, rate| Voice {
            sample,
            group: Group::Effects,
            gain,
            rate,
        };
        match *event {
            SoundEvent::Step { cover, speed_m_s } => {
                let (loudest, at_m_s) = STEP;
                let gain = loudest * (0.4 + 0.6 * share(speed_m_s, 0.0, at_m_s));
                effect(self.pick(&Sample::steps(cover)), gain, self.waver())
            }
            SoundEvent::Landed { cover, speed_m_s } => {
                let (loudest_m_s, hard_m_s) = LANDING_M_S;
                let sample = if speed_m_s < hard_m_s {
                    Sample::LandSoft
                } else {
                    Sample::LandHard
                };
                let gain = 0.25 + 0.65 * share(speed_m_s, 0.0, loudest_m_s);
                effect(sample, gain, pitch(cover))
            }
            SoundEvent::Dug { cover } => {
                let variants = [Sample::Dig1, Sample::Dig2, Sample::Dig3];
                effect(self.pick(&variants), 0.5, pitch(cover) * self.waver())
            }
            SoundEvent::Built => effect(
                self.pick(&[Sample::Build1, Sample::Build2]),
                0.5,
                self.waver(),
            ),
            SoundEvent::SlotChanged => interface(Sample::Slot, 0.4),
            SoundEvent::Shot => effect(Sample::Shot, 0.6, self.waver()),
            SoundEvent::Clicked => effect(Sample::Click, 0.4, 1.0),
            SoundEvent::Struck => effect(Sample::Struck, 0.5, self.waver()),
            SoundEvent::Hurt => effect(Sample::Hurt, 0.6, self.waver()),
            SoundEvent::PutDown(_) => effect(Sample::Lamp, 0.45, 1.0),
            SoundEvent::TakenUp(_) => effect(Sample::Lamp, 0.4, 1.26),
            SoundEvent::CarDoor => effect(Sample::Door, 0.5, self.waver()),
            SoundEvent::Crashed { speed_m_s } => {
                let gain = 0.3 + 0.6 * share(speed_m_s, 0.0, LANDING_M_S.0);
                effect(Sample::LandHard, gain, 1.2 * self.waver())
            }
            SoundEvent::CarHit => effect(Sample::Struck, 0.5, 1.6 * self.waver()),
            SoundEvent::Horn => effect(Sample::Horn, 0.6, 1.0),
            SoundEvent::PickedUp => effect(Sample::PickUp, 0.4, self.waver()),
        }
    }

    /// One variant after the other: the same twice running is heard as a machine.
    fn pick(&self, variants: &[Sample]) -> Sample {
        variants[self.count as usize % variants.len()]
    }

    /// A rate within 6 % of 1 that does not repeat soon: steps of the golden ratio fill an interval evenly.
    fn waver(&self) -> f32 {
        0.94 + 0.12 * (self.count as f32 * 0.618_034).fract()
    }

    fn lay_beds(&mut self, player: &mut dyn Player) {
        let wanted = self.levels();
        for ((bed, told), wanted) in Bed::ALL.into_iter().zip(&mut self.beds).zip(wanted) {
            let changed = (told.0 - wanted.0).abs().max((told.1 - wanted.1).abs());
            let ends = wanted.0 == 0.0 && told.0 != 0.0;
            if changed > AUDIBLE_CHANGE || ends {
                *told = wanted;
                player.set_bed(bed, wanted.0, wanted.1);
            }
        }
    }

    /// Amplitude and rate of each bed.
    fn levels(&self) -> [(f32, f32); BEDS] {
        let present = match self.play_state {
            PlayState::Menu => return [(0.0, 1.0); BEDS],
            PlayState::Paused => PAUSED_SHARE,
            PlayState::World => 1.0,
        };
        let air = &self.surroundings;
        let high = share(air.height_m, 0.0, air.relief_m.max(1.0));
        let (slow_m_s, fast_m_s) = WIND_SPEED_M_S;
        let fast = share(air.speed_m_s, slow_m_s, fast_m_s);
        let (calm, height, speed) = WIND;
        let wind = calm + height * high * high + speed * fast;
        // Two beds that fade over into each other keep their power together when their squares add up to one.
        let day = share(air.day, 0.0, 1.0);
        let below = share(air.height_m, -12.0, -2.0);
        let bed = BED_GAIN * present * below;
        [
            (wind.min(1.0) * present, 0.85 + 0.25 * high + 0.35 * fast),
            (bed * day.sqrt(), 1.0),
            (bed * (1.0 - day).sqrt(), 1.0),
            engine(air.drive, present),
            tyres(air.drive, present),
        ]
    }
}

/// Amplitude and rate of the engine: it runs faster with the wheels, and harder with the pedal.
fn engine(drive: Option<Drive>, present: f32) -> (f32, f32) {
    let Some(drive) = drive else {
        return (0.0, ENGINE_RATE.0);
    };
    let pedal = share(drive.throttle.abs(), 0.0, 1.0);
    let fast = share(drive.speed_m_s.abs(), 0.0, ENGINE_TOP_M_S);
    let (idle, works, runs) = ENGINE;
    let (slow, quick) = ENGINE_RATE;
    let gain = idle + works * pedal + runs * fast;
    (
        gain * present,
        slow + (quick - slow) * (0.9 * fast + 0.1 * pedal),
    )
}

/// Amplitude and rate of tyres that slide.
fn tyres(drive: Option<Drive>, present: f32) -> (f32, f32) {
    let slide_m_s = drive.map_or(0.0, |drive| drive.slide_m_s);
    let (from_m_s, most_m_s) = SLIDE_M_S;
    let slides = share(slide_m_s, from_m_s, most_m_s);
    (TYRES * slides * present, 0.85 + 0.3 * slides)
}

fn interface(sample: Sample, gain: f32) -> Voice {
    Voice {
        sample,
        group: Group::Interface,
        gain,
        rate: 1.0,
    }
}

/// Hard ground sounds higher than soft.
fn pitch(cover: Cover) -> f32 {
    match cover {
        Cover::Rock => 1.15,
        Cover::Gravel => 1.05,
        Cover::Sand => 0.95,
        Cover::Soil => 0.85,
        Cover::Grass => 0.9,
    }
}

/// 0 up to `from`, 1 from `to` on, straight between; 0 for what is no number.
fn share(x: f64, from: f64, to: f64) -> f32 {
    let share = (x - from) / (to - from);
    if share.is_nan() {
        0.0
    } else {
        share.clamp(0.0, 1.0) as f32
    }
}

#[cfg(test)]
mod tests;
