//! The state that workers share, and the making of one chunk.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

use antipode_geometry::{ChartPoint, ChunkCoord, Strategy};
use antipode_physics::TerrainCollider;
use antipode_plants::{add_solids, left_of, placed, stones_of_others, undergrowth};
use antipode_terrain::{
    ChunkMesh, FIRST_PLANTED, Field, Level, Mesher, Samples, Thing, apply_edits,
};
use glam::DVec3;

use crate::api::Chunk;
use crate::bases::Bases;
use crate::edit_store::{EditStore, Snapshot, column_of};
use crate::history::History;
use crate::scheduler::Make;

/// A thing goes with the ground so far below its root, metres.
pub const BELOW_ROOT_M: f64 = 0.6;

/// A point in a worker's course, told to the test that watches it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Step {
    /// About to apply a batch of strokes.
    Apply,
    /// A batch has entered the edit store; its meshes are still to be made.
    Entered,
    /// A load has taken its snapshot of the edits.
    Load(ChunkCoord),
    /// About to make a chunk of a batch anew.
    Remesh(ChunkCoord),
}

/// A test's look into the workers: it may wait, or panic in their place.
pub(crate) type Watch = Arc<dyn Fn(Step) + Send + Sync>;

/// Everything a worker needs besides its channels.
pub(crate) struct Shared {
    pub(crate) field: Arc<Field>,
    pub(crate) strategy: Arc<dyn Strategy>,
    pub(crate) edit_store: EditStore,
    pub(crate) bases: Bases,
    pub(crate) history: History,
    pub(crate) watch: Option<Watch>,
    /// Room for meshing that nobody uses at the moment.
    meshers: Mutex<Vec<Mesher>>,
    stopped: AtomicBool,
}

impl Shared {
    /// State for a new worker pool.
    pub(crate) fn new(
        field: Arc<Field>,
        strategy: Arc<dyn Strategy>,
        edit_store: EditStore,
        bases: Bases,
        watch: Option<Watch>,
    ) -> Self {
        Self {
            field,
            strategy,
            edit_store,
            bases,
            history: History::default(),
            watch,
            meshers: Mutex::default(),
            stopped: AtomicBool::new(false),
        }
    }

    /// Tells the workers to leave what they have not begun.
    pub(crate) fn stop(&self) {
        self.stopped.store(true, Ordering::Release);
    }

    /// Have the workers been told to leave?
    pub(crate) fn is_stopped(&self) -> bool {
        self.stopped.load(Ordering::Acquire)
    }

    /// Tells a watching test where the worker is.
    pub(crate) fn at(&self, step: Step) {
        if let Some(watch) = &self.watch {
            watch(step);
        }
    }

    /// Makes a chunk with the given edits. `again` says that it is being edited, so that what it
    /// is made from is worth keeping.
    pub(crate) fn make(&self, make: Make, edits: &Snapshot, again: bool) -> Chunk {
        let Make {
            coord,
            level,
            solid,
        } = make;
        let samples = self.samples(coord, level, edits, again);
        let mut mesh = self.mesh(coord, &samples);
        if !mesh.is_empty() {
            let there = |thing: Thing| {
                if edits.keeps(&thing) {
                    Some(thing)
                } else {
                    left_of(&thing)
                }
            };
            let placed = placed(&self.field, coord).into_iter();
            mesh.things = placed
                .filter_map(there)
                .chain(edits.planted.iter().copied())
                .filter(|thing| self.stands(coord, thing, edits))
                .collect();
            mesh.tufts = undergrowth(&self.field, coord, &mesh);
        }
        let mesh = Arc::new(mesh);
        let collider = if solid {
            self.collider(coord, &mesh, edits, again)
        } else {
            None
        };
        Chunk {
            coord,
            mesh,
            collider,
            samples: solid.then_some(samples),
        }
    }

