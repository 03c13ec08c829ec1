//! Chance that a save, a seed and the player's actions determine: SplitMix64 (Steele, Lea and Flood 2014).

/// A stream of numbers that its seed determines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Dice(u64);

impl Dice {
    /// A stream of its own for each list of seeds.
    pub fn new(seeds: &[u64]) -> Self {
        let mut dice = Self(0);
        for seed in seeds {
            dice.0 ^= seed;
            dice.0 = dice.next();
        }
        dice
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Evenly from 0 to below 1.
    pub fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Evenly between two bounds.
    pub fn between(&mut self, [least, most]: [f64; 2]) -> f64 {
        least + (most - least) * self.unit()
    }

    /// A whole number from the first to the last of a range.
    pub fn whole(&mut self, [least, most]: [u32; 2]) -> u32 {
        least + (self.unit() * f64::from(most - least + 1)) as u32
    }

    /// A heading in radians.
    pub fn heading(&mut self) -> f64 {
        self.between([-std::f64::consts::PI, std::f64::consts::PI])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_seeds_give_the_same_numbers_and_others_others() {
        let row = |seeds: &[u64]| {
            let mut dice = Dice::new(seeds);
            [dice.unit(), dice.unit(), dice.unit()]
        };
        assert_eq!(row(&[3, 5]), row(&[3, 5]));
        assert_ne!(row(&[3, 5]), row(&[5, 3]));
    }

    #[test]
    fn numbers_are_spread_evenly_within_their_bounds() {
        let mut dice = Dice::new(&[7]);
        let numbers: Vec<_> = (0..1000).map(|_| dice.between([-2.0, 3.0])).collect();
        assert!(numbers.iter().all(|n| (-2.0..3.0).contains(n)));
        let mean = numbers.iter().sum::<f64>() / 1000.0;
        assert!((mean - 0.5).abs() < 0.15, "{mean}");
        let counts = (0..600)
            .map(|_| dice.whole([4, 6]))
            .fold([0; 3], |mut c, n| {
                c[n as usize - 4] += 1;
                c
            });
        assert!(counts.iter().all(|c| (150..250).contains(c)), "{counts:?}");
    }
}
