//! The number of a chart.

use std::fmt;
use std::str::FromStr;

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

/// Its number in hexadecimal digits. What a world calls it, its atlas says.
impl fmt::Display for ChartId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:#x}", self.number())
    }
}

impl fmt::Debug for ChartId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

/// What is no name of a chart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ParseChartError;

impl fmt::Display for ParseChartError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a chart is A or B, or a hexadecimal number such as 0x1f")
    }
}

impl std::error::Error for ParseChartError {}

/// By its number, or by a letter as scripts name the charts of a globe; the letters stand for the first two.
impl FromStr for ChartId {
    type Err = ParseChartError;

    fn from_str(name: &str) -> Result<Self, ParseChartError> {
        match name {
            "A" => Ok(Self::FIRST),
            "B" => Ok(Self::SECOND),
            _ => {
                let digits = name.strip_prefix("0x").filter(|it| !it.starts_with('+'));
                let number = digits.and_then(|it| u128::from_str_radix(it, 16).ok());
                number.map(Self::new).ok_or(ParseChartError)
            }
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
        assert_eq!(names[..4], ["0x0", "0x1", "0x2", "0x10000000000000000"]);
        assert_eq!(names.map(|name| name.parse()), charts.map(Ok));
        assert_eq!(["A", "B"].map(str::parse), [Ok(charts[0]), Ok(charts[1])]);
        for name in [
            "",
            "C",
            "a",
            "2",
            "0x",
            "0x+2",
            "0x-2",
            "0xg",
            "0x1 ",
            &format!("0x1{:032x}", 0),
        ] {
            assert_eq!(name.parse::<ChartId>(), Err(ParseChartError), "{name}");
        }
    }
}
