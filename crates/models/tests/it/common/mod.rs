//! Small files made on the spot.

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

/// All files of the game.
pub const FILES: [(&str, &[u8]); 9] = [
    ("astronaut", antipode_models::ASTRONAUT),
    ("astronaut_teal", antipode_models::ASTRONAUT_TEAL),
    ("car", antipode_models::CAR),
    (
        "lamp",
        include_bytes!("../../../../../assets/models/lamp.glb"),
    ),
    (
        "bullet",
        include_bytes!("../../../../../assets/models/bullet.glb"),
    ),
    (
        "gun",
        include_bytes!("../../../../../assets/models/gun.glb"),
    ),
    (
        "wooden_pickaxe",
        include_bytes!("../../../../../assets/models/wooden_pickaxe.glb"),
    ),
    (
        "iron_pickaxe",
        include_bytes!("../../../../../assets/models/iron_pickaxe.glb"),
    ),
    (
        "diamond_pickaxe",
        include_bytes!("../../../../../assets/models/diamond_pickaxe.glb"),
    ),
];
