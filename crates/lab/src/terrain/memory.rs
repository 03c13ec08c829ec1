//! Memory and disk: a long way in one direction with edits, and what a world that nobody has touched takes.

use std::path::Path;
use std::sync::Arc;
use std::time::Duration;

use antipode_geometry::{ChartId, ChartPoint, Geometry};
use antipode_scene::tuning::FOV_Y_RAD;
use antipode_scene::{Actions, Scene};
use antipode_storage::{SavesDir, WorldStore};
use antipode_terrain::Field;
use antipode_timing::resident_mb;
use glam::DVec3;

use super::engine::{field, open, setup};
use super::row::{Bar, Judged, Row, table};
use crate::{Effort, LabError, Plot, Scale, Section, Series};

/// Simulated seconds of the way, and of a quick one. Over the first ten minutes the allocator still takes what it will
/// keep for its threads; whether memory is level after that, the second ten tell.
const WAY_S: [usize; 2] = [1200, 20];
/// View distance in chunks.
const VIEW_DISTANCE: u32 = 6;
/// Digging lasts this many steps, once in this many seconds.
const DIG: (usize, usize) = (20, 4);
/// How far above the ground the player keeps, metres: a tool reaches it.
const ABOVE_M: f64 = 5.0;
/// Steps in a simulated second.
const STEPS: usize = 60;
/// Simulated seconds between two looks at the memory.
const LOOK_S: usize = 5;
/// Most memory beyond what the program had before, MB.
const MEMORY_MB: f64 = 350.0;
/// Most that memory may grow over the second half of the way, MB.
const GROWTH_MB: f64 = 10.0;
/// Most of a played world on the disk, of an untouched one, and of an edited chunk.
const DISK_MB: f64 = 5.0;
const UNTOUCHED_MB: f64 = 1.1;
const CHUNK_KB: f64 = 4.0;
/// Longest wait for land or disk.
const PATIENCE: Duration = Duration::from_mins(2);
/// What a frame gives to finished chunks, as in the game.
const CHUNK_BUDGET: Duration = Duration::from_millis(2);

/// What the way showed.
struct Way {
    /// Simulated seconds and memory in MB beyond what was there before, where the system tells.
    memory: Vec<(f64, f64)>,
    went_m: f64,
    edited: usize,
}

/// The section of memory and disk.
///
/// # Errors
/// When a world cannot be made, opened, played or closed.
pub fn section(effort: Effort) -> Result<Section, LabError> {
    let failed = |error: std::io::Error| LabError::Scene(format!("no place for a world: {error}"));
    let place = tempfile::tempdir().map_err(failed)?;
    let saves = SavesDir::new(place.path());
    let untouched_mb = untouched(&saves)?;
    let (dir, store) = create(&saves)?;
    let seconds = WAY_S[usize::from(effort.quick)];
    let way = go(store, seconds)?;
    let disk_mb = size_mb(&dir);
    let case = format!("{seconds} s at sprint, view distance {VIEW_DISTANCE}");
    let mut rows = memory_rows(&way, &case);
    rows.extend(disk_rows(&way, &case, disk_mb, untouched_mb));
    Ok(Section::new(
        "terrain-memory",
        "Memory and disk",
        METHOD,
        [table("A long way in one direction", &rows, effort)],
    )
    .with([plot(&way)]))
}

fn memory_rows(way: &Way, case: &str) -> Vec<Row> {
    let most = way.memory.iter().map(|at| at.1).reduce(f64::max);
    vec![
        Row::new("memory, at most", case, most, "MB")
            .bar(Bar::AtMost(MEMORY_MB), Judged::InFull)
            .note(format!("{:.0} m in one direction", way.went_m)),
        Row::new(
            "memory's growth over the second half",
            case,
            growth_mb(&way.memory),
            "MB",
        )
        .bar(Bar::AtMost(GROWTH_MB), Judged::InFull),
    ]
}

fn disk_rows(way: &Way, case: &str, disk_mb: f64, untouched_mb: f64) -> Vec<Row> {
    let edited = way.edited as f64;
    let each_kb = (way.edited > 0).then(|| (disk_mb - untouched_mb).max(0.0) * 1e3 / edited);
    let row = |what: &str, case: &str, value: f64, most: f64| {
        Row::new(what, case, value, "MB").bar(Bar::AtMost(most), Judged::Always)
    };
    vec![
        row("world on the disk", case, disk_mb, DISK_MB),
        row(
            "untouched new world on the disk",
            "closed at once",
            untouched_mb,
            UNTOUCHED_MB,
        ),
        Row::new("an edited chunk on the disk", case, each_kb, "kB")
            .bar(Bar::AtMost(CHUNK_KB), Judged::InFull)
            .note(format!("{} chunks were edited", way.edited)),
    ]
}

/// How much the straight line through the second half of the points rises from its begin to its end.
fn growth_mb(memory: &[(f64, f64)]) -> Option<f64> {
    let half = &memory[memory.len() / 2..];
    let n = half.len() as f64;
    let ((first, _), (last, _)) = (half.first()?, half.last()?);
    let mean = |of: fn(&(f64, f64)) -> f64| half.iter().map(of).sum::<f64>() / n;
    let (x, y) = (mean(|at| at.0), mean(|at| at.1));
    let slope = |sum: (f64, f64), at: &(f64, f64)| {
        let dx = at.0 - x;
        (sum.0 + dx * (at.1 - y), sum.1 + dx * dx)
    };
    let (up, along) = half.iter().fold((0.0, 0.0), slope);
    (along > 0.0).then(|| up / along * (last - first))
}

