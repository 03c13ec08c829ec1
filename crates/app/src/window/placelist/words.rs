//! The lists of worlds and rooms, and what was done there, in words.

use antipode_language::{Texts, Value};
use antipode_rooms::RoomSummary;
use antipode_storage::WorldSummary;
use antipode_ui::{ToastKind, WorldRow};

use super::folder::{FolderProblem, Reason};
use super::news::News;
use super::shelf::{Kept, Shelf};
use super::work::Job;
use crate::dates::date;
use crate::wording;

/// The news in words, and of what kind they are; `known` are the places that are known.
pub fn news<S: Shelf>(texts: &Texts, news: &News, known: &[S::Kept]) -> (String, ToastKind) {
    let key = |what| [S::WORDS, "-", what].concat();
    let named = |what, name: &str| {
        let values = [("name", name.into())];
        let key = key(what);
        (texts.say_with(&key, &values), ToastKind::Info)
    };
    match news {
        News::Renamed(name) => named("renamed", name),
        News::Duplicated(name) => named("duplicated", name),
        News::Imported(name) => named("imported", name),
        News::Exported(file) => {
            let values = [("file", file.display().to_string().into())];
            let key = key("exported");
            (texts.say_with(&key, &values), ToastKind::Info)
        }
        News::Failed(failure) => {
            tracing::error!("{failure}");
            (S::failure(texts, failure, known), ToastKind::Problem)
        }
        News::Folder(problem) => {
            tracing::error!("{problem:?}");
            (folder(texts, problem), ToastKind::Problem)
        }
        News::ListDied => {
            let key = key("list-died");
            (texts.say(&key), ToastKind::Problem)
        }
        News::WorkDied => (texts.say("worlds-work-died"), ToastKind::Problem),
    }
}

fn folder(texts: &Texts, problem: &FolderProblem) -> String {
    let reason = match &problem.reason {
        Reason::NoProgram => texts.say("worlds-folder-no-program"),
        Reason::Refused => texts.say("worlds-folder-refused"),
        Reason::System(said) => said.clone(),
    };
    let values = [
        ("dir", problem.dir.display().to_string().into()),
        ("reason", reason.into()),
    ];
    texts.say_with("worlds-folder-failed", &values)
}

/// What is being done; none for what is over in a moment.
pub fn work(texts: &Texts, kind: &str, job: &Job) -> Option<String> {
    let key = match job {
        Job::Delete { .. } => "work-delete",
        Job::Rename { .. } => "work-rename",
        Job::Duplicate { .. } => "work-duplicate",
        Job::Export { .. } => "work-export",
        Job::Import { .. } => "work-import",
        Job::List | Job::LookAt { .. } | Job::FindArchives { .. } => return None,
    };
    let key = [kind, "-", key].concat();
    Some(texts.say(&key))
}

/// What a world's own records say of it.
pub fn world_row(texts: &Texts, world: &WorldSummary) -> WorldRow {
    let meta = world.meta.as_ref();
    let known = |words: &dyn Fn(&antipode_storage::WorldMeta) -> String| {
        meta.map_or_else(String::new, words)
    };
    WorldRow {
        slug: world.slug.clone(),
        name: world.shown(),
        full_name: world.name().to_owned(),
        geometry: known(&|meta| {
            let space = meta.geometry.parse();
            space.map_or_else(
                |_| meta.geometry.clone(),
                |space| wording::geometry(texts, space),
            )
        }),
        mode: if meta.is_some_and(|meta| meta.gathering) {
            texts.say("mode-gathering")
        } else {
            String::new()
        },
        played: known(&|meta| played(texts, meta.played_s)),
        last_played: known(&|meta| date(meta.last_played_unix_s)),
        size: size(texts, world.size_bytes),
        cheated: meta.is_some_and(|meta| meta.cheated),
        problem: wording::world_problem(texts, world),
        ..WorldRow::default()
    }
}

/// What a room's own text says of it.
pub fn room_row(texts: &Texts, room: &RoomSummary) -> WorldRow {
    let told = wording::room(texts, room);
    WorldRow {
        slug: Kept::slug(room),
        name: told.name,
        full_name: room.name.clone(),
        sentence: told.sentence,
        shipped: room.shipped,
        edits: Some(room.objects),
        problem: room.problem.clone(),
        ..WorldRow::default()
    }
}

/// A length of a file.
pub fn size(texts: &Texts, bytes: u64) -> String {
    if bytes < 100_000 {
        let kilobytes = Value::decimals((bytes as f64 / 1e3).ceil(), 0);
        return texts.say_with("worlds-size-small", &[("kilobytes", kilobytes)]);
    }
    let megabytes = Value::decimals(bytes as f64 / 1e6, 1);
    texts.say_with("worlds-size", &[("megabytes", megabytes)])
}

fn played(texts: &Texts, time_s: f64) -> String {
    let minutes = (time_s / 60.0).max(0.0) as u64;
    match minutes {
        0 => texts.say("worlds-played-briefly"),
        1..=89 => texts.say_with("worlds-played-minutes", &[("minutes", minutes.into())]),
        _ => {
            let values = [
                ("hours", (minutes / 60).into()),
                ("minutes", format!("{:02}", minutes % 60).into()),
            ];
            texts.say_with("worlds-played-hours", &values)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_files_are_told_in_kilobytes_and_large_ones_in_megabytes() {
        let texts = Texts::default();
        let said = |bytes| size(&texts, bytes).replace('\u{a0}', " ");
        let told = [1, 1_500, 99_000, 100_000, 2_340_000].map(said);
        assert_eq!(told, ["1 kB", "2 kB", "99 kB", "0.1 MB", "2.3 MB"]);
    }

    #[test]
    fn play_time_reads_like_a_person_says_it() {
        let texts = Texts::default();
        assert_eq!(played(&texts, 12.0), "under a minute");
        assert_eq!(played(&texts, 720.0), "12 min");
        assert_eq!(played(&texts, 7500.0), "2 h 05 min");
        assert_eq!(played(&texts, -5.0), "under a minute");
        assert_eq!(played(&texts, f64::NAN), "under a minute");
    }
}
