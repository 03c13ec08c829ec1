//! Maps that are drawn anew, some triangles each frame.

use antipode_frame::Frame;
use antipode_geometry::ChunkCoord;

use super::caster::Caster;
use super::levels::{MapNumber, Shot, wanted};
use super::light::{Light, Rectangle};
use super::uniform::{CasterUniform, own_base};
use super::{MapTarget, Over, Pass, SLOTS, ShadowSources, Shadows};
use crate::chunk_store::ChunkStore;

/// The slot that a map is made in.
pub(super) fn slot_of(level: usize) -> usize {
    level.min(SLOTS - 1)
}

/// A map in the making.
#[derive(Debug)]
pub(super) struct Job {
    /// The level it is for.
    pub level: usize,
    /// What it is to be.
    pub shot: Shot,
    /// Chunks that are still to be drawn.
    todo: Vec<ChunkCoord>,
    begun: bool,
    /// Whether other ground on it has changed.
    pub changed: bool,
    /// What of it shows ground as it was before an edit.
    pub hole: Option<Rectangle>,
}

impl Shadows {
    /// Goes on with what is in the making, and begins what is due, by at most `left` triangles.
    pub(super) fn make(
        &mut self,
        frame: &Frame,
        light: &Light,
        land: &mut ShadowSources<'_>,
        left: usize,
    ) {
        let mut left = left;
        for slot in 0..SLOTS {
            while left > 0 && self.has_pass() {
                let begun = self.jobs[slot].take();
                let Some(job) = begun.or_else(|| self.next_job(slot, frame, light, land.chunks))
                else {
                    break;
                };
                left = self.advance(job, frame, land, left);
            }
        }
        self.busy = left == 0 || self.jobs.iter().any(Option::is_some);
    }

    /// Whether this frame has room for another pass over land.
    pub(super) fn has_pass(&self) -> bool {
        self.passes.len() < self.lists.len()
    }

    /// Takes note of land that came or went on a level, to be drawn when there is time.
    pub(super) fn note(&mut self, number: usize, frame: &Frame, of: &Caster) {
        self.levels[number].note(frame, of);
        for job in self.jobs.iter_mut().flatten() {
            let (light, crop) = (&job.shot.light, &job.shot.crop);
            job.changed |=
                job.level == number && light.heights(&*frame.view.strategy, crop, of).is_some();
        }
    }

    /// The map of a slot that most needs to be drawn anew, if any does.
    fn next_job(
        &self,
        slot: usize,
        frame: &Frame,
        light: &Light,
        chunks: &ChunkStore,
    ) -> Option<Job> {
        let texels = self.maps.texels;
        let own = self
            .levels
            .iter()
            .enumerate()
            .filter(|(i, _)| slot_of(*i) == slot);
        let due = own.filter_map(|(i, level)| {
            let map = MapNumber {
                level: i,
                of: self.levels.len(),
            };
            let crop = wanted(map, frame, light, texels);
            let staleness = if !chunks.rush {
                level.staleness(map, frame, light, &crop, texels)
            } else if level.is_exact(light, &crop) {
                0.0
            } else {
                f64::INFINITY
            };
            (staleness > 1.0).then_some((staleness, i, crop))
        });
        let (_, level, crop) = due.reduce(|a, b| if b.0 > a.0 { b } else { a })?;
        let mut heights = [f64::INFINITY, f64::NEG_INFINITY];
        let mut todo = Vec::new();
        for (coord, caster) in chunks.casters() {
            if let Some([low, high]) = light.heights(&*frame.view.strategy, &crop, &caster) {
                heights = [heights[0].min(low), heights[1].max(high)];
                todo.push(coord);
            }
        }
        if todo.is_empty() {
            heights = [0.0, 1.0];
        }
        Some(Job {
            level,
            shot: Shot {
                light: *light,
                crop,
                heights,
            },
            todo,
            begun: false,
            changed: false,
            hole: None,
        })
    }

    /// Goes on with a map, by a pass over at most `left` triangles; returns what is left of them.
    fn advance(
        &mut self,
        mut job: Job,
        frame: &Frame,
        land: &mut ShadowSources<'_>,
        mut left: usize,
    ) -> usize {
        let (shot, slot) = (job.shot, slot_of(job.level));
        let target = MapTarget {
            shot: &shot,
            layer: self.spares[slot],
        };
        if !job.todo.is_empty() || !job.begun {
            let over = if job.begun { Over::Map } else { Over::Nothing };
            let used = self.pass(frame, target, over, land, &mut job.todo, left);
            job.begun = true;
            left = left.saturating_sub(used.max(1));
        }
        if job.todo.is_empty()
            && self.has_pass()
            && let Some(hole) = job.hole.take()
        {
            let used = self.fill(frame, land, target, hole);
            left = left.saturating_sub(used);
        }
        if job.todo.is_empty() && job.hole.is_none() {
            let level = &mut self.levels[job.level];
            std::mem::swap(&mut level.layer, &mut self.spares[slot]);
            level.shot = Some(job.shot);
            level.changed = job.changed.then_some(0);
            level.is_mended = false;
        } else {
            self.jobs[slot] = Some(job);
        }
        left
    }

    /// Plans a pass into a layer, of chunks from the end of a list, over at most `left` triangles but for one mesh;
    /// returns how many.
    pub(super) fn pass(
        &mut self,
        frame: &Frame,
        target: MapTarget<'_>,
        over: Over,
        land: &mut ShadowSources<'_>,
        todo: &mut Vec<ChunkCoord>,
        left: usize,
    ) -> usize {
        let MapTarget { shot, layer } = target;
        let number = self.passes.len();
        let (list, draws) = &mut self.lists[number];
        list.clear();
        let mut used = 0;
        while used < left
            && let Some(coord) = todo.pop()
        {
            let strategy = &*frame.view.strategy;
            let origin = shot.light.origin(strategy, &frame.view.eye, coord.chart);
            let Some(from) = origin else {
                continue;
            };
            let chart = land.charts.number(coord.chart);
            used += land.chunks.list_caster(strategy, coord, chart, from, list);
        }
        draws.send(&self.queue, list);
        let uniform = CasterUniform::new(shot, own_base(frame, &shot.light));
        self.maps.write(&self.queue, number, &uniform);
        self.passes.push(Pass { layer, over });
        used
    }
}
