//! Chooses the chunks whose edges are halved, and keeps the error of what is drawn of them.
//!
//! A thread makes the refinements, the nearest chunk's first. Two chunks agree on their shared edge if both were
//! refined for the same eyes. So the chunks of one set are shown together, as soon as the last of them is made. Until
//! then the frame draws the earlier ones, or the meshes as they are, and reports their error.
//!
//! A moving eye has left its place before a set for that place is made. So a set is made for all of the way that the
//! eye will cover until the next set can be ready ([`Lead`]). Where the thread does not keep
//! up even so, the frame refines all that it shows itself: late is better than wrong.
//!
//! A chunk that was refined and then changes would be seen to lose its refinement for some frames, so the nearest such
//! chunk is refined on the spot, for the eyes that its neighbours were refined for.

use std::sync::Arc;

use antipode_frame::Frame;
use antipode_geometry::ChunkCoord;
use glam::DVec3;

use crate::chunk_store::ChunkStore;
use crate::land_mesh::LandMesh;
use crate::pages::Pages;
use crate::plan::{Bounds, ChunkLand, FramePlan, RefineKey, RefineRules, Refined, Subdivider};
use crate::subdivision_thread::{Delivery, SubdivisionThread, Task};
use lead::Lead;

mod lead;
mod of_chunk;

/// Chunks that a frame refines on the spot: changed ones, and others where no thread does it.
const ON_THE_SPOT: usize = 1;
/// A refinement made for eyes farther away than this is let go, metres.
const OF_NO_USE_M: f64 = 16.0;
/// An eye farther than this from those that the land is refined for does not wait for the thread, metres.
const LEFT_BEHIND_M: f64 = 3.0;
/// What is out of the picture is refined too where it would otherwise stray by more than this when one turns round,
/// pixels.
const TURNED_TO_PX: f64 = 1.5;

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

/// Chunks that are refined for the same eyes, to be shown together.
#[derive(Debug)]
struct Set {
    rules: Arc<RefineRules>,
    /// Those in the picture first, and the nearest of them before the others.
    coords: Vec<ChunkCoord>,
    /// What the thread has not begun when this is dropped it need not do.
    wanted: Arc<()>,
}

/// What makes refinements.
#[derive(Debug, Default)]
pub struct Refinements {
    /// Of what is shown.
    shown: Option<Arc<RefineRules>>,
    /// What is being made.
    coming: Option<Set>,
    thread: SubdivisionThread,
    lead: Lead,
    /// For what is refined on the spot.
    subdivider: Subdivider,
}

impl Refinements {
    /// Whether some are being made.
    pub fn is_busy(&self) -> bool {
        self.coming.is_some() || self.thread.is_busy()
    }

    /// Forgets what was shown and is being made: the land is another.
    pub fn forget(&mut self) {
        self.shown = None;
        self.coming = None;
    }

    /// Has frames get what the thread makes at another time than as soon as it is made.
    pub fn deliver(&mut self, delivery: Delivery) {
        self.thread.delivery = delivery;
    }

    /// Lets the thread seem to be at its work still, or done with all of it, whatever it has done.
    #[cfg(test)]
    pub fn hold(&mut self, held: bool) {
        self.deliver(if held {
            Delivery::Held
        } else {
            Delivery::Awaited
        });
    }

    /// Whether the eye is past what the land is refined for, and the thread will not make that good in time.
    fn is_left_behind(&self, frame: &Frame) -> bool {
        let shown = self.shown.as_ref();
        shown.is_some_and(|rules| rules.away_m(frame) > LEFT_BEHIND_M)
    }

    /// The eye cannot wait for what is being made: the next is to last longer. What will hold until then is made whole
    /// by the frame, and what will not is let go.
    fn miss(&mut self, frame: &Frame, bounds: &Bounds) {
        let Some(set) = &self.coming else {
            return;
        };
        self.lead.late();
        let next = self.lead.when_made(&frame.view.eye.point);
        if !set.rules.key.holds(frame, bounds, &next) {
            self.coming = None;
        }
    }

    /// The rules of what is shown, if they hold for a frame and until others can be made.
    fn lasting(&self, frame: &Frame, bounds: &Bounds) -> Option<&Arc<RefineRules>> {
        let holds = |rules: &&Arc<RefineRules>| {
            let key = &rules.key;
            key.holds(frame, bounds, &frame.view.eye.point)
                && key.way.covers(&self.lead.when_made(&frame.view.eye.point))
                // An eye that stands does not need what was made for one that walks.
                && (!self.lead.rests() || key.way.is_place())
        };
        self.shown.as_ref().filter(holds)
    }

    /// The rules to refine by now.
    fn rules(&self, frame: &Frame, bounds: &Bounds, rush: bool) -> Arc<RefineRules> {
        // A single picture is the same whatever was shown before.
        let step = if rush { DVec3::ZERO } else { self.lead.way() };
        let key = RefineKey::of(frame, bounds, step);
        match (self.lasting(frame, bounds).filter(|_| !rush), &self.shown) {
            (Some(lasting), _) => Arc::clone(lasting),
            (None, Some(shown)) if shown.key == key => Arc::clone(shown),
            _ => Arc::new(RefineRules::new(frame, bounds, step)),
        }
    }
}

