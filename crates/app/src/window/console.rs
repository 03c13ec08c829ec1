//! The console in the game: what is typed and answered there, and what was entered in earlier runs.

use std::path::PathBuf;

use antipode_ui::Console;

use super::press::{Press, Taken};
use crate::bindings::Action;
use crate::console::{read_history, write_history};
use crate::controls::Controls;

/// The console, and what its answers tell of.
#[derive(Default)]
pub struct ConsoleLayer {
    pub(super) view: Console,
    /// The number of the world that was answered in.
    world: u64,
    /// The adapter's name.
    pub(super) adapter: String,
    /// Where what was entered is kept for later runs.
    history: Option<PathBuf>,
}

impl ConsoleLayer {
    /// Takes over what was entered in earlier runs, and keeps there what is entered in this one.
    pub fn remember_in(&mut self, file: PathBuf) {
        self.view.remember(read_history(&file));
        self.history = Some(file);
    }

    /// Keeps what was entered.
    pub fn keep_history(&self) {
        if let Some(file) = self
            .history
            .as_ref()
            .filter(|_| !self.view.history().is_empty())
        {
            write_history(file, self.view.history());
        }
    }

    /// Brings it up over the world with that number.
    pub fn open(&mut self, world: u64) {
        if std::mem::replace(&mut self.world, world) != world {
            // What was answered in another world is not true of this one.
            self.view.clear();
        }
        self.view.open();
    }

    /// The layer of the console: what closes it is nobody else's.
    pub fn press(&mut self, press: &Press, controls: &Controls) -> Taken {
        let key = press.fresh_key().filter(|_| self.view.is_open());
        let does = |action| key.is_some_and(|key| controls.does(key, action));
        let closes = does(Action::Menu) || does(Action::Console);
        if closes {
            self.view.close();
        }
        Taken::if_true(closes)
    }
}
