//! Many inputs for one target, in a process that is watched: what ends it, what takes
//! more than five seconds of the processor, what waits for a minute and what wants more
//! than 512 MB is a find like a broken promise, and the campaign goes on after it.
//!
//! An input follows from the seed and its number alone, so each can be made again.

use std::cell::RefCell;
use std::fs::{self, File};
use std::io::{BufRead, BufReader, Seek, Write};
use std::panic::{self, AssertUnwindSafe};
use std::path::Path;
use std::process::{Child, Stdio};
use std::thread;

use fastrand::Rng;

use crate::watch::{Ended, MOST_WAIT, bounded, watch};
use crate::world_folder::with_world_folder;
use crate::{Seen, Target};

/// After so many finds there is enough to do.
const MOST_FINDS: usize = 25;
/// What came of a campaign.
#[derive(Debug, Default)]
pub struct Report {
    /// Inputs that were tried.
    pub inputs: u64,
    /// Of those, how many had all their checksums right.
    pub past_checksums: u64,
    /// And how many were taken for what they claim to be.
    pub taken: u64,
    /// Panics of the embedded store that the game turned into sentences.
    pub caught: u64,
    /// What the slowest input took of the processor, milliseconds, and its number.
    pub slowest: (u64, u64),
    /// Most memory that the process had, bytes.
    pub peak_bytes: u64,
    /// What went wrong: the number of the input, and a sentence.
    pub finds: Vec<(u64, String)>,
}

/// An input of a campaign.
pub fn input(target: &Target, seeds: &[(String, Vec<u8>)], seed: u64, number: u64) -> Vec<u8> {
    if let Some((_, bytes)) = usize::try_from(number)
        .ok()
        .and_then(|number| seeds.get(number))
    {
        return bytes.clone();
    }
    let mut rng = Rng::with_seed(seed ^ number.wrapping_mul(0x9e37_79b9_7f4a_7c15));
    let from = &seeds[rng.usize(..seeds.len())].1;
    (target.mutate)(&mut rng, from)
}

/// Runs the inputs `0..count` in processes of `program`, which is `antipode-fuzzing`.
///
/// # Errors
/// When a process cannot be started or watched.
pub fn run(program: &Path, target: &Target, count: u64, seed: u64) -> Result<Report, String> {
    let scratch = tempfile::tempdir().map_err(|error| error.to_string())?;
    let progress = scratch.path().join("progress");
    let mut report = Report::default();
    let mut from = 0;
    while from < count && report.finds.len() < MOST_FINDS {
        fs::write(&progress, from.to_string()).map_err(|error| error.to_string())?;
        let mut child = begin(program, target, seed, from..count, &progress)?;
        let output = child.stdout.take().ok_or("the process has no output")?;
        let reader = thread::spawn(move || {
            let lines = BufReader::new(output).lines();
            lines.map_while(Result::ok).collect::<Vec<_>>()
        });
        let ended = watch(&mut child, &progress, MOST_WAIT)?;
        let lines = reader
            .join()
            .map_err(|_| "the reader of its output has died")?;
        for line in lines {
            report.take(&line);
        }
        let reached = report.take_in(&progress);
        match ended {
            Ended::Stopped(why) => report.finds.push((reached, why)),
            Ended::With(status) if !status.success() => {
                report
                    .finds
                    .push((reached, format!("the process ended: {status}")));
            }
            Ended::With(_) => {
                report.inputs = count;
                return Ok(report);
            }
        }
        from = reached + 1;
        report.inputs = from;
    }
    Ok(report)
}

fn begin(
    program: &Path,
    target: &Target,
    seed: u64,
    numbers: std::ops::Range<u64>,
    progress: &Path,
) -> Result<Child, String> {
    bounded(program)
        .args(["child", target.name])
        .args([seed, numbers.start, numbers.end].map(|number| number.to_string()))
        .arg(progress)
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .map_err(|error| format!("{} cannot be started: {error}", program.display()))
}

impl Report {
    /// Takes in a line of the process: `find NUMBER SENTENCE`.
    fn take(&mut self, line: &str) {
        if let Some((number, sentence)) = line
            .strip_prefix("find ")
            .and_then(|rest| rest.split_once(' '))
        {
            self.finds
                .push((number.parse().unwrap_or(0), sentence.to_owned()));
        }
    }

    /// Takes in what a process that has ended did; the number of the input that it was at.
    fn take_in(&mut self, progress: &Path) -> u64 {
        let text = fs::read_to_string(progress).unwrap_or_default();
        let numbers: Vec<u64> = text.split_whitespace().flat_map(str::parse).collect();
        if let [number, past, taken, caught, slowest_ms, slowest, peak] = numbers[..] {
            self.past_checksums += past;
            self.taken += taken;
            self.caught += caught;
            self.slowest = self.slowest.max((slowest_ms, slowest));
            self.peak_bytes = self.peak_bytes.max(peak);
            return number;
        }
        numbers.first().copied().unwrap_or(0)
    }
}

