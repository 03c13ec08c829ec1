//! Curves, fades and layers against values worked out by hand, and what the loader makes of a file's variants.

use std::f32::consts::{FRAC_PI_2, FRAC_PI_4};

use crate::common::{CORNERS, floats, triangle};
use antipode_models::{
    Channel, Clip, Curve, Interpolation, Joint, Mask, Model, Pose, Skeleton, Transform,
};
use glam::{Quat, Vec3};

fn curve<T>(times: &[f32], values: Vec<T>, interpolation: Interpolation) -> Curve<T> {
    Curve {
        times: times.to_vec(),
        values,
        interpolation,
    }
}

fn chain() -> Skeleton {
    let joint = |name: &str, parent, x| Joint {
        name: name.to_owned(),
        parent,
        rest: Transform {
            translation: Vec3::new(x, 0.0, 0.0),
            ..Transform::IDENTITY
        },
    };
    Skeleton {
        joints: vec![
            joint("a", None, 0.0),
            joint("b", Some(0), 1.0),
            joint("c", Some(1), 1.0),
        ],
    }
}

fn turning(degrees: f32, loops: bool) -> Clip {
    let turns = vec![Quat::IDENTITY, Quat::from_rotation_z(degrees.to_radians())];
    let channel = Channel::Rotation(0, curve(&[0.0, 2.0], turns, Interpolation::Linear));
    Clip {
        name: "turn".into(),
        seconds: 2.0,
        loops,
        ground_speed_m_s: 0.0,
        channels: vec![channel],
    }
}

#[test]
fn a_turn_carries_what_hangs_from_it() {
    let skeleton = chain();
    let at = |time| {
        let pose = turning(90.0, false).pose(&skeleton, time);
        pose.model_matrices(&skeleton)[2].transform_point3(Vec3::ZERO)
    };
    assert!(at(0.0).distance(Vec3::new(2.0, 0.0, 0.0)) < 1.0e-6);
    assert!(at(1.0).distance(Vec3::new(2.0, 2.0, 0.0) * FRAC_PI_4.cos()) < 1.0e-6);
    assert!(at(2.0).distance(Vec3::new(0.0, 2.0, 0.0)) < 1.0e-6);
    assert!(
        at(9.0).distance(Vec3::new(0.0, 2.0, 0.0)) < 1.0e-6,
        "a clip that does not loop holds its end"
    );
}

#[test]
fn a_loop_goes_round_and_odd_times_do_no_harm() {
    let clip = turning(90.0, true);
    assert_eq!(clip.moment(4.5), 0.5);
    assert_eq!(clip.moment(-0.5), 1.5);
    assert_eq!(clip.moment(f32::NAN), 0.0);
    assert_eq!(turning(90.0, false).moment(-1.0), 0.0);
}

#[test]
fn steps_hold_and_lines_run_straight() {
    let values = vec![Vec3::ZERO, Vec3::X * 4.0, Vec3::Y];
    let step = curve(&[1.0, 2.0, 3.0], values.clone(), Interpolation::Step);
    let line = curve(&[1.0, 2.0, 3.0], values, Interpolation::Linear);
    assert_eq!(step.at(1.99), Some(Vec3::ZERO));
    assert_eq!(step.at(2.0), Some(Vec3::X * 4.0));
    assert_eq!(line.at(0.0), Some(Vec3::ZERO));
    assert_eq!(line.at(1.25), Some(Vec3::X));
    assert_eq!(line.at(2.5), Some(Vec3::new(2.0, 0.5, 0.0)));
    assert_eq!(line.at(7.0), Some(Vec3::Y));
}

/// Keys of t^3 - t over 0 to 2 with its own slopes 3 t^2 - 1: a cubic, so the spline must give it back.
#[test]
fn a_cubic_spline_gives_back_a_cubic() {
    let f = |t: f32| t * t * t - t;
    let slope = |t: f32| 3.0 * t * t - 1.0;
    let key = |t: f32| [Vec3::X * slope(t), Vec3::X * f(t), Vec3::X * slope(t)];
    let spline = curve(
        &[0.0, 0.5, 2.0],
        [0.0, 0.5, 2.0].into_iter().flat_map(key).collect(),
        Interpolation::CubicSpline,
    );
    for (time, value) in [
        (0.0, 0.0),
        (0.25, -0.234_375),
        (0.5, -0.375),
        (1.0, 0.0),
        (1.5, 1.875),
        (2.0, 6.0),
    ] {
        assert!(
            (spline.at(time).unwrap().x - value).abs() < 1.0e-5,
            "{time}"
        );
    }
}

/// A quarter turn with tangents of 0 is, halfway, the mean of its ends made unit length: an eighth.
#[test]
fn a_cubic_spline_of_turns_stays_of_unit_length() {
    let still = Quat::from_xyzw(0.0, 0.0, 0.0, 0.0);
    let values = vec![
        still,
        Quat::IDENTITY,
        still,
        still,
        Quat::from_rotation_y(FRAC_PI_2),
        still,
    ];
    let spline = curve(&[0.0, 1.0], values, Interpolation::CubicSpline);
    let half = spline.at(0.5).unwrap();
    assert!(half.angle_between(Quat::from_rotation_y(FRAC_PI_4)) < 1.0e-3);
    assert!((spline.at(0.3).unwrap().length() - 1.0).abs() < 1.0e-6);
}

#[test]
fn a_fade_begins_and_ends_exactly_at_its_poses() {
    let skeleton = chain();
    let (a, b) = (
        turning(90.0, false).pose(&skeleton, 0.7),
        turning(-40.0, false).pose(&skeleton, 1.3),
    );
    for (share, end) in [(0.0, &a), (1.0, &b)] {
        let mut pose = a.clone();
        pose.fade(&b, share);
        assert_eq!(&pose, end);
        assert_eq!(
            Pose::mix(&[(&a, 1.0 - share), (&b, share)]).as_ref(),
            Some(end)
        );
    }
    assert_eq!(Pose::mix(&[(&a, 0.0), (&b, f32::NAN)]), None);
}

