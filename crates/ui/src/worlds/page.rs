//! The page of one world or room: what it is, and what can be done with it.

use std::path::Path;

use egui::{Id, Label, Response, RichText, Sense, Ui};

use super::field::{line, note};
use super::{Kind, WorldsIntent, edits, enter, facts, import, picture};
use crate::layout::{Stops, pane, steady};
use crate::legible::is_partly_shown;
use crate::model::WorldRow;
use crate::shell::Pass;
use crate::theme::{BAD, GOOD, GRID, WEAK, small};
use crate::widgets::{button, focus_ring, primary_button};

/// Height of the picture where there is room, in points.
const PICTURE_HEIGHT: f32 = 144.0;

/// The page of one world.
pub(super) struct Page {
    slug: String,
    mode: Mode,
}

/// What the page is for just now.
enum Mode {
    Overview,
    /// With the new name as typed.
    Rename(String),
    /// With the file as typed.
    Export(String),
}

/// Where a frame of the page leads.
pub(super) enum Turn {
    Stay,
    /// Another part of the page is up from the next frame on.
    Redraw,
    Delete,
    Back,
}

/// What a button of the overview does.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Action {
    Load,
    Rename,
    Duplicate,
    Export,
    OpenFolder,
    Delete,
}

impl Action {
    const ALL: [(Self, &'static str); 6] = [
        (Self::Load, "worlds-load"),
        (Self::Rename, "worlds-rename"),
        (Self::Duplicate, "worlds-duplicate"),
        (Self::Export, "worlds-export"),
        (Self::OpenFolder, "worlds-open-folder"),
        (Self::Delete, "worlds-delete"),
    ];

    /// Whether it can be done: not all to what is played just now, nor to what comes with the game.
    fn is_for(self, row: &WorldRow) -> bool {
        let spares_the_store = matches!(self, Self::Load | Self::OpenFolder);
        let spares_the_place = matches!(self, Self::Load | Self::Duplicate | Self::Export);
        (!row.running || row.shipped || spares_the_store) && (!row.shipped || spares_the_place)
    }
}

/// What was pressed under a form.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Pressed {
    Nothing,
    Do,
    Cancel,
}

impl Page {
    pub(super) fn new(slug: &str) -> Self {
        Self {
            slug: slug.to_owned(),
            mode: Mode::Overview,
        }
    }

    pub(super) fn slug(&self) -> &str {
        &self.slug
    }

    /// The part of the page that is up, as a name that it bears every time.
    pub(super) fn place(&self) -> Id {
        Id::unique((&self.slug, std::mem::discriminant(&self.mode)))
    }

    /// Esc: from a form to the overview; false if that is up already.
    pub(super) fn back(&mut self) -> bool {
        let in_form = !matches!(self.mode, Mode::Overview);
        self.mode = Mode::Overview;
        in_form
    }

    pub(super) fn show(
        &mut self,
        ui: &mut Ui,
        pass: &mut Pass<'_>,
        kind: Kind,
        row: &WorldRow,
    ) -> Turn {
        match &mut self.mode {
            Mode::Overview => self.overview(ui, pass, kind, row),
            Mode::Rename(name) => {
                let valid = if name.trim() == row.full_name {
                    Ok(())
                } else {
                    kind.check_rename(pass.model, &row.slug, name.trim())
                };
                let pressed = rename_form(ui, pass, row, name, &valid);
                if pressed == Pressed::Do && name.trim() != row.full_name {
                    pass.intents.push(kind.ask(WorldsIntent::Rename {
                        slug: row.slug.clone(),
                        name: name.trim().to_owned(),
                    }));
                }
                self.leave_form(pressed)
            }
            Mode::Export(file) => {
                let pressed = export_form(ui, pass, kind, row, file);
                if pressed == Pressed::Do {
                    pass.intents.push(kind.ask(WorldsIntent::Export {
                        slug: row.slug.clone(),
                        file: file.trim().to_owned(),
                    }));
                }
                self.leave_form(pressed)
            }
        }
    }

