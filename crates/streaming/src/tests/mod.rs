//! What the game sees of the streamer, in worlds made for the purpose.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "tests fail by panicking"
)]

mod cone;
mod damaged;
mod earthworks;
mod editing;
mod failing;
mod gathering;
mod kinds;
mod levels;
mod loading;
mod overlap;
mod saving;
mod solid;
mod tiled;
mod tiles;

use std::collections::{BTreeMap, HashMap};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};
use std::time::Duration;

use antipode_geometry::{ChartId, ChartPoint, ChunkCoord, Geometry, Strategy, strategy};
use antipode_storage::{Batch, ChunkKey, RecordChanges};
use antipode_terrain::{Earth, Field, Samples, Stroke};
use crossbeam_channel::{Receiver, Sender, bounded};
use glam::{DVec3, IVec3};

use crate::api::{Chunk, Config, NotUndone, Until, Update, Wish};
use crate::edit_backend::{EditBackend, Failure, ReadFault, Stored};
use crate::shared::{Step, Watch};
use crate::streamer::Streamer;

/// Far more than any test needs; it only ends a test that would hang.
const LIMIT: Duration = Duration::from_mins(2);

const SEED: u64 = 11;

/// A world under test and what its game has been told.
struct Game {
    streamer: Streamer,
    field: Arc<Field>,
    space: Arc<dyn Strategy>,
    chunks: BTreeMap<ChunkCoord, Chunk>,
    problems: Vec<String>,
    saved: usize,
}

impl Game {
    fn new(
        geometry: Geometry,
        workers: usize,
        backend: Option<Arc<dyn EditBackend>>,
        watch: Option<Watch>,
    ) -> Self {
        let radius_m = if geometry == Geometry::Spherical {
            16.0
        } else {
            20.0
        };
        Self::in_space(strategy(geometry, radius_m), workers, backend, watch)
    }

    fn of(geometry: Geometry, radius_m: f64, workers: usize) -> Self {
        Self::in_space(strategy(geometry, radius_m), workers, None, None)
    }

    fn in_space(
        space: Arc<dyn Strategy>,
        workers: usize,
        backend: Option<Arc<dyn EditBackend>>,
        watch: Option<Watch>,
    ) -> Self {
        let field = Field::new(SEED, space.clone());
        Self::on(field, space, workers, backend, watch)
    }

    fn on(
        field: Field,
        space: Arc<dyn Strategy>,
        workers: usize,
        backend: Option<Arc<dyn EditBackend>>,
        watch: Option<Watch>,
    ) -> Self {
        let field = Arc::new(field);
        let config = Config {
            workers,
            ..Config::default()
        };
        let streamer =
            Streamer::start_watched(field.clone(), space.clone(), backend, config, watch).unwrap();
        Self {
            streamer,
            field,
            space,
            chunks: BTreeMap::new(),
            problems: Vec::new(),
            saved: 0,
        }
    }

    fn flat(workers: usize) -> Self {
        Self::new(Geometry::Euclidean, workers, None, None)
    }

    /// The place where the ground crosses a column, chart metres.
    fn ground(&self, x: f64, z: f64) -> DVec3 {
        DVec3::new(x, self.field.surface_height(ChartId::FIRST, x, z), z)
    }

    fn wish(&mut self, at: DVec3, view_distance: u32) {
        self.streamer
            .wish(&Wish::new(ChartPoint::a(at), DVec3::X, view_distance));
    }

    fn edit(&mut self, at: DVec3, amount: f32) {
        self.streamer.edit(stroke(at, amount));
    }

    /// Waits, and does what a game does with the updates; returns how many there were of each kind.
    fn wait(&mut self, what: Until<'_>) -> Seen {
        let updates = self.streamer.wait(what, LIMIT);
        self.apply(updates)
    }

    fn apply(&mut self, updates: Vec<Update>) -> Seen {
        let mut seen = Seen::default();
        for update in updates {
            match update {
                Update::Loaded(chunk) => {
                    seen.loaded.push(chunk.coord);
                    self.chunks.insert(chunk.coord, chunk);
                }
                Update::Edited(chunks) => {
                    seen.batches
                        .push(chunks.iter().map(|chunk| chunk.coord).collect());
                    self.chunks
                        .extend(chunks.into_iter().map(|chunk| (chunk.coord, chunk)));
                }
                Update::Solid {
                    coord,
                    collider,
                    samples,
                } => {
                    seen.solid.push((coord, samples.is_some()));
                    let chunk = self.chunks.get_mut(&coord).expect("a chunk that is there");
                    (chunk.collider, chunk.samples) = (collider, samples);
                }
                Update::Unloaded(coord) => {
                    seen.unloaded.push(coord);
                    assert!(
                        self.chunks.remove(&coord).is_some(),
                        "{coord:?} was unloaded but never there"
                    );
                }
                Update::Moved { earth, .. } => seen.earth.add(&earth),
                Update::Undone(end) => seen.undone.push(end),
                Update::Saved => self.saved += 1,
                Update::Problem(problem) => self.problems.push(problem),
                Update::SaveFailed(why) => self.problems.push(why.to_string()),
            }
        }
        seen
    }

