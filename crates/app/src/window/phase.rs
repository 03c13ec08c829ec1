//! The phase of the game at a moment, and the phases that can follow.

use super::background::Task;
use super::visit::Visit;
use crate::failure::Failure;
use crate::rooms::OpenRoom;
use crate::session::{NewWorld, Session, Unclosed};

/// A world or a room to open.
#[derive(Clone, Debug, PartialEq)]
pub enum Request {
    /// Make a new one.
    New(NewWorld),
    /// Open a saved one, by name or slug.
    Load(String),
    /// Make a room of that name, or of one that nobody has, and enter it.
    NewRoom(Option<String>),
    /// Enter a room, by what the menu knows it by.
    Room(String),
    /// Enter a room, by its name.
    RoomNamed(String),
    /// Build in a room, by what the menu knows it by.
    Build(String),
    /// Make a room of a name that nobody has, and build in it.
    BuildNew,
}

/// What was opened.
#[derive(Debug)]
pub enum Opened {
    /// A world.
    World(Box<Session>),
    /// A room, and whether it is to be built in.
    Room(Box<OpenRoom>, bool),
}

/// What follows when a world has been closed, or a room left.
#[derive(Clone, Debug, PartialEq)]
pub enum Next {
    /// The main menu.
    Menu,
    /// Another world, or a room.
    Open(Request),
    /// The end.
    Quit,
}

/// A world or a room on its way to being open.
pub type Opening = Task<Result<Opened, Failure>>;
/// A world on its way to being closed.
pub type Closing = Task<Result<(), Unclosed>>;

/// What the game is doing.
#[derive(Debug, Default)]
pub enum Phase {
    /// Showing the main menu; nothing is open.
    Menu,
    /// Reading or making a world or a room.
    Opening(Opening),
    /// Waiting for the land around the player.
    Loading(Session),
    /// Playing.
    Playing(Session),
    /// Showing the pause menu over a world.
    Paused(Session),
    /// Playing in a room, or waiting for its first picture.
    InRoom(Box<Visit>),
    /// Showing the pause menu over a room.
    RoomPaused(Box<Visit>),
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

    /// The open room, if there is one.
    pub fn visit(&self) -> Option<&Visit> {
        match self {
            Self::InRoom(visit) | Self::RoomPaused(visit) => Some(visit),
            _ => None,
        }
    }

    /// The open room, to change it.
    pub fn visit_mut(&mut self) -> Option<&mut Visit> {
        match self {
            Self::InRoom(visit) | Self::RoomPaused(visit) => Some(visit),
            _ => None,
        }
    }

    /// Whether a world or a room is played.
    pub fn is_played(&self) -> bool {
        match self {
            Self::Playing(_) => true,
            Self::InRoom(visit) => visit.is_drawn && visit.workshop.is_none(),
            _ => false,
        }
    }

    /// Whether somebody builds in a room.
    pub fn is_built(&self) -> bool {
        matches!(self, Self::InRoom(visit) if visit.workshop.is_some())
    }

    /// Whether the pause menu is over a world or a room.
    pub fn is_paused(&self) -> bool {
        matches!(self, Self::Paused(_) | Self::RoomPaused(_))
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
