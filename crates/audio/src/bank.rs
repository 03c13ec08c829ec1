//! The sounds of `assets/tables/sounds.ron` and their files, which are built in as `assets/sounds/make_sounds.py` makes them.

use antipode_terrain::Cover;

use crate::volumes::Group;
use crate::wav::{self, Clip, WavError};

antipode_tables::sounds!();

/// What the table says of a sound.
struct Row {
    group: Group,
    gain: f32,
    least: f32,
    rate: f32,
    wavers: bool,
    by_ground: bool,
    loops: bool,
}

/// A file of the bank, by its place there.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Sample(usize);

impl Sample {
    /// Every file.
    pub fn all() -> impl Iterator<Item = Self> {
        (0..FILES.len()).map(Self)
    }

    /// The name of its file, without `.wav`.
    pub fn name(self) -> &'static str {
        FILES[self.0].0
    }

    /// The sound itself.
    ///
    /// # Errors
    /// When its file is none that the game plays.
    pub fn clip(self) -> Result<Clip, WavError> {
        wav::read(FILES[self.0].1)
    }
}

impl Sound {
    fn row(self) -> &'static Row {
        &ROWS[self as usize]
    }

    /// Its files.
    pub fn samples(self) -> &'static [Sample] {
        SAMPLES[self as usize]
    }

    /// Whose volume it goes by.
    pub fn group(self) -> Group {
        self.row().group
    }

    /// Its amplitude, 0 to 1, where it is as loud as a share, 0 to 1, of what it can be.
    pub fn gain(self, share: f32) -> f32 {
        let Row { gain, least, .. } = self.row();
        least + (gain - least) * share
    }

    /// How fast it is played: 2 is an octave higher.
    pub fn rate(self) -> f32 {
        self.row().rate
    }

    /// Whether its rate changes a little from one time to the next.
    pub fn wavers(self) -> bool {
        self.row().wavers
    }

    /// Whether it sounds higher on hard ground.
    pub fn is_by_ground(self) -> bool {
        self.row().by_ground
    }

    /// Whether it goes on and on.
    pub fn loops(self) -> bool {
        self.row().loops
    }

    /// That of a step.
    pub(crate) fn step(cover: Cover) -> Self {
        match cover {
            Cover::Rock => Self::StepRock,
            Cover::Gravel => Self::StepGravel,
            Cover::Sand => Self::StepSand,
            Cover::Soil => Self::StepSoil,
            Cover::Grass => Self::StepGrass,
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::panic, reason = "tests fail by panicking")]

    use super::*;

    fn clip(sample: Sample) -> Clip {
        sample
            .clip()
            .unwrap_or_else(|error| panic!("{}: {error}", sample.name()))
    }

    #[test]
    fn every_sound_can_be_read_is_heard_and_is_not_cut_off_at_full_level() {
        for sample in Sample::all() {
            let clip = clip(sample);
            let peak = clip
                .samples
                .iter()
                .fold(0.0f32, |most, x| most.max(x.abs()));
            assert!(
                (0.3..0.95).contains(&peak),
                "{}: peak {peak}",
                sample.name()
            );
            let mean = clip.samples.iter().sum::<f32>() / clip.samples.len() as f32;
            assert!(mean.abs() < 0.03, "{}: mean {mean}", sample.name());
        }
    }

    #[test]
    fn no_sound_ends_in_a_click_and_loops_go_on_without_one() {
        let loops: Vec<Sample> = Sound::ALL
            .into_iter()
            .filter(|sound| sound.loops())
            .flat_map(|sound| sound.samples().iter().copied())
            .collect();
        assert_eq!(loops.len(), 5);
        for sample in Sample::all() {
            let samples = clip(sample).samples;
            let (first, last) = (samples[0], samples[samples.len() - 1]);
            let steepest = samples
                .windows(2)
                .map(|pair| (pair[1] - pair[0]).abs())
                .fold(0.0, f32::max);
            if loops.contains(&sample) {
                let jump = (first - last).abs();
                assert!(
                    jump <= steepest,
                    "{}: {jump} beside {steepest}",
                    sample.name()
                );
            } else {
                let click = first.abs().max(last.abs());
                assert!(click < 0.02, "{}: {click}", sample.name());
            }
        }
    }

    #[test]
    fn grounds_sound_different() {
        let crossings = |sample: Sample| {
            let samples = clip(sample).samples;
            let count = samples
                .windows(2)
                .filter(|pair| pair[0] * pair[1] < 0.0)
                .count();
            count as f32 / samples.len() as f32
        };
        let [soil, grass] =
            [Sound::StepSoil, Sound::StepGrass].map(|sound| crossings(sound.samples()[0]));
        assert!(
            grass > 1.5 * soil,
            "soil is dull and grass rustles: {soil} {grass}"
        );
    }

    #[test]
    fn the_bank_stays_small() {
        let bytes: usize = FILES.iter().map(|(_, bytes)| bytes.len()).sum();
        assert!(bytes < 2_000_000, "{bytes} bytes");
    }
}
