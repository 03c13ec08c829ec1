//! Rows of the terrain tables: what was measured, its bar, and whether that was met.
//!
//! Two kinds of bars: times and memory depend on the machine and on what else it does, and are judged in full runs
//! only; ratios between rivals of the same run and counts hold anywhere, and are always judged.

use crate::figure;
use crate::{Cell, Effort, Table};

/// On which side of a bar a figure must lie.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bar {
    /// At most this.
    AtMost(f64),
    /// At least this.
    AtLeast(f64),
}

/// When a bar decides about the run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Judged {
    /// In every run: a ratio of the same run, or a count.
    Always,
    /// In full runs: times and memory of this machine.
    InFull,
}

/// One figure.
#[derive(Clone, Debug)]
pub struct Row {
    what: String,
    case: String,
    value: Option<f64>,
    unit: &'static str,
    bar: Option<(Bar, Judged)>,
    note: String,
}

impl Row {
    /// A figure without a bar; `case` says of what, `unit` may be empty.
    pub fn new(what: &str, case: &str, value: impl Into<Option<f64>>, unit: &'static str) -> Self {
        Self {
            what: what.to_owned(),
            case: case.to_owned(),
            value: value.into(),
            unit,
            bar: None,
            note: String::new(),
        }
    }

    /// With a bar.
    #[must_use]
    pub fn bar(mut self, bar: Bar, judged: Judged) -> Self {
        self.bar = Some((bar, judged));
        self
    }

    /// With words beside it.
    #[must_use]
    pub fn note(mut self, note: impl Into<String>) -> Self {
        self.note = note.into();
        self
    }

    /// The figure, if it was measured.
    #[cfg(test)]
    pub fn value(&self) -> Option<f64> {
        self.value
    }

    /// Whether the figure meets its bar; nothing without a bar or a figure.
    pub fn met(&self) -> Option<bool> {
        let value = self.value?;
        let (bar, _) = self.bar?;
        Some(match bar {
            Bar::AtMost(limit) => value <= limit,
            Bar::AtLeast(limit) => value >= limit,
        })
    }

    fn cells(&self, effort: Effort) -> Vec<Cell> {
        let bar = self.bar.map(|(bar, judged)| match bar {
            Bar::AtMost(limit) => (format!("at most {}", self.written(limit)), judged),
            Bar::AtLeast(limit) => (format!("at least {}", self.written(limit)), judged),
        });
        let verdict = match (self.met(), self.bar) {
            (Some(met), Some((_, Judged::Always))) => Cell::Verdict(met),
            (Some(met), Some(_)) if !effort.quick => Cell::Verdict(met),
            (Some(met), Some(_)) => Cell::Text(if met { "met" } else { "not met" }.to_owned()),
            _ => Cell::Empty,
        };
        let finite = self.value.filter(|value| value.is_finite());
        vec![
            Cell::Text(self.what.clone()),
            Cell::Text(self.case.clone()),
            finite.map_or(Cell::Empty, |v| Cell::Figure(v, self.unit.to_owned())),
            bar.map_or(Cell::Empty, |(words, _)| Cell::Text(words)),
            verdict,
            Cell::Text(self.note.clone()),
        ]
    }

    fn written(&self, value: f64) -> String {
        figure::with_unit(value, self.unit)
    }
}

/// A table of rows.
pub fn table(title: &str, rows: &[Row], effort: Effort) -> Table {
    let columns = ["What", "Case", "Measured", "Bar", "Passed", "Note"];
    Table {
        title: title.to_owned(),
        columns: columns.map(str::to_owned).to_vec(),
        rows: rows.iter().map(|row| row.cells(effort)).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const QUICK: Effort = Effort { quick: true };
    const FULL: Effort = Effort { quick: false };

    fn verdict(row: &Row, effort: Effort) -> Cell {
        row.cells(effort)[4].clone()
    }

    #[test]
    fn a_time_is_judged_in_full_runs_only_and_a_ratio_in_every_run() {
        let slow = Row::new("a", "b", 2.5, "ms").bar(Bar::AtMost(2.0), Judged::InFull);
        assert_eq!(verdict(&slow, FULL), Cell::Verdict(false));
        assert_eq!(verdict(&slow, QUICK), Cell::Text("not met".to_owned()));
        let ratio = Row::new("a", "b", 4.0, "").bar(Bar::AtLeast(6.0), Judged::Always);
        assert_eq!(verdict(&ratio, QUICK), Cell::Verdict(false));
        let lost = Row::new("a", "b", 0.0, "").bar(Bar::AtMost(0.0), Judged::Always);
        assert_eq!(verdict(&lost, QUICK), Cell::Verdict(true));
    }

    #[test]
    fn what_was_not_measured_is_not_judged_and_what_never_ended_fails() {
        let none = Row::new("a", "b", None, "MB").bar(Bar::AtMost(350.0), Judged::InFull);
        assert_eq!(verdict(&none, FULL), Cell::Empty);
        let never = Row::new("a", "b", f64::INFINITY, "s").bar(Bar::AtMost(1.0), Judged::InFull);
        assert_eq!(verdict(&never, FULL), Cell::Verdict(false));
    }
}
