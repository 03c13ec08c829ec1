//! Edits: how long a stroke takes to become ground, what it costs the main thread, and whether any is lost.

use std::sync::Arc;
use std::time::{Duration, Instant};

use antipode_geometry::{ChartPoint, Geometry, strategy};
use antipode_physics::PhysicsWorld;
use antipode_streaming::{Chunk, Config, Reach, Streamer, Until, Update, Wish};
use glam::DVec3;

use super::clock::{Spread, ThreadClock, program_ms};
use super::engine::surface_chunk;
use super::row::{Bar, Judged, Row, table};
use super::strokes::{PER_S, Strokes};
use crate::{Effort, LabError, Section};

/// Most milliseconds from a stroke to its mesh and collider.
const LATENCY_MS: f64 = 33.0;
/// Frames of a sixtieth of a second in that time.
const LATENCY_FRAMES: f64 = 2.0;
/// Most milliseconds of the main thread in a frame.
const MAIN_MS: f64 = 1.0;
/// Chunks that one stroke reaches.
const CHUNKS: f64 = 8.0;
/// Ground is solid this far from the corner, metres: all eight chunks, as around a player who digs.
const SOLID_M: f64 = 16.0;
/// What a frame gives to finished chunks, as in the game.
const CHUNK_BUDGET: Duration = Duration::from_millis(2);
/// Between two looks at what is finished, where a frame's end is not waited for.
const LOOK_AGAIN: Duration = Duration::from_millis(1);
/// Longest wait for loads, and for the last strokes.
const PATIENCE: Duration = Duration::from_mins(1);

/// How often finished work is asked for.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Look {
    /// Every millisecond: what the workers need.
    Often,
    /// Once a frame, as the game does.
    EachFrame,
}

/// What one session of strokes showed.
#[derive(Default)]
struct Session {
    latency_ms: Vec<f64>,
    frames: Vec<f64>,
    main_ms: Vec<f64>,
    meshed: Vec<f64>,
    /// Deliveries that were not the ground after any stroke.
    strange: usize,
    /// Meshes that came without their collider.
    hollow: usize,
    lost: usize,
    /// Processor time of all threads, milliseconds.
    worked_ms: Option<f64>,
}

/// The section of edits.
///
/// # Errors
/// When the workers cannot be started or the land is not made.
pub fn section(effort: Effort) -> Result<Section, LabError> {
    let seconds = if effort.quick { 2 } else { 10 };
    let often = run(Look::Often, seconds * PER_S)?;
    let framed = run(Look::EachFrame, seconds * PER_S)?;
    let mut rows = rows("asked every millisecond", &often);
    rows.extend(self::rows("asked once a frame", &framed));
    Ok(Section::new(
        "terrain-edits",
        "Edits",
        METHOD,
        [table(
            "Sixty strokes a second over eight chunks",
            &rows,
            effort,
        )],
    ))
}

fn rows(case: &str, session: &Session) -> Vec<Row> {
    let mut rows = latency_rows(case, session);
    let main = Spread::of(&session.main_ms);
    let batches = session.meshed.len();
    let each_ms = session.worked_ms.map(|ms| ms / batches.max(1) as f64);
    rows.extend([
        Row::new(
            "processor time of a batch, all threads",
            case,
            each_ms,
            "ms",
        )
        .note(format!("{batches} batches")),
        Row::new("main thread, p50", case, main.p50, "ms"),
        Row::new("main thread, p99", case, main.p99, "ms")
            .bar(Bar::AtMost(MAIN_MS), Judged::InFull)
            .note(format!("the longest {:.2} ms", main.max)),
    ]);
    let count = |what: &str, count: f64, most: f64| {
        Row::new(what, case, count, "").bar(Bar::AtMost(most), Judged::Always)
    };
    let meshed = Spread::of(&session.meshed).max;
    rows.extend([
        count("strokes lost", session.lost as f64, 0.0)
            .note(format!("of {}", session.main_ms.len())),
        count(
            "deliveries that show no state of the ground",
            session.strange as f64,
            0.0,
        )
        .note(format!("of {batches}")),
        count("meshes without their collider", session.hollow as f64, 0.0),
        count("chunks meshed again in a batch, at most", meshed, CHUNKS),
    ]);
    rows
}

fn latency_rows(case: &str, session: &Session) -> Vec<Row> {
    let (ms, frames) = (Spread::of(&session.latency_ms), Spread::of(&session.frames));
    let what = "stroke to mesh and collider";
    let p99 = Row::new(&format!("{what}, p99"), case, ms.p99, "ms");
    let mut rows = vec![Row::new(&format!("{what}, p50"), case, ms.p50, "ms")];
    if case.ends_with("frame") {
        // A frame is asked for once in 16.7 ms: 33.4 ms are two of them, and the clock's wobble.
        let shown = "stroke to the frame that shows it, p99";
        rows.push(p99);
        rows.push(
            Row::new(shown, case, frames.p99, "frames")
                .bar(Bar::AtMost(LATENCY_FRAMES), Judged::InFull),
        );
    } else {
        rows.push(p99.bar(Bar::AtMost(LATENCY_MS), Judged::InFull));
    }
    rows
}

/// The session under way.
struct Driver {
    streamer: Streamer,
    physics: PhysicsWorld,
    strokes: Strokes,
    issued: Vec<Instant>,
    /// Strokes that what was delivered holds.
    held: usize,
    session: Session,
}

