//! The settings screen, generated from the table of settings: a search, every value with what it means, and a way
//! back to its default.

mod control;
mod row;
mod search;

use antipode_settings::{Group, fields};
use egui::{RichText, Ui};

use crate::entry::entry;
use crate::layout::{Stops, long_pane};
use crate::model::Screen;
use crate::shell::Pass;
use crate::theme::{ACCENT, GRID, WEAK};
use crate::widgets::button;

/// What is up on the screen beside the settings themselves.
#[derive(Default)]
pub(crate) struct SettingsScreen {
    search: String,
    /// What the search meant when it was typed, by id. It stays until another is typed: changing the language must not
    /// take away the row it is changed in because its words are others now.
    found: Vec<&'static str>,
    /// A slider on its way that is applied when it is let go: field and value.
    held: Option<(&'static str, f64)>,
}

impl SettingsScreen {
    /// Esc: clears the search first; false if there is none.
    pub(crate) fn back(&mut self) -> bool {
        let searched = !self.search.is_empty();
        self.search.clear();
        searched
    }

    /// Draws the screen.
    pub(crate) fn show(&mut self, ui: &mut Ui, pass: &mut Pass<'_>) {
        let regions = pass.regions;
        let texts = pass.model.texts;
        let mut back = false;
        let body = |ui: &mut Ui, stops: &mut Stops| {
            let hint = texts.say("settings-search");
            let search = entry(ui, &mut self.search, &hint, &hint);
            stops.add(&search);
            pass.offer_focus(&search);
            if search.changed() {
                self.found = search::found(texts, &self.search);
            }
            self.groups(ui, pass, stops);
        };
        let title = texts.say("menu-settings");
        long_pane(ui, regions.pane, &title, body, |ui| {
            back = button(ui, &texts.say("back")).clicked();
        });
        if back {
            pass.go = Some(Screen::Main);
        }
    }

    fn groups(&mut self, ui: &mut Ui, pass: &mut Pass<'_>, stops: &mut Stops) {
        let texts = pass.model.texts;
        let all = self.search.trim().is_empty();
        let mut found = false;
        for group in Group::ALL {
            let of_group = fields().iter().filter(|field| field.group == group);
            let matching: Vec<_> = of_group
                .filter(|field| all || self.found.contains(&field.id))
                .collect();
            if matching.is_empty() {
                continue;
            }
            ui.add_space(if found { GRID } else { 0.0 });
            found = true;
            ui.label(RichText::new(texts.say(group.id())).color(ACCENT));
            if let (Group::Sound, Some(notice)) = (group, pass.model.sound_notice) {
                ui.add(egui::Label::new(RichText::new(notice).color(WEAK)).wrap());
            }
            for field in matching {
                row::show(ui, pass, stops, field, &mut self.held);
            }
        }
        if !found {
            let values = [("words", self.search.trim().into())];
            let nothing = texts.say_with("settings-nothing-found", &values);
            ui.add(egui::Label::new(RichText::new(nothing).color(WEAK)).wrap());
        }
    }
}
