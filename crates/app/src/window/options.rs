//! The settings in the game: what the player changes holds at once and is written in the background.

use std::collections::BTreeSet;

use antipode_scene::frame::Quality;
use antipode_settings::{Config, Given, Keeper, Lesson, Preset, Settings, Value};
use antipode_ui::ToastKind;

use super::menus::Menus;
use super::play::Play;
use crate::common::Common;
use crate::controls::Controls;
use crate::options;
use crate::wording;

/// Settings and key bindings, their file, and what stands above it.
#[derive(Debug)]
pub struct Options {
    pub(super) config: Config,
    keeper: Keeper,
    /// What the command line fixes until the player changes that very setting.
    preset: Option<Preset>,
    quality: Option<Quality>,
    view_distance: Option<u32>,
    /// Whether the processor draws.
    pub(super) software: bool,
}

impl Options {
    /// Those of a file, below what the command line fixes.
    pub fn new(config: Config, keeper: Keeper, common: Option<&Common>, software: bool) -> Self {
        Self {
            config,
            keeper,
            preset: common.and_then(|common| common.preset),
            quality: common.and_then(|common| common.quality),
            view_distance: common.and_then(|common| common.view_distance),
            software,
        }
    }

    /// The settings by which pictures are made: those of the file, below what the command line fixes.
    pub fn of_pictures(&self) -> Settings {
        let settings = &self.config.settings;
        Settings {
            preset: self.preset.unwrap_or(settings.preset),
            ..settings.clone()
        }
    }

    /// Tells why settings could not be written.
    pub fn watch(&self, menus: &mut Menus) {
        if let Some(problem) = self.keeper.take_problem() {
            let (key, values) = (problem.text_key(), problem.text_arguments());
            let words = wording::texts_with(&menus.texts, key, values);
            menus.shell.toast(words, ToastKind::Problem);
        }
    }

    /// Gives a setting a value. Returns whether it takes it.
    pub fn set(&mut self, id: &'static str, value: Value) -> bool {
        let set = self.config.settings.set(id, Given::from(value));
        set.inspect_err(|error| tracing::warn!("{error}")).is_ok()
    }

    /// Something was changed: it holds at once, whatever the command line fixes, and is kept.
    pub fn changed(
        &mut self,
        id: &str,
        menus: &mut Menus,
        controls: &mut Controls,
        play: &mut Play,
    ) {
        let settings = &self.config.settings;
        match id {
            "preset" => self.preset = None,
            "quality" => self.quality = None,
            "view-distance" => self.view_distance = None,
            "language" => menus.texts = options::texts(settings),
            "hyperbolic-map" => play.turn_to(options::map(settings)),
            _ => {}
        }
        self.apply(controls, play);
        self.keeper.save(&self.config);
    }

    /// Everything here holds from now on.
    pub fn apply(&self, controls: &mut Controls, play: &mut Play) {
        controls.set_config(&self.config);
        let settings = &self.config.settings;
        let quality = self.quality.unwrap_or_else(|| options::quality(settings));
        let own = || self.of_pictures().view_distance(self.software);
        let chunks = self.view_distance.unwrap_or_else(own);
        play.follow(settings, quality, chunks);
    }

    /// Has the file keep how the panes of the workshop lie, where that is otherwise than before.
    pub fn keep_panes(&mut self, panes: String) {
        if panes != self.config.panes {
            self.config.panes = panes;
            self.keeper.save(&self.config);
        }
    }

    /// Has the file keep whether the lesson of the workshop was taken.
    pub fn keep_taught_to_build(&mut self, taught: bool) {
        if taught != self.config.taught_to_build {
            self.config.taught_to_build = taught;
            self.keeper.save(&self.config);
        }
    }

    /// Has the file keep what was learnt, where that is something else than before.
    pub fn keep_learnt(&mut self, learnt: BTreeSet<Lesson>) {
        if learnt != self.config.learnt {
            self.config.learnt = learnt;
            self.keeper.save(&self.config);
        }
    }
}
