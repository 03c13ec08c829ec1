//! The medians as tables, each with its verdicts.

use super::number::Operations;
use super::outcome::Outcome;
use super::published::{MEDIANS, Published};
use super::suite::{Medians, Subject, Test};
use crate::{Cell, Table};

/// The two tolerances, in radii and radians.
pub const TOLERANCES: [f64; 2] = [0.1, 1e-3];

/// A subject and its medians at each of [`TOLERANCES`].
pub struct Measured {
    /// What was measured.
    pub subject: Subject,
    /// Its medians.
    pub medians: [Medians; 2],
}

fn outcome(median: Option<Outcome>) -> Cell {
    match median {
        Some(Outcome::Failed(at)) => Cell::figure(at, ""),
        Some(Outcome::Held(to)) => Cell::text(format!("> {to}")),
        None => Cell::Empty,
    }
}

fn position(test: Test) -> usize {
    Test::ALL
        .iter()
        .position(|&other| other == test)
        .unwrap_or(0)
}

/// The medians of every representation at one of [`TOLERANCES`], by its index.
pub fn medians(measured: &[Measured], at: usize) -> Table {
    let mut columns = ["representation", "precision"].map(str::to_owned).to_vec();
    columns.extend(Test::ALL.map(|test| format!("{}, {}", test.name(), test.unit())));
    columns.push("count, operations".to_owned());
    let rows = measured.iter().map(|one| {
        let mut row = vec![
            Cell::text(one.subject.name),
            Cell::text(one.subject.precision),
        ];
        row.extend(one.medians[at].map(outcome));
        row.push(
            one.subject
                .costs
                .map_or(Cell::Empty, |costs| Cell::figure(costs.compose.total(), "")),
        );
        row
    });
    let title = format!("Where the median run fails, tolerance {}", TOLERANCES[at]);
    Table::new(title, columns, rows)
}

/// The published medians beside ours.
pub fn published(measured: &[Measured]) -> Table {
    let ours = |published: &Published, at: usize| {
        let one = measured.iter().find(|one| {
            one.subject.name == published.subject && one.subject.precision == published.precision
        });
        one.and_then(|one| one.medians[at][position(published.test)])
    };
    let rows = MEDIANS.iter().map(|published| {
        let (loose, tight) = (ours(published, 0), ours(published, 1));
        let agrees = match (loose, tight) {
            (Some(loose), Some(tight)) => published.is_between(tight.reached(), loose.reached()),
            _ => false,
        };
        vec![
            Cell::text(published.subject),
            Cell::text(published.precision),
            Cell::text(published.test.name()),
            Cell::figure(published.median, published.test.unit()),
            outcome(loose),
            outcome(tight),
            Cell::Verdict(agrees),
        ]
    });
    let columns = [
        "representation",
        "precision",
        "test",
        "published",
        "here, 0.1",
        "here, 1e-3",
        "reproduced",
    ];
    Table::new("Beside the published medians", columns, rows)
}

/// The best that the others reach in a test, measured here or published, and whose it is.
fn best(
    measured: &[Measured],
    precision: &str,
    test: Test,
    at: usize,
) -> Option<(Outcome, String)> {
    let peers = measured.iter().filter(|one| !one.subject.is_ours);
    let here = peers
        .filter(|one| one.subject.precision == precision)
        .filter_map(|one| {
            Some((
                one.medians[at][position(test)]?,
                one.subject.name.to_owned(),
            ))
        });
    let printed = MEDIANS
        .iter()
        .filter(|known| known.precision == precision && known.test == test)
        .map(|known| {
            let name = format!("{}, published", known.subject);
            (Outcome::Failed(known.median), name)
        });
    here.chain(printed).reduce(|best, other| {
        if best.0.at_least(other.0) {
            best
        } else {
            other
        }
    })
}

