//! Which chunks have their edges halved, and how far off what is drawn of them is.
//!
//! A thread makes the refinements, the nearest chunk's first. Until one comes, the last one is drawn, or the mesh as
//! it is, and the error that is told is theirs. A chunk that was refined and then changes would be seen to lose
//! its refinement for some frames, so the nearest such chunk is refined on the spot.

use std::sync::Arc;

use antipode_scene::frame::Frame;

use crate::chunk_store::{ChunkStore, GpuChunk};
use crate::land_mesh::LandMesh;
use crate::pages::Pages;
use crate::plan::{
    Bounds, ChunkLand, FramePlan, Halver, RefineKey, RefineRules, Refined, unhalved_error_px,
};
use crate::refinery::{Refinery, Task};

/// Chunks that a frame refines on the spot: changed ones, and others where no thread does it.
const ON_THE_SPOT: usize = 1;
/// Refinements that the thread made and a frame takes over: each is a megabyte to be sent.
const TAKEN_PER_FRAME: usize = 1;
/// A refinement made for an eye farther away than this is let go, metres.
const OF_NO_USE_M: f64 = 16.0;

/// A mesh with edges halved near the eye.
#[derive(Debug)]
pub struct Refinement {
    /// Nothing where no edge needed it.
    pub mesh: Option<LandMesh>,
    rules: Arc<RefineRules>,
    /// The largest stray of an edge when it was made, pixels.
    error_px: f64,
}

/// What makes refinements.
#[derive(Debug, Default)]
pub struct Refinements {
    rules: Option<Arc<RefineRules>>,
    refinery: Refinery,
    /// For what is refined on the spot.
    halver: Halver,
}

impl Refinements {
    /// Whether a thread is at work on one.
    pub fn is_busy(&self) -> bool {
        self.refinery.is_busy()
    }

    /// The rules of a frame; the last frame's, where they are the same.
    fn rules(&mut self, frame: &Frame, bounds: &Bounds) -> Arc<RefineRules> {
        let key = RefineKey::of(frame, bounds);
        match &self.rules {
            Some(rules) if rules.key == key => Arc::clone(rules),
            _ => Arc::clone(self.rules.insert(Arc::new(RefineRules::new(frame, bounds)))),
        }
    }
}

impl GpuChunk {
    fn is_refined_for(&self, key: &RefineKey) -> bool {
        self.refined.as_ref().is_some_and(|r| r.rules.key == *key)
    }

    fn set_refined(&mut self, pages: &mut Pages, rules: Arc<RefineRules>, refined: Refined) {
        self.drop_refined(pages);
        self.is_urgent = false;
        self.refined = Some(Refinement {
            mesh: (refined.halved > 0).then(|| LandMesh::put(pages, refined.parts)),
            rules,
            error_px: refined.error_px,
        });
    }

    fn drop_refined(&mut self, pages: &mut Pages) {
        if let Some(mesh) = self.refined.take().and_then(|refined| refined.mesh) {
            mesh.give_back(pages);
        }
    }

    /// The most that its edges stray in a frame as it is drawn, pixels.
    fn error_px(&self, frame: &Frame, bounds: &Bounds, key: &RefineKey) -> f64 {
        match &self.refined {
            None => unhalved_error_px(frame, bounds, &self.land),
            Some(refined) if refined.rules.key == *key => refined.error_px,
            Some(Refinement {
                rules, error_px, ..
            }) => rules.stale_error_px(*error_px, frame, bounds, &self.land),
        }
    }
}

impl ChunkStore {
    /// Brings the refinements of the chosen chunks up to date as far as that can be done, and adds to the plan's
    /// figures what is drawn of them.
    pub fn refine(&mut self, frame: &Frame, land: &[ChunkLand], plan: &mut FramePlan) {
        self.drop_useless(frame);
        if !plan.chunks.iter().any(|choice| choice.refine) {
            return;
        }
        let rules = self.refinements.rules(frame, &plan.bounds);
        self.take_done(&rules.key);
        let mut on_the_spot = if self.rush { usize::MAX } else { ON_THE_SPOT };
        for choice in &plan.chunks {
            let coord = land[choice.place].coord;
            let Some(chunk) = self.chunks.get_mut(&coord) else {
                continue;
            };
            if !choice.refine {
                chunk.drop_refined(&mut self.pages);
                chunk.is_urgent = false;
                continue;
            }
            let Refinements {
                refinery, halver, ..
            } = &mut self.refinements;
            if !chunk.is_refined_for(&rules.key)
                && let Some(eye) = rules.eye_from(frame, &chunk.land)
            {
                let must = self.rush || chunk.is_urgent || refinery.has_failed();
                if must && on_the_spot > 0 {
                    on_the_spot -= 1;
                    let refined = halver.refine(&rules, eye, &chunk.source);
                    chunk.set_refined(&mut self.pages, Arc::clone(&rules), refined);
                } else if refinery.has_room() {
                    refinery.start(Task {
                        coord,
                        source: Arc::clone(&chunk.source),
                        rules: Arc::clone(&rules),
                        eye,
                    });
                }
            }
            let error_px = chunk.error_px(frame, &plan.bounds, &rules.key);
            plan.stats.error_at_least(error_px);
            if let Some(mesh) = chunk.refined.as_ref().and_then(|r| r.mesh.as_ref()) {
                plan.stats.chunks_refined += 1;
                plan.stats.triangles_added += mesh.triangles().saturating_sub(chunk.land.triangles);
            }
        }
    }

    /// Takes over what the thread has finished, if its mesh is still the one that is shown.
    fn take_done(&mut self, key: &RefineKey) {
        for _ in 0..TAKEN_PER_FRAME {
            let Some((task, refined)) = self.refinements.refinery.take() else {
                return;
            };
            if let Some(chunk) = self.chunks.get_mut(&task.coord)
                && Arc::ptr_eq(&chunk.source, &task.source)
                && !chunk.is_refined_for(key)
            {
                chunk.set_refined(&mut self.pages, task.rules, refined);
            }
        }
    }

    /// Lets go of refinements that were left behind.
    fn drop_useless(&mut self, frame: &Frame) {
        for chunk in self.chunks.values_mut() {
            let is_useless =
                |refined: &Refinement| refined.rules.key.away_m(&frame.eye.point) > OF_NO_USE_M;
            if chunk.refined.as_ref().is_some_and(is_useless) {
                chunk.drop_refined(&mut self.pages);
            }
        }
    }
}
