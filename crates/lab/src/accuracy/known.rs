//! Bars that are known not to be reached, each with the reason and a ceiling that it may not pass either.
//!
//! A row in this list is shown as not reached, in words, and does not fail the run as long as it stays under
//! its ceiling. The bars themselves stay where they are; whoever reaches one strikes it from the list.

use super::row::Arithmetic;

/// A bar that is not reached yet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Known {
    quantity: &'static str,
    arithmetics: &'static [Arithmetic],
    /// The error that it may not pass, in the row's unit.
    pub ceiling: f64,
    /// What stands between.
    pub why: &'static str,
}

const KNOWN: [Known; 6] = [
    Known {
        quantity: "port, hyperbolic (exponential chart)",
        arithmetics: &[Arithmetic::Single, Arithmetic::Gpu],
        ceiling: 2.6,
        why: "d^2 is rounded before the series, and sinh doubles that at d = 3",
    },
    Known {
        quantity: "port, hyperbolic (cylindrical chart)",
        arithmetics: &[Arithmetic::Single, Arithmetic::Gpu],
        ceiling: 3.0,
        why: "two rounded squares, and a product of two series",
    },
    Known {
        quantity: "length of a light's direction",
        arithmetics: &[Arithmetic::Single],
        ceiling: 3.2e-7,
        why: "normalised once in f32; no shader has lamps yet",
    },
    Known {
        quantity: "composed camera moves, off orthogonal",
        arithmetics: &[Arithmetic::Single],
        ceiling: 3.5e-7,
        why: "f32 Gram-Schmidt; the game composes no moves",
    },
    Known {
        quantity: "distance of two points",
        arithmetics: &[Arithmetic::Single],
        ceiling: 2.8e-7,
        why: "the points themselves are rounded to f32 first",
    },
    Known {
        quantity: "sinh(t)/t",
        arithmetics: &[Arithmetic::Single, Arithmetic::Gpu],
        ceiling: 1.6,
        why: "1.54 at the worst of 2e7 arguments, by the division",
    },
];

/// The entry that covers an error of a quantity, if there is one.
pub fn known(quantity: &str, arithmetic: Arithmetic, error: f64) -> Option<&'static Known> {
    KNOWN.iter().find(|known| {
        known.quantity == quantity
            && known.arithmetics.contains(&arithmetic)
            && error <= known.ceiling
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn past_its_ceiling_a_known_miss_is_a_failure() {
        let port = "port, hyperbolic (exponential chart)";
        assert!(known(port, Arithmetic::Gpu, 2.0).is_some());
        assert!(known(port, Arithmetic::Gpu, 2.7).is_none());
        assert!(known(port, Arithmetic::Double, 2.0).is_none());
        assert!(known("port, spherical", Arithmetic::Gpu, 0.1).is_none());
    }
}
