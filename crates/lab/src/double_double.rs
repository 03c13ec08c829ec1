//! Numbers of about 31 digits, each the unevaluated sum of two `f64`: the reference for the `f64`
//! port.
//!
//! Sums after Knuth, products by a fused multiply-add, division and square root by one step of
//! Newton, as in Hida, Li and Bailey, "Quad-double arithmetic" (2000). The functions are Taylor
//! series after reduction of the argument. Relative errors are about 1e-30; the range is that of
//! `f64`.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// `hi + lo`, where `lo` is at most half a unit in the last place of `hi`.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Double2 {
    hi: f64,
    lo: f64,
}

const HALF_PI: Double2 = Double2 {
    hi: std::f64::consts::FRAC_PI_2,
    lo: 6.123_233_995_736_766e-17,
};
const LN_2: Double2 = Double2 {
    hi: std::f64::consts::LN_2,
    lo: 2.319_046_813_846_299_6e-17,
};

fn two_sum(a: f64, b: f64) -> Double2 {
    let hi = a + b;
    let part = hi - a;
    Double2 {
        hi,
        lo: (a - (hi - part)) + (b - part),
    }
}

/// As [`two_sum`], for |a| >= |b|.
fn quick_two_sum(a: f64, b: f64) -> Double2 {
    let hi = a + b;
    Double2 {
        hi,
        lo: b - (hi - a),
    }
}

fn two_prod(a: f64, b: f64) -> Double2 {
    let hi = a * b;
    Double2 {
        hi,
        lo: a.mul_add(b, -hi),
    }
}

impl From<f64> for Double2 {
    fn from(value: f64) -> Self {
        Self { hi: value, lo: 0.0 }
    }
}

impl Add for Double2 {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (high, low) = (two_sum(self.hi, other.hi), two_sum(self.lo, other.lo));
        let sum = quick_two_sum(high.hi, high.lo + low.hi);
        quick_two_sum(sum.hi, sum.lo + low.lo)
    }
}

impl Neg for Double2 {
    type Output = Self;
    fn neg(self) -> Self {
        Self {
            hi: -self.hi,
            lo: -self.lo,
        }
    }
}

impl Sub for Double2 {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Double2 {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let product = two_prod(self.hi, other.hi);
        let cross = self.hi * other.lo + self.lo * other.hi;
        quick_two_sum(product.hi, product.lo + cross)
    }
}

impl Div for Double2 {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let first = self.hi / other.hi;
        let left = self - other * Self::from(first);
        let second = left.hi / other.hi;
        let left = left - other * Self::from(second);
        let sum = quick_two_sum(first, second);
        sum + Self::from(left.hi / other.hi)
    }
}

impl Double2 {
    /// The quotient of two `f64`, to 31 digits.
    pub fn ratio(a: f64, b: f64) -> Self {
        Self::from(a) / Self::from(b)
    }

    /// The nearest `f64`.
    pub fn to_f64(self) -> f64 {
        self.hi
    }

    fn times_two_to(self, n: i32) -> Self {
        // In two steps, so that neither factor leaves the range.
        let (half, rest) = (f64::from(n / 2).exp2(), f64::from(n - n / 2).exp2());
        Self {
            hi: self.hi * half * rest,
            lo: self.lo * half * rest,
        }
    }

    /// The square root of a number that is not negative.
    #[must_use]
    pub fn sqrt(self) -> Self {
        if self.hi <= 0.0 {
            return Self::default();
        }
        let near = self.hi.sqrt();
        let left = self - two_prod(near, near);
        quick_two_sum(near, left.hi / (2.0 * near))
    }

