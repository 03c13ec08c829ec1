//! `docs/accuracy.md`, made from a report: prose from a template, every figure from the report.
//!
//! The template is Markdown with three kinds of holes:
//! - `{{made on}}`: program, machine and adapter;
//! - `{{section ID}}`: a section, with its method, tables and plots;
//! - `{{cell ID | WORDS | WORDS | COLUMN}}`: one cell, from the first row of the section in which
//!   every one of the words is a whole cell;
//! - `{{rest}}`: the sections that no other hole has shown.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use crate::error::LabError;
use crate::figure;
use crate::markdown;
use crate::report::{Cell, Report, Section};
use crate::svg;

/// The document's file name.
pub const NAME: &str = "accuracy.md";
/// The directory of its plots, beside it.
pub const PLOTS: &str = "accuracy";
/// What stands where a report has no answer.
pub const NOT_MEASURED: &str = "*not measured*";

const TEMPLATE: &str = include_str!("docs/accuracy.md");

/// The document and the files that it shows.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Document {
    /// The document, Markdown.
    pub text: String,
    /// File name and SVG of each plot, in the order of the report.
    pub plots: Vec<(String, String)>,
}

/// The document of a report.
///
/// # Errors
/// [`LabError::Template`] when the template itself has a mistake.
pub fn document(report: &Report) -> Result<Document, LabError> {
    let plots = report.sections.iter().flat_map(|section| &section.plots);
    Ok(Document {
        text: filled(TEMPLATE, report)?,
        plots: plots
            .map(|plot| (markdown::file_name(plot), svg::plot(plot)))
            .collect(),
    })
}

/// The plots that a directory holds; none where there is no such directory.
pub fn plots_in(folder: &Path) -> Vec<PathBuf> {
    let Ok(entries) = std::fs::read_dir(folder) else {
        return Vec::new();
    };
    let mut files: Vec<PathBuf> = entries
        .filter_map(|entry| Some(entry.ok()?.path()))
        .filter(|path| path.extension().is_some_and(|end| end == "svg"))
        .collect();
    files.sort();
    files
}

fn filled(template: &str, report: &Report) -> Result<String, LabError> {
    let mut shown = Vec::new();
    let mut out = String::new();
    let mut left = template;
    while let Some((before, after)) = left.split_once("{{") {
        let Some((hole, rest)) = after.split_once("}}") else {
            return Err(LabError::Template("a hole is not closed".into()));
        };
        out.push_str(before);
        out.push_str(&answer(hole.trim(), report, &mut shown)?);
        left = rest;
    }
    out.push_str(left);
    Ok(out)
}

fn answer(hole: &str, report: &Report, shown: &mut Vec<String>) -> Result<String, LabError> {
    let (verb, words) = hole.split_once(' ').unwrap_or((hole, ""));
    match verb {
        "made" => Ok(made_on(report)),
        "section" => {
            shown.push(words.to_owned());
            let found = report.sections.iter().find(|section| section.id == words);
            Ok(found.map_or_else(|| format!("{NOT_MEASURED}\n"), part))
        }
        "rest" => {
            let others = report.sections.iter();
            let others = others.filter(|section| !shown.contains(&section.id));
            Ok(others.map(part).collect::<Vec<_>>().join("\n"))
        }
        "cell" => {
            let parts: Vec<&str> = words.split('|').map(str::trim).collect();
            cell(report, &parts)
        }
        _ => Err(LabError::Template(format!(
            "there is no hole called \"{verb}\""
        ))),
    }
}

fn part(section: &Section) -> String {
    markdown::section(section, 2, PLOTS)
}

fn made_on(report: &Report) -> String {
    let mut out = String::new();
    for (name, value) in &report.made_on {
        let _ = writeln!(out, "- {name}: {value}");
    }
    out
}

fn cell(report: &Report, parts: &[&str]) -> Result<String, LabError> {
    let [id, words @ .., column] = parts else {
        return Err(LabError::Template("a cell needs section and column".into()));
    };
    let section = report.sections.iter().find(|section| section.id == *id);
    let tables = section.map(|section| &section.tables);
    for table in tables.into_iter().flatten() {
        let Some(at) = table.columns.iter().position(|name| name == column) else {
            continue;
        };
        let found = table.rows.iter().find(|row| {
            let has = |word: &&str| row.contains(&Cell::Text((*word).to_owned()));
            words.iter().all(has)
        });
        if let Some(answer) = found.and_then(|row| row.get(at)) {
            return Ok(figure::cell(answer));
        }
    }
    Ok(NOT_MEASURED.to_owned())
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests fail by panicking")]
mod tests {
    use super::*;
    use crate::report::Table;

    fn report() -> Report {
        let section = |id: &str| Section {
            id: id.into(),
            title: id.to_uppercase(),
            method: vec![],
            tables: vec![Table {
                title: "T".into(),
                columns: vec!["What".into(), "Worst".into()],
                rows: vec![vec![
                    Cell::Text("port".into()),
                    Cell::Figure(1.5, "ulp".into()),
                ]],
            }],
            plots: vec![],
        };
        Report {
            made_on: vec![("adapter".into(), "none".into())],
            sections: vec![section("a"), section("b")],
        }
    }

    #[test]
    fn holes_are_filled_from_the_report() {
        let text = filled("{{cell a | port | Worst}}!", &report()).unwrap();
        assert_eq!(text, "1.50 ulp!");
        let text = filled("{{section b}}--{{rest}}", &report()).unwrap();
        assert!(
            text.starts_with("## B") && text.contains("--## A"),
            "{text}"
        );
        assert_eq!(text.matches("## ").count(), 2);
        assert_eq!(
            filled("{{made on}}", &report()).unwrap(),
            "- adapter: none\n"
        );
    }

    #[test]
    fn what_is_missing_is_said_and_mistakes_are_errors() {
        let text = filled("{{cell a | port | Best}} {{section c}}", &report()).unwrap();
        assert_eq!(text.matches(NOT_MEASURED).count(), 2);
        assert!(filled("{{sum a}}", &report()).is_err());
        assert!(filled("{{cell", &report()).is_err());
    }
}
