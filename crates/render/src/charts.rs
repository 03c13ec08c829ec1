//! What the shaders are told of a view: the scene once, and its charts one at a time, any number of them.
//!
//! All of it lies in one uniform buffer, which is sent by one write: first the scene, then a place for each chart. What is
//! drawn is drawn chart by chart, with that place bound, so that no shader knows how many there are.

use antipode_frame::Frame;
use antipode_geometry::{ChartId, ChartPoint, Domain};
use bytemuck::{Pod, Zeroable};
use glam::{DMat4, DVec2, DVec3, Vec3Swizzles};
use wgpu::{
    BindGroup, BindGroupLayout, Buffer, BufferUsages, Device, Queue, RenderPass, ShaderStages,
};

use crate::pressers::{PRESSERS, PresserUniform, Pressers};
use crate::uniforms::SceneUniform;

/// Uniforms begin at multiples of this many bytes, on every adapter.
const ALIGNED: usize = 256;
/// Where the charts begin in the buffer: behind the scene.
const CHARTS_AT: usize = size_of::<SceneUniform>().next_multiple_of(ALIGNED);
/// From one chart to the next.
const STRIDE: usize = size_of::<ChartUniform>().next_multiple_of(ALIGNED);
/// The group by which shaders read the scene and the chart of what is drawn.
const GROUP: u32 = 1;
/// Sides of rectangles are no farther off than this, metres: past it there is nothing.
const UNLIMITED_M: f64 = 1e9;
/// Room for so many charts at first.
const FIRST_ROOM: usize = 2;

/// `Chart` of common.wgsl.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct ChartUniform {
    /// What is applied to ported points to have view coordinates, and to have them in the model in which light is told.
    pub view: [[f32; 4]; 4],
    /// See above.
    pub home: [[f32; 4]; 4],
    /// The reference from the whole metres that chunks are measured from.
    pub fraction: [f32; 3],
    /// How a square is joined to those about it: [`Joins::bits`](antipode_geometry::Joins::bits).
    pub joins: u32,
    /// A rectangle past which other charts draw the land: the least x and z from the reference, and the greatest, metres.
    pub domain_low: [f32; 2],
    /// See above.
    pub domain_high: [f32; 2],
    /// Where the reference lies in the chart, as the map tells it.
    pub origin: [f32; 4],
    /// Towards the ideal point in the north, x and z, where light goes by one.
    pub north: [f32; 4],
    /// What bends what grows there.
    pub pressers: [PresserUniform; PRESSERS],
}

impl ChartUniform {
    fn new(frame: &Frame, chart: ChartId, pressers: &Pressers) -> Self {
        let columns = |matrix: DMat4| matrix.as_mat4().to_cols_array_2d();
        let (strategy, eye) = (&*frame.view.strategy, &frame.view.eye);
        let reference = strategy.reference(eye, chart);
        let fraction = reference - whole_reference(frame, chart);
        // The shaders know of an edge that is a circle from the space.
        let [low, high] = match strategy.domain(chart) {
            Domain::Rectangle { low, high } => [low - reference.xz(), high - reference.xz()],
            Domain::Everywhere | Domain::Disc { .. } => [DVec2::NEG_INFINITY, DVec2::INFINITY],
        };
        let within =
            |side: DVec2| side.clamp(DVec2::splat(-UNLIMITED_M), DVec2::splat(UNLIMITED_M));
        let [low, high] = [low, high].map(|side| within(side).as_vec2());
        Self {
            view: columns(frame.view.chart_matrix(chart)),
            home: columns(strategy.light_matrix(eye, chart)),
            fraction: fraction.as_vec3().into(),
            joins: strategy
                .tiled()
                .map_or(0, |tiled| tiled.joins(chart).bits()),
            domain_low: low.into(),
            domain_high: high.into(),
            origin: strategy.port_origin(eye, chart).as_vec4().into(),
            north: strategy
                .ideal_north(chart)
                .as_vec2()
                .extend(0.0)
                .extend(0.0)
                .into(),
            pressers: pressers.uniforms(frame, chart),
        }
    }
}

/// The scene of a view and the charts of what it draws.
#[derive(Debug)]
pub struct Charts {
    numbered: Vec<ChartId>,
    /// What is sent, kept for its room.
    bytes: Vec<u8>,
    uniforms: Buffer,
    bound: BindGroup,
}

