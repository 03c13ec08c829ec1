//! Sections and tables as Markdown; plots go out as files beside it and are shown from there.

use std::fmt::Write;

use crate::figure;
use crate::report::{Plot, Section, Table};
use crate::text::is_figures;

/// One section under a heading of the given level; `plots` is the directory its plots are in, as
/// seen from the document.
pub fn section(section: &Section, level: usize, plots: &str) -> String {
    let mut out = format!("{} {}\n", "#".repeat(level), escape(&section.title));
    for paragraph in &section.method {
        let _ = write!(out, "\n{}\n", wrapped(&escape(paragraph)));
    }
    for part in &section.tables {
        let _ = write!(out, "\n{}", table(part));
    }
    for plot in &section.plots {
        let _ = write!(
            out,
            "\n![{}]({plots}/{})\n",
            escape(&plot.title),
            file_name(plot)
        );
    }
    out
}

/// The name of a plot's file.
pub fn file_name(plot: &Plot) -> String {
    let safe = |c: char| if c.is_ascii_alphanumeric() { c } else { '-' };
    let id: String = plot.id.chars().map(safe).collect();
    format!("{id}.svg")
}

/// One table under its title.
pub fn table(table: &Table) -> String {
    let mut out = format!("**{}**\n\n|", escape(&table.title));
    for column in &table.columns {
        let _ = write!(out, " {} |", escape(column));
    }
    out.push_str("\n|");
    for i in 0..table.columns.len() {
        out.push_str(if is_figures(table, i) {
            "---:|"
        } else {
            "---|"
        });
    }
    out.push('\n');
    for row in &table.rows {
        out.push('|');
        for cell in row {
            let _ = write!(out, " {} |", escape(&figure::cell(cell)));
        }
        out.push('\n');
    }
    out
}

/// Text that means itself in a table of Markdown.
fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '|' | '*' | '_' | '`' | '\\' | '[' | ']' => {
                out.push('\\');
                out.push(character);
            }
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '\n' => out.push(' '),
            c => out.push(c),
        }
    }
    out
}

/// Lines of at most 90 characters, where the words allow it.
fn wrapped(text: &str) -> String {
    let (mut out, mut length) = (String::new(), 0);
    for word in text.split_whitespace() {
        let more = word.chars().count() + 1;
        if length > 0 && length + more > 90 {
            out.push('\n');
            length = 0;
        } else if length > 0 {
            out.push(' ');
        }
        out.push_str(word);
        length += more;
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::Cell;

    #[test]
    fn a_bar_in_a_cell_does_not_end_it() {
        let made = table(&Table {
            title: "T".into(),
            columns: vec!["a | b".into(), "n".into()],
            rows: vec![vec![
                Cell::Text("|a - b| < c".into()),
                Cell::Figure(2.0, "px".into()),
            ]],
        });
        assert!(made.contains("| a \\| b | n |\n|---|---:|\n"), "{made}");
        assert!(made.contains("| \\|a - b\\| &lt; c | 2 px |"), "{made}");
    }
}
