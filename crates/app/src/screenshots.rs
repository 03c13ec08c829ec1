//! Screenshots and photos: where they go, what they are called, and writing them without ever replacing a file.

use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::time::{SystemTime, UNIX_EPOCH};

use antipode_language::Texts;
use antipode_storage::is_saves_dir_named;
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder, RgbaImage};

use crate::common::Common;
use crate::dates::stamp;

/// Pictures of one moment are told apart by a number up to this.
const MOST_ALIKE: u32 = 1000;

/// The folder that pictures are kept in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Album {
    dir: PathBuf,
}

/// Why a picture could not be kept.
#[derive(Debug)]
pub struct Unkept {
    /// What was to be written.
    path: PathBuf,
    error: io::Error,
}

impl Album {
    /// The folder for the pictures of a game whose worlds are in `saves`: whoever says on the command line, or in the
    /// environment, where worlds are kept has their pictures beside them. Otherwise they go where the system keeps
    /// pictures, if it says so.
    pub fn new(common: &Common, saves: &Path) -> Self {
        let told = is_saves_dir_named(common.saves_dir.as_deref());
        let pictures =
            directories::UserDirs::new().and_then(|dirs| dirs.picture_dir().map(Path::to_path_buf));
        Self {
            dir: folder(saves, pictures.filter(|_| !told)),
        }
    }

    /// Pictures are kept in this folder.
    pub fn at(dir: PathBuf) -> Self {
        Self { dir }
    }

    /// Where pictures go.
    pub fn dir(&self) -> &Path {
        &self.dir
    }

    /// What a picture of that world taken now is called, without its ending; the slug may be empty.
    pub fn stem(slug: &str) -> String {
        let now_s = SystemTime::now()
            .duration_since(UNIX_EPOCH)
            .map_or(0, |since| since.as_secs());
        let world = if slug.is_empty() { "antipode" } else { slug };
        format!("{world} {}", stamp(now_s))
    }

    /// Encodes a picture and writes it under a name that no file has. Takes its time: not for the main thread.
    ///
    /// # Errors
    /// When the folder cannot be made or the file not written; a file begun is taken away again.
    pub fn keep(&self, stem: &str, picture: &RgbaImage) -> Result<PathBuf, Unkept> {
        let at = |path: &Path| {
            let path = path.to_path_buf();
            move |error| Unkept { path, error }
        };
        fs::create_dir_all(&self.dir).map_err(at(&self.dir))?;
        let (path, file) = create(&self.dir, stem).map_err(at(&self.dir.join(stem)))?;
        write(file, picture).map_err(|error| {
            // What is left of it is no picture.
            let _ = fs::remove_file(&path);
            at(&path)(error)
        })?;
        Ok(path)
    }
}

impl Unkept {
    /// The failure as a sentence.
    pub fn words(&self, texts: &Texts) -> String {
        let path = self.path.display().to_string();
        let values = [("path", path.as_str().into())];
        match self.error.kind() {
            ErrorKind::StorageFull | ErrorKind::QuotaExceeded | ErrorKind::FileTooLarge => {
                texts.say_with("picture-disk-full", &values)
            }
            ErrorKind::PermissionDenied | ErrorKind::ReadOnlyFilesystem => {
                texts.say_with("picture-read-only", &values)
            }
            _ => {
                let reason = self.error.to_string();
                let values = [("path", path.as_str().into()), ("reason", reason.into())];
                texts.say_with("picture-not-kept", &values)
            }
        }
    }
}

fn folder(saves: &Path, pictures: Option<PathBuf>) -> PathBuf {
    match pictures {
        Some(pictures) => pictures.join("Antipode"),
        None => saves.with_file_name("screenshots"),
    }
}

fn create(dir: &Path, stem: &str) -> io::Result<(PathBuf, File)> {
    for number in 1..=MOST_ALIKE {
        let name = match number {
            1 => format!("{stem}.png"),
            _ => format!("{stem} ({number}).png"),
        };
        let path = dir.join(name);
        match OpenOptions::new().write(true).create_new(true).open(&path) {
            Ok(file) => return Ok((path, file)),
            Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
            Err(error) => return Err(error),
        }
    }
    Err(ErrorKind::AlreadyExists.into())
}

fn write(file: File, picture: &RgbaImage) -> io::Result<()> {
    let mut out = BufWriter::new(file);
    let encoder =
        PngEncoder::new_with_quality(&mut out, CompressionType::Fast, FilterType::Adaptive);
    let (width, height) = picture.dimensions();
    encoder
        .write_image(picture.as_raw(), width, height, ExtendedColorType::Rgba8)
        .map_err(|error| match error {
            image::ImageError::IoError(error) => error,
            other => io::Error::other(other.to_string()),
        })?;
    out.flush()?;
    out.get_ref().sync_all()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

    use super::*;

    fn picture(grey: u8) -> RgbaImage {
        RgbaImage::from_pixel(3, 2, image::Rgba([grey, grey, grey, 255]))
    }

    #[test]
    fn pictures_lie_beside_the_saves_or_where_the_system_keeps_pictures() {
        let saves = Path::new("/home/me/games/saves");
        assert_eq!(folder(saves, None), Path::new("/home/me/games/screenshots"));
        assert_eq!(folder(Path::new("saves"), None), Path::new("screenshots"));
        let pictures = Some(PathBuf::from("/home/me/Bilder"));
        assert_eq!(
            folder(saves, pictures),
            Path::new("/home/me/Bilder/Antipode")
        );
    }

    #[test]
    fn a_picture_is_called_by_its_world_and_its_time() {
        assert!(Album::stem("my-world").starts_with("my-world 20"));
        assert!(Album::stem("").starts_with("antipode 20"));
    }

    #[test]
    fn no_picture_ever_takes_the_place_of_another() {
        let dir = tempfile::tempdir().unwrap();
        let album = Album::at(dir.path().join("screenshots"));
        let kept: Vec<_> = (0..3)
            .map(|grey| album.keep("w", &picture(grey)).unwrap())
            .collect();
        for (grey, path) in (0..).zip(&kept) {
            assert_eq!(image::open(path).unwrap().to_rgba8(), picture(grey));
        }
        assert!(kept[1].ends_with("w (2).png"), "{kept:?}");
    }

    #[test]
    fn what_cannot_be_written_is_told_in_words_and_leaves_nothing() {
        let dir = tempfile::tempdir().unwrap();
        let file = dir.path().join("screenshots");
        fs::write(&file, b"in the way").unwrap();
        let unkept = Album::at(file).keep("w", &picture(0)).unwrap_err();
        let words = unkept.words(&Texts::default());
        assert!(words.contains("screenshots"), "{words}");
        for (kind, word) in [
            (ErrorKind::StorageFull, "space"),
            (ErrorKind::ReadOnlyFilesystem, "read-only"),
        ] {
            let unkept = Unkept {
                path: PathBuf::from("w.png"),
                error: kind.into(),
            };
            let words = unkept.words(&Texts::default());
            assert!(words.contains(word) && words.contains("w.png"), "{words}");
        }
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_full_disk_is_told_and_the_beginning_of_the_picture_is_taken_away() {
        let full = OpenOptions::new().write(true).open("/dev/full").unwrap();
        let error = write(full, &picture(7)).unwrap_err();
        assert_eq!(error.kind(), ErrorKind::StorageFull);
    }
}
