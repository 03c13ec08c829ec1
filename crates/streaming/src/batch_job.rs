//! One edit batch among the workers: the strokes are applied by one of them, then all that are
//! free make the chunks anew, and whoever makes the last one reports the batch whole.

use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

use antipode_geometry::ChunkCoord;
use antipode_terrain::{Earth, Ground, Kind, Samples, Stock, Stroke, apply_edits};

use crate::api::Chunk;
use crate::earthworks;
use crate::edit_store::{Change, Entered};
use crate::outcome::{Edited, Undone};
use crate::range::around;
use crate::scheduler::Make;
use crate::shared::{Shared, Step};
use crate::strokes::ThingChange;
use crate::worker::guarded;

/// How often a stroke that a stock does not last for is halved: then it leaves a 64th of what it would have taken.
const HALVINGS: u32 = 6;

/// What a batch does to the edits.
#[derive(Debug)]
pub(crate) enum Job {
    /// Applies strokes in the order in which they were made, all of one press, or of none that can be undone.
    Strokes(Vec<Stroke>, Option<u64>),
    /// Undoes a press, which was seen from these chunks.
    Undo(u64, BTreeSet<ChunkCoord>),
    /// Changes a thing on a chunk.
    Thing(ChunkCoord, ThingChange),
}

/// What the game hands over.
#[derive(Debug)]
pub(crate) struct EditBatch {
    pub(crate) job: Job,
    /// What may be built with; without it nothing is spent.
    pub(crate) stock: Option<Box<Stock>>,
    /// Chunks whose meshes an earlier batch could not make.
    pub(crate) overdue: Vec<ChunkCoord>,
    /// How chunks are to be made that the strokes may reach, they or the borders of their coarse
    /// cells; those not named are not shown.
    pub(crate) makes: Vec<Make>,
}

/// A batch that has entered the edit store and is being meshed.
pub(crate) struct BatchJob {
    makes: Vec<Make>,
    next: AtomicUsize,
    result: Mutex<Progress>,
}

struct Progress {
    finished: usize,
    edited: Edited,
}

impl BatchJob {
    /// Applies the strokes. On a panic nothing has entered the edit store.
    pub(crate) fn begin(shared: &Shared, batch: &EditBatch) -> Self {
        let mut problems = Vec::new();
        let tried = guarded(&mut problems, "changing the terrain", |problems| {
            apply(shared, batch, problems)
        });
        if tried.is_none() {
            problems.push(
                "The last change to the terrain could not be made and is left out; try it again."
                    .to_owned(),
            );
        }
        let applied = tried.unwrap_or_default();
        shared.at(Step::Entered);
        let shown = |make: &&Make| {
            applied.remeshed.contains(&make.coord) || applied.bordering.contains(&make.coord)
        };
        let makes: Vec<_> = batch.makes.iter().filter(shown).copied().collect();
        let edited = Edited {
            chunks: Vec::with_capacity(makes.len()),
            touched: applied.touched,
            emptied: applied.emptied,
            remeshed: applied.remeshed.into_iter().collect(),
            bordering: applied.bordering.into_iter().collect(),
            revision: applied.entered.revision,
            land: applied.entered.land,
            complete: true,
            problems,
            moved: applied.moved,
            gathered: applied.gathered,
            undone: applied.undone,
        };
        Self {
            makes,
            next: AtomicUsize::new(0),
            result: Mutex::new(Progress {
                finished: 0,
                edited,
            }),
        }
    }

    /// The chunks to make.
    pub(crate) fn len(&self) -> usize {
        self.makes.len()
    }

    /// Makes chunks until none is left; returns the batch to the worker that made the last.
    pub(crate) fn help(&self, shared: &Shared) -> Option<Edited> {
        if self.makes.is_empty() {
            return Some(std::mem::take(&mut self.lock().edited));
        }
        while !shared.is_stopped() {
            let make = *self.makes.get(self.next.fetch_add(1, Ordering::Relaxed))?;
            let coord = make.coord;
            let mut problems = Vec::new();
            let doing = format!("making chunk {}", coord.index);
            let made = guarded(&mut problems, &doing, |problems| {
                shared.at(Step::Remesh(coord));
                let edits = shared.edit_store.snapshot(coord, problems);
                (make, shared.make(make, &edits, true))
            });
            if let Some(edited) = self.finish(made, problems) {
                return Some(edited);
            }
        }
        None
    }

