//! Tables of ours beside rivals: a time each, how many times ours it is, and how many it has to be.

use super::clock::Rival;
use crate::{Cell, Table};

/// The beginning of a rival's name, and how many times our time it takes at least.
pub type Least = (&'static str, f64);

/// A table of raced rivals. The first `ours + 1` of them are ours, and the slowest of those is what the others are
/// compared with.
pub fn versus(
    title: &str,
    rivals: &[Rival<'_>],
    ns: &[f64],
    last_of_ours: usize,
    least: &[Least],
) -> Table {
    let own = ns[..=last_of_ours].iter().copied().fold(0.0, f64::max);
    let rows = rivals
        .iter()
        .zip(ns)
        .enumerate()
        .map(|(place, (rival, ns))| {
            let mut row = vec![
                Cell::Text(title.to_owned()),
                Cell::Text(rival.name.to_owned()),
                Cell::Figure(*ns, "ns".to_owned()),
            ];
            if place <= last_of_ours {
                row.extend([Cell::Empty, Cell::Empty, Cell::Empty]);
                return row;
            }
            let ratio = ns / own;
            row.push(Cell::Figure(ratio, String::new()));
            let bar = least.iter().find(|(name, _)| rival.name.starts_with(name));
            row.extend(bar.map_or([Cell::Empty, Cell::Empty], |(_, times)| {
                let words = format!("at least {times}");
                [Cell::Text(words), Cell::Verdict(ratio >= *times)]
            }));
            row
        });
    let columns = ["What", "Whose", "Least time", "Times ours", "Bar", "Passed"];
    Table {
        title: format!("{title}: ours and others in one run"),
        columns: columns.map(str::to_owned).to_vec(),
        rows: rows.collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rivals_are_compared_with_the_slowest_of_ours() {
        let rival = |name| Rival::new(name, 1, || ());
        let rivals = [
            rival("ours, a"),
            rival("ours, b"),
            rival("theirs 0.9"),
            rival("other"),
        ];
        let table = versus(
            "T",
            &rivals,
            &[10.0, 20.0, 90.0, 50.0],
            1,
            &[("theirs", 5.0)],
        );
        assert_eq!(table.rows[2][3], Cell::Figure(4.5, String::new()));
        assert_eq!(table.rows[2][5], Cell::Verdict(false));
        assert_eq!(table.rows[3][5], Cell::Empty);
    }
}
