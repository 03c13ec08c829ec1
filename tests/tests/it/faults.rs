//! Everything that can go wrong round a save: a sentence for the player, and nothing lost that was safe.

use std::fs;
use std::path::Path;
use std::time::{SystemTime, UNIX_EPOCH};

use antipode_storage::{Batch, SCHEMA_VERSION, SavesDir, WORLD_FILE};
use antipode_tests::background::Background;
use antipode_tests::program::{comparable, field, number, run};
use tempfile::TempDir;

const DIG: &str = "aim 0 -60\ntap Digit4\nhold LEFT 0.5\nwait 1";

/// A saves directory with two dug worlds, First and Second.
fn two() -> TempDir {
    let saves = tempfile::tempdir().unwrap();
    for name in ["First", "Second"] {
        let made = run(
            saves.path(),
            &format!("new euclidean seed=5 name={name}\n{DIG}\nsave"),
        );
        assert_eq!(made.status, Some(0), "{}", made.stderr);
    }
    saves
}

/// A script that must fail with one line that says this.
fn fails(saves: &Path, script: &str, words: &[&str]) {
    let run = run(saves, script);
    assert_eq!(run.status, Some(1), "{}", run.stderr);
    let said = run.stderr.trim();
    assert_eq!(said.lines().count(), 1, "{said}");
    for words in words {
        assert!(said.contains(words), "{words}: {said}");
    }
}

#[test]
fn damaged_foreign_and_newer_saves_are_refused_in_words_and_the_others_go_on() {
    type Fault = fn(&mut Vec<u8>);
    let faults: [(&str, Fault, &str); 3] = [
        (
            "foreign",
            |bytes| *bytes = b"GIF89a and not a save at all".repeat(99),
            "saves repair",
        ),
        (
            "truncated",
            |bytes| bytes.truncate(bytes.len() / 3),
            "saves repair",
        ),
        ("empty", Vec::clear, "saves repair"),
    ];
    for (what, fault, words) in faults {
        let saves = two();
        let path = saves.path().join("first").join(WORLD_FILE);
        let mut bytes = fs::read(&path).unwrap();
        fault(&mut bytes);
        fs::write(&path, &bytes).unwrap();
        fails(saves.path(), "load First", &[words, "world.redb"]);
        assert_eq!(
            fs::read(&path).unwrap(),
            bytes,
            "{what}: a refused save is left as it is"
        );
        let other = run(saves.path(), "load Second\nprobe\nlist");
        assert!(number(other.probe(0), "chunks.edited") >= 1.0, "{what}");
        assert_eq!(other.lines[1].as_array().map(Vec::len), Some(2), "{what}");
    }
}

#[test]
fn a_save_of_a_newer_game_is_refused_and_not_touched() {
    let saves = two();
    let path = saves.path().join("first").join(WORLD_FILE);
    let mut bytes = fs::read(&path).unwrap();
    let changed = make_newer(&mut bytes);
    assert!(changed >= 3, "{changed} records");
    fs::write(&path, &bytes).unwrap();
    fails(
        saves.path(),
        "load First",
        &["\"First\"", "newer version of the game", "Update the game"],
    );
    assert_eq!(run(saves.path(), "load Second\nprobe").status, Some(0));
}

/// Gives every record in a store the next schema version, checksum and all; how many there were.
/// A record: version, mark `Ap`, kind, key length, body length, sequence, CRC-32 of the rest, key, body.
fn make_newer(bytes: &mut [u8]) -> usize {
    let mut changed = 0;
    for at in 0..bytes.len() - 22 {
        let version = u16::from_le_bytes([bytes[at], bytes[at + 1]]);
        if version != SCHEMA_VERSION || bytes[at + 2..at + 4] != *b"Ap" {
            continue;
        }
        let body = u32::from_le_bytes(bytes[at + 6..at + 10].try_into().unwrap()) as usize;
        let end = at + 22 + usize::from(bytes[at + 5]) + body;
        if end > bytes.len() {
            continue;
        }
        bytes[at..at + 2].copy_from_slice(&(version + 1).to_le_bytes());
        let mut sum = crc32fast::Hasher::new();
        sum.update(&bytes[at..at + 18]);
        sum.update(&bytes[at + 22..end]);
        bytes[at + 18..at + 22].copy_from_slice(&sum.finalize().to_le_bytes());
        changed += 1;
    }
    changed
}

#[test]
fn a_flipped_bit_costs_one_chunk_at_most_and_is_said() {
    let saves = two();
    let path = saves.path().join("first").join(WORLD_FILE);
    let good = fs::read(&path).unwrap();
    // One in every record of a chunk, behind its header and key.
    let mut bytes = good.clone();
    for at in 0..good.len() - 60 {
        if good[at + 2..at + 5] == *b"Ap\x03" {
            bytes[at + 22 + 13 + 4] ^= 1;
        }
    }
    assert_ne!(bytes, good);
    fs::write(&path, &bytes).unwrap();
    let run = run(saves.path(), "load First\nprobe\nwait 1\nprobe");
    assert!(field(run.probe(0), "player.pos").is_array());
    assert!(run.stderr.contains("damaged"), "{}", run.stderr);
}

