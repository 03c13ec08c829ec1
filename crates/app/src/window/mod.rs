//! The window: events in, frames out. Everything the game decides is in `game`.

mod about;
mod app;
mod backdrop;
mod background;
mod backpack;
mod console;
mod devices;
mod display;
mod events;
mod framerate;
mod game;
mod hearing;
mod hints;
mod icon;
mod injected;
mod interface;
mod layers;
mod menus;
mod naming;
mod open;
mod options;
mod orders;
mod overlays;
mod pace;
mod pads;
mod phase;
mod photo;
mod placelist;
mod play;
mod pointer;
mod portrait;
mod press;
mod reading;
mod redraw;
mod room_hud;
mod shots;
mod shown;
mod stage;
#[cfg(test)]
mod tests;
mod veil;
mod visit;
mod waits;
mod wheel;
mod workshop;

use std::path::PathBuf;

use antipode_geometry::Geometry;
use antipode_scene::Mode;
use winit::event_loop::EventLoop;

use crate::common::{Adapter, Common};
use crate::failure::Failure;
use crate::session::{Beginning, NewWorld, Worlds};
use crate::trouble::Trouble;
use app::App;
pub use injected::Fault;
use phase::Request;
use placelist::Kept;

/// How the game before this one ended, to be told.
#[derive(Clone, Debug, PartialEq)]
pub enum After {
    /// It crashed; the report.
    Crash(PathBuf),
    /// Its graphics failed for good.
    Graphics(Trouble),
}

/// How the game begins.
#[derive(Clone, Debug, PartialEq)]
pub enum Start {
    /// In the main menu.
    Menu,
    /// In a new world.
    New {
        /// Its space.
        geometry: Geometry,
        /// Its seed; random when left out.
        seed: Option<u64>,
        /// Its name; a free one when left out.
        name: Option<String>,
        /// Its radius, for a spherical or hyperbolic world.
        radius_m: Option<f64>,
        /// What building costs.
        mode: Mode,
    },
    /// In the main menu, with words about how the game before it ended.
    After(After),
    /// In a saved world.
    Load {
        /// Its name.
        name: String,
    },
    /// In a room.
    Room {
        /// Its name.
        name: String,
    },
}

/// Opens the window and plays until it is closed.
///
/// # Errors
/// When no window can be opened, or the adapter fails.
pub fn run(start: Start, common: &Common, inject: Option<Fault>) -> Result<(), Failure> {
    if common.adapter == Adapter::None {
        return Err(Failure::Usage(
            "The game in its window needs an adapter; --adapter none is for scripts".to_owned(),
        ));
    }
    let worlds = Worlds::new(common);
    let after = match &start {
        Start::After(after) => Some(after.clone()),
        _ => None,
    };
    let first = first_request(start, &worlds)?;
    let events = EventLoop::new().map_err(|e| Failure::no_window(&e))?;
    let mut app = App::new(common, worlds, first, after, inject);
    let ended = events.run_app(&mut app);
    let (failure, unsaved) = app.ended();
    match (failure, unsaved) {
        (None | Some(Failure::Stopped(_)), Some(unsaved)) => Err(Failure::Runtime(unsaved)),
        (Some(failure), Some(unsaved)) => Err(Failure::Runtime(format!("{failure} {unsaved}"))),
        (Some(failure), None) => Err(failure),
        (None, None) => ended.map_err(|e| Failure::no_window(&e)),
    }
}

fn first_request(start: Start, worlds: &Worlds) -> Result<Option<Request>, Failure> {
    Ok(match start {
        Start::Menu | Start::After(_) => None,
        Start::New {
            geometry,
            seed,
            name,
            radius_m,
            mode,
        } => {
            let name = name.unwrap_or_else(|| worlds.free_name());
            Some(Request::New(NewWorld {
                geometry,
                name: Some(name),
                seed,
                radius_m,
                generator: None,
                mode,
                start: Beginning::View,
            }))
        }
        Start::Load { name } => Some(Request::Load(worlds.saves().find(&name)?.slug)),
        Start::Room { name } => Some(Request::Room(Kept::slug(&worlds.rooms().find(&name)?))),
    })
}
