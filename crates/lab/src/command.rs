//! The command line of the laboratory: prints tables, writes reports, and fails where a bar is not met.

use std::fs::OpenOptions;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use antipode_lab::accuracy::{self, Bench};
use antipode_lab::terrain::{self, Logs};
use antipode_lab::{Effort, LabError, Report, Section, made_on, peer, speed, text};
use antipode_render::AdapterChoice;
use clap::{Args, Parser, Subcommand, ValueEnum};

use crate::gpu_command::{self, GpuArguments};

/// Most failed rows that are named on standard error; the tables have them all.
const MOST_NAMED: usize = 4;

/// Measures how exact and how fast Antipode is.
#[derive(Debug, Parser)]
#[command(name = "antipode-lab", version)]
pub struct Cli {
    /// What to measure.
    #[command(subcommand)]
    action: Action,
    /// What computes and draws [default: auto, and gpu where a graphics card is measured].
    #[arg(long, global = true, value_enum)]
    adapter: Option<Adapter>,
}

/// What computes and draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Adapter {
    /// A graphics card if there is one, else software.
    Auto,
    /// A graphics card, or fail.
    Gpu,
    /// Software rendering.
    Software,
    /// Nothing: what needs an adapter is left out.
    None,
}

impl Adapter {
    /// The renderer's choice; nothing where nothing is to be drawn.
    pub fn chosen(self) -> Option<AdapterChoice> {
        match self {
            Self::Auto => Some(AdapterChoice::Auto),
            Self::Gpu => Some(AdapterChoice::Gpu),
            Self::Software => Some(AdapterChoice::Software),
            Self::None => None,
        }
    }
}

/// What the laboratory can be asked for.
#[derive(Debug, Subcommand)]
enum Action {
    /// Every formula at its extremes: processor and adapter, ours beside the textbook's.
    Accuracy(Outputs),
    /// What each formula and each choice costs, beside its error.
    Speed(Outputs),
    /// Accuracy and speed.
    Exactness(Outputs),
    /// How fast ground is made, loaded, changed and kept, beside other programs.
    Terrain {
        /// What is left behind.
        #[command(flatten)]
        outputs: Outputs,
        /// Write the flight's log, one line a frame, as CSV.
        #[arg(long, value_name = "FILE")]
        frame_log: Option<PathBuf>,
    },
    /// What only a graphics card can tell, in five minutes: one JSON and one page, to be sent.
    Gpu(GpuArguments),
    /// All of it but the graphics card.
    All(Outputs),
    /// Make the documents from a report, without measuring.
    Docs {
        /// The report to read.
        #[arg(long, value_name = "FILE")]
        json: PathBuf,
        /// Where the documents and their plots go.
        #[arg(long, value_name = "DIR")]
        docs: PathBuf,
    },
}

/// What a measurement leaves behind, besides the tables on standard output.
#[derive(Clone, Debug, Args)]
struct Outputs {
    /// Write the report as JSON.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Write the report as a page, DIR/index.html.
    #[arg(long, value_name = "DIR")]
    report: Option<PathBuf>,
    /// Write the report as documents with plots, DIR/accuracy.md and DIR/terrain.md.
    #[arg(long, value_name = "DIR")]
    docs: Option<PathBuf>,
    /// Fewer inputs and shorter runs, in under a minute.
    #[arg(long)]
    quick: bool,
}

/// Which parts of the laboratory are to run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Wanted {
    accuracy: bool,
    speed: bool,
    terrain: bool,
}

impl Action {
    /// What is to be measured and what comes of it; nothing where others see to it.
    fn measurement(&self) -> Option<(Wanted, &Outputs)> {
        let none = Wanted::default();
        let exactness = Wanted {
            accuracy: true,
            speed: true,
            ..none
        };
        let all = Wanted {
            terrain: true,
            ..exactness
        };
        Some(match self {
            Self::Accuracy(outputs) => (
                Wanted {
                    accuracy: true,
                    ..none
                },
                outputs,
            ),
            Self::Speed(outputs) => (
                Wanted {
                    speed: true,
                    ..none
                },
                outputs,
            ),
            Self::Exactness(outputs) => (exactness, outputs),
            Self::Terrain { outputs, .. } => (
                Wanted {
                    terrain: true,
                    ..none
                },
                outputs,
            ),
            Self::All(outputs) => (all, outputs),
            Self::Docs { .. } | Self::Gpu(_) => return None,
        })
    }

    fn frame_log(&self) -> Option<&Path> {
        match self {
            Self::Terrain { frame_log, .. } => frame_log.as_deref(),
            _ => None,
        }
    }
}

