//! The handle through which the game uses this crate.

use std::collections::{BTreeSet, HashSet, VecDeque};
use std::fmt;
use std::sync::Arc;
use std::time::{Duration, Instant};

use antipode_geometry::{Atlas, ChunkCoord, Strategy};
use antipode_storage::{RecordChanges, WorldMeta, WorldStore};
use antipode_terrain::{Field, Stock, Stroke, Thing};

use crate::api::{Cause, Config, StreamingError, Update, Wish};
use crate::bases::Bases;
use crate::batch_job::{EditBatch, Job};
use crate::edit_backend::{EditBackend, coord_of};
use crate::edit_store::Column;
use crate::edit_store::{EditMap, EditStore};
use crate::gathered::Gathered;
use crate::outcome::{Edited, Loaded, Outcome};
use crate::saver::{Parts, Unsaved};
use crate::scheduler::{ChunkScheduler, Verdict};
use crate::shared::{Shared, Watch};
use crate::strokes::{Mark, Strokes, ThingChange, Work};
use crate::updates::{coords, game_cost, is_solid, softened};
use crate::worker_pool::WorkerPool;
use presses::Pressed;

mod presses;
mod questions;
mod stock;

/// Loads, edits and saves chunks in the background. See the crate's documentation.
pub struct Streamer {
    strategy: Arc<dyn Strategy>,
    pub(crate) worker_pool: WorkerPool,
    pub(crate) scheduler: ChunkScheduler,
    pub(crate) strokes: Strokes,
    pub(crate) gathered: Gathered,
    pub(crate) batch_in_flight: bool,
    /// The last presses that have changed anything.
    presses: VecDeque<Pressed>,
    /// Meshes that an earlier batch could not make.
    overdue: HashSet<ChunkCoord>,
    /// Loads that include a batch not shown yet.
    held: Vec<Loaded>,
    pub(crate) saves: Saves,
    /// Updates that arose outside `poll`.
    ready: VecDeque<Update>,
    /// Chunks that no body is near any more: told one at a time, since taking colliders away costs
    /// the game as much as a frame's other work.
    leaving: VecDeque<ChunkCoord>,
}

/// Where saving stands.
#[derive(Default)]
pub(crate) struct Saves {
    /// What the batches have changed since a save last took it. Their workers hand it over: to look for it in the edit store
    /// is to wait for whoever reads that, or for luck.
    land: EditMap,
    /// Asked for; strokes made before are not all in the edit store yet. A save holds the land of its own moment: every
    /// stroke before its mark, and none after. The last gives way to a newer one, the first does not, so that one
    /// comes to its end however much is dug.
    asked: VecDeque<((Mark, Stock), Parts)>,
    /// With its land, waiting for the saver.
    whole: Option<Parts>,
    pub(crate) in_flight: bool,
    /// Not on disk because the commit failed; tried again with the next save.
    unsaved: Parts,
    /// Why the last commit failed.
    pub(crate) last_failure: Option<Cause>,
    /// Was anything changed since the last save was asked for?
    stale: bool,
}

impl fmt::Debug for Streamer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Streamer")
            .field("pending", &self.pending())
            .field("resident", &self.resident_count())
            .field("edited", &self.edited_count())
            .finish_non_exhaustive()
    }
}

impl Streamer {
    /// Starts the workers and the saver. Without a `store` edits live only as long as the streamer.
    ///
    /// # Errors
    /// If the store's list of edited chunks cannot be read or the system refuses a thread.
    pub fn start(
        field: Arc<Field>,
        strategy: Arc<dyn Strategy>,
        store: Option<Arc<WorldStore>>,
        config: Config,
    ) -> Result<Self, StreamingError> {
        let backend = store.map(|store| store as Arc<dyn EditBackend>);
        Self::start_watched(field, strategy, backend, config, None)
    }

