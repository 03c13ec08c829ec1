//! What newcomers are told in the world, one thing after another, each until it was done or skipped: the lessons of
//! `assets/tables/hints.ron`.

#[cfg(test)]
mod tests;

use std::collections::BTreeSet;

use antipode_geometry::ChartId;
use antipode_language::Texts;
use antipode_scene::tuning::STEP_S;
use antipode_scene::{Actions, Scene};
use antipode_settings::{Done, Lesson, Needs, Profiles};
use antipode_ui::{HintModel, first_input_label, pad_input_label};

use super::phase::Phase;
use crate::bindings::Action;

/// Squares whose order is remembered.
const MOST_SQUARES: usize = 16;
/// From one hint to the next, seconds.
const REST_S: f64 = 0.6;
/// How long it is said that one has gone round a corner, seconds.
const BACK_S: f64 = 8.0;

/// What of a world the hints depend on.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct HintContext {
    /// Whether the wheel turns a dial.
    pub has_dial: bool,
    /// Whether there is no other picture.
    pub only_view: bool,
    /// Whether the world is closed: the land is overhead, and a way round leads home.
    pub closed: bool,
    /// The square that the player is in, in a world in squares.
    pub square: Option<ChartId>,
    /// Whether what is built is gathered first.
    pub gathering: bool,
    /// Whether it is dark where the player is.
    pub dark: bool,
    /// Whether somebody answers the player.
    pub answered: bool,
    /// Whether the player sits in a car.
    pub drives: bool,
    /// Elevation of the view, radians.
    pub pitch_rad: f64,
}

impl HintContext {
    /// Of an open world.
    pub fn of(scene: &Scene) -> Self {
        Self {
            has_dial: scene.lens().range().is_some(),
            only_view: scene.strategy().view_modes().len() == 1,
            closed: scene.strategy().globe().is_some(),
            square: scene.strategy().tiled().map(|_| scene.feet().chart),
            gathering: scene.stock().is_some(),
            dark: scene.is_dark(),
            answered: scene.is_answered(),
            drives: scene.is_driving(),
            pitch_rad: scene.head().pitch,
        }
    }

    /// Of the world that is open, if there is one.
    pub fn in_phase(phase: &Phase) -> Self {
        let session = phase.session();
        session.map_or_else(Self::default, |session| Self::of(&session.scene))
    }

    /// Whether what a lesson is about is there.
    fn has(self, lesson: Lesson) -> bool {
        match lesson.needs() {
            Needs::Nothing => true,
            Needs::Dial => self.has_dial,
            Needs::OtherPicture => !self.only_view,
            Needs::Closed => self.closed,
            Needs::Squares => self.square.is_some(),
            Needs::Gathering => self.gathering,
            Needs::Dark => self.dark,
        }
    }
}

/// What was done of it so far.
#[derive(Clone, Debug, Default)]
pub struct Hints {
    done: [bool; Lesson::ALL.len()],
    turned_rad: f64,
    walked_s: f64,
    dug_s: f64,
    built_s: f64,
    /// The squares that were gone through, without what was gone back.
    squares: Vec<ChartId>,
    /// How long a hint that is only to be read has been shown, seconds.
    read_s: f64,
    /// Until the next is told, seconds.
    rest_s: f64,
    /// Whether one has just gone round a corner, which is said until then.
    is_back: bool,
    /// Whether the player last used a gamepad.
    by_pad: bool,
}

impl Hints {
    /// Notes what was used last, as it is named in the hints.
    pub fn use_pad(&mut self, by_pad: bool) {
        self.by_pad = by_pad;
    }

    /// Remembers that all was told, and begins anew where the hints are not `shown`. Once a frame. Returns whether all was
    /// told just now.
    pub fn watch(&mut self, shown: bool, phase: &Phase) -> bool {
        if shown && matches!(phase, Phase::Paused(_)) {
            // Whoever is here has found the menu.
            self.use_action(Action::Menu);
        }
        // Of what this world lacks, such as a dial, the next one that has it tells.
        let all = self.learnt().len() == Lesson::ALL.len();
        if all || !shown {
            self.begin_anew();
        }
        all
    }

    fn begin_anew(&mut self) {
        *self = Self {
            by_pad: self.by_pad,
            ..Self::default()
        };
    }

    /// Goes on from what was learnt in earlier runs.
    pub fn go_on(&mut self, learnt: &BTreeSet<Lesson>) {
        for lesson in learnt {
            self.finish(*lesson);
        }
        self.rest_s = 0.0;
    }

    /// What was done, skipped or seen long enough.
    pub fn learnt(&self) -> BTreeSet<Lesson> {
        let all = Lesson::ALL.into_iter().zip(self.done);
        all.filter_map(|(lesson, done)| done.then_some(lesson))
            .collect()
    }

