//! Which chunks have their edges halved, and how far off what is drawn of them is.
//!
//! A thread makes the refinements, the nearest chunk's first. Two chunks agree on the edge they share if both were
//! refined for the same eye, so those of one eye are shown together, when the last of them has come; until then those
//! of the eye before are drawn, or the meshes as they are, and the error that is told is theirs. A chunk that was
//! refined and then changes would be seen to lose its refinement for some frames, so the nearest such chunk is refined
//! on the spot, for the eye that its neighbours were refined for.

use std::sync::Arc;

use antipode_geometry::ChunkCoord;
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
const TAKEN_PER_FRAME: usize = 2;
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

impl Refinement {
    fn put(pages: &mut Pages, rules: Arc<RefineRules>, refined: Refined) -> Self {
        Self {
            mesh: (refined.halved > 0).then(|| LandMesh::put(pages, refined.parts)),
            rules,
            error_px: refined.error_px,
        }
    }

    /// Frees its place.
    pub fn give_back(self, pages: &mut Pages) {
        if let Some(mesh) = self.mesh {
            mesh.give_back(pages);
        }
    }
}

/// Chunks that are refined for one eye, to be shown together.
#[derive(Debug)]
struct Set {
    rules: Arc<RefineRules>,
    /// The nearest first.
    coords: Vec<ChunkCoord>,
}

/// What makes refinements.
#[derive(Debug, Default)]
pub struct Refinements {
    /// Of the last frame.
    rules: Option<Arc<RefineRules>>,
    /// Of what is shown.
    shown: Option<Arc<RefineRules>>,
    /// What is being made.
    coming: Option<Set>,
    refinery: Refinery,
    /// For what is refined on the spot.
    halver: Halver,
}

impl Refinements {
    /// Whether some are being made.
    pub fn is_busy(&self) -> bool {
        self.coming.is_some() || self.refinery.is_busy()
    }