#[test]
fn a_second_process_opens_nothing_and_the_lock_dies_with_the_first() {
    let saves = two();
    let mut first = Background::begin(saves.path(), "load First\nprobe\nwait 80000");
    let before = first.next_line().unwrap();
    fails(
        saves.path(),
        "load First",
        &["\"First\" is in use", "Close it there"],
    );
    fails(saves.path(), "delete First", &["in use"]);
    assert_eq!(run(saves.path(), "load Second\nprobe").status, Some(0));
    first.kill();
    let after = run(saves.path(), "load First\nprobe");
    assert!(number(after.probe(0), "t") >= number(&before, "t") - 5.0);
}

#[test]
fn a_save_folder_that_is_gone_while_playing_is_said_and_not_made_anew() {
    let saves = two();
    let mut playing = Background::begin(saves.path(), "load First\nprobe\nwait 60\nsave");
    playing.next_line().unwrap();
    // The game may be writing into it at this moment, and a folder that is not empty stays.
    let folder = saves.path().join("first");
    while folder.exists() {
        if let Err(e) = fs::remove_dir_all(&folder) {
            assert_eq!(e.kind(), std::io::ErrorKind::DirectoryNotEmpty, "{e}");
        }
    }
    let ended = playing.ended();
    assert_eq!(ended.status, Some(1), "{}", ended.stderr);
    assert!(ended.stderr.contains("is gone"), "{}", ended.stderr);
    assert!(!saves.path().join("first").exists());
}

#[test]
fn a_clock_set_back_loses_nothing() {
    let saves = two();
    let now = SystemTime::now()
        .duration_since(UNIX_EPOCH)
        .unwrap()
        .as_secs();
    let ten_years = 10 * 365 * 86_400;
    let worlds = SavesDir::new(saves.path());
    // Made and last played when the clock was ten years ahead.
    let world = worlds.open("first").unwrap();
    let mut meta = world.meta();
    meta.created_unix_s = now + ten_years;
    meta.last_played_unix_s = now + ten_years;
    world
        .commit(&Batch {
            meta: Some(meta),
            ..Batch::default()
        })
        .unwrap();
    drop(world);
    for file in fs::read_dir(saves.path().join("first")).unwrap() {
        let file = fs::File::options()
            .write(true)
            .open(file.unwrap().path())
            .unwrap();
        file.set_modified(UNIX_EPOCH + std::time::Duration::from_secs(now + ten_years))
            .unwrap();
    }
    let before = run(saves.path(), &format!("load First\n{DIG}\nprobe\nsave"));
    let after = run(saves.path(), "load First\nprobe\nlist");
    assert_eq!(comparable(before.probe(0)), comparable(after.probe(0)));
    assert_eq!(after.lines[1].as_array().map(Vec::len), Some(2));
    let meta = worlds.open("first").unwrap().meta();
    assert_eq!(meta.created_unix_s, now + ten_years);
    assert!(meta.played_s > 2.0, "{} s", meta.played_s);
}

#[cfg(unix)]
mod system {
    //! Faults that only the system can make.

    use std::os::unix::fs::chown;
    use std::process::Command;

    use antipode_tests::program::binary;
    use antipode_tests::system::{SmallDisk, give_away, is_root, permit, unprivileged};

    use super::*;

    /// A script without pictures, by a user whom permissions bind.
    fn as_nobody(saves: &Path, script: &str) -> Option<Background> {
        let mut command = unprivileged(saves)?;
        command.args(["script", "-", "--adapter", "none", "--view-distance", "1"]);
        Some(Background::begin_as(command, script))
    }

    /// The one line with which a script fails for want of permission; `None` where nobody can be denied.
    fn denied(saves: &Path, script: &str) -> Option<String> {
        let ended = as_nobody(saves, script)?.ended();
        assert_eq!(ended.status, Some(1), "{}", ended.stderr);
        assert_eq!(ended.stderr.trim().lines().count(), 1, "{}", ended.stderr);
        Some(ended.stderr)
    }

