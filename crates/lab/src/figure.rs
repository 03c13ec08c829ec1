//! How figures and other cells are written: two or three significant digits, with their unit.

use crate::report::Cell;

/// A figure alone: three digits where it is of ordinary size, else two and a power of ten.
pub fn number(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    if !value.is_finite() {
        // NaN, inf or -inf.
        return value.to_string();
    }
    if value.fract() == 0.0 && value.abs() < 1e6 {
        return format!("{value:.0}");
    }
    // The exponent after rounding to three digits: 9.996 is 10.0.
    let scientific = format!("{value:.2e}");
    let exponent: i32 = scientific
        .split_once('e')
        .and_then(|(_, digits)| digits.parse().ok())
        .unwrap_or(0);
    match exponent {
        -2..=2 => format!("{value:.*}", (2 - exponent) as usize),
        3..=5 => format!("{value:.0}"),
        _ => format!("{value:.1e}"),
    }
}

/// A figure with its unit.
pub fn with_unit(value: f64, unit: &str) -> String {
    match unit {
        "" => number(value),
        "%" => format!("{}%", number(value)),
        _ => format!("{} {unit}", number(value)),
    }
}

/// A cell as words.
pub fn cell(cell: &Cell) -> String {
    match cell {
        Cell::Text(words) => words.clone(),
        Cell::Figure(value, unit) => with_unit(*value, unit),
        Cell::Verdict(true) => "pass".to_owned(),
        Cell::Verdict(false) => "FAIL".to_owned(),
        Cell::Empty => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_have_two_or_three_digits() {
        for (value, says) in [
            (0.0, "0"),
            (1.0, "1"),
            (0.5, "0.500"),
            (9.996, "10.0"),
            (14.26, "14.3"),
            (331.4, "331"),
            (5120.6, "5121"),
            (4.6e-8, "4.6e-8"),
            (0.0123, "0.0123"),
            (-0.5, "-0.500"),
            (7.04e9, "7.0e9"),
            (100_000.0, "100000"),
            (f64::INFINITY, "inf"),
            (f64::NAN, "NaN"),
        ] {
            assert_eq!(number(value), says, "{value:e}");
        }
        assert_eq!(with_unit(1.5, "ulp"), "1.50 ulp");
        assert_eq!(with_unit(12.0, "%"), "12%");
    }
}
