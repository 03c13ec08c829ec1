//! The other process, played by shells and by this test itself.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]

use std::process::Command;

use clap::Parser;

use antipode_storage::NameError;

use super::*;
use crate::cli::Cli;
use crate::saves_command::SavesAction;

fn task() -> Task {
    Task::Import {
        file: PathBuf::from("x.antipode-world"),
    }
}

fn answer(program: &str, arguments: &[&str], time: Duration) -> Result<Answer, Failure> {
    let mut command = Command::new(program);
    command.args(arguments);
    let limits = Limits {
        memory_bytes: 512 << 20,
        time,
    };
    answer_of(command, &task(), limits)
}

#[test]
fn the_hidden_command_is_what_is_started() {
    let repair = Task::Repair {
        slug: "--odd".to_owned(),
    };
    let room = Task::ImportRoom {
        file: PathBuf::from("x.antipode-room"),
    };
    let tasks = [
        ("some where", task()),
        ("-x", task()),
        ("--load=y", repair),
        ("z", room),
    ];
    for (place, task) in tasks {
        let saves = SavesDir::new(place);
        let all = std::iter::once(OsString::from("antipode")).chain(task.arguments(&saves));
        let cli = Cli::try_parse_from(all).unwrap();
        assert_eq!(cli.common.saves_dir.as_deref(), Some(saves.path()));
        let Some(crate::cli::Command::Saves {
            action: SavesAction::Confined { task: parsed },
        }) = cli.command
        else {
            panic!("{task:?}")
        };
        assert_eq!(format!("{parsed:?}"), format!("{task:?}"));
    }
}

#[test]
fn refusals_pass_from_one_process_to_the_other_as_they_are() {
    let path = PathBuf::from("saves/x");
    let errors = [
        StorageError::InUse {
            world: "W".to_owned(),
        },
        StorageError::Newer {
            world: "W".to_owned(),
            found: 99,
        },
        StorageError::NotADirectory { path: path.clone() },
        StorageError::Unsalvageable {
            path: path.clone(),
            reason: "why".to_owned(),
        },
        StorageError::NotFound {
            world: "W".to_owned(),
            dir: path.clone(),
        },
        StorageError::Archive {
            path: path.clone(),
            reason: "why".to_owned(),
        },
        StorageError::DiskFull {
            what: "the world".to_owned(),
        },
        StorageError::Busy { dir: path.clone() },
        StorageError::NotWritable { path: path.clone() },
        StorageError::NotReadable { path: path.clone() },
        StorageError::Exists { path: path.clone() },
        StorageError::Name(NameError::TooLong { chars: 99 }),
        StorageError::Io {
            action: "Reading".into(),
            path,
            source: std::io::ErrorKind::TimedOut.into(),
        },
    ];
    for error in errors {
        let sentence = error.to_string();
        let kind = std::mem::discriminant(&error);
        let sent = serde_json::to_string(&Answer::Refused(error)).unwrap();
        let Ok(Answer::Refused(received)) = serde_json::from_str(&sent) else {
            panic!("{sent}")
        };
        assert_eq!(std::mem::discriminant(&received), kind);
        assert_eq!(received.to_string(), sentence);
    }
}

#[cfg(unix)]
#[test]
fn a_refusal_of_a_path_that_is_no_text_is_told() {
    use std::os::unix::ffi::OsStringExt;
    let path = PathBuf::from(OsString::from_vec(b"saves/\xff.antipode-world".to_vec()));
    let error = StorageError::NotReadable { path };
    let sentence = error.to_string();
    let sent = serde_json::to_string(&Answer::Refused(error)).unwrap();
    let Ok(Answer::Refused(received)) = serde_json::from_str(&sent) else {
        panic!("{sent}")
    };
    assert_eq!(received.to_string(), sentence);
}

#[cfg(unix)]
#[test]
fn a_process_that_hangs_dies_or_talks_nonsense_is_a_sentence() {
    let long = Duration::from_mins(10);
    let hung = answer("sh", &["-c", "sleep 600"], Duration::ZERO)
        .unwrap_err()
        .to_string();
    assert!(
        hung.contains("x.antipode-world took more than 0 seconds"),
        "{hung}"
    );
    // It may have come to its end just before.
    assert!(!hung.contains("Nothing was changed"), "{hung}");
    for script in [
        "kill -SEGV $$",
        "kill -ABRT $$",
        "echo nonsense",
        "exit 0",
        "head -c 100000 /dev/zero",
    ] {
        let failed = answer("sh", &["-c", script], long).unwrap_err().to_string();
        assert!(
            failed.contains("Importing x.antipode-world failed: the file is damaged"),
            "{failed}"
        );
        assert!(!failed.contains("Nothing was changed"), "{failed}");
    }
    let none = answer("/no/such/program", &[], long)
        .unwrap_err()
        .to_string();
    assert!(none.contains("could not be started"), "{none}");
    let said = r#"echo '{"Imported":"kept"}'"#;
    assert!(
        matches!(answer("sh", &["-c", said], long), Ok(Answer::Imported(slug)) if slug == "kept")
    );
}