    fn samples(&self, coord: ChunkCoord) -> &Samples {
        self.chunks[&coord].samples.as_ref().expect("solid ground")
    }

    /// The field at a sample of the grid, edits included, in a chunk that is there.
    fn sample(&self, at: IVec3) -> f32 {
        let coord = ChunkCoord::containing(ChartPoint::a(at.as_dvec3()));
        self.samples(coord).density(at.as_dvec3() - coord.origin())
    }

    fn sum(&self, coord: ChunkCoord) -> f64 {
        let grid = (0..32)
            .flat_map(|x| (0..32).flat_map(move |y| (0..32).map(move |z| IVec3::new(x, y, z))));
        grid.map(|local| f64::from(self.samples(coord).density(local.as_dvec3())))
            .sum()
    }
}

#[derive(Default)]
struct Seen {
    loaded: Vec<ChunkCoord>,
    batches: Vec<Vec<ChunkCoord>>,
    unloaded: Vec<ChunkCoord>,
    solid: Vec<(ChunkCoord, bool)>,
    earth: Earth,
    undone: Vec<Result<Earth, NotUndone>>,
}

fn stroke(at: DVec3, amount: f32) -> Stroke {
    Stroke {
        centre: ChartPoint::a(at),
        radius_m: 5.0,
        amount,
        part: antipode_terrain::Part::Whole,
        kind: None,
        shape: antipode_terrain::Shape::Ball,
        power: None,
    }
}

fn chunk(x: i32, y: i32, z: i32) -> ChunkCoord {
    ChunkCoord {
        chart: ChartId::FIRST,
        index: IVec3::new(x, y, z),
    }
}

/// Stops the first worker that comes to a step, until it is let go.
struct Gate {
    reached: Receiver<()>,
    go: Sender<()>,
}

impl Gate {
    fn at(stop: impl Fn(Step) -> bool + Send + Sync + 'static) -> (Self, Watch) {
        let (reach, reached) = bounded(1);
        let (go, gone) = bounded::<()>(1);
        let used = AtomicBool::new(false);
        let watch = move |step: Step| {
            if stop(step) && !used.swap(true, Ordering::SeqCst) {
                reach.send(()).unwrap();
                let _ = gone.recv_timeout(LIMIT);
            }
        };
        (Self { reached, go }, Arc::new(watch))
    }

    fn wait(&self) {
        self.reached
            .recv_timeout(LIMIT)
            .expect("a worker comes to the gate");
    }

    fn open(&self) {
        self.go.send(()).unwrap();
    }
}

/// A store in memory that fails when told to.
#[derive(Default)]
struct Memory {
    chunks: Mutex<HashMap<ChunkKey, Vec<i16>>>,
    kinds: Mutex<BTreeMap<ChunkKey, Vec<u8>>>,
    commits: Mutex<Vec<(bool, bool, Vec<ChunkKey>)>>,
    records: Mutex<Vec<RecordChanges>>,
    full: AtomicBool,
    damaged: Mutex<Option<ChunkKey>>,
    broken: AtomicBool,
    /// Chunks cannot be read, but are sound.
    absent: AtomicBool,
}

impl Memory {
    fn fail(&self, full: bool) {
        self.full.store(full, Ordering::SeqCst);
    }

    fn commits(&self) -> Vec<(bool, bool, Vec<ChunkKey>)> {
        self.commits.lock().unwrap().clone()
    }

    fn records(&self) -> Vec<RecordChanges> {
        self.records.lock().unwrap().clone()
    }
}

impl EditBackend for Memory {
    fn edited(&self) -> Result<Vec<ChunkKey>, Failure> {
        Ok(self.chunks.lock().unwrap().keys().copied().collect())
    }

    fn chunk(&self, key: &ChunkKey) -> Result<Option<Stored>, ReadFault> {
        if self.absent.load(Ordering::SeqCst) {
            return Err(ReadFault::Unreadable("the disk is away".into()));
        }
        if *self.damaged.lock().unwrap() == Some(*key) {
            return Err(ReadFault::Damaged("its checksum is wrong".into()));
        }
        let kinds = self.kinds.lock().unwrap().get(key).cloned();
        let units = self.chunks.lock().unwrap().get(key).cloned();
        Ok(units.map(|units| (units, kinds.unwrap_or_default())))
    }

    fn commit(&self, batch: &Batch) -> Result<(), Failure> {
        assert!(!self.broken.load(Ordering::SeqCst), "a broken store");
        if self.full.load(Ordering::SeqCst) {
            return Err("the disk is full".into());
        }
        let keys = batch.chunks.iter().map(|(key, _)| *key).collect();
        self.commits
            .lock()
            .unwrap()
            .push((batch.meta.is_some(), !batch.records.is_empty(), keys));
        self.records.lock().unwrap().push(batch.records.clone());
        self.kinds.lock().unwrap().extend(batch.kinds.clone());
        let mut chunks = self.chunks.lock().unwrap();
        chunks.extend(batch.chunks.iter().cloned());
        chunks.retain(|_, units| !units.is_empty());
        Ok(())
    }
}
