//! The Controls screen: every action with what does it, changed by pressing a key, a button or turning the wheel;
//! and several profiles of them.

mod line;
mod profiles;

use antipode_language::Texts;
use antipode_settings::{Action, ActionGroup, BindError, Input, Profiles, actions};
use egui::{Id, Label, RichText, Ui};

use crate::layout::{Stops, long_pane, pane};
use crate::model::{Intent, Screen};
use crate::shell::Pass;
use crate::theme::{ACCENT, BAD, TEXT, WEAK};
use crate::widgets::button;

/// What is up on the screen beside the bindings themselves.
#[derive(Default)]
pub(crate) struct ControlsScreen {
    /// The action that waits for an input, and the one that it takes the place of.
    waiting: Option<(Action, Option<Input>)>,
    /// What has come for it.
    come: Option<Input>,
    /// Why the last change could not be made.
    refused: Option<(Action, BindError)>,
    form: profiles::Form,
}

/// What is asked for in one frame.
#[derive(Clone, Copy)]
enum Wish {
    /// To press something for an action, in place of an input or beside the others.
    Wait(Action, Option<Input>),
    Unbind(Action, Input),
    Reset(Action),
}

impl ControlsScreen {
    /// What is up beside the plain list, as a name that it bears every time.
    pub(crate) fn place(&self) -> Option<Id> {
        let asked = self.waiting.map(|(action, _)| action);
        match (asked, self.form.is_open()) {
            (None, false) => None,
            (asked, _) => Some(Id::unique((asked, std::mem::discriminant(&self.form)))),
        }
    }

    /// Back to the plain list.
    pub(crate) fn reset(&mut self) {
        *self = Self::default();
    }

    /// Esc: one level back within this screen; false if there is none.
    pub(crate) fn back(&mut self) -> bool {
        self.waiting.take().is_some() || self.form.close()
    }

    /// Whether the next key, button or notch is to be given to [`ControlsScreen::take`].
    pub(crate) fn is_waiting(&self) -> bool {
        self.waiting.is_some() && self.come.is_none()
    }

    /// Takes what the player has pressed.
    pub(crate) fn take(&mut self, input: Input) {
        if self.is_waiting() {
            self.come = Some(input);
        }
    }

    /// Draws the screen. True if something else is up from the next frame on.
    pub(crate) fn show(&mut self, ui: &mut Ui, pass: &mut Pass<'_>) -> bool {
        let mut turned = false;
        if let Some(input) = self.come.take()
            && let Some((action, old)) = self.waiting.take()
        {
            self.bind(pass, action, old, input);
            turned = true;
        }
        if let Some((action, _)) = self.waiting {
            ask(ui, pass, action);
            return false;
        }
        let regions = pass.regions;
        let texts = pass.model.texts;
        let mut back = false;
        let mut wish = None;
        let body = |ui: &mut Ui, stops: &mut Stops| {
            turned |= self.form.show(ui, pass, stops);
            wish = self.lines(ui, pass, stops);
            of_workshop(ui, texts);
        };
        let title = texts.say("menu-controls");
        long_pane(ui, regions.pane, &title, body, |ui| {
            back = button(ui, &texts.say("back")).clicked();
        });
        if back {
            pass.go = Some(Screen::Main);
        }
        turned |= wish.is_some_and(|wish| self.follow(pass, wish));
        if turned || !pass.intents.is_empty() {
            ui.ctx().request_repaint();
        }
        turned
    }

    fn lines(&self, ui: &mut Ui, pass: &mut Pass<'_>, stops: &mut Stops) -> Option<Wish> {
        let texts = pass.model.texts;
        let profile = pass.model.config.profiles.chosen();
        let conflicts = profile.conflicts();
        let mut wish = None;
        for group in ActionGroup::ALL {
            ui.separator();
            ui.label(RichText::new(texts.say(group.id())).color(ACCENT));
            if group == ActionGroup::Moving {
                let (look, mouse) = (texts.say("action-look"), texts.say("key-Mouse"));
                ui.add(Label::new(RichText::new(format!("{look}: {mouse}")).color(WEAK)).wrap());
            }
            for info in actions().iter().filter(|info| info.group == group) {
                let asked = line::show(ui, pass, stops, profile, info.action);
                wish = wish.or(asked);
                for conflict in &conflicts {
                    line::tell(ui, texts, conflict, info.action);
                }
                if let Some((action, why)) = self.refused
                    && action == info.action
                {
                    let words = texts.say(why.text_key());
                    ui.add(Label::new(RichText::new(words).color(BAD)).wrap());
                }
            }
        }
        wish
    }

