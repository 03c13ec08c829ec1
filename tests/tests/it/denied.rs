//! Folders that nobody may look into, and files longer than the disk: worlds are told apart from what is somebody
//! else's, and nothing of that is touched.
#![cfg(unix)]

use std::fs;
use std::path::Path;

use antipode_storage::{SavesDir, WorldMeta};
use antipode_tests::system::{give_away, permit, unprivileged};
use tempfile::TempDir;

/// A saves directory with the closed world First.
fn first() -> TempDir {
    let dir = tempfile::tempdir().unwrap();
    let meta = WorldMeta {
        name: "First".to_owned(),
        geometry: "euclidean".to_owned(),
        ..WorldMeta::default()
    };
    drop(SavesDir::new(dir.path()).create(&meta).unwrap());
    dir
}

/// What `antipode saves` says to a user whom permissions bind, and whether it has done what it should.
fn saves(dir: &Path, arguments: &[&str]) -> Option<(bool, String)> {
    let output = unprivileged(dir)?.arg("saves").args(arguments).output();
    let output = output.unwrap();
    let said = [output.stdout, output.stderr].concat();
    Some((output.status.success(), String::from_utf8(said).unwrap()))
}

#[test]
fn a_folder_that_nobody_may_look_into_is_listed_as_such_and_never_deleted() {
    let dir = first();
    for name in ["lost+found", "backup", "System Volume Information"] {
        fs::create_dir(dir.path().join(name)).unwrap();
        fs::write(dir.path().join(name).join("mine"), b"mine").unwrap();
    }
    give_away(dir.path());
    let folders = ["first", "lost+found", "backup", "System Volume Information"];
    let all = |mode: u32| {
        for folder in folders {
            permit(&dir.path().join(folder), mode);
        }
    };
    // Neither list nor search is allowed; writing is, so that it could be moved away.
    all(0o200);
    let Some((listed, said)) = saves(dir.path(), &["list"]) else {
        return;
    };
    assert!(
        listed && said.contains("first") && said.contains("permissions"),
        "{said}"
    );
    assert!(!said.contains("lost") && !said.contains("System"), "{said}");
    for folder in folders {
        let (deleted, said) = saves(dir.path(), &["delete", folder]).unwrap();
        assert!(!deleted, "{folder}: {said}");
        let known = ["first", "backup"].contains(&folder);
        let words = if known { "cannot be read" } else { "no world" };
        assert!(said.contains(words), "{folder}: {said}");
    }
    all(0o755);
    for folder in &folders[1..] {
        assert!(dir.path().join(folder).join("mine").exists(), "{folder}");
    }
    let (sound, said) = saves(dir.path(), &["verify", "First"]).unwrap();
    assert!(sound, "{said}");
}

#[test]
fn what_cannot_be_deleted_stays_where_it_was_and_is_told_by_its_folder() {
    let dir = first();
    let kept = dir.path().join("first/kept");
    fs::create_dir(&kept).unwrap();
    fs::write(kept.join("mine"), b"mine").unwrap();
    give_away(dir.path());
    permit(&kept, 0o555);
    let Some((deleted, said)) = saves(dir.path(), &["delete", "First"]) else {
        return;
    };
    let folder = dir.path().join("first");
    assert!(
        !deleted && said.contains(folder.to_str().unwrap()),
        "{said}"
    );
    assert!(!said.contains("/.antipode"), "{said}");
    assert!(kept.join("mine").exists());
    permit(&kept, 0o755);
}
