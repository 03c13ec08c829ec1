//! Joints from postures: clips hold their shapes, and fades go from one to the other.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "tests fail by panicking"
)]
use antipode_frame::{ModelId, ModelShape};
use antipode_models::Model;
use antipode_scene::tuning::{RUN_STRIDE_M, WALK_STRIDE_M};

use super::*;
use crate::gpu::Gpu;
use crate::models::{ModelVertex, Shape, SkinVertex, load_all};
use crate::shaders::FIGURE;

fn rig() -> (Rig, Shape) {
    let astronaut = load_all().unwrap().swap_remove(0);
    (astronaut.rig.unwrap(), astronaut.shape)
}

/// Postures of all kinds.
fn postures() -> Vec<Posture> {
    let mut all: Vec<Posture> = Clip::ALL.map(|clip| Posture::of(clip, 0.37)).into();
    let mut busy = Posture::of(Clip::Run, 0.6)
        .with(Clip::Walk, 0.5, 0.6)
        .with(Clip::Hold, 1.0, 0.4)
        .with(Clip::Hit, 0.7, 0.1);
    (busy.twist_rad, busy.pitch_rad) = (1.4, -0.6);
    (busy.swing, busy.kick) = (0.5, 0.5);
    all.extend([busy, Posture::of(Clip::Die, 9.0)]);
    all
}

/// Where a vertex comes to, by the rows of its joints.
fn carried(vertex: &ModelVertex, skin: &SkinVertex, joints: &[JointRows]) -> Vec3 {
    let mut place = Vec3::ZERO;
    let [x, y, z] = vertex.position;
    for (joint, weight) in skin.joints.iter().zip(skin.weights) {
        let rows = joints[usize::from(*joint)];
        let at = rows.map(|[a, b, c, d]| a * x + b * y + c * z + d);
        place += Vec3::from(at) * (f32::from(weight) / f32::from(u16::MAX));
    }
    place
}

fn places(posed: &Posed, shape: &Shape) -> Vec<Vec3> {
    let pairs = shape.vertices.iter().zip(&shape.skin);
    pairs.map(|(v, s)| carried(v, s, &posed.joints)).collect()
}

#[test]
fn the_scene_knows_how_far_a_cycle_of_each_gait_goes() {
    let ModelShape::Bent(file) = ModelId::Astronaut.shape() else {
        panic!("the astronaut has a skeleton");
    };
    let model = Model::from_glb(file).unwrap();
    for (clip, stride_m) in [(Clip::Walk, WALK_STRIDE_M), (Clip::Run, RUN_STRIDE_M)] {
        let clip = model.clip(clip.name()).unwrap();
        let own_m = f64::from(clip.ground_speed_m_s * clip.seconds);
        assert!((own_m - stride_m).abs() < 1e-3, "{}: {own_m}", clip.name);
    }
}

#[test]
fn the_box_of_a_posture_holds_every_vertex_and_little_else() {
    let (rig, shape) = rig();
    for posture in postures() {
        let posed = rig.pose(&posture);
        let [low, high] = posed.limits;
        let places = places(&posed, &shape);
        for place in &places {
            assert!(place.cmpge(low - 1e-3).all() && place.cmple(high + 1e-3).all());
        }
        let least = places.iter().copied().reduce(Vec3::min).unwrap();
        let most = places.iter().copied().reduce(Vec3::max).unwrap();
        assert!(
            (high - low - (most - least)).max_element() < 0.5,
            "{posture:?}"
        );
    }
}

#[test]
fn the_dead_lie_and_the_living_stand() {
    let (rig, shape) = rig();
    let top = |posture: &Posture| {
        let places = places(&rig.pose(posture), &shape);
        places.iter().map(|p| p.y).fold(f32::MIN, f32::max)
    };
    assert!((1.75..1.85).contains(&top(&Posture::default())));
    assert!(top(&Posture::of(Clip::Die, 9.0)) < 0.85);
}

#[test]
fn a_gait_swings_the_legs_and_a_hold_brings_the_hand_ahead() {
    let (rig, shape) = rig();
    let step = |cycle: f32| places(&rig.pose(&Posture::of(Clip::Walk, cycle)), &shape);
    let most = |a: Vec<Vec3>, b: Vec<Vec3>| {
        a.iter()
            .zip(&b)
            .map(|(a, b)| a.distance(*b))
            .fold(0.0, f32::max)
    };
    assert!(most(step(0.0), step(0.5)) > 0.4);
    assert!(most(step(0.0), step(1.0)) < 1e-3, "it goes round");
    let hand = |posture: &Posture| rig.pose(posture).hand;
    let HandPose { turn, place: holds } = hand(&Posture::default().with(Clip::Hold, 1.0, 0.0));
    let hangs = hand(&Posture::default()).place;
    assert!(holds.x > hangs.x + 0.15 && holds.z > 0.1, "{holds} {hangs}");
    assert!(
        (turn * Vec3::X).x > 0.9,
        "a gun points ahead: {}",
        turn * Vec3::X
    );
}

