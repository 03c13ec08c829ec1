//! The list of sources that coverage is asked of is whole.

use super::coverage::SOURCES;
use super::{hyperbolic_world, tiling};

#[test]
fn every_source_file_is_looked_at() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut folders = vec![root];
    let mut files = 0;
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            if path.is_dir() {
                folders.push(path);
            // Lists of modules hold no functions.
            } else if name != "lib.rs" && name != "mod.rs" {
                files += 1;
            }
        }
    }
    assert_eq!(
        files,
        SOURCES.len() + tiling::SOURCES.len() + hyperbolic_world::SOURCES.len(),
        "a file of src is missing from the list"
    );
}
