//! Draws what flies off the ground and what is pressed into it: particles by one call for each chart, marks by another.

use antipode_frame::{Frame, GroundMark, Look, MarkShape, Particle};
use antipode_geometry::ChartId;
use bytemuck::{Pod, Zeroable};
use glam::DVec3;
use wgpu::{Buffer, BufferUsages, Device, Queue, RenderPass, RenderPipeline};

use crate::charts::{Charts, offset_of};
use crate::draw_list::DrawCount;
use crate::lamps::lights_near;
use crate::pipelines::{Maker, VEIL, instances};
use crate::shaders::DUST;

/// Particles that a picture shows.
pub const MOST_PARTICLES: usize = 512;
/// Marks that a picture shows.
pub const MOST_MARKS: usize = 2048;
/// Corners of the two triangles of a square.
const CORNERS: u32 = 6;

/// The ways of drawing both.
#[derive(Debug)]
pub struct DustPipelines {
    /// Particles.
    pub particles: RenderPipeline,
    /// Marks on the ground.
    pub marks: RenderPipeline,
}

impl DustPipelines {
    pub(crate) fn made_by(maker: &Maker<'_>) -> Self {
        let module = maker.compile(DUST);
        Self {
            particles: maker.make(
                &module,
                ["vertex_particle", "fragment_particle"],
                &[instances::<ParticleInstance>(&ParticleInstance::ATTRIBUTES)],
                VEIL,
            ),
            marks: maker.make(
                &module,
                ["vertex_mark", "fragment_mark"],
                &[instances::<MarkInstance>(&MarkInstance::ATTRIBUTES)],
                VEIL,
            ),
        }
    }
}

/// A particle as dust.wgsl reads it.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct ParticleInstance {
    place: [f32; 4],
    ground: [f32; 4],
    colour: [f32; 4],
    looks: [f32; 4],
    lights: [u32; 3],
}

impl ParticleInstance {
    const ATTRIBUTES: [wgpu::VertexAttribute; 5] = wgpu::vertex_attr_array![
        0 => Float32x4, 1 => Float32x4, 2 => Float32x4, 3 => Float32x4, 4 => Uint32x3
    ];

    fn of(frame: &Frame, it: &Particle, lights: [u32; 3]) -> Self {
        let look = match it.look {
            Look::Dust => 0.0,
            Look::Spray => 1.0,
            Look::Chip => 2.0,
        };
        let [r, g, b] = it.colour;
        Self {
            place: offset_of(frame, it.point)
                .as_vec3()
                .extend(it.radius_m)
                .into(),
            ground: it.up.extend(it.height_m).into(),
            colour: [r, g, b, it.opacity],
            looks: [look, it.shape, it.turn_rad, it.sky],
            lights,
        }
    }
}

/// A mark as dust.wgsl reads it.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct MarkInstance {
    corners: [[f32; 3]; 4],
    lies: [f32; 4],
    shape: f32,
}

impl MarkInstance {
    const ATTRIBUTES: [wgpu::VertexAttribute; 6] = wgpu::vertex_attr_array![
        0 => Float32x3, 1 => Float32x3, 2 => Float32x3, 3 => Float32x3, 4 => Float32x4, 5 => Float32
    ];

    fn of(reference: DVec3, it: &GroundMark) -> Self {
        let [from, to] = it.strength;
        let [from_m, to_m] = it.along_m;
        Self {
            corners: it
                .corners
                .map(|corner| (corner - reference).as_vec3().into()),
            lies: [from, to, from_m, to_m],
            shape: match it.shape {
                MarkShape::Print => 0.0,
                MarkShape::Contact => 1.0,
            },
        }
    }
}

/// What one call draws.
#[derive(Clone, Copy, Debug)]
struct Run {
    /// The chart's number.
    chart: u32,
    first: u32,
    count: u32,
}

/// Instances of one sort on the adapter.
#[derive(Debug)]
struct Instances<T> {
    buffer: Buffer,
    runs: Vec<Run>,
    /// What is sent, kept for its room.
    list: Vec<T>,
}

