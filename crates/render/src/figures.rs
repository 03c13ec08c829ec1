//! Figures: one mesh for each model, an instance for each figure and for what it holds.

use std::ops::Range;

use antipode_frame::{Figure, Frame, ModelId};
use antipode_geometry::ChartPoint;
use glam::{DQuat, DVec3, Mat3, Quat, Vec3};
use wgpu::{BindGroup, Buffer, Device, Queue, RenderPass};

use crate::culling::{Reaches, Shown, Wanted};
use crate::error::RenderError;
use crate::figure_buffers::{BATCH, Place, ROWS_BYTES, Statics, instance_buffer, joints_buffer};
use crate::hand;
use crate::lamps::lights_near;
use crate::models::{Loaded, number};
use crate::pipelines::{FigurePipelines, Pipelines};
use crate::plan::{FramePlan, Tolerance};
use crate::rig::{JOINTS, JointRows, Posed};
use crate::shadow::{Caster, Shot};
use crate::uniforms::{FigureInstance, chart_index, frame_rows, offset_of};

/// How figures are carried into the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Way {
    /// Before the eye, in its own axes.
    Hand,
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
    first: u32,
    count: u32,
    /// Where the joints of the first lie, in figures that bend.
    joints: Option<u32>,
}

/// A figure about to be drawn.
#[derive(Debug)]
struct Seen {
    model: usize,
    way: Way,
    instance: FigureInstance,
    joints: Option<Vec<JointRows>>,
    /// The box of the chart that it takes, of what throws a shadow.
    room: Option<Caster>,
}

/// The models on the adapter and this frame's figures.
#[derive(Debug)]
pub struct Figures {
    models: Vec<Loaded>,
    reaches: Reaches,
    /// Whether figures that nobody sees are left out.
    pub culls: bool,
    statics: Statics,
    instances: Buffer,
    room: usize,
    joints: Buffer,
    joints_bound: BindGroup,
    joints_room: usize,
    runs: Vec<Run>,
    /// Boxes of the chart that hold each figure, and what it holds, as far as they throw shadows.
    rooms: Vec<Caster>,
}

impl Figures {
    /// Reads and uploads the models.
    ///
    /// # Errors
    /// When a model cannot be read.
    pub fn new(device: &Device) -> Result<Self, RenderError> {
        let models = crate::models::load_all()?;
        let (room, joints_room) = (16, BATCH);
        let (joints, joints_bound) = joints_buffer(device, joints_room);
        Ok(Self {
            statics: Statics::new(device, &models),
            reaches: Reaches::of(&models),
            culls: true,
            models,
            instances: instance_buffer(device, room),
            room,
            joints,
            joints_bound,
            joints_room,
            runs: Vec::new(),
            rooms: Vec::new(),
        })
    }

    /// Takes this frame's figures, those that a frame serves within the tolerance first, if they or their shadows on
    /// `map` may be seen.
    pub fn prepare(
        &mut self,
        (device, queue): (&Device, &Queue),
        frame: &Frame,
        plan: &mut FramePlan,
        map: Option<Shot>,
    ) {
        let mut seen: Vec<Seen> = Vec::new();
        let shown = Shown::new(frame, plan, map);
        for figure in &frame.figures {
            let mut wanted = shown.wants(&self.reaches.ball(figure));
            plan.stats.figures_outside += usize::from(!wanted.seen);
            wanted.seen |= !self.culls;
            if wanted.seen || wanted.shades {
                self.see(frame, plan, (figure, wanted), &mut seen);
            }
        }
        let count = |way: Way| seen.iter().filter(|it| it.way == way).count();
        plan.stats.figures_by_frame = count(Way::Framed);
        plan.stats.figures_by_vertex = count(Way::Vertex);
        let in_hand = frame
            .hand
            .iter()
            .flat_map(|hand| hand::instances(frame, hand));
        seen.extend(in_hand.map(|(model, instance)| Seen {
            model: number(model),
            way: Way::Hand,
            instance,
            joints: None,
            room: None,
        }));
        // A stable sort: figures of a kind keep their order, and so the picture its bits.
        seen.sort_by_key(|it| (it.way, it.model));
        self.rooms.clear();
        self.rooms.extend(seen.iter().filter_map(|it| it.room));
        let rows = self.run_up(&mut seen);
        self.send(device, queue, &seen, &rows);
    }

