//! The shader's five functions, once for each case.

use antipode_lab::compute;
use bytemuck::{Pod, Zeroable};
use glam::{Vec3, Vec4};

use super::gpu::gpu;
use super::probes::Case;

const TYPES: &str = "
struct Case { space: Space, p: vec3<f32>, map: u32, n: vec3<f32>, pad: u32 }
struct Answer { view: vec4<f32>, clip: vec4<f32>, normal: vec3<f32>, distance: f32, frame: vec4<f32> }";
const BODY: &str = "let space = inputs[i].space;
    let view = port_to_view(space, inputs[i].p);
    outputs[i].view = view;
    outputs[i].clip = clip_from_view(space, view);
    outputs[i].normal = port_normal(space, inputs[i].p, inputs[i].n);
    outputs[i].distance = eye_distance(space, view);
    outputs[i].frame = frame_vector(space, inputs[i].p, outputs[i].normal);";

/// What the shader answers.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
pub struct Answer {
    pub view: Vec4,
    pub clip: Vec4,
    pub normal: Vec3,
    pub distance: f32,
    pub frame: Vec4,
}

/// Its answers, where there is an adapter.
pub fn answers(cases: &[Case]) -> Option<Vec<Answer>> {
    let shader = compute::shader(TYPES, "Case", "Answer", BODY);
    gpu().map(|gpu| gpu.compute(&shader, cases, |case| case.map))
}
