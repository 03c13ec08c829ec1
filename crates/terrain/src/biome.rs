//! The biomes of `assets/tables/biomes.ron`: octaves, frequencies, amplitudes, height levels and colours.
//!
//! Octaves, frequencies, amplitudes and levels are the reference game's; its colours
//! are the starting point of the palettes, which are tuned for linear light.

use glam::Vec4;

use crate::cover::Cover;
use crate::form::Form;
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
#[derive(Debug, Clone, Copy, PartialEq)]
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

/// What a biome is of which a whole world is made.
#[derive(Debug)]
struct Alone {
    octaves: usize,
    first_frequency: f64,
    first_amplitude_m: f64,
    middle_m: f64,
    top_m: f64,
    /// How far the ground of flat worlds at 2, 4 and 8 m is off, metres.
    level_errors_m: [f64; 3],
    kinds: Kinds,
}

/// A kind of land.
#[derive(Debug)]
pub struct Biome {
    name: &'static str,
    alone: Option<Alone>,
    /// Heat, humidity and how high land lies.
    pub(crate) climate: [f32; 3],
    /// Whether worlds may begin in it.
    pub(crate) begins: bool,
    rise_m: f32,
    waves_m: [f32; 4],
    terraces: f32,
    /// Heights over the middle of the world's ground where middle and high ground begin.
    pub(crate) levels_m: [f32; 2],
    /// What low, middle and high ground is covered with.
    pub(crate) covers: [Cover; 3],
    pub(crate) kinds: Kinds,
    pub(crate) palette: Palette,
}

type Row = Biome;
antipode_tables::biomes!();

impl Biome {
    /// The biome of the world of [`crate::Generator::OneBiome`] with this seed: that at `seed` modulo their number, as in
    /// the reference game.
    pub fn from_seed(seed: u64) -> &'static Self {
        let alone = || ROWS.iter().filter(|row| row.alone.is_some());
        let count = alone().count().max(1) as u64;
        alone().nth((seed % count) as usize).unwrap_or(&ROWS[0])
    }

    /// All biomes.
    pub fn all() -> &'static [Self] {
        &ROWS
    }

    /// The biome of a name.
    pub fn of_name(name: &str) -> Option<&'static Self> {
        ROWS.iter().find(|row| row.name == name)
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

    /// Half of the greatest relief of a world of it alone, metres: such worlds have ground between 0 and twice this height
    /// where they are flat, and this high on average.
    pub fn max_amplitude_m(&self) -> f64 {
        self.octaves().iter().map(|o| o.amplitude_m / 2.0).sum()
    }

    /// Heights where middle and high ground begin in a world of it alone, metres in flat worlds.
    pub(crate) fn levels_alone_m(&self) -> [f32; 2] {
        let levels = |alone: &Alone| [alone.middle_m as f32, alone.top_m as f32];
        self.alone.as_ref().map_or([0.0; 2], levels)
    }

    /// The kinds of a world of it alone.
    pub(crate) fn kinds_alone(&self) -> Kinds {
        self.alone.as_ref().map_or(self.kinds, |it| it.kinds)
    }

    /// How far the ground of a flat world of it alone is off at 2, 4 and 8 m, metres.
    pub(crate) fn level_errors_m(&self) -> [f64; 3] {
        self.alone.as_ref().map_or([0.0; 3], |it| it.level_errors_m)
    }

    /// The octaves of a world of it alone.
    pub(crate) fn octaves(&self) -> Vec<Octave> {
        let Some(alone) = &self.alone else {
            return Vec::new();
        };
        let mut octave = Octave {
            frequency: alone.first_frequency,
            amplitude_m: alone.first_amplitude_m,
        };
        let mut octaves = Vec::with_capacity(alone.octaves);
        for _ in 0..alone.octaves {
            octaves.push(octave);
            octave.frequency *= FREQUENCY_RATIO;
            octave.amplitude_m *= AMPLITUDE_RATIO;
        }
        octaves
    }

    /// How its ground is shaped where a world has biomes by climate.
    pub(crate) fn form(&self) -> Form {
        Form {
            waves: Vec4::from(self.waves_m),
            fall_m: -self.rise_m,
            terraces: self.terraces,
        }
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
        let alone = (0..5).map(Biome::from_seed);
        let reliefs: Vec<_> = alone.map(Biome::max_amplitude_m).collect();
        assert_eq!(reliefs, [18.75, 12.75, 15.75, 14.0, 18.75]);
    }

    #[test]
    fn no_two_biomes_have_the_same_ground_or_form() {
        assert!(ROWS.len() >= 9, "{}", ROWS.len());
        for (n, a) in ROWS.iter().enumerate() {
            for b in &ROWS[n + 1..] {
                assert_ne!(a.kinds.middle, b.kinds.middle, "{} {}", a.name, b.name);
                assert_ne!(a.form(), b.form(), "{} {}", a.name, b.name);
            }
        }
    }

    #[test]
    fn octaves_double_in_frequency_and_halve_in_amplitude() {
        let octaves = Biome::from_seed(0).octaves();
        assert_eq!(octaves.len(), 4);
        assert_eq!(octaves[3].frequency, 2.4);
        assert_eq!(octaves[3].amplitude_m, 2.5);
    }
}
