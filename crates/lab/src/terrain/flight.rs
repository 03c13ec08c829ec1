//! A flight over land that logs every frame: how the main thread spends each sixtieth of a second while the ground
//! streams in.

use std::fmt::Write;
use std::time::{Duration, Instant};

use antipode_geometry::{ChartId, ChartPoint, Geometry};
use antipode_scene::frame::LandCursor;
use antipode_scene::tuning::{FOV_Y_RAD, STEP_S};
use antipode_scene::{Actions, Scene};
use glam::DVec3;

use super::clock::{Spent, Spread, ThreadClock};
use super::control::Control;
use super::engine::{field, open};
use super::row::{Bar, Judged, Row, table};
use crate::{Effort, LabError, Plot, Scale, Section, Series};

/// Length of the flight, metres, and of a quick one.
const LENGTH_M: [f64; 2] = [2000.0, 72.0];
/// View distance in chunks.
const VIEW_DISTANCE: u32 = 6;
/// How far above the highest ground that there can be, metres.
const ABOVE_M: f64 = 4.0;
/// Where one looks, radians: along the land, a little down.
const PITCH_RAD: f64 = -0.25;
/// The view sweeps this far to either side, radians, once in this many seconds.
const SWEEP: (f64, f64) = (0.6, 8.0);
/// Most milliseconds of the main thread, 99 of 100 frames.
const MAIN_MS: f64 = 4.0;
/// Most that any frame may take of the middle one.
const TIMES: f64 = 3.0;
/// Frames before and after one that workers may have finished the same in.
const BESIDE: usize = 3;
/// A frame has waited for another thread if it was neither on a processor nor ready for one for so long, milliseconds.
const WAITED_MS: f64 = 1.0;
/// What a frame gives to finished chunks, as in the game.
const CHUNK_BUDGET: Duration = Duration::from_millis(2);
/// Longest wait for the first land.
const PATIENCE: Duration = Duration::from_mins(2);
/// The flight is given up when it takes this many times as long as it should.
const OVERDUE: f64 = 3.0;
/// Frames that each point of the plot stands for.
const PLOTTED: usize = 15;

/// One frame of the log.
#[derive(Clone, Copy, Debug, Default)]
struct Logged {
    /// When it began, seconds from the first.
    at_s: f64,
    /// Distance flown, metres.
    flown_m: f64,
    /// Step, taking in of chunks, and making of the frame.
    parts: [Spent; 3],
    /// Chunks with a surface, and work not finished.
    chunks: [usize; 2],
    /// Meshes that appeared, changed or went.
    changes: usize,
    /// The piece of arithmetic after the frame.
    control: Option<Spent>,
}

impl Logged {
    fn sum(&self, of: fn(&Spent) -> f64) -> f64 {
        self.parts.iter().map(of).sum()
    }

    fn own_ms(&self) -> f64 {
        self.sum(|spent| spent.own_ms)
    }
}

/// The section of the flight, and its log as CSV.
///
/// # Errors
/// When the world cannot be opened or its first land is not made.
pub fn section(effort: Effort) -> Result<(Section, String), LabError> {
    let length_m = LENGTH_M[usize::from(effort.quick)];
    let log = fly(length_m)?;
    let again = [fly(length_m)?, fly(length_m)?];
    let mut all = rows(&log, length_m);
    all.push(repeated_row([&log, &again[0], &again[1]], length_m));
    let section = Section::new(
        "terrain-flight",
        "A flight over land",
        METHOD,
        [table("The main thread, frame by frame", &all, effort)],
    )
    .with([plot(&log)]);
    Ok((section, csv(&log)))
}

fn rows(log: &[Logged], length_m: f64) -> Vec<Row> {
    let case = format!("{length_m:.0} m, view distance {VIEW_DISTANCE}");
    let mut rows = work_rows(log, &case);
    rows.extend(control_rows(log, &case));
    let between: Vec<f64> = log
        .windows(2)
        .map(|pair| 1e3 * (pair[1].at_s - pair[0].at_s))
        .collect();
    let between = Spread::of(&between);
    let flown_m = log.last().map_or(0.0, |frame| frame.flown_m);
    let due_s = log.len() as f64 * STEP_S;
    let pending = log.iter().map(|frame| frame.chunks[1]).max().unwrap_or(0);
    let between_row = "the longest time between two frames, times the median";
    rows.extend([
        Row::new(between_row, &case, between.max / between.p50, "")
            .bar(Bar::AtMost(TIMES), Judged::InFull)
            .note(format!(
                "median {:.1}, longest {:.1} ms",
                between.p50, between.max
            )),
        Row::new("distance flown", &case, flown_m, "m")
            .bar(Bar::AtLeast(length_m), Judged::InFull)
            .note(format!("in {due_s:.1} simulated seconds")),
        Row::new("chunks not there yet, at most", &case, pending as f64, ""),
    ]);
    rows
}

