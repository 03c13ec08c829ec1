//! A directory with two worlds, and what is found in it.

use std::fs;
use std::path::Path;

use antipode_storage::SavesDir;
use tempfile::TempDir;

use super::{batch, key, meta, samples, state};

/// A directory with the worlds Foo, of four edited chunks and a picture, and Bar.
pub fn two() -> (TempDir, SavesDir) {
    let dir = tempfile::tempdir().unwrap();
    let saves = SavesDir::new(dir.path().join("saves"));
    let (_, world) = saves.create(&meta("Foo")).unwrap();
    world.commit(&batch(4, 3)).unwrap();
    world.write_thumbnail(b"png").unwrap();
    drop(world);
    drop(saves.create(&meta("Bar")).unwrap());
    (dir, saves)
}

pub fn names(saves: &SavesDir) -> Vec<String> {
    let worlds = saves.list().unwrap();
    let mut names: Vec<_> = worlds.iter().map(|world| world.name().to_owned()).collect();
    names.sort();
    names
}

/// Everything in a directory, hidden or not.
pub fn entries(dir: &Path) -> Vec<String> {
    let entries = fs::read_dir(dir).unwrap();
    let mut names: Vec<_> = entries
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        // The lock of the directory of worlds stays.
        .filter(|name| name != ".antipode.lock")
        .collect();
    names.sort();
    names
}

/// What Foo holds, wherever it is and whatever it is called.
pub fn assert_is_foo(saves: &SavesDir, slug: &str, name: &str) {
    let world = saves.open(slug).unwrap();
    assert_eq!(world.meta(), meta(name));
    assert_eq!(world.problems(), Vec::<String>::new());
    assert_eq!(world.state().unwrap(), Some(state(3.0)));
    for x in 0..4 {
        assert_eq!(world.chunk(&key(x)).unwrap(), Some(samples(x, 3)));
    }
    let picture = fs::read(saves.thumbnail_path(slug).unwrap()).unwrap();
    assert_eq!(picture, b"png");
    drop(world);
    assert!(saves.verify(slug).unwrap().is_sound());
}
