//! A room's folder as a whole: its text and every file that it names, each looked at before any of it is given out.

use std::collections::{BTreeMap, HashMap, HashSet};
use std::fs;
use std::io::Cursor;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use image::{ImageFormat, ImageReader, Limits, RgbaImage};

use crate::bounds::{
    LARGEST_TEXTURE_PX, MOST_FILES, MOST_FOLDER_BYTES, MOST_MODELS, MOST_PIXELS, MOST_ROOM_BYTES,
    MOST_TRIANGLES,
};
use crate::check::shown;
use crate::error::{Fault, RoomError};
use crate::files::{ROOM_FILE, most_bytes};
use crate::lines;
use crate::mesh::{Roundness, meshes};
use crate::model::{self, RoomModel};
use crate::read::read;
use crate::room::{Room, What};

/// What a room's objects are made of besides what `room.ron` says.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Assets {
    /// Models by their file.
    pub models: BTreeMap<String, Arc<RoomModel>>,
    /// Textures by their file, sRGB.
    pub textures: BTreeMap<String, Arc<RgbaImage>>,
}

impl Assets {
    /// Those of them that a room names; none if it names others, too.
    pub fn of(&self, room: &Room) -> Option<Self> {
        let mut all = Self::default();
        for object in &room.objects {
            if let What::Model { file, .. } = &object.what {
                let model = self.models.get(file)?.clone();
                all.models.insert(file.clone(), model);
            }
            if let Some(it) = &object.surface.texture {
                let texture = self.textures.get(&it.file)?.clone();
                all.textures.insert(it.file.clone(), texture);
            }
        }
        Some(all)
    }

    /// Adds others.
    pub fn add(&mut self, others: &Self) {
        let (models, textures) = (others.models.clone(), others.textures.clone());
        self.models.extend(models);
        self.textures.extend(textures);
    }
}

/// A room that is sound, with all that it needs.
#[derive(Debug, Clone, PartialEq)]
pub struct Loaded {
    /// The room.
    pub room: Room,
    /// Its models and textures.
    pub assets: Assets,
    /// The names of the files that it is made of, [`ROOM_FILE`] first.
    pub files: Vec<String>,
    /// What all of them have together, bytes.
    pub bytes: u64,
}

/// The text of the room in a folder.
///
/// # Errors
/// [`RoomError::File`] if it cannot be read.
pub(crate) fn read_text(dir: &Path) -> Result<Vec<u8>, RoomError> {
    let path = dir.join(ROOM_FILE);
    antipode_storage::read_file(&path, MOST_ROOM_BYTES).map_err(|error| RoomError::File {
        path,
        reason: in_words(&error),
    })
}

fn in_words(error: &std::io::Error) -> String {
    match error.kind() {
        std::io::ErrorKind::NotFound => "there is no such file".to_owned(),
        std::io::ErrorKind::PermissionDenied => "its permissions forbid to read it".to_owned(),
        _ => error.to_string().trim_end_matches('.').to_owned(),
    }
}

/// Reads the room in a folder, and every file that it names.
///
/// # Errors
/// The first thing that is wrong: in the text with its line and field; in a file that the text names, with the line and
/// field that names it.
pub fn open(dir: &Path) -> Result<Loaded, RoomError> {
    let bytes = read_text(dir)?;
    let label = dir.join(ROOM_FILE).display().to_string();
    let room = read(&label, &bytes)?;
    let mut files = Files::of(dir, bytes.len() as u64);
    let assets = gather(&room, &mut files).map_err(|(path, reason)| {
        let line = lines::line_of(&String::from_utf8_lossy(&bytes), &path);
        let fault = fault(&room, path, &reason);
        RoomError::Text {
            file: label.clone(),
            line,
            fault,
        }
    })?;
    let (files, bytes) = (files.names, files.bytes);
    Ok(Loaded {
        room,
        assets,
        files,
        bytes,
    })
}

/// Reads the files in a folder that a room names, which is not the one that its `room.ron` has.
///
/// # Errors
/// [`RoomError::Unsound`]: the field that names what is wrong.
pub fn assets(dir: &Path, room: &Room) -> Result<Assets, RoomError> {
    gather(room, &mut Files::of(dir, 0))
        .map_err(|(path, reason)| RoomError::Unsound(fault(room, path, &reason)))
}

/// What is wrong with a file, told of the field that names it.
fn fault(room: &Room, path: String, reason: &str) -> Fault {
    let index = path
        .split(['[', ']'])
        .nth(1)
        .and_then(|it| it.parse::<usize>().ok());
    let object = index.and_then(|it| room.objects.get(it));
    let name = object.map_or_else(|| "the room".to_owned(), |it| shown(&it.name));
    let last = path.rsplit('.').next().unwrap_or_default();
    Fault {
        field: format!("{last} of {name}"),
        reason: printable(reason),
        path,
    }
}

/// A sentence that quotes what strangers have written: on one line, and not too long.
pub(crate) fn printable(sentence: &str) -> String {
    let shown = sentence
        .chars()
        .filter(|it| !antipode_storage::is_unprintable(*it));
    shown.take(400).collect()
}

/// The files of a room that have been read.
struct Files<'a> {
    dir: &'a Path,
    known: HashSet<String>,
    names: Vec<String>,
    bytes: u64,
}

