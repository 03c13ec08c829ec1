//! Lists of rays, traced on the adapter by the text that pictures are drawn with.

use antipode_deformation::Place;
use bytemuck::{Pod, Zeroable, cast_slice};
use glam::{DVec3, Vec3};
use wgpu::{BindGroupLayout, BufferBindingType, BufferUsages, ComputePipeline, Device, Queue};

use crate::error::RaysError;
use crate::kinds::Kinds;
use crate::loaded::Loaded;
use crate::packed::{Rule, stack};
use crate::picture::mapped;
use crate::rays::{READ, accepted, buffer, group, layout, pipeline, scene_group, scene_layout};
use crate::shaders::PROBE;

/// Rays of a group.
const GROUP: u32 = 64;

/// A ray to be traced.
#[derive(Clone, Copy, Debug)]
pub struct ProbeRay {
    /// Where it begins.
    pub start: Place,
    /// Its felt direction, of length 1.
    pub w: DVec3,
    /// Felt metres that it goes at most.
    pub longest: f64,
}

/// How a ray has ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// It has its whole length.
    Spent,
    /// At an object, and at which triangle of its mesh.
    Object(u32, u32),
    /// At the wall of an aberration across this axis.
    Wall(u32, u32),
    /// After as many events as there may be.
    TooManyEvents,
}

/// What became of a ray.
#[derive(Clone, Copy, Debug)]
pub struct Answer {
    /// How it ended.
    pub outcome: Outcome,
    /// Where, metres of the scene.
    pub point: Vec3,
    /// Felt direction there.
    pub w: Vec3,
    /// Felt metres.
    pub length: f32,
    /// Faces that it passed.
    pub events: u32,
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct PackedRay {
    x: Vec3,
    longest: f32,
    w: Vec3,
    depth: u32,
    stack: [u32; 4],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct PackedAnswer {
    x: Vec3,
    length: f32,
    w: Vec3,
    events: u32,
    end: u32,
    what: u32,
    part: u32,
    depth: u32,
    stack: [u32; 4],
}

/// What traces lists of rays.
#[derive(Debug)]
pub struct Prober {
    pipeline: ComputePipeline,
    scene_layout: BindGroupLayout,
    list_layout: BindGroupLayout,
}

impl Prober {
    /// Compiles the shaders.
    ///
    /// # Errors
    /// When the adapter refuses them.
    pub fn new(device: &Device) -> Result<Self, RaysError> {
        accepted(device, || {
            let scene_layout = scene_layout(device);
            let written = BufferBindingType::Storage { read_only: false };
            let list_layout = layout(device, "list of rays", &[buffer(READ), buffer(written)]);
            Self {
                pipeline: pipeline(
                    device,
                    ("probe of rays", &PROBE, "probe"),
                    &[&scene_layout, &list_layout],
                    Kinds::ALL,
                ),
                scene_layout,
                list_layout,
            }
        })
    }

    /// Traces the rays and waits for them.
    ///
    /// # Errors
    /// When the adapter is lost or its memory cannot be read.
    pub fn trace(
        &self,
        device: &Device,
        queue: &Queue,
        loaded: &Loaded,
        rays: &[ProbeRay],
    ) -> Result<Vec<Answer>, RaysError> {
        let packed: Vec<_> = rays.iter().map(pack).collect();
        let answer_bytes = (rays.len() * size_of::<PackedAnswer>()) as u64;
        let make = |size: u64, usage| {
            device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("list of rays"),
                size: size.max(64),
                usage,
                mapped_at_creation: false,
            })
        };
        let asked = make(
            size_of_val(&*packed) as u64,
            BufferUsages::STORAGE | BufferUsages::COPY_DST,
        );
        let answers = make(answer_bytes, BufferUsages::STORAGE | BufferUsages::COPY_SRC);
        let back = make(
            answer_bytes,
            BufferUsages::MAP_READ | BufferUsages::COPY_DST,
        );
        queue.write_buffer(&asked, 0, cast_slice(&packed));
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        {
            let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
            pass.set_pipeline(&self.pipeline);
            pass.set_bind_group(
                0,
                &scene_group(device, &self.scene_layout, loaded, Rule::Exact),
                &[],
            );
            let resources = [asked.as_entire_binding(), answers.as_entire_binding()];
            pass.set_bind_group(
                1,
                &group(device, "list of rays", &self.list_layout, resources),
                &[],
            );
            pass.dispatch_workgroups((rays.len() as u32).div_ceil(GROUP), 1, 1);
        }
        encoder.copy_buffer_to_buffer(&answers, 0, &back, 0, answer_bytes);
        queue.submit([encoder.finish()]);
        let bytes = mapped(device, &back)?;
        let read =
            bytemuck::pod_collect_to_vec::<u8, PackedAnswer>(&bytes[..answer_bytes as usize]);
        Ok(read.iter().map(unpack).collect())
    }
}

fn pack(ray: &ProbeRay) -> PackedRay {
    PackedRay {
        x: ray.start.point.as_vec3(),
        longest: ray.longest as f32,
        w: ray.w.as_vec3(),
        depth: ray.start.stack.len() as u32,
        stack: stack(&ray.start.stack),
    }
}

fn unpack(answer: &PackedAnswer) -> Answer {
    Answer {
        outcome: match answer.end {
            0 => Outcome::Spent,
            1 => Outcome::Object(answer.what, answer.part),
            2 => Outcome::Wall(answer.what, answer.part),
            _ => Outcome::TooManyEvents,
        },
        point: answer.x,
        w: answer.w,
        length: answer.length,
        events: answer.events,
    }
}
