//! The profiles above the list of actions: choose, add, rename, delete, and everything back to its default.

use antipode_language::Texts;
use antipode_settings::{Profile, ProfileError, Profiles};
use egui::{
    Button, Key, Label, Response, RichText, Role, TextWrapMode, Ui, Widget as _, WidgetInfo,
};

use crate::entry::entry;
use crate::layout::Stops;
use crate::legible::legible_name;
use crate::model::Intent;
use crate::shell::Pass;
use crate::theme::{BAD, small};
use crate::widgets::{button, focus_ring};

/// What is being asked of the player.
#[derive(Default)]
pub(super) enum Form {
    #[default]
    Closed,
    /// A name for a new profile.
    Add(String),
    /// Another name for the one in use.
    Rename(String),
    /// Whether to delete it.
    Delete,
    /// Whether to give all its actions their defaults.
    ResetAll,
}

/// What the player does with the form.
enum Answer {
    Do,
    Cancel,
}

impl Form {
    /// Whether anything is being asked.
    pub(super) fn is_open(&self) -> bool {
        !matches!(self, Self::Closed)
    }

    /// Closes the form; false if none is open.
    pub(super) fn close(&mut self) -> bool {
        let open = self.is_open();
        *self = Self::Closed;
        open
    }

    /// Draws the profiles and the form; true if another form is up from the next frame on.
    pub(super) fn show(&mut self, ui: &mut Ui, pass: &mut Pass<'_>, stops: &mut Stops) -> bool {
        choose(ui, pass, stops);
        if !self.is_open() {
            return self.buttons(ui, pass, stops);
        }
        let mut profiles = pass.model.config.profiles.clone();
        let done = self.apply(&mut profiles);
        match self.fill_in(ui, pass, stops, done.err()) {
            Some(Answer::Do) if done.is_ok() => {
                pass.intents.push(Intent::Bind(Box::new(profiles)));
                self.close()
            }
            Some(Answer::Cancel) => self.close(),
            _ => false,
        }
    }

    fn buttons(&mut self, ui: &mut Ui, pass: &mut Pass<'_>, stops: &mut Stops) -> bool {
        let texts = pass.model.texts;
        let profiles = &pass.model.config.profiles;
        ui.horizontal_wrapped(|ui| {
            ui.style_mut().wrap_mode = Some(TextWrapMode::Extend);
            let mut press = |ui: &mut Ui, key: &str, form: Self| {
                let response = button(ui, &texts.say(key));
                stops.add(&response);
                if response.clicked() {
                    *self = form;
                }
            };
            press(ui, "profile-add", Self::Add(String::new()));
            let name = full_label(texts, profiles.chosen());
            press(ui, "profile-rename", Self::Rename(name));
            if profiles.all().len() > 1 {
                press(ui, "profile-delete", Self::Delete);
            }
            press(ui, "profile-reset-all", Self::ResetAll);
        });
        self.is_open()
    }

    /// What the form asks for, done to a copy.
    fn apply(&self, profiles: &mut Profiles) -> Result<(), ProfileError> {
        match self {
            Self::Closed => Ok(()),
            Self::Add(name) => profiles.add(name),
            Self::Rename(name) => profiles.rename(name),
            Self::Delete => profiles.delete(),
            Self::ResetAll => {
                profiles.chosen_mut().reset_all();
                Ok(())
            }
        }
    }

    fn fill_in(
        &mut self,
        ui: &mut Ui,
        pass: &mut Pass<'_>,
        stops: &mut Stops,
        wrong: Option<ProfileError>,
    ) -> Option<Answer> {
        let texts = pass.model.texts;
        let profiles = &pass.model.config.profiles;
        let own = label(texts, profiles.chosen(), profiles.chosen_place());
        let values = [("name", own.as_str().into())];
        let mut entered = false;
        match self {
            Self::Add(name) | Self::Rename(name) => {
                let title = texts.say("profile-name");
                let response = entry(ui, name, &title, &title);
                stops.add(&response);
                pass.offer_focus(&response);
                entered = response.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
                if let Some(wrong) = wrong {
                    let words = RichText::new(texts.say(wrong.text_key())).font(small());
                    Label::new(words.color(BAD)).wrap().ui(ui);
                }
            }
            Self::Delete => {
                Label::new(texts.say_with("profile-delete-question", &values))
                    .wrap()
                    .ui(ui);
            }
            Self::ResetAll => {
                Label::new(texts.say_with("profile-reset-question", &values))
                    .wrap()
                    .ui(ui);
            }
            Self::Closed => {}
        }
        let sure = match self {
            Self::Delete => "profile-delete-do",
            Self::ResetAll => "profile-reset-do",
            _ => "ok",
        };
        let mut answer = entered.then_some(Answer::Do);
        ui.horizontal(|ui| {
            for (key, given) in [(sure, Answer::Do), ("controls-cancel", Answer::Cancel)] {
                let response = button(ui, &texts.say(key));
                stops.add(&response);
                // A question without a line to fill in begins at what changes nothing.
                if matches!(given, Answer::Cancel) {
                    pass.offer_focus(&response);
                }
                if response.clicked() {
                    answer = Some(given);
                }
            }
        });
        answer
    }
}

/// The profiles side by side, the one in use marked.
fn choose(ui: &mut Ui, pass: &mut Pass<'_>, stops: &mut Stops) {
    let texts = pass.model.texts;
    let profiles = &pass.model.config.profiles;
    ui.label(texts.say("profile-title"));
    let mut chosen = None;
    ui.horizontal_wrapped(|ui| {
        ui.style_mut().wrap_mode = Some(TextWrapMode::Truncate);
        for (place, profile) in profiles.all().iter().enumerate() {
            let name = label(texts, profile, place);
            let response = profile_button(ui, texts, &name, place == profiles.chosen_place());
            stops.add(&response);
            if response.clicked() {
                chosen = Some(place);
            }
        }
    });
    if let Some(place) = chosen {
        let mut profiles = profiles.clone();
        profiles.choose(place);
        pass.intents.push(Intent::Bind(Box::new(profiles)));
    }
}

fn profile_button(ui: &mut Ui, texts: &Texts, name: &str, chosen: bool) -> Response {
    let response = ui.add(Button::new(name).selected(chosen));
    let spoken = format!("{}: {name}", texts.say("profile-title"));
    response.widget_info(|| WidgetInfo::selected(Role::RadioButton, true, chosen, &spoken));
    focus_ring(ui, &response);
    response
}

/// A profile's name as it can be shown; `place`: which one it is, from 0.
fn label(texts: &Texts, profile: &Profile, place: usize) -> String {
    let name = full_label(texts, profile);
    legible_name(&name, &(place + 1).to_string()).into_owned()
}

/// A profile's name; the first has a common one until somebody gives it another.
fn full_label(texts: &Texts, profile: &Profile) -> String {
    match profile.name() {
        "" => texts.say("profile-standard"),
        name => name.to_owned(),
    }
}
