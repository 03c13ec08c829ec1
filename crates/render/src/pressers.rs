//! What bends leaves and grass: which of it a picture shows, and on which chunks.

use std::array;

use antipode_frame::{Frame, Presser};
use antipode_geometry::{ChartId, ChartPoint};
use bytemuck::{Pod, Zeroable};
use glam::DVec3;

use crate::charts::offset_of;
use crate::plan::ChunkLand;

/// Those that bend at once; `PRESSERS` of common.wgsl.
pub const PRESSERS: usize = 8;
/// Farther from the eye nobody sees what is bent, metres of the space.
const SEEN_M: f64 = 80.0;

/// `Presser` of common.wgsl. The default presses nothing.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
pub struct PresserUniform {
    pub(crate) place: [f32; 3],
    pub(crate) reach_m: f32,
    pub(crate) along: [f32; 3],
    pub(crate) height_m: f32,
    pub(crate) up: [f32; 3],
    pub(crate) strength: f32,
}

/// What bends leaves and grass in a picture: the nearest to the eye.
#[derive(Clone, Debug, Default)]
pub struct Pressers(Vec<Presser>);

impl Pressers {
    /// Those of a frame.
    pub fn of(frame: &Frame) -> Self {
        let all = &frame.content.pressers;
        if all.is_empty() {
            return Self::default();
        }
        let (space, eye) = (&*frame.view.strategy, &frame.view.eye);
        let view = space.viewer(eye);
        let away_m = |point: ChartPoint| space.eye_distance_m(eye, view(point));
        let mut near: Vec<_> = all.iter().map(|it| (away_m(it.point), *it)).collect();
        near.retain(|(away_m, _)| *away_m < SEEN_M);
        near.sort_by(|(a, _), (b, _)| a.total_cmp(b));
        Self(near.into_iter().map(|(_, it)| it).take(PRESSERS).collect())
    }

    /// All of them as a chart has them; nothing of one that does not come into it.
    fn in_chart(&self, frame: &Frame, chart: ChartId) -> impl Iterator<Item = Option<Presser>> {
        let carried = move |it: &Presser| {
            let carried = frame.view.strategy.carry(it.point, chart);
            carried.map(|crossing| it.carried(&crossing))
        };
        self.0.iter().map(carried)
    }

    /// Which of them may bend what grows on a chunk, a bit for each.
    pub fn on(&self, frame: &Frame, land: &ChunkLand) -> u32 {
        let [low, high] = land.whole;
        let is_near = |it: Presser| {
            let reach_m = it.reach_m + it.along.length();
            let pos: DVec3 = it.point.pos;
            // What grows low is no part of the box; it is no higher than what presses reaches.
            pos.distance(pos.clamp(low, high)) < reach_m
        };
        let bits = self.in_chart(frame, land.coord.chart).enumerate();
        bits.filter(|(_, it)| it.is_some_and(is_near))
            .fold(0, |bits, (place, _)| bits | 1 << place)
    }

    /// As the shaders take them of a chart.
    pub fn uniforms(&self, frame: &Frame, chart: ChartId) -> [PresserUniform; PRESSERS] {
        let mut all = self.in_chart(frame, chart);
        array::from_fn(|_| {
            let it = all.next().flatten();
            it.map_or_else(PresserUniform::default, |it| PresserUniform {
                place: offset_of(frame, it.point).as_vec3().into(),
                reach_m: it.reach_m as f32,
                along: it.along.as_vec3().into(),
                height_m: it.height_m as f32,
                up: it.up.as_vec3().into(),
                strength: it.strength as f32,
            })
        })
    }
}