impl Charts {
    /// None.
    pub fn new(device: &Device) -> Self {
        let (uniforms, bound) = room_for(device, FIRST_ROOM);
        Self {
            numbered: Vec::new(),
            bytes: Vec::new(),
            uniforms,
            bound,
        }
    }

    /// Begins a frame: that of the eye is the first.
    pub fn begin(&mut self, frame: &Frame) {
        self.numbered.clear();
        self.number(frame.view.eye.point.chart);
    }

    /// The number by which a chart is bound in this frame.
    pub fn number(&mut self, chart: ChartId) -> u32 {
        let known = self.numbered.iter().position(|it| *it == chart);
        known.unwrap_or_else(|| {
            self.numbered.push(chart);
            self.numbered.len() - 1
        }) as u32
    }

    /// Sends the scene, and what the shaders are to know of the charts that were numbered.
    pub fn send(
        &mut self,
        device: &Device,
        queue: &Queue,
        frame: &Frame,
        scene: &SceneUniform,
        pressers: &Pressers,
    ) {
        let bytes = CHARTS_AT + self.numbered.len() * STRIDE;
        if bytes > self.uniforms.size() as usize {
            let room = self.numbered.len().next_power_of_two();
            (self.uniforms, self.bound) = room_for(device, room);
        }
        self.bytes.resize(bytes, 0);
        let (head, charts) = self.bytes.split_at_mut(CHARTS_AT);
        head[..size_of::<SceneUniform>()].copy_from_slice(bytemuck::bytes_of(scene));
        for (place, chart) in charts.chunks_exact_mut(STRIDE).zip(&self.numbered) {
            let uniform = ChartUniform::new(frame, *chart, pressers);
            place[..size_of::<ChartUniform>()].copy_from_slice(bytemuck::bytes_of(&uniform));
        }
        queue.write_buffer(&self.uniforms, 0, &self.bytes);
    }

    /// Has what is drawn from now on be of the chart of that number; the eye's is 0.
    pub fn bind(&self, pass: &mut RenderPass<'_>, number: u32) {
        pass.set_bind_group(GROUP, &self.bound, &[number * STRIDE as u32]);
    }
}

/// What a chart and the scene are bound by.
pub fn chart_layout(device: &Device) -> BindGroupLayout {
    let entry = |binding, has_dynamic_offset, bytes: usize| wgpu::BindGroupLayoutEntry {
        binding,
        visibility: ShaderStages::VERTEX_FRAGMENT,
        ty: wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Uniform,
            has_dynamic_offset,
            min_binding_size: wgpu::BufferSize::new(bytes as u64),
        },
        count: None,
    };
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("scene and chart"),
        entries: &[
            entry(0, false, size_of::<SceneUniform>()),
            entry(1, true, size_of::<ChartUniform>()),
        ],
    })
}

fn room_for(device: &Device, charts: usize) -> (Buffer, BindGroup) {
    let uniforms = device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("scene and charts"),
        size: (CHARTS_AT + charts * STRIDE) as u64,
        usage: BufferUsages::UNIFORM | BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    let entry = |binding, offset: usize, bytes: usize| wgpu::BindGroupEntry {
        binding,
        resource: wgpu::BindingResource::Buffer(wgpu::BufferBinding {
            buffer: &uniforms,
            offset: offset as u64,
            size: wgpu::BufferSize::new(bytes as u64),
        }),
    };
    let bound = device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("scene and charts"),
        layout: &chart_layout(device),
        entries: &[
            entry(0, 0, size_of::<SceneUniform>()),
            entry(1, CHARTS_AT, size_of::<ChartUniform>()),
        ],
    });
    (uniforms, bound)
}

/// The whole metres next to a frame's reference, from which chunks are measured: those differences are exact.
pub fn whole_reference(frame: &Frame, chart: ChartId) -> DVec3 {
    frame
        .view
        .strategy
        .reference(&frame.view.eye, chart)
        .round()
}

/// A point as the shaders take it: metres from the reference of its chart.
pub fn offset_of(frame: &Frame, point: ChartPoint) -> DVec3 {
    point.pos - frame.view.strategy.reference(&frame.view.eye, point.chart)
}