    /// Forgets what was shown and is being made: the land is another.
    pub fn forget(&mut self) {
        self.shown = None;
        self.coming = None;
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

    /// Whether it has a refinement for an eye, shown or not.
    fn is_ready_for(&self, key: &RefineKey) -> bool {
        let comes = self.coming.as_ref().is_some_and(|r| r.rules.key == *key);
        comes || self.is_refined_for(key)
    }

    fn set_refined(&mut self, pages: &mut Pages, refinement: Refinement) {
        self.drop_refined(pages);
        self.is_urgent = false;
        self.refined = Some(refinement);
    }

    fn set_coming(&mut self, pages: &mut Pages, refinement: Refinement) {
        if let Some(before) = self.coming.replace(refinement) {
            before.give_back(pages);
        }
    }

    /// Shows what has come for an eye; lets go of all that was made for another.
    fn turn_to(&mut self, pages: &mut Pages, key: &RefineKey) {
        if let Some(coming) = self.coming.take() {
            if coming.rules.key == *key {
                self.set_refined(pages, coming);
            } else {
                coming.give_back(pages);
            }
        }
        if !self.is_refined_for(key) {
            self.drop_refined(pages);
            self.is_urgent = false;
        }
    }

    fn drop_refined(&mut self, pages: &mut Pages) {
        if let Some(refined) = self.refined.take() {
            refined.give_back(pages);
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
        let chosen = plan.chunks.iter().filter(|choice| choice.refine);
        let chosen: Vec<_> = chosen.map(|choice| land[choice.place].coord).collect();
        if chosen.is_empty() && self.refinements.coming.is_none() {
            return;
        }
        let rules = self.refinements.rules(frame, &plan.bounds);
        self.refine_changed(frame, &chosen);
        self.begin_set(&chosen, &rules);
        self.take_done();
        if self.is_set_complete(frame) {
            self.show_set();
        }
        for coord in &chosen {
            let Some(chunk) = self.chunks.get(coord) else {
                continue;
            };
            let error_px = chunk.error_px(frame, &plan.bounds, &rules.key);
            plan.stats.error_at_least(error_px);
            if let Some(mesh) = chunk.refined.as_ref().and_then(|r| r.mesh.as_ref()) {
                plan.stats.chunks_refined += 1;
                plan.stats.triangles_added += mesh.triangles().saturating_sub(chunk.land.triangles);
            }
        }
    }

    /// Refines a chunk that has changed for the eye that those beside it were refined for.
    fn refine_changed(&mut self, frame: &Frame, chosen: &[ChunkCoord]) {
        let Some(rules) = self.refinements.shown.clone() else {
            return;
        };
        let is_urgent = |coord: &&ChunkCoord| self.chunks.get(coord).is_some_and(|c| c.is_urgent);
        let urgent: Vec<_> = chosen.iter().filter(is_urgent).take(ON_THE_SPOT).collect();
        for coord in urgent {
            if let Some(chunk) = self.chunks.get_mut(coord)
                && let Some(eye) = rules.eye_from(frame, &chunk.land)
            {
                let refined = self.refinements.halver.refine(&rules, eye, &chunk.source);
                let refinement = Refinement::put(&mut self.pages, Arc::clone(&rules), refined);
                chunk.set_refined(&mut self.pages, refinement);
            }
        }
    }

    /// Begins refinements for the eye of now where some are missing and none are being made. A frame that is to be
    /// complete begins anew.
    fn begin_set(&mut self, chosen: &[ChunkCoord], rules: &Arc<RefineRules>) {
        let chunk = |coord: &ChunkCoord| self.chunks.get(coord);
        let is_missing = |coord| chunk(coord).is_some_and(|c| !c.is_refined_for(&rules.key));
        if (self.rush || self.refinements.coming.is_none()) && chosen.iter().any(is_missing) {
            self.refinements.coming = Some(Set {
                rules: Arc::clone(rules),
                coords: chosen.to_vec(),
            });
        }
    }

    /// Takes over what the thread has finished, if its mesh is still the one that is shown.
    fn take_done(&mut self) {
        for _ in 0..TAKEN_PER_FRAME {
            let Some((task, refined)) = self.refinements.refinery.take() else {
                return;
            };
            let set = self.refinements.coming.as_ref();
            if set.is_some_and(|set| set.rules.key == task.rules.key)
                && let Some(chunk) = self.chunks.get_mut(&task.coord)
                && Arc::ptr_eq(&chunk.source, &task.source)
            {
                let refinement = Refinement::put(&mut self.pages, task.rules, refined);
                chunk.set_coming(&mut self.pages, refinement);
            }
        }
    }

    /// Goes on with what is being made; whether nothing of it is missing.
    fn is_set_complete(&mut self, frame: &Frame) -> bool {
        let Refinements {
            coming: Some(Set { rules, coords }),
            refinery,
            halver,
            ..
        } = &mut self.refinements
        else {
            return false;
        };
        let mut on_the_spot = match (self.rush, refinery.has_failed()) {
            (true, _) => usize::MAX,
            (false, true) => ON_THE_SPOT,
            (false, false) => 0,
        };
        let mut is_complete = true;
        for coord in coords {
            let Some(chunk) = self.chunks.get_mut(coord) else {
                continue;
            };
            let Some(eye) = rules
                .eye_from(frame, &chunk.land)
                .filter(|_| !chunk.is_ready_for(&rules.key))
            else {
                continue;
            };
            if on_the_spot > 0 {
                on_the_spot -= 1;
                let refined = halver.refine(rules, eye, &chunk.source);
                let refinement = Refinement::put(&mut self.pages, Arc::clone(rules), refined);
                chunk.set_coming(&mut self.pages, refinement);
                continue;
            }
            is_complete = false;
            if refinery.has_room() {
                refinery.start(Task {
                    coord: *coord,
                    source: Arc::clone(&chunk.source),
                    rules: Arc::clone(rules),
                    eye,
                });
            }
        }
        is_complete
    }

    /// Shows what was made for one eye, all at once.
    fn show_set(&mut self) {
        if let Some(set) = self.refinements.coming.take() {
            for chunk in self.chunks.values_mut() {
                chunk.turn_to(&mut self.pages, &set.rules.key);
            }
            self.refinements.shown = Some(set.rules);
        }
    }

    /// Lets go of refinements that were left behind.
    fn drop_useless(&mut self, frame: &Frame) {
        let is_useless = |rules: &RefineRules| rules.key.away_m(&frame.eye.point) > OF_NO_USE_M;
        self.refinements
            .coming
            .take_if(|set| is_useless(&set.rules));
        self.refinements.shown.take_if(|rules| is_useless(rules));
        for chunk in self.chunks.values_mut() {
            if chunk
                .refined
                .as_ref()
                .is_some_and(|it| is_useless(&it.rules))
            {
                chunk.drop_refined(&mut self.pages);
            }
            if let Some(coming) = chunk.coming.take_if(|it| is_useless(&it.rules)) {
                coming.give_back(&mut self.pages);
            }
        }
    }
}
