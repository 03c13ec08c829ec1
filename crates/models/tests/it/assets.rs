//! The game's own models: what they are made of, how they move, and that they are what the script makes.

use std::path::Path;
use std::process::Command;

use crate::common::{FILES, file};
use antipode_models::{Clip, GAME_FROM_FILE, Model, Part, Pose};
use glam::{Mat4, Vec3};

fn load(name: &str) -> Model {
    Model::from_glb(file(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
}

fn astronauts() -> [Model; 2] {
    [load("astronaut"), load("astronaut_teal")]
}

/// Every vertex of the model in a pose, metres in the file's axes.
fn places(model: &Model, pose: &Pose) -> Vec<Vec3> {
    let joints = pose.model_matrices(&model.skeleton);
    let mut out = Vec::new();
    for Part { node, mesh, skin } in &model.parts {
        let skinning = skin.map(|s| model.skins[s].matrices(&joints));
        for vertex in model.meshes[*mesh]
            .primitives
            .iter()
            .flat_map(|p| &p.vertices)
        {
            let matrix = match &skinning {
                None => joints[*node],
                Some(matrices) => (0..4).fold(Mat4::ZERO, |m, i| {
                    m + matrices[vertex.joints[i] as usize] * vertex.weights[i]
                }),
            };
            out.push(matrix.transform_point3(vertex.position));
        }
    }
    out
}

fn size(model: &Model) -> (Vec3, Vec3) {
    let all = places(model, &Pose::rest(&model.skeleton));
    (
        all.iter().copied().reduce(Vec3::min).unwrap(),
        all.iter().copied().reduce(Vec3::max).unwrap(),
    )
}

#[test]
fn sizes_are_those_of_the_things() {
    for model in astronauts() {
        let (low, high) = size(&model);
        assert!(
            low.y.abs() < 0.005 && (high.y - 1.8).abs() < 0.02,
            "{low} {high}"
        );
        assert!(
            (1500..5000).contains(&model.triangles()),
            "{}",
            model.triangles()
        );
    }
    let (low, high) = size(&load("car"));
    let span = high - low;
    assert!(
        (span.z - 3.2).abs() < 0.1 && (span.x - 1.5).abs() < 0.1 && (span.y - 1.5).abs() < 0.1,
        "{span}"
    );
    assert!(low.y.abs() < 0.01);
}

#[test]
fn no_triangle_is_degenerate_and_every_normal_is_on_its_outer_side() {
    for (name, _) in &*FILES {
        let model = load(name);
        for primitive in model.meshes.iter().flat_map(|m| &m.primitives) {
            let mut against = 0;
            for corner in primitive.indices.chunks_exact(3) {
                let [a, b, c] = [0, 1, 2].map(|i| primitive.vertices[corner[i] as usize]);
                let face = (b.position - a.position).cross(c.position - a.position);
                assert!(face.length() > 1.0e-9, "{name}: {corner:?}");
                against += usize::from(face.dot(a.normal + b.normal + c.normal) <= 0.0);
            }
            assert_eq!(against, 0, "{name}");
            assert!(
                primitive
                    .vertices
                    .iter()
                    .all(|v| (v.normal.length() - 1.0).abs() < 1.0e-3)
            );
        }
    }
}

#[test]
fn weights_sum_to_one_and_every_joint_of_the_skin_is_used() {
    for model in astronauts() {
        assert!((18..=22).contains(&model.skins[0].joints.len()));
        let mut used = vec![false; model.skins[0].joints.len()];
        for vertex in model
            .meshes
            .iter()
            .flat_map(|m| &m.primitives)
            .flat_map(|p| &p.vertices)
        {
            assert!((vertex.weights.iter().sum::<f32>() - 1.0).abs() < 1.0e-5);
            for (joint, weight) in vertex.joints.iter().zip(vertex.weights) {
                used[*joint as usize] |= weight > 0.0;
            }
        }
        assert!(used.iter().all(|used| *used), "{used:?}");
        let hold = model.skeleton.find("hold.R").unwrap();
        assert!(
            model
                .skeleton
                .is_below(hold, model.skeleton.find("hand.R").unwrap())
        );
    }
}

#[test]
fn both_outfits_have_the_same_skeleton_and_clips() {
    let [white, teal] = astronauts();
    assert_eq!(white.skeleton, teal.skeleton);
    assert_eq!(white.clips, teal.clips);
    let names: Vec<_> = white.clips.iter().map(|c| c.name.as_str()).collect();
    assert_eq!(
        names,
        [
            "idle", "walk", "run", "jump", "fall", "hold", "hit", "die", "sit", "rest", "perch"
        ]
    );
    assert_ne!(white.meshes, teal.meshes);
}

#[test]
fn loops_close_exactly() {
    let [model, _] = astronauts();
    for clip in model.clips.iter().filter(|c| c.loops) {
        let open = Clip {
            loops: false,
            ..clip.clone()
        };
        assert_eq!(
            open.pose(&model.skeleton, 0.0),
            open.pose(&model.skeleton, clip.seconds),
            "{}",
            clip.name
        );
    }
    assert_eq!(model.clips.iter().filter(|c| c.loops).count(), 8);
}

/// Every stretch of time in which a vertex of a boot is within 6 mm of the ground, it may drift over the
/// ground, which passes at the clip's speed, by no more than 2 cm.
#[test]
fn feet_that_touch_the_ground_stand_still() {
    let [model, _] = astronauts();
    for name in ["walk", "run", "idle"] {
        let clip = model.clip(name).unwrap();
        let steps = 240;
        let frames: Vec<Vec<Vec3>> = (0..2 * steps)
            .map(|k| {
                let time = clip.seconds * k as f32 / steps as f32;
                let ground = Vec3::new(0.0, 0.0, clip.ground_speed_m_s * time);
                places(&model, &clip.pose(&model.skeleton, time))
                    .iter()
                    .map(|p| *p + ground)
                    .collect()
            })
            .collect();
        let lowest = frames
            .iter()
            .flatten()
            .map(|p| p.y)
            .fold(f32::MAX, f32::min);
        assert!(lowest > -0.012, "{name} goes {lowest} m into the ground");
        let (mut worst, mut touches) = (0.0f32, 0);
        for v in 0..frames[0].len() {
            let mut from: Option<Vec3> = None;
            for frame in &frames {
                let p = frame[v];
                if p.y < 0.006 {
                    let start = *from.get_or_insert(p);
                    worst = worst.max((p - start).with_y(0.0).length());
                    touches += 1;
                } else {
                    from = None;
                }
            }
        }
        println!("{name}: worst drift {worst} m, lowest {lowest} m");
        assert!(
            touches > steps && worst < 0.02,
            "{name}: {worst} m in {touches} touches"
        );
    }
}

#[test]
fn the_sphere_holds_every_clip_and_every_fade_between_them() {
    for (name, _) in &*FILES {
        let model = load(name);
        let sphere = model.bounds;
        let mut poses = vec![Pose::rest(&model.skeleton)];
        for clip in &model.clips {
            poses.extend((0..8).map(|k| clip.pose(&model.skeleton, clip.seconds * k as f32 / 7.5)));
        }
        let firsts = poses.clone();
        for (a, b) in firsts.iter().zip(firsts.iter().skip(5)) {
            let mut between = a.clone();
            between.fade(b, 0.5);
            poses.push(between);
        }
        let mut farthest = 0.0f32;
        for pose in &poses {
            let reach = places(&model, pose)
                .iter()
                .map(|p| p.distance(sphere.centre))
                .fold(0.0, f32::max);
            farthest = farthest.max(reach);
        }
        assert!(
            farthest <= sphere.radius * 1.0001,
            "{name}: {farthest} of {sphere:?}"
        );
        assert!(
            sphere.radius < 2.2 * farthest,
            "{name}: {farthest} of {sphere:?}"
        );
    }
}

#[test]
fn the_hold_keeps_the_item_upright_over_a_walk() {
    use antipode_models::Mask;
    let [model, _] = astronauts();
    let skeleton = &model.skeleton;
    let hold = model.clip("hold").unwrap();
    let mask = Mask::below(skeleton, skeleton.find("spine").unwrap());
    let hand = skeleton.find("hold.R").unwrap();
    for k in 0..16 {
        let walk = model.clip("walk").unwrap().pose(skeleton, k as f32 * 0.05);
        let mut pose = walk.clone();
        pose.layer(&hold.pose(skeleton, k as f32 * 0.1), &mask, 1.0);
        let held = pose.model_matrices(skeleton)[hand];
        assert!(held.transform_vector3(Vec3::Y).y > 0.95, "{k}");
        assert!(held.transform_vector3(Vec3::Z).z > 0.9, "{k}");
        let foot = skeleton.find("foot.L").unwrap();
        assert_eq!(
            pose.model_matrices(skeleton)[foot],
            walk.model_matrices(skeleton)[foot]
        );
    }
}

#[test]
fn the_car_looks_ahead_and_its_wheels_turn_about_their_hubs() {
    let model = load("car");
    let joints = Pose::rest(&model.skeleton).model_matrices(&model.skeleton);
    let hub = |name: &str| {
        GAME_FROM_FILE * joints[model.skeleton.find(name).unwrap()].transform_point3(Vec3::ZERO)
    };
    // In the game's axes: x ahead, z to the right.
    assert!(
        hub("wheel.FL").x > 0.5
            && hub("wheel.FL").z < -0.3
            && hub("wheel.RR").x < -0.5
            && hub("wheel.RR").z > 0.3
    );
    for part in &model.parts {
        let mesh = &model.meshes[part.mesh];
        if mesh.name == "wheel" {
            let vertices = mesh.primitives.iter().flat_map(|p| &p.vertices);
            let radius = vertices
                .map(|v| v.position.with_x(0.0).length())
                .fold(0.0, f32::max);
            assert!((radius - hub("wheel.FL").y).abs() < 1.0e-3);
        }
    }
    let head = model
        .materials
        .iter()
        .position(|m| m.name == "glow.head")
        .unwrap();
    let lights = model
        .meshes
        .iter()
        .flat_map(|m| &m.primitives)
        .filter(|p| p.material == head);
    let ahead = lights
        .flat_map(|p| &p.vertices)
        .all(|v| (GAME_FROM_FILE * v.position).x > 1.3);
    assert!(ahead);
}

#[test]
fn the_lamp_shines_by_itself() {
    let model = load("lamp");
    let shining = |name: &str| {
        model
            .materials
            .iter()
            .find(|m| m.name == name)
            .unwrap()
            .emission
    };
    assert!(shining("glow").min_element() > 0.3 && shining("globe").min_element() > 0.1);
    assert!(
        model
            .materials
            .iter()
            .any(|m| m.name == "paint" && m.emission == Vec3::ZERO)
    );
}

/// Where there is a Python, the files are compared with what the script writes, byte for byte; the icons, whose
/// compression differs between machines, by their pixels.
#[test]
fn the_files_are_what_the_script_makes() {
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets/models/make_models.py");
    match Command::new("python3").arg(&script).arg("--check").output() {
        Err(e) => antipode_testing::skipped(&format!(
            "no python3 ({e}), so the models were not compared with their script"
        )),
        Ok(out) => assert!(
            out.status.success(),
            "{}{}",
            String::from_utf8_lossy(&out.stdout),
            String::from_utf8_lossy(&out.stderr)
        ),
    }
}
