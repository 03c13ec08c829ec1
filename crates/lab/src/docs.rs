//! The documents `docs/accuracy.md` and `docs/terrain.md`, made from a report: prose from a template, every figure
//! from the report.
//!
//! A template is Markdown with four kinds of holes:
//! - `{{made on}}`: program, machine and adapter;
//! - `{{section ID}}`: a section, with its method, tables and plots;
//! - `{{cell ID | WORDS | WORDS | COLUMN}}`: one cell, from the first row of the section in which
//!   every one of the words is a whole cell;
//! - `{{rest}}`: the document's sections that no other hole has shown.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use crate::error::LabError;
use crate::figure;
use crate::gpu;
use crate::markdown;
use crate::report::{Cell, Report, Section};
use crate::svg;
use crate::terrain;

/// What stands where a report has no answer.
pub const NOT_MEASURED: &str = "*not measured*";

/// One of the documents.
#[derive(Debug)]
pub struct Kind {
    /// Its file name.
    pub name: &'static str,
    /// The directory of its plots, beside it.
    pub plots: &'static str,
    template: &'static str,
    /// Whether it is the one about terrain; the other has all other sections.
    terrain: bool,
}

/// How exact the game is, and what that costs.
pub const ACCURACY: Kind = Kind {
    name: "accuracy.md",
    plots: "accuracy",
    template: include_str!("docs/accuracy.md"),
    terrain: false,
};

/// How fast ground is made, and what it takes.
pub const TERRAIN: Kind = Kind {
    name: "terrain.md",
    plots: "terrain",
    template: include_str!("docs/terrain.md"),
    terrain: true,
};

/// Every document.
pub const ALL: [&Kind; 2] = [&ACCURACY, &TERRAIN];

/// A document and the files that it shows.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Document {
    /// The document, Markdown.
    pub text: String,
    /// File name and SVG of each plot, in the order of the report.
    pub plots: Vec<(String, String)>,
}

impl Kind {
    /// Whether a section belongs into this document. What was measured of somebody's graphics card is in none.
    pub fn has(&self, section: &Section) -> bool {
        let is_of_a_card = section.id.starts_with(gpu::PREFIX);
        !is_of_a_card && section.id.starts_with(terrain::PREFIX) == self.terrain
    }

    /// The document of a report.
    ///
    /// # Errors
    /// [`LabError::Template`] when the template itself has a mistake.
    pub fn document(&self, report: &Report) -> Result<Document, LabError> {
        let own = report.sections.iter().filter(|section| self.has(section));
        let plots = own.flat_map(|section| &section.plots);
        Ok(Document {
            text: self.filled(self.template, report)?,
            plots: plots
                .map(|plot| (markdown::file_name(plot), svg::plot(plot)))
                .collect(),
        })
    }

    fn filled(&self, template: &str, report: &Report) -> Result<String, LabError> {
        let mut shown = Vec::new();
        let mut out = String::new();
        let mut left = template;
        while let Some((before, after)) = left.split_once("{{") {
            let Some((hole, rest)) = after.split_once("}}") else {
                return Err(LabError::Template("a hole is not closed".into()));
            };
            out.push_str(before);
            out.push_str(&self.answer(hole.trim(), report, &mut shown)?);
            left = rest;
        }
        out.push_str(left);
        Ok(out)
    }

    fn answer(
        &self,
        hole: &str,
        report: &Report,
        shown: &mut Vec<String>,
    ) -> Result<String, LabError> {
        let (verb, words) = hole.split_once(' ').unwrap_or((hole, ""));
        match verb {
            "made" => Ok(made_on(report)),
            "section" => {
                shown.push(words.to_owned());
                let found = report.sections.iter().find(|section| section.id == words);
                Ok(found.map_or_else(|| format!("{NOT_MEASURED}\n"), |it| self.part(it)))
            }
            "rest" => {
                let others = report.sections.iter().filter(|section| self.has(section));
                let others = others.filter(|section| !shown.contains(&section.id));
                Ok(others
                    .map(|it| self.part(it))
                    .collect::<Vec<_>>()
                    .join("\n"))
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

    fn part(&self, section: &Section) -> String {
        markdown::section(section, 2, self.plots)
    }
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
            let has = |word: &&str| row.contains(&Cell::text(*word));
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
            pictures: vec![],
        };
        Report {
            made_on: vec![("adapter".into(), "none".into())],
            sections: vec![section("a"), section("b")],
        }
    }

    #[test]
    fn holes_are_filled_from_the_report() {
        let text = ACCURACY
            .filled("{{cell a | port | Worst}}!", &report())
            .unwrap();
        assert_eq!(text, "1.50 ulp!");
        let text = ACCURACY
            .filled("{{section b}}--{{rest}}", &report())
            .unwrap();
        assert!(
            text.starts_with("## B") && text.contains("--## A"),
            "{text}"
        );
        assert_eq!(text.matches("## ").count(), 2);
        assert_eq!(
            ACCURACY.filled("{{made on}}", &report()).unwrap(),
            "- adapter: none\n"
        );
    }

    #[test]
    fn each_document_shows_its_own_sections_only() {
        let mut report = report();
        report.sections[1].id = "terrain-field".into();
        let shown = ACCURACY.filled("{{rest}}", &report).unwrap();
        assert!(shown.contains("## A") && !shown.contains("## B"), "{shown}");
        let shown = TERRAIN.filled("{{rest}}", &report).unwrap();
        assert!(shown.contains("## B") && !shown.contains("## A"), "{shown}");
        report.sections[1].id = "gpu-frames".into();
        for kind in ALL {
            let shown = kind.filled("{{rest}}", &report).unwrap();
            assert!(!shown.contains("## B"), "{shown}");
        }
    }

    #[test]
    fn what_is_missing_is_said_and_mistakes_are_errors() {
        let text = ACCURACY
            .filled("{{cell a | port | Best}} {{section c}}", &report())
            .unwrap();
        assert_eq!(text.matches(NOT_MEASURED).count(), 2);
        assert!(ACCURACY.filled("{{sum a}}", &report()).is_err());
        assert!(ACCURACY.filled("{{cell", &report()).is_err());
    }
}