    /// As [`start`](Self::start), with any backend and a test's look into the workers.
    pub(crate) fn start_watched(
        field: Arc<Field>,
        strategy: Arc<dyn Strategy>,
        backend: Option<Arc<dyn EditBackend>>,
        config: Config,
        watch: Option<Watch>,
    ) -> Result<Self, StreamingError> {
        let keys = backend
            .as_ref()
            .map_or(Ok(Vec::new()), |backend| backend.edited())
            .map_err(StreamingError::Store)?;
        let coords = keys.iter().map(coord_of);
        let edited: HashSet<_> = coords
            .filter(|coord| strategy.has_chart(coord.chart))
            .collect();
        let mut ready = VecDeque::new();
        if edited.len() < keys.len() {
            let strange = keys.len() - edited.len();
            ready.push_back(Update::Problem(format!(
                "{strange} stored changes of the terrain belong to no place in this world and are not shown."
            )));
        }
        let charts = Arc::<dyn Strategy>::clone(&strategy);
        let scheduler = ChunkScheduler::new(
            Arc::clone(&field),
            charts as Arc<dyn Atlas>,
            edited.iter().copied().collect(),
        );
        let shared = Shared::new(
            field,
            Arc::clone(&strategy),
            EditStore::new(backend, edited),
            Bases::new(config.kept_samples),
            watch,
        );
        let worker_pool =
            WorkerPool::start(Arc::new(shared), config.workers).map_err(StreamingError::Threads)?;
        Ok(Self {
            strategy,
            worker_pool,
            scheduler,
            strokes: Strokes::default(),
            gathered: Gathered::default(),
            batch_in_flight: false,
            presses: VecDeque::new(),
            overdue: HashSet::new(),
            held: Vec::new(),
            saves: Saves::default(),
            ready,
            leaving: VecDeque::new(),
        })
    }

    /// Says what the player needs now. Cheap: call it every frame. Loads that are no longer in
    /// range and not begun are dropped, chunks more than one beyond the range are unloaded once the
    /// plan has been made anew.
    pub fn wish(&mut self, wish: &Wish) {
        let left = self.scheduler.wish(wish);
        self.leaving.extend(left);
        self.feed();
    }

    /// Applies a brush stroke. Never waits: while a batch is under way strokes add up for the next.
    pub fn edit(&mut self, stroke: Stroke) {
        self.edit_in(None, stroke);
    }

    /// Fells the thing of a slot ([`antipode_terrain::Thing::slot`]) on a chunk: it stands there no more. Whoever calls this
    /// keeps it for the next visit; see [`Streamer::remember_felled`].
    pub fn fell(&mut self, coord: ChunkCoord, slot: u8) {
        self.strokes.change(coord, ThingChange::Felled(slot));
        self.feed();
    }

    /// Has a thing stand on a chunk, in place of what stood in its slot, which is one of those for what somebody planted.
    /// Whoever calls this keeps it for the next visit; see [`Streamer::remember_planted`].
    pub fn plant(&mut self, coord: ChunkCoord, thing: Thing) {
        self.strokes.change(coord, ThingChange::Planted(thing));
        self.feed();
    }

    /// Leaves nothing of what somebody planted in a slot of a chunk.
    pub fn uproot(&mut self, coord: ChunkCoord, slot: u8) {
        self.strokes.change(coord, ThingChange::Gone(slot));
        self.feed();
    }

    /// Takes over what was felled in earlier visits of a column of chunks, a bit for each slot; before the first wish.
    pub fn remember_felled(&self, column: Column, slots: u128) {
        self.worker_pool.remember_felled(column, slots);
    }

    /// Takes over what was planted on a chunk in earlier visits, or has grown where no land is there to show it.
    pub fn remember_planted(&self, coord: ChunkCoord, thing: Thing) {
        self.worker_pool.remember_planted(coord, thing);
    }

    /// Saves the given parts and every stroke made so far, and none that comes later, in one commit on the saver's
    /// thread, as soon as the strokes are in the edit store; [`Update::Saved`] or [`Update::SaveFailed`] tells the end. Parts that could not be saved are
    /// tried again with the next save unless that brings newer ones.
    pub fn save(&mut self, meta: Option<WorldMeta>, records: RecordChanges) {
        let parts = Parts {
            meta,
            records,
            ..Parts::default()
        };
        let older = if self.saves.asked.len() > 1 {
            self.saves.asked.pop_back()
        } else {
            None
        };
        let parts = parts.or(older.map_or_else(Parts::default, |(_, parts)| parts));
        let moment = (self.strokes.mark(), self.gathered.spent);
        self.saves.asked.push_back((moment, parts));
        self.saves.stale = false;
        self.feed();
    }

    /// Takes finished work until about `budget` is spent, counting what the game itself will spend
    /// on each mesh; at least one result if there is any. A batch is always delivered whole. Ground
    /// that is shown becomes solid, or ceases to be, one chunk at a time.
    pub fn poll(&mut self, budget: Duration) -> Vec<Update> {
        let started = Instant::now();
        let mut updates = Vec::from(std::mem::take(&mut self.ready));
        let mut spent = Duration::ZERO;
        while let Ok(outcome) = self.worker_pool.results().try_recv() {
            let before = updates.len();
            self.take(outcome, &mut updates);
            spent += updates[before..].iter().map(game_cost).sum::<Duration>();
            self.feed();
            if started.elapsed() + spent >= budget || updates[before..].iter().any(is_solid) {
                break;
            }
        }
        updates.extend(
            self.scheduler
                .settle_some()
                .into_iter()
                .map(Update::Unloaded),
        );
        self.feed();
        self.settle_leaving(&updates);
        if !updates.iter().any(is_solid) {
            updates.extend(self.leaving.pop_front().map(softened));
        }
        updates
    }

