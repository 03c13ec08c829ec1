//! What one test found: the worst error with its input, beside the bar and the textbook formula.

use crate::report::{Cell, Plot, Scale, Series, Table};

/// In which arithmetic a quantity was computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Arithmetic {
    /// Single precision on the processor.
    Single,
    /// Double precision on the processor.
    Double,
    /// Double precision on the processor, rounded to single once.
    Cast,
    /// The shaders, on the adapter in use.
    Gpu,
    /// A built-in function of WGSL, on the adapter in use.
    BuiltIn,
}

impl Arithmetic {
    /// Its name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Single => "CPU f32",
            Self::Double => "CPU f64",
            Self::Cast => "CPU f64, then f32",
            Self::Gpu => "GPU",
            Self::BuiltIn => "GPU, built-in",
        }
    }
}

/// The greatest error among many inputs.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Worst {
    /// The greatest finite error.
    pub error: f64,
    /// The input that caused it; the first that gave NaN or infinity, if any did.
    pub at: String,
    /// Inputs that gave NaN or infinity.
    pub bad: u64,
    /// Inputs tried.
    pub count: u64,
}

impl Worst {
    /// Takes in one input's error; NaN or infinity where the answer was.
    pub fn note(&mut self, error: f64, at: impl FnOnce() -> String) {
        self.count += 1;
        if !error.is_finite() {
            self.bad += 1;
            if self.bad == 1 {
                self.at = at();
            }
        } else if error > self.error {
            self.error = error;
            if self.bad == 0 {
                self.at = at();
            }
        }
    }
}

/// One line of the report.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// What is computed.
    pub quantity: &'static str,
    /// Over which inputs.
    pub range: String,
    /// In which arithmetic.
    pub arithmetic: Arithmetic,
    /// The unit of the errors.
    pub unit: &'static str,
    /// Ours; nothing where it was not run.
    pub ours: Option<Worst>,
    /// The greatest error allowed. Without one, only NaN and infinity fail.
    pub bar: Option<f64>,
    /// The textbook formula on the same inputs, in single precision.
    pub naive: Option<Worst>,
}

/// The headings of the tables that rows make.
const COLUMNS: [&str; 11] = [
    "Quantity",
    "Range",
    "Arithmetic",
    "Worst error",
    "Bar",
    "Passed",
    "NaN or inf",
    "Inputs",
    "Textbook f32",
    "its NaN or inf",
    "Worst input",
];

impl Row {
    /// Whether the bar was met; nothing where it was not run, or is none of ours.
    pub fn passed(&self) -> Option<bool> {
        let ours = self.ours.as_ref()?;
        if self.arithmetic == Arithmetic::BuiltIn {
            return None;
        }
        Some(ours.bad == 0 && ours.count > 0 && self.bar.is_none_or(|bar| ours.error <= bar))
    }

    fn cells(&self) -> Vec<Cell> {
        let figure = |value: f64| Cell::figure(value, self.unit);
        let count = |n: u64| Cell::figure(n as f64, "");
        let mut cells = vec![
            Cell::text(self.quantity),
            Cell::text(&self.range),
            Cell::text(self.arithmetic.name()),
        ];
        let bar = self.bar.map_or(Cell::Empty, figure);
        match &self.ours {
            Some(ours) => cells.extend([
                figure(ours.error),
                bar,
                self.passed().map_or(Cell::Empty, Cell::Verdict),
                count(ours.bad),
                count(ours.count),
            ]),
            None => cells.extend([
                Cell::text("NOT RUN"),
                bar,
                Cell::text("NOT RUN"),
                Cell::Empty,
                Cell::Empty,
            ]),
        }
        match &self.naive {
            Some(naive) if naive.bad == naive.count => {
                cells.extend([Cell::text("none"), count(naive.bad)]);
            }
            Some(naive) => cells.extend([figure(naive.error), count(naive.bad)]),
            None => cells.extend([Cell::Empty, Cell::Empty]),
        }
        let at = self.ours.as_ref().map_or("", |ours| &ours.at);
        cells.push(Cell::text(at));
        cells
    }
}

/// What the rows of one quantity have in common.
#[derive(Clone, Debug)]
pub struct Subject {
    pub quantity: &'static str,
    pub range: String,
    pub unit: &'static str,
    pub naive: Option<Worst>,
}

