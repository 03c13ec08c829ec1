//! Time against error: who is on the frontier, as a table and a plot.

use crate::speed::clock::{Batch, race, scalar};
use crate::{Axis, Cell, Effort, Plot, Scale, Series, Table};

/// Timings closer than this share count as equal: what a shared machine cannot tell apart.
const TIMING_SLACK: f64 = 0.05;
/// Drawn in place of no error at all, which a logarithmic axis has no place for.
const LEAST_DRAWN: f64 = 1e-18;

/// One way to compute something, and how well it did.
#[derive(Clone, Debug, PartialEq)]
pub struct Variant {
    /// What it is.
    pub name: String,
    /// Nanoseconds per item.
    pub ns: f64,
    /// Worst error over the inputs, in the group's unit; results that are no number are not in it.
    pub error: f64,
    /// How many results were no number.
    pub not_numbers: usize,
    /// Where the game uses it; empty where it does not.
    pub used: &'static str,
}

impl Variant {
    /// The error that decides: a result that is no number is worse than any other.
    fn weight(&self) -> f64 {
        if self.not_numbers > 0 {
            f64::INFINITY
        } else {
            self.error
        }
    }

    /// Whether nothing is left to say for `other`: it is no quicker and no truer, and in one of the two worse.
    fn beats(&self, other: &Self) -> bool {
        let truer = self.weight() < other.weight() && self.ns <= other.ns;
        let quicker = self.weight() <= other.weight() && self.ns < other.ns * (1.0 - TIMING_SLACK);
        truer || quicker
    }
}

/// For each variant whether no other beats it.
pub fn frontier(variants: &[Variant]) -> Vec<bool> {
    variants
        .iter()
        .map(|own| !variants.iter().any(|other| other.beats(own)))
        .collect()
}

/// A variant before its timing: what it computes and how wrong it is.
pub struct Rival<'a> {
    variant: Variant,
    batch: Batch<'a>,
}

impl<'a> Rival<'a> {
    /// A formula applied to each input by itself, judged by `error` over all of them.
    pub fn new<I, O>(
        name: &str,
        used: &'static str,
        inputs: &'a [I],
        formula: impl Fn(&I) -> O + 'a,
        error: impl Fn(&I, &O) -> f64,
    ) -> Self {
        let errors: Vec<f64> = inputs.iter().map(|i| error(i, &formula(i))).collect();
        Self::of(name, used, &errors, scalar(inputs, formula))
    }

    /// Any work, with the errors it made.
    pub fn of(name: &str, used: &'static str, errors: &[f64], batch: Batch<'a>) -> Self {
        let variant = Variant {
            name: name.to_owned(),
            ns: f64::INFINITY,
            error: errors
                .iter()
                .copied()
                .filter(|e| e.is_finite())
                .fold(0.0, f64::max),
            not_numbers: errors.iter().filter(|e| !e.is_finite()).count(),
            used,
        };
        Self { variant, batch }
    }
}

/// Variants that compute the same thing.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// Short and stable.
    pub id: &'static str,
    /// What is computed, and over which inputs.
    pub title: String,
    /// What the error is, with its unit.
    pub error: &'static str,
    /// The unit alone.
    pub unit: &'static str,
    /// The rivals.
    pub variants: Vec<Variant>,
}

impl Group {
    /// Times the rivals, each of which handles `items` a run.
    pub fn race(
        id: &'static str,
        title: &str,
        (error, unit): (&'static str, &'static str),
        items: usize,
        rivals: Vec<Rival<'_>>,
        effort: Effort,
    ) -> Self {
        let (mut variants, mut batches): (Vec<_>, Vec<_>) =
            rivals.into_iter().map(|r| (r.variant, r.batch)).unzip();
        let times = race(&mut batches, items, effort);
        for (variant, ns) in variants.iter_mut().zip(times) {
            variant.ns = ns;
        }
        Self {
            id,
            title: title.to_owned(),
            error,
            unit,
            variants,
        }
    }

    /// A row for each variant, beside what the game uses.
    pub fn table(&self) -> Table {
        let used = self.variants.iter().find(|v| !v.used.is_empty());
        let rows = self.variants.iter().zip(frontier(&self.variants));
        let columns = [
            "variant",
            "time",
            "to the game's",
            self.error,
            "not a number",
            "frontier",
            "in the game",
        ];
        Table {
            title: self.title.clone(),
            columns: columns.map(str::to_owned).to_vec(),
            rows: rows
                .map(|(v, best)| {
                    vec![
                        Cell::Text(v.name.clone()),
                        Cell::Figure(v.ns, "ns".to_owned()),
                        used.map_or(Cell::Empty, |u| Cell::Figure(v.ns / u.ns, String::new())),
                        Cell::Figure(v.error, self.unit.to_owned()),
                        Cell::Figure(v.not_numbers as f64, String::new()),
                        Cell::Text(if best { "yes" } else { "no" }.to_owned()),
                        Cell::Text(v.used.to_owned()),
                    ]
                })
                .collect(),
        }
    }

    /// Time across, error upwards.
    pub fn plot(&self) -> Plot {
        let axis = |label: &str| Axis {
            label: label.to_owned(),
            scale: Scale::Logarithmic,
        };
        let own = self.variants.iter().map(|v| Series {
            name: if v.used.is_empty() {
                v.name.clone()
            } else {
                format!("{} ({})", v.name, v.used)
            },
            points: vec![(v.ns, v.error.max(LEAST_DRAWN))],
            joined: false,
        });
        Plot {
            id: format!("speed-{}", self.id),
            title: self.title.clone(),
            x: axis("time, ns"),
            y: axis(&format!("{}, {}", self.error, self.unit)),
            series: own.chain([self.frontier_line()]).collect(),
        }
    }

    fn frontier_line(&self) -> Series {
        let best = frontier(&self.variants);
        let mut points: Vec<_> = self
            .variants
            .iter()
            .zip(best)
            .filter(|(_, best)| *best)
            .map(|(v, _)| (v.ns, v.error.max(LEAST_DRAWN)))
            .collect();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        Series {
            name: "frontier".to_owned(),
            points,
            joined: true,
        }
    }
}
