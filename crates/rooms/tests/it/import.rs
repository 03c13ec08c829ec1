//! Files from elsewhere: copied into the room with what they have beside them, or refused in a sentence.

use std::fs;
use std::path::Path;

use antipode_rooms::import::{Imported, import};
use antipode_rooms::room::{Object, What};
use antipode_rooms::{Room, folder};
use glam::DVec3;
use tempfile::TempDir;

/// A square of 2 m, half a metre before its origin, of a red material.
const OBJ: &str =
    "mtllib it is red.mtl\nv -1 0 0.5\nv 1 0 0.5\nv 1 2 0.5\nv -1 2 0.5\nusemtl red\nf 1 2 3 4\n";
const MTL: &str = "newmtl red\nKd 0.8 0.1 0.05\n";

fn elsewhere(files: &[(&str, &[u8])]) -> TempDir {
    let dir = tempfile::tempdir().unwrap();
    for (name, bytes) in files {
        fs::write(dir.path().join(name), bytes).unwrap();
    }
    dir
}

fn picture() -> Vec<u8> {
    let mut out = std::io::Cursor::new(Vec::new());
    let image = image::RgbaImage::new(4, 4);
    image.write_to(&mut out, image::ImageFormat::Png).unwrap();
    out.into_inner()
}

/// A room that has that model, as it is read from its folder.
fn opened(dir: &Path, file: &str) -> folder::Assets {
    let mut room = Room::new("Test");
    let (file, scale) = (file.to_owned(), 1.0);
    room.push(Object::new("it", DVec3::ZERO, What::Model { file, scale }));
    folder::assets(dir, &room).unwrap()
}

#[test]
fn an_obj_comes_with_its_materials_and_stands_as_its_file_says() {
    let from = elsewhere(&[
        ("chair: 1.OBJ", OBJ.as_bytes()),
        ("it is red.mtl", MTL.as_bytes()),
    ]);
    let room = tempfile::tempdir().unwrap();
    let Imported::Model(file) = import(room.path(), &from.path().join("chair: 1.OBJ")).unwrap()
    else {
        panic!("it is a model")
    };
    assert_eq!(file, "models/chair- 1/chair- 1.obj");
    drop(from);
    let assets = opened(room.path(), &file);
    let model = &assets.models[&file];
    let part = &model.parts[0];
    assert_eq!(part.shape.triangles.len(), 2);
    assert!(
        (part.shape.normals[0] - DVec3::X).length() < 1e-9,
        "{part:?}"
    );
    let corner = DVec3::new(0.5, 2.0, 1.0);
    assert!(
        part.shape
            .positions
            .iter()
            .any(|it| (*it - corner).length() < 1e-9)
    );
    let colour = model.materials[part.material].colour;
    assert!((colour.x - 0.8).abs() < 1e-6, "{colour}");
}

#[test]
fn the_same_file_is_copied_once_and_another_of_its_name_beside_it() {
    let png = picture();
    let from = elsewhere(&[("a.png", &png), ("b.obj", OBJ.as_bytes())]);
    let room = tempfile::tempdir().unwrap();
    let take = |name: &str| import(room.path(), &from.path().join(name)).unwrap();
    assert_eq!(
        take("a.png"),
        Imported::Texture("textures/a.png".to_owned())
    );
    assert_eq!(
        take("a.png"),
        Imported::Texture("textures/a.png".to_owned())
    );
    assert_eq!(take("b.obj"), Imported::Model("models/b/b.obj".to_owned()));
    fs::write(from.path().join("b.obj"), OBJ.replace("0.5", "0.7")).unwrap();
    assert_eq!(
        take("b.obj"),
        Imported::Model("models/b 2/b 2.obj".to_owned())
    );
    assert_eq!(fs::read(room.path().join("textures/a.png")).unwrap(), png);
}

#[test]
fn what_cannot_be_taken_is_told_and_leaves_nothing_behind() {
    let files: [(&str, &[u8]); 7] = [
        ("a.exe", b"MZ"),
        ("a.png", b"no picture"),
        ("a.glb", b"glTF no model"),
        ("a.fbx", &[0; 999]),
        ("empty.obj", b"# nothing\n"),
        (
            "wild.obj",
            b"v 1 2\nf 1 2 9999999 -7\nf -1 -1 -1\n\xff\xfe\0",
        ),
        ("..png", b"x"),
    ];
    let from = elsewhere(&files);
    let room = tempfile::tempdir().unwrap();
    for (name, _) in files {
        let why = import(room.path(), &from.path().join(name)).unwrap_err();
        assert!(
            why.contains("was not taken: ") && why.ends_with('.'),
            "{why}"
        );
    }
    let why = import(room.path(), Path::new("/nowhere/a.png")).unwrap_err();
    assert!(why.contains("was not taken"), "{why}");
    let large = fs::File::create(from.path().join("large.obj")).unwrap();
    large.set_len(1 << 40).unwrap();
    let why = import(room.path(), &from.path().join("large.obj")).unwrap_err();
    assert!(why.contains("1099511627776 bytes"), "{why}");
    assert_eq!(fs::read_dir(room.path()).unwrap().count(), 0);
}

#[test]
fn no_damaged_obj_or_picture_makes_the_game_panic() {
    let mut rng = fastrand::Rng::with_seed(24);
    let png = picture();
    for number in 0..400 {
        let (name, mut bytes) = match number % 3 {
            0 => ("a.png", png.clone()),
            _ => ("a.obj", OBJ.repeat(3).into_bytes()),
        };
        for _ in 0..=(number % 9) {
            let at = rng.usize(..bytes.len());
            match rng.u8(..3) {
                0 => bytes[at] = rng.u8(..),
                1 => bytes.truncate(at.max(1)),
                _ => bytes.insert(at, b"0123456789-/. \n"[rng.usize(..15)]),
            }
        }
        let from = elsewhere(&[(name, &bytes), ("it is red.mtl", MTL.as_bytes())]);
        let room = tempfile::tempdir().unwrap();
        if let Ok(Imported::Model(file)) = import(room.path(), &from.path().join(name)) {
            opened(room.path(), &file);
        }
    }
}
