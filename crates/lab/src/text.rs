//! A report for a terminal: aligned tables, words to the left and figures to the right.

use std::fmt::Write;

use crate::figure;
use crate::report::{Cell, Report, Section, Table};

/// The whole report.
pub fn report(report: &Report) -> String {
    let mut out = String::new();
    for (name, value) in &report.made_on {
        let _ = writeln!(out, "{name}: {value}");
    }
    for part in &report.sections {
        out.push('\n');
        out.push_str(&section(part));
    }
    out
}

/// One section: heading and tables.
pub fn section(section: &Section) -> String {
    let mut out = format!("== {} ==\n", section.title);
    for part in &section.tables {
        out.push('\n');
        out.push_str(&table(part));
    }
    out
}

/// One table.
pub fn table(table: &Table) -> String {
    let rows: Vec<Vec<String>> = table
        .rows
        .iter()
        .map(|row| row.iter().map(figure::cell).collect())
        .collect();
    let width = |i: usize| {
        let cells = rows.iter().filter_map(|row| row.get(i));
        cells
            .chain(table.columns.get(i))
            .map(|words| words.chars().count())
            .max()
            .unwrap_or(0)
    };
    let widths: Vec<usize> = (0..table.columns.len()).map(width).collect();
    let right: Vec<bool> = (0..table.columns.len())
        .map(|i| is_figures(table, i))
        .collect();
    let mut out = format!("{}\n", table.title);
    out.push_str(&line(&table.columns, &widths, &right));
    let rule: Vec<String> = widths.iter().map(|width| "-".repeat(*width)).collect();
    out.push_str(&line(&rule, &widths, &right));
    for row in &rows {
        out.push_str(&line(row, &widths, &right));
    }
    out
}

/// Whether a column holds figures, so that its entries stand to the right.
pub(crate) fn is_figures(table: &Table, column: usize) -> bool {
    table
        .rows
        .iter()
        .any(|row| matches!(row.get(column), Some(Cell::Figure(..))))
}

fn line(cells: &[String], widths: &[usize], right: &[bool]) -> String {
    let mut out = String::new();
    for ((cell, &width), &right) in cells.iter().zip(widths).zip(right) {
        if !out.is_empty() {
            out.push_str("  ");
        }
        let _ = if right {
            write!(out, "{cell:>width$}")
        } else {
            write!(out, "{cell:<width$}")
        };
    }
    out.truncate(out.trim_end().len());
    out.push('\n');
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_aligned() {
        let made = table(&Table {
            title: "Errors".into(),
            columns: vec!["What".into(), "Worst".into(), "Passed".into()],
            rows: vec![
                vec![
                    Cell::Text("port".into()),
                    Cell::Figure(1.5, "ulp".into()),
                    Cell::Verdict(true),
                ],
                vec![
                    Cell::Text("curvature".into()),
                    Cell::Figure(4.6e-8, "rad".into()),
                    Cell::Verdict(false),
                ],
            ],
        });
        let lines: Vec<&str> = made.lines().collect();
        assert_eq!(lines[1], "What            Worst  Passed");
        assert_eq!(lines[3], "port         1.50 ulp  pass");
        assert_eq!(lines[4], "curvature  4.6e-8 rad  FAIL");
    }
}
