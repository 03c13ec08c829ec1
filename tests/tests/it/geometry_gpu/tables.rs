//! Rows of the golden files, and errors in units of the last place of single precision.

/// Rows of numbers, one on each line of their table. The standard library reads every digit.
pub fn rows(text: &str, table: &str) -> Vec<Vec<f64>> {
    let start = format!("\"{table}\": [\n");
    let from = text
        .find(&start)
        .unwrap_or_else(|| panic!("no table {table}"))
        + start.len();
    let numbers = |line: &str| {
        let inner = line.trim_end_matches(',').trim_matches(['[', ']']);
        inner.split(", ").map(|x| x.parse().unwrap()).collect()
    };
    let lines = text[from..].lines();
    lines
        .take_while(|line| *line != "]," && *line != "]")
        .map(numbers)
        .collect()
}

/// The distance between neighbouring `f32` numbers at this size; below the normal numbers, which
/// adapters may flush to zero, that of the least of them.
pub fn ulp(x: f64) -> f64 {
    let exponent = ((x.abs().to_bits() >> 52) as i32 - 1023).max(-1022);
    if exponent < -126 {
        return f64::from(f32::MIN_POSITIVE);
    }
    f64::from(exponent - 23).exp2()
}

/// The worst of many errors, and the row that causes it; a NaN is worse than anything.
#[derive(Default)]
pub struct Worst {
    pub error: f64,
    pub at: Vec<f64>,
}

impl Worst {
    pub fn note(&mut self, error: f64, at: &[f64]) {
        let better = error.is_nan() && !self.error.is_nan() || error > self.error;
        if better {
            self.error = error;
            self.at = at.to_vec();
        }
    }

    pub fn check(&self, name: &str, bound: f64) {
        eprintln!("{name}: {:.3e} of {bound:e} at {:?}", self.error, self.at);
        assert!(
            self.error <= bound,
            "{name}: {} of {bound} at {:?}",
            self.error,
            self.at
        );
    }
}
