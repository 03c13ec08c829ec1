//! Screenshots in the game: asked for, taken with the next frame, written in the background, told in a line.

use std::collections::VecDeque;
use std::path::{Path, PathBuf};

use antipode_render::RenderError;
use antipode_ui::ToastKind;
use image::RgbaImage;

use super::background::{Progress, Task};
use super::game::Game;
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

    /// Writes a picture in the background.
    pub fn keep(&mut self, stem: String, picture: RgbaImage) {
        let album = self.album.clone();
        self.wait_for(Task::start("picture", move || album.keep(&stem, &picture)));
    }

    /// Tells of a picture when it has been written.
    pub fn wait_for(&mut self, writing: Task<Result<PathBuf, Unkept>>) {
        self.writing.push(writing);
    }
}

impl Game {
    /// Takes over what only the window knows: the adapter's name, and where pictures go.
    /// And what was entered in the console before, which lies beside the settings.
    pub fn begin_in(&mut self, adapter: &str, album: Album, settings: Option<&Path>) {
        adapter.clone_into(&mut self.console.adapter);
        self.shots.album = album;
        if let Some(settings) = settings {
            self.console
                .remember_in(settings.with_file_name("console-history.txt"));
        }
    }

    /// Keeps the next frame as a picture.
    pub fn take_screenshot(&mut self) {
        let slug = self.phase.session().map_or("", |session| &session.slug);
        self.shots.want(Album::stem(slug));
    }

    /// The frame in which a picture is to be taken has been drawn. Returns whether there is one to take.
    pub fn begin_screenshot(&mut self) -> bool {
        let wanted = self.shots.wanted.take();
        let begun = wanted.is_some();
        self.shots.taken.extend(wanted);
        begun
    }

    /// Takes the picture over that was begun first.
    pub fn keep_screenshot(&mut self, picture: Result<RgbaImage, RenderError>) {
        let Some(stem) = self.shots.taken.pop_front() else {
            return;
        };
        match picture {
            Ok(picture) => self.shots.keep(stem, picture),
            Err(error) => self.picture_failed(&error.to_string()),
        }
    }

    /// There is no picture, for that reason.
    pub(super) fn picture_failed(&mut self, reason: &str) {
        tracing::error!("no picture was taken: {reason}");
        let values = [("reason", reason.into())];
        self.menus
            .toast(ToastKind::Problem, "picture-not-taken", &values);
    }

    /// Tells of pictures that have been written.
    pub(super) fn tell_pictures(&mut self) {
        let mut place = 0;
        while place < self.shots.writing.len() {
            match self.shots.writing[place].poll() {
                Progress::Running => {
                    place += 1;
                    continue;
                }
                Progress::Done(Ok(file)) => {
                    let file = file.display().to_string();
                    let values = [("file", file.into())];
                    self.menus.toast(ToastKind::Info, "picture-kept", &values);
                }
                Progress::Done(Err(unkept)) => {
                    tracing::error!("{unkept:?}");
                    self.menus
                        .shell
                        .toast(unkept.words(&self.menus.texts), ToastKind::Problem);
                }
                Progress::Died => self.picture_failed("the thread that writes it ended"),
            }
            self.shots.writing.remove(place);
        }
    }

    /// Waits until all pictures are written.
    pub(super) fn finish_pictures(&mut self) {
        for task in self.shots.writing.drain(..) {
            task.finish();
        }
    }
}
