//! Draws a view's figures: their instances, the joints of those that bend, and the calls.

use std::ops::Range;

use antipode_geometry::ChartId;
use wgpu::{BindGroup, Buffer, Device, Queue, RenderPass};

use crate::charts::Charts;
use crate::draw_list::DrawCount;
use crate::figure_buffers::{BATCH, ROWS_BYTES, Statics, instance_buffer, joints_buffer};
use crate::figure_pipelines::FigurePipelines;
use crate::pipelines::Pipelines;
use crate::rig::{JOINTS, JointRows};
use crate::shadow::Caster;
use crate::uniforms::{FigureInstance, PLACE_SHIFT};

/// How figures are carried into the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Way {
    /// Before the eye, in its own axes.
    Hand,
    /// The same where no lamp or beam shines.
    UnlitHand,
    /// By one matrix.
    Framed,
    /// Vertex by vertex.
    Vertex,
    /// Not at all: only its shadow is seen.
    Shade,
}

/// Figures drawn at once.
#[derive(Clone, Copy, Debug)]
struct Run {
    model: usize,
    way: Way,
    /// The chart's number.
    chart: u32,
    first: u32,
    count: u32,
    /// Where the joints of the first lie, in figures that bend.
    joints: Option<u32>,
}

/// A figure about to be drawn.
#[derive(Debug)]
pub struct Seen {
    /// The number of its model.
    pub model: usize,
    /// How it is carried into the picture.
    pub way: Way,
    /// Where it stands.
    pub instance: FigureInstance,
    /// Where its joints are, if it bends.
    pub joints: Option<Vec<JointRows>>,
    /// Its chart.
    pub chart: ChartId,
    /// The box of the chart that it takes, of what throws a shadow.
    pub room: Option<Caster>,
}

/// A view's figures on the adapter.
#[derive(Debug)]
pub struct FigureDraws {
    instances: Buffer,
    room: usize,
    joints: Buffer,
    joints_bound: BindGroup,
    joints_room: usize,
    runs: Vec<Run>,
    /// Boxes of the chart that hold each figure, and what it holds, as far as they throw shadows.
    rooms: Vec<Caster>,
}

impl FigureDraws {
    /// Buffers for a handful of figures.
    pub fn new(device: &Device) -> Self {
        let (room, joints_room) = (16, BATCH);
        let (joints, joints_bound) = joints_buffer(device, joints_room);
        Self {
            instances: instance_buffer(device, room),
            room,
            joints,
            joints_bound,
            joints_room,
            runs: Vec::new(),
            rooms: Vec::new(),
        }
    }

    /// Takes the figures of a frame.
    pub fn take(
        &mut self,
        device: &Device,
        queue: &Queue,
        mut seen: Vec<Seen>,
        charts: &mut Charts,
    ) {
        // A stable sort: figures of a kind keep their order, and so the picture its bits.
        seen.sort_by_key(|it| (it.way, it.model, it.chart));
        self.rooms.clear();
        self.rooms.extend(seen.iter().filter_map(|it| it.room));
        let rows = self.run_up(&mut seen, charts);
        self.send(device, queue, &seen, &rows);
    }

    /// Brings together what one call can draw, and the joints of all that bend, each with its place among them.
    fn run_up(&mut self, seen: &mut [Seen], charts: &mut Charts) -> Vec<JointRows> {
        let mut rows: Vec<JointRows> = Vec::new();
        self.runs.clear();
        for (first, it) in (0..).zip(seen.iter_mut()) {
            let chart = charts.number(it.chart);
            let goes_on = self.runs.last_mut().filter(|run| {
                let full = run.joints.is_some() && run.count as usize >= BATCH;
                (run.model, run.way, run.chart) == (it.model, it.way, chart) && !full
            });
            if let Some(run) = goes_on {
                run.count += 1;
            } else {
                // A batch begins where the adapter can bind it, which the figures in it fill up to.
                rows.resize(
                    rows.len().next_multiple_of(BATCH * JOINTS),
                    JointRows::default(),
                );
                self.runs.push(Run {
                    model: it.model,
                    way: it.way,
                    chart,
                    first,
                    count: 1,
                    joints: it.joints.as_ref().map(|_| (rows.len() * ROWS_BYTES) as u32),
                });
            }
            if let Some(joints) = it.joints.take() {
                let place = self.runs.last().map_or(0, |run| run.count - 1);
                it.instance.flags |= place << PLACE_SHIFT;
                let end = rows.len() + JOINTS;
                rows.extend(joints);
                rows.resize(end, JointRows::default());
            }
        }
        rows
    }

