//! Figures: one mesh for each model, an instance for each figure.

use antipode_scene::frame::{Figure, Frame};
use glam::DVec3;
use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{Buffer, BufferUsages, Device, Queue, RenderPass};

use crate::astronaut::astronaut;
use crate::pipelines::Pipelines;
use crate::plan::{Affine, FramePlan, Tolerance};
use crate::uniforms::{FigureInstance, frame_rows, hemisphere_index, offset_of};

/// Widest angle of a leg from straight down, radians.
const SWING_RAD: f32 = 0.62;
/// The body rises by this much when the legs pass each other, metres.
const RISE_M: f32 = 0.035;

/// Half the sides of the box that a figure in any pose stays in, metres.
const FIGURE_HALF_WIDTH_M: f64 = 0.6;
/// Half its height, metres.
const FIGURE_HALF_HEIGHT_M: f64 = 0.95;

/// The models on the adapter and this frame's figures.
#[derive(Debug)]
pub struct Figures {
    vertices: Buffer,
    indices: Buffer,
    index_count: u32,
    instances: Buffer,
    room: usize,
    framed: u32,
    count: u32,
}

impl Figures {
    /// Uploads the models.
    pub fn new(device: &Device) -> Self {
        let solid = astronaut();
        let vertices = device.create_buffer_init(&BufferInitDescriptor {
            label: Some("astronaut vertices"),
            contents: bytemuck::cast_slice(&solid.vertices),
            usage: BufferUsages::VERTEX,
        });
        let indices = device.create_buffer_init(&BufferInitDescriptor {
            label: Some("astronaut indices"),
            contents: bytemuck::cast_slice(&solid.indices),
            usage: BufferUsages::INDEX,
        });
        let index_count = solid.indices.len() as u32;
        let room = 16;
        Self {
            vertices,
            indices,
            index_count,
            instances: instance_buffer(device, room),
            room,
            framed: 0,
            count: 0,
        }
    }

    /// Takes this frame's figures, those that a frame serves within the tolerance first.
    pub fn prepare(&mut self, device: &Device, queue: &Queue, frame: &Frame, plan: &mut FramePlan) {
        let mut instances = Vec::with_capacity(frame.figures.len());
        let mut by_vertex = Vec::new();
        for figure in &frame.figures {
            let plain = instance(frame, figure);
            match figure_frame(frame, plan, figure) {
                Some((affine, error_px)) => {
                    plan.stats.error_at_least(error_px);
                    let frame = frame_rows(&affine);
                    instances.push(FigureInstance { frame, ..plain });
                }
                None => by_vertex.push(plain),
            }
        }
        self.framed = instances.len() as u32;
        plan.stats.figures_by_frame = instances.len();
        plan.stats.figures_by_vertex = by_vertex.len();
        instances.append(&mut by_vertex);
        if instances.len() > self.room {
            self.room = instances.len().next_power_of_two();
            self.instances = instance_buffer(device, self.room);
        }
        queue.write_buffer(&self.instances, 0, bytemuck::cast_slice(&instances));
        self.count = instances.len() as u32;
    }

    /// Draws them; returns triangles and draw calls.
    pub fn draw(&self, pass: &mut RenderPass<'_>, pipelines: &Pipelines) -> (usize, usize) {
        let mut draws = 0;
        pass.set_vertex_buffer(0, self.vertices.slice(..));
        pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint16);
        let runs = [
            (&pipelines.figure_framed, 0..self.framed),
            (&pipelines.figure, self.framed..self.count),
        ];
        for (pipeline, run) in runs {
            if run.is_empty() {
                continue;
            }
            let start = u64::from(run.start) * size_of::<FigureInstance>() as u64;
            pass.set_pipeline(pipeline);
            pass.set_vertex_buffer(1, self.instances.slice(start..));
            pass.draw_indexed(0..self.index_count, 0, 0..run.end - run.start);
            draws += 1;
        }
        ((self.index_count / 3 * self.count) as usize, draws)
    }
}

/// The frame of a figure, where it is exact enough.
fn figure_frame(frame: &Frame, plan: &FramePlan, figure: &Figure) -> Option<(Affine, f64)> {
    let half = DVec3::new(
        FIGURE_HALF_WIDTH_M,
        FIGURE_HALF_HEIGHT_M,
        FIGURE_HALF_WIDTH_M,
    );
    let middle = figure.point.moved(DVec3::Y * FIGURE_HALF_HEIGHT_M);
    let tolerance = Tolerance::of(frame.quality);
    plan.bounds
        .object(frame, figure.point, middle, half, tolerance.shape_px)
}

fn instance_buffer(device: &Device, room: usize) -> Buffer {
    device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("figures"),
        size: (room * size_of::<FigureInstance>()) as u64,
        usage: BufferUsages::VERTEX | BufferUsages::COPY_DST,
        mapped_at_creation: false,
    })
}

fn instance(frame: &Frame, figure: &Figure) -> FigureInstance {
    let (sin, cos) = figure.yaw.sin_cos();
    let swing = figure.stride.sin();
    // Standing still (stride 0) is the middle of a step, where the body is at its height: no rise is added.
    let pose = [
        cos as f32,
        sin as f32,
        SWING_RAD * swing,
        -RISE_M * swing * swing,
    ];
    FigureInstance {
        offset: offset_of(frame, figure.point),
        hemisphere: hemisphere_index(figure.point.hemisphere),
        pose,
        frame: [[0.0; 4]; 4],
    }
}
