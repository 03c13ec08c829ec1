//! Screenshots in the game: asked for, taken with the next frame, written in the background, told in a line.

use std::collections::VecDeque;
use std::path::PathBuf;

use antipode_render::RenderError;
use antipode_ui::ToastKind;
use image::RgbaImage;

use super::background::{Progress, Task};
use super::menus::Menus;
use super::phase::Phase;
use crate::screenshots::{Album, Unkept};

/// Most pictures that are asked for and not written yet: a key held down must not fill the memory.
const MOST_UNDER_WAY: usize = 4;

/// Pictures on their way.
#[derive(Debug)]
pub struct Shots {
    pub(super) album: Album,
    /// What the picture of the next frame is to be called.
    wanted: Option<String>,
    /// What those are called that the adapter has not handed over yet, in its order.
    taken: VecDeque<String>,
    writing: Vec<Task<Result<PathBuf, Unkept>>>,
}

impl Shots {
    /// None yet.
    pub fn new(album: Album) -> Self {
        Self {
            album,
            wanted: None,
            taken: VecDeque::new(),
            writing: Vec::new(),
        }
    }

    /// The next frame is to be kept under that name.
    pub fn want(&mut self, stem: String) {
        if self.taken.len() + self.writing.len() < MOST_UNDER_WAY {
            self.wanted = Some(stem);
        }
    }

    /// Whether the frame that is about to be drawn is to be kept.
    pub fn is_now(&self) -> bool {
        self.wanted.is_some()
    }

    /// Whether no picture is on its way.
    pub fn is_idle(&self) -> bool {
        self.wanted.is_none() && self.taken.is_empty() && self.writing.is_empty()
    }

    /// Keeps the next frame as a picture of what is being done.
    pub fn want_of(&mut self, phase: &Phase) {
        let room = phase.visit().and_then(|visit| visit.room.kept.as_ref());
        self.want(Album::stem(room.map_or(phase.slug(), |kept| &kept.slug)));
    }

    /// Writes a picture in the background.
    pub fn write(&mut self, stem: String, picture: impl FnOnce() -> RgbaImage + Send + 'static) {
        let album = self.album.clone();
        let write = move || album.keep(&stem, &picture());
        self.writing.push(Task::start("picture", write));
    }

    /// The frame in which a picture is to be taken has been drawn. Returns whether there is one to take.
    pub fn begin(&mut self) -> bool {
        let wanted = self.wanted.take();
        let begun = wanted.is_some();
        self.taken.extend(wanted);
        begun
    }

    /// Takes the picture over that was begun first.
    pub fn keep(&mut self, picture: Result<RgbaImage, RenderError>, menus: &mut Menus) {
        let Some(stem) = self.taken.pop_front() else {
            return;
        };
        match picture {
            Ok(picture) => self.write(stem, move || picture),
            Err(error) => menus.tell_no_picture(&error.to_string()),
        }
    }

    /// Tells of pictures that have been written.
    pub fn tell(&mut self, menus: &mut Menus) {
        self.writing.retain(|task| {
            match task.poll() {
                Progress::Running => return true,
                Progress::Done(Ok(file)) => {
                    let values = [("file", file.display().to_string().into())];
                    menus.toast(ToastKind::Info, "picture-kept", &values);
                }
                Progress::Done(Err(unkept)) => {
                    tracing::error!("{unkept:?}");
                    let words = unkept.words(&menus.texts);
                    menus.shell.toast(words, ToastKind::Problem);
                }
                Progress::Died => menus.tell_no_picture("the thread that writes it ended"),
            }
            false
        });
    }

    /// Waits until all pictures are written.
    pub fn finish(&mut self) {
        for task in self.writing.drain(..) {
            task.finish();
        }
    }
}
