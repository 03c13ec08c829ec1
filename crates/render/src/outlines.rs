//! Outlines of the shapes by which things are hit: unit shapes of short lines, placed by instances and ported by vertex.

use std::f32::consts::TAU;

use antipode_frame::{Frame, HitForm, HitShape};
use bytemuck::{Pod, Zeroable};
use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{Buffer, BufferUsages, Device, Queue, RenderPass, RenderPipeline};

use crate::charts::{Charts, offset_of};
use crate::draw_list::DrawCount;
use crate::uniforms::OutlineInstance;

/// Linear light of what moves, and of what rests.
const AWAKE: [f32; 3] = [0.05, 1.1, 0.12];
const ASLEEP: [f32; 3] = [1.3, 0.04, 0.03];
/// Lines of a full ring, and of a straight edge: what bends in the space is seen to bend.
const RING_LINES: u16 = 32;
const EDGE_LINES: u16 = 8;
/// Room for so many shapes at first.
const FIRST_ROOM: usize = 64;

/// An end of a line, twice for its two sides.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Corner {
    /// Where the end is on the unit shape; last, 1 if it goes with the upper middle and 0 with the lower.
    here: [f32; 4],
    /// The other end.
    there: [f32; 4],
    /// The side of the line, as one looks from here to there: 1 or -1.
    side: f32,
}

impl Corner {
    /// Attributes from location 0 on.
    pub const ATTRIBUTES: [wgpu::VertexAttribute; 3] =
        wgpu::vertex_attr_array![0 => Float32x4, 1 => Float32x4, 2 => Float32];
}

/// Indices of one kind of shape.
#[derive(Clone, Copy, Debug, Default)]
struct Span {
    first: u32,
    end: u32,
}

/// The unit shapes on the adapter, and this frame's instances of each.
#[derive(Debug)]
pub struct Outlines {
    corners: Buffer,
    indices: Buffer,
    /// Capsule, ball and box.
    spans: [Span; 3],
    instances: Buffer,
    room: usize,
    /// What of this frame one call draws.
    runs: Vec<Run>,
}

/// Shapes of a kind in a chart.
#[derive(Clone, Copy, Debug)]
struct Run {
    kind: usize,
    /// The chart's number.
    chart: u32,
    count: u32,
}

impl Outlines {
    /// Uploads the unit shapes.
    pub fn new(device: &Device) -> Self {
        let mut lines = Lines::default();
        let spans = [Lines::capsule, Lines::ball, Lines::cuboid].map(|shape| {
            let first = lines.indices.len() as u32;
            shape(&mut lines);
            let end = lines.indices.len() as u32;
            Span { first, end }
        });
        let corners = device.create_buffer_init(&BufferInitDescriptor {
            label: Some("outline corners"),
            contents: bytemuck::cast_slice(&lines.corners),
            usage: BufferUsages::VERTEX,
        });
        let indices = device.create_buffer_init(&BufferInitDescriptor {
            label: Some("outline indices"),
            contents: bytemuck::cast_slice(&lines.indices),
            usage: BufferUsages::INDEX,
        });
        Self {
            corners,
            indices,
            spans,
            instances: instance_buffer(device, FIRST_ROOM),
            room: FIRST_ROOM,
            runs: Vec::new(),
        }
    }

    /// Takes this frame's shapes.
    pub fn prepare(&mut self, device: &Device, queue: &Queue, frame: &Frame, charts: &mut Charts) {
        self.runs.clear();
        if frame.content.hit_shapes.is_empty() || !frame.view.shows_marks {
            return;
        }
        let mut shapes: Vec<_> = frame.content.hit_shapes.iter().collect();
        let key = |shape: &HitShape| (kind(shape), shape.point.chart);
        shapes.sort_by_key(|shape| key(shape));
        for run in shapes.chunk_by(|a, b| key(a) == key(b)) {
            let (kind, chart) = key(run[0]);
            self.runs.push(Run {
                kind,
                chart: charts.number(chart),
                count: run.len() as u32,
            });
        }
        if shapes.len() > self.room {
            self.room = shapes.len().next_power_of_two();
            self.instances = instance_buffer(device, self.room);
        }
        let instances: Vec<_> = shapes.iter().map(|shape| instance(frame, shape)).collect();
        queue.write_buffer(&self.instances, 0, bytemuck::cast_slice(&instances));
    }

    /// Draws all of them by some pipelines; returns what that took.
    pub fn draw(
        &self,
        pass: &mut RenderPass<'_>,
        charts: &Charts,
        pipelines: [&RenderPipeline; 2],
    ) -> DrawCount {
        pass.set_vertex_buffer(0, self.corners.slice(..));
        pass.set_vertex_buffer(1, self.instances.slice(..));
        pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint16);
        let mut count = DrawCount::default();
        for pipeline in pipelines {
            pass.set_pipeline(pipeline);
            let mut first = 0;
            for run in &self.runs {
                let span = &self.spans[run.kind];
                charts.bind(pass, run.chart);
                pass.draw_indexed(span.first..span.end, 0, first..first + run.count);
                first += run.count;
                count.triangles += ((span.end - span.first) / 3 * run.count) as usize;
                count.draws += 1;
            }
        }
        count
    }
}

fn instance_buffer(device: &Device, room: usize) -> Buffer {
    device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("outlines"),
        size: (room * size_of::<OutlineInstance>()) as u64,
        usage: BufferUsages::VERTEX | BufferUsages::COPY_DST,
        mapped_at_creation: false,
    })
}

