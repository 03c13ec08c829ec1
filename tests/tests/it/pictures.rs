//! The scenes of `tests/scenes` look as expected: each script there takes pictures, and beside it lie those that it
//! should take. `ANTIPODE_REMAKE_PICTURES=1` makes these anew.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use antipode_testing::may_skip;
use antipode_tests::program::run_with;
use antipode_tests::seam::{Block, difference, picture, worst_block};
use image::RgbImage;
use image::codecs::png::{CompressionType, FilterType, PngEncoder};

const SOFTWARE: [&str; 2] = ["--adapter", "software"];
const SMALL: [&str; 4] = ["--size", "256x144", "--view-distance", "2"];
/// How far the mean of a block may be off, steps of 1/255.
const MOST_STEPS: f64 = 3.0;

fn scenes() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes")
}

fn script(space: &str) -> String {
    fs::read_to_string(scenes().join(format!("{space}.script"))).unwrap()
}

/// The pictures that a script takes, by their files' names.
fn shots(script: &str) -> impl Iterator<Item = &str> {
    script.lines().filter_map(|line| line.strip_prefix("shot "))
}

fn remake(name: &str, found: &RgbImage) {
    let file = fs::File::create(scenes().join(name)).unwrap();
    let encoder = PngEncoder::new_with_quality(file, CompressionType::Best, FilterType::Adaptive);
    found.write_with_encoder(encoder).unwrap();
}

/// What is wrong with a picture, whose actual and difference are then kept.
fn fault(name: &str, found: &RgbImage) -> Option<String> {
    let expected = picture(&scenes().join(name));
    let Block { steps, at: (x, y) } = worst_block(found, &expected);
    if steps <= MOST_STEPS {
        return None;
    }
    let kept = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let [actual, apart] = ["actual", "difference"].map(|what| kept.join(format!("{what}-{name}")));
    found.save(&actual).unwrap();
    difference(found, &expected).save(&apart).unwrap();
    Some(format!(
        "{name} is off by {steps:.1} steps at ({x}, {y}): see {} and {}",
        actual.display(),
        apart.display()
    ))
}

fn looks_as_expected(space: &str) {
    let saves = tempfile::tempdir().unwrap();
    let probe = [&SOFTWARE[..], &["--size", "64x64", "--view-distance", "1"]].concat();
    let adapter = run_with(saves.path(), "new euclidean\nshot probe.png", &probe);
    if adapter.status != Some(0) && may_skip("a software adapter") {
        return;
    }
    let script = script(space);
    let run = run_with(saves.path(), &script, &[&SOFTWARE[..], &SMALL].concat());
    assert_eq!(run.status, Some(0), "{}", run.stderr);
    let found = shots(&script).map(|name| (name, picture(&saves.path().join(name))));
    if std::env::var_os("ANTIPODE_REMAKE_PICTURES").is_some() {
        found.for_each(|(name, found)| remake(name, &found));
        return;
    }
    let faults: Vec<String> = found
        .filter_map(|(name, found)| fault(name, &found))
        .collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn the_flat_world_looks_as_expected() {
    looks_as_expected("euclidean");
}

#[test]
fn the_hyperbolic_world_looks_as_expected() {
    looks_as_expected("hyperbolic");
}

#[test]
fn the_closed_world_looks_as_expected() {
    looks_as_expected("spherical");
}

#[test]
fn each_expected_picture_is_taken_by_one_scene() {
    let scripts = ["euclidean", "hyperbolic", "spherical"].map(script);
    let taken: Vec<&str> = scripts.iter().flat_map(|script| shots(script)).collect();
    let there: BTreeSet<String> = fs::read_dir(scenes())
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter(|name| Path::new(name).extension().is_some_and(|it| it == "png"))
        .collect();
    assert_eq!(taken.len(), there.len(), "{there:?}");
    assert!(taken.iter().all(|name| there.contains(*name)), "{taken:?}");
}
