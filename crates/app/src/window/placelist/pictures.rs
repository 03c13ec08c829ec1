//! The pictures of the list: read and decoded in the background, a few at a time.

use std::collections::{HashMap, VecDeque};
use std::fs;
use std::io::Cursor;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use egui::{ColorImage, Context, TextureHandle, TextureId, TextureOptions};
use image::{ImageFormat, ImageReader, Limits};

use crate::window::background::{Progress, Task};

/// How many worlds are shown with their picture, the newest.
const MOST: usize = 128;
/// How many are decoded in one piece of work.
const BATCH: usize = 8;
/// How many are handed to the adapter in one frame.
const UPLOADS: usize = 2;
/// A longer file is no picture of this game's, bytes.
const MOST_BYTES: u64 = 16 << 20;
/// Longer sides than this are no picture of this game's, pixels.
const MOST_SIDE: u32 = 4096;
/// Size that pictures are shown at, pixels; larger ones are made smaller.
const SHOWN: (u32, u32) = (320, 180);

/// What tells a picture from the one that was there before.
type Stamp = (Option<SystemTime>, u64);

/// A picture that has been read.
#[derive(Debug)]
struct Read {
    slug: String,
    stamp: Stamp,
    /// None if there is none that could be shown.
    image: Option<ColorImage>,
}

/// Where a picture of a world or room is.
#[derive(Clone, Debug)]
pub enum PictureSource {
    /// In a file, which need not exist.
    File(PathBuf),
    /// In the game itself: a PNG file's bytes.
    Game(&'static [u8]),
}

/// A picture to be read.
struct Wanted {
    /// Of which world.
    slug: String,
    source: PictureSource,
    /// What was there when it was read last.
    before: Option<Stamp>,
}

/// The pictures of the list.
#[derive(Default)]
pub struct Pictures {
    shown: HashMap<String, (Stamp, Option<TextureHandle>)>,
    wanted: VecDeque<Wanted>,
    task: Option<Task<Vec<Read>>>,
    read: VecDeque<Read>,
}

impl std::fmt::Debug for Pictures {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Pictures")
            .field("shown", &self.shown.len())
            .field("wanted", &self.wanted.len())
            .finish_non_exhaustive()
    }
}

impl Pictures {
    /// Asks for the pictures of these, each with its slug; those that have not changed are not read again.
    pub fn want(&mut self, places: impl Iterator<Item = (String, Option<PictureSource>)>) {
        self.wanted = places
            .take(MOST)
            .filter_map(|(slug, source)| {
                let before = self.shown.get(&slug).map(|(stamp, _)| *stamp);
                let source = source?;
                Some(Wanted {
                    slug,
                    source,
                    before,
                })
            })
            .collect();
        let wanted = &self.wanted;
        self.shown
            .retain(|slug, _| wanted.iter().any(|wanted| wanted.slug == *slug));
        self.go_on();
    }

    /// Takes in what has been read. Never blocks.
    pub fn poll(&mut self) {
        match self.task.as_ref().map(Task::poll) {
            None | Some(Progress::Running) => return,
            Some(Progress::Done(read)) => self.read.extend(read),
            // The places of those pictures stay empty; the panic is in the log.
            Some(Progress::Died) => {}
        }
        self.task = None;
        self.go_on();
    }

    fn go_on(&mut self) {
        if self.task.is_some() || self.wanted.is_empty() {
            return;
        }
        let batch: Vec<_> = self.wanted.drain(..self.wanted.len().min(BATCH)).collect();
        let work = move || batch.into_iter().filter_map(read).collect();
        self.task = Some(Task::start("pictures", work));
    }

    /// Hands some of what has been read to the adapter.
    pub fn upload(&mut self, context: &Context) {
        for _ in 0..UPLOADS {
            let Some(read) = self.read.pop_front() else {
                return;
            };
            let texture = read.image.map(|image| {
                context.load_texture(
                    format!("world {}", read.slug),
                    image,
                    TextureOptions::LINEAR,
                )
            });
            self.shown.insert(read.slug, (read.stamp, texture));
        }
        if !self.read.is_empty() {
            context.request_repaint();
        }
    }

    /// The picture of a world, if it has one and it is ready.
    pub fn of(&self, slug: &str) -> Option<TextureId> {
        let (_, texture) = self.shown.get(slug)?;
        texture.as_ref().map(TextureHandle::id)
    }

    /// Whether everything asked for has been read.
    pub fn is_idle(&self) -> bool {
        self.task.is_none() && self.wanted.is_empty()
    }
}

/// Reads a picture; none if it is the one that was there before.
fn read(wanted: Wanted) -> Option<Read> {
    let Wanted {
        slug,
        source,
        before,
    } = wanted;
    let (stamp, data) = match &source {
        PictureSource::File(path) => {
            let data = fs::metadata(path).ok()?;
            ((data.modified().ok(), data.len()), Some(data))
        }
        PictureSource::Game(bytes) => ((None, bytes.len() as u64), None),
    };
    if before == Some(stamp) {
        return None;
    }
    let image = match (&source, data) {
        (PictureSource::File(path), Some(data)) => of_file(path, &data),
        (PictureSource::Game(bytes), _) => decode(bytes.to_vec(), "a picture of the game"),
        (PictureSource::File(_), None) => None,
    };
    Some(Read { slug, stamp, image })
}

fn of_file(path: &Path, data: &fs::Metadata) -> Option<ColorImage> {
    if !data.is_file() || data.len() > MOST_BYTES {
        return None;
    }
    decode(fs::read(path).ok()?, &path.display().to_string())
}

fn decode(bytes: Vec<u8>, called: &str) -> Option<ColorImage> {
    let mut reader = ImageReader::with_format(Cursor::new(bytes), ImageFormat::Png);
    let mut limits = Limits::default();
    limits.max_image_width = Some(MOST_SIDE);
    limits.max_image_height = Some(MOST_SIDE);
    reader.limits(limits);
    let mut picture = reader
        .decode()
        .inspect_err(|error| tracing::info!("{called} is no picture: {error}"))
        .ok()?;
    if picture.width() > SHOWN.0 || picture.height() > SHOWN.1 {
        picture = picture.thumbnail(SHOWN.0, SHOWN.1);
    }
    let pixels = picture.to_rgba8();
    let size = [pixels.width() as usize, pixels.height() as usize];
    Some(ColorImage::from_rgba_unmultiplied(size, pixels.as_raw()))
}
