//! A room's folder: what its files are, and that none of them leads out.

use std::fs;
use std::path::Path;

use antipode_rooms::mesh::{Look, Roundness, meshes};
use antipode_rooms::room::{Object, Texture, What};
use antipode_rooms::{Room, folder, write};
use glam::DVec3;
use tempfile::TempDir;

const LAMP: &[u8] = include_bytes!("../../../../assets/models/lamp.glb");

/// A triangle as text, whose corners lie in another file.
const TRIANGLE: &str = r#"{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],
"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":"BUFFER"}]}"#;

fn corners() -> Vec<u8> {
    [0.0_f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0]
        .iter()
        .flat_map(|it| it.to_le_bytes())
        .collect()
}

fn picture(side: u32) -> Vec<u8> {
    let mut out = std::io::Cursor::new(Vec::new());
    image::RgbaImage::new(side, side)
        .write_to(&mut out, image::ImageFormat::Png)
        .unwrap();
    out.into_inner()
}

fn with_model(file: &str) -> Room {
    let mut room = Room::new("Test");
    room.push(Object::new(
        "it",
        DVec3::ZERO,
        What::Model {
            file: file.to_owned(),
            scale: 2.0,
        },
    ));
    room
}

fn put(dir: &Path, name: &str, bytes: &[u8]) {
    fs::create_dir_all(dir.join(name).parent().unwrap()).unwrap();
    fs::write(dir.join(name), bytes).unwrap();
}

fn folder_of(room: &Room) -> TempDir {
    let dir = tempfile::tempdir().unwrap();
    put(dir.path(), "room.ron", write(room).unwrap().as_bytes());
    dir
}

fn refusal(dir: &Path) -> String {
    folder::open(dir).unwrap_err().to_string()
}

#[test]
fn models_and_textures_come_with_the_room() {
    let mut room = with_model("models/lamp.glb");
    room.object_mut(0).surface.texture = Some(Texture {
        file: "textures/a.png".to_owned(),
        size: 1.0,
    });
    let dir = folder_of(&room);
    put(dir.path(), "models/lamp.glb", LAMP);
    put(dir.path(), "textures/a.png", &picture(8));
    put(dir.path(), "textures/unused.png", b"whatever");
    let loaded = folder::open(dir.path()).unwrap();
    assert_eq!(
        loaded.files,
        ["room.ron", "textures/a.png", "models/lamp.glb"]
    );
    assert_eq!(loaded.assets.textures["textures/a.png"].width(), 8);
    let made = meshes(&room, &loaded.assets, Roundness::default());
    let parts = made
        .iter()
        .filter(|it| matches!(it.look, Look::Model { .. }))
        .count();
    assert_eq!(parts, loaded.assets.models["models/lamp.glb"].parts.len());
    assert!(parts > 0);
}

#[test]
fn gltf_in_several_files_is_put_together() {
    let dir = folder_of(&with_model("models/t/tri.gltf"));
    put(
        dir.path(),
        "models/t/tri.gltf",
        TRIANGLE.replace("BUFFER", "../my%20data.bin").as_bytes(),
    );
    put(dir.path(), "models/my data.bin", &corners());
    let loaded = folder::open(dir.path()).unwrap();
    assert_eq!(
        loaded.files,
        ["room.ron", "models/t/tri.gltf", "models/my data.bin"]
    );
    let shape = &loaded.assets.models["models/t/tri.gltf"].parts[0].shape;
    assert_eq!(shape.triangles.len(), 1);
    // What looks to +z in the file looks to the room's +x.
    assert!(
        (shape.normals[0] - DVec3::X).length() < 1e-6,
        "{}",
        shape.normals[0]
    );
}

