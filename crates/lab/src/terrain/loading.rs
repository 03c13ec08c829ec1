//! Loading: how long a new player waits until the world can be played, and until all of its ground stands.

use std::time::{Duration, Instant};

use antipode_geometry::Geometry;

use super::engine::{name, open};
use super::row::{Bar, Judged, Row, table};
use crate::{Effort, LabError, SPACES, Section};

/// View distance in chunks: 343 chunks around the player.
const VIEW_DISTANCE: u32 = 3;
/// Most seconds until the world can be played.
const PLAYABLE_S: f64 = 1.0;
/// Most seconds until everything stands.
const COMPLETE_S: f64 = 2.0;
/// Longest wait.
const PATIENCE: Duration = Duration::from_mins(1);
/// What a frame gives to finished chunks, as in the game.
const CHUNK_BUDGET: Duration = Duration::from_millis(2);
/// Between two looks at what is finished.
const LOOK_AGAIN: Duration = Duration::from_millis(1);

/// One world's loading, seconds from the order to open it.
struct Loaded {
    playable_s: f64,
    complete_s: f64,
    chunks: usize,
    triangles: usize,
}

/// The section of loading times.
///
/// # Errors
/// When a world cannot be opened.
pub fn section(effort: Effort) -> Result<Section, LabError> {
    let mut rows = Vec::new();
    for geometry in SPACES {
        rows.extend(rows_of(geometry, effort)?);
    }
    Ok(Section::new(
        "terrain-loading",
        "Loading",
        METHOD,
        [table("A new player's wait", &rows, effort)],
    ))
}

fn rows_of(geometry: Geometry, effort: Effort) -> Result<[Row; 2], LabError> {
    let times = if effort.quick { 1 } else { 3 };
    let mut best = load(geometry)?;
    for _ in 1..times {
        let next = load(geometry)?;
        best.playable_s = best.playable_s.min(next.playable_s);
        best.complete_s = best.complete_s.min(next.complete_s);
    }
    let row = |what: &str, value: f64, most: f64| {
        Row::new(what, name(geometry), value, "s").bar(Bar::AtMost(most), Judged::InFull)
    };
    let note = format!(
        "{} with a surface, {} triangles",
        best.chunks, best.triangles
    );
    Ok([
        row("playable", best.playable_s, PLAYABLE_S),
        row("complete", best.complete_s, COMPLETE_S).note(note),
    ])
}

fn load(geometry: Geometry) -> Result<Loaded, LabError> {
    let began = Instant::now();
    let mut scene = open(geometry, VIEW_DISTANCE, None)?;
    let mut loaded = Loaded {
        playable_s: f64::INFINITY,
        complete_s: f64::INFINITY,
        chunks: 0,
        triangles: 0,
    };
    while began.elapsed() < PATIENCE {
        scene.pump(CHUNK_BUDGET);
        let now_s = began.elapsed().as_secs_f64();
        if scene.loading_progress() >= 1.0 {
            loaded.playable_s = loaded.playable_s.min(now_s);
        }
        if scene.pending() == 0 {
            loaded.complete_s = now_s;
            break;
        }
        std::thread::sleep(LOOK_AGAIN);
    }
    let chunks = scene.probe().chunks;
    (loaded.chunks, loaded.triangles) = (chunks.resident, chunks.triangles);
    Ok(loaded)
}

const METHOD: [&str; 1] = [
    "A new world is opened as the game does it, with 343 chunks around the player (a closed world is loaded whole), and finished chunks are taken in within the game's own budget. Playable is the moment at which the loading screen goes, complete the one at which nothing is left to make; both count from the order to open the world, and are the least of three loadings.",
];