fn create(saves: &SavesDir) -> Result<(std::path::PathBuf, Arc<WorldStore>), LabError> {
    let meta = setup(Geometry::Euclidean, VIEW_DISTANCE).to_meta();
    let made = saves.create(&meta);
    let (_, store) = made.map_err(|error| LabError::Scene(error.to_string()))?;
    Ok((store.dir().to_owned(), Arc::new(store)))
}

fn close(scene: Scene) -> Result<(), LabError> {
    scene
        .close()
        .map_err(|failure| LabError::Scene(failure.to_string()))
}

/// Size of a world that was opened, settled and closed.
fn untouched(saves: &SavesDir) -> Result<f64, LabError> {
    let (dir, store) = create(saves)?;
    let scene = open(Geometry::Euclidean, 1, Some(store))?;
    close(scene)?;
    let size = size_mb(&dir);
    let gone = std::fs::remove_dir_all(&dir);
    gone.map_err(|error| LabError::Scene(error.to_string()))?;
    Ok(size)
}

/// What a directory's files take, MB.
fn size_mb(dir: &Path) -> f64 {
    let Ok(entries) = std::fs::read_dir(dir) else {
        return f64::INFINITY;
    };
    let sizes = entries.filter_map(|entry| Some(entry.ok()?.metadata().ok()?.len()));
    sizes.sum::<u64>() as f64 / 1e6
}

/// Goes along the x axis at a walker's sprint, low over the ground, and digs now and then.
fn go(store: Arc<WorldStore>, seconds: usize) -> Result<Way, LabError> {
    let before_mb = resident_mb();
    let field = field(Geometry::Euclidean);
    let mut scene = open(Geometry::Euclidean, VIEW_DISTANCE, Some(store))?;
    let mut at = DVec3::new(0.0, 0.0, 16.0);
    at.y = field.surface_height(ChartId::FIRST, at.x, at.z) + ABOVE_M;
    scene.set_flying(true);
    scene.teleport(ChartPoint::a(at));
    scene.aim(0.0, -0.7);
    let mut way = Way {
        memory: Vec::new(),
        went_m: 0.0,
        edited: 0,
    };
    for second in 0..seconds {
        for step in 0..STEPS {
            let dig = second % DIG.1 == 0 && step < DIG.0;
            scene.step(&along(&scene, &field, dig));
            scene.pump(CHUNK_BUDGET);
            drop(scene.frame(FOV_Y_RAD, 16.0 / 9.0, 1));
        }
        if !scene.settle(PATIENCE) {
            return Err(LabError::Scene("the land was not made in time".to_owned()));
        }
        if second % LOOK_S == LOOK_S - 1 {
            let more = resident_mb()
                .zip(before_mb)
                .map(|(now, before)| now - before);
            way.memory.extend(more.map(|mb| (second as f64 + 1.0, mb)));
        }
    }
    way.went_m = scene.feet().pos.x - at.x;
    way.edited = scene.probe().chunks.edited;
    close(scene)?;
    Ok(way)
}

/// Straight on, up and down with the land.
fn along(scene: &Scene, field: &Field, dig: bool) -> Actions {
    let feet = scene.feet().pos;
    let ground =
        [0.0, 4.0].map(|ahead| field.surface_height(ChartId::FIRST, feet.x + ahead, feet.z));
    let over_m = feet.y - ground[0].max(ground[1]);
    Actions {
        forward: 1.0,
        jump: over_m < ABOVE_M - 0.5,
        sink: over_m > ABOVE_M + 0.5,
        primary: dig,
        ..Actions::default()
    }
}

fn plot(way: &Way) -> Plot {
    Plot::new(
        "terrain-memory",
        "Memory on a long way",
        Scale::Linear.axes("simulated time, s", "resident memory, MB"),
        [Series::line(
            "beyond what the program had before",
            way.memory.clone(),
        )],
    )
}

const METHOD: [&str; 3] = [
    "A player goes straight on for twenty simulated minutes at 8 m/s, a sprint, low over the ground, up and down with it, and digs for a third of a second every four. The world is kept on disk and saved as the game saves it. Simulated time does not wait for the clock, but each simulated second waits for all of its land, so everything that a slower machine would load is loaded.",
    "Memory is what the program holds resident beyond what it held before the world was opened; there is no adapter in it. Its growth is that of the straight line through the second half of the way: ten minutes, after ten in which the allocator fills what it keeps for its threads.",
    "On the disk are all files of the world's directory after it was closed. What an edited chunk takes is the difference to a world that nobody touched, by the number of chunks that were edited.",
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn growth_is_that_of_the_second_half_alone() {
        let at = |n: i32| {
            let x = f64::from(n);
            (
                x,
                if n < 50 {
                    10.0 * x
                } else {
                    500.0 + 0.1 * (x - 50.0)
                },
            )
        };
        let memory: Vec<_> = (0..100).map(at).collect();
        let growth = growth_mb(&memory).unwrap_or(f64::NAN);
        assert!((growth - 4.9).abs() < 1e-9, "{growth}");
        assert_eq!(growth_mb(&[]), None);
    }
}
