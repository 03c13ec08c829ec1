//! Rows of the golden files, and how far a kernel is off them.

use antipode_geometry::Real;

pub const FUNCTIONS: &str = include_str!("../../../../../tests/reference/functions.json");
pub const KERNELS: &str = include_str!("../../../../../tests/reference/kernels.json");
pub const STRATEGIES: &str = include_str!("../../../../../tests/reference/strategies.json");
pub const TILING: &str = include_str!("../../../../../tests/reference/tiling.json");

/// One kernel in one precision: arguments to answers.
pub type Kernel<T> = fn(&[T]) -> Vec<T>;

/// What an answer's error is a part of.
#[derive(Clone, Copy)]
pub enum Unit {
    /// The last place of each exact number.
    Own,
    /// The last place of each exact number, or of 1 where it is less.
    One,
    /// A point: the last place of its spatial length, and of w or 1.
    Point,
    /// A vector of any kind: the last place of its greatest coordinate or of 1.
    Vector,
}

/// A table of a golden file, the kernel it holds in both precisions, and the stated bounds.
pub struct Check {
    pub table: &'static str,
    /// Public functions that these rows pin down.
    pub covers: &'static [&'static str],
    pub arguments: usize,
    pub double: Kernel<f64>,
    pub single: Option<Kernel<f32>>,
    pub unit: Unit,
    /// What a rounding of the arguments may be multiplied by, at least 1.
    pub condition: fn(&[f64]) -> f64,
    /// Bounds in ulp, `f64` then `f32`.
    pub bounds: [f64; 2],
}

pub fn one(_: &[f64]) -> f64 {
    1.0
}

/// The distance between neighbouring numbers at this size.
fn ulp<T: Real>(x: f64) -> f64 {
    let (digits, least) = if size_of::<T>() == 4 {
        (23, -149)
    } else {
        (52, -1022)
    };
    let exponent = ((x.abs().to_bits() >> 52) as i32 - 1023).max(-1022);
    f64::from((exponent - digits).max(least)).exp2()
}

/// Rows of numbers, one on each line of its table. The standard library reads every digit, where
/// JSON readers may be a last place off.
pub fn rows(text: &str, table: &str) -> Vec<Vec<f64>> {
    let start = format!("\"{table}\": [\n");
    let from = text
        .find(&start)
        .unwrap_or_else(|| panic!("no table {table}"))
        + start.len();
    let lines = text[from..]
        .lines()
        .take_while(|line| *line != "]," && *line != "]");
    let numbers = |line: &str| {
        let inner = line.trim_end_matches(',').trim_matches(['[', ']']);
        inner.split(", ").map(|x| x.parse().unwrap()).collect()
    };
    lines.map(numbers).collect()
}

fn off<T: Real>(unit: Unit, ours: &[T], exact: &[f64]) -> f64 {
    let gaps: Vec<f64> = ours
        .iter()
        .zip(exact)
        .map(|(a, b)| (a.to_f64() - b).abs())
        .collect();
    let over = |gap: f64, size: f64| {
        if gap == 0.0 {
            0.0
        } else {
            gap / ulp::<T>(size)
        }
    };
    // `max` would lose a NaN.
    if gaps.iter().any(|gap| gap.is_nan()) || ours.len() != exact.len() {
        return f64::NAN;
    }
    let most = |sizes: &[f64]| {
        gaps.iter()
            .zip(sizes)
            .map(|(g, s)| over(*g, *s))
            .fold(0.0, f64::max)
    };
    match unit {
        Unit::Own => most(exact),
        Unit::One => most(&exact.iter().map(|x| x.abs().max(1.0)).collect::<Vec<_>>()),
        Unit::Vector => {
            let size = exact.iter().fold(1.0, |size: f64, x| size.max(x.abs()));
            most(&vec![size; exact.len()])
        }
        Unit::Point => {
            // Past a right angle on the sphere the error is a part of the radius.
            let length = exact[0].hypot(exact[1]).hypot(exact[2]);
            let length = if exact[3] < 0.0 { 1.0 } else { length };
            most(&[length, length, length, exact[3].abs().max(1.0)])
        }
    }
}

/// The worst error of a kernel over its table, in ulp over the condition, and where.
pub fn worst<T: Real>(text: &str, check: &Check, kernel: Kernel<T>) -> (f64, Vec<f64>) {
    let mut worst = (0.0, Vec::new());
    for row in rows(text, check.table) {
        let (arguments, exact) = row.split_at(check.arguments);
        let ours = kernel(&arguments.iter().map(|x| T::of(*x)).collect::<Vec<_>>());
        let error = off(check.unit, &ours, exact) / (check.condition)(arguments).max(1.0);
        // A NaN is worse than anything, and ends the search.
        if error.is_nan() {
            return (error, row);
        }
        if error > worst.0 {
            worst = (error, row);
        }
    }
    worst
}

/// What went beyond its bound, in words.
pub fn failures(text: &str, checks: &[Check]) -> Vec<String> {
    let mut out = Vec::new();
    for check in checks {
        let mut note = |precision: &str, (error, row): (f64, Vec<f64>), bound: f64| {
            let words = format!("{} in {precision}: {error:.3} of {bound} ulp", check.table);
            println!("{words}");
            // A NaN is no less than any bound.
            if error.is_nan() || error > bound {
                out.push(format!("{words} at {row:?}"));
            }
        };
        note("f64", worst(text, check, check.double), check.bounds[0]);
        if let Some(kernel) = check.single {
            note("f32", worst(text, check, kernel), check.bounds[1]);
        }
    }
    out
}
