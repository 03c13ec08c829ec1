//! `antipode lab`: the laboratory from the command line. It prints tables, writes reports, and fails where a bar
//! is not met.

use std::fs::OpenOptions;
use std::path::Path;
use std::path::PathBuf;

use antipode_lab::accuracy::{self, Bench};
use antipode_lab::{Effort, LabError, Report, Section, made_on, peer, speed, text};
use antipode_render::AdapterChoice;
use clap::{Args, Subcommand};

use crate::cli::{Adapter, Common};
use crate::failure::Failure;
use crate::output::line;

/// Most failed rows that are named on standard error; the tables have them all.
const MOST_NAMED: usize = 4;

/// What the laboratory can be asked for.
#[derive(Debug, Subcommand)]
pub enum LabAction {
    /// Every formula at its extremes: processor and adapter, ours beside the textbook's.
    Accuracy(Outputs),
    /// What each formula and each choice costs, beside its error.
    Speed(Outputs),
    /// Both.
    All(Outputs),
    /// Make the document from a report, without measuring.
    Docs {
        /// The report to read.
        #[arg(long, value_name = "FILE")]
        json: PathBuf,
        /// Where the document and its plots go.
        #[arg(long, value_name = "DIR")]
        docs: PathBuf,
    },
}

/// What a measurement leaves behind, besides the tables on standard output.
#[derive(Clone, Debug, Args)]
pub struct Outputs {
    /// Write the report as JSON.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Write the report as a page, DIR/index.html.
    #[arg(long, value_name = "DIR")]
    report: Option<PathBuf>,
    /// Write the report as a document with plots, DIR/accuracy.md.
    #[arg(long, value_name = "DIR")]
    docs: Option<PathBuf>,
    /// Fewer inputs and shorter runs, in under a minute.
    #[arg(long)]
    quick: bool,
}

/// Does what was asked for.
///
/// # Errors
/// When a bar is not met, the adapter fails, or a file or standard output cannot be written.
pub fn run(action: &LabAction, common: &Common) -> Result<(), Failure> {
    let (outputs, wanted) = match action {
        LabAction::Accuracy(outputs) => (outputs, [true, false]),
        LabAction::Speed(outputs) => (outputs, [false, true]),
        LabAction::All(outputs) => (outputs, [true, true]),
        LabAction::Docs { json, docs } => {
            let report = Report::read(json).map_err(failure)?;
            return report.write_docs(docs).map_err(failure);
        }
    };
    writable(outputs)?;
    let report = measured(outputs, wanted, common)?;
    if let Some(file) = &outputs.json {
        report.write_json(file).map_err(failure)?;
    }
    if let Some(directory) = &outputs.report {
        report.write_page(directory).map_err(failure)?;
    }
    if let Some(directory) = &outputs.docs {
        report.write_docs(directory).map_err(failure)?;
    }
    judged(&report)
}

/// Looks before minutes of measuring whether what comes of it can be written.
fn writable(outputs: &Outputs) -> Result<(), Failure> {
    let told = |path: &Path, error: std::io::Error| {
        Failure::Runtime(format!("{} cannot be written: {error}", path.display()))
    };
    if let Some(file) = &outputs.json {
        let mut opened = OpenOptions::new();
        opened.create(true).append(true);
        opened.open(file).map_err(|error| told(file, error))?;
    }
    for directory in [&outputs.report, &outputs.docs].into_iter().flatten() {
        std::fs::create_dir_all(directory).map_err(|error| told(directory, error))?;
    }
    Ok(())
}

/// Measures and prints, one section after another.
fn measured(
    outputs: &Outputs,
    [accuracy, speed]: [bool; 2],
    common: &Common,
) -> Result<Report, Failure> {
    let effort = Effort {
        quick: outputs.quick,
    };
    let adapter = choice(common.adapter);
    let bench = Bench::open(effort, adapter).map_err(failure)?;
    let mut report = Report {
        made_on: made_on(effort, bench.gpu.as_ref()),
        sections: Vec::new(),
    };
    for (name, value) in &report.made_on {
        line(&format!("{name}: {value}"))?;
    }
    if bench.gpu.is_none() {
        line("NOT RUN on any GPU: with --adapter none, no row says anything about the shaders.")?;
    }
    let mut take = |sections: Vec<Section>| {
        for section in sections {
            line("")?;
            line(text::section(&section).trim_end())?;
            report.sections.push(section);
        }
        Ok::<(), Failure>(())
    };
    if accuracy {
        for suite in accuracy::SUITES {
            take(vec![suite.run(&bench).map_err(failure)?])?;
        }
        take(vec![peer::run(effort)])?;
    }
    if speed {
        take(vec![speed::cpu_section(effort)])?;
        if let Some(adapter) = adapter {
            take(vec![speed::gpu_section(effort, adapter).map_err(failure)?])?;
        }
    }
    Ok(report)
}

fn choice(adapter: Adapter) -> Option<AdapterChoice> {
    match adapter {
        Adapter::Auto => Some(AdapterChoice::Auto),
        Adapter::Gpu => Some(AdapterChoice::Gpu),
        Adapter::Software => Some(AdapterChoice::Software),
        Adapter::None => None,
    }
}

fn failure(error: LabError) -> Failure {
    match error {
        LabError::Render(error) => Failure::Render(error),
        other => Failure::Runtime(other.to_string()),
    }
}

/// A failure that names the rows that missed their bar, if any did.
fn judged(report: &Report) -> Result<(), Failure> {
    let failed = report.failures();
    if failed.is_empty() {
        return Ok(());
    }
    let named: Vec<&str> = failed.iter().take(MOST_NAMED).map(String::as_str).collect();
    let more = match failed.len() - named.len() {
        0 => String::new(),
        n => format!(" and {n} more"),
    };
    Err(Failure::Runtime(format!(
        "{} of the laboratory's bars {} not met: {}{more}",
        failed.len(),
        if failed.len() == 1 { "is" } else { "are" },
        named.join("; ")
    )))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use super::*;
    use antipode_lab::{Cell, Table};

    fn report(verdicts: &[bool]) -> Report {
        let row = |met: &bool| vec![Cell::Text("port".into()), Cell::Verdict(*met)];
        Report {
            made_on: vec![],
            sections: vec![Section {
                id: "a".into(),
                title: "A".into(),
                method: vec![],
                tables: vec![Table {
                    title: "T".into(),
                    columns: vec!["What".into(), "Passed".into()],
                    rows: verdicts.iter().map(row).collect(),
                }],
                plots: vec![],
            }],
        }
    }

    #[test]
    fn a_bar_that_is_not_met_ends_the_program_with_status_one_and_one_sentence() {
        assert!(judged(&report(&[true, true])).is_ok());
        let failure = judged(&report(&[true, false])).unwrap_err();
        assert_eq!(failure.exit_status(), crate::cli::EXIT_FAILED);
        let words = failure.to_string();
        assert!(words.contains("port") && !words.contains('\n'), "{words}");
        let many = judged(&report(&[false; 9])).unwrap_err().to_string();
        assert!(
            many.starts_with("9 of the laboratory's bars are not met")
                && many.ends_with("and 5 more"),
            "{many}"
        );
    }

    #[test]
    fn no_adapter_is_a_choice_of_its_own() {
        assert_eq!(choice(Adapter::None), None);
        assert_eq!(choice(Adapter::Software), Some(AdapterChoice::Software));
    }
}