impl Subject {
    /// A row for each arithmetic, with what was found and its bar.
    pub fn rows<const N: usize>(&self, found: [(Arithmetic, Option<Worst>, f64); N]) -> [Row; N] {
        found.map(|(arithmetic, ours, bar)| Row {
            quantity: self.quantity,
            range: self.range.clone(),
            arithmetic,
            unit: self.unit,
            ours,
            bar: Some(bar),
            naive: self.naive.clone(),
        })
    }
}

/// Takes in one input's errors, at x on the curves; what was not run is left out.
pub fn note_all<const N: usize>(
    errors: [Option<f64>; N],
    worst: &mut [Worst; N],
    curves: &mut [Curve; N],
    x: f64,
    at: impl Fn() -> String,
) {
    for ((error, worst), curve) in errors.into_iter().zip(worst).zip(curves) {
        let Some(error) = error else { continue };
        worst.note(error, &at);
        curve.note(x, error);
    }
}

/// The rows as a table.
pub fn table(title: &str, rows: &[Row]) -> Table {
    Table::new(title, COLUMNS, rows.iter().map(Row::cells))
}

/// A curve of worst errors: the greatest in each of some bins of a logarithmic axis.
#[derive(Clone, Debug)]
pub struct Curve {
    name: String,
    low: f64,
    step: f64,
    worst: Vec<f64>,
}

impl Curve {
    const BINS: usize = 48;

    /// Bins from `low` to `high`, both positive.
    pub fn new(name: &str, low: f64, high: f64) -> Self {
        Self {
            name: name.to_owned(),
            low: low.ln(),
            step: (high / low).ln() / Self::BINS as f64,
            worst: vec![0.0; Self::BINS],
        }
    }

    /// Takes in the error at one place; what is no number is left to [`Worst`].
    pub fn note(&mut self, x: f64, error: f64) {
        let bin = ((x.ln() - self.low) / self.step).floor();
        if error.is_finite() && (0.0..Self::BINS as f64).contains(&bin) {
            let worst = &mut self.worst[bin as usize];
            *worst = worst.max(error);
        }
    }

    /// The curve; bins without error have no point on a logarithmic axis.
    pub fn series(&self) -> Series {
        let place = |i: usize| (self.low + (i as f64 + 0.5) * self.step).exp();
        let points = self.worst.iter().enumerate();
        Series::line(
            self.name.clone(),
            points
                .filter(|(_, worst)| **worst > 0.0)
                .map(|(i, worst)| (place(i), *worst)),
        )
    }
}

/// A plot of curves over logarithmic axes; curves without a point are left out.
pub fn plot(id: &str, title: &str, across: &str, upwards: &str, curves: &[Curve]) -> Plot {
    Plot::new(
        id,
        title,
        Scale::Logarithmic.axes(across, upwards),
        curves
            .iter()
            .map(Curve::series)
            .filter(|series| !series.points.is_empty()),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(ours: Option<Worst>) -> Row {
        Row {
            quantity: "port",
            range: "0 to 3".into(),
            arithmetic: Arithmetic::Gpu,
            unit: "ulp",
            ours,
            bar: Some(1.5),
            naive: None,
        }
    }

    #[test]
    fn one_nan_or_one_error_past_the_bar_fails() {
        let mut worst = Worst::default();
        assert_eq!(row(Some(worst.clone())).passed(), Some(false), "no input");
        worst.note(1.0, || "a".into());
        assert_eq!(row(Some(worst.clone())).passed(), Some(true));
        worst.note(2.0, || "b".into());
        assert_eq!(row(Some(worst)).passed(), Some(false));
        let mut worst = Worst::default();
        worst.note(f64::NAN, || "c".into());
        worst.note(1.0, || "d".into());
        assert_eq!((worst.bad, worst.at.as_str()), (1, "c"));
        assert_eq!(row(Some(worst)).passed(), Some(false));
    }

    #[test]
    fn what_was_not_run_has_no_verdict_and_says_so() {
        let cells = row(None).cells();
        assert_eq!(cells.len(), COLUMNS.len());
        assert!(!cells.iter().any(|cell| matches!(cell, Cell::Verdict(_))));
        assert!(cells.contains(&Cell::Text("NOT RUN".into())));
    }
}
