//! The picture of a world or room for the menu: drawn while the game goes on, even while the world is being closed.

use std::io::Cursor;
use std::path::Path;

use antipode_rays::View as RoomLook;
use antipode_scene::frame::{Frame, View};
use crossbeam_channel::{Receiver, Sender, bounded};
use image::{ImageFormat, RgbaImage};

use crate::room_picture::RoomView;

/// Width over height of the menu's pictures of worlds.
const ASPECT: f64 = 16.0 / 9.0;

/// What a frame shows, with nothing that the player is told of it, in a picture for the menu.
pub fn portrait_of(frame: &Frame) -> View {
    let mut view = View {
        hand: None,
        shows_marks: false,
        ..frame.view.clone()
    };
    view.projection.sx = view.projection.sy / ASPECT;
    view
}

/// What a room's picture shows, by the game's own rule and with nothing in the hand.
pub fn room_portrait_of(view: &RoomView) -> RoomView {
    let mut view = view.clone();
    view.moment.hand = None;
    view.tile = None;
    view.options.view = RoomLook::Exact;
    view
}

/// What a picture for the menu is of.
#[derive(Clone, Debug)]
pub enum PortraitView {
    /// A world.
    World(View),
    /// A room.
    Room(RoomView),
}

/// Writes a picture whole or not at all; that it cannot be written is no matter for the player.
pub fn write_portrait(picture: &RgbaImage, path: &Path) {
    let mut png = Cursor::new(Vec::new());
    let written = match picture.write_to(&mut png, ImageFormat::Png) {
        Ok(()) => {
            antipode_storage::replace_file(path, png.get_ref()).map_err(|why| why.to_string())
        }
        Err(why) => Err(why.to_string()),
    };
    if let Err(why) = written {
        tracing::info!("the menu's picture could not be written: {why}");
    }
}

/// What becomes of the picture of the open world.
#[derive(Debug, Default)]
pub struct Portrait {
    /// One should be taken.
    pub is_wanted: bool,
    /// The one that is being drawn.
    last: Option<LastPicture>,
}

/// A picture that is being drawn.
#[derive(Debug)]
struct LastPicture {
    /// Which of the worlds opened so far it shows.
    world: u64,
    /// Where it goes when the world is being closed.
    to: Option<Sender<RgbaImage>>,
}

impl Portrait {
    /// A picture of the world is being drawn: its number among the worlds opened so far, of which none has the same. A call
    /// of [`Portrait::hand_over`] or [`Portrait::miss`] is to follow.
    pub fn expect(&mut self, world: u64) -> u64 {
        self.last = Some(LastPicture { world, to: None });
        world
    }

    /// The world is being closed; the picture that is being drawn, or word that there is none, comes here.
    pub fn comes_later(&mut self) -> Option<Receiver<RgbaImage>> {
        let (sender, receiver) = bounded(1);
        self.last.as_mut()?.to = Some(sender);
        Some(receiver)
    }

    /// A picture of that world is drawn. Hands it to whoever closes the world, else back.
    pub fn hand_over(&mut self, world: u64, picture: RgbaImage) -> Option<RgbaImage> {
        let expected = self.last.take_if(|last| last.world == world);
        let Some(to) = expected.and_then(|last| last.to) else {
            return Some(picture);
        };
        // Whoever closes the world may have lost patience.
        let _ = to.try_send(picture);
        None
    }

    /// There will be no picture.
    pub fn miss(&mut self) {
        self.last = None;
    }
}
