//! Tells the log what the window shows, whenever that has become something else: whoever reads of a fault goes by it, and
//! so do tests with a real window, which nothing else tells when a picture is there.

use antipode_ui::Screen;

use super::game::Game;
use super::phase::Phase;
use super::veil::Veil;

/// What the last picture showed.
#[derive(Debug, Default)]
pub struct Shown(&'static str);

impl Shown {
    /// A picture of the game as it is has been shown.
    pub fn tell(&mut self, game: &Game) {
        let what = what_is_up(game);
        if what != self.0 {
            self.0 = what;
            tracing::debug!("shown: {what}.");
        }
    }
}

fn what_is_up(game: &Game) -> &'static str {
    if !game.play.phase.is_played() && !game.play.phase.is_built() {
        return screen_name(game.menus.shell.screen(), game.play.phase.is_paused());
    }
    let overlays = &game.overlays;
    if overlays.is_typing() {
        "the console"
    } else if overlays.is_photographing() {
        "the photo mode"
    } else if overlays.is_packing() {
        "the backpack"
    } else if overlays.is_naming() {
        "the question for a name"
    } else if game.play.phase.is_built() {
        "the workshop"
    } else if matches!(game.play.phase, Phase::InRoom(_)) {
        "the room"
    } else if game.play.veil == Veil::Up {
        "the world"
    } else {
        "a world that comes"
    }
}

fn screen_name(screen: &Screen, is_paused: bool) -> &'static str {
    match screen {
        Screen::Hidden => "no menu",
        Screen::Main if is_paused => "the pause menu",
        Screen::Main => "the main menu",
        Screen::NewGame => "the form for a new world",
        Screen::Load => "the worlds to load",
        Screen::Delete => "the worlds to delete",
        Screen::Rooms => "the rooms",
        Screen::Workshop => "the rooms to build in",
        Screen::Settings => "the settings",
        Screen::Controls => "the controls",
        Screen::About => "the about screen",
        Screen::Busy { .. } => "work in progress",
        Screen::Message { .. } => "a message",
        Screen::Unsaved { .. } => "a world that is not saved",
    }
}
