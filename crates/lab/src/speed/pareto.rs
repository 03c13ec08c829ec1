//! Time against error: who is on the frontier, as a table and a plot.

use std::marker::PhantomData;

use crate::speed::clock::{Batch, race, scalar};
use crate::{Cell, Effort, Plot, Scale, Series, Table};

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

/// Rivals that are given the same inputs and judged by the same error.
pub struct Contest<'a, I, O, E> {
    inputs: &'a [I],
    error: E,
    rivals: Vec<Rival<'a>>,
    result: PhantomData<O>,
}

impl<'a, I, O, E: Fn(&I, &O) -> f64> Contest<'a, I, O, E> {
    /// Of nobody yet.
    pub fn new(inputs: &'a [I], error: E) -> Self {
        Self {
            inputs,
            error,
            rivals: Vec::new(),
            result: PhantomData,
        }
    }

    /// With a formula that is applied to each input by itself, and where the game uses it.
    #[must_use]
    pub fn with(mut self, name: &str, used: &'static str, formula: impl Fn(&I) -> O + 'a) -> Self {
        let errors: Vec<f64> = self
            .inputs
            .iter()
            .map(|i| (self.error)(i, &formula(i)))
            .collect();
        let batch = scalar(self.inputs, formula);
        self.rivals.push(Rival::of(name, used, &errors, batch));
        self
    }

    /// Times the rivals.
    pub fn race(
        self,
        id: &'static str,
        title: &str,
        error: (&'static str, &'static str),
        effort: Effort,
    ) -> Group {
        Group::race(id, title, error, self.inputs.len(), self.rivals, effort)
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
        Table::new(
            self.title.clone(),
            columns,
            rows.map(|(v, best)| {
                vec![
                    Cell::text(&v.name),
                    Cell::figure(v.ns, "ns"),
                    used.map_or(Cell::Empty, |u| Cell::figure(v.ns / u.ns, "")),
                    Cell::figure(v.error, self.unit),
                    Cell::count(v.not_numbers),
                    Cell::Text(if best { "yes" } else { "no" }.to_owned()),
                    Cell::text(v.used),
                ]
            }),
        )
    }

    /// Time across, error upwards.
    pub fn plot(&self) -> Plot {
        let own = self.variants.iter().map(|v| {
            Series::dots(
                if v.used.is_empty() {
                    v.name.clone()
                } else {
                    format!("{} ({})", v.name, v.used)
                },
                [(v.ns, v.error.max(LEAST_DRAWN))],
            )
        });
        Plot::new(
            format!("speed-{}", self.id),
            self.title.clone(),
            Scale::Logarithmic.axes("time, ns", &format!("{}, {}", self.error, self.unit)),
            own.chain([self.frontier_line()]),
        )
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
        Series::line("frontier", points)
    }
}
