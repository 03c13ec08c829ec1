//! Whole numbers of 256 bits: exact sums of products of numbers of 128.

use super::TilingError;

/// `high * 2^128 + low`, between `-2^255` and `2^255`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Wide {
    high: i128,
    low: u128,
}

impl Wide {
    /// Nought.
    pub const ZERO: Self = Self { high: 0, low: 0 };

    /// The product of any two numbers: at most `2^254`.
    pub fn product(a: i128, b: i128) -> Self {
        let (low, carried) = a.unsigned_abs().carrying_mul(b.unsigned_abs(), 0);
        let magnitude = Self {
            high: carried as i128,
            low,
        };
        if (a < 0) == (b < 0) {
            magnitude
        } else {
            magnitude.negated()
        }
    }

    /// The number with the other sign; `-2^255`, which no product reaches, stays as it is.
    pub fn negated(self) -> Self {
        Self {
            high: (!self.high).wrapping_add(i128::from(self.low == 0)),
            low: self.low.wrapping_neg(),
        }
    }

    /// The sum. Whoever adds products keeps their sum below `2^255`: see [`Golden::LIMIT`](super::Golden::LIMIT).
    pub fn plus(self, other: Self) -> Self {
        let (low, carry) = self.low.overflowing_add(other.low);
        let high = self.high.wrapping_add(other.high);
        Self {
            high: high.wrapping_add(i128::from(carry)),
            low,
        }
    }

    /// The difference, without a look for overflow: products are far from it.
    pub fn minus(self, other: Self) -> Self {
        self.plus(other.negated())
    }

    /// The number in 128 bits.
    ///
    /// # Errors
    /// [`TilingError::OutOfReach`] where it has more.
    pub fn narrowed(self) -> Result<i128, TilingError> {
        let low = self.low as i128;
        if self.high == low >> 127 {
            Ok(low)
        } else {
            Err(TilingError::OutOfReach)
        }
    }

    /// The number to 1 ulp.
    pub fn to_f64(self) -> f64 {
        // Of a number just below 0 the two halves would cancel.
        if self.high < 0 {
            return -self.negated().to_f64();
        }
        self.high as f64 * 2f64.powi(128) + self.low as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wide(value: i128) -> Wide {
        Wide::product(value, 1)
    }

    #[test]
    fn products_and_sums_are_those_of_small_numbers_where_they_are_small() {
        let numbers = [0, 1, -1, 5, -7, 1 << 60, -(1 << 62), (1 << 63) - 1];
        for a in numbers {
            for b in numbers {
                let product = Wide::product(a, b);
                assert_eq!(product.narrowed(), Ok(a * b));
                assert_eq!(product.to_f64(), (a * b) as f64);
                assert_eq!(product.plus(wide(a)).narrowed(), Ok(a * b + a));
                assert_eq!(product.minus(wide(b)).narrowed(), Ok(a * b - b));
            }
        }
    }

    #[test]
    fn what_does_not_fit_is_an_error_and_what_cancels_fits_again() {
        let big = i128::MAX;
        let square = Wide::product(big, big);
        assert_eq!(square.narrowed(), Err(TilingError::OutOfReach));
        assert_eq!(square.negated().narrowed(), Err(TilingError::OutOfReach));
        // (n + 1)(n - 1) - n^2 = -1
        let n = big - 1;
        let rest = Wide::product(n + 1, n - 1).minus(Wide::product(n, n));
        assert_eq!(rest.narrowed(), Ok(-1));
        assert_eq!(rest.to_f64(), -1.0);
        assert_eq!(square.to_f64(), 2f64.powi(254));
        assert_eq!(Wide::product(i128::MIN, i128::MIN).to_f64(), 2f64.powi(254));
        assert_eq!(wide(i128::MIN).narrowed(), Ok(i128::MIN));
        assert_eq!(Wide::ZERO, wide(3).minus(wide(3)));
    }
}
