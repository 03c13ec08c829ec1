//! Figures: one mesh for each model, and which figures a view shows, with an instance for each and for what it holds.

use antipode_frame::{Figure, Frame, Presence};
use glam::{Mat3, Quat, Vec3};
use wgpu::Device;

use crate::charts::offset_of;
use crate::culling::{Falls, Reaches, Shown, Wanted};
use crate::error::RenderError;
use crate::figure_buffers::Statics;
use crate::figure_draws::{Seen, Way};
use crate::hand::{self, Held, in_hand_of};
use crate::lamps::lights_near;
use crate::models::{Loaded, number};
use crate::plan::{FramePlan, Tolerance};
use crate::rig::Posed;
use crate::shadow::Caster;
use crate::uniforms::{
    BARRED_FLAG, BRAKES_FLAG, FigureInstance, HOSTILE_FLAG, LIGHTS_FLAG, POSSIBLE_FLAG, WHOLE,
    dark_bits, frame_rows, level_row, packed_cut,
};

/// The models, which all views draw figures with.
#[derive(Debug)]
pub struct Figures {
    models: Vec<Loaded>,
    reaches: Reaches,
    /// Whether figures that nobody sees are left out.
    pub culls: bool,
    /// The models on the adapter.
    pub statics: Statics,
}

impl Figures {
    /// Reads and uploads the models.
    ///
    /// # Errors
    /// When a model cannot be read.
    pub fn new(device: &Device) -> Result<Self, RenderError> {
        let models = crate::models::load_all()?;
        Ok(Self {
            statics: Statics::new(device, &models),
            reaches: Reaches::of(&models),
            culls: true,
            models,
        })
    }

    /// The figures of a frame, if they or their shadows on `map` may be seen; and the heights towards the light between
    /// which all lie that fall on it, seen or not: its depth does not depend on the figures that were left out.
    pub fn seen(
        &self,
        frame: &Frame,
        plan: &mut FramePlan,
        map: Option<Falls>,
    ) -> (Vec<Seen>, [f64; 2]) {
        let mut seen: Vec<Seen> = Vec::new();
        let mut heights = [f64::INFINITY, f64::NEG_INFINITY];
        let map = map.map(|map| Falls {
            is_shared: map.is_shared || !self.culls,
            ..map
        });
        let shown = Shown::new(frame, plan, map);
        for figure in &frame.content.figures {
            let mut wanted = shown.wants(&self.reaches.ball(figure));
            if let Some([low, high]) = wanted.falls {
                heights = [heights[0].min(low), heights[1].max(high)];
            }
            plan.stats.figures_outside += usize::from(!wanted.seen);
            wanted.seen |= !self.culls;
            if wanted.seen || wanted.shades {
                self.see(frame, plan, figure, wanted, &mut seen);
            }
        }
        let count = |way: Way| seen.iter().filter(|it| it.way == way).count();
        plan.stats.figures_by_frame = count(Way::Framed);
        plan.stats.figures_by_vertex = count(Way::Vertex);
        let in_hand = frame
            .view
            .hand
            .iter()
            .flat_map(|hand| hand::instances(frame, hand));
        seen.extend(in_hand.map(|(model, instance)| Seen {
            model: number(model),
            way: if instance.lights == [0; 3] {
                Way::UnlitHand
            } else {
                Way::Hand
            },
            instance,
            joints: None,
            chart: frame.view.eye.point.chart,
            room: None,
        }));
        (seen, heights)
    }