fn run(look: Look, count: usize) -> Result<Session, LabError> {
    let mut driver = Driver::open(count)?;
    let clock = ThreadClock::new();
    let frame = Duration::from_secs(1) / PER_S as u32;
    let before_ms = program_ms();
    let began = Instant::now();
    for n in 0..count {
        let then = clock.now();
        driver.ask();
        driver.streamer.edit(driver.strokes.row[n]);
        driver.issued.push(Instant::now());
        driver.take();
        let mut main_ms = clock.since(then).own_ms;
        let end = began + frame * (n as u32 + 1);
        while look == Look::Often && Instant::now() + LOOK_AGAIN < end {
            std::thread::sleep(LOOK_AGAIN);
            let then = clock.now();
            driver.take();
            main_ms += clock.since(then).own_ms;
        }
        std::thread::sleep(end.saturating_duration_since(Instant::now()));
        driver.session.main_ms.push(main_ms);
    }
    let last = driver.streamer.wait(Until::Edits, PATIENCE);
    driver.apply(last);
    let worked_ms = program_ms().zip(before_ms);
    driver.session.worked_ms = worked_ms.map(|(after, before)| after - before);
    driver.session.lost = count - driver.held;
    Ok(driver.session)
}

impl Driver {
    fn open(count: usize) -> Result<Self, LabError> {
        let failed = |error: antipode_streaming::StreamingError| LabError::Scene(error.to_string());
        let (field, _) = surface_chunk(Geometry::Euclidean);
        let strokes = Strokes::new(&field, count);
        let space = strategy(Geometry::Euclidean, f64::INFINITY);
        let streamer = Streamer::start(Arc::new(field), space, None, Config::default());
        let mut driver = Self {
            streamer: streamer.map_err(failed)?,
            physics: PhysicsWorld::new(),
            strokes,
            issued: Vec::new(),
            held: 0,
            session: Session::default(),
        };
        driver.ask();
        let loaded = driver.streamer.wait(Until::Idle, PATIENCE);
        if loaded.is_empty() {
            return Err(LabError::Scene("no land was loaded".to_owned()));
        }
        driver.apply(loaded);
        Ok(driver)
    }

    /// Tells what is wanted, as every frame does.
    fn ask(&mut self) {
        let centre = ChartPoint::a(self.strokes.corner);
        self.streamer.wish(&Wish {
            bodies: vec![Reach::around(centre, SOLID_M)],
            ..Wish::new(centre, DVec3::X, 1)
        });
    }

    /// Takes in what is finished.
    fn take(&mut self) {
        let updates = self.streamer.poll(CHUNK_BUDGET);
        self.apply(updates);
    }

    fn apply(&mut self, updates: Vec<Update>) {
        for update in updates {
            match update {
                Update::Loaded(chunk) => self.put(chunk),
                Update::Edited(chunks) => {
                    self.account(&chunks);
                    for chunk in chunks {
                        self.put(chunk);
                    }
                }
                Update::Solid {
                    coord, collider, ..
                } => {
                    let ground = self.physics.chart_mut(coord.chart);
                    ground.set_terrain(coord, coord.origin(), collider);
                }
                _ => {}
            }
        }
    }

    fn put(&mut self, chunk: Chunk) {
        let origin = chunk.coord.origin();
        self.physics
            .chart_mut(chunk.coord.chart)
            .set_terrain(chunk.coord, origin, chunk.collider);
    }

    /// Finds out which strokes a batch shows, and when they were made.
    fn account(&mut self, chunks: &[Chunk]) {
        let now = Instant::now();
        self.session.meshed.push(chunks.len() as f64);
        let hollow = |chunk: &&Chunk| chunk.collider.is_none() && !chunk.mesh.is_empty();
        self.session.hollow += chunks.iter().filter(hollow).count();
        let witness = chunks.iter().find(|c| self.strokes.touches(c.coord));
        let held = witness.and_then(|chunk| {
            let seen = self.strokes.seen(chunk.coord, chunk.samples.as_deref()?);
            self.strokes.held(&seen, self.held, self.issued.len())
        });
        let Some(held) = held else {
            self.session.strange += 1;
            return;
        };
        for issued in &self.issued[self.held..held] {
            let waited_s = now.duration_since(*issued).as_secs_f64();
            self.session.latency_ms.push(waited_s * 1e3);
            self.session.frames.push((waited_s * PER_S as f64).round());
        }
        self.held = held;
    }
}

const METHOD: [&str; 3] = [
    "A corner at which eight chunks meet is struck sixty times a second, in real time, each stroke five metres wide and at another place, a second of digging and a second of building in turns. A mesh with its collider that is handed over is recognised by the field at the eight samples around the corner: from it one knows which strokes it holds, so latency is counted for every stroke, and a stroke that never shows is a lost one. Latency counts the wall clock, so it needs a machine that does nothing else; the processor time of a batch of eight chunks, everything that all threads did divided by the batches, does not.",
    "Once the streamer is asked for finished work every millisecond, which gives the time that the workers need, and once only at each frame, as the game does it, where the times are whole frames: a stroke that is made in one frame and shown in the next but one took two.",
    "The main thread's share is all that it does in a frame for strokes and their meshes: telling what is wanted, handing over the stroke, taking finished meshes and putting their colliders into the physics. Time in which the system had given the core to another program is not counted.",
];