impl ChunkStore {
    /// Brings the refinements of the chosen chunks up to date as far as that can be done, and adds to the plan's
    /// figures what is drawn of them.
    pub fn refine(&mut self, frame: &Frame, land: &[ChunkLand], plan: &mut FramePlan) {
        let has_leapt = self.drop_useless(frame);
        let chosen = plan.chunks.iter().filter(|choice| choice.refine);
        let chosen: Vec<_> = chosen.map(|choice| land[choice.place].coord).collect();
        let eye = &frame.view.eye.point;
        self.refinements.lead.frame(&*frame.view.strategy, eye);
        // First, and always: what nobody waits for any more is not to seem under way for ever.
        self.take_done();
        if chosen.is_empty() && self.refinements.coming.is_none() {
            return;
        }
        let anew = self.rush || has_leapt;
        let left_behind = self.refinements.is_left_behind(frame);
        if left_behind {
            self.refinements.miss(frame, &plan.bounds);
        }
        let at_once = anew || left_behind;
        self.refine_changed(frame, &chosen);
        if anew || self.refinements.coming.is_none() {
            self.begin_set(frame, &plan.bounds, land, &chosen, at_once);
        }
        if self.is_set_complete(frame, at_once) {
            self.show_set(at_once);
        }
        for coord in &chosen {
            let Some(chunk) = self.chunks.get(coord) else {
                continue;
            };
            let error_px = chunk.error_px(frame, &plan.bounds);
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
                && let eyes = rules.eyes_from(frame, &chunk.land)
                && !eyes.is_empty()
            {
                let refined = self
                    .refinements
                    .subdivider
                    .refine(&rules, &eyes, &chunk.source);
                let refinement = Refinement::put(&mut self.pages, Arc::clone(&rules), refined);
                chunk.set_refined(&mut self.pages, refinement);
            }
        }
    }

    /// Begins refinements for the eye of now, and those that it will be, where some are missing.
    fn begin_set(
        &mut self,
        frame: &Frame,
        bounds: &Bounds,
        land: &[ChunkLand],
        chosen: &[ChunkCoord],
        at_once: bool,
    ) {
        let rules = self.refinements.rules(frame, bounds, self.rush);
        let chunk = |coord: &ChunkCoord| self.chunks.get(coord);
        let is_missing = |coord| chunk(coord).is_some_and(|c| !c.is_refined_for(&rules.key));
        if !chosen.iter().any(is_missing) {
            return;
        }
        let mut coords = chosen.to_vec();
        if !at_once {
            let is_near = |chunk: &&ChunkLand| {
                let strays_m = bounds
                    .bend
                    .strays_within_m(chunk.longest_edge_m(), TURNED_TO_PX);
                Bounds::nearest_chart_m(frame, chunk) < strays_m
            };
            let near = land.iter().filter(is_near).map(|chunk| chunk.coord);
            coords.extend(near.filter(|coord| !chosen.contains(coord)));
        }
        self.refinements.coming = Some(Set {
            rules,
            coords,
            wanted: Arc::new(()),
        });
        if !at_once {
            self.refinements.lead.begin();
        }
    }

    /// Takes over what the thread has finished, if its mesh is still the one that is shown.
    fn take_done(&mut self) {
        while let Some((task, refined)) = self.refinements.thread.take() {
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
    fn is_set_complete(&mut self, frame: &Frame, at_once: bool) -> bool {
        let Refinements {
            coming:
                Some(Set {
                    rules,
                    coords,
                    wanted,
                }),
            thread,
            subdivider,
            ..
        } = &mut self.refinements
        else {
            return false;
        };
        let mut on_the_spot = match (at_once, thread.has_failed()) {
            (true, _) => usize::MAX,
            (false, true) => ON_THE_SPOT,
            (false, false) => 0,
        };
        let mut is_complete = true;
        for coord in coords {
            let Some(chunk) = self.chunks.get_mut(coord) else {
                continue;
            };
            if chunk.is_ready_for(&rules.key) {
                continue;
            }
            let eyes = rules.eyes_from(frame, &chunk.land);
            if eyes.is_empty() {
                continue;
            }
            if on_the_spot > 0 {
                on_the_spot -= 1;
                let refined = subdivider.refine(rules, &eyes, &chunk.source);
                let refinement = Refinement::put(&mut self.pages, Arc::clone(rules), refined);
                chunk.set_coming(&mut self.pages, refinement);
                continue;
            }
            is_complete = false;
            thread.start(Task {
                coord: *coord,
                source: Arc::clone(&chunk.source),
                rules: Arc::clone(rules),
                eyes,
                wanted: Arc::downgrade(wanted),
            });
        }
        is_complete
    }

    /// Shows what was made for the same eyes, all at once.
    fn show_set(&mut self, at_once: bool) {
        if let Some(set) = self.refinements.coming.take() {
            // What the frame made tells nothing of the thread.
            if !at_once {
                self.refinements.lead.end();
            }
            for chunk in self.chunks.values_mut() {
                chunk.turn_to(&mut self.pages, &set.rules.key);
            }
            self.refinements.shown = Some(set.rules);
        }
    }

    /// Lets go of refinements that were left behind; whether what was shown is among them.
    fn drop_useless(&mut self, frame: &Frame) -> bool {
        let is_useless = |rules: &RefineRules| rules.away_m(frame) > OF_NO_USE_M;
        self.refinements
            .coming
            .take_if(|set| is_useless(&set.rules));
        let has_leapt = self
            .refinements
            .shown
            .take_if(|rules| is_useless(rules))
            .is_some();
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
        has_leapt
    }
}

#[cfg(test)]
mod tests;