#[cfg(target_os = "linux")]
#[test]
fn what_is_known_of_an_end_is_told_and_no_sound_file_called_damaged() {
    let late = "took more than 600 seconds";
    let outside = "the system or somebody ended the work";
    for (script, words) in [
        ("exit 3", late),
        ("kill -XCPU $$", late),
        ("kill -KILL $$", outside),
        ("kill -TERM $$", outside),
        (
            "echo a warning >&2; echo 'antipode: there are no threads' >&2; exit 1",
            "Importing x.antipode-world failed: there are no threads",
        ),
        ("echo 'antipode: what is -x' >&2; exit 2", "what is -x"),
        (
            "echo 'memory allocation of 9 bytes failed' >&2; kill -ABRT $$",
            "more memory than it may have, at most 512 MB",
        ),
    ] {
        let failed = answer("sh", &["-c", script], Duration::from_mins(10))
            .unwrap_err()
            .to_string();
        assert!(
            failed.contains(words) && !failed.contains("damaged"),
            "{script}: {failed}"
        );
    }
}

#[test]
fn limits_follow_from_the_length_of_the_file() {
    let dir = tempfile::tempdir().unwrap();
    let saves = SavesDir::new(dir.path());
    let path = dir.path().join("w").join(WORLD_FILE);
    std::fs::create_dir(dir.path().join("w")).unwrap();
    let repair = Task::Repair {
        slug: "w".to_owned(),
    };
    let limits = |bytes: u64| {
        std::fs::File::create(&path)
            .unwrap()
            .set_len(bytes)
            .unwrap();
        let limits = repair.limits(&saves);
        (limits.memory_bytes >> 20, limits.time.as_secs())
    };
    assert_eq!(limits(0), (512, 60));
    assert_eq!(limits(100 << 20), (712, 110));
    assert_eq!(limits(10 << 30), (4096, 600));
    assert_eq!(
        Task::Import { file: path }.limits(&saves).memory_bytes >> 20,
        512
    );
}

#[test]
fn a_repair_that_takes_longer_than_it_may_is_stopped_and_said() {
    let dir = tempfile::tempdir().unwrap();
    let saves = SavesDir::new(dir.path());
    std::fs::create_dir(dir.path().join("w")).unwrap();
    // As long as a disk, of which nothing is a world.
    let file = std::fs::File::create(dir.path().join("w").join(WORLD_FILE)).unwrap();
    file.set_len(10 << 30).unwrap();
    let task = Task::Repair {
        slug: "w".to_owned(),
    };
    let limits = Limits {
        time: Duration::ZERO,
        ..task.limits(&saves)
    };
    let failed = answer_of(myself(&task, &saves).unwrap(), &task, limits);
    let failed = failed.unwrap_err().to_string();
    assert!(
        failed.contains("Repairing the world in w took more than 0 seconds"),
        "{failed}"
    );
}

/// Set for the child only.
#[cfg(target_os = "linux")]
const CHILD: &str = "ANTIPODE_TEST_HUNGRY_CHILD";

/// Not a test of its own: what the child process does.
#[cfg(target_os = "linux")]
#[test]
fn child_takes_more_than_it_may() {
    if std::env::var_os(CHILD).is_none() {
        return;
    }
    limit_memory(256 << 20).unwrap();
    let some = vec![1_u8; 64 << 20];
    let mut more = Vec::<u8>::new();
    assert!(more.try_reserve_exact(512 << 20).is_err());
    assert_eq!(some.len() >> 20, 64);
}

#[cfg(target_os = "linux")]
#[test]
fn memory_is_limited() {
    let output = Command::new(std::env::current_exe().unwrap())
        .args([
            "--exact",
            "confined::tests::child_takes_more_than_it_may",
            "--nocapture",
        ])
        .env(CHILD, "1")
        .output()
        .unwrap();
    let said = String::from_utf8(output.stdout).unwrap();
    assert!(said.contains("1 passed"), "{said}");
}

/// Not a test of its own: what the child process does.
#[cfg(target_os = "linux")]
#[test]
fn child_dies_of_what_it_may_not_have() {
    if std::env::var_os(CHILD).is_some() {
        limit_memory(256 << 20).unwrap();
        assert_eq!(vec![1_u8; 512 << 20].iter().max(), Some(&1));
    }
}

#[cfg(target_os = "linux")]
#[test]
fn who_dies_of_the_limit_on_memory_is_told_from_a_damaged_file() {
    let mut command = Command::new(std::env::current_exe().unwrap());
    command.args([
        "--exact",
        "confined::tests::child_dies_of_what_it_may_not_have",
        "--nocapture",
    ]);
    command.env(CHILD, "1");
    let limits = Limits {
        memory_bytes: 256 << 20,
        time: Duration::from_mins(10),
    };
    let failed = answer_of(command, &task(), limits).unwrap_err().to_string();
    assert!(
        failed.contains("needed more memory than it may have, at most 256 MB"),
        "{failed}"
    );
}

/// Set for the child only.
const ORPHAN: &str = "ANTIPODE_TEST_ORPHAN";

/// Not a test of its own: what the child process does.
#[test]
fn child_works_longer_than_it_may() {
    if std::env::var_os(ORPHAN).is_some() {
        end_after(Duration::from_millis(50)).unwrap();
        std::thread::sleep(Duration::from_secs(20));
    }
}

#[test]
fn a_process_that_nobody_waits_for_ends_with_its_time() {
    let output = Command::new(std::env::current_exe().unwrap())
        .args(["--exact", "confined::tests::child_works_longer_than_it_may"])
        .env(ORPHAN, "1")
        .output()
        .unwrap();
    let failed = process::End::of(Some(output.status), "")
        .told(&task(), task().limits(&SavesDir::new("x")))
        .to_string();
    assert!(failed.contains("took more than 60 seconds"), "{failed}");
}
