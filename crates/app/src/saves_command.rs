//! `antipode saves`: looking after worlds from the command line.

use antipode_geometry::Geometry;
use antipode_storage::{RepairReport, VerifyReport, WorldSummary};

use crate::cli::{Common, SavesAction};
use crate::confined;
use crate::failure::Failure;
use crate::output::line;
use crate::session::Worlds;

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
        lines.push(format!("biome     {}", meta.biome));
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