    /// Whether nobody has dug away the ground right below a thing.
    fn stands(&self, coord: ChunkCoord, thing: &Thing, edits: &Snapshot) -> bool {
        // What grew by itself has untouched ground below it; somebody may have planted on what was built.
        let grew = thing.slot < FIRST_PLANTED;
        if grew && edits.near.is_empty() {
            return true;
        }
        let below = coord.origin() + thing.root.as_dvec3() - DVec3::Y * BELOW_ROOT_M;
        let (low, share) = (below.floor(), below - below.floor());
        let (mut value, mut is_dug) = (0.0, false);
        for n in 0..8 {
            let by = DVec3::new(f64::from(n & 1), f64::from(n >> 1 & 1), f64::from(n >> 2));
            let sample = ChartPoint::new(coord.chart, low + by);
            let of = ChunkCoord::containing(sample);
            let [i, j, k] = (sample.pos - of.origin()).to_array().map(|c| c as usize);
            let delta = edits.of(of).map_or(0.0, |edits| edits.delta(i, j, k));
            let weight = (by * share + (1.0 - by) * (1.0 - share)).element_product();
            // What all charts share over a corner has all the weight there.
            is_dug |= delta > 0.0 && weight > 0.0;
            value += weight * f64::from(self.field.sample(sample) + delta);
        }
        (grew && !is_dug) || value < 0.0
    }

    /// What stands on a chunk and is a thing of another chart.
    fn others_on(&self, coord: ChunkCoord, edits: &Snapshot) -> Vec<Thing> {
        let others = stones_of_others(&self.field, coord).into_iter();
        let stands = |(thing, home): (Thing, ChunkCoord)| {
            let felled = self.edit_store.felled(column_of(home));
            let is_felled = felled.unbounded_shr(thing.slot.into()) & 1 == 1;
            (!is_felled && self.stands(coord, &thing, edits)).then_some(thing)
        };
        others.filter_map(stands).collect()
    }

    fn mesh(&self, coord: ChunkCoord, samples: &Samples) -> ChunkMesh {
        let meshers = || self.meshers.lock().unwrap_or_else(PoisonError::into_inner);
        let mut mesher = meshers().pop().unwrap_or_default();
        let mesh = mesher.march(samples, &self.field, coord);
        meshers().push(mesher);
        mesh
    }

    fn samples(
        &self,
        coord: ChunkCoord,
        level: Level,
        edits: &Snapshot,
        again: bool,
    ) -> Arc<Samples> {
        let base = if level == Level::FULL {
            self.base(coord, again || !edits.near.is_empty())
        } else {
            Arc::new(self.field.samples_at(coord, level))
        };
        if edits.near.is_empty() {
            return base;
        }
        let mut samples = Arc::unwrap_or_clone(base);
        apply_edits(&mut samples, coord, |near| edits.of(near));
        Arc::new(samples)
    }

    /// Builds the collider, or only what an edit has changed of it.
    fn collider(
        &self,
        coord: ChunkCoord,
        mesh: &ChunkMesh,
        edits: &Snapshot,
        again: bool,
    ) -> Option<TerrainCollider> {
        let before = self.bases.collider(coord);
        let (mut corners, mut triangles) = (mesh.positions(), mesh.triangles().to_vec());
        add_solids(&mesh.things, &mut corners, &mut triangles);
        if !mesh.is_empty() {
            let others = self.others_on(coord, edits);
            add_solids(&others, &mut corners, &mut triangles);
        }
        let collider = TerrainCollider::rebuild(before.as_ref(), &corners, &triangles);
        if again {
            self.bases.keep_collider(coord, collider.clone());
        }
        collider
    }

    /// The untouched samples of a chunk at full resolution, which are worth keeping or not.
    pub(crate) fn base(&self, coord: ChunkCoord, keep: bool) -> Arc<Samples> {
        let base = self
            .bases
            .get(coord)
            .unwrap_or_else(|| Arc::new(self.field.samples(coord)));
        if keep {
            self.bases.keep(coord, &base);
        } else {
            self.bases.note(coord, &base);
        }
        base
    }
}