    #[test]
    fn without_permission_the_place_and_the_remedy_are_named() {
        let saves = two();
        let root = is_root();
        give_away(saves.path());
        let world = saves.path().join("first");
        // The whole directory of worlds: nothing new can be made in it.
        permit(saves.path(), 0o555);
        let Some(said) = denied(saves.path(), "new euclidean name=Third") else {
            return;
        };
        assert!(
            said.contains("cannot be written") && said.contains("--saves-dir"),
            "{said}"
        );
        permit(saves.path(), 0o000);
        let Some(said) = denied(saves.path(), "load First") else {
            return;
        };
        assert!(
            said.contains("cannot be read") && said.contains("permissions"),
            "{said}"
        );
        permit(saves.path(), 0o755);
        // The world's own file.
        permit(&world.join(WORLD_FILE), 0o444);
        let Some(said) = denied(saves.path(), "load First") else {
            return;
        };
        assert!(
            said.contains("cannot be written") && said.contains("world.redb"),
            "{said}"
        );
        permit(&world.join(WORLD_FILE), 0o644);
        if root {
            chown(saves.path(), Some(0), Some(0)).unwrap();
        }
        let again = run(saves.path(), "load First\nprobe");
        assert!(
            number(again.probe(0), "chunks.edited") >= 1.0,
            "nothing is lost by it"
        );
    }

    /// Writes until there is no room.
    fn fill(path: &Path) {
        use std::io::Write;
        let mut filler = fs::File::create(path).unwrap();
        while filler.write(&[7; 4096]).is_ok_and(|written| written > 0) {}
    }

    #[test]
    fn on_a_full_disk_the_last_save_stays_and_room_makes_it_go_on() {
        let Some(disk) = SmallDisk::new("size=6m") else {
            return;
        };
        let saves = disk.path();
        let made = run(
            saves,
            &format!("new euclidean seed=5 name=First\n{DIG}\nprobe\nsave"),
        );
        assert_eq!(made.status, Some(0), "{}", made.stderr);
        let filler = saves.join("filler");
        fill(&filler);
        // Digging in many places needs more pages than the file has free.
        let places = (0..40).map(|place| {
            let x = 40 * place;
            format!("teleport {x} 12 0\naim 0 -80\ntap Digit4\nhold LEFT 0.4\n")
        });
        let places: Vec<_> = places.collect();
        let dig = format!("load First\nset fly on\n{}", places.concat());
        let full = run(saves, &format!("{dig}save"));
        assert_eq!(full.status, Some(1), "{}", full.stderr);
        let last = full.stderr.trim().lines().last().unwrap_or_default();
        assert!(
            last.contains("no space left") && last.contains("Free some space"),
            "{last}"
        );
        fs::remove_file(&filler).unwrap();
        let kept = run(saves, "load First\nprobe");
        assert!(number(kept.probe(0), "chunks.edited") >= 1.0);
        let again = run(saves, &format!("load First\n{DIG}\nprobe\nsave"));
        assert!(number(again.probe(0), "t") > number(made.probe(0), "t"));
    }

    #[test]
    fn on_a_read_only_disk_worlds_are_listed_verified_and_exported_and_the_reason_is_said() {
        let Some(disk) = SmallDisk::new("size=16m") else {
            return;
        };
        let saves = disk.path();
        let made = run(saves, "new euclidean seed=5 name=First\nwait 1\nsave");
        assert_eq!(made.status, Some(0), "{}", made.stderr);
        let remounted = Command::new("mount")
            .args(["-o", "remount,ro"])
            .arg(saves)
            .status()
            .unwrap();
        assert!(remounted.success());
        // The program's own directory would be the read-only one.
        let command = || {
            let mut command = Command::new(binary());
            command
                .env_remove("ANTIPODE_SAVES")
                .current_dir("/")
                .arg("--saves-dir")
                .arg(saves);
            command
        };
        let listed = command().args(["saves", "list"]).output().unwrap();
        assert!(String::from_utf8_lossy(&listed.stdout).contains("First"));
        // Elsewhere there is room, and nothing has to be written here to get there.
        let elsewhere = tempfile::tempdir().unwrap();
        let file = elsewhere.path().join("first.antipode-world");
        for (arguments, words) in [
            (&["verify", "First"][..], "are whole"),
            (&["info", "First"], "First"),
            (&["export", "First", file.to_str().unwrap()], "is written"),
        ] {
            let output = command().arg("saves").args(arguments).output().unwrap();
            let said = String::from_utf8_lossy(&output.stdout);
            let mistake = String::from_utf8_lossy(&output.stderr);
            assert!(
                output.status.success() && said.contains(words) && mistake.is_empty(),
                "{arguments:?}: {said} {mistake}"
            );
        }
        let imported = SavesDir::new(elsewhere.path()).import(&file).unwrap();
        assert_eq!(imported, "first");
        for script in ["load First", "new euclidean name=Second"] {
            let mut command = command();
            command.args(["script", "-", "--adapter", "none"]);
            let ended = Background::begin_as(command, script).ended();
            assert_eq!(ended.status, Some(1), "{script}: {}", ended.stderr);
            assert!(
                ended.stderr.contains("read-only"),
                "{script}: {}",
                ended.stderr
            );
        }
    }
}