    /// What an update tells anew of a chunk stands, and no longer what was to be told before.
    fn settle_leaving(&mut self, updates: &[Update]) {
        if self.leaving.is_empty() {
            return;
        }
        let told: HashSet<ChunkCoord> = updates.iter().flat_map(coords).collect();
        self.leaving.retain(|coord| !told.contains(coord));
    }

    /// Has a worker drop what the game needs no more: samples, colliders, meshes. Freeing them takes
    /// longer than a frame should.
    pub fn discard(&self, thing: impl Send + 'static) {
        self.worker_pool.discard(Box::new(thing));
    }

    #[cfg(test)]
    pub(crate) fn held_loads(&self) -> usize {
        self.held.len()
    }

    pub(crate) fn is_editing(&self) -> bool {
        self.batch_in_flight || !self.strokes.is_empty()
    }

    pub(crate) fn take_ready(&mut self) -> Vec<Update> {
        let mut ready = Vec::from(std::mem::take(&mut self.ready));
        self.settle_leaving(&ready);
        ready.extend(self.leaving.drain(..).map(softened));
        ready
    }

    /// Keeps updates for the next [`poll`](Self::poll) or [`wait`](Self::wait).
    pub(crate) fn keep_ready(&mut self, updates: Vec<Update>) {
        self.ready.extend(updates);
    }

    /// Hands over whatever there is room for: the batch first.
    pub(crate) fn feed(&mut self) {
        self.gather_saves();
        if !self.batch_in_flight && !self.strokes.is_empty() {
            self.feed_batch();
        }
        if let Some(request) = self.scheduler.next_plan()
            && !self.worker_pool.plan(request)
        {
            self.scheduler.plan_not_made();
        }
        while let Some(make) = self.scheduler.next_load(self.worker_pool.most_loads()) {
            if !self.worker_pool.load(make) {
                self.scheduler.not_sent(make.coord);
                break;
            }
        }
        if !self.saves.in_flight
            && let Some(whole) = self.saves.whole.take()
        {
            let parts = whole.or(std::mem::take(&mut self.saves.unsaved));
            match self.worker_pool.save(Box::new(parts)) {
                Ok(()) => self.saves.in_flight = true,
                Err(parts) => self.saves.whole = Some(*parts),
            }
        }
    }

    /// Takes the land for the saves whose moment the edit store has come to; before the next batch changes it.
    fn gather_saves(&mut self) {
        while !self.batch_in_flight
            && let Some(((mark, _), _)) = self.saves.asked.front()
            && self.strokes.has_passed(*mark)
            && let Some(((_, spent), mut parts)) = self.saves.asked.pop_front()
        {
            parts.records.extend(self.gathered.record(&spent));
            let land = std::mem::take(&mut self.saves.land);
            let older = self.saves.whole.take().unwrap_or_default();
            self.saves.whole = Some(Parts { land, ..parts }.or(older));
        }
    }

    fn feed_batch(&mut self) {
        let until = self.saves.asked.front().map(|((mark, _), _)| *mark);
        let Some(work) = self.strokes.take(until) else {
            return;
        };
        let mut coords: BTreeSet<_> = self.overdue.iter().copied().collect();
        let job = match work {
            Work::Strokes(strokes, press) => {
                for stroke in &strokes {
                    coords.extend(stroke.remeshed(&*self.strategy));
                }
                let bordering = self.bordering(Some(&strokes), &coords);
                coords.extend(bordering);
                Job::Strokes(strokes, press)
            }
            Work::Thing(coord, change) => {
                coords.insert(coord);
                Job::Thing(coord, change)
            }
            Work::Undo => match self.last_press() {
                Ok(last) => {
                    let (number, reach) = (last.number, last.remeshed.clone());
                    coords.extend(&reach);
                    let bordering = self.bordering(None, &coords);
                    coords.extend(bordering);
                    Job::Undo(number, reach)
                }
                Err(why) => {
                    self.ready.push_back(Update::Undone(Err(why)));
                    return;
                }
            },
        };
        let batch = EditBatch {
            job,
            stock: self.gathered.stock.map(Box::new),
            overdue: self.overdue.iter().copied().collect(),
            makes: self.scheduler.begin_batch(coords.into_iter()),
        };
        match self.worker_pool.edit(batch) {
            Ok(()) => self.batch_in_flight = true,
            Err(batch) => {
                self.strokes.put_back(match batch.job {
                    Job::Strokes(strokes, press) => Work::Strokes(strokes, press),
                    Job::Undo(..) => Work::Undo,
                    Job::Thing(coord, change) => Work::Thing(coord, change),
                });
                self.scheduler.batch_not_sent();
            }
        }
    }

