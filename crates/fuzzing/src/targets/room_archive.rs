//! A room as one file, as it comes from others: it is refused and leaves nothing, or the room is sound.
//!
//! | bytes | what |
//! |---|---|
//! | 0 | bit 0: blocks get their checksums again; bits 1 to 3: changes to the archive; all bits: a raw archive follows |
//! | then 6 each | a change, as those of archives of worlds |
//! | the rest | the text of its room, and after a byte 0 its model, which is there as glTF, as fbx and as obj |

use antipode_rooms::{RoomsDir, folder};
use fastrand::Rng;

use super::archive::{EDIT, change};
use super::{Seen, Target, must};
use crate::forge::container;
use crate::mutation::{change_text, some};
use crate::world_folder::with_world_folder;

pub(super) const TARGET: Target = Target {
    name: "room_archive",
    run,
    seeds,
    mutate,
};

const SEAL: u8 = 1;
const RAW: u8 = 0xff;
const MAGIC: &[u8; 8] = b"ANTIROOM";
const TEXT: &str =
    "(version: 1, name: \"A\", objects: [(name: \"a\", what: Model(file: \"models/a.gltf\"))])";
/// A triangle with a material beside it.
const OBJ: &str = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n";
const FBX: &str = include_str!("../../../rooms/tests/it/square.fbx");
const MODEL: &str = r#"{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":"a.bin"}]}"#;
const WORDS: &[&str] = &[
    "../",
    "a.bin",
    "../../room.ron",
    "%2e%2e/",
    "file:///etc/passwd",
    "data:,",
    "models/a.gltf",
    "models/a.glb",
    "textures/a.png",
    "\"uri\":",
    "{",
    "}",
    "[",
    "]",
    "0",
    "-1",
    "4294967295",
    "18446744073709551615",
    "null",
    "\"images\":[{\"uri\":\"a.png\"}],",
    "\"bufferView\":9",
    "\"byteOffset\":",
    "KHR_draco_mesh_compression",
    "models/a.fbx",
    "models/a.obj",
    "mtllib a.mtl",
    "*4 {",
    "a: 0,1,-3",
    "C: \"OO\",10,20",
    "P: \"UnitScaleFactor\", \"double\", \"Number\", \"\",1e300",
    "Kaydara FBX Binary  ",
];

fn run(input: &[u8]) -> Result<Seen, String> {
    let bytes = archive(input);
    with_world_folder(|folder| {
        folder.empty().map_err(|error| error.to_string())?;
        let file = folder.beside("foreign");
        std::fs::write(&file, &bytes).map_err(|error| error.to_string())?;
        let rooms = RoomsDir::new(folder.beside("rooms"));
        let imported = rooms.import(&file);
        if let Err(error) = &imported {
            let said = error.to_string();
            must(said.len() < 4000 && !said.contains('\n'), || {
                format!("a refusal is no line: {said:.300}")
            })?;
        }
        let folders = std::fs::read_dir(rooms.path())
            .into_iter()
            .flatten()
            .flatten();
        let left: Vec<_> = folders
            .map(|it| it.file_name())
            .filter(|it| it != ".antipode.lock")
            .collect();
        must(left.len() == usize::from(imported.is_ok()), || {
            format!("there are {left:?}")
        })?;
        if let Ok(slug) = &imported {
            folder::open(&rooms.path().join(slug))
                .map_err(|error| format!("what came in is not sound: {error}"))?;
        }
        let past_checksums = container::is_sealed(&bytes);
        Ok(Seen {
            past_checksums,
            taken: imported.is_ok(),
        })
    })
}

/// The archive that an input describes.
fn archive(input: &[u8]) -> Vec<u8> {
    let (flags, rest) = match input.split_first() {
        None => return Vec::new(),
        Some((&RAW, raw)) => return raw.to_vec(),
        Some((flags, rest)) => (flags, rest),
    };
    let changes = usize::from(flags >> 1 & 7) * EDIT;
    let (edits, inner) = rest.split_at(changes.min(rest.len()));
    let middle = inner.iter().position(|it| *it == 0).unwrap_or(inner.len());
    let (text, model) = (
        &inner[..middle],
        inner.get(middle + 1..).unwrap_or_default(),
    );
    let corners = [0.0_f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0]
        .map(f32::to_le_bytes)
        .concat();
    let mut bytes = container::pack(&[
        ("room.ron", text),
        ("models/a.gltf", model),
        ("models/a.fbx", model),
        ("models/a.obj", model),
        ("models/a.mtl", b"newmtl a\nKd 1 0 0\n"),
        ("models/a.bin", &corners),
    ]);
    bytes[..MAGIC.len()].copy_from_slice(MAGIC);
    for edit in edits.chunks_exact(EDIT) {
        change(&mut bytes, edit);
    }
    if flags & SEAL != 0 {
        container::seal(&mut bytes);
    }
    bytes
}

fn seeds() -> Vec<(String, Vec<u8>)> {
    let sound = [&[SEAL], TEXT.as_bytes(), &[0], MODEL.as_bytes()].concat();
    let text = TEXT.replace("gltf", "fbx");
    let model = FBX.replace("C: \"OP\",40,30, \"DiffuseColor\"", "");
    let fbx = [&[SEAL], text.as_bytes(), &[0], model.as_bytes()].concat();
    let text = TEXT.replace("gltf", "obj");
    let obj = [&[SEAL], text.as_bytes(), &[0], OBJ.as_bytes()].concat();
    let plain = [&[SEAL], b"(version: 1, name: \"B\")".as_slice()].concat();
    let raw = [&[RAW], archive(&sound).as_slice()].concat();
    [
        ("model", sound),
        ("fbx", fbx),
        ("obj", obj),
        ("plain", plain),
        ("raw", raw),
        ("bare", vec![RAW]),
    ]
    .map(|(name, it)| (name.to_owned(), it))
    .into()
}

fn mutate(rng: &mut Rng, seed: &[u8]) -> Vec<u8> {
    let mut inner = seed.get(1..).unwrap_or_default().to_vec();
    let changes = if rng.bool() { 0 } else { rng.u8(1..4) };
    if changes == 0 {
        for _ in 0..some(rng) {
            change_text(rng, &mut inner, WORDS);
        }
    }
    let seal = u8::from(rng.u8(..8) > 0) * SEAL;
    let mut input = vec![seal | changes << 1];
    input.extend(std::iter::repeat_with(|| rng.u8(..)).take(usize::from(changes) * EDIT));
    input.extend(inner);
    input
}