    /// Takes in what the player asked for in one step of the simulation, and where.
    pub fn step(&mut self, actions: &Actions, context: HintContext) {
        self.rest_s = (self.rest_s - STEP_S).max(0.0);
        let current = self.current(context).filter(|_| self.rest_s <= 0.0);
        if let Some((lesson, Some(most_s))) = current.map(|(lesson, ..)| (lesson, lesson.read_s()))
        {
            self.read_s += STEP_S;
            if self.read_s >= most_s {
                self.finish(lesson);
            }
        }
        self.turned_rad += actions.look_yaw.abs() + actions.look_pitch.abs();
        self.walked_s += actions.forward.hypot(actions.strafe).min(1.0) * STEP_S;
        let worked = |on: bool| if on { STEP_S } else { 0.0 };
        self.dug_s += worked(actions.primary);
        self.built_s += worked(actions.secondary);
        self.go_through(context.square);
        for lesson in Lesson::ALL {
            let is_done = match lesson.done() {
                Done::Turned(most_rad) => self.turned_rad >= most_rad,
                Done::Walked(most_s) => self.walked_s >= most_s,
                Done::Dug(most_s) => self.dug_s >= most_s,
                Done::Built(most_s) => self.built_s >= most_s,
                Done::LookedUp(most_rad) => context.has(lesson) && context.pitch_rad >= most_rad,
                Done::Rounded(count) => self.has_rounded(count),
                Done::Asked | Done::Read => false,
            };
            let is_rounded = is_done && matches!(lesson.done(), Done::Rounded(_));
            let is_new = self.done.get(lesson as usize) == Some(&false);
            if is_done {
                self.finish(lesson);
            }
            if is_rounded && is_new {
                (self.rest_s, self.is_back) = (BACK_S, true);
            }
        }
        // Nobody has learnt what he tried in vain.
        for (action, is_used) in [
            (Action::Jump, actions.jump),
            (Action::Talk, context.answered),
            (Action::EnterCar, context.drives),
            (Action::OtherMap, actions.turn_map),
            (Action::Camera, actions.toggle_camera),
            (Action::Flashlight, actions.toggle_light),
            (Action::DialUp, actions.dial != 0.0),
        ] {
            if is_used {
                self.use_action(action);
            }
        }
    }

    fn go_through(&mut self, square: Option<ChartId>) {
        let Some(square) = square else {
            self.squares.clear();
            return;
        };
        let mut last = self.squares.iter().rev();
        if last.next() == Some(&square) {
            return;
        }
        if last.next() == Some(&square) {
            self.squares.pop();
            return;
        }
        self.squares.push(square);
        if self.squares.len() > MOST_SQUARES {
            self.squares.remove(0);
        }
    }

    /// Whether the last of the squares is the one that so many were gone through since.
    fn has_rounded(&self, count: usize) -> bool {
        let mut last = self.squares.iter().rev();
        let now = last.next();
        now.is_some() && last.nth(count.saturating_sub(1)) == now
    }

    /// Takes in that an action was used.
    pub fn use_action(&mut self, action: Action) {
        let lessons = Lesson::ALL.into_iter();
        for lesson in lessons.filter(|lesson| lesson.is_asked_by(action)) {
            self.finish(lesson);
        }
    }

    /// A lesson is done.
    fn finish(&mut self, lesson: Lesson) {
        let Some(done) = self.done.get_mut(lesson as usize) else {
            return;
        };
        if !std::mem::replace(done, true) {
            tracing::debug!("learnt {lesson:?}");
            self.rest_s = REST_S;
            self.is_back = false;
            self.read_s = 0.0;
        }
    }

    /// Goes on from the hint that is shown.
    pub fn skip(&mut self, context: HintContext) {
        if let Some((lesson, ..)) = self.current(context) {
            self.finish(lesson);
        }
    }

    /// What is to be told now, its number among those that this world has, and how many these are. Places in their order would go
    /// back where an earlier one waited for what it tells of.
    fn current(&self, context: HintContext) -> Option<(Lesson, usize, usize)> {
        let lessons = Lesson::ALL.into_iter();
        let lessons: Vec<_> = lessons.filter(|lesson| context.has(*lesson)).collect();
        let is_open = |lesson: &Lesson| self.done.get(*lesson as usize) == Some(&false);
        let at = lessons.iter().position(is_open)?;
        let done = lessons.iter().filter(|it| !is_open(it)).count();
        Some((lessons[at], done + 1, lessons.len()))
    }

    /// The words to show now, if any.
    pub fn model(
        &self,
        texts: &Texts,
        profiles: &Profiles,
        context: HintContext,
    ) -> Option<HintModel> {
        if self.is_back && self.rest_s > 0.0 {
            return Some(HintModel {
                text: texts.say("hints-corner-back"),
                footer: String::new(),
            });
        }
        let (lesson, step, count) = self.current(context).filter(|_| self.rest_s <= 0.0)?;
        let key = |action| {
            let pad = pad_input_label(texts, profiles, action).filter(|_| self.by_pad);
            pad.unwrap_or_else(|| first_input_label(texts, profiles, action))
        };
        let text = self.words(texts, lesson, key);
        let mut values = vec![("step", step.into()), ("count", count.into())];
        // A pad has no button for it; nor has a keyboard whose key was taken away.
        let skips = !self.by_pad && !profiles.chosen().inputs(Action::SkipHint).is_empty();
        let footer = if skips {
            values.push(("key", key(Action::SkipHint).into()));
            texts.say_with("hints-footer", &values)
        } else {
            texts.say_with("hints-footer-plain", &values)
        };
        Some(HintModel { text, footer })
    }

    /// What a lesson says; `key` names what does a thing.
    fn words(&self, texts: &Texts, lesson: Lesson, key: impl Fn(Action) -> String) -> String {
        let named = |actions: &[Action]| actions.iter().map(|it| key(*it)).collect::<Vec<_>>();
        let keys = lesson.keys().iter();
        let mut values: Vec<_> = keys
            .map(|(argument, actions)| (*argument, named(actions).join(" ").into()))
            .collect();
        if lesson == Lesson::Corner {
            values.push(("gone", self.squares.len().saturating_sub(1).into()));
        }
        if let Some(device) = lesson.device(self.by_pad) {
            values = vec![("key", texts.say(device).into())];
        }
        texts.say_with(&format!("hints-{}", lesson.id()), &values)
    }
}