    /// Chunks beside `coords` that the strokes do not reach, but the borders of their coarse cells,
    /// from which the normals at their faces come; without strokes all that may be.
    fn bordering(
        &self,
        strokes: Option<&[Stroke]>,
        coords: &BTreeSet<ChunkCoord>,
    ) -> Vec<ChunkCoord> {
        let mut found = Vec::new();
        for (level, beside) in self.scheduler.coarse_beside(coords) {
            let Some(strokes) = strokes else {
                found.extend(beside);
                continue;
            };
            let seen = strokes
                .iter()
                .flat_map(|stroke| stroke.remeshed_at(&*self.strategy, level));
            let seen: BTreeSet<_> = seen.collect();
            found.extend(beside.into_iter().filter(|coord| seen.contains(coord)));
        }
        found
    }

    /// Turns a finished job into updates.
    pub(crate) fn take(&mut self, outcome: Outcome, updates: &mut Vec<Update>) {
        match outcome {
            Outcome::Loaded(loaded) => self.take_loaded(loaded, updates),
            Outcome::Edited(edited) => self.take_edited(edited, updates),
            Outcome::Planned(Ok(planned)) => {
                let before = self.scheduler.planned(planned);
                self.discard(before);
            }
            Outcome::Planned(Err(problems)) => {
                self.scheduler.plan_failed();
                updates.extend(problems.into_iter().map(Update::Problem));
            }
            Outcome::Saved(failed) => self.take_saved(failed, updates),
        }
    }

    fn take_loaded(&mut self, mut loaded: Loaded, updates: &mut Vec<Update>) {
        updates.extend(
            std::mem::take(&mut loaded.problems)
                .into_iter()
                .map(Update::Problem),
        );
        let Some(chunk) = loaded.chunk else {
            self.scheduler.give_up(loaded.make.coord);
            return;
        };
        match self.scheduler.loaded(loaded.make, loaded.revision) {
            Verdict::Show => updates.push(Update::Loaded(chunk)),
            Verdict::Harden => updates.push(Update::Solid {
                coord: chunk.coord,
                collider: chunk.collider,
                samples: chunk.samples,
            }),
            Verdict::Hold => self.held.push(Loaded {
                chunk: Some(chunk),
                ..loaded
            }),
            Verdict::Drop => self.discard(chunk),
        }
    }

    fn take_edited(&mut self, edited: Edited, updates: &mut Vec<Update>) {
        self.batch_in_flight = false;
        self.gathered.add(&edited.gathered);
        self.take_press(&edited, updates);
        self.saves.land.extend(edited.land);
        updates.extend(edited.problems.into_iter().map(Update::Problem));
        self.scheduler
            .batch_ended(&edited.touched, &edited.remeshed, edited.revision);
        self.scheduler.emptied(&edited.emptied);
        self.scheduler
            .borders_changed(&edited.bordering, edited.revision);
        if edited.complete {
            let done: HashSet<_> = edited.remeshed.iter().chain(&edited.bordering).collect();
            self.overdue.retain(|coord| !done.contains(coord));
            let made = edited.chunks.into_iter();
            let shown = made.filter(|(make, _)| self.scheduler.show_edited(*make));
            let shown = shown.map(|(_, chunk)| chunk);
            // Which these are hangs on the levels of the picture; their ground is as it was.
            let (beside, chunks): (Vec<_>, Vec<_>) =
                shown.partition(|chunk| !edited.remeshed.contains(&chunk.coord));
            if !chunks.is_empty() {
                updates.push(Update::Edited(chunks));
            }
            updates.extend(beside.into_iter().map(Update::Loaded));
        } else {
            self.overdue.extend(edited.remeshed);
            self.overdue.extend(edited.bordering);
            updates.push(Update::Problem(
                "The last change to the terrain is kept but cannot be shown yet; the next change shows it."
                    .to_owned(),
            ));
        }
        for loaded in std::mem::take(&mut self.held) {
            self.take_loaded(loaded, updates);
        }
    }

    fn take_saved(&mut self, failed: Option<Unsaved>, updates: &mut Vec<Update>) {
        self.saves.in_flight = false;
        self.saves.last_failure = None;
        let Some(Unsaved { why, parts }) = failed else {
            updates.push(Update::Saved);
            return;
        };
        updates.push(Update::SaveFailed(Cause::clone(&why)));
        self.saves.last_failure = Some(why);
        self.saves.unsaved = parts;
    }
}