    fn leave_form(&mut self, pressed: Pressed) -> Turn {
        if pressed == Pressed::Nothing {
            return Turn::Stay;
        }
        self.mode = Mode::Overview;
        Turn::Redraw
    }

    fn overview(&mut self, ui: &mut Ui, pass: &mut Pass<'_>, kind: Kind, row: &WorldRow) -> Turn {
        let regions = pass.regions;
        let texts = pass.model.texts;
        let mut pressed = None;
        let body = |ui: &mut Ui, stops: &mut Stops| {
            if !regions.compact {
                let height = PICTURE_HEIGHT.min(ui.available_width() / picture::ASPECT);
                let (rect, _) = ui.allocate_exact_size(picture::size(height), Sense::hover());
                picture::paint(ui.painter(), rect, kind, row);
            }
            particulars(ui, pass, kind, row);
            pressed = steady(ui, "actions", |ui| actions(ui, pass, stops, (kind, row)));
        };
        let mut back = false;
        pane(ui, regions.pane, &row.name, body, |ui| {
            back = button(ui, &texts.say("back")).clicked();
        });
        match pressed {
            Some(action) => self.follow(action, pass, kind, row),
            None if back => Turn::Back,
            None => Turn::Stay,
        }
    }

    fn follow(&mut self, action: Action, pass: &mut Pass<'_>, kind: Kind, row: &WorldRow) -> Turn {
        let slug = row.slug.clone();
        let ask = |pass: &mut Pass<'_>, intent| pass.intents.push(kind.ask(intent));
        match action {
            Action::Load => enter(pass, kind, row),
            Action::Duplicate => ask(pass, WorldsIntent::Duplicate { slug }),
            Action::OpenFolder => ask(pass, WorldsIntent::OpenFolder { slug }),
            Action::Rename => {
                self.mode = Mode::Rename(row.full_name.clone());
                return Turn::Redraw;
            }
            Action::Export => {
                self.mode = Mode::Export(row.export_to.clone());
                ask(pass, look_about(&row.export_to));
                return Turn::Redraw;
            }
            Action::Delete => return Turn::Delete,
        }
        Turn::Stay
    }
}

/// What there is to know of it, in words.
fn particulars(ui: &mut Ui, pass: &Pass<'_>, kind: Kind, row: &WorldRow) {
    let weak = |text: String| Label::new(RichText::new(text).font(small()).color(WEAK)).wrap();
    ui.add(weak(facts(pass, row)));
    ui.add(weak(edits(pass, kind, row)));
    if row.shipped {
        ui.add(weak(pass.model.texts.say("rooms-shipped")));
    } else {
        ui.add(weak(row.path.clone()));
    }
    let problem = match &row.problem {
        _ if row.running && !row.shipped => Some(kind.say(pass.model.texts, "running-no-change")),
        problem => problem.clone(),
    };
    if let Some(problem) = problem {
        ui.add(Label::new(RichText::new(problem).font(small()).color(BAD)).wrap());
    }
    if let Some(work) = &kind.files(pass.model).work {
        ui.add(weak(work.clone()));
    }
}

/// The buttons, side by side as far as there is room; which was pressed.
fn actions(
    ui: &mut Ui,
    pass: &mut Pass<'_>,
    stops: &mut Stops,
    (kind, row): (Kind, &WorldRow),
) -> Option<Action> {
    let mut pressed = None;
    ui.horizontal_wrapped(|ui| {
        for (action, key) in Action::ALL {
            let label = match action {
                Action::Load => kind.say(pass.model.texts, "load"),
                _ => pass.model.texts.say(key),
            };
            let mut text = RichText::new(label);
            if action == Action::Delete {
                text = text.color(BAD);
            }
            let enabled = action.is_for(row);
            let response = ui.add_enabled(enabled, egui::Button::new(text));
            focus_ring(ui, &response);
            if enabled {
                stops.add(&response);
                pass.offer_focus(&response);
            }
            if response.clicked() {
                pressed = Some(action);
            }
        }
    });
    pressed
}

