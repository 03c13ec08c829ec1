//! Models in fbx: as large, as turned and as coloured as their file says, and within bounds.

use std::fs;

use antipode_rooms::room::{Object, What};
use antipode_rooms::{Loaded, Room, folder, write};
use glam::DVec3;
use tempfile::TempDir;

/// A square of 2 m, half a metre before its origin, whose material's picture lay on its maker's disk.
const SQUARE: &str = include_str!("square.fbx");

fn with_model(file: &str, text: &str) -> TempDir {
    let mut room = Room::new("Test");
    let what = What::Model {
        file: file.to_owned(),
        scale: 1.0,
    };
    room.push(Object::new("it", DVec3::ZERO, what));
    let dir = tempfile::tempdir().unwrap();
    fs::write(dir.path().join("room.ron"), write(&room).unwrap()).unwrap();
    fs::create_dir(dir.path().join("models")).unwrap();
    fs::write(dir.path().join(file), text).unwrap();
    dir
}

fn picture(side: u32) -> Vec<u8> {
    let mut out = std::io::Cursor::new(Vec::new());
    image::RgbaImage::new(side, side)
        .write_to(&mut out, image::ImageFormat::Png)
        .unwrap();
    out.into_inner()
}

fn opened(dir: &TempDir) -> Result<Loaded, String> {
    folder::open(dir.path()).map_err(|error| error.to_string())
}

/// The square without a picture.
fn plain() -> String {
    SQUARE.replace("C: \"OP\",40,30, \"DiffuseColor\"", "")
}

#[test]
fn a_model_is_as_large_and_stands_as_its_file_says() {
    let loaded = opened(&with_model("models/square.fbx", &plain())).unwrap();
    let model = &loaded.assets.models["models/square.fbx"];
    let [part] = model.parts.as_slice() else {
        panic!("{model:?}")
    };
    assert_eq!(part.shape.triangles.len(), 2);
    // Centimetres of the file are metres here, and what looks to +z there looks to +x.
    for (x, y, z) in [
        (0.5, 0.0, 1.0),
        (0.5, 0.0, -1.0),
        (0.5, 2.0, 1.0),
        (0.5, 2.0, -1.0),
    ] {
        let corner = DVec3::new(x, y, z);
        let near = |it: &DVec3| (*it - corner).length() < 1e-9;
        assert!(part.shape.positions.iter().any(near), "{corner}: {part:?}");
    }
    for [a, b, c] in &part.shape.triangles {
        let [a, b, c] = [a, b, c].map(|it| part.shape.positions[*it as usize]);
        assert!((b - a).cross(c - a).x > 0.0, "its inside is shown");
    }
    assert!((part.shape.normals[0] - DVec3::X).length() < 1e-9);
    let colour = model.materials[part.material].colour;
    assert!(
        (colour.x - 0.8).abs() < 1e-6 && (colour.y - 0.1).abs() < 1e-6,
        "{colour}"
    );
}

#[test]
fn its_picture_lies_beside_it_wherever_it_lay_before() {
    let dir = with_model("models/square.FBX", SQUARE);
    let said = opened(&dir).unwrap_err();
    assert!(
        said.contains("models/brick.png") && said.contains("no such file"),
        "{said}"
    );
    fs::write(dir.path().join("models/brick.png"), picture(6)).unwrap();
    let loaded = opened(&dir).unwrap();
    let model = &loaded.assets.models["models/square.FBX"];
    assert_eq!(model.textures[0].width, 6);
    assert_eq!(model.materials[model.parts[0].material].texture, Some(0));
    assert!(loaded.files.iter().any(|it| it == "models/brick.png"));
    // The picture's lower edge is the square's.
    let shape = &model.parts[0].shape;
    for (position, uv) in shape.positions.iter().zip(&shape.uvs) {
        assert!(
            (uv.y - (1.0 - position.y / 2.0)).abs() < 1e-9,
            "{position} {uv}"
        );
    }
}

#[test]
fn what_is_none_or_too_large_is_refused_with_the_field_that_names_it() {
    let polygons = "0,1,-3,".repeat(200_001);
    let many = plain()
        .replace(
            "*4 {\n\t\t\ta: 0,1,2,-4",
            &format!("*600003 {{\n\t\t\ta: {}", polygons.trim_end_matches(',')),
        )
        .replace("LayerElementUV", "LayerElementNone");
    let cases = [
        (many, "200001 triangles"),
        (plain().replace("-100,0,0,100", "-1e12,0,0,100"), "no place"),
        (plain().replace("0,1,2,-4", "0,1,-3"), ""),
        (plain().replace("C: \"OO\",10,20", ""), "no triangles"),
        ("no model".to_owned(), "cannot be used"),
        (String::new(), "cannot be used"),
        // Another kind of model, which the reader knows as well.
        (
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".to_owned(),
            "cannot be used",
        ),
        (SQUARE.replace("brick.png", "..\\\\secret"), "its picture"),
    ];
    for (text, wanted) in cases {
        let said = opened(&with_model("models/a.fbx", &text)).err();
        let said = said.unwrap_or_default();
        assert!(said.contains(wanted), "{wanted}: {said:.300}");
        let is_told = said.contains("file of \"it\"") && said.contains("room.ron:");
        assert!(wanted.is_empty() || is_told, "{said:.300}");
    }
}
