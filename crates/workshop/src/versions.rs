//! Older versions of a room: files beside its journal, each called by its time, fewer the older they are.
//!
//! The ten newest are kept as they come, 30 s apart; of older ones the last of each ten minutes, ten of these; and the last of
//! each day, for thirty days. The last of a span of time that is over stays the last of it, so what is kept once for a span is
//! kept until the span is too old.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use antipode_rooms::bounds::MOST_ROOM_BYTES;
use antipode_rooms::{Room, RoomError, read_so_far};

use crate::error::WorkshopError;
use crate::journal::{VERSIONS, in_folder};

const NEWEST: usize = 10;
const SPANS: usize = 10;
const SPAN_S: u64 = 600;
const DAYS: usize = 30;
const DAY_S: u64 = 86_400;
const ENDING: &str = "ron";

/// An older version of a room.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Version {
    /// When it was written, seconds since 1970 in UTC. No two of a room have the same.
    pub when_s: u64,
}

/// Which of these times are kept.
pub(crate) fn kept(times: &BTreeSet<u64>) -> BTreeSet<u64> {
    let newest = || times.iter().rev().copied();
    let mut kept: BTreeSet<u64> = newest().take(NEWEST).collect();
    let mut last_of = |span_s: u64, count: usize| {
        let mut spans = BTreeSet::new();
        for time in newest() {
            let is_last = spans.insert(time / span_s);
            if spans.len() > count {
                break;
            }
            if is_last {
                kept.insert(time);
            }
        }
    };
    last_of(SPAN_S, SPANS);
    last_of(DAY_S, DAYS);
    kept
}

fn path_of(dir: &Path, when_s: u64) -> PathBuf {
    in_folder(dir, VERSIONS).join(format!("{when_s}.{ENDING}"))
}

/// The versions of the room in a folder, the newest first.
pub fn versions(dir: &Path) -> Vec<Version> {
    let times = times(dir);
    times
        .into_iter()
        .rev()
        .map(|when_s| Version { when_s })
        .collect()
}

fn times(dir: &Path) -> BTreeSet<u64> {
    let Ok(entries) = std::fs::read_dir(in_folder(dir, VERSIONS)) else {
        return BTreeSet::new();
    };
    let names = entries
        .flatten()
        .filter_map(|it| it.file_name().into_string().ok());
    names
        .filter_map(|name| {
            let (stem, ending) = name.split_once('.')?;
            let when_s = stem.parse().ok()?;
            // As this module writes it, and no other file that may lie there.
            (ending == ENDING && format!("{when_s}") == stem).then_some(when_s)
        })
        .collect()
}

/// Reads an older version of the room in a folder.
///
/// # Errors
/// [`WorkshopError::NoVersion`] if it is not there any more, or why it cannot be read.
pub fn read_version(dir: &Path, version: Version) -> Result<Room, WorkshopError> {
    let path = path_of(dir, version.when_s);
    let bytes = match antipode_storage::read_file(&path, MOST_ROOM_BYTES) {
        Ok(bytes) => bytes,
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => {
            return Err(WorkshopError::NoVersion(version.when_s.to_string()));
        }
        Err(error) => {
            let reason = error.to_string();
            return Err(RoomError::File { path, reason }.into());
        }
    };
    Ok(read_so_far(&path.display().to_string(), &bytes)?)
}

/// Writes a version of that time, unless there is one, and removes those that are not kept any more.
pub(crate) fn write_version(dir: &Path, when_s: u64, text: &str) -> Result<(), WorkshopError> {
    let path = path_of(dir, when_s);
    if std::fs::symlink_metadata(&path).is_err() {
        antipode_storage::replace_file(&path, text.as_bytes())?;
    }
    let all = times(dir);
    for old in all.difference(&kept(&all)) {
        // What cannot be removed now is tried again with the next.
        let _ = std::fs::remove_file(path_of(dir, *old));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn versions_grow_sparser_with_age_and_the_day_before_stays() {
        let start = 20_000 * DAY_S;
        let mut all = BTreeSet::new();
        // Ten hours a day for forty days, one version each 30 s.
        for day in 0..40 {
            for half_minute in 0..1200 {
                all.insert(start + day * DAY_S + 8 * 3600 + half_minute * 30);
                all = kept(&all);
            }
        }
        let now = start + 39 * DAY_S + 8 * 3600 + 1199 * 30;
        let within = |from: u64, to: u64| {
            all.iter()
                .filter(|it| (from..=to).contains(&(now - **it)))
                .count()
        };
        assert_eq!(within(0, 9 * 30), 10, "the newest");
        assert!(
            (17..=20).contains(&within(0, 10 * SPAN_S)),
            "{}",
            within(0, 10 * SPAN_S)
        );
        let days: BTreeSet<_> = all.iter().map(|it| it / DAY_S).collect();
        assert_eq!(days.len(), 30);
        assert!(all.len() <= NEWEST + SPANS + DAYS, "{}", all.len());
    }
}