    /// `sum of x^n / n!` over n from `first` in steps of `step`, signs alternating with `flip`.
    fn series(self, first: u32, step: u32, flip: f64) -> Self {
        let mut term = Self::from(1.0);
        for n in 1..=first {
            term = term * self / Self::from(f64::from(n));
        }
        let (mut sum, mut n) = (Self::default(), first);
        while term.hi.abs() > 1e-34 * sum.hi.abs() && n < 80 {
            sum = sum + term;
            for _ in 0..step {
                n += 1;
                term = term * self / Self::from(f64::from(n));
            }
            term = term * Self::from(flip);
        }
        sum
    }

    /// e to this power.
    #[must_use]
    pub fn exp(self) -> Self {
        const HALVINGS: i32 = 9;
        let n = (self.hi / LN_2.hi).round();
        let small = (self - LN_2 * Self::from(n)).times_two_to(-HALVINGS);
        // e^x - 1, doubled by (1 + s)^2 - 1 = 2 s + s^2.
        let mut s = small.series(1, 1, 1.0);
        for _ in 0..HALVINGS {
            s = s + s + s * s;
        }
        (s + Self::from(1.0)).times_two_to(n as i32)
    }

    /// Hyperbolic sine and cosine.
    #[must_use]
    pub fn sinh_cosh(self) -> (Self, Self) {
        if self.hi.abs() < 0.5 {
            return (self.series(1, 2, 1.0), self.series(0, 2, 1.0));
        }
        let e = self.exp();
        let r = Self::from(1.0) / e;
        let half = Self::from(0.5);
        ((e - r) * half, (e + r) * half)
    }

    /// Sine and cosine of an angle of at most a few turns.
    #[must_use]
    pub fn sin_cos(self) -> (Self, Self) {
        let quarter = (self.hi / HALF_PI.hi).round();
        let x = self - HALF_PI * Self::from(quarter);
        let (sin, cos) = (x.series(1, 2, -1.0), x.series(0, 2, -1.0));
        match quarter.rem_euclid(4.0) as u8 {
            0 => (sin, cos),
            1 => (cos, -sin),
            2 => (-sin, -cos),
            _ => (-cos, sin),
        }
    }

    /// Inverse hyperbolic sine: one step of Newton from the `f64` answer.
    #[must_use]
    pub fn asinh(self) -> Self {
        let near = Self::from(self.hi.asinh());
        let (sinh, cosh) = near.sinh_cosh();
        near - (sinh - self) / cosh
    }

    /// The angle whose sine and cosine are in proportion to `self` and `cos`.
    #[must_use]
    pub fn atan2(self, cos: Self) -> Self {
        let near = Self::from(self.hi.atan2(cos.hi));
        let (s, c) = near.sin_cos();
        let length = (self * self + cos * cos).sqrt();
        near + (self * c - cos * s) / length
    }

    /// The natural logarithm of a positive number.
    #[must_use]
    pub fn ln(self) -> Self {
        let near = Self::from(self.hi.ln());
        near + self / near.exp() - Self::from(1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(a: Double2, b: Double2) {
        let off = ((a - b) / b).to_f64().abs();
        assert!(off < 4e-30, "{a:?} {b:?} {off:e}");
    }

    #[test]
    fn identities_hold_to_thirty_digits() {
        let one = Double2::from(1.0);
        for i in 1..60 {
            let x = Double2::ratio(f64::from(i), 7.0);
            let (sinh, cosh) = x.sinh_cosh();
            close(sinh * sinh + one, cosh * cosh);
            close(sinh + cosh, x.exp());
            let (sin, cos) = x.sin_cos();
            close(sin * sin + cos * cos, one);
            let (twice, _) = (x + x).sin_cos();
            let off = (twice - (sin * cos + sin * cos)).to_f64().abs();
            assert!(off < 1e-30);
            close(sinh.asinh(), x);
            close(x.exp().ln(), x);
            close(x.sqrt() * x.sqrt(), x);
            close(x / x, one);
        }
        let (sin, cos) = Double2::ratio(1.0, 3.0).sin_cos();
        close(sin.atan2(cos), Double2::ratio(1.0, 3.0));
    }
}
