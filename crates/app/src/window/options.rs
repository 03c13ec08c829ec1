//! The settings in the game: what the player changes holds at once and is written in the background.

use std::collections::BTreeSet;

use antipode_scene::frame::Quality;
use antipode_settings::{Config, Given, Keeper, Lesson, Value};
use antipode_ui::ToastKind;

use super::menus::Menus;
use super::play::Play;
use crate::cli::Common;
use crate::controls::Controls;
use crate::options;
use crate::wording;

/// What the command line fixes until the player changes that very setting.
#[derive(Clone, Copy, Debug, Default)]
struct Fixed {
    quality: Option<Quality>,
    view_distance: Option<u32>,
}

/// Settings and key bindings, their file, and what stands above it.
#[derive(Debug)]
pub struct Options {
    pub(super) config: Config,
    keeper: Keeper,
    fixed: Fixed,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            config: Config::default(),
            keeper: Keeper::idle(),
            fixed: Fixed::default(),
        }
    }
}

impl Options {
    /// Those of a file, below what the command line fixes.
    pub fn new(config: Config, keeper: Keeper, common: &Common) -> Self {
        Self {
            config,
            keeper,
            fixed: Fixed {
                quality: common.quality,
                view_distance: common.view_distance,
            },
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

    /// The player has changed a setting, which the command line fixes no longer.
    pub fn let_go(&mut self, id: &str) {
        match id {
            "quality" => self.fixed.quality = None,
            "view-distance" => self.fixed.view_distance = None,
            _ => {}
        }
    }

    /// Everything here holds from now on.
    pub fn hold(&self, controls: &mut Controls, play: &mut Play) {
        controls.set_config(&self.config);
        let settings = &self.config.settings;
        let quality = self.fixed.quality;
        let chunks = self.fixed.view_distance;
        play.follow(
            settings,
            quality.unwrap_or_else(|| options::quality(settings)),
            chunks.unwrap_or(settings.view_distance_chunks),
        );
    }

    /// Has the file keep what holds now.
    pub fn keep(&self) {
        self.keeper.save(&self.config);
    }

    /// Has the file keep what was learnt, where that is something else than before.
    pub fn keep_learnt(&mut self, learnt: BTreeSet<Lesson>) {
        if learnt != self.config.learnt {
            self.config.learnt = learnt;
            self.keep();
        }
    }
}
