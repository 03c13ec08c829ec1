//! The two kinds of places that are kept: worlds and rooms. Their lists and pages are the same, but for what is said and asked.

use antipode_language::{Texts, Value};

use super::{WorldFiles, WorldsIntent};
use crate::model::{Intent, MenuModel, Screen, WorldRow};

/// A kind of places.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub(crate) enum Kind {
    /// Worlds of land.
    #[default]
    World,
    /// Rooms of deformed space.
    Room,
    /// Rooms of the player's own, to build in them.
    Own,
}

/// Those of the rooms that the player has made, which come first.
fn own(rooms: &[WorldRow]) -> &[WorldRow] {
    let count = rooms.iter().take_while(|row| !row.shipped).count();
    &rooms[..count]
}

impl Kind {
    /// What a screen is about.
    pub(crate) fn of(screen: &Screen) -> Self {
        match screen {
            Screen::Rooms => Self::Room,
            Screen::Workshop => Self::Own,
            _ => Self::World,
        }
    }

    /// All places of the kind.
    pub(super) fn rows<'a>(self, model: &MenuModel<'a>) -> &'a [WorldRow] {
        match self {
            Self::World => model.worlds,
            Self::Room => model.rooms,
            Self::Own => own(model.rooms),
        }
    }

    /// What is known of places in files.
    pub(super) fn files<'a>(self, model: &MenuModel<'a>) -> &'a WorldFiles {
        match self {
            Self::World => model.world_files,
            Self::Room | Self::Own => model.room_files,
        }
    }

    /// Whether a place that is there may bear that name.
    pub(super) fn check_rename(
        self,
        model: &MenuModel<'_>,
        slug: &str,
        name: &str,
    ) -> Result<(), String> {
        match self {
            Self::World => (model.check_rename)(slug, name),
            Self::Room | Self::Own => (model.check_room_rename)(slug, name),
        }
    }

    /// Words that differ by the kind.
    pub(super) fn say(self, texts: &Texts, what: &str) -> String {
        texts.say(&self.key(what))
    }

    /// The same with values.
    pub(super) fn say_with(
        self,
        texts: &Texts,
        what: &str,
        values: &[(&str, Value<'_>)],
    ) -> String {
        texts.say_with(&self.key(what), values)
    }

    fn key(self, what: &str) -> String {
        match self {
            Self::World => format!("worlds-{what}"),
            Self::Own if matches!(what, "none" | "load" | "load-named") => {
                format!("workshop-rooms-{what}")
            }
            Self::Room | Self::Own => format!("rooms-{what}"),
        }
    }

    /// To go there.
    pub(super) fn enter(self, slug: String) -> Intent {
        match self {
            Self::World => Intent::Load { slug },
            Self::Room => Intent::EnterRoom { slug },
            Self::Own => Intent::BuildIn { slug },
        }
    }

    /// To have it gone.
    pub(super) fn delete(self, slug: String) -> Intent {
        match self {
            Self::World => Intent::Delete { slug },
            Self::Room | Self::Own => Intent::DeleteRoom { slug },
        }
    }

    /// To have something else done with it.
    pub(super) fn ask(self, what: WorldsIntent) -> Intent {
        match self {
            Self::World => Intent::Worlds(what),
            Self::Room | Self::Own => Intent::Rooms(what),
        }
    }
}