#[test]
fn legs_go_where_they_are_turned_and_the_face_stays_ahead() {
    let (rig, shape) = rig();
    let posture = Posture {
        twist_rad: 1.0,
        ..Posture::default()
    };
    let posed = rig.pose(&posture);
    let visor = shape
        .vertices
        .iter()
        .zip(&shape.skin)
        .filter(|(v, _)| v.colour[3] > 200);
    let face: Vec3 = visor.map(|(v, s)| carried(v, s, &posed.joints)).sum();
    assert!(face.z.abs() < 0.35 * face.x, "{face}");
    let toes: Vec3 = places(&posed, &shape)
        .into_iter()
        .filter(|p| p.y < 0.03)
        .sum();
    assert!(toes.z > 0.6 * toes.x, "the feet point to the right: {toes}");
}

/// `bend` of figure.wgsl, for one vertex each.
const KERNEL: &str = "
struct Given { place: vec4<f32>, weights: vec4<f32>, joints: vec4<u32> }
@group(0) @binding(1) var<storage, read> given: array<Given>;
@group(0) @binding(2) var<storage, read_write> found: array<vec4<f32>>;
@compute @workgroup_size(64)
fn kernel(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= arrayLength(&given) { return; }
    let it = given[id.x];
    let stance = Stance(it.place.xyz, vec3<f32>(0.0, 1.0, 0.0));
    found[id.x] = vec4<f32>(bend(stance, SkinIn(it.weights, it.joints), 3u).place, 1.0);
}";

/// The shader carries every vertex where the processor does, from another figure's place in the batch.
#[test]
fn the_adapter_bends_as_the_processor_does() {
    use wgpu::BufferUsages as Usage;
    use wgpu::util::{BufferInitDescriptor, DeviceExt};
    let Some(gpu) = Gpu::for_test() else {
        return;
    };
    let (rig, shape) = rig();
    let mut given: Vec<[u32; 12]> = Vec::new();
    for (vertex, skin) in shape.vertices.iter().zip(&shape.skin) {
        let [x, y, z] = vertex.position.map(f32::to_bits);
        let w = skin
            .weights
            .map(|w| (f32::from(w) / f32::from(u16::MAX)).to_bits());
        let j = skin.joints.map(u32::from);
        given.push([x, y, z, 0, w[0], w[1], w[2], w[3], j[0], j[1], j[2], j[3]]);
    }
    let buffer = |contents: &[u8], usage| {
        let label = None;
        gpu.device.create_buffer_init(&BufferInitDescriptor {
            label,
            contents,
            usage,
        })
    };
    let source = FIGURE.source(Some(&antipode_geometry::shader::FLAT)) + KERNEL;
    let pipeline = gpu.kernel(source);
    let asked = buffer(bytemuck::cast_slice(&given), Usage::STORAGE);
    let found = buffer(&vec![0; 16 * given.len()], Usage::STORAGE | Usage::COPY_SRC);
    for posture in postures() {
        let posed = rig.pose(&posture);
        let mut rows = vec![JointRows::default(); 16 * JOINTS];
        rows[3 * JOINTS..][..posed.joints.len()].copy_from_slice(&posed.joints);
        let joints = buffer(bytemuck::cast_slice(&rows), Usage::UNIFORM);
        let group = |number: u32, bound: &[(u32, &wgpu::Buffer)]| {
            let mut entries = Vec::new();
            for (binding, buffer) in bound {
                entries.push(wgpu::BindGroupEntry {
                    binding: *binding,
                    resource: buffer.as_entire_binding(),
                });
            }
            gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: None,
                layout: &pipeline.get_bind_group_layout(number),
                entries: &entries,
            })
        };
        let (own, bones) = (
            group(0, &[(1, &asked), (2, &found)]),
            group(2, &[(0, &joints)]),
        );
        let mut encoder = gpu.encoder();
        {
            let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
            pass.set_pipeline(&pipeline);
            pass.set_bind_group(0, &own, &[]);
            pass.set_bind_group(2, &bones, &[]);
            pass.dispatch_workgroups(given.len().div_ceil(64) as u32, 1, 1);
        }
        gpu.queue.submit([encoder.finish()]);
        let found = gpu.read_back(&found);
        for (place, [x, y, z, _]) in places(&posed, &shape).into_iter().zip(found) {
            assert!(
                place.distance(Vec3::new(x, y, z)) < 2e-6,
                "{place} {x} {y} {z}"
            );
        }
    }
    assert_eq!(gpu.take_error(), None);
}