    /// Adds a figure, and what it holds.
    fn see(
        &self,
        frame: &Frame,
        plan: &mut FramePlan,
        (figure, wanted): (&Figure, Wanted),
        seen: &mut Vec<Seen>,
    ) {
        let model = number(figure.model);
        let Loaded { shape: _, rig } = &self.models[model];
        let posed = rig.as_ref().map(|rig| rig.pose(&figure.posture));
        let limits = posed
            .as_ref()
            .map_or(self.statics.places[model].limits, |posed| posed.limits);
        put(frame, plan, (figure, wanted), (model, limits), seen);
        let Some(Posed { joints, hand, .. }) = posed else {
            return;
        };
        if let Some(last) = seen.last_mut() {
            last.joints = Some(joints);
        }
        let Some(held) = figure.held else { return };
        let (turn, place) = in_hand(figure, held, hand);
        let flash = figure.flashes.then_some(ModelId::Flash);
        for thing in [Some(held), flash].into_iter().flatten() {
            let beyond = if thing == ModelId::Flash {
                turn * hand::MUZZLE_M.as_dvec3()
            } else {
                DVec3::ZERO
            };
            let figure = Figure {
                turn,
                ..Figure::standing(thing, place.moved(beyond), 0.0)
            };
            let thing = number(thing);
            let limits = self.statics.places[thing].limits;
            put(frame, plan, (&figure, wanted), (thing, limits), seen);
        }
    }

