//! Decides what is to be heard: voices for events, levels of the beds, and when the music plays.
//!
//! Nothing here is random or asks for the time: the same events and the same passing of time are heard the same.

use antipode_scene::sound::Drive;
use antipode_scene::{SoundEvent, Surroundings};
use antipode_terrain::Cover;

use crate::bank::Sound;
use crate::music::Music;
use crate::player::{BEDS, Bed, Player, Voice};
use crate::studio::{Cue, Heard, PlayState};
use crate::volumes::{Group, Volumes};

/// The speed in m/s at which a step is loudest.
const STEP_M_S: f64 = 8.0;
/// Fall, in m/s, that is heard as loud as can be, and the one from which it sounds hard.
const LANDING_M_S: (f64, f64) = (16.0, 9.0);
/// Wind on the lowest ground, and what height and speed add to it at most.
const WIND: (f32, f32, f32) = (0.06, 0.30, 0.55);
/// Speeds in m/s at which one's own motion is first heard as wind, and is as loud as can be.
const WIND_SPEED_M_S: (f64, f64) = (6.0, 40.0);
/// An idle engine, and what the pedal and speed add to it at most, in amplitude.
const ENGINE: (f32, f32, f32) = (0.14, 0.16, 0.12);
/// How fast the engine's loop is played at rest and at the speed in m/s at which it is highest.
const ENGINE_RATE: (f32, f32) = (0.7, 2.1);
const ENGINE_TOP_M_S: f64 = 30.0;
/// The speeds over the ground in m/s from which tyres are heard to slide, and at which they are loudest.
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
            self.count = self.count.wrapping_add(1);
            let (sound, loud, ground) = told(event);
            player.play(self.voice(sound, loud, ground));
        }
        self.lay_beds(player);
    }

    /// Plays a sound of the interface.
    pub fn cue(&mut self, cue: Cue, player: &mut dyn Player) {
        let sound = match cue {
            Cue::Moved => Sound::Tick,
            Cue::Pressed => Sound::Press,
        };
        player.play(self.voice(sound, 1.0, None));
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

    /// A sound as loud as a share of what it can be, on some ground.
    fn voice(&self, sound: Sound, loud: f32, ground: Option<Cover>) -> Voice {
        // One variant after the other: the same twice running is heard as a machine.
        let variants = sound.samples();
        let ground = ground.filter(|_| sound.is_by_ground());
        let waver = if sound.wavers() { self.waver() } else { 1.0 };
        Voice {
            sample: variants[self.count as usize % variants.len()],
            group: sound.group(),
            gain: sound.gain(loud),
            rate: sound.rate() * ground.map_or(1.0, pitch) * waver,
        }
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
        let levels: [(f32, f32); BEDS] = [
            (wind.min(1.0), 0.85 + 0.25 * high + 0.35 * fast),
            (below * day.sqrt(), 1.0),
            (below * (1.0 - day).sqrt(), 1.0),
            engine(air.drive),
            tyres(air.drive),
        ];
        std::array::from_fn(|place| {
            let (sound, (share, rate)) = (Bed::ALL[place].sound(), levels[place]);
            (sound.gain(share) * present, sound.rate() * rate)
        })
    }
}

/// The sound of an event, how loud it is as a share of what it can be, and on which ground it is heard.
fn told(event: &SoundEvent) -> (Sound, f32, Option<Cover>) {
    let plain = |sound| (sound, 1.0, None);
    match *event {
        SoundEvent::Step { cover, speed_m_s } => (
            Sound::step(cover),
            share(speed_m_s, 0.0, STEP_M_S),
            Some(cover),
        ),
        SoundEvent::Landed { cover, speed_m_s } => {
            let (loudest_m_s, hard_m_s) = LANDING_M_S;
            let sound = if speed_m_s < hard_m_s {
                Sound::LandSoft
            } else {
                Sound::LandHard
            };
            (sound, share(speed_m_s, 0.0, loudest_m_s), Some(cover))
        }
        SoundEvent::Crashed { speed_m_s } => {
            (Sound::Crash, share(speed_m_s, 0.0, LANDING_M_S.0), None)
        }
        SoundEvent::Dug { cover } => (Sound::Dig, 1.0, Some(cover)),
        SoundEvent::Built => plain(Sound::Build),
        SoundEvent::SlotChanged => plain(Sound::Slot),
        SoundEvent::Shot => plain(Sound::Shot),
        SoundEvent::Clicked => plain(Sound::Click),
        SoundEvent::Struck => plain(Sound::Struck),
        SoundEvent::Hurt => plain(Sound::Hurt),
        SoundEvent::PutDown(_) => plain(Sound::PutDown),
        SoundEvent::TakenUp(_) => plain(Sound::TakenUp),
        SoundEvent::PickedUp => plain(Sound::PickUp),
        SoundEvent::CarDoor => plain(Sound::Door),
        SoundEvent::CarHit => plain(Sound::CarHit),
        SoundEvent::Horn => plain(Sound::Horn),
    }
}

/// Level and rate of the engine: it runs faster with the wheels, and harder with the pedal.
fn engine(drive: Option<Drive>) -> (f32, f32) {
    let Some(drive) = drive else {
        return (0.0, ENGINE_RATE.0);
    };
    let pedal = share(drive.throttle.abs(), 0.0, 1.0);
    let fast = share(drive.speed_m_s.abs(), 0.0, ENGINE_TOP_M_S);
    let (idle, works, runs) = ENGINE;
    let (slow, quick) = ENGINE_RATE;
    (
        idle + works * pedal + runs * fast,
        slow + (quick - slow) * (0.9 * fast + 0.1 * pedal),
    )
}

/// Level and rate of tyres that slide.
fn tyres(drive: Option<Drive>) -> (f32, f32) {
    let slide_m_s = drive.map_or(0.0, |drive| drive.slide_m_s);
    let (from_m_s, most_m_s) = SLIDE_M_S;
    let slides = share(slide_m_s, from_m_s, most_m_s);
    (slides, 0.85 + 0.3 * slides)
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