/// What the main thread did.
fn work_rows(log: &[Logged], case: &str) -> Vec<Row> {
    let spread = |of: fn(&Logged) -> f64| Spread::of(&log.iter().map(of).collect::<Vec<_>>());
    let own = spread(Logged::own_ms);
    let wall = spread(|frame| frame.sum(|spent| spent.wall_ms));
    let cpu = spread(|frame| frame.sum(|spent| spent.cpu_ms));
    let words = |spread: Spread| {
        let Spread { p50, p99, max } = spread;
        format!("p50 {p50:.3}, p99 {p99:.2}, most {max:.2} ms")
    };
    let part = |name: &str, of: fn(&Logged) -> f64| format!("{name}: {}", words(spread(of)));
    let row = |what: &str, value: f64| Row::new(what, case, value, "ms");
    let longer = log.iter().filter(|it| it.own_ms() > TIMES * own.p50);
    let waited = log.iter().filter(|it| {
        let cpu_ms = it.sum(|spent| spent.cpu_ms);
        it.own_ms() - cpu_ms > WAITED_MS
    });
    vec![
        row("main thread, p50", own.p50).note(part("step", |it| it.parts[0].own_ms)),
        row("main thread, p99", own.p99)
            .bar(Bar::AtMost(MAIN_MS), Judged::InFull)
            .note(part("taking in", |it| it.parts[1].own_ms)),
        row("main thread, the longest frame", own.max)
            .note(part("making", |it| it.parts[2].own_ms)),
        Row::new(
            "the longest frame, times the median",
            case,
            own.max / own.p50,
            "",
        )
        .bar(Bar::AtMost(TIMES), Judged::InFull)
        .note(format!(
            "{} of {} frames are longer",
            longer.count(),
            log.len()
        )),
        Row::new(
            "frames that waited for another thread",
            case,
            waited.count() as f64,
            "",
        )
        .note(format!("over {WAITED_MS} ms")),
        row("by the wall clock, p99", wall.p99).note(words(wall)),
        row("on the processor, p99", cpu.p99).note(words(cpu)),
    ]
}

/// How long the longest frame is that is long at the same place of every flight. A flight is the same each time but for when
/// workers finish, so a place has the longest of a few frames about it, and of the flights the least: what the game does
/// there it does each time, and what the machine does it does elsewhere.
fn repeated_row(flights: [&[Logged]; 3], length_m: f64) -> Row {
    let case = format!("{length_m:.0} m, view distance {VIEW_DISTANCE}");
    let times = flights.map(|log| {
        let own_ms: Vec<f64> = log.iter().map(Logged::own_ms).collect();
        let p50 = Spread::of(&own_ms).p50;
        own_ms.iter().map(|ms| ms / p50).collect::<Vec<_>>()
    });
    let about = |times: &[f64], n: usize| {
        let from = n.saturating_sub(BESIDE);
        let to = (n + BESIDE + 1).min(times.len());
        times[from..to].iter().copied().fold(0.0, f64::max)
    };
    let frames = times.iter().map(Vec::len).min().unwrap_or(0);
    let least = |n| {
        times
            .iter()
            .map(|it| about(it, n))
            .fold(f64::INFINITY, f64::min)
    };
    let longest = (0..frames).map(least).fold(0.0, f64::max);
    let [one, two, three] = times.each_ref().map(|it| Spread::of(it).max);
    let what = "the longest that is so in each of three flights, times the median";
    Row::new(what, &case, longest, "")
        .bar(Bar::AtMost(TIMES), Judged::InFull)
        .note(format!(
            "the longest of each: {one:.2}, {two:.2}, {three:.2}"
        ))
}