    fn finish(&self, made: Option<(Make, Chunk)>, problems: Vec<String>) -> Option<Edited> {
        let mut progress = self.lock();
        progress.finished += 1;
        progress.edited.problems.extend(problems);
        match made {
            Some(chunk) => progress.edited.chunks.push(chunk),
            None => progress.edited.complete = false,
        }
        (progress.finished == self.makes.len()).then(|| {
            let mut edited = std::mem::take(&mut progress.edited);
            edited.chunks.sort_unstable_by_key(|(make, _)| make.coord);
            edited
        })
    }

    fn lock(&self) -> std::sync::MutexGuard<'_, Progress> {
        self.result.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

#[derive(Default)]
struct Applied {
    touched: Vec<ChunkCoord>,
    emptied: Vec<ChunkCoord>,
    remeshed: BTreeSet<ChunkCoord>,
    bordering: BTreeSet<ChunkCoord>,
    entered: Entered,
    moved: Option<(u64, Earth)>,
    gathered: Stock,
    undone: Option<Undone>,
}

fn apply(shared: &Shared, batch: &EditBatch, problems: &mut Vec<String>) -> Applied {
    shared.at(Step::Apply);
    match &batch.job {
        Job::Strokes(strokes, press) => {
            let mut reached = BTreeSet::new();
            let done = if press.is_some() {
                affordable(
                    shared,
                    strokes,
                    batch.stock.as_deref(),
                    &mut reached,
                    problems,
                )
            } else {
                let changed = changes(shared, strokes, &mut reached, problems);
                changed.map(|changed| (changed, Earth::default()))
            };
            let (changed, earth) = done.unwrap_or_else(|| {
                problems.push(
                    "The last change to the terrain is left out, since it would overwrite stored changes that cannot \
                     be read now. See that the disk is there and try again."
                        .to_owned(),
                );
                (Vec::new(), Earth::default())
            });
            let gathered = earth.gathered(kind_built(strokes));
            if let Some(press) = press {
                let states = changed.iter().map(Change::states);
                shared.history.note(*press, &earth, &gathered, states);
            }
            Applied {
                moved: press.map(|press| (press, earth)),
                gathered,
                ..enter(shared, batch, changed, reached)
            }
        }
        Job::Thing(coord, change) => {
            let mut applied = enter(shared, batch, Vec::new(), BTreeSet::new());
            applied.remeshed.insert(*coord);
            applied.entered = shared.edit_store.change(*coord, change);
            applied
        }
        Job::Undo(press, reach) => {
            match earthworks::undo(shared, *press, batch.stock.as_deref(), problems) {
                Ok((changed, earth, gathered)) => Applied {
                    undone: Some((*press, Ok(earth))),
                    gathered: gathered.negative(),
                    ..enter(shared, batch, changed, reach.clone())
                },
                Err(why) => Applied {
                    undone: Some((*press, Err(why))),
                    ..enter(shared, batch, Vec::new(), BTreeSet::new())
                },
            }
        }
    }
}

/// What strokes of a press build of.
fn kind_built(strokes: &[Stroke]) -> Option<Kind> {
    strokes.first().and_then(|stroke| stroke.kind)
}

/// The changes that strokes make and what they move, as far as the stock lasts; `None` if something is stored there and
/// cannot be read now.
///
/// What is moved is known only of strokes that were made. So where they take more than there is they are made anew with a
/// share of their amount, found by halving.
fn affordable(
    shared: &Shared,
    strokes: &[Stroke],
    stock: Option<&Stock>,
    reached: &mut BTreeSet<ChunkCoord>,
    problems: &mut Vec<String>,
) -> Option<(Vec<Change>, Earth)> {
    let mut done = |share: f32| {
        let strokes: Vec<_> = strokes
            .iter()
            .map(|stroke| Stroke {
                amount: share * stroke.amount,
                ..*stroke
            })
            .collect();
        let changed = changes(shared, &strokes, reached, problems)?;
        let earth = earthworks::earth(shared, &changed, problems);
        Some((changed, earth))
    };
    let whole = done(1.0)?;
    let Some(stock) = stock else {
        return Some(whole);
    };
    let builds = kind_built(strokes);
    let is_allowed = |earth: &Earth| stock.allows_building(&earth.gathered(builds), builds);
    if is_allowed(&whole.1) {
        return Some(whole);
    }
    let mut best = (Vec::new(), Earth::default());
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..HALVINGS {
        let share = f32::midpoint(low, high);
        let part = done(share)?;
        if is_allowed(&part.1) {
            (low, best) = (share, part);
        } else {
            high = share;
        }
    }
    Some(best)
}

/// Enters changes, which are seen from the chunks of `reached` at most.
fn enter(
    shared: &Shared,
    batch: &EditBatch,
    changed: Vec<Change>,
    mut reached: BTreeSet<ChunkCoord>,
) -> Applied {
    let touched: Vec<_> = changed
        .iter()
        .filter(|change| change.visible)
        .map(|change| change.coord)
        .collect();
    let emptied = changed.iter().filter(|change| change.is_undone());
    let emptied = emptied.map(|change| change.coord).collect();
    let beside: BTreeSet<_> = touched
        .iter()
        .flat_map(|&coord| around(coord, -1, 1))
        .collect();
    // What is to be made without being reached by the strokes is so for its border's sake.
    let makes = batch.makes.iter().map(|make| make.coord);
    let bordering = makes.filter(|coord| beside.contains(coord) && !reached.contains(coord));
    let bordering = bordering.collect();
    reached.retain(|coord| beside.contains(coord));
    reached.extend(&batch.overdue);
    Applied {
        touched,
        emptied,
        remeshed: reached,
        bordering,
        entered: shared.edit_store.enter(changed),
        ..Applied::default()
    }
}

/// What a chunk's ground is with all edits, those of the batch so far too.
fn now(
    shared: &Shared,
    coord: ChunkCoord,
    changes: &BTreeMap<ChunkCoord, Change>,
    problems: &mut Vec<String>,
) -> Samples {
    let before = shared.edit_store.snapshot(coord, problems);
    let mut samples = Samples::clone(&shared.base(coord, true));
    apply_edits(&mut samples, coord, |near| match changes.get(&near) {
        Some(change) => Some(Arc::clone(&change.edits)),
        None => before.of(near),
    });
    samples
}

/// The new edits of every chunk that a stroke reaches, and in `reached` the chunks that show them;
/// `None` if one of them is stored and cannot be read now.
fn changes(
    shared: &Shared,
    strokes: &[Stroke],
    reached: &mut BTreeSet<ChunkCoord>,
    problems: &mut Vec<String>,
) -> Option<Vec<Change>> {
    let strategy = &*shared.strategy;
    let mut changes: BTreeMap<ChunkCoord, Change> = BTreeMap::new();
    for stroke in strokes {
        for coord in stroke.touched(strategy) {
            let change = match changes.entry(coord) {
                Entry::Occupied(found) => found.into_mut(),
                Entry::Vacant(missing) => {
                    let before = shared.edit_store.edits(coord, problems)?;
                    missing.insert(Change::of(coord, before))
                }
            };
            if !stroke.needs_samples(&change.edits) {
                change.visible |= stroke.apply(coord, change.edits_mut(), strategy);
                continue;
            }
            let now = now(shared, coord, &changes, problems);
            if let Some(change) = changes.get_mut(&coord) {
                let ground = Ground {
                    samples: &now,
                    field: &shared.field,
                };
                change.visible |=
                    stroke.apply_to(coord, change.edits_mut(), strategy, Some(ground));
            }
        }
        reached.extend(stroke.remeshed(strategy));
    }
    Some(changes.into_values().collect())
}
