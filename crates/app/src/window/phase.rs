//! The phase of the game at a moment, and the phases that can follow.

use super::background::Task;
use crate::failure::Failure;
use crate::session::{NewWorld, Session, Unclosed};

/// A world to open.
#[derive(Clone, Debug, PartialEq)]
pub enum Request {
    /// Make a new one.
    New(NewWorld),
    /// Open a saved one, by name or slug.
    Load(String),
}

/// What follows when a world has been closed.
#[derive(Clone, Debug, PartialEq)]
pub enum Next {
    /// The main menu.
    Menu,
    /// Another world.
    Open(Request),
    /// The end.
    Quit,
}

/// A world on its way to being open.
pub type Opening = Task<Result<Session, Failure>>;
/// A world on its way to being closed.
pub type Closing = Task<Result<(), Unclosed>>;

/// What the game is doing.
#[derive(Debug, Default)]
pub enum Phase {
    /// Showing the main menu; no world is open.
    Menu,
    /// Reading or making a world.
    Opening(Opening),
    /// Waiting for the land around the player.
    Loading(Session),
    /// Playing.
    Playing(Session),
    /// Showing the pause menu over a world.
    Paused(Session),
    /// Saving a world that is being left.
    Closing(Closing, Next),
    /// Ended.
    #[default]
    Over,
}

impl Phase {
    /// The open world, if there is one on this thread.
    pub fn session(&self) -> Option<&Session> {
        match self {
            Self::Loading(session) | Self::Playing(session) | Self::Paused(session) => {
                Some(session)
            }
            _ => None,
        }
    }

    /// The open world, to change it.
    pub fn session_mut(&mut self) -> Option<&mut Session> {
        match self {
            Self::Loading(session) | Self::Playing(session) | Self::Paused(session) => {
                Some(session)
            }
            _ => None,
        }
    }

    /// Directory of the open world's save; empty where no world is open, or it is not kept.
    pub fn slug(&self) -> &str {
        self.session().map_or("", |session| &session.slug)
    }

    /// Whether the wheel turns a dial in the open world.
    pub fn has_dial(&self) -> bool {
        self.session()
            .is_some_and(|session| session.scene.lens().range().is_some())
    }
}
