//! Worlds and rooms from files: one is named, chosen from those found, or dropped on the window.

use antipode_language::Texts;
use egui::Ui;

use super::field::{line, note};
use super::{FolderRow, Kind, WorldsIntent};
use crate::layout::{Stops, pane, steady};
use crate::shell::Pass;
use crate::theme::{BAD, WEAK};
use crate::widgets::{button, column_button, primary_button};

/// The form for a world from a file, with the file as typed.
#[derive(Default)]
pub(super) struct Form {
    file: String,
}

impl Form {
    /// Draws the form; true when it is done with.
    pub(super) fn show(&mut self, ui: &mut Ui, pass: &mut Pass<'_>, kind: Kind) -> bool {
        let texts = pass.model.texts;
        let files = kind.files(pass.model);
        let regions = pass.regions;
        let typed = !self.file.trim().is_empty();
        let (mut wanted, mut looks_in) = (None, None);
        let body = |ui: &mut Ui, stops: &mut Stops| {
            let label = ui.label(texts.say("worlds-file"));
            let field = line(ui, &mut self.file).labelled_by(label.id);
            stops.add(&field);
            pass.offer_focus(&field);
            note(ui, &kind.say(texts, "import-hint"), WEAK);
            let found = if files.archives.is_empty() {
                "found-none"
            } else {
                "found"
            };
            let found = kind.say_with(texts, found, &[("dir", files.dir.as_str().into())]);
            match &files.problem {
                Some(problem) => note(ui, problem, BAD),
                None => note(ui, &found, WEAK),
            }
            for archive in &files.archives {
                let values = [
                    ("name", archive.name.as_str().into()),
                    ("size", archive.size.as_str().into()),
                ];
                let label = texts.say_with("worlds-import-named", &values);
                let response = steady(ui, &archive.file, |ui| column_button(ui, &label, false));
                stops.add(&response);
                if response.clicked() {
                    wanted = Some(archive.file.clone());
                }
            }
            looks_in = folders(ui, stops, texts, &files.folders);
            field
        };
        let (mut accept, mut back) = (false, false);
        let field = pane(
            ui,
            regions.pane,
            &kind.say(texts, "import-title"),
            body,
            |ui| {
                accept = primary_button(ui, &texts.say("worlds-import-do"), typed).clicked();
                back = button(ui, &texts.say("back")).clicked();
            },
        );
        pass.intents.extend(looks_in.map(|it| kind.ask(it)));
        let in_use = field.has_focus() || field.lost_focus();
        accept |= typed && in_use && ui.input(|input| input.key_pressed(egui::Key::Enter));
        if accept {
            wanted = Some(self.file.trim().to_owned());
        }
        let done = back || wanted.is_some();
        if let Some(file) = wanted {
            pass.intents.push(kind.ask(WorldsIntent::Import { file }));
        }
        done
    }
}

/// Lines for the folders that lie about; the one that was clicked, as what it asks for.
pub(super) fn folders(
    ui: &mut Ui,
    stops: &mut Stops,
    texts: &Texts,
    folders: &[FolderRow],
) -> Option<WorldsIntent> {
    let mut asked = None;
    for folder in folders {
        let label = match &folder.name {
            Some(name) => texts.say_with("worlds-folder-named", &[("name", name.as_str().into())]),
            None => texts.say("worlds-folder-above"),
        };
        let response = steady(ui, &folder.path, |ui| column_button(ui, &label, false));
        stops.add(&response);
        if response.clicked() {
            let folder = folder.path.clone();
            asked = Some(WorldsIntent::FindIn { folder });
        }
    }
    asked
}

/// Takes in files that were dropped on the window.
pub(super) fn take_dropped(ui: &Ui, pass: &mut Pass<'_>, kind: Kind) {
    let dropped = ui.input(|input| input.raw.dropped_files.clone());
    for dropped in dropped {
        let file = dropped.path().to_string_lossy().into_owned();
        pass.intents.push(kind.ask(WorldsIntent::Import { file }));
    }
}