    fn follow(&mut self, pass: &mut Pass<'_>, wish: Wish) -> bool {
        self.refused = None;
        let change = |pass: &mut Pass<'_>, how: &dyn Fn(&mut Profiles) -> Result<(), BindError>| {
            let mut profiles = pass.model.config.profiles.clone();
            let done = how(&mut profiles);
            pass.intents.push(Intent::Bind(Box::new(profiles)));
            done
        };
        let (action, done) = match wish {
            Wish::Wait(action, old) => {
                self.waiting = Some((action, old));
                return true;
            }
            Wish::Unbind(action, input) => {
                let unbind = |own: &mut Profiles| own.chosen_mut().unbind(action, input);
                (action, change(pass, &unbind))
            }
            Wish::Reset(action) => {
                let reset = |own: &mut Profiles| {
                    own.chosen_mut().reset(action);
                    Ok(())
                };
                (action, change(pass, &reset))
            }
        };
        self.refused = done.err().map(|why| (action, why));
        false
    }

    fn bind(&mut self, pass: &mut Pass<'_>, action: Action, old: Option<Input>, input: Input) {
        let mut profiles = pass.model.config.profiles.clone();
        let own = profiles.chosen_mut();
        let bound = match old {
            Some(old) => own.rebind(action, old, input),
            None => own.bind(action, input),
        };
        self.refused = bound.err().map(|why| (action, why));
        if bound.is_ok() {
            pass.intents.push(Intent::Bind(Box::new(profiles)));
        }
    }
}

/// The keys of the workshop, which are what they are.
fn of_workshop(ui: &mut Ui, texts: &Texts) {
    ui.separator();
    ui.label(RichText::new(texts.say("menu-workshop")).color(ACCENT));
    for line in crate::workshop::told_keys(texts) {
        ui.add(Label::new(RichText::new(line).color(WEAK)).wrap());
    }
}

/// What stands in the place of the list while something is to be pressed.
fn ask(ui: &mut Ui, pass: &Pass<'_>, action: Action) {
    let texts = pass.model.texts;
    let body = |ui: &mut Ui, _: &mut Stops| {
        let values = [("action", action_label(texts, action).into())];
        for (key, colour) in [("controls-press", TEXT), ("controls-press-cancel", WEAK)] {
            let words = texts.say_with(key, &values);
            ui.add(Label::new(RichText::new(words).color(colour)).wrap());
        }
    };
    pane(
        ui,
        pass.regions.pane,
        &action_label(texts, action),
        body,
        |_| {},
    );
}

/// What an action is called.
pub fn action_label(texts: &Texts, action: Action) -> String {
    if let Action::Slot(slot) = action {
        return texts.say_with("action-slot", &[("number", (slot + 1).into())]);
    }
    let id = action.info().id;
    texts.say(&format!("action-{id}"))
}

/// What a key, a button or a way to turn the wheel is called.
pub fn input_label(texts: &Texts, input: Input) -> String {
    if let Some(printed) = input.printed() {
        return printed.to_owned();
    }
    let name = input.name();
    if let Some(digit) = name.strip_prefix("Numpad").filter(|rest| rest.len() == 1) {
        return texts.say_with("key-Numpad", &[("key", digit.into())]);
    }
    let key = format!("key-{name}");
    if texts.has(&key) {
        texts.say(&key)
    } else {
        name.to_owned()
    }
}

/// What does an action, for hints: the first of its inputs, or that it has none.
pub fn first_input_label(texts: &Texts, profiles: &Profiles, action: Action) -> String {
    let first = profiles.chosen().inputs(action).first();
    first.map_or_else(|| texts.say("key-none"), |input| input_label(texts, *input))
}

/// The same for somebody with a gamepad in hand: the first of its buttons, if it has one.
pub fn pad_input_label(texts: &Texts, profiles: &Profiles, action: Action) -> Option<String> {
    let mut inputs = profiles.chosen().inputs(action).iter();
    let button = inputs.find(|input| matches!(input, Input::Pad(_)))?;
    Some(input_label(texts, *button))
}