    /// Adds a figure, and what it holds.
    fn see(
        &self,
        frame: &Frame,
        plan: &mut FramePlan,
        figure: &Figure,
        wanted: Wanted,
        seen: &mut Vec<Seen>,
    ) {
        let model = number(figure.model);
        let Loaded { shape: _, rig } = &self.models[model];
        let posed = rig.as_ref().map(|rig| rig.pose(&figure.posture));
        let limits = posed
            .as_ref()
            .map_or(self.statics.ranges[model].limits, |posed| posed.limits);
        put(frame, plan, figure, wanted, model, limits, seen);
        let Some(Posed { joints, hand, .. }) = posed else {
            return;
        };
        if let Some(last) = seen.last_mut() {
            last.joints = Some(joints);
        }
        let Some(held) = figure.held else { return };
        for Held { model, turn, place } in in_hand_of(hand, held, figure.flashes) {
            let place = figure.level.in_chart(figure.turn * place.as_dvec3());
            let figure = Figure {
                turn: figure.turn * turn.as_dquat(),
                level: figure.level,
                cut: figure.cut.map(|cut| cut.from_origin_moved(place)),
                sky: figure.sky,
                ..Figure::standing(model, figure.point.moved(place), 0.0)
            };
            let thing = number(model);
            let limits = self.statics.ranges[thing].limits;
            put(frame, plan, &figure, wanted, thing, limits, seen);
        }
    }
}

/// Adds one instance, whose vertices are within a box about its origin.
fn put(
    frame: &Frame,
    plan: &mut FramePlan,
    figure: &Figure,
    wanted: Wanted,
    model: usize,
    limits: [Vec3; 2],
    seen: &mut Vec<Seen>,
) {
    let [low, high] = turned(limits, figure.turn.as_quat());
    let middle = figure.level.in_chart(low.midpoint(high).as_dvec3());
    let middle = figure.point.moved(middle);
    let half = figure.level.half_box((0.5 * (high - low)).as_dvec3());
    let chart = figure.point.chart;
    let (min, max) = (middle.pos - half, middle.pos + half);
    let mut instance = FigureInstance {
        offset: offset_of(frame, figure.point).as_vec3().into(),
        flags: flags(figure),
        turn: figure.turn.as_quat().to_array(),
        frame: [[0.0; 4]; 4],
        lights: [0; 3],
        cut: figure.cut.as_ref().map_or(WHOLE, packed_cut),
        level: level_row(figure.level),
    };
    let mut way = Way::Shade;
    let throws = wanted.shades && figure.presence == Presence::Real;
    if wanted.seen {
        instance.lights = lights_near(frame, chart, min, max);
        let tolerance_px = Tolerance::of(frame.view.quality).shape_px;
        let bounds = &plan.bounds;
        way = match bounds.object(frame, figure.point, middle, half, tolerance_px) {
            Some((affine, error_px)) => {
                plan.stats.error_at_least(error_px);
                instance.frame = frame_rows(&affine.moved(&frame.view));
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
        chart,
        room: throws.then_some(Caster { chart, min, max }),
    });
}

/// What is switched of a figure; figure.wgsl.
fn flags(figure: &Figure) -> u32 {
    let switches = [
        (figure.hostile, HOSTILE_FLAG),
        (figure.lights, LIGHTS_FLAG),
        (figure.brakes, BRAKES_FLAG),
        (figure.presence == Presence::Possible, POSSIBLE_FLAG),
        (figure.presence == Presence::Barred, BARRED_FLAG),
    ];
    let on = switches.into_iter().filter(|(is_on, _)| *is_on);
    on.fold(dark_bits(figure.sky), |flags, (_, flag)| flags | flag)
}

/// The box of a turned box.
fn turned([low, high]: [Vec3; 2], turn: Quat) -> [Vec3; 2] {
    let axes = Mat3::from_quat(turn);
    let middle = axes * low.midpoint(high);
    let half = 0.5 * (high - low);
    let reach =
        axes.x_axis.abs() * half.x + axes.y_axis.abs() * half.y + axes.z_axis.abs() * half.z;
    [middle - reach, middle + reach]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_turned_box_holds_every_corner() {
        let limits = [Vec3::new(-0.2, 0.0, -0.7), Vec3::new(1.5, 1.8, 0.3)];
        let turn = Quat::from_rotation_y(0.7) * Quat::from_rotation_x(-1.1);
        let [low, high] = turned(limits, turn);
        for corner in 0..8 {
            let pick = |axis: usize| {
                if corner >> axis & 1 == 1 {
                    limits[1][axis]
                } else {
                    limits[0][axis]
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