fn rename_form(
    ui: &mut Ui,
    pass: &mut Pass<'_>,
    row: &WorldRow,
    name: &mut String,
    valid: &Result<(), String>,
) -> Pressed {
    let texts = pass.model.texts;
    let title = texts.say_with("worlds-rename-title", &[("name", row.name.as_str().into())]);
    form(
        ui,
        pass,
        &title,
        &texts.say("worlds-rename"),
        valid.is_ok(),
        |ui, pass, stops| {
            let label = ui.label(texts.say("worlds-new-name"));
            let field = line(ui, name).labelled_by(label.id);
            stops.add(&field);
            pass.offer_focus(&field);
            match valid {
                Ok(()) if is_partly_shown(name) => note(ui, &texts.say("name-not-shown"), WEAK),
                Ok(()) => note(ui, &texts.say("worlds-name-free"), GOOD),
                Err(reason) => note(ui, reason, BAD),
            }
            field
        },
    )
}

fn export_form(
    ui: &mut Ui,
    pass: &mut Pass<'_>,
    kind: Kind,
    row: &WorldRow,
    file: &mut String,
) -> Pressed {
    let texts = pass.model.texts;
    let title = texts.say_with("worlds-export-title", &[("name", row.name.as_str().into())]);
    let enabled = !file.trim().is_empty();
    form(
        ui,
        pass,
        &title,
        &texts.say("worlds-export"),
        enabled,
        |ui, pass, stops| {
            let label = ui.label(texts.say("worlds-file"));
            let field = line(ui, file).labelled_by(label.id);
            stops.add(&field);
            pass.offer_focus(&field);
            note(ui, &kind.say(texts, "export-hint"), WEAK);
            let files = kind.files(pass.model);
            let values = [("dir", files.dir.as_str().into())];
            match &files.problem {
                Some(problem) => note(ui, problem, BAD),
                None => note(ui, &texts.say_with("worlds-export-folders", &values), WEAK),
            }
            if let Some(asked) = import::folders(ui, stops, texts, &files.folders) {
                if let WorldsIntent::FindIn { folder } = &asked {
                    *file = in_folder(folder, file);
                }
                pass.intents.push(kind.ask(asked));
            }
            field
        },
    )
}

/// Asks what is in the folder of a file that an export goes to.
fn look_about(file: &str) -> WorldsIntent {
    let folder = Path::new(file).parent().filter(|it| it.is_absolute());
    folder.map_or(WorldsIntent::FindArchives, |folder| WorldsIntent::FindIn {
        folder: folder.display().to_string(),
    })
}

/// The same file in another folder.
fn in_folder(folder: &str, file: &str) -> String {
    let name = Path::new(file.trim()).file_name().unwrap_or_default();
    Path::new(folder).join(name).display().to_string()
}

/// A pane with one line of text to fill in, which Enter and the first button accept.
fn form(
    ui: &mut Ui,
    pass: &mut Pass<'_>,
    title: &str,
    accept: &str,
    enabled: bool,
    field: impl FnOnce(&mut Ui, &mut Pass<'_>, &mut Stops) -> Response,
) -> Pressed {
    let regions = pass.regions;
    let cancel = pass.model.texts.say("worlds-cancel");
    let mut pressed = Pressed::Nothing;
    let body = |ui: &mut Ui, stops: &mut Stops| {
        let response = field(ui, pass, stops);
        ui.add_space(GRID);
        response
    };
    let response = pane(ui, regions.pane, title, body, |ui| {
        if primary_button(ui, accept, enabled).clicked() {
            pressed = Pressed::Do;
        } else if button(ui, &cancel).clicked() {
            pressed = Pressed::Cancel;
        }
    });
    // Enter takes the focus off a line of text, so losing it counts.
    let in_use = response.has_focus() || response.lost_focus();
    if enabled && in_use && ui.input(|input| input.key_pressed(egui::Key::Enter)) {
        pressed = Pressed::Do;
    }
    pressed
}
