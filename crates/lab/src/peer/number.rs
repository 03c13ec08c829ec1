//! The arithmetic the representations are written in: single, double, and one that counts.
//!
//! Nothing is corrected here: every operation is the machine's own, so that what a test measures
//! is the representation and its precision.

use std::cell::Cell;
use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A real number of some precision.
pub trait Number:
    Copy
    + Debug
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// What the precision is called.
    const NAME: &'static str;

    /// The nearest number to a double.
    fn of(value: f64) -> Self;
    /// The number as a double, exactly.
    fn get(self) -> f64;
    /// Square root.
    #[must_use]
    fn sqrt(self) -> Self;
    /// Exponential.
    #[must_use]
    fn exp(self) -> Self;
    /// Natural logarithm.
    #[must_use]
    fn ln(self) -> Self;
    /// Sine of an angle in radians.
    #[must_use]
    fn sin(self) -> Self;
    /// Cosine of an angle in radians.
    #[must_use]
    fn cos(self) -> Self;
    /// Hyperbolic sine.
    #[must_use]
    fn sinh(self) -> Self;
    /// Hyperbolic cosine.
    #[must_use]
    fn cosh(self) -> Self;
    /// Inverse hyperbolic sine.
    #[must_use]
    fn asinh(self) -> Self;
    /// Angle of the vector (x, self), radians.
    #[must_use]
    fn atan2(self, x: Self) -> Self;
}

/// The length of a vector, without overflow where the length itself is finite.
pub fn length<N: Number>(vector: [N; 2]) -> N {
    let [x, y] = vector.map(|part| if part < N::of(0.0) { -part } else { part });
    let (small, large) = if x < y { (x, y) } else { (y, x) };
    if large == N::of(0.0) {
        return large;
    }
    let share = small / large;
    large * (N::of(1.0) + share * share).sqrt()
}

macro_rules! machine_number {
    ($type:ty) => {
        impl Number for $type {
            const NAME: &'static str = stringify!($type);

            fn of(value: f64) -> Self {
                value as $type
            }
            fn get(self) -> f64 {
                f64::from(self)
            }
            fn sqrt(self) -> Self {
                <$type>::sqrt(self)
            }
            fn exp(self) -> Self {
                <$type>::exp(self)
            }
            fn ln(self) -> Self {
                <$type>::ln(self)
            }
            fn sin(self) -> Self {
                <$type>::sin(self)
            }
            fn cos(self) -> Self {
                <$type>::cos(self)
            }
            fn sinh(self) -> Self {
                <$type>::sinh(self)
            }
            fn cosh(self) -> Self {
                <$type>::cosh(self)
            }
            fn asinh(self) -> Self {
                <$type>::asinh(self)
            }
            fn atan2(self, x: Self) -> Self {
                <$type>::atan2(self, x)
            }
        }
    };
}

machine_number!(f32);
machine_number!(f64);

/// How many operations of each kind were done.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Operations {
    /// Additions and subtractions.
    pub additions: u32,
    /// Multiplications.
    pub multiplications: u32,
    /// Divisions.
    pub divisions: u32,
    /// Roots, exponentials, logarithms, circular and hyperbolic functions.
    pub functions: u32,
}

impl Operations {
    /// All of them together.
    pub fn total(self) -> u32 {
        self.additions + self.multiplications + self.divisions + self.functions
    }
}

thread_local! {
    static DONE: Cell<Operations> = const {
        Cell::new(Operations { additions: 0, multiplications: 0, divisions: 0, functions: 0 })
    };
}

/// The operations that `work` does on [`Counted`] numbers.
pub fn count(work: impl FnOnce()) -> Operations {
    DONE.set(Operations::default());
    work();
    DONE.get()
}

fn note(kind: impl FnOnce(&mut Operations) -> &mut u32) {
    let mut done = DONE.get();
    let times = kind(&mut done);
    *times = times.saturating_add(1);
    DONE.set(done);
}

/// A double that counts what is done to it. Changes of sign and comparisons are free.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Counted(f64);

macro_rules! counted_operator {
    ($trait:ident, $method:ident, $kind:ident, $operator:tt) => {
        impl $trait for Counted {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                note(|done| &mut done.$kind);
                Self(self.0 $operator other.0)
            }
        }
    };
}

counted_operator!(Add, add, additions, +);
counted_operator!(Sub, sub, additions, -);
counted_operator!(Mul, mul, multiplications, *);
counted_operator!(Div, div, divisions, /);

impl Neg for Counted {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Counted {
    fn function(self, value: impl FnOnce(f64) -> f64) -> Self {
        note(|done| &mut done.functions);
        Self(value(self.0))
    }
}

impl Number for Counted {
    const NAME: &'static str = "counted";

    fn of(value: f64) -> Self {
        Self(value)
    }
    fn get(self) -> f64 {
        self.0
    }
    fn sqrt(self) -> Self {
        self.function(f64::sqrt)
    }
    fn exp(self) -> Self {
        self.function(f64::exp)
    }
    fn ln(self) -> Self {
        self.function(f64::ln)
    }
    fn sin(self) -> Self {
        self.function(f64::sin)
    }
    fn cos(self) -> Self {
        self.function(f64::cos)
    }
    fn sinh(self) -> Self {
        self.function(f64::sinh)
    }
    fn cosh(self) -> Self {
        self.function(f64::cosh)
    }
    fn asinh(self) -> Self {
        self.function(f64::asinh)
    }
    fn atan2(self, x: Self) -> Self {
        self.function(|y| y.atan2(x.0))
    }
}
