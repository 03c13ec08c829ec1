//! Numbers `a + b phi` with whole a and b, where `phi = (1 + sqrt(5))/2` and hence `phi^2 = phi + 1`.
//!
//! The *conjugate* of such a number has `-1/phi`, the other root of that equation, in place of phi; sums and products go
//! along with it. A number times its conjugate is the whole number `a^2 + a b - b^2`, its *norm*.

use std::cmp::Ordering;

use super::TilingError;
use super::wide::Wide;

/// The golden ratio, to the last place.
const PHI: f64 = 1.618_033_988_749_895;

/// `a + b phi`, exactly, with a and b between `-LIMIT` and `LIMIT`. Ordered by its value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Golden {
    whole: i128,
    phis: i128,
}

impl Golden {
    /// The greatest a and b: `2^125`. Sums of two fit into 128 bits, and sums of the nine products that a coordinate of a
    /// product of matrices is made of, at most `9 * 2^250`, into 256.
    pub const LIMIT: i128 = 1 << 125;
    /// 0.
    pub const ZERO: Self = Self { whole: 0, phis: 0 };
    /// 1.
    pub const ONE: Self = Self { whole: 1, phis: 0 };
    /// The golden ratio.
    pub const PHI: Self = Self { whole: 0, phis: 1 };

    /// `whole + phis * phi`.
    ///
    /// # Errors
    /// [`TilingError::OutOfReach`] where one of them is beyond [`LIMIT`](Self::LIMIT).
    pub fn new(whole: i128, phis: i128) -> Result<Self, TilingError> {
        let fits = |part: i128| part.unsigned_abs() <= Self::LIMIT.unsigned_abs();
        if fits(whole) && fits(phis) {
            Ok(Self { whole, phis })
        } else {
            Err(TilingError::OutOfReach)
        }
    }

    /// a and b of `a + b phi`.
    pub fn parts(self) -> [i128; 2] {
        [self.whole, self.phis]
    }

    /// The sum.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn plus(self, other: Self) -> Result<Self, TilingError> {
        Self::new(self.whole + other.whole, self.phis + other.phis)
    }

    /// The difference.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn minus(self, other: Self) -> Result<Self, TilingError> {
        self.plus(other.negated())
    }

    /// The number below 0 that is as far from it.
    #[must_use]
    pub const fn negated(self) -> Self {
        Self {
            whole: -self.whole,
            phis: -self.phis,
        }
    }

    /// The product. Only the result need be in range, not what it is made of.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn times(self, other: Self) -> Result<Self, TilingError> {
        Self::dot([self], [other])
    }

    /// The number times phi: `(a + b phi) phi = b + (a + b) phi`.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn times_phi(self) -> Result<Self, TilingError> {
        Self::new(self.phis, self.whole + self.phis)
    }

    /// The number over phi, which is a whole number of both kinds too since `1/phi = phi - 1`.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn over_phi(self) -> Result<Self, TilingError> {
        Self::new(self.phis - self.whole, self.whole)
    }

    /// The sum of products of one to three pairs, of which only the result need be in range:
    /// `(a + b phi)(c + d phi) = ac + bd + (ad + bc + bd) phi`.
    pub(super) fn dot<const N: usize>(
        ours: [Self; N],
        theirs: [Self; N],
    ) -> Result<Self, TilingError> {
        let (mut whole, mut phis) = (Wide::ZERO, Wide::ZERO);
        for (one, other) in ours.into_iter().zip(theirs) {
            let both = Wide::product(one.phis, other.phis);
            let cross =
                Wide::product(one.whole, other.phis).plus(Wide::product(one.phis, other.whole));
            whole = whole.plus(Wide::product(one.whole, other.whole)).plus(both);
            phis = phis.plus(cross).plus(both);
        }
        Self::new(whole.narrowed()?, phis.narrowed()?)
    }

    /// How the number compares with 0.
    pub fn sign(self) -> Ordering {
        sign(self.whole, self.phis)
    }

    /// The number as an `f64`, within 8e-16 of itself however small it is.
    ///
    /// Where a and b differ in sign, `a + b phi` may cancel to nothing. There the conjugate `a - b/phi` is a sum of two of
    /// one sign, and the number is its norm, which is whole, over that.
    pub fn to_f64(self) -> f64 {
        let (a, b) = (self.whole as f64, self.phis as f64);
        if a * b >= 0.0 {
            return a + b * PHI;
        }
        self.norm().to_f64() / (a - b * (PHI - 1.0))
    }

    /// `a^2 + a b - b^2`.
    fn norm(self) -> Wide {
        Wide::product(self.whole, self.whole + self.phis).minus(Wide::product(self.phis, self.phis))
    }
}

/// How `a + b phi` compares with 0, for a and b to twice [`Golden::LIMIT`].
///
/// Where a and b are of one sign that is plain. Otherwise the number is multiplied by phi, which keeps its sign: b and
/// a + b are not greater than the greater of a and b, and the conjugate has shrunk by phi. A number is at least one over
/// its conjugate, so that after some 190 times at most the conjugate is so much the lesser of the two that a and b are of
/// one sign.
fn sign(mut a: i128, mut b: i128) -> Ordering {
    loop {
        if a >= 0 && b >= 0 {
            return (a | b).cmp(&0);
        }
        if a <= 0 && b <= 0 {
            return Ordering::Less;
        }
        (a, b) = (b, a + b);
    }
}

impl Ord for Golden {
    fn cmp(&self, other: &Self) -> Ordering {
        sign(self.whole - other.whole, self.phis - other.phis)
    }
}

impl PartialOrd for Golden {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl From<i32> for Golden {
    fn from(whole: i32) -> Self {
        Self {
            whole: whole.into(),
            phis: 0,
        }
    }
}
