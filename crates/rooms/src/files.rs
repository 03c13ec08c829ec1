//! The names of a room's files, and what a name in one of them leads to. No name leads out of the room's folder.
//!
//! A name is `room.ron`, or parts between slashes of which the first is `models` or `textures`; parts are of letters,
//! digits, `-`, `_`, `.` and blanks, so that they mean the same on every system.

use crate::bounds::{MOST_MODEL_BYTES, MOST_ROOM_BYTES, MOST_TEXTURE_BYTES};

/// The file that says what a room is.
pub const ROOM_FILE: &str = "room.ron";
/// The folder of models.
pub const MODELS: &str = "models";
/// The folder of textures.
pub const TEXTURES: &str = "textures";

/// How many parts a name may have, and how long one and all may be.
const MOST_PARTS: usize = 4;
const MOST_PART_BYTES: usize = 64;
const MOST_NAME_BYTES: usize = 160;
const PICTURES: [&str; 3] = ["png", "jpg", "jpeg"];
const SHAPES: [&str; 4] = ["glb", "gltf", "fbx", "obj"];

/// What models have beside them: bytes of glTF, materials of obj.
const PARTS: [&str; 2] = ["bin", "mtl"];

/// How long the file of that name may be; nothing if no room has such a file.
pub fn most_bytes(name: &str) -> Option<u64> {
    if name == ROOM_FILE {
        return Some(MOST_ROOM_BYTES);
    }
    check_parts(name).ok()?;
    let (folder, _) = name.split_once('/')?;
    let ending = ending(name);
    let is_picture = PICTURES.contains(&ending.as_str());
    match folder {
        MODELS if SHAPES.contains(&ending.as_str()) || PARTS.contains(&ending.as_str()) => {
            Some(MOST_MODEL_BYTES)
        }
        MODELS | TEXTURES if is_picture => Some(MOST_TEXTURE_BYTES),
        _ => None,
    }
}

/// Whether a name can be that of a model.
pub(crate) fn check_model(name: &str) -> Result<(), String> {
    check_file(name, MODELS, &SHAPES)
}

/// Whether a name can be that of a texture.
pub(crate) fn check_texture(name: &str) -> Result<(), String> {
    check_file(name, TEXTURES, &PICTURES)
}

fn check_file(name: &str, folder: &str, endings: &[&str]) -> Result<(), String> {
    let said = crate::check::shown(name);
    check_parts(name).map_err(|reason| format!("is {said}: {reason}"))?;
    if name
        .split_once('/')
        .is_none_or(|(first, _)| first != folder)
    {
        return Err(format!(
            "is {said}, and is to be a file in the room's folder {folder}, such as \"{folder}/name.{}\"",
            endings[0]
        ));
    }
    if endings.contains(&ending(name).as_str()) {
        return Ok(());
    }
    Err(format!(
        "is {said}, and files that end in {} can be read",
        endings.join(", ")
    ))
}

fn ending(name: &str) -> String {
    name.rsplit_once('.')
        .map(|(_, ending)| ending.to_ascii_lowercase())
        .unwrap_or_default()
}

/// Whether every part of a name is a plain one.
fn check_parts(name: &str) -> Result<(), String> {
    if name.len() > MOST_NAME_BYTES {
        return Err(format!("it has more than {MOST_NAME_BYTES} bytes"));
    }
    if name.starts_with('/') || name.contains(['\\', ':']) {
        return Err("it leads out of the room's folder; a room's files are in it".to_owned());
    }
    let mut parts = 0;
    for part in name.split('/') {
        parts += 1;
        if part == ".." || part == "." {
            return Err("it leads out of the room's folder; a room's files are in it".to_owned());
        }
        let is_fit = |it: char| it.is_alphanumeric() || "-_. ".contains(it);
        if part.is_empty() || part.len() > MOST_PART_BYTES || !part.chars().all(is_fit) {
            return Err(format!(
                "each part of a file's name is 1 to {MOST_PART_BYTES} letters, digits, '-', '_', '.' and blanks"
            ));
        }
        if part.starts_with(['.', ' ']) || part.ends_with(['.', ' ']) {
            return Err(
                "no part of a file's name begins or ends with a point or a blank".to_owned(),
            );
        }
        let stem = part.split('.').next().unwrap_or_default().trim();
        if antipode_storage::is_reserved_name(stem) {
            return Err(format!("{stem} is a device on some systems, and no file"));
        }
    }
    if parts > MOST_PARTS {
        return Err(format!("it lies in more than {} folders", MOST_PARTS - 1));
    }
    Ok(())
}

