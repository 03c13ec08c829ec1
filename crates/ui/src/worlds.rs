//! The Load and Delete screens: every world as a row, newest first.

use egui::Ui;

use crate::layout::{Stops, pane};
use crate::model::{Intent, Screen, WorldRow};
use crate::shell::Pass;
use crate::widgets::{button, world_row};

/// Why the world being played cannot be deleted.
const RUNNING: &str = "This world is running. Save and quit to the menu first, then delete it.";

/// Draws the list of worlds to load.
pub(crate) fn load(ui: &mut Ui, pass: &mut Pass<'_>) {
    let Some(row) = list(ui, pass, "Load", load_remark) else {
        return;
    };
    if row.running {
        pass.intents.push(Intent::Resume);
    } else if let Some(problem) = &row.problem {
        let title = format!("“{}” cannot be loaded", row.name);
        pass.go = Some(Screen::Message {
            title,
            text: problem.clone(),
        });
    } else {
        pass.intents.push(Intent::Load {
            slug: row.slug.clone(),
        });
    }
}

/// Draws the list of worlds to delete; returns the slug and name of the one
/// whose deletion should be asked about.
pub(crate) fn delete(ui: &mut Ui, pass: &mut Pass<'_>) -> Option<(String, String)> {
    let row = list(ui, pass, "Delete", delete_remark)?;
    if row.running {
        let title = format!("“{}” cannot be deleted now", row.name);
        pass.go = Some(Screen::Message {
            title,
            text: RUNNING.to_owned(),
        });
        return None;
    }
    Some((row.slug.clone(), row.name.clone()))
}

/// A line under a row, and whether it tells of something bad.
type Remark<'a> = (Option<&'a str>, bool);

fn load_remark(row: &WorldRow) -> Remark<'_> {
    match &row.problem {
        _ if row.running => (Some("Running now"), false),
        Some(problem) => (Some(problem), true),
        None => (None, false),
    }
}

fn delete_remark(row: &WorldRow) -> Remark<'_> {
    if row.running {
        (Some(RUNNING), true)
    } else {
        load_remark(row)
    }
}

/// The list itself; returns the row that was chosen.
fn list<'a>(
    ui: &mut Ui,
    pass: &mut Pass<'a>,
    verb: &str,
    remark: fn(&WorldRow) -> Remark<'_>,
) -> Option<&'a WorldRow> {
    let worlds = pass.model.worlds;
    let regions = pass.regions;
    let mut chosen = None;
    let mut back = None;
    let body = |ui: &mut Ui, stops: &mut Stops| {
        if worlds.is_empty() {
            ui.label("There are no worlds yet. New Game makes one.");
        }
        for row in worlds {
            let (words, bad) = remark(row);
            let response = ui
                .push_id(&row.slug, |ui| world_row(ui, row, verb, words, bad))
                .inner;
            stops.add(&response);
            pass.offer_focus(&response);
            if response.clicked() {
                chosen = Some(row);
            }
        }
    };
    pane(ui, regions.pane, verb, body, |ui| {
        back = Some(button(ui, "Back"));
    });
    if let Some(back) = back {
        if worlds.is_empty() {
            pass.offer_focus(&back);
        }
        if back.clicked() {
            pass.go = Some(Screen::Main);
        }
    }
    chosen
}
