//! The sounds that are built in, as `assets/sounds/make_sounds.py` makes them.

use antipode_terrain::Cover;

use crate::wav::{self, Clip, WavError};

/// Variants by the names of their files.
macro_rules! samples {
    ($($variant:ident = $file:literal,)+) => {
        /// A sound of the bank.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[expect(missing_docs, reason = "each is the file of its name")]
        pub enum Sample {
            $($variant,)+
        }

        impl Sample {
            /// Every sound.
            pub const ALL: &'static [Self] = &[$(Self::$variant),+];

            /// The name of its file, without `.wav`.
            pub fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $file,)+
                }
            }

            fn bytes(self) -> &'static [u8] {
                match self {
                    $(Self::$variant => include_bytes!(concat!("../../../assets/sounds/", $file, ".wav")),)+
                }
            }
        }
    };
}

samples! {
    StepRock1 = "step-rock-1",
    StepRock2 = "step-rock-2",
    StepRock3 = "step-rock-3",
    StepGravel1 = "step-gravel-1",
    StepGravel2 = "step-gravel-2",
    StepGravel3 = "step-gravel-3",
    StepSand1 = "step-sand-1",
    StepSand2 = "step-sand-2",
    StepSand3 = "step-sand-3",
    StepSoil1 = "step-soil-1",
    StepSoil2 = "step-soil-2",
    StepSoil3 = "step-soil-3",
    StepGrass1 = "step-grass-1",
    StepGrass2 = "step-grass-2",
    StepGrass3 = "step-grass-3",
    Dig1 = "dig-1",
    Dig2 = "dig-2",
    Dig3 = "dig-3",
    Build1 = "build-1",
    Build2 = "build-2",
    LandSoft = "land-soft",
    LandHard = "land-hard",
    Shot = "shot",
    Click = "click",
    Struck = "struck",
    Hurt = "hurt",
    Lamp = "lamp",
    PickUp = "pick-up",
    Tick = "tick",
    Press = "press",
    Slot = "slot",
    Wind = "wind",
    Day = "day",
    Night = "night",
    Engine = "engine",
    Tyres = "tyres",
    Horn = "horn",
    Door = "door",
    Pad = "pad",
    Bell = "bell",
}

impl Sample {
    /// The sound itself.
    ///
    /// # Errors
    /// When its file is none that the game plays.
    pub fn clip(self) -> Result<Clip, WavError> {
        wav::read(self.bytes())
    }

    /// The variants of a step.
    pub(crate) fn steps(cover: Cover) -> [Self; 3] {
        match cover {
            Cover::Rock => [Self::StepRock1, Self::StepRock2, Self::StepRock3],
            Cover::Gravel => [Self::StepGravel1, Self::StepGravel2, Self::StepGravel3],
            Cover::Sand => [Self::StepSand1, Self::StepSand2, Self::StepSand3],
            Cover::Soil => [Self::StepSoil1, Self::StepSoil2, Self::StepSoil3],
            Cover::Grass => [Self::StepGrass1, Self::StepGrass2, Self::StepGrass3],
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

    const LOOPS: [Sample; 5] = [
        Sample::Wind,
        Sample::Day,
        Sample::Night,
        Sample::Engine,
        Sample::Tyres,
    ];

    #[test]
    fn every_sound_can_be_read_is_heard_and_is_not_cut_off_at_full_level() {
        for sample in Sample::ALL {
            let clip = clip(*sample);
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
        for sample in Sample::ALL {
            let samples = clip(*sample).samples;
            let (first, last) = (samples[0], samples[samples.len() - 1]);
            let steepest = samples
                .windows(2)
                .map(|pair| (pair[1] - pair[0]).abs())
                .fold(0.0, f32::max);
            if LOOPS.contains(sample) {
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
            [Cover::Soil, Cover::Grass].map(|cover| crossings(Sample::steps(cover)[0]));
        assert!(
            grass > 1.5 * soil,
            "soil is dull and grass rustles: {soil} {grass}"
        );
    }

    #[test]
    fn the_bank_stays_small() {
        let bytes: usize = Sample::ALL.iter().map(|sample| sample.bytes().len()).sum();
        assert!(bytes < 2_000_000, "{bytes} bytes");
    }
}
