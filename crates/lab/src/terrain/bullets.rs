//! Bullets: as many as a world holds, kept in flight for ten minutes, and for one in the curved spaces.

use std::time::Duration;

use antipode_geometry::Geometry;
use antipode_scene::{Actions, Scene};
use antipode_timing::resident_mb;
use glam::DVec3;

use super::clock::{Spread, ThreadClock};
use super::engine::{name, open};
use super::row::{Bar, Judged, Row, table};
use crate::{Effort, LabError, SPACES, Section};

/// Bullets in flight.
const BULLETS: usize = 500;
/// Simulated seconds, and of a quick run.
const SECONDS: [usize; 2] = [600, 20];
/// Steps in a simulated second.
const STEPS: usize = 60;
/// Fastest that a bullet is thrown, metres a second, and how high over the player's feet.
const SPEED_M_S: f64 = 30.0;
const ABOVE_M: f64 = 4.0;
/// The golden angle: bullets go all ways, and no two the same.
const GOLDEN_RAD: f64 = 2.399_963_229_728_653;
/// What 99 of 100 steps and the longest may take at most: a quarter of a step and a whole one, ms.
const STEP_MS: [f64; 2] = [4.0, 1000.0 / 60.0];
/// Most that memory may grow over the second half, MB.
const GROWTH_MB: f64 = 10.0;
/// Longest wait for land.
const PATIENCE: Duration = Duration::from_mins(2);
/// View distance, chunks.
const VIEW_DISTANCE: u32 = 3;

/// The section of bullets.
///
/// # Errors
/// When a world cannot be opened or played.
pub fn section(effort: Effort) -> Result<Section, LabError> {
    let seconds = SECONDS[usize::from(effort.quick)];
    let mut rows = Vec::new();
    for geometry in SPACES {
        // Memory does not ask which space it is.
        let long = geometry == Geometry::Euclidean || effort.quick;
        rows.extend(rows_of(
            geometry,
            if long { seconds } else { seconds / 10 },
        )?);
    }
    Ok(Section::new(
        "terrain-bullets",
        "Bullets",
        METHOD,
        [table("500 bullets in flight", &rows, effort)],
    ))
}

fn rows_of(geometry: Geometry, seconds: usize) -> Result<Vec<Row>, LabError> {
    let mut scene = open(geometry, VIEW_DISTANCE, None)?;
    if !scene.settle(PATIENCE) {
        return Err(LabError::Scene("the land was not made in time".to_owned()));
    }
    // A spectator is not struck, and so does not die of it.
    scene.set_flying(true);
    let mut thrown = 0;
    let mut costs_ms = Vec::with_capacity(seconds * STEPS);
    let mut memory_mb = Vec::new();
    let mut fewest = usize::MAX;
    for second in 0..seconds {
        costs_ms.extend((0..STEPS).map(|_| {
            refill(&mut scene, &mut thrown);
            let clock = ThreadClock::new();
            let then = clock.now();
            scene.step(&Actions::default());
            clock.since(then).cpu_ms
        }));
        fewest = fewest.min(scene.projectiles().len());
        if second >= seconds / 2 {
            memory_mb.extend(resident_mb());
        }
    }
    let spread = Spread::of(&costs_ms);
    let case = format!("{}, {seconds} s", name(geometry));
    let growth_mb = memory_mb
        .last()
        .zip(memory_mb.first())
        .map(|(last, first)| last - first);
    let row = |what: &str, value: f64| Row::new(what, &case, Some(value), "ms");
    Ok(vec![
        row("a step, 99 of 100", spread.p99)
            .bar(Bar::AtMost(STEP_MS[0]), Judged::InFull)
            .note(format!(
                "median {:.3} ms, at least {fewest} in flight",
                spread.p50
            )),
        row("a step, the longest", spread.max).bar(Bar::AtMost(STEP_MS[1]), Judged::InFull),
        Row::new(
            "memory's growth over the second half",
            &case,
            growth_mb,
            "MB",
        )
        .bar(Bar::AtMost(GROWTH_MB), Judged::InFull),
    ])
}

/// Throws bullets from over the player until there are enough again; their ages differ, as those of many shots do.
fn refill(scene: &mut Scene, thrown: &mut u32) {
    let missing = BULLETS - scene.projectiles().len().min(BULLETS);
    let at_once = if *thrown < BULLETS as u32 { 2 } else { missing };
    for _ in 0..at_once.min(missing) {
        let angle = f64::from(*thrown) * GOLDEN_RAD;
        let share = (f64::from(*thrown) * 0.754_877_666).fract();
        let way = DVec3::new(angle.cos(), 0.6 * share, angle.sin());
        let from = scene.feet().moved(DVec3::Y * ABOVE_M + way);
        scene.throw_bullet(from, way * (SPEED_M_S * (0.3 + 0.7 * share)));
        *thrown += 1;
    }
}

const METHOD: [&str; 2] = [
    "Five hundred bullets, as many as a world holds at once, are kept in flight for ten simulated minutes, and for one in the curved spaces: whenever one is gone after its five seconds, another is thrown from over the player's head, each another way and at 9 to 30 m/s. They fall, bounce and slide on the land, and are tried against everybody who stands there.",
    "A step is all that the simulation does in a sixtieth of a second; its time is the main thread's own.",
];