/// How evenly the machine runs a thread that does nothing but arithmetic.
fn control_rows(log: &[Logged], case: &str) -> [Row; 2] {
    let times: Vec<f64> = log
        .iter()
        .filter_map(|it| Some(it.control?.own_ms))
        .collect();
    let Spread { p50, p99, max } = Spread::of(&times);
    let longer = times.iter().filter(|&&ms| ms > TIMES * p50).count();
    let figure = |value: f64| (!times.is_empty()).then_some(value);
    let words = format!("p50 {p50:.3}, p99 {p99:.2}, most {max:.2} ms");
    let longest = "arithmetic alone, the longest, times the median";
    let over = format!("arithmetic alone, over {TIMES} times the median");
    [
        Row::new(longest, case, figure(max / p50), "").note(words),
        Row::new(&over, case, figure(longer as f64), "").note(format!("of {}", times.len())),
    ]
}

fn fly(length_m: f64) -> Result<Vec<Logged>, LabError> {
    let mut scene = open(Geometry::Euclidean, VIEW_DISTANCE, None)?;
    let field = field(Geometry::Euclidean);
    let (_, high_m) = field.ground_range_m();
    let start = DVec3::new(16.0, high_m + ABOVE_M, 16.0);
    scene.set_flying(true);
    scene.teleport(ChartPoint::new(ChartId::FIRST, start));
    scene.aim(0.0, PITCH_RAD);
    if !scene.settle(PATIENCE) {
        return Err(LabError::Scene(
            "the first land was not made in time".to_owned(),
        ));
    }
    // The land that is there already is not the flight's.
    let mut cursor = LandCursor::default();
    scene
        .frame(FOV_Y_RAD, 16.0 / 9.0, 1)
        .content
        .land
        .news(&mut cursor);
    let clock = ThreadClock::new();
    let mut log: Vec<Logged> = Vec::new();
    let mut control = Control::default();
    let began = Instant::now();
    let speed_m_s = fly_speed_m_s();
    let frames = (OVERDUE * length_m / speed_m_s / STEP_S) as usize;
    for n in 0..frames {
        let due = began + Duration::from_secs_f64(n as f64 * STEP_S);
        std::thread::sleep(due.saturating_duration_since(Instant::now()));
        let at_s = began.elapsed().as_secs_f64();
        let mut logged = frame(&mut scene, &mut cursor, &clock, n);
        logged.at_s = at_s;
        logged.control = control.run(&clock, logged.own_ms());
        logged.flown_m = (scene.feet().pos - start).length();
        let done = logged.flown_m >= length_m;
        log.push(logged);
        if done {
            break;
        }
    }
    Ok(log)
}

fn fly_speed_m_s() -> f64 {
    let tuning = antipode_physics::CharacterTuning::default();
    tuning.fly_speed_m_s * tuning.fly_sprint_factor
}

/// What the game does in a frame before anything is sent to the adapter.
fn frame(scene: &mut Scene, cursor: &mut LandCursor, clock: &ThreadClock, n: usize) -> Logged {
    let turn = |n: usize| {
        let (aside_rad, period_s) = SWEEP;
        aside_rad * (std::f64::consts::TAU * n as f64 * STEP_S / period_s).sin()
    };
    // Looks to the sides and goes straight on all the same.
    let yaw_rad = turn(n + 1);
    let actions = Actions {
        forward: yaw_rad.cos(),
        strafe: -yaw_rad.sin(),
        sprint: true,
        look_yaw: yaw_rad - turn(n),
        ..Actions::default()
    };
    let then = clock.now();
    scene.step(&actions);
    let step = clock.since(then);
    let then = clock.now();
    scene.pump(CHUNK_BUDGET);
    let take = clock.since(then);
    let then = clock.now();
    let made = scene.frame(FOV_Y_RAD, 16.0 / 9.0, 1);
    let news = made.content.land.news(cursor);
    let make = clock.since(then);
    let chunks = scene.probe().chunks;
    Logged {
        parts: [step, take, make],
        chunks: [chunks.resident, chunks.pending],
        changes: news.changes.len(),
        ..Logged::default()
    }
}

