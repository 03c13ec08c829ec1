//! Small files made on the spot, and those of the game.

use std::fs;
use std::path::Path;
use std::sync::LazyLock;

/// A .glb of a description and data.
pub fn glb(json: &str, data: &[u8]) -> Vec<u8> {
    let mut text = json.as_bytes().to_vec();
    text.resize(text.len().next_multiple_of(4), b' ');
    let mut data = data.to_vec();
    data.resize(data.len().next_multiple_of(4), 0);
    let mut out = b"glTF\x02\0\0\0".to_vec();
    out.extend((12 + 8 + text.len() as u32 + 8 + data.len() as u32).to_le_bytes());
    out.extend((text.len() as u32).to_le_bytes());
    out.extend(b"JSON");
    out.extend(text);
    out.extend((data.len() as u32).to_le_bytes());
    out.extend(b"BIN\0");
    out.extend(data);
    out
}

/// Little-endian bytes of floats.
pub fn floats(values: &[f32]) -> Vec<u8> {
    values.iter().flat_map(|v| v.to_le_bytes()).collect()
}

/// A file with one triangle whose parts can be replaced: pairs of what stands there and what shall.
pub fn triangle(changes: &[(&str, &str)], positions: &[f32], more: &[u8]) -> Vec<u8> {
    let mut data = floats(positions);
    let own = data.len();
    data.extend(more);
    let mut json = format!(
        r#"{{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],"nodes":[{{"name":"n","mesh":0}}],
        "meshes":[{{"name":"m","primitives":[{{"attributes":{{"POSITION":0}}}}]}}],
        "accessors":[{{"bufferView":0,"componentType":5126,"count":{},"type":"VEC3","min":[0,0,0],"max":[1,1,0]}}],
        "bufferViews":[{{"buffer":0,"byteLength":{own}}}],"buffers":[{{"byteLength":{}}}]}}"#,
        positions.len() / 3,
        data.len()
    );
    for (old, new) in changes {
        assert!(json.contains(old), "{old}");
        json = json.replace(old, new);
    }
    glb(&json, &data)
}

/// Corners of a triangle that faces +z.
pub const CORNERS: [f32; 9] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];

/// All files of the game, by their names without `.glb`, in the order of those.
pub static FILES: LazyLock<Vec<(String, Vec<u8>)>> = LazyLock::new(|| {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets/models");
    let paths = folder.read_dir().unwrap().map(|it| it.unwrap().path());
    let models = paths.filter(|path| path.extension().is_some_and(|it| it == "glb"));
    let named = models.map(|path| {
        let name = path.file_stem().unwrap().to_str().unwrap();
        (name.to_owned(), fs::read(&path).unwrap())
    });
    let mut files: Vec<_> = named.collect();
    files.sort();
    assert!(files.len() >= 10, "the models were not found");
    files
});

/// The file of that name.
pub fn file(name: &str) -> &'static [u8] {
    let (_, bytes) = FILES.iter().find(|(it, _)| it == name).unwrap();
    bytes
}