impl std::fmt::Display for Report {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let share = |part: u64| 100.0 * part as f64 / self.inputs.max(1) as f64;
        write!(
            f,
            "{} inputs, {:.1} % past the checksums, {:.1} % taken, {} finds, slowest {} ms (number {}), {} MB at most, {} panics of the store caught",
            self.inputs,
            share(self.past_checksums),
            share(self.taken),
            self.finds.len(),
            self.slowest.0,
            self.slowest.1,
            self.peak_bytes >> 20,
            self.caught,
        )?;
        for (number, sentence) in &self.finds {
            write!(f, "\n  number {number}: {sentence}")?;
        }
        Ok(())
    }
}

thread_local! {
    /// Panics that the game caught, and the words of the last that it did not.
    static PANICS: RefCell<(u64, String)> = const { RefCell::new((0, String::new())) };
}

/// The inputs of a process that is watched; what it has to say goes to standard output.
///
/// # Errors
/// When nobody can be told.
pub fn child(
    target: &Target,
    seed: u64,
    numbers: std::ops::Range<u64>,
    progress: &Path,
) -> Result<(), String> {
    listen_for_panics();
    let seeds = (target.seeds)();
    let progress = File::options()
        .write(true)
        .open(progress)
        .map_err(|error| error.to_string())?;
    let mut done = Done::default();
    for number in numbers.clone() {
        // In one call, so that the watching process reads all of the old line or of the new.
        done.write(&progress, number)
            .map_err(|error| error.to_string())?;
        let bytes = input(target, &seeds, seed, number);
        let before_ms = used_ms();
        let ran = panic::catch_unwind(AssertUnwindSafe(|| (target.run)(&bytes)));
        done.slowest = done.slowest.max((used_ms() - before_ms, number));
        match ran {
            Ok(Ok(seen)) => done.add(seen),
            Ok(Err(sentence)) => tell(&format!("find {number} {}", sentence.escape_debug())),
            Err(_) => {
                let words = PANICS.with_borrow(|panics| panics.1.clone());
                tell(&format!("find {number} panic: {}", words.escape_debug()));
            }
        }
    }
    done.peak = peak_bytes();
    done.write(&progress, numbers.end)
        .map_err(|error| error.to_string())
}

/// What a process has done so far.
#[derive(Default)]
struct Done {
    past: u64,
    taken: u64,
    slowest: (u64, u64),
    peak: u64,
}

impl Done {
    /// Asking the system for the peak takes longer than most inputs.
    const PEAK_EVERY: u64 = 64;

    fn add(&mut self, seen: Seen) {
        self.past += u64::from(seen.past_checksums);
        self.taken += u64::from(seen.taken);
    }

    fn write(&mut self, mut progress: &File, number: u64) -> std::io::Result<()> {
        if number.is_multiple_of(Self::PEAK_EVERY) {
            self.peak = peak_bytes();
        }
        let caught = PANICS.with_borrow(|panics| panics.0);
        let (slowest_ms, slowest) = self.slowest;
        let line = format!(
            "{number} {} {} {caught} {slowest_ms} {slowest} {}",
            self.past, self.taken, self.peak
        );
        progress.rewind()?;
        progress.write_all(format!("{line:150}").as_bytes())
    }
}

fn tell(line: &str) {
    let mut out = std::io::stdout();
    let _ = writeln!(out, "{line}").and_then(|()| out.flush());
}

/// Counts the panics that the game catches and keeps the words of others.
fn listen_for_panics() {
    // The game puts its own hook at its first use, and the last hook hears first.
    let _ = with_world_folder(|folder| {
        let dir = folder
            .plant_store(b"no store")
            .map_err(|error| error.to_string())?;
        drop(antipode_storage::WorldStore::open(&dir));
        Ok(())
    });
    panic::set_hook(Box::new(|info| {
        PANICS.with_borrow_mut(|panics| {
            if antipode_storage::is_guarded() {
                panics.0 += 1;
            } else {
                panics.1 = info.to_string();
            }
        });
    }));
}

/// What this thread has used of the processor, milliseconds.
fn used_ms() -> u64 {
    antipode_timing::thread_ran().map_or(0, |ran| ran.as_millis() as u64)
}

/// Most memory that this process had, bytes.
fn peak_bytes() -> u64 {
    let text = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = text.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let kib = line.and_then(|line| line.trim().trim_end_matches(" kB").parse::<u64>().ok());
    kib.unwrap_or(0) << 10
}