/// The room's file that an address in one of its files means: `address` in the model `base` of the room. Addresses are
/// relative, with `%20` and the like for characters; `..` may lead up within the room.
///
/// # Errors
/// Why there can be no such file in the room, to follow the address.
pub(crate) fn resolve(base: &str, address: &str) -> Result<String, String> {
    let plain = unescaped(address).ok_or("is no address")?;
    if plain.starts_with('/') || plain.contains(['\\', ':']) {
        return Err("leads out of the room's folder".to_owned());
    }
    let mut parts: Vec<&str> = base.split('/').collect();
    parts.pop();
    for part in plain.split('/') {
        match part {
            "." => {}
            ".." => {
                parts.pop().ok_or("leads out of the room's folder")?;
            }
            part => parts.push(part),
        }
    }
    let name = parts.join("/");
    match most_bytes(&name) {
        Some(_) if name != ROOM_FILE => Ok(name),
        _ => Err("leads to no file that a room can have".to_owned()),
    }
}

/// The text with its `%20` and the like as characters.
fn unescaped(address: &str) -> Option<String> {
    let mut out = Vec::with_capacity(address.len());
    let mut rest = address.as_bytes();
    while let Some((byte, after)) = rest.split_first() {
        if *byte == b'%' {
            let digits = std::str::from_utf8(after.get(..2)?).ok()?;
            out.push(u8::from_str_radix(digits, 16).ok()?);
            rest = &after[2..];
        } else {
            out.push(*byte);
            rest = after;
        }
    }
    String::from_utf8(out).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_those_of_a_rooms_files() {
        for name in [
            "room.ron",
            "models/house.glb",
            "models/a/b.gltf",
            "models/a.FBX",
            "models/a.bin",
            "models/a.obj",
            "models/a.mtl",
            "textures/Ziegel 2.PNG",
        ] {
            assert!(most_bytes(name).is_some(), "{name}");
        }
        for name in [
            "",
            "room.ro",
            "Room.ron/",
            "house.glb",
            "/etc/passwd.png",
            "textures/../room.ron",
            "textures/../../a.png",
            "textures/./a.png",
            "textures//a.png",
            "textures/a.exe",
            "textures/a.glb",
            "textures\\a.png",
            "C:/a.png",
            "textures/C:a.png",
            "textures/.a.png",
            "textures/a.png.",
            "textures/con.png",
            "textures/com1.x.png",
            "models/a/b/c/d.glb",
            "textures/\u{202e}.png",
            "textures/a\0.png",
            "textures",
            "textures/",
        ] {
            assert!(most_bytes(name).is_none(), "{name}");
        }
        assert!(most_bytes(&format!("textures/{}.png", "a".repeat(70))).is_none());
    }

    #[test]
    fn addresses_stay_in_the_room() {
        let to = |address: &str| resolve("models/house/house.gltf", address).ok();
        assert_eq!(to("house.bin").as_deref(), Some("models/house/house.bin"));
        assert_eq!(
            to("../stone%20wall.png").as_deref(),
            Some("models/stone wall.png")
        );
        assert_eq!(
            to("../../textures/a.png").as_deref(),
            Some("textures/a.png")
        );
        assert_eq!(to("./house.bin").as_deref(), Some("models/house/house.bin"));
        for out in [
            "../../../a.png",
            "../../../../textures/a.png",
            "/textures/a.png",
            "file:///etc/passwd",
            "http://x/a.png",
            "//x/a.png",
            "..%2f..%2f..%2fa.png",
            "..\\a.png",
            "../../room.ron",
            "%zz.png",
            "%",
            "a%0",
            "",
            "a.png\0",
            "%ff.png",
        ] {
            assert_eq!(to(out), None, "{out}");
        }
    }
}
