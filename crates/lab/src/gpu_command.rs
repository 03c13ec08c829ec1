//! `antipode-lab gpu`: measures a graphics card, and leaves one JSON and one page to be sent.

use std::io::Write;
use std::path::PathBuf;

use antipode_lab::gpu::{self, News, Plan};
use antipode_lab::{Effort, LabError, text};
use antipode_render::AdapterChoice;
use clap::Args;

use crate::command::{Adapter, judged, lines, unwritable};

/// What can be asked of it.
#[derive(Clone, Debug, Args)]
pub struct GpuArguments {
    /// Where report.json and index.html go.
    #[arg(long, value_name = "DIR", default_value = "gpu-report")]
    out: PathBuf,
    /// The game, for the image suite [default: beside this program].
    #[arg(long, value_name = "FILE")]
    game: Option<PathBuf>,
    /// The image suite's scripts and pictures [default: the folder `scenes` beside this program].
    #[arg(long, value_name = "DIR")]
    scenes: Option<PathBuf>,
    /// Small pictures and few frames, to see that everything runs.
    #[arg(long)]
    quick: bool,
}

/// Measures, tells on the way, and writes the report, also where not all could be measured.
///
/// # Errors
/// When something could not be measured, a bar is not met, or a file or standard output cannot be written.
pub fn run(arguments: &GpuArguments, adapter: Option<Adapter>) -> Result<(), LabError> {
    let out = &arguments.out;
    std::fs::create_dir_all(out).map_err(|source| unwritable(out, source))?;
    let outcome = gpu::run(&plan(arguments, adapter)?, &mut told)?;
    let json = out.join("report.json");
    outcome.report.write_json(&json)?;
    outcome.report.write_page(out)?;
    let [json, page] = [json, out.join("index.html")];
    let files = format!("\nWritten: {} and {}", json.display(), page.display());
    lines(&files)?;
    match outcome.lacks.len() {
        0 => judged(&outcome.report),
        1 => Err(LabError::Failed(outcome.lacks.concat())),
        n => Err(LabError::Failed(format!(
            "{n} things could not be measured; the first: {}",
            outcome.lacks[0]
        ))),
    }
}

/// What is to be measured. Nothing but a graphics card will do unless another adapter is asked for.
fn plan(arguments: &GpuArguments, adapter: Option<Adapter>) -> Result<Plan, LabError> {
    let adapter = adapter.unwrap_or(Adapter::Gpu);
    let adapter: AdapterChoice = adapter.chosen().ok_or_else(|| {
        let words = "With --adapter none there is no graphics card to measure; leave it out.";
        LabError::Failed(words.to_owned())
    })?;
    let ours = std::env::current_exe().unwrap_or_default();
    let [game, scenes] = gpu::beside(&ours);
    Ok(Plan {
        effort: Effort {
            quick: arguments.quick,
        },
        adapter,
        game: absolute(arguments.game.clone().unwrap_or(game)),
        scenes: absolute(arguments.scenes.clone().unwrap_or(scenes)),
    })
}

/// The game is run in another folder, from where a relative path leads elsewhere.
fn absolute(path: PathBuf) -> PathBuf {
    std::path::absolute(&path).unwrap_or(path)
}

/// Sections and the head go to standard output, what is to be known and what is done now to standard error.
fn told(news: News<'_>) -> Result<(), LabError> {
    let complain = |text: &str| {
        // A closed standard error is no reason to stop: the report says it, too.
        let _ = writeln!(std::io::stderr().lock(), "antipode-lab: {text}");
        Ok(())
    };
    match news {
        News::Head(head) => head
            .iter()
            .try_for_each(|(name, value)| lines(&format!("{name}: {value}"))),
        News::Warning(words) => complain(words),
        News::Begun(what) => complain(&format!("now: {what}")),
        News::Done(section) => {
            lines("")?;
            lines(text::section(section).trim_end())
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use super::*;

    fn asked() -> GpuArguments {
        GpuArguments {
            out: PathBuf::from("out"),
            game: None,
            scenes: None,
            quick: true,
        }
    }

    #[test]
    fn nothing_but_a_card_will_do_unless_another_adapter_is_asked_for() {
        let chosen = |adapter| plan(&asked(), adapter).map(|it| it.adapter);
        assert_eq!(chosen(None).unwrap(), AdapterChoice::Gpu);
        let software = chosen(Some(Adapter::Software)).unwrap();
        assert_eq!(software, AdapterChoice::Software);
        let none = chosen(Some(Adapter::None)).unwrap_err().to_string();
        assert!(none.contains("--adapter none"), "{none}");
    }

    #[test]
    fn the_game_and_the_scenes_are_looked_for_beside_the_program() {
        let plan = plan(&asked(), None).unwrap();
        let ours = std::env::current_exe().unwrap();
        assert_eq!(plan.game.parent(), ours.parent());
        assert_eq!(plan.scenes, ours.parent().unwrap().join("scenes"));
        let named = GpuArguments {
            game: Some(PathBuf::from("elsewhere/antipode")),
            ..asked()
        };
        let named = super::plan(&named, None).unwrap().game;
        assert!(named.is_absolute() && named.ends_with("elsewhere/antipode"));
    }
}
