//! Worlds and rooms from files: one is named, chosen from those found, or dropped on the window.

use egui::{RichText, Ui};

use super::field::{line, note};
use super::{Kind, WorldsIntent};
use crate::layout::{Stops, pane, steady};
use crate::shell::Pass;
use crate::theme::{WEAK, small};
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
        let mut wanted = None;
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
            ui.add(egui::Label::new(RichText::new(found).font(small()).color(WEAK)).wrap());
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

/// Takes in files that were dropped on the window.
pub(super) fn take_dropped(ui: &Ui, pass: &mut Pass<'_>, kind: Kind) {
    let dropped = ui.input(|input| input.raw.dropped_files.clone());
    for dropped in dropped {
        let file = dropped.path().to_string_lossy().into_owned();
        pass.intents.push(kind.ask(WorldsIntent::Import { file }));
    }
}
