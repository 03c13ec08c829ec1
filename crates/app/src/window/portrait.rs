//! A world's picture for the menu: drawn while the game goes on, even while the world is being closed.

use antipode_scene::frame::Frame;
use crossbeam_channel::{Receiver, Sender, bounded};
use image::RgbaImage;

use super::background::Task;
use super::game::Game;

/// Width over height of the menu's pictures.
const ASPECT: f64 = 16.0 / 9.0;

/// A picture that is being drawn.
#[derive(Debug)]
pub struct LastPicture {
    /// Which of the worlds opened so far it shows.
    world: u64,
    /// Where it goes when the world is being closed.
    to: Option<Sender<RgbaImage>>,
}

impl LastPicture {
    /// The world is being closed; its picture, or word that there is none, comes here.
    pub fn comes_later(&mut self) -> Receiver<RgbaImage> {
        let (sender, receiver) = bounded(1);
        self.to = Some(sender);
        receiver
    }
}

impl Game {
    /// Whether a picture of the world should be taken for the menu; asked for once.
    pub fn take_wants_picture(&mut self) -> bool {
        std::mem::take(&mut self.wants_picture)
    }

    /// What a picture of the open world for the menu shows: the world, and nothing that the player is told of it.
    pub fn portrait(&mut self, height_px: u32) -> Option<Frame> {
        let frame = self.frame(ASPECT, height_px)?;
        Some(Frame {
            hand: None,
            marker: None,
            hit_shapes: Vec::new(),
            ..frame
        })
    }

    /// A picture of the open world is being drawn: its number among the worlds opened so far, of which none has the
    /// same. [`Game::keep_picture`] or [`Game::miss_picture`] is to follow.
    pub fn expect_picture(&mut self) -> u64 {
        let world = self.worlds_opened;
        self.last_picture = Some(LastPicture { world, to: None });
        world
    }

    /// Keeps a picture of the world with that number if it is still open, or being closed, and writes it in the
    /// background.
    pub fn keep_picture(&mut self, world: u64, picture: RgbaImage) {
        let expected = self.last_picture.take_if(|last| last.world == world);
        if let Some(to) = expected.and_then(|last| last.to) {
            // Whoever closes the world may have lost patience.
            let _ = to.try_send(picture);
            return;
        }
        if world != self.worlds_opened {
            return;
        }
        if let Some(session) = self.phase.session_mut() {
            let write = session.keep_picture(picture);
            Task::start("picture", write);
        }
    }

    /// There will be no picture.
    pub fn miss_picture(&mut self) {
        self.last_picture = None;
    }
}
