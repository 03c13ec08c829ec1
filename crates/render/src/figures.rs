//! Figures: one mesh for each model, an instance for each figure.

use antipode_scene::frame::{Figure, Frame, ModelId};
use glam::DVec3;
use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{Buffer, BufferUsages, Device, Queue, RenderPass, RenderPipeline};

use crate::astronaut::astronaut;
use crate::lamps::lights_near;
use crate::pipelines::Pipelines;
use crate::plan::{Affine, FramePlan, Tolerance};
use crate::solids::Solid;
use crate::things::{Head, bullet, gun, lamp, pickaxe};
use crate::uniforms::{FigureInstance, frame_rows, hemisphere_index, offset_of};

/// Widest angle of a leg from straight down, radians.
const SWING_RAD: f32 = 0.62;
/// The body rises by this much when the legs pass each other, metres.
const RISE_M: f32 = 0.035;

/// Half the sides of the box that a figure in any pose stays in, metres.
const FIGURE_HALF_WIDTH_M: f64 = 0.6;
/// Half its height, metres.
const FIGURE_HALF_HEIGHT_M: f64 = 0.95;

/// Where a model lies in the buffers.
#[derive(Clone, Copy, Debug)]
struct Place {
    base_vertex: i32,
    first_index: u32,
    index_count: u32,
}

/// Figures drawn at once: of one model, and all by a frame or all by the vertex.
#[derive(Clone, Copy, Debug)]
struct Run {
    model: usize,
    framed: bool,
    first: u32,
    count: u32,
}

/// The models on the adapter and this frame's figures.
#[derive(Debug)]
pub struct Figures {
    vertices: Buffer,
    indices: Buffer,
    places: Vec<Place>,
    instances: Buffer,
    room: usize,
    runs: Vec<Run>,
}

fn solid(model: ModelId) -> Solid {
    match model {
        ModelId::Astronaut => astronaut(),
        ModelId::Lamp => lamp(),
        ModelId::Bullet => bullet(),
        ModelId::Gun => gun(),
        ModelId::PickaxeWood => pickaxe(Head::Wood),
        ModelId::PickaxeIron => pickaxe(Head::Iron),
        ModelId::PickaxeDiamond => pickaxe(Head::Diamond),
    }
}

/// The number of a model in the buffers.
fn number(model: ModelId) -> usize {
    ModelId::ALL.iter().position(|it| *it == model).unwrap_or(0)
}

impl Figures {
    /// Uploads the models.
    pub fn new(device: &Device) -> Self {
        let mut whole = Solid::default();
        let places = ModelId::ALL.map(|model| {
            let solid = solid(model);
            let place = Place {
                base_vertex: whole.vertices.len() as i32,
                first_index: whole.indices.len() as u32,
                index_count: solid.indices.len() as u32,
            };
            whole.vertices.extend(solid.vertices);
            whole.indices.extend(solid.indices);
            place
        });
        let vertices = device.create_buffer_init(&BufferInitDescriptor {
            label: Some("model vertices"),
            contents: bytemuck::cast_slice(&whole.vertices),
            usage: BufferUsages::VERTEX,
        });
        let indices = device.create_buffer_init(&BufferInitDescriptor {
            label: Some("model indices"),
            contents: bytemuck::cast_slice(&whole.indices),
            usage: BufferUsages::INDEX,
        });
        let room = 16;
        Self {
            vertices,
            indices,
            places: places.to_vec(),
            instances: instance_buffer(device, room),
            room,
            runs: Vec::new(),
        }
    }

    /// Takes this frame's figures, those that a frame serves within the tolerance first.
    pub fn prepare(&mut self, device: &Device, queue: &Queue, frame: &Frame, plan: &mut FramePlan) {
        let mut seen: Vec<(usize, bool, FigureInstance)> = Vec::with_capacity(frame.figures.len());
        for figure in &frame.figures {
            let plain = instance(frame, figure);
            let model = number(figure.model);
            match figure_frame(frame, plan, figure) {
                Some((affine, error_px)) => {
                    plan.stats.error_at_least(error_px);
                    let frame = frame_rows(&affine);
                    seen.push((model, true, FigureInstance { frame, ..plain }));
                }
                None => seen.push((model, false, plain)),
            }
        }
        // A stable sort: figures of a kind keep their order, and so the picture its bits.
        seen.sort_by_key(|(model, framed, _)| (!framed, *model));
        plan.stats.figures_by_frame = seen.iter().filter(|(_, framed, _)| *framed).count();
        plan.stats.figures_by_vertex = seen.len() - plan.stats.figures_by_frame;
        self.runs.clear();
        for (model, framed, _) in &seen {
            match self.runs.last_mut() {
                Some(run) if (run.model, run.framed) == (*model, *framed) => run.count += 1,
                last => {
                    let first = last.map_or(0, |run| run.first + run.count);
                    self.runs.push(Run {
                        model: *model,
                        framed: *framed,
                        first,
                        count: 1,
                    });
                }
            }
        }
        if seen.len() > self.room {
            self.room = seen.len().next_power_of_two();
            self.instances = instance_buffer(device, self.room);
        }
        let instances: Vec<FigureInstance> = seen.into_iter().map(|(.., it)| it).collect();
        queue.write_buffer(&self.instances, 0, bytemuck::cast_slice(&instances));
    }

    /// Draws them; returns triangles and draw calls.
    pub fn draw(&self, pass: &mut RenderPass<'_>, pipelines: &Pipelines) -> (usize, usize) {
        let mut triangles = 0;
        pass.set_vertex_buffer(0, self.vertices.slice(..));
        pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint16);
        for run in &self.runs {
            let place = self.places[run.model];
            // Not every adapter draws instances from a number on, so the buffer begins there.
            let start = u64::from(run.first) * size_of::<FigureInstance>() as u64;
            pass.set_pipeline(if run.framed {
                &pipelines.figure_framed
            } else {
                &pipelines.figure
            });
            pass.set_vertex_buffer(1, self.instances.slice(start..));
            let indices = place.first_index..place.first_index + place.index_count;
            pass.draw_indexed(indices, place.base_vertex, 0..run.count);
            triangles += place.index_count / 3 * run.count;
        }
        (triangles as usize, self.runs.len())
    }
}

impl Figures {
    /// Draws them into a shadow map; returns triangles.
    pub fn draw_shadows(&self, pass: &mut RenderPass<'_>, pipeline: &RenderPipeline) -> usize {
        let mut triangles = 0;
        pass.set_pipeline(pipeline);
        pass.set_vertex_buffer(0, self.vertices.slice(..));
        pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint16);
        for run in &self.runs {
            let place = self.places[run.model];
            let start = u64::from(run.first) * size_of::<FigureInstance>() as u64;
            pass.set_vertex_buffer(1, self.instances.slice(start..));
            let indices = place.first_index..place.first_index + place.index_count;
            pass.draw_indexed(indices, place.base_vertex, 0..run.count);
            triangles += place.index_count / 3 * run.count;
        }
        triangles as usize
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
        lights: lights_near(
            frame,
            figure.point.hemisphere,
            figure.point.pos,
            figure.point.pos + DVec3::Y * (2.0 * FIGURE_HALF_HEIGHT_M),
        ),
    }
}
