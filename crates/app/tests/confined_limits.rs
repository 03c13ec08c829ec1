//! The limits of the process that reads files of others, in the built program with its own allocator.
//!
//! A program of its own: the children that `program.rs` starts have, for a moment, the locks of all files that are open
//! in their parent.
#![cfg(target_os = "linux")]
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]

use std::fs::{self, File};
use std::process::Command;
use std::time::{Duration, Instant};

use antipode_storage::{SavesDir, WorldMeta};

/// What the system tells of a process in one of its files, by the beginning of the line.
fn told(process: &str, file: &str, line: &str) -> Option<u64> {
    let text = fs::read_to_string(format!("/proc/{process}/{file}")).ok()?;
    let rest = text.lines().find_map(|it| it.strip_prefix(line))?;
    rest.split_whitespace().next()?.parse().ok()
}

/// The child of a process that has taken its limits.
fn limited_child(parent: u32) -> Option<String> {
    let processes = fs::read_dir("/proc").unwrap().flatten();
    let mut names = processes.filter_map(|entry| entry.file_name().into_string().ok());
    names.find(|process| {
        told(process, "status", "PPid:") == Some(u64::from(parent))
            && told(process, "limits", "Max data size") == Some(512 << 20)
    })
}

#[test]
fn the_limit_on_memory_holds_for_what_the_allocator_took_before_it() {
    let dir = tempfile::tempdir().unwrap();
    let saves = SavesDir::new(dir.path().join("saves"));
    let meta = WorldMeta {
        name: "W".to_owned(),
        ..WorldMeta::default()
    };
    drop(saves.create(&meta).unwrap());
    let file = dir.path().join("w.antipode-world");
    saves.export("w", &file).unwrap();
    // Keeps the import waiting for its turn.
    let turn = File::open(saves.path().join(".antipode.lock")).unwrap();
    turn.lock().unwrap();
    let mut asking = Command::new(env!("CARGO_BIN_EXE_antipode"))
        .arg("--saves-dir")
        .arg(saves.path())
        .args(["saves", "import"])
        .arg(&file)
        .spawn()
        .unwrap();
    let began = Instant::now();
    let child = loop {
        match limited_child(asking.id()) {
            Some(child) => break child,
            None if began.elapsed() < Duration::from_secs(8) => {
                std::thread::sleep(Duration::from_millis(5));
            }
            None => panic!("no process has limits: {:?}", asking.wait()),
        }
    };
    let data_kib = told(&child, "status", "VmData:").unwrap();
    let cpu_s = told(&child, "limits", "Max cpu time").unwrap();
    drop(turn);
    assert!(asking.wait().unwrap().success());
    assert!(data_kib < 512 << 10, "{data_kib} KiB are taken already");
    assert_eq!(cpu_s, 61);
    assert_eq!(saves.list().unwrap().len(), 2);
}