#[test]
fn several_buffers_and_pictures_come_to_lie_in_one() {
    let text = TRIANGLE
        .replace(
            "\"buffers\":[",
            "\"buffers\":[{\"byteLength\":5,\"uri\":\"five.bin\"},",
        )
        .replace("\"buffer\":0", "\"buffer\":1")
        .replace("BUFFER", "corners.bin")
        .replace("{\"POSITION\":0}", "{\"POSITION\":0},\"material\":0")
        .replace(
            "\"buffers\"",
            r#""materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],
            "textures":[{"source":0}],"images":[{"uri":"../textures/a.png"}],"buffers""#,
        );
    let dir = folder_of(&with_model("models/tri.gltf"));
    put(dir.path(), "models/tri.gltf", text.as_bytes());
    put(dir.path(), "models/five.bin", b"12345");
    put(dir.path(), "models/corners.bin", &corners());
    put(dir.path(), "textures/a.png", &picture(7));
    let loaded = folder::open(dir.path()).unwrap();
    let model = &loaded.assets.models["models/tri.gltf"];
    assert_eq!(model.textures[0].width, 7);
    let most = model.parts[0]
        .shape
        .positions
        .iter()
        .copied()
        .reduce(DVec3::max)
        .unwrap();
    assert!((most - DVec3::new(0.0, 1.0, 0.0)).length() < 1e-6, "{most}");
    // A buffer that is shorter than it says.
    put(dir.path(), "models/corners.bin", &corners()[..8]);
    assert!(refusal(dir.path()).contains("shorter than it says"));
}

#[test]
fn addresses_in_models_lead_nowhere_else() {
    let outside = tempfile::tempdir().unwrap();
    fs::write(outside.path().join("secret.bin"), corners()).unwrap();
    let secret = outside.path().join("secret.bin").display().to_string();
    for address in [
        "../../secret.bin",
        "../../../secret.bin",
        &secret,
        "file:///etc/passwd",
        "http://example.org/a.bin",
        "..\\\\a.bin",
        "data:application/octet-stream;base64,AAAA",
    ] {
        let dir = folder_of(&with_model("models/tri.gltf"));
        put(
            dir.path(),
            "models/tri.gltf",
            TRIANGLE.replace("BUFFER", address).as_bytes(),
        );
        let said = refusal(dir.path());
        let names = [":19: file of \"it\"", "models/tri.gltf"];
        assert!(
            names.iter().all(|it| said.contains(it)),
            "{address}: {said}"
        );
        assert!(
            ["leads", "data in its text"]
                .iter()
                .any(|it| said.contains(it)),
            "{address}: {said}"
        );
    }
}

#[test]
fn what_is_missing_broken_or_too_large_is_told_with_its_line() {
    let dir = folder_of(&with_model("models/a.glb"));
    let said = refusal(dir.path());
    assert!(
        said.contains("room.ron:19: file of \"it\" is \"models/a.glb\": there is no such file."),
        "{said}"
    );
    put(dir.path(), "models/a.glb", b"no model");
    let said = refusal(dir.path());
    assert!(said.contains("not a binary glTF file"), "{said}");
    let mut room = Room::new("Test");
    room.object_mut(0).surface.texture = Some(Texture {
        file: "textures/a.png".to_owned(),
        size: 1.0,
    });
    let dir = folder_of(&room);
    put(dir.path(), "textures/a.png", &picture(5000));
    let said = refusal(dir.path());
    assert!(
        said.contains("file of \"floor\"") && said.contains("5000 x 5000"),
        "{said}"
    );
    put(dir.path(), "textures/a.png", b"GIF89a");
    assert!(refusal(dir.path()).contains("neither PNG nor JPEG"));
    put(dir.path(), "textures/a.png", &picture(9)[..40]);
    assert!(refusal(dir.path()).contains("cannot be read"));
    assert!(refusal(&dir.path().join("nothing")).contains("there is no such file"));
}

#[cfg(unix)]
#[test]
fn links_are_not_followed() {
    use std::os::unix::fs::symlink;
    let elsewhere = tempfile::tempdir().unwrap();
    put(elsewhere.path(), "a.glb", LAMP);
    let dir = folder_of(&with_model("models/a.glb"));
    symlink(elsewhere.path(), dir.path().join("models")).unwrap();
    assert!(
        refusal(dir.path()).contains("link"),
        "{}",
        refusal(dir.path())
    );
    fs::remove_file(dir.path().join("models")).unwrap();
    fs::create_dir(dir.path().join("models")).unwrap();
    symlink(
        elsewhere.path().join("a.glb"),
        dir.path().join("models/a.glb"),
    )
    .unwrap();
    assert!(refusal(dir.path()).contains("link"));
    fs::remove_file(dir.path().join("models/a.glb")).unwrap();
    fs::rename(
        dir.path().join("room.ron"),
        elsewhere.path().join("room.ron"),
    )
    .unwrap();
    symlink(
        elsewhere.path().join("room.ron"),
        dir.path().join("room.ron"),
    )
    .unwrap();
    assert!(refusal(dir.path()).contains("link"));
}
