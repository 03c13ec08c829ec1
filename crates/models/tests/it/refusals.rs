//! What cannot be shown is refused in plain words, and no bytes make the loader panic.

use crate::common::{CORNERS, FILES, file, floats, glb, triangle};
use antipode_models::{Error, Model, Note};
use proptest::prelude::*;

fn refusal(bytes: &[u8]) -> Error {
    Model::from_glb(bytes).expect_err("it should have been refused")
}

#[test]
fn each_refusal_is_one_sentence() {
    let needs = |name: &str| {
        triangle(
            &[(
                r#""scene":0"#,
                &format!(r#""scene":0,"extensionsRequired":["{name}"]"#),
            )],
            &CORNERS,
            &[],
        )
    };
    let attribute = r#""attributes":{"POSITION":0}"#;
    let cases = [
        (b"PK\x03\x04 and more".to_vec(), "not a binary glTF"),
        (b"glTF\x01\0\0\0\x14\0\0\0".to_vec(), "version 1"),
        (
            needs("KHR_draco_mesh_compression"),
            "KHR_draco_mesh_compression",
        ),
        (needs("EXT_meshopt_compression"), "EXT_meshopt_compression"),
        (needs("KHR_texture_basisu"), "KHR_texture_basisu"),
        (
            triangle(
                &[(
                    attribute,
                    r#""attributes":{"POSITION":0},"targets":[{"POSITION":0}]"#,
                )],
                &CORNERS,
                &[],
            ),
            "morph targets",
        ),
        (
            triangle(
                &[(attribute, r#""attributes":{"POSITION":0},"mode":1"#)],
                &CORNERS,
                &[],
            ),
            "points or lines",
        ),
        (
            triangle(
                &[(r#""buffers":[{"#, r#""buffers":[{"uri":"far.bin","#)],
                &CORNERS,
                &[],
            ),
            "another file",
        ),
        (
            triangle(&[(r#""mesh":0}"#, r#""mesh":7}"#)], &CORNERS, &[]),
            "damaged",
        ),
        (
            triangle(
                &[(r#""mesh":0}"#, r#""mesh":0,"children":[0]}"#)],
                &CORNERS,
                &[],
            ),
            "tree",
        ),
        (
            triangle(&[(r#""count":3"#, r#""count":3000000000"#)], &CORNERS, &[]),
            "too many",
        ),
        (
            triangle(&[(r#""count":3"#, r#""count":4"#)], &CORNERS, &[]),
            "does not have",
        ),
        (
            triangle(&[(r#","mesh":0}"#, "}")], &CORNERS, &[]),
            "nothing to draw",
        ),
        (
            triangle(
                &[],
                &[f32::NAN, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0],
                &[],
            ),
            "not numbers",
        ),
        (
            triangle(&[], &[1.0e30, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0], &[]),
            "far too large",
        ),
    ];
    for (bytes, word) in cases {
        let said = refusal(&bytes).to_string();
        assert!(said.contains(word), "{said} does not say {word}");
        assert!(said.ends_with('.') && !said.contains('\n'), "{said}");
    }
}

#[test]
fn a_header_that_claims_less_than_itself_is_refused() {
    for length in 0..12u32 {
        let mut bytes = triangle(&[], &CORNERS, &[]);
        bytes[8..12].copy_from_slice(&length.to_le_bytes());
        assert_eq!(refusal(&bytes), Error::Truncated);
    }
}

#[test]
fn indices_past_the_vertices_are_refused() {
    let accessors = (
        r#""accessors":["#,
        r#""accessors":[{"bufferView":1,"componentType":5121,"count":3,"type":"SCALAR"},"#,
    );
    let views = (
        r#","byteLength":36}]"#,
        r#","byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":3}]"#,
    );
    let used = (
        r#""attributes":{"POSITION":0}"#,
        r#""attributes":{"POSITION":1},"indices":0"#,
    );
    assert!(Model::from_glb(&triangle(&[accessors, views, used], &CORNERS, &[0, 1, 2])).is_ok());
    assert_eq!(
        refusal(&triangle(&[accessors, views, used], &CORNERS, &[0, 1, 3])),
        Error::OutOfRange("vertices")
    );
}

#[test]
fn positions_that_are_not_there_are_refused() {
    let bytes = triangle(
        &[(
            r#""attributes":{"POSITION":0}"#,
            r#""attributes":{"POSITION":9}"#,
        )],
        &CORNERS,
        &[],
    );
    assert_eq!(refusal(&bytes), Error::OutOfRange("vertex data"));
}

#[test]
fn more_than_four_joints_for_a_vertex_are_refused() {
    let mut more = vec![0u8; 12];
    more.extend(floats(&[0.5; 12]));
    let accessors = (
        r#""max":[1,1,0]}"#,
        r#""max":[1,1,0]},{"bufferView":1,"componentType":5121,"count":3,"type":"VEC4"},
           {"bufferView":2,"componentType":5126,"count":3,"type":"VEC4"}"#,
    );
    let views = (
        r#","byteLength":36}]"#,
        r#","byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":12},{"buffer":0,"byteOffset":48,"byteLength":48}]"#,
    );
    let four = r#""attributes":{"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2}"#;
    let eight =
        r#""attributes":{"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2,"JOINTS_1":1,"WEIGHTS_1":2}"#;
    let old = r#""attributes":{"POSITION":0}"#;
    let model =
        Model::from_glb(&triangle(&[accessors, views, (old, four)], &CORNERS, &more)).unwrap();
    assert_eq!(model.meshes[0].primitives[0].vertices[0].weights, [0.25; 4]);
    assert_eq!(
        refusal(&triangle(
            &[accessors, views, (old, eight)],
            &CORNERS,
            &more
        )),
        Error::Influences("m".into())
    );
}

#[test]
fn cameras_are_left_out_and_noted() {
    let camera =
        r#""scene":0,"cameras":[{"type":"perspective","perspective":{"yfov":1,"znear":0.1}}]"#;
    let model = Model::from_glb(&triangle(&[(r#""scene":0"#, camera)], &CORNERS, &[])).unwrap();
    assert_eq!(model.notes, [Note::CamerasIgnored]);
}

#[test]
fn every_truncation_is_refused() {
    let bullet = file("bullet");
    for length in (0..bullet.len()).step_by(7) {
        assert!(Model::from_glb(&bullet[..length]).is_err(), "{length}");
    }
}

/// A file shortened without its lengths knowing: the header and the chunks are mended.
#[test]
fn shortened_data_are_refused() {
    let bullet = file("bullet");
    let json = u32::from_le_bytes(bullet[12..16].try_into().unwrap()) as usize;
    let text = std::str::from_utf8(&bullet[20..20 + json]).unwrap();
    let data = &bullet[28 + json..];
    assert!(Model::from_glb(&glb(text, data)).is_ok());
    for length in (0..data.len() - 4).step_by(97) {
        assert!(
            Model::from_glb(&glb(text, &data[..length])).is_err(),
            "{length}"
        );
    }
}

/// The same cases every time.
fn fixed(cases: u32) -> ProptestConfig {
    ProptestConfig {
        cases,
        rng_seed: proptest::test_runner::RngSeed::Fixed(20),
        failure_persistence: None,
        ..ProptestConfig::default()
    }
}

proptest! {
    #![proptest_config(fixed(1024))]

    #[test]
    fn flipped_bytes_never_panic(
        file in 0..FILES.len(),
        flips in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>(), any::<bool>()), 1..12),
    ) {
        let mut bytes = FILES[file].1.clone();
        let json = u32::from_le_bytes(bytes[12..16].try_into().unwrap()) as usize;
        for (at, value, in_description) in flips {
            let length = if in_description { 20 + json } else { bytes.len() };
            bytes[at.index(length)] = value;
        }
        if let Ok(model) = Model::from_glb(&bytes) {
            exercise(&model);
        }
    }

    /// Digits changed to digits keep the description readable, so the damage reaches further in.
    #[test]
    fn changed_numbers_never_panic(
        file in 0..FILES.len(),
        flips in prop::collection::vec((any::<prop::sample::Index>(), b'0'..=b'9'), 1..6),
    ) {
        let mut bytes = FILES[file].1.clone();
        let json = u32::from_le_bytes(bytes[12..16].try_into().unwrap()) as usize;
        let digits: Vec<usize> = (20..20 + json).filter(|&i| bytes[i].is_ascii_digit()).collect();
        for (at, digit) in flips {
            bytes[digits[at.index(digits.len())]] = digit;
        }
        if let Ok(model) = Model::from_glb(&bytes) {
            exercise(&model);
        }
    }

    #[test]
    fn noise_never_panics(mut bytes in prop::collection::vec(any::<u8>(), 0..400), glb in any::<bool>()) {
        if glb && bytes.len() >= 20 {
            bytes[..8].copy_from_slice(b"glTF\x02\0\0\0");
            bytes[16..20].copy_from_slice(b"JSON");
        }
        let _ = Model::from_glb(&bytes);
    }
}

/// Whatever is taken can be posed.
fn exercise(model: &Model) {
    for clip in &model.clips {
        let pose = clip.pose(&model.skeleton, clip.seconds * 0.37);
        let joints = pose.model_matrices(&model.skeleton);
        for skin in &model.skins {
            let _ = skin.matrices(&joints);
        }
    }
}
