//! The menu's list of worlds, read in the background so that the menu never waits for the disk.

use std::collections::VecDeque;

use antipode_storage::{SavesDir, WorldSummary};
use antipode_ui::WorldRow;

use super::background::{Progress, Task};
use crate::failure::Failure;
use crate::session::Worlds;

/// What a piece of work on the saves came to: what went wrong with it, and the list afterwards.
type Reading = (Option<String>, Result<Vec<WorldSummary>, Failure>);

/// The worlds as last read.
#[derive(Debug)]
pub struct WorldList {
    worlds: Worlds,
    known: Vec<WorldSummary>,
    reading: Option<Task<Reading>>,
    again: bool,
    /// Worlds still to be deleted; they are not shown any more.
    doomed: VecDeque<String>,
    problems: VecDeque<String>,
}

impl WorldList {
    /// Nothing read yet.
    pub fn new(worlds: Worlds) -> Self {
        Self {
            worlds,
            known: Vec::new(),
            reading: None,
            again: false,
            doomed: VecDeque::new(),
            problems: VecDeque::new(),
        }
    }

    /// Asks for the list to be read anew.
    pub fn refresh(&mut self) {
        self.again = true;
        self.go_on();
    }

    /// Deletes a world and reads the list anew. A world that cannot be deleted comes back with it.
    pub fn delete(&mut self, slug: String) {
        self.known.retain(|world| world.slug != slug);
        self.doomed.push_back(slug);
        self.go_on();
    }

    /// Starts what is waiting, one piece of work at a time.
    fn go_on(&mut self) {
        if self.reading.is_some() {
            return;
        }
        let worlds = self.worlds.clone();
        if let Some(slug) = self.doomed.pop_front() {
            self.reading = Some(Task::start("delete", move || {
                let problem = worlds.saves().delete(&slug).err();
                (problem.map(|error| error.to_string()), worlds.list())
            }));
        } else if std::mem::take(&mut self.again) {
            self.reading = Some(Task::start("list", move || (None, worlds.list())));
        }
    }

    /// Takes a finished reading in. Never blocks.
    pub fn poll(&mut self) {
        let Some(task) = &self.reading else { return };
        match task.poll() {
            Progress::Running => return,
            Progress::Done((problem, list)) => {
                self.problems.extend(problem);
                match list {
                    Ok(mut worlds) => {
                        worlds.retain(|world| !self.doomed.contains(&world.slug));
                        self.known = worlds;
                    }
                    Err(failure) => self.problems.push_back(failure.to_string()),
                }
            }
            Progress::Died => self.problems.push_back(
                "The list of worlds could not be read; the log has the rest.".to_owned(),
            ),
        }
        self.reading = None;
        self.go_on();
    }

    /// Why the list could not be read or a world not be deleted; each is told once.
    pub fn take_problem(&mut self) -> Option<String> {
        self.problems.pop_front()
    }

    /// The rows the menu shows; `running` is the slug of the open world.
    pub fn rows(&self, running: Option<&str>) -> Vec<WorldRow> {
        self.known.iter().map(|world| row(world, running)).collect()
    }

    /// Whether a new world may have this name, as a sentence when not.
    ///
    /// # Errors
    /// The reason in words.
    pub fn check_name(&self, name: &str) -> Result<(), String> {
        let taken = self.known.iter().map(WorldSummary::name);
        SavesDir::check_name_among(name, taken).map_err(|error| error.to_string())
    }
}

fn row(world: &WorldSummary, running: Option<&str>) -> WorldRow {
    WorldRow {
        slug: world.slug.clone(),
        name: world.name().to_owned(),
        geometry: world
            .meta
            .as_ref()
            .map_or_else(String::new, |meta| meta.geometry.clone()),
        played: world
            .meta
            .as_ref()
            .map_or_else(String::new, |meta| played(meta.played_s)),
        last_played: world
            .meta
            .as_ref()
            .map_or_else(String::new, |meta| date(meta.last_played_unix_s)),
        size: format!("{:.1} MB", world.size_bytes as f64 / 1e6),
        problem: world.problem.clone(),
        running: running == Some(world.slug.as_str()),
    }
}

