//! Who is asked about a press: the layers of the game in one list, the topmost first. Each takes the press or passes it
//! on; what all pass is for the interface.

use super::game::Game;
use crate::bindings::{Action, Input};

/// Something that a hand does: a key, a button or a notch of the wheel goes down or comes up.
#[derive(Clone, Copy, Debug)]
pub struct Press {
    /// What; none for a key that bindings do not know.
    pub input: Option<Input>,
    pub down: bool,
    /// It is held, and the system tells it again.
    pub repeats: bool,
    /// The system tells it because the keyboard came or went, and no hand did it.
    pub synthetic: bool,
    /// A field of the interface takes text.
    pub into_text: bool,
}

impl Press {
    /// A press by hand.
    pub fn of(input: impl Into<Option<Input>>, down: bool) -> Self {
        Self {
            input: input.into(),
            down,
            repeats: false,
            synthetic: false,
            into_text: false,
        }
    }

    /// Whether it goes down just now.
    fn is_fresh(&self) -> bool {
        self.down && !self.repeats && !self.synthetic
    }

    /// What it is, where somebody did it.
    fn by_hand(&self) -> Option<Input> {
        self.input.filter(|_| !(self.synthetic && self.down))
    }
}

/// What a layer makes of a press.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Taken {
    /// It is nobody else's.
    Wholly,
    /// The interface hears of it, too: of a key that comes up, since one that went down in a menu would stay down there.
    AndHeard,
    /// It is for those below, and for the interface if it is nobody's.
    Not,
}

impl Taken {
    fn if_true(taken: bool) -> Self {
        if taken { Self::Wholly } else { Self::Not }
    }

    /// Whether the interface hears of it.
    pub fn is_heard(self) -> bool {
        self != Self::Wholly
    }
}

type Layer = fn(&mut Game, &Press) -> Taken;

/// All layers, the topmost first.
const LAYERS: [Layer; 7] = [binding, everywhere, console, backpack, photo, world, menu];

impl Game {
    /// Gives a press to the topmost layer that takes it.
    pub fn press(&mut self, press: &Press) -> Taken {
        let mut taken = LAYERS.iter().map(|layer| layer(self, press));
        taken
            .find(|taken| *taken != Taken::Not)
            .unwrap_or(Taken::Not)
    }
}

/// An action that waits for its key takes whatever it is, but Escape.
fn binding(game: &mut Game, press: &Press) -> Taken {
    let input = press
        .input
        .filter(|input| *input != ESCAPE && press.is_fresh());
    let Some(input) = input.filter(|_| game.menus.shell.wants_input()) else {
        return Taken::Not;
    };
    game.menus.shell.take_input(input);
    Taken::Wholly
}

/// The keys that mean the same in menus as in the world.
fn everywhere(game: &mut Game, press: &Press) -> Taken {
    let fresh = press
        .input
        .filter(|input| press.is_fresh() && is_key(*input));
    let Some(input) = fresh.filter(|_| !game.is_playing() && !game.menus.shell.wants_input())
    else {
        return Taken::Not;
    };
    let typing = press.into_text || game.is_typing();
    if game.controls.does(input, Action::Fullscreen) && !typing {
        game.turn_fullscreen();
    } else if game.controls.does(input, Action::Screenshot) {
        game.take_screenshot();
    } else {
        return Taken::Not;
    }
    Taken::Wholly
}

fn console(game: &mut Game, press: &Press) -> Taken {
    let input = press
        .input
        .filter(|input| press.is_fresh() && is_key(*input));
    Taken::if_true(input.is_some_and(|input| game.is_typing() && game.console_key(input)))
}

fn backpack(game: &mut Game, press: &Press) -> Taken {
    let Some(input) = press
        .input
        .filter(|_| press.is_fresh() && game.is_packing())
    else {
        return Taken::Not;
    };
    Taken::if_true(match input {
        Input::Key(_) => game.backpack_key(input),
        // The buttons of a mouse work in it, but for one that closes it. A pad's are translated to keys.
        Input::Mouse(_) if game.controls.does(input, Action::Backpack) => {
            game.close_backpack();
            true
        }
        _ => false,
    })
}

fn photo(game: &mut Game, press: &Press) -> Taken {
    let input = press.by_hand().filter(|input| is_key(*input));
    let is_photos = |game: &mut Game, input| game.photo_key(input, press.down, press.repeats);
    Taken::if_true(input.is_some_and(|input| game.is_photographing() && is_photos(game, input)))
}

fn world(game: &mut Game, press: &Press) -> Taken {
    if !game.is_playing() {
        return Taken::Not;
    }
    if let Some(input) = press.by_hand().filter(|_| !press.repeats) {
        game.input(input, press.down);
    }
    if press.down || !press.input.is_none_or(is_key) {
        Taken::Wholly
    } else {
        Taken::AndHeard
    }
}

/// Escape leads one level back; all else is the interface's.
fn menu(game: &mut Game, press: &Press) -> Taken {
    if press.input != Some(ESCAPE) || !press.down {
        return Taken::Not;
    }
    if press.is_fresh() {
        game.escape();
    }
    Taken::Wholly
}

/// The key that leads back, whatever is bound to it.
const ESCAPE: Input = Input::Key("Escape");

fn is_key(input: Input) -> bool {
    matches!(input, Input::Key(_))
}
