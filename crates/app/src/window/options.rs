//! The settings in the game: what the player changes holds at once and is written in the background.

use antipode_scene::frame::Quality;
use antipode_settings::{Given, Keeper, Opened, Profiles, Value};
use antipode_ui::{Intent, ToastKind};

use super::game::Game;
use crate::cli::Common;
use crate::options;
use crate::session::Session;
use crate::wording;

/// Most sentences about the file of the settings that are told one by one.
const MOST_TOLD: usize = 3;

/// What the command line fixes until the player changes that very setting.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Fixed {
    quality: Option<Quality>,
    view_distance: Option<u32>,
}

/// The file, and what stands above it.
#[derive(Debug)]
pub(super) struct Options {
    keeper: Keeper,
    fixed: Fixed,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            keeper: Keeper::idle(),
            fixed: Fixed::default(),
        }
    }
}

impl Game {
    /// Takes over the settings to begin with, and tells what there is to tell of their file.
    pub fn begin_with(&mut self, opened: Opened, common: &Common) {
        let Opened {
            config,
            notices,
            keeper,
        } = opened;
        self.config = config;
        self.hints.go_on(&self.config.learnt);
        self.options = Options {
            keeper,
            fixed: Fixed {
                quality: common.quality,
                view_distance: common.view_distance,
            },
        };
        self.menus.texts = options::texts(&self.config.settings);
        self.follow_settings();
        for notice in notices.iter().take(MOST_TOLD) {
            let words = wording::settings_notice(&self.menus.texts, notice);
            self.menus.shell.toast(words, ToastKind::Problem);
        }
        if let Some(more) = notices
            .len()
            .checked_sub(MOST_TOLD)
            .filter(|more| *more > 0)
        {
            let values = [("count", more.into())];
            self.menus
                .toast(ToastKind::Problem, "settings-file-more", &values);
        }
    }

    /// Tells why settings could not be written.
    pub(super) fn watch_options(&mut self) {
        if let Some(problem) = self.options.keeper.take_problem() {
            let words = wording::texts_with(
                &self.menus.texts,
                problem.text_key(),
                problem.text_arguments(),
            );
            self.menus.shell.toast(words, ToastKind::Problem);
        }
    }

    /// Gives a setting a value.
    pub(super) fn set_option(&mut self, id: &'static str, value: Value) {
        match self.config.settings.set(id, Given::from(value)) {
            Ok(()) => self.option_changed(id),
            Err(error) => tracing::warn!("{error}"),
        }
    }

    /// Gives a setting its default.
    pub(super) fn reset_option(&mut self, id: &'static str) {
        if self.config.settings.reset(id) {
            self.option_changed(id);
        }
    }

    /// Has the file keep what holds now.
    pub(super) fn keep_config(&self) {
        self.options.keeper.save(&self.config);
    }

    /// Puts key bindings in use.
    pub(super) fn bind(&mut self, profiles: Profiles) {
        self.config.profiles = profiles;
        self.follow_settings();
        self.options.keeper.save(&self.config);
    }

    /// The window fills the screen, or no longer.
    pub(super) fn turn_fullscreen(&mut self) {
        let value = Value::Switch(!self.config.settings.fullscreen);
        self.follow(Intent::Set {
            id: "fullscreen",
            value,
        });
    }

    /// Gives an opened world what the player has chosen for all.
    pub(super) fn fit(&self, session: &mut Session) {
        options::fit(&mut session.scene, &self.config.settings);
    }

    fn option_changed(&mut self, id: &str) {
        match id {
            "quality" => self.options.fixed.quality = None,
            "view-distance" => self.options.fixed.view_distance = None,
            "language" => self.menus.texts = options::texts(&self.config.settings),
            "hyperbolic-map" => self.turn_to_map(),
            _ => {}
        }
        self.follow_settings();
        self.options.keeper.save(&self.config);
    }

    /// Everything here holds from now on.
    fn follow_settings(&mut self) {
        self.controls.set_config(&self.config);
        let settings = &self.config.settings;
        let Fixed {
            quality,
            view_distance,
        } = self.options.fixed;
        let quality = quality.unwrap_or_else(|| options::quality(settings));
        let chunks = view_distance.unwrap_or(settings.view_distance_chunks);
        self.worlds.set_quality(quality);
        self.worlds.set_view_distance(chunks);
        self.worlds.set_map(options::map(settings));
        if let Some(session) = self.phase.session_mut() {
            let scene = &mut session.scene;
            scene.set_quality(quality);
            if scene.view_distance() != chunks {
                scene.set_view_distance(chunks);
            }
            options::fit(scene, settings);
        }
    }

    /// The open world is seen through the map of the settings, if it has maps.
    fn turn_to_map(&mut self) {
        let wanted = options::map(&self.config.settings);
        let Some(session) = self.phase.session_mut() else {
            return;
        };
        if session.scene.lens().map().is_some_and(|map| map != wanted) {
            session.scene.turn_map();
        }
    }
}