/// The camera-relative rule beside the best of the others, test by test.
pub fn ours(measured: &[Measured]) -> Table {
    let mut rows = Vec::new();
    for (at, tolerance) in TOLERANCES.iter().enumerate() {
        for one in measured.iter().filter(|one| one.subject.is_ours) {
            for (test, median) in Test::ALL.into_iter().zip(one.medians[at]) {
                let other = best(measured, one.subject.precision, test, at);
                let holds = match (median, &other) {
                    (Some(median), Some((other, _))) => median.at_least(*other),
                    _ => false,
                };
                rows.push(vec![
                    Cell::text(test.name()),
                    Cell::text(one.subject.precision),
                    Cell::figure(*tolerance, ""),
                    Cell::text(other.as_ref().map_or("", |(_, name)| name)),
                    outcome(other.as_ref().map(|(median, _)| *median)),
                    outcome(median),
                    Cell::Verdict(holds),
                ]);
            }
        }
    }
    let columns = [
        "test",
        "precision",
        "tolerance",
        "best of the others",
        "its median",
        "camera-relative",
        "at least as good",
    ];
    let title = "The camera-relative rule beside the best of the others";
    Table::new(title, columns, rows)
}

fn in_words(operations: Operations) -> Cell {
    let kinds = [
        (operations.additions, "add"),
        (operations.multiplications, "mul"),
        (operations.divisions, "div"),
        (operations.functions, "fn"),
    ];
    let parts = kinds.iter().filter(|(times, _)| *times > 0);
    let parts: Vec<_> = parts
        .map(|(times, kind)| format!("{times} {kind}"))
        .collect();
    Cell::text(if parts.is_empty() {
        "none".to_owned()
    } else {
        parts.join(", ")
    })
}

/// What each operation of each representation costs: the published count.
pub fn counts(measured: &[Measured]) -> Table {
    let single = measured.iter().filter(|one| one.subject.precision == "f32");
    let rows = single.filter_map(|one| {
        let costs = one.subject.costs?;
        let operations = [
            costs.spin,
            costs.push,
            costs.apply,
            costs.compose,
            costs.inverse,
            costs.push_to,
            costs.distance,
            costs.angle,
        ];
        let mut row = vec![Cell::text(one.subject.name)];
        row.extend(operations.map(in_words));
        Some(row)
    });
    let columns = [
        "representation",
        "turn",
        "translation",
        "isometry on point",
        "isometry on isometry",
        "inverse",
        "translation to point",
        "distance",
        "angle",
    ];
    Table::new("Operations, counted", columns, rows)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::peer::suite::subjects;

    fn all(reached: impl Fn(bool) -> Outcome) -> Vec<Measured> {
        let measured = subjects().into_iter().map(|subject| {
            let medians = [[Some(reached(subject.is_ours)); Test::ALL.len()]; 2];
            Measured { subject, medians }
        });
        measured.collect()
    }

    fn verdicts(table: &Table) -> Vec<bool> {
        let cells = table.rows.iter().flatten();
        cells
            .filter_map(|cell| match cell {
                Cell::Verdict(good) => Some(*good),
                _ => None,
            })
            .collect()
    }

    #[test]
    fn a_rule_that_falls_behind_is_said_to() {
        let behind = all(|is_ours| Outcome::Failed(if is_ours { 700 } else { 800 }));
        assert!(verdicts(&ours(&behind)).iter().all(|good| !good));
        let ahead = all(|is_ours| Outcome::Failed(if is_ours { 800 } else { 700 }));
        assert!(verdicts(&ours(&ahead)).iter().all(|good| *good));
        // Not even the published figures are beaten by failing at once.
        let level = all(|_| Outcome::Failed(1));
        assert!(verdicts(&ours(&level)).iter().any(|good| !good));
    }

    #[test]
    fn a_published_median_far_from_ours_is_not_reproduced() {
        assert!(
            verdicts(&published(&all(|_| Outcome::Failed(80))))
                .iter()
                .all(|good| !good)
        );
        let right = MEDIANS[0];
        assert!(right.is_between(6, 9) && right.is_between(7, 9) && !right.is_between(8, 9));
    }

    #[test]
    fn every_row_has_a_cell_for_every_column() {
        let measured = all(|_| Outcome::Held(9));
        let made = [
            medians(&measured, 0),
            published(&measured),
            ours(&measured),
            counts(&measured),
        ];
        for table in made {
            assert!(!table.rows.is_empty());
            for row in &table.rows {
                assert_eq!(row.len(), table.columns.len(), "{}", table.title);
            }
        }
    }
}
