//! Figures: one mesh for each model, an instance for each figure.

use antipode_scene::frame::{Figure, Frame};
use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{Buffer, BufferUsages, Device, Queue, RenderPass};

use crate::astronaut::astronaut;
use crate::uniforms::{FigureInstance, hemisphere_index, offset_of};

/// Widest angle of a leg from straight down, radians.
const SWING_RAD: f32 = 0.62;
/// The body rises by this much when the legs pass each other, metres.
const RISE_M: f32 = 0.035;

/// The models on the adapter and this frame's figures.
#[derive(Debug)]
pub struct Figures {
    vertices: Buffer,
    indices: Buffer,
    index_count: u32,
    instances: Buffer,
    room: usize,
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
            count: 0,
        }
    }

    /// Takes this frame's figures.
    pub fn prepare(&mut self, device: &Device, queue: &Queue, frame: &Frame) {
        let instances: Vec<_> = frame
            .figures
            .iter()
            .map(|figure| instance(frame, figure))
            .collect();
        if instances.len() > self.room {
            self.room = instances.len().next_power_of_two();
            self.instances = instance_buffer(device, self.room);
        }
        queue.write_buffer(&self.instances, 0, bytemuck::cast_slice(&instances));
        self.count = instances.len() as u32;
    }

    /// Draws them; returns triangles and draw calls.
    pub fn draw(&self, pass: &mut RenderPass<'_>) -> (usize, usize) {
        if self.count == 0 {
            return (0, 0);
        }
        pass.set_vertex_buffer(0, self.vertices.slice(..));
        pass.set_vertex_buffer(1, self.instances.slice(..));
        pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint16);
        pass.draw_indexed(0..self.index_count, 0, 0..self.count);
        ((self.index_count / 3 * self.count) as usize, 1)
    }
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
    }
}