#[test]
fn fades_go_the_short_way() {
    let skeleton = chain();
    let a = turning(20.0, false).pose(&skeleton, 2.0);
    let mut b = turning(40.0, false).pose(&skeleton, 2.0);
    // The same turn, written with the other sign.
    b.locals[0].rotation = -b.locals[0].rotation;
    let mut half = a.clone();
    half.fade(&b, 0.5);
    let wanted = Quat::from_rotation_z(30f32.to_radians());
    assert!(half.locals[0].rotation.angle_between(wanted) < 1.0e-3);
    let mixed = Pose::mix(&[(&a, 2.0), (&b, 2.0)]).unwrap();
    assert!(mixed.locals[0].rotation.angle_between(wanted) < 1.0e-3);
    let three = [
        Pose::mix(&[(&a, 1.0), (&b, 3.0), (&half, 2.0)]),
        Pose::mix(&[(&half, 2.0), (&b, 3.0), (&a, 1.0)]),
    ];
    let [one, other] = three.map(|p| p.unwrap().locals[0].rotation);
    assert!(one.angle_between(other) < 1.0e-3);
}

#[test]
fn a_layer_moves_only_what_hangs_from_its_joint() {
    let skeleton = chain();
    let mut over = Pose::rest(&skeleton);
    for local in &mut over.locals {
        local.rotation = Quat::from_rotation_x(1.0);
    }
    let mut pose = Pose::rest(&skeleton);
    pose.layer(&over, &Mask::below(&skeleton, 1), 1.0);
    assert_eq!(pose.locals[0], Transform::IDENTITY);
    assert_eq!(pose.locals[1].rotation, over.locals[1].rotation);
    assert_eq!(pose.locals[2].rotation, over.locals[2].rotation);
}

#[test]
fn missing_normals_are_those_of_the_planes() {
    let model = Model::from_glb(&triangle(&[], &CORNERS, &[])).unwrap();
    let primitive = &model.meshes[0].primitives[0];
    assert!(primitive.vertices.iter().all(|v| v.normal == Vec3::Z));
    assert_eq!(model.materials[primitive.material].name, "default");
}

#[test]
fn strips_and_fans_become_triangles_that_face_the_same_way() {
    let strip = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0];
    let fan = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0];
    for (mode, corners) in [(5, strip), (6, fan)] {
        let change = format!(r#""attributes":{{"POSITION":0}},"mode":{mode}"#);
        let bytes = triangle(
            &[(r#""attributes":{"POSITION":0}"#, &change)],
            &corners,
            &[],
        );
        let model = Model::from_glb(&bytes).unwrap();
        assert_eq!(model.triangles(), 2);
        assert!(
            model.meshes[0].primitives[0]
                .vertices
                .iter()
                .all(|v| v.normal == Vec3::Z),
            "{mode}"
        );
    }
}

#[test]
fn sparse_accessors_put_their_values_over_the_others() {
    let mut more = vec![1u8, 0, 0, 0];
    more.extend(floats(&[3.0, 0.0, 0.0]));
    let sparse = r#""max":[1,1,0],"sparse":{"count":1,"indices":{"bufferView":1,"byteOffset":0,"componentType":5121},
        "values":{"bufferView":2,"byteOffset":0}}"#;
    let views = r#","byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":1},{"buffer":0,"byteOffset":40,"byteLength":12}]"#;
    let changes = [
        (r#""max":[1,1,0]"#, sparse),
        (r#","byteLength":36}]"#, views),
    ];
    let model = Model::from_glb(&triangle(&changes, &CORNERS, &more)).unwrap();
    let places: Vec<_> = model.meshes[0].primitives[0]
        .vertices
        .iter()
        .map(|v| v.position)
        .collect();
    assert_eq!(places, [Vec3::ZERO, Vec3::X * 3.0, Vec3::Y]);
    let past = [changes[0], (changes[1].0, changes[1].1)];
    more[0] = 3;
    assert!(Model::from_glb(&triangle(&past, &CORNERS, &more)).is_err());
}

#[test]
fn pictures_within_the_file_are_decoded() {
    let mut png = Vec::new();
    let picture = image::RgbaImage::from_fn(2, 1, |x, _| image::Rgba([x as u8 * 200, 10, 20, 255]));
    picture
        .write_to(&mut std::io::Cursor::new(&mut png), image::ImageFormat::Png)
        .unwrap();
    let image =
        r#""scene":0,"images":[{"bufferView":1,"mimeType":"image/png"}],"textures":[{"source":0}],
        "materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}]"#
            .to_string();
    let views = format!(
        r#","byteLength":36}},{{"buffer":0,"byteOffset":36,"byteLength":{}}}]"#,
        png.len()
    );
    let changes = [
        (r#""scene":0"#, image.as_str()),
        (r#","byteLength":36}]"#, views.as_str()),
        (
            r#""attributes":{"POSITION":0}"#,
            r#""attributes":{"POSITION":0},"material":0"#,
        ),
    ];
    let model = Model::from_glb(&triangle(&changes, &CORNERS, &png)).unwrap();
    assert_eq!(model.materials[0].texture, Some(0));
    assert_eq!((model.textures[0].width, model.textures[0].height), (2, 1));
    assert_eq!(model.textures[0].rgba, [0, 10, 20, 255, 200, 10, 20, 255]);
    png.truncate(40);
    assert!(Model::from_glb(&triangle(&[changes[0], changes[2]], &CORNERS, &png)).is_err());
}