    /// Brings together what one call can draw, and the joints of all that bend, each with its place among them.
    fn run_up(&mut self, seen: &mut [Seen]) -> Vec<JointRows> {
        let mut rows: Vec<JointRows> = Vec::new();
        self.runs.clear();
        for (first, it) in (0..).zip(seen.iter_mut()) {
            let goes_on = self.runs.last_mut().filter(|run| {
                let full = run.joints.is_some() && run.count as usize >= BATCH;
                (run.model, run.way) == (it.model, it.way) && !full
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
                    first,
                    count: 1,
                    joints: it.joints.as_ref().map(|_| (rows.len() * ROWS_BYTES) as u32),
                });
            }
            if let Some(joints) = it.joints.take() {
                let place = self.runs.last().map_or(0, |run| run.count - 1);
                it.instance.flags |= place << 2;
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

    /// Draws what hides things behind it; returns triangles and draw calls.
    pub fn draw(&self, pass: &mut RenderPass<'_>, pipelines: &Pipelines) -> (usize, usize) {
        self.draw_parts(pass, &pipelines.figures, |place| &place.solid, false)
    }

    /// Draws what lets light through, which is to come after all that is solid; returns triangles and draw calls.
    pub fn draw_clear(&self, pass: &mut RenderPass<'_>, pipelines: &Pipelines) -> (usize, usize) {
        self.draw_parts(pass, &pipelines.figures, |place| &place.clear, true)
    }

    /// Draws what is solid of them into a shadow map, finely or coarsely; returns triangles.
    pub fn draw_shadows(
        &self,
        pass: &mut RenderPass<'_>,
        pipelines: &FigurePipelines,
        coarse: bool,
    ) -> usize {
        let mut triangles = 0;
        for run in self.runs.iter().filter(|run| run.way != Way::Hand) {
            let place = &self.statics.places[run.model];
            let indices = if coarse { &place.coarse } else { &place.solid };
            if indices.is_empty() {
                continue;
            }
            pass.set_pipeline(match run.joints {
                Some(_) => &pipelines.bent_caster,
                None => &pipelines.caster,
            });
            triangles += self.draw_run(pass, run, indices);
        }
        triangles
    }

    fn draw_parts(
        &self,
        pass: &mut RenderPass<'_>,
        pipelines: &FigurePipelines,
        part: impl Fn(&Place) -> &Range<u32>,
        clear: bool,
    ) -> (usize, usize) {
        let (mut triangles, mut calls) = (0, 0);
        for run in self.runs.iter().filter(|run| run.way != Way::Shade) {
            let indices = part(&self.statics.places[run.model]);
            if indices.is_empty() {
                continue;
            }
            pass.set_pipeline(match (run.way, run.joints, clear) {
                (Way::Hand, _, false) => &pipelines.hand,
                (Way::Hand, _, true) => &pipelines.hand_clear,
                (Way::Framed, Some(_), _) => &pipelines.bent_framed,
                (Way::Vertex | Way::Shade, Some(_), _) => &pipelines.bent,
                (Way::Framed, None, false) => &pipelines.framed,
                (Way::Vertex | Way::Shade, None, false) => &pipelines.plain,
                (Way::Framed, None, true) => &pipelines.clear_framed,
                (Way::Vertex | Way::Shade, None, true) => &pipelines.clear,
            });
            triangles += self.draw_run(pass, run, indices);
            calls += 1;
        }
        (triangles, calls)
    }

    /// Draws a part of a run's model with the pipeline that is set; returns triangles.
    fn draw_run(&self, pass: &mut RenderPass<'_>, run: &Run, indices: &Range<u32>) -> usize {
        self.statics.bind(pass, run.joints.is_some());
        if let Some(offset) = run.joints {
            pass.set_bind_group(1, &self.joints_bound, &[offset]);
        }
        // Not every adapter draws instances from a number on, so the buffer begins there.
        let start = u64::from(run.first) * size_of::<FigureInstance>() as u64;
        pass.set_vertex_buffer(1, self.instances.slice(start..));
        let base_vertex = self.statics.places[run.model].base_vertex;
        pass.draw_indexed(indices.clone(), base_vertex, 0..run.count);
        indices.len() / 3 * run.count as usize
    }
}

/// Adds one instance, whose vertices are within a box about its origin.
fn put(
    frame: &Frame,
    plan: &mut FramePlan,
    (figure, wanted): (&Figure, Wanted),
    (model, limits): (usize, (Vec3, Vec3)),
    seen: &mut Vec<Seen>,
) {
    let (low, high) = turned(limits, figure.turn.as_quat());
    let middle = figure.point.moved(low.midpoint(high).as_dvec3());
    let half = (0.5 * (high - low)).as_dvec3();
    let chart = figure.point.chart;
    let (min, max) = (middle.pos - half, middle.pos + half);
    let mut instance = FigureInstance {
        offset: offset_of(frame, figure.point),
        flags: chart_index(chart) | u32::from(figure.hostile) << 1,
        turn: figure.turn.as_quat().to_array(),
        frame: [[0.0; 4]; 4],
        lights: [0; 3],
    };
    let mut way = Way::Shade;
    if wanted.seen {
        instance.lights = lights_near(frame, chart, min, max);
        let tolerance_px = Tolerance::of(frame.quality).shape_px;
        let bounds = &plan.bounds;
        way = match bounds.object(frame, figure.point, middle, half, tolerance_px) {
            Some((affine, error_px)) => {
                plan.stats.error_at_least(error_px);
                instance.frame = frame_rows(&affine);
                Way::Framed
            }
            None => Way::Vertex,
        };
    }
    seen.push(Seen {
        model,
        way,
        instance,
        joints: None,
        room: wanted.shades.then_some(Caster { chart, min, max }),
    });
}

/// How what a figure holds is turned and where its origin is, given how its hand is in the figure's axes.
fn in_hand(figure: &Figure, held: ModelId, (turn, place): (Quat, Vec3)) -> (DQuat, ChartPoint) {
    let turn = figure.turn * turn.as_dquat();
    let grip = turn * -hand::grip_m(held).as_dvec3();
    let place = figure.turn * place.as_dvec3();
    (turn, figure.point.moved(place + grip))
}

/// The box of a turned box.
fn turned((low, high): (Vec3, Vec3), turn: Quat) -> (Vec3, Vec3) {
    let axes = Mat3::from_quat(turn);
    let middle = axes * low.midpoint(high);
    let half = 0.5 * (high - low);
    let reach =
        axes.x_axis.abs() * half.x + axes.y_axis.abs() * half.y + axes.z_axis.abs() * half.z;
    (middle - reach, middle + reach)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_turned_box_holds_every_corner() {
        let limits = (Vec3::new(-0.2, 0.0, -0.7), Vec3::new(1.5, 1.8, 0.3));
        let turn = Quat::from_rotation_y(0.7) * Quat::from_rotation_x(-1.1);
        let (low, high) = turned(limits, turn);
        for corner in 0..8 {
            let pick = |axis: usize| {
                if corner >> axis & 1 == 1 {
                    limits.1[axis]
                } else {
                    limits.0[axis]
                }
            };
            let at = turn * Vec3::from_array([0, 1, 2].map(pick));
            assert!(
                at.cmpge(low - 1e-5).all() && at.cmple(high + 1e-5).all(),
                "{at}"
            );
        }
    }
}