impl<'a> Files<'a> {
    /// Only `room.ron`, of so many bytes, has been read.
    fn of(dir: &'a Path, bytes: u64) -> Self {
        Self {
            dir,
            known: HashSet::new(),
            names: vec![ROOM_FILE.to_owned()],
            bytes,
        }
    }

    /// Reads a file of the room, or says why it cannot be read.
    fn read(&mut self, name: &str) -> Result<Vec<u8>, String> {
        let most = most_bytes(name).ok_or("no room has such a file")?;
        let mut path: PathBuf = self.dir.to_path_buf();
        for part in name.split('/') {
            let is_link = fs::symlink_metadata(&path).is_ok_and(|data| data.is_symlink());
            if is_link && path != self.dir {
                return Err(
                    "it lies behind a link, which leads out of the room's folder".to_owned(),
                );
            }
            path.push(part);
        }
        let bytes = antipode_storage::read_file(&path, most).map_err(|error| in_words(&error))?;
        if self.known.insert(name.to_ascii_lowercase()) {
            self.names.push(name.to_owned());
            self.bytes += bytes.len() as u64;
        }
        if self.names.len() > MOST_FILES || self.bytes > MOST_FOLDER_BYTES {
            return Err(format!(
                "with it the room has more than {MOST_FILES} files or {MOST_FOLDER_BYTES} bytes"
            ));
        }
        Ok(bytes)
    }
}

/// Reads models and textures; an error is the field that names what is wrong, and why.
fn gather(room: &Room, files: &mut Files<'_>) -> Result<Assets, (String, String)> {
    let mut assets = Assets::default();
    let mut pixels = 0;
    for (index, object) in room.objects.iter().enumerate() {
        if let What::Model { file, .. } = &object.what
            && !assets.models.contains_key(file)
        {
            let refuse = |reason: String| {
                (
                    format!("objects[{index}].what.file"),
                    format!("is \"{file}\": {reason}"),
                )
            };
            if assets.models.len() == MOST_MODELS {
                return Err(refuse(format!(
                    "a room has at most {MOST_MODELS} different models"
                )));
            }
            let bytes = files.read(file).map_err(refuse)?;
            let model = model::load(file, &bytes, &mut |part| {
                files
                    .read(part)
                    .map_err(|reason| format!("its part {part}: {reason}"))
            });
            assets
                .models
                .insert(file.clone(), Arc::new(model.map_err(refuse)?));
        }
        if let Some(texture) = &object.surface.texture
            && !assets.textures.contains_key(&texture.file)
        {
            let file = &texture.file;
            let refuse = |reason: String| {
                (
                    format!("objects[{index}].surface.texture.file"),
                    format!("is \"{file}\": {reason}"),
                )
            };
            let bytes = files.read(file).map_err(refuse)?;
            let picture = picture(&bytes, MOST_PIXELS - pixels).map_err(refuse)?;
            pixels += u64::from(picture.width()) * u64::from(picture.height());
            assets.textures.insert(file.clone(), Arc::new(picture));
        }
    }
    check_triangles(room, &assets).map_err(|reason| ("objects".to_owned(), reason))?;
    Ok(assets)
}

/// Reads a picture of at most `most_pixels`.
pub(crate) fn picture(bytes: &[u8], most_pixels: u64) -> Result<RgbaImage, String> {
    let unreadable = |error: &dyn std::fmt::Display| format!("it cannot be read ({error})");
    let format = image::guess_format(bytes).map_err(|_| "it is neither PNG nor JPEG".to_owned())?;
    if !matches!(format, ImageFormat::Png | ImageFormat::Jpeg) {
        return Err("it is neither PNG nor JPEG".to_owned());
    }
    let (width, height) = ImageReader::with_format(Cursor::new(bytes), format)
        .into_dimensions()
        .map_err(|error| unreadable(&error))?;
    if width.max(height) > LARGEST_TEXTURE_PX || width == 0 || height == 0 {
        return Err(format!(
            "it has {width} x {height} pixels, and each side is to have 1 to {LARGEST_TEXTURE_PX}"
        ));
    }
    if u64::from(width) * u64::from(height) > most_pixels {
        return Err(format!(
            "with it the room's textures have more than {MOST_PIXELS} pixels together"
        ));
    }
    let mut reader = ImageReader::with_format(Cursor::new(bytes), format);
    let mut limits = Limits::default();
    limits.max_image_width = Some(LARGEST_TEXTURE_PX);
    limits.max_image_height = Some(LARGEST_TEXTURE_PX);
    reader.limits(limits);
    Ok(reader
        .decode()
        .map_err(|error| unreadable(&error))?
        .to_rgba8())
}

/// Equal solids share their triangles, and are counted once.
fn check_triangles(room: &Room, assets: &Assets) -> Result<(), String> {
    let mut shapes = HashMap::new();
    for mesh in meshes(room, assets, Roundness::default()) {
        shapes.insert(Arc::as_ptr(&mesh.shape), mesh.shape);
    }
    let triangles: usize = shapes.values().map(|it| it.triangles.len()).sum();
    if triangles > MOST_TRIANGLES {
        return Err(format!(
            "have {triangles} triangles together, and a room has at most {MOST_TRIANGLES}"
        ));
    }
    Ok(())
}