fn kind(shape: &HitShape) -> usize {
    match shape.form {
        HitForm::Capsule { .. } => 0,
        HitForm::Ball { .. } => 1,
        HitForm::Box { .. } => 2,
    }
}

fn instance(frame: &Frame, shape: &HitShape) -> OutlineInstance {
    let (size, low, high) = match shape.form {
        HitForm::Capsule { height_m, radius_m } => {
            let radius = radius_m as f32;
            ([radius; 3], radius, height_m as f32 - radius)
        }
        HitForm::Ball { radius_m } => ([radius_m as f32; 3], 0.0, 0.0),
        HitForm::Box { half_m } => (half_m.as_vec3().to_array(), 0.0, 0.0),
    };
    let [x, y, z] = size;
    let [r, g, b] = if shape.awake { AWAKE } else { ASLEEP };
    OutlineInstance {
        offset: offset_of(frame, shape.point).as_vec3().into(),
        turn: shape.turn.as_quat().to_array(),
        size: [x, y, z, low],
        colour: [r, g, b, high],
    }
}

/// Lines of unit shapes, each a thin quad that the shader widens.
#[derive(Default)]
struct Lines {
    corners: Vec<Corner>,
    indices: Vec<u16>,
}

impl Lines {
    fn line(&mut self, a: [f32; 4], b: [f32; 4]) {
        let first = self.corners.len() as u16;
        // Seen from the other end, the same side is the other one.
        self.corners.extend(
            [(a, b, 1.0), (a, b, -1.0), (b, a, -1.0), (b, a, 1.0)]
                .map(|(here, there, side)| Corner { here, there, side }),
        );
        self.indices
            .extend([0, 1, 2, 2, 1, 3].map(|corner| first + corner));
    }

    /// Lines along `at`, from 0 to 1.
    fn path(&mut self, lines: u16, at: impl Fn(f32) -> [f32; 4]) {
        let at = |step: u16| at(f32::from(step) / f32::from(lines));
        for step in 0..lines {
            self.line(at(step), at(step + 1));
        }
    }

    /// A part of the unit circle in the plane of two axes, in turns.
    fn arc(&mut self, [a, b]: [usize; 2], turns: [f32; 2], upper: f32) {
        let [from, to] = turns;
        let lines = (f32::from(RING_LINES) * (to - from).abs()).ceil() as u16;
        self.path(lines, |share| {
            let (sin, cos) = (TAU * (from + (to - from) * share)).sin_cos();
            let mut at = [0.0, 0.0, 0.0, upper];
            (at[a], at[b]) = (cos, sin);
            at
        });
    }

    fn capsule(&mut self) {
        for upper in [0.0, 1.0] {
            self.arc([0, 2], [0.0, 1.0], upper);
        }
        for axis in [0, 2] {
            self.arc([axis, 1], [0.0, 0.5], 1.0);
            self.arc([axis, 1], [0.5, 1.0], 0.0);
            for side in [-1.0, 1.0] {
                self.path(EDGE_LINES, |upper| {
                    let mut at = [0.0, 0.0, 0.0, upper];
                    at[axis] = side;
                    at
                });
            }
        }
    }

    fn ball(&mut self) {
        for axes in [[0, 2], [0, 1], [2, 1]] {
            self.arc(axes, [0.0, 1.0], 0.0);
        }
    }

    fn cuboid(&mut self) {
        for along in 0..3 {
            for (u, v) in [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)] {
                self.path(EDGE_LINES, |share| {
                    let mut at = [0.0; 4];
                    at[along] = 2.0 * share - 1.0;
                    (at[(along + 1) % 3], at[(along + 2) % 3]) = (u, v);
                    at
                });
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lines(shape: impl Fn(&mut Lines)) -> Vec<[[f32; 4]; 2]> {
        let mut lines = Lines::default();
        shape(&mut lines);
        let quads = lines.corners.chunks_exact(4);
        quads.map(|quad| [quad[0].here, quad[0].there]).collect()
    }

    #[test]
    fn a_ball_lies_on_the_unit_sphere_and_a_box_on_the_unit_cube() {
        for end in lines(Lines::ball).concat() {
            let [x, y, z, _] = end;
            assert!(((x * x + y * y + z * z).sqrt() - 1.0).abs() < 1e-6);
        }
        let edges = lines(Lines::cuboid);
        assert_eq!(edges.len(), 12 * usize::from(EDGE_LINES));
        for [x, y, z, _] in edges.concat() {
            let on_faces = [x, y, z].iter().filter(|c| c.abs() == 1.0).count();
            assert!(on_faces >= 2, "{x} {y} {z}");
        }
    }

    #[test]
    fn a_capsule_is_round_at_both_ends_and_straight_between() {
        for end in lines(Lines::capsule).concat() {
            let [x, y, z, upper] = end;
            assert!(((x * x + y * y + z * z).sqrt() - 1.0).abs() < 1e-6);
            // Only the upper half of the upper ball is part of it, and the lower of the lower.
            assert!(y == 0.0 || (y > -1e-6) == (upper > 0.5) || y.abs() < 1e-6);
        }
    }

    #[test]
    fn lines_are_short_enough_to_bend() {
        for shape in [Lines::capsule, Lines::ball, Lines::cuboid] {
            for [a, b] in lines(shape) {
                let length: f32 = a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum();
                assert!(length.sqrt() <= 0.2501, "{a:?} {b:?}");
            }
        }
    }
}