/// Does what was asked for.
///
/// # Errors
/// When a bar is not met, the adapter fails, or a file or standard output cannot be written.
pub fn run(cli: &Cli) -> Result<(), LabError> {
    let action = &cli.action;
    if let Action::Docs { json, docs } = action {
        return Report::read(json)?.write_docs(docs);
    }
    if let Action::Gpu(arguments) = action {
        return gpu_command::run(arguments, cli.adapter);
    }
    let Some((wanted, outputs)) = action.measurement() else {
        return Ok(());
    };
    let frame_log = action.frame_log();
    writable(outputs, frame_log)?;
    let mut logs = Logs::default();
    let adapter = cli.adapter.unwrap_or(Adapter::Auto);
    let report = measured(outputs, wanted, adapter, &mut logs)?;
    if let Some(file) = frame_log {
        std::fs::write(file, &logs.flight).map_err(|source| unwritable(file, source))?;
    }
    if let Some(file) = &outputs.json {
        report.write_json(file)?;
    }
    if let Some(directory) = &outputs.report {
        report.write_page(directory)?;
    }
    if let Some(directory) = &outputs.docs {
        report.write_docs(directory)?;
    }
    judged(&report)
}

/// The failure to write there.
pub fn unwritable(path: &Path, source: io::Error) -> LabError {
    let path = path.to_owned();
    LabError::Write { path, source }
}

/// Prints lines on standard output.
///
/// # Errors
/// When it is full or closed.
pub fn lines(text: &str) -> Result<(), LabError> {
    let mut out = io::stdout().lock();
    writeln!(out, "{text}")
        .and_then(|()| out.flush())
        .map_err(LabError::Output)
}

/// Looks before minutes of measuring whether what comes of it can be written.
fn writable(outputs: &Outputs, frame_log: Option<&Path>) -> Result<(), LabError> {
    for file in [outputs.json.as_deref(), frame_log].into_iter().flatten() {
        let mut opened = OpenOptions::new();
        opened.create(true).append(true);
        opened
            .open(file)
            .map_err(|source| unwritable(file, source))?;
    }
    for directory in [&outputs.report, &outputs.docs].into_iter().flatten() {
        std::fs::create_dir_all(directory).map_err(|source| unwritable(directory, source))?;
    }
    Ok(())
}

/// Measures and prints, one section after another.
fn measured(
    outputs: &Outputs,
    wanted: Wanted,
    adapter: Adapter,
    logs: &mut Logs,
) -> Result<Report, LabError> {
    let effort = Effort {
        quick: outputs.quick,
    };
    let adapter = adapter.chosen();
    let bench = Bench::open(effort, adapter)?;
    let mut report = Report {
        made_on: made_on(effort, bench.gpu.as_ref()),
        sections: Vec::new(),
    };
    for (name, value) in &report.made_on {
        lines(&format!("{name}: {value}"))?;
    }
    if bench.gpu.is_none() {
        lines("NOT RUN on any GPU: with --adapter none, no row says anything about the shaders.")?;
    }
    let mut take = |section: Section| {
        lines("")?;
        lines(text::section(&section).trim_end())?;
        report.sections.push(section);
        Ok::<(), LabError>(())
    };
    if wanted.accuracy {
        for suite in accuracy::SUITES {
            take(suite.run(&bench)?)?;
        }
        take(peer::run(effort))?;
    }
    if wanted.speed {
        take(speed::cpu_section(effort))?;
        if let Some(adapter) = adapter {
            take(speed::gpu_section(effort, adapter)?)?;
        }
    }
    if wanted.terrain {
        for suite in terrain::SUITES {
            take(suite(effort, bench.gpu.as_ref(), logs)?)?;
        }
    }
    Ok(report)
}

/// A failure that names the rows that missed their bar, if any did.
///
/// # Errors
/// That failure.
pub fn judged(report: &Report) -> Result<(), LabError> {
    let failed = report.failures();
    if failed.is_empty() {
        return Ok(());
    }
    let named: Vec<&str> = failed.iter().take(MOST_NAMED).map(String::as_str).collect();
    let more = match failed.len() - named.len() {
        0 => String::new(),
        n => format!(" and {n} more"),
    };
    Err(LabError::Failed(format!(
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
                pictures: vec![],
            }],
        }
    }

    #[test]
    fn a_bar_that_is_not_met_is_a_failure_in_one_sentence() {
        assert!(judged(&report(&[true, true])).is_ok());
        let failure = judged(&report(&[true, false])).unwrap_err();
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
    fn every_word_asks_for_its_own_suites_and_the_last_for_all() {
        let wanted = |word: &str| {
            let cli = Cli::try_parse_from(["antipode-lab", word, "--quick"]).unwrap();
            let (wanted, outputs) = cli.action.measurement().unwrap();
            assert!(outputs.quick);
            [wanted.accuracy, wanted.speed, wanted.terrain]
        };
        assert_eq!(wanted("accuracy"), [true, false, false]);
        assert_eq!(wanted("speed"), [false, true, false]);
        assert_eq!(wanted("terrain"), [false, false, true]);
        assert_eq!(wanted("exactness"), [true, true, false]);
        assert_eq!(wanted("all"), [true; 3]);
    }

    #[test]
    fn no_adapter_is_a_choice_of_its_own() {
        assert_eq!(Adapter::None.chosen(), None);
        assert_eq!(Adapter::Software.chosen(), Some(AdapterChoice::Software));
    }
}
