//! `antipode saves`: looking after worlds from the command line.

use std::path::PathBuf;

use antipode_geometry::Geometry;
use antipode_storage::{RepairReport, VerifyReport, WorldSummary};
use clap::Subcommand;

use crate::common::Common;
use crate::confined;
use crate::failure::Failure;
use crate::output::line;
use crate::session::Worlds;

/// What can be done with saved worlds.
#[derive(Debug, Subcommand)]
pub enum SavesAction {
    /// Every world, newest first.
    List,
    /// One world's particulars.
    Info {
        /// The world's name.
        name: String,
    },
    /// Read everything in a world and say whether it is sound.
    Verify {
        /// The world's name.
        name: String,
    },
    /// Rescue what can be read of a damaged world; the damaged file is kept beside it.
    Repair {
        /// The world's name.
        name: String,
    },
    /// Delete a world for ever.
    Delete {
        /// The world's name.
        name: String,
    },
    /// Write a world into one file.
    Export {
        /// The world's name.
        name: String,
        /// The file to write.
        file: PathBuf,
    },
    /// Bring a world in from a file.
    Import {
        /// The file to read.
        file: PathBuf,
    },
    /// Work that the game gives to a process of its own.
    #[command(hide = true)]
    Confined {
        /// What to do.
        #[command(subcommand)]
        task: confined::Task,
    },
}

/// Does what was asked with the saved worlds.
///
/// # Errors
/// When the world is not there, is damaged, or the disk or standard output refuses.
pub fn run(action: &SavesAction, common: &Common) -> Result<(), Failure> {
    let worlds = Worlds::new(common);
    let saves = worlds.saves();
    let slug = |name: &str| saves.find(name).map(|summary| summary.slug);
    match action {
        SavesAction::List => worlds
            .list()?
            .iter()
            .try_for_each(|world| line(&row(world))),
        SavesAction::Info { name } => particulars(&saves.find(name)?)
            .iter()
            .try_for_each(|it| line(it)),
        SavesAction::Verify { name } => verified(name, &saves.verify(&slug(name)?)?),
        SavesAction::Repair { name } => repaired(&confined::repair(saves, &slug(name)?)?),
        SavesAction::Delete { name } => {
            saves.delete(&slug(name)?)?;
            line(&format!("\"{name}\" is deleted"))
        }
        SavesAction::Export { name, file } => {
            saves.export(&slug(name)?, file)?;
            line(&format!("\"{name}\" is written to {}", file.display()))
        }
        SavesAction::Import { file } => {
            let slug = confined::import(saves, file)?;
            line(&format!("The world is in {slug}"))
        }
        SavesAction::Confined { task } => confined::obey(saves, task),
    }
}

fn verified(name: &str, report: &VerifyReport) -> Result<(), Failure> {
    let state = if report.has_state {
        "the player's state and "
    } else {
        ""
    };
    line(&format!(
        "\"{}\": {state}{} changed chunks are whole",
        report.world, report.chunks
    ))?;
    for problem in &report.problems {
        line(&format!("  {problem}"))?;
    }
    if report.is_sound() {
        return Ok(());
    }
    Err(Failure::Runtime(format!(
        "\"{name}\" is damaged; `antipode saves repair` rescues what can be read"
    )))
}

fn repaired(report: &RepairReport) -> Result<(), Failure> {
    if report.kept.is_none() && report.losses.is_empty() {
        return line(&format!(
            "\"{}\" is sound; nothing was changed",
            report.world
        ));
    }
    line(&format!(
        "\"{}\": {} changed chunks rescued",
        report.world, report.chunks
    ))?;
    for loss in &report.losses {
        line(&format!("  {loss}"))?;
    }
    let Some(kept) = &report.kept else {
        return Ok(());
    };
    line(&format!("The damaged file is kept as {}", kept.display()))
}

fn row(world: &WorldSummary) -> String {
    let state = world.problem.as_deref().unwrap_or("sound");
    let geometry = world.meta.as_ref().map_or("?", |meta| &meta.geometry);
    let minutes = world
        .meta
        .as_ref()
        .map_or(0.0, |meta| (meta.played_s / 60.0).round());
    format!(
        "{:<40} {geometry:<11} {:>7.2} MB {minutes:>6} min  {state}",
        world.name(),
        world.size_bytes as f64 / 1e6
    )
}

fn particulars(world: &WorldSummary) -> Vec<String> {
    let mut lines = vec![
        format!("name      {}", world.name()),
        format!("directory {}", world.slug),
    ];
    if let Some(meta) = &world.meta {
        lines.push(format!("space     {}", meta.geometry));
        if !meta.biome.is_empty() {
            lines.push(format!("biome     {}", meta.biome));
        }
        lines.push(format!("generator {}", meta.generator));
        if meta.gathering {
            lines.push("mode      gathering".to_owned());
        }
        lines.push(format!("seed      {}", meta.seed));
        let space = meta.geometry.parse::<Geometry>();
        if space.is_ok_and(|it| it.radii().chosen_m.is_some()) {
            lines.push(format!("radius    {} m", meta.radius_m));
        }
        lines.push(format!("played    {:.1} min", meta.played_s / 60.0));
        if meta.cheated {
            lines.push("cheats    used".to_owned());
        }
    }
    lines.push(format!("size      {:.2} MB", world.size_bytes as f64 / 1e6));
    if let Some(problem) = &world.problem {
        lines.push(format!("problem   {problem}"));
    }
    lines
}