fn played(time_s: f64) -> String {
    let minutes = (time_s / 60.0).max(0.0) as u64;
    match minutes {
        0 => "under a minute".to_owned(),
        1..=89 => format!("{minutes} min"),
        _ => format!("{} h {:02} min", minutes / 60, minutes % 60),
    }
}

/// The day of a Unix time as year-month-day, UTC, by Howard Hinnant's `civil_from_days`.
fn date(unix_s: u64) -> String {
    let days = (unix_s / 86_400) as i64 + 719_468;
    let era = days.div_euclid(146_097);
    let day_of_era = days.rem_euclid(146_097);
    let year_of_era =
        (day_of_era - day_of_era / 1460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let shifted_month = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * shifted_month + 2) / 5 + 1;
    let month = if shifted_month < 10 {
        shifted_month + 3
    } else {
        shifted_month - 9
    };
    let year = year_of_era + era * 400 + i64::from(month <= 2);
    format!("{year:04}-{month:02}-{day:02}")
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

    use antipode_geometry::Geometry;
    use clap::Parser;

    use super::*;
    use crate::cli::Cli;
    use crate::session::NewWorld;

    /// A directory with the worlds a, b and c, and the list of them.
    fn three() -> (tempfile::TempDir, WorldList) {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().to_str().unwrap();
        let cli =
            Cli::try_parse_from(["antipode", "--saves-dir", path, "--view-distance", "1"]).unwrap();
        let worlds = Worlds::new(&cli.common);
        for name in ["a", "b", "c"] {
            let made = worlds.create(&NewWorld {
                geometry: Geometry::Euclidean,
                name: Some(name.to_owned()),
                seed: Some(1),
                radius_m: None,
            });
            made.unwrap().close().unwrap();
        }
        let mut list = WorldList::new(worlds);
        list.refresh();
        finish(&mut list);
        (dir, list)
    }

    fn finish(list: &mut WorldList) {
        while list.reading.is_some() {
            list.poll();
            std::thread::yield_now();
        }
    }

    fn names(list: &WorldList) -> Vec<String> {
        let mut names: Vec<_> = list.rows(None).into_iter().map(|row| row.name).collect();
        names.sort();
        names
    }

    #[test]
    fn a_world_that_cannot_be_deleted_comes_back_with_the_reason() {
        let (_dir, mut list) = three();
        let held = list.worlds.load("b").unwrap();
        list.delete("b".to_owned());
        list.delete("nowhere".to_owned());
        list.delete("c".to_owned());
        assert_eq!(names(&list), ["a"]);
        finish(&mut list);
        assert_eq!(names(&list), ["a", "b"]);
        assert!(
            list.take_problem()
                .is_some_and(|said| said.contains("in use"))
        );
        assert!(
            list.take_problem()
                .is_some_and(|said| said.contains("nowhere"))
        );
        assert_eq!(list.take_problem(), None);
        held.close().unwrap();
    }

    #[test]
    fn dates_are_right_over_leap_days_and_centuries() {
        assert_eq!(date(0), "1970-01-01");
        assert_eq!(date(951_782_400), "2000-02-29");
        assert_eq!(date(951_868_800), "2000-03-01");
        assert_eq!(date(1_798_761_599), "2026-12-31");
        assert_eq!(date(4_107_542_400), "2100-03-01");
    }

    #[test]
    fn play_time_reads_like_a_person_says_it() {
        assert_eq!(played(12.0), "under a minute");
        assert_eq!(played(720.0), "12 min");
        assert_eq!(played(7500.0), "2 h 05 min");
        assert_eq!(played(-5.0), "under a minute");
    }
}
