//! The name of a chart.

use std::fmt;

/// A chart of a world's atlas: a number that the atlas gives it, for good. A chart that is made on demand has the same
/// number whenever it is made, since the number says which chart it is and not how many there were before.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct ChartId([u64; 2]);

impl ChartId {
    /// The chart that every atlas has: the only one of a world with one chart, and A of the sphere.
    pub const FIRST: Self = Self([0, 0]);
    /// The second of an atlas that counts its charts: B of the sphere.
    pub const SECOND: Self = Self([0, 1]);

    /// The chart with that number.
    pub const fn new(number: u128) -> Self {
        Self([(number >> 64) as u64, number as u64])
    }

    /// Its number.
    pub const fn number(self) -> u128 {
        (self.0[0] as u128) << 64 | self.0[1] as u128
    }
}

/// The letter of the first two, the number of others.
impl fmt::Debug for ChartId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::FIRST => f.pad("A"),
            Self::SECOND => f.pad("B"),
            other => write!(f, "#{:x}", other.number()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn charts_are_told_apart_and_ordered_by_their_whole_number() {
        let numbers = [0, 1, 2, 1 << 64, (1 << 64) + 1, u128::MAX];
        let charts = numbers.map(ChartId::new);
        assert_eq!(charts.map(ChartId::number), numbers);
        assert!(charts.is_sorted_by(|a, b| a < b));
        assert_eq!(charts[..2], [ChartId::FIRST, ChartId::SECOND]);
        let names = charts.map(|chart| format!("{chart:?}"));
        assert_eq!(names[..3], ["A", "B", "#2"]);
    }
}
