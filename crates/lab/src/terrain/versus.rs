//! Tables of ours beside rivals: a time each, how many times ours it is, and how many it has to be.

use super::clock::Rival;
use crate::{Cell, Table};

/// The beginning of a rival's name, and how many times the time of each of ours it takes at least.
pub type Least<'a> = (&'static str, &'a [f64]);

/// A table of raced rivals, of which the first `ours` are our own. Bars are those of `least`, in the order of ours.
pub fn versus(
    title: &str,
    rivals: &[Rival<'_>],
    ns: &[f64],
    ours: usize,
    least: &[Least<'_>],
) -> Table {
    let rows = rivals
        .iter()
        .zip(ns)
        .enumerate()
        .map(|(place, (rival, theirs))| {
            let mut row = vec![
                Cell::text(title),
                Cell::text(rival.name),
                Cell::figure(*theirs, "ns"),
            ];
            if place < ours {
                row.extend(vec![Cell::Empty; ours + 2]);
                return row;
            }
            let times: Vec<f64> = ns[..ours].iter().map(|own| theirs / own).collect();
            row.extend(times.iter().map(|times| Cell::figure(*times, "")));
            let bars = least.iter().find(|(name, _)| rival.name.starts_with(name));
            row.extend(bars.map_or([Cell::Empty, Cell::Empty], |(_, bars)| {
                let words: Vec<String> = bars.iter().map(f64::to_string).collect();
                let met = times.iter().zip(*bars).all(|(times, bar)| times >= bar);
                let words = format!("at least {}", words.join(" and "));
                [Cell::Text(words), Cell::Verdict(met)]
            }));
            row
        });
    let own = rivals[..ours]
        .iter()
        .map(|own| format!("Times {}", own.name));
    let columns = ["What", "Whose", "Least time"]
        .map(str::to_owned)
        .into_iter();
    let last = ["Bar", "Passed"].map(str::to_owned);
    Table::new(
        format!("{title}: ours and others in one run"),
        columns.chain(own).chain(last),
        rows,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rival_has_to_be_slower_than_each_of_ours_by_its_own_bar() {
        let rival = |name| Rival::new(name, 1, || ());
        let rivals = [
            rival("ours, a"),
            rival("ours, b"),
            rival("theirs 0.9"),
            rival("other"),
        ];
        let made = |b_ns: f64| {
            let ns = [10.0, b_ns, 90.0, 50.0];
            versus("T", &rivals, &ns, 2, &[("theirs", &[5.0, 3.0])])
        };
        let (quick, slow) = (made(20.0), made(40.0));
        assert_eq!(quick.rows[2][4], Cell::Figure(4.5, String::new()));
        assert_eq!(quick.rows[2][6], Cell::Verdict(true));
        assert_eq!(slow.rows[2][6], Cell::Verdict(false));
        assert_eq!(quick.rows[3][6], Cell::Empty);
        assert!(
            quick
                .rows
                .iter()
                .all(|row| row.len() == quick.columns.len())
        );
    }
}
