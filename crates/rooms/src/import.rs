//! Files that a player brings from elsewhere: looked at first, and then copied into the room's folder, so that no path of the machine
//! is ever part of a room.

use std::fs;
use std::path::{Path, PathBuf};

use crate::bounds::MOST_PIXELS;
use crate::files::{MODELS, TEXTURES, most_bytes};
use crate::folder::picture;
use crate::model;

/// Letters of the name that a file gets.
const LONGEST_STEM: usize = 40;
/// What a file is called of whose name nothing is left.
const NAMELESS: &str = "file";

/// A file that has become one of the room's.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Imported {
    /// The name of a model.
    Model(String),
    /// The name of a texture.
    Texture(String),
}

/// Copies a model or a picture, with the files that it has beside it, into the room in a folder. Waits for the disk.
///
/// # Errors
/// A sentence: what is wrong with the file, and what can be done.
pub fn import(dir: &Path, from: &Path) -> Result<Imported, String> {
    taken(dir, from).map_err(|reason| {
        let said = from.file_name().unwrap_or_default().to_string_lossy();
        let reason = reason.trim_end_matches('.');
        format!("{} was not taken: {reason}.", crate::check::shown(&said))
    })
}

fn taken(dir: &Path, from: &Path) -> Result<Imported, String> {
    let ending = from.extension().unwrap_or_default().to_string_lossy();
    let ending = ending.to_ascii_lowercase();
    let stem = plain(&from.file_stem().unwrap_or_default().to_string_lossy());
    let is_picture = matches!(ending.as_str(), "png" | "jpg" | "jpeg");
    let is_model = matches!(ending.as_str(), "glb" | "gltf" | "fbx" | "obj");
    let name = |number: u32| {
        let stem = match number {
            1 => stem.clone(),
            number => format!("{stem} {number}"),
        };
        if is_picture {
            format!("{TEXTURES}/{stem}.{ending}")
        } else {
            format!("{MODELS}/{stem}/{stem}.{ending}")
        }
    };
    let most = most_bytes(&name(1)).filter(|_| is_picture || is_model);
    let most = most.ok_or(
        "models are glb, gltf, fbx or obj, and pictures png or jpg; save it as one of these",
    )?;
    let mut all = vec![(name(1), read(from, most)?)];
    if is_picture {
        picture(&all[0].1, MOST_PIXELS)?;
    } else {
        parts(&mut all, from)?;
    }
    let free = (1..1000).find(|number| is_free(dir, &all, &name(1), &name(*number)));
    let number = free.ok_or("the room has too many files of that name")?;
    copy(dir, &all, &name(1), &name(number))?;
    let name = name(number);
    Ok(if is_picture {
        Imported::Texture(name)
    } else {
        Imported::Model(name)
    })
}

/// Writes files that are not there yet.
fn copy(dir: &Path, all: &[(String, Vec<u8>)], old: &str, new: &str) -> Result<(), String> {
    for (file, bytes) in all {
        let file = moved(file, old, new);
        let path = file
            .split('/')
            .fold(dir.to_path_buf(), |path, it| path.join(it));
        if !path.exists() {
            antipode_storage::new_file(&path, bytes).map_err(|it| it.to_string())?;
        }
    }
    Ok(())
}

/// Reads the model that is first in the list, and adds what it has beside it.
fn parts(all: &mut Vec<(String, Vec<u8>)>, from: &Path) -> Result<(), String> {
    let (name, bytes) = all[0].clone();
    let within = name.rsplit_once('/').map_or("", |it| it.0).to_owned() + "/";
    let beside: PathBuf = from.parent().map_or_else(PathBuf::new, Path::to_path_buf);
    model::load(&name, &bytes, &mut |part| {
        let Some(place) = part.strip_prefix(&within) else {
            return Err(format!(
                "its part {part} does not lie beside it; put it there"
            ));
        };
        let most = most_bytes(part).ok_or("no room has such a file")?;
        let path = place
            .split('/')
            .fold(beside.clone(), |path, it| path.join(it));
        let bytes = read(&path, most).map_err(|reason| format!("its part {place}: {reason}"))?;
        if all.iter().all(|(known, _)| known != part) {
            all.push((part.to_owned(), bytes.clone()));
        }
        Ok(bytes)
    })?;
    Ok(())
}

fn read(path: &Path, most: u64) -> Result<Vec<u8>, String> {
    let length = fs::metadata(path).map_err(|error| error.to_string())?.len();
    if length > most {
        return Err(format!(
            "it has {length} bytes, and at most {most} can be taken"
        ));
    }
    antipode_storage::read_file(path, most).map_err(|error| error.to_string())
}

/// Whether the room has nothing else where these would come to lie.
fn is_free(dir: &Path, all: &[(String, Vec<u8>)], old: &str, new: &str) -> bool {
    all.iter().all(|(file, bytes)| {
        let file = moved(file, old, new);
        let path = file
            .split('/')
            .fold(dir.to_path_buf(), |path, it| path.join(it));
        fs::symlink_metadata(&path).is_err() || fs::read(&path).is_ok_and(|it| it == *bytes)
    })
}

/// The name of a file of an import whose first file is called otherwise.
fn moved(file: &str, old: &str, new: &str) -> String {
    if file == old {
        return new.to_owned();
    }
    let folder = |name: &str| name.rsplit_once('/').map_or("", |it| it.0).to_owned();
    let place = file.strip_prefix(&folder(old)).unwrap_or(file);
    folder(new) + place
}

/// What of a name may be in that of a room's file.
fn plain(stem: &str) -> String {
    let kept: String = stem
        .chars()
        .map(|it| {
            if it.is_alphanumeric() || "-_ ".contains(it) {
                it
            } else {
                '-'
            }
        })
        .take(LONGEST_STEM)
        .collect();
    let mut kept = kept.trim_matches([' ', '-']).to_owned();
    while kept.len() > LONGEST_STEM {
        kept.pop();
    }
    let kept = kept.trim().to_owned();
    if kept.is_empty() || antipode_storage::is_reserved_name(&kept) {
        NAMELESS.to_owned()
    } else {
        kept
    }
}