impl<T: Pod> Instances<T> {
    fn new(device: &Device, label: &str, room: usize) -> Self {
        Self {
            buffer: device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size: (room * size_of::<T>()) as u64,
                usage: BufferUsages::VERTEX | BufferUsages::COPY_DST,
                mapped_at_creation: false,
            }),
            runs: Vec::new(),
            list: Vec::with_capacity(room),
        }
    }

    fn begin(&mut self) {
        self.runs.clear();
        self.list.clear();
    }

    fn add(&mut self, chart: u32, it: T) {
        match self.runs.last_mut().filter(|run| run.chart == chart) {
            Some(run) => run.count += 1,
            None => self.runs.push(Run {
                chart,
                first: self.list.len() as u32,
                count: 1,
            }),
        }
        self.list.push(it);
    }

    fn send(&self, queue: &Queue) {
        if !self.list.is_empty() {
            queue.write_buffer(&self.buffer, 0, bytemuck::cast_slice(&self.list));
        }
    }

    fn draw(
        &self,
        pass: &mut RenderPass<'_>,
        charts: &Charts,
        pipeline: &RenderPipeline,
    ) -> DrawCount {
        let mut count = DrawCount::default();
        for run in &self.runs {
            pass.set_pipeline(pipeline);
            charts.bind(pass, run.chart);
            // Not every adapter draws instances from a number on, so the buffer begins there.
            let start = u64::from(run.first) * size_of::<T>() as u64;
            pass.set_vertex_buffer(0, self.buffer.slice(start..));
            pass.draw(0..CORNERS, 0..run.count);
            count.triangles += 2 * run.count as usize;
            count.draws += 1;
        }
        count
    }
}

/// A view's particles and marks on the adapter.
#[derive(Debug)]
pub struct DustDraws {
    particles: Instances<ParticleInstance>,
    marks: Instances<MarkInstance>,
    /// Particles by chart, and in each the farther ones first.
    order: Vec<(u32, f64, usize)>,
}

impl DustDraws {
    /// Room for all that a picture shows.
    pub fn new(device: &Device) -> Self {
        Self {
            particles: Instances::new(device, "particles", MOST_PARTICLES),
            marks: Instances::new(device, "marks", MOST_MARKS),
            order: Vec::with_capacity(MOST_PARTICLES),
        }
    }

    /// Takes a frame's particles and marks.
    pub fn prepare(&mut self, queue: &Queue, frame: &Frame, charts: &mut Charts) {
        self.prepare_particles(frame, charts);
        self.particles.send(queue);
        self.marks.begin();
        let dust = &frame.content.dust;
        let mut here: Option<(ChartId, u32, DVec3)> = None;
        for mark in dust.marks.iter().take(MOST_MARKS) {
            let known = here.filter(|(chart, ..)| *chart == mark.chart);
            let (_, number, reference) = *here.insert(known.unwrap_or_else(|| {
                let reference = frame.view.strategy.reference(&frame.view.eye, mark.chart);
                (mark.chart, charts.number(mark.chart), reference)
            }));
            self.marks.add(number, MarkInstance::of(reference, mark));
        }
        self.marks.send(queue);
    }

    fn prepare_particles(&mut self, frame: &Frame, charts: &mut Charts) {
        let particles = &frame.content.dust.particles;
        self.particles.begin();
        self.order.clear();
        for (at, it) in particles.iter().take(MOST_PARTICLES).enumerate() {
            let away = frame.view.point(it.point).truncate().length();
            self.order.push((charts.number(it.point.chart), away, at));
        }
        let farther_first =
            |a: &(u32, f64, usize), b: &(u32, f64, usize)| a.0.cmp(&b.0).then(b.1.total_cmp(&a.1));
        self.order.sort_unstable_by(farther_first);
        let mut lit: Option<(u32, [u32; 3])> = None;
        for (chart, _, at) in &self.order {
            let it = &particles[*at];
            let known = lit.filter(|(number, _)| number == chart);
            let (_, lights) = *lit.insert(
                known.unwrap_or_else(|| (*chart, lights_on_all(frame, particles, it.point.chart))),
            );
            self.particles
                .add(*chart, ParticleInstance::of(frame, it, lights));
        }
    }

    /// Draws the marks, which are to come after all land; returns what that took.
    pub fn draw_marks(
        &self,
        pass: &mut RenderPass<'_>,
        charts: &Charts,
        pipelines: &DustPipelines,
    ) -> DrawCount {
        self.marks.draw(pass, charts, &pipelines.marks)
    }

    /// Draws the particles, which are to come after all that is solid; returns what that took.
    pub fn draw(
        &self,
        pass: &mut RenderPass<'_>,
        charts: &Charts,
        pipelines: &DustPipelines,
    ) -> DrawCount {
        self.particles.draw(pass, charts, &pipelines.particles)
    }
}

/// Which lamps and beams may light any of a chart's particles.
fn lights_on_all(frame: &Frame, particles: &[Particle], chart: ChartId) -> [u32; 3] {
    let of_chart = particles.iter().filter(|it| it.point.chart == chart);
    let nothing = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    let (min, max) = of_chart.fold(nothing, |(min, max), it| {
        (min.min(it.point.pos), max.max(it.point.pos))
    });
    lights_near(frame, chart, min, max)
}