/// The whole log, one line a frame.
fn csv(log: &[Logged]) -> String {
    let mut out = "frame,at_s,flown_m,own_ms,wall_ms,cpu_ms,step_ms,take_in_ms,make_frame_ms,\
                   chunks,pending,changes,arithmetic_ms\n"
        .to_owned();
    for (n, frame) in log.iter().enumerate() {
        let [step, take, make] = frame.parts.map(|part| part.own_ms);
        let _ = writeln!(
            out,
            "{n},{:.3},{:.1},{:.3},{:.3},{:.3},{step:.3},{take:.3},{make:.3},{},{},{},{}",
            frame.at_s,
            frame.flown_m,
            frame.own_ms(),
            frame.sum(|spent| spent.wall_ms),
            frame.sum(|spent| spent.cpu_ms),
            frame.chunks[0],
            frame.chunks[1],
            frame.changes,
            frame
                .control
                .map_or(String::new(), |spent| format!("{:.3}", spent.own_ms)),
        );
    }
    out
}

fn plot(log: &[Logged]) -> Plot {
    let curve = |name: &str, of: fn(Spread) -> f64| {
        Series::line(
            name,
            log.chunks(PLOTTED).map(|frames| {
                let times: Vec<f64> = frames.iter().map(Logged::own_ms).collect();
                (frames[0].at_s, of(Spread::of(&times)))
            }),
        )
    };
    Plot::new(
        "terrain-flight",
        "The main thread on a flight over land, each quarter of a second",
        Scale::Linear.axes("time, s", "main thread in a frame, ms"),
        [
            curve("longest frame", |spread| spread.max),
            curve("median", |spread| spread.p50),
        ],
    )
}

const METHOD: [&str; 5] = [
    "A spectator flies straight on over flat-space land at 24 m/s, looking to the left and to the right, in real time: a frame begins every sixtieth of a second. Nothing is drawn, so a frame is what the main thread does for it before anything goes to an adapter: one step of the simulation, telling the workers what is wanted and taking in what is finished, and filling the frame's snapshot.",
    "Time is the thread's own: the wall clock's without the time in which the thread was ready to run and the system had given the core to another, since other programs run on the machine too; waiting for a lock or a channel counts. The wall clock and the time on the processor are shown beside it. The time between two frames is what a player would see: from the begin of one to the begin of the next, a sixtieth of a second unless the main thread took longer.",
    "After each frame but the first sixty the same thread runs a piece of pure arithmetic, always the same, that lasts about as long as the middle one of those sixty; it is timed by the same clock and counts in no frame. It waits for nobody and touches no memory: if its longest run is as many times its median as the longest frame, the machine under the program does it (a host that runs others meanwhile, interrupts, a changing clock rate), not the game; if it is even and the frames are not, look at the game first (caches that went cold while it slept can do that too).",
    "The flight is flown three times, and the rows but the last are of the first. The last asks whether a frame is long at the same place each time: a place has the longest of seven frames about it, since workers do not finish to the frame alike, and of the three flights the least. What the game does at a place it does in every flight.",
    "With --frame-log FILE the whole log of the first is written.",
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_log_has_a_line_for_each_frame_and_its_plot_the_longest_of_them() {
        let spent = |ms| Spent {
            wall_ms: ms,
            own_ms: ms,
            cpu_ms: ms,
        };
        let mut log = vec![
            Logged {
                parts: [spent(0.1), spent(0.2), spent(0.1)],
                ..Logged::default()
            };
            40
        ];
        log[20].parts[1] = spent(5.0);
        for (n, frame) in log.iter_mut().enumerate().skip(10) {
            frame.control = Some(spent(if n < 12 { 0.7 } else { 0.2 }));
        }
        let text = csv(&log);
        assert_eq!(text.lines().count(), 41);
        let columns = |line: &str| line.split(',').count();
        assert!(text.lines().all(|line| columns(line) == 13), "{text}");
        let plotted = plot(&log);
        assert_eq!(plotted.series[0].points.len(), 3);
        assert!((plotted.series[0].points[1].1 - 5.2).abs() < 1e-9);
        let rows = rows(&log, 10.0);
        let [longest, over] = control_rows(&log, "").map(|row| row.value());
        assert!(longest.is_some_and(|times| (times - 3.5).abs() < 1e-9));
        assert_eq!(over, Some(2.0), "runs over three times the median");
        assert_eq!(rows[3].met(), Some(false), "a frame of thirteen medians");
        assert_eq!(
            rows[1].met(),
            Some(false),
            "one of forty is in the last hundredth"
        );
    }
}
