//! Quiet music without an end: phrases of a few notes over slow chords, with long rests between.
//!
//! A phrase walks along a pentatonic scale, in which any two notes go together: major by day, minor by night. Which
//! notes come is a pure function of how many came before.

use crate::bank::Sound;
use crate::player::Voice;

/// Semitones above A of the scales' notes, over two octaves.
const MAJOR: [i32; 10] = [0, 2, 4, 7, 9, 12, 14, 16, 19, 21];
const MINOR: [i32; 10] = [0, 3, 5, 7, 10, 12, 15, 17, 19, 22];
/// Degrees of the scale that begin a chord.
const ROOTS: [i32; 4] = [0, 3, 1, 2];
/// Length of a beat, in seconds.
const BEAT_S: f64 = 0.85;
/// Beats of a chord.
const CHORD_BEATS: u32 = 4;
/// Chords of a phrase.
const PHRASE_CHORDS: u32 = 6;
/// Shortest and longest rest between phrases, in beats.
const REST_BEATS: (u32, u32) = (30, 75);
/// Time before the first note, in seconds.
const FIRST_S: f64 = 3.0;

/// The composer.
#[derive(Clone, Debug)]
pub struct Music {
    /// Time until the next beat, in seconds.
    left_s: f64,
    /// Beats of this phrase that were played.
    beat: u32,
    /// Where the melody stands in the scale.
    degree: i32,
    dice: u64,
}

impl Default for Music {
    fn default() -> Self {
        Self {
            left_s: FIRST_S,
            beat: 0,
            degree: 4,
            dice: 0x5EED,
        }
    }
}

impl Music {
    /// Lets `dt_s` seconds pass; `night`: whether it is dark. `play` gets the notes that fall into them.
    pub fn advance(&mut self, dt_s: f64, night: bool, mut play: impl FnMut(Voice)) {
        self.left_s -= dt_s;
        // A long gap in time, as after a suspend, is a rest and not a cluster of notes.
        if self.left_s < -2.0 * BEAT_S {
            self.left_s = 0.0;
        }
        if self.left_s <= 0.0 {
            self.beat(if night { &MINOR } else { &MAJOR }, &mut play);
            self.left_s += BEAT_S;
        }
    }

    fn beat(&mut self, scale: &[i32; 10], play: &mut impl FnMut(Voice)) {
        let (chord, within) = (self.beat / CHORD_BEATS, self.beat % CHORD_BEATS);
        if within == 0 {
            let root = ROOTS[chord as usize % ROOTS.len()];
            for degree in [root, root + 2] {
                play(note(Sound::Pad, scale, degree, -12, 1.0));
            }
        }
        // The first beat of all is the chord's alone, and not every other has a note.
        if self.beat > 0 && self.roll(100) < if within == 2 { 75 } else { 45 } {
            self.degree = (self.degree + self.roll(5) as i32 - 2).clamp(0, scale.len() as i32 - 1);
            let share = 0.7 + 0.03 * self.roll(11) as f32;
            play(note(Sound::Bell, scale, self.degree, 0, share));
        }
        self.beat += 1;
        if self.beat >= CHORD_BEATS * PHRASE_CHORDS {
            self.beat = 0;
            let (least, most) = REST_BEATS;
            self.left_s += f64::from(least + self.roll(most - least)) * BEAT_S;
        }
    }

    /// A number below `sides`: the upper bits of L'Ecuyer's 64-bit generator with Knuth's constants.
    fn roll(&mut self, sides: u32) -> u32 {
        self.dice = self
            .dice
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        ((self.dice >> 33) % u64::from(sides)) as u32
    }
}

/// A note of the scale, as loud as a share of what its sound can be; the samples sound A.
fn note(sound: Sound, scale: &[i32; 10], degree: i32, transpose: i32, share: f32) -> Voice {
    let semitones = scale[degree.rem_euclid(10) as usize] + transpose;
    Voice {
        sample: sound.samples()[0],
        group: sound.group(),
        gain: share * sound.gain(1.0),
        rate: sound.rate() * (semitones as f32 / 12.0).exp2(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::volumes::Group;

    /// Notes with their times, in seconds.
    fn listen(seconds: u32, night: bool) -> Vec<(f64, Voice)> {
        let (mut music, mut notes) = (Music::default(), Vec::new());
        for tick in 0..seconds * 20 {
            let now_s = f64::from(tick) * 0.05;
            music.advance(0.05, night, |voice| notes.push((now_s, voice)));
        }
        notes
    }

    #[test]
    fn music_is_the_same_every_time_and_never_ends() {
        let notes = listen(3600, false);
        assert_eq!(notes, listen(3600, false));
        assert!(notes.last().is_some_and(|(at_s, _)| *at_s > 3500.0));
    }

    #[test]
    fn phrases_are_followed_by_long_rests() {
        let notes = listen(600, false);
        let gaps: Vec<f64> = notes.windows(2).map(|pair| pair[1].0 - pair[0].0).collect();
        let rests = gaps.iter().filter(|gap| **gap > 25.0).count();
        assert!((5..15).contains(&rests), "{rests} rests in ten minutes");
        assert!(gaps.iter().all(|gap| *gap < 80.0));
    }

    #[test]
    fn every_note_is_of_its_scale_and_quiet() {
        for (night, scale) in [(false, MAJOR), (true, MINOR)] {
            for (_, voice) in listen(600, night) {
                let semitones = (12.0 * voice.rate.log2()).round() as i32;
                let within = semitones.rem_euclid(12);
                assert!(
                    scale.iter().any(|tone| tone % 12 == within),
                    "{night} {semitones}"
                );
                assert!(voice.gain < 0.25 && voice.group == Group::Music);
            }
        }
    }

    #[test]
    fn after_a_long_sleep_no_cluster_of_notes_comes() {
        let (mut music, mut count) = (Music::default(), 0);
        music.advance(86_400.0, false, |_| count += 1);
        for _ in 0..5 {
            music.advance(0.05, false, |_| count += 1);
        }
        assert!(count <= 3, "{count} notes at once");
    }
}