    fn send(&mut self, device: &Device, queue: &Queue, seen: &[Seen], rows: &[JointRows]) {
        if seen.len() > self.room {
            self.room = seen.len().next_power_of_two();
            self.instances = instance_buffer(device, self.room);
        }
        let instances: Vec<FigureInstance> = seen.iter().map(|it| it.instance).collect();
        queue.write_buffer(&self.instances, 0, bytemuck::cast_slice(&instances));
        let figures = (rows.len() / JOINTS).next_multiple_of(BATCH);
        if figures > self.joints_room {
            self.joints_room = figures.next_power_of_two();
            (self.joints, self.joints_bound) = joints_buffer(device, self.joints_room);
        }
        queue.write_buffer(&self.joints, 0, bytemuck::cast_slice(rows));
    }

    /// Boxes of the chart that hold those of this frame's figures that may throw shadows.
    pub fn rooms(&self) -> &[Caster] {
        &self.rooms
    }

    /// Draws what hides things behind it; returns what that took.
    pub fn draw(
        &self,
        pass: &mut RenderPass<'_>,
        models: &Statics,
        charts: &Charts,
        pipelines: &Pipelines,
    ) -> DrawCount {
        self.draw_parts(pass, models, charts, &pipelines.figures, false)
    }

    /// Draws what lets light through, which is to come after all that is solid; returns what that took.
    pub fn draw_clear(
        &self,
        pass: &mut RenderPass<'_>,
        models: &Statics,
        charts: &Charts,
        pipelines: &Pipelines,
    ) -> DrawCount {
        self.draw_parts(pass, models, charts, &pipelines.figures, true)
    }

    /// Draws what is solid of them into a shadow map, finely or coarsely; returns triangles.
    pub fn draw_shadows(
        &self,
        pass: &mut RenderPass<'_>,
        models: &Statics,
        charts: &Charts,
        pipelines: &FigurePipelines,
        coarse: bool,
    ) -> usize {
        let mut triangles = 0;
        for run in self
            .runs
            .iter()
            .filter(|run| !matches!(run.way, Way::Hand | Way::UnlitHand))
        {
            let ranges = &models.ranges[run.model];
            let indices = if coarse {
                &ranges.coarse
            } else {
                &ranges.solid
            };
            if indices.is_empty() {
                continue;
            }
            if run.joints.is_some() {
                pass.set_pipeline(&pipelines.bent_caster);
            } else {
                pass.set_pipeline(&pipelines.caster);
                pass.set_bind_group(2, &self.joints_bound, &[0]);
            }
            triangles += self.draw_run(pass, models, charts, run, indices);
        }
        triangles
    }

    /// Draws what lets light through of them, or all else.
    fn draw_parts(
        &self,
        pass: &mut RenderPass<'_>,
        models: &Statics,
        charts: &Charts,
        pipelines: &FigurePipelines,
        clear: bool,
    ) -> DrawCount {
        let mut count = DrawCount::default();
        for run in self.runs.iter().filter(|run| run.way != Way::Shade) {
            let ranges = &models.ranges[run.model];
            let indices = if clear { &ranges.clear } else { &ranges.solid };
            if indices.is_empty() {
                continue;
            }
            pass.set_pipeline(match (run.way, run.joints, clear) {
                (Way::Hand, _, false) => &pipelines.hand,
                (Way::UnlitHand, _, false) => {
                    pipelines.unlit_hand.as_ref().unwrap_or(&pipelines.hand)
                }
                (Way::Hand | Way::UnlitHand, _, true) => &pipelines.hand_clear,
                (Way::Framed, Some(_), _) => &pipelines.bent_framed,
                (Way::Vertex | Way::Shade, Some(_), _) => &pipelines.bent,
                (Way::Framed, None, false) => &pipelines.framed,
                (Way::Vertex | Way::Shade, None, false) => &pipelines.plain,
                (Way::Framed, None, true) => &pipelines.clear_framed,
                (Way::Vertex | Way::Shade, None, true) => &pipelines.clear,
            });
            count.triangles += self.draw_run(pass, models, charts, run, indices);
            count.draws += 1;
        }
        count
    }

    /// Draws a part of a run's model with the pipeline that is set; returns triangles.
    fn draw_run(
        &self,
        pass: &mut RenderPass<'_>,
        models: &Statics,
        charts: &Charts,
        run: &Run,
        indices: &Range<u32>,
    ) -> usize {
        models.bind(pass, run.joints.is_some());
        charts.bind(pass, run.chart);
        if let Some(offset) = run.joints {
            pass.set_bind_group(2, &self.joints_bound, &[offset]);
        }
        // Not every adapter draws instances from a number on, so the buffer begins there.
        let start = u64::from(run.first) * size_of::<FigureInstance>() as u64;
        pass.set_vertex_buffer(1, self.instances.slice(start..));
        let base_vertex = models.ranges[run.model].base_vertex;
        pass.draw_indexed(indices.clone(), base_vertex, 0..run.count);
        indices.len() / 3 * run.count as usize
    }
}
