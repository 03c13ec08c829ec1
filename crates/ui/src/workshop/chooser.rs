//! A page on which a file is chosen: the folders and fitting files of a folder, the way up and home, and a path that is typed. It reads
//! nothing itself.

use egui::{Button, Id, Key, Label, Modal, RichText, ScrollArea, Ui, vec2};

use super::model::{WorkshopModel, WorkshopWish};
use crate::entry::named_line;
use crate::theme::{BAD, GRID, TEXT, WEAK};
use crate::widgets::{button, focus_ring};

/// Widest the page gets, points.
const WIDEST: f32 = 560.0;
/// Longest path that can be typed, characters.
const LONGEST: usize = 1000;

/// A folder from which a file is chosen.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ChooserModel {
    /// Its path.
    pub folder: String,
    /// What of it can be gone into or chosen, folders first.
    pub entries: Vec<ChooserEntry>,
    /// What cannot be read or is not shown, in a sentence.
    pub problem: Option<String>,
    /// Whether it is still being read.
    pub is_reading: bool,
}

/// A folder or a file in a folder.
#[derive(Clone, Debug, PartialEq)]
pub struct ChooserEntry {
    /// Its name.
    pub name: String,
    /// Whether it is a folder.
    pub is_folder: bool,
    /// How large it is, or that it is a folder, in words.
    pub about: String,
}

/// What is asked for while a file is chosen.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ChooserWish {
    /// The folder or file of that name in the folder that is shown.
    Open(String),
    /// The folder or file of that path, as it was typed.
    Go(String),
    /// The folder that this one is in.
    Up,
    /// The player's own folder.
    Home,
    /// No file.
    Close,
}

/// What the page remembers.
#[derive(Debug, Default)]
pub(super) struct ChooserState {
    /// The path as it is typed, and the folder that was shown when that began.
    typed: Option<(String, String)>,
    /// The folder whose first line was given the keyboard.
    focused: Option<String>,
}

/// Draws it while there is something to choose from.
pub(super) fn show(
    ui: &Ui,
    model: &WorkshopModel<'_>,
    state: &mut ChooserState,
    wishes: &mut Vec<WorkshopWish>,
) {
    let Some(chooser) = model.chooser else {
        *state = ChooserState::default();
        return;
    };
    let mut asked = Vec::new();
    let screen = ui.ctx().content_rect();
    let response = Modal::new(Id::unique("antipode-workshop-chooser")).show(ui.ctx(), |ui| {
        ui.style_mut().override_font_id = Some(egui::FontId::proportional(14.0));
        ui.spacing_mut().item_spacing = vec2(GRID, 4.0);
        ui.spacing_mut().button_padding = vec2(8.0, 3.0);
        ui.spacing_mut().interact_size.y = 26.0;
        ui.set_width(WIDEST.min(0.86 * screen.width()));
        let title = model.texts.say("workshop-chooser-title");
        ui.label(RichText::new(title).color(TEXT).size(20.0));
        let about = model.texts.say("workshop-chooser-about");
        ui.add(Label::new(RichText::new(about).color(WEAK)).wrap());
        path(ui, model, chooser, state, &mut asked);
        if let Some(problem) = &chooser.problem {
            ui.add(Label::new(RichText::new(problem).color(BAD)).wrap());
        }
        let height = (screen.height() - 260.0).clamp(90.0, 420.0);
        ScrollArea::vertical()
            .id_salt(&chooser.folder)
            .auto_shrink(false)
            .max_height(height)
            .show(ui, |ui| entries(ui, model, chooser, state, &mut asked));
        ui.horizontal_wrapped(|ui| {
            for (key, wish) in [
                ("workshop-chooser-up", ChooserWish::Up),
                ("workshop-chooser-home", ChooserWish::Home),
                ("workshop-chooser-close", ChooserWish::Close),
            ] {
                if button(ui, &model.texts.say(key)).clicked() {
                    asked.push(wish);
                }
            }
        });
    });
    if response.should_close() {
        asked.push(ChooserWish::Close);
    }
    wishes.extend(asked.into_iter().map(WorkshopWish::Chooser));
}

/// The path of the folder, which can be typed: Enter goes there.
fn path(
    ui: &mut Ui,
    model: &WorkshopModel<'_>,
    chooser: &ChooserModel,
    state: &mut ChooserState,
    asked: &mut Vec<ChooserWish>,
) {
    let kept = state.typed.take();
    let kept = kept.filter(|(folder, _)| *folder == chooser.folder);
    let mut typed = kept.map_or_else(|| chooser.folder.clone(), |(_, typed)| typed);
    let label = model.texts.say("workshop-chooser-path");
    let response = named_line(ui, &mut typed, &label, "", LONGEST);
    let is_entered = response.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
    let open = model.texts.say("workshop-chooser-open");
    let is_other = typed.trim() != chooser.folder && !typed.trim().is_empty();
    let is_opened = is_other && button(ui, &open).clicked();
    if (is_entered || is_opened) && !typed.trim().is_empty() {
        asked.push(ChooserWish::Go(typed.clone()));
    }
    state.typed = Some((chooser.folder.clone(), typed));
}

/// The lines of the folder, folders first.
fn entries(
    ui: &mut Ui,
    model: &WorkshopModel<'_>,
    chooser: &ChooserModel,
    state: &mut ChooserState,
    asked: &mut Vec<ChooserWish>,
) {
    // Another path is typed: what is in this folder says nothing of that.
    let is_other = (state.typed.as_ref()).is_some_and(|(folder, typed)| folder != typed);
    if chooser.entries.is_empty() && is_other && !chooser.is_reading {
        return;
    }
    if chooser.entries.is_empty() {
        let key = if chooser.is_reading {
            "workshop-chooser-reading"
        } else {
            "workshop-chooser-empty"
        };
        let words = RichText::new(model.texts.say(key)).color(WEAK);
        ui.add(Label::new(words).wrap());
        return;
    }
    let is_new = state.focused.as_ref() != Some(&chooser.folder);
    for (number, entry) in chooser.entries.iter().enumerate() {
        let width = ui.available_width() - GRID;
        let colour = if entry.is_folder { WEAK } else { TEXT };
        let line = Button::new(RichText::new(&entry.name).color(colour))
            .shortcut_text(&entry.about)
            .truncate()
            .min_size(vec2(width, 24.0));
        let response = ui.add(line);
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, &entry.name));
        focus_ring(ui, &response);
        if number == 0 && is_new {
            response.request_focus();
            state.focused = Some(chooser.folder.clone());
        }
        if response.clicked() {
            asked.push(ChooserWish::Open(entry.name.clone()));
        }
    }
}
