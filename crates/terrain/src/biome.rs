//! The biomes of `assets/tables/biomes.ron`: octaves, frequencies, amplitudes, height levels and colours.
//!
//! Octaves, frequencies, amplitudes and levels are the reference game's; its colours
//! are the starting point of the palettes, which are tuned for linear light.

use crate::cover::Cover;
use crate::fractal::Octave;
use crate::kind::Kind;

/// Frequencies double from octave to octave.
const FREQUENCY_RATIO: f64 = 2.0;
/// Amplitudes halve from octave to octave.
const AMPLITUDE_RATIO: f64 = 0.5;

/// The colours of a biome's ground, sRGB.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Palette {
    /// Ground below the middle level: low land and the inside of pits.
    pub bottom: [u8; 3],
    /// Ground between the levels.
    pub middle: [u8; 3],
    /// Ground above the top level.
    pub top: [u8; 3],
    /// Steep faces.
    pub rock: [u8; 3],
    /// The lighter or darker beds that run through steep faces.
    pub strata: [u8; 3],
}

/// The kinds of a biome's ground.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Kinds {
    /// Of low ground.
    pub low: Kind,
    /// Of middle ground.
    pub middle: Kind,
    /// Of high ground.
    pub high: Kind,
    /// Of the highest.
    pub cap: Kind,
    /// Of patches in all but the highest.
    pub patch: Kind,
    /// What is found right below.
    pub under: Kind,
    /// What is below that.
    pub stone: Kind,
}

/// A kind of land, chosen by a world's seed.
#[derive(Debug)]
pub struct Biome {
    name: &'static str,
    octaves: usize,
    first_frequency: f64,
    first_amplitude_m: f64,
    middle_m: f64,
    top_m: f64,
    /// What low, middle and high ground is covered with.
    pub(crate) covers: [Cover; 3],
    pub(crate) kinds: Kinds,
    pub(crate) palette: Palette,
    /// How far the ground of flat worlds at 2, 4 and 8 m is off, metres.
    pub(crate) level_errors_m: [f64; 3],
}

type Row = Biome;
antipode_tables::biomes!();

impl Biome {
    /// The biome of the world with this seed: that at `seed` modulo their number, as in the reference game.
    pub fn from_seed(seed: u64) -> &'static Self {
        &ROWS[(seed % ROWS.len() as u64) as usize]
    }

    /// Colours of low, middle and high ground, sRGB.
    pub fn ground_colours(&self) -> [[u8; 3]; 3] {
        let Palette {
            bottom,
            middle,
            top,
            ..
        } = self.palette;
        [bottom, middle, top]
    }

    /// The biome's lower-case English name.
    pub fn name(&self) -> &'static str {
        self.name
    }

    /// Half of the greatest relief, metres: flat worlds have ground between 0 and twice
    /// this height, and this high on average.
    pub fn max_amplitude_m(&self) -> f64 {
        self.octaves().iter().map(|o| o.amplitude_m / 2.0).sum()
    }

    /// Height where low ground turns into middle ground, metres in flat worlds.
    pub fn middle_m(&self) -> f64 {
        self.middle_m
    }

    /// Height where middle ground turns into high ground, metres in flat worlds.
    pub fn top_m(&self) -> f64 {
        self.top_m
    }

    pub(crate) fn octaves(&self) -> Vec<Octave> {
        let mut octave = Octave {
            frequency: self.first_frequency,
            amplitude_m: self.first_amplitude_m,
        };
        let mut octaves = Vec::with_capacity(self.octaves);
        for _ in 0..self.octaves {
            octaves.push(octave);
            octave.frequency *= FREQUENCY_RATIO;
            octave.amplitude_m *= AMPLITUDE_RATIO;
        }
        octaves
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seeds_choose_biomes_in_order() {
        let names: Vec<_> = (10..15).map(|seed| Biome::from_seed(seed).name()).collect();
        assert_eq!(names, ["volcanic", "desert", "forest", "toxic", "jungle"]);
        assert_eq!(Biome::from_seed(u64::MAX).name(), "volcanic");
    }

    #[test]
    fn reliefs_are_the_references() {
        let reliefs: Vec<_> = ROWS.iter().map(Biome::max_amplitude_m).collect();
        assert_eq!(reliefs, [18.75, 12.75, 15.75, 14.0, 18.75]);
    }

    #[test]
    fn octaves_double_in_frequency_and_halve_in_amplitude() {
        let octaves = Biome::from_seed(0).octaves();
        assert_eq!(octaves.len(), 4);
        assert_eq!(octaves[3].frequency, 2.4);
        assert_eq!(octaves[3].amplitude_m, 2.5);
    }
}
