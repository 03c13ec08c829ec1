//! The scenes of `tests/scenes` look as expected: each script there takes pictures, and beside it lie those that it
//! should take. `ANTIPODE_REMAKE_PICTURES=1` makes these anew.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

use antipode_lab::gpu::suite::{MOST_STEPS, SCENES, Shot, Suite, shots, worst};
use antipode_lab::gpu::{Block, difference};
use antipode_render::AdapterChoice;
use antipode_testing::may_skip;
use antipode_tests::program::{binary, run_with};

fn scenes() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes")
}

fn suite() -> Suite {
    Suite {
        game: binary(),
        scenes: scenes(),
        adapter: AdapterChoice::Software,
        patience: Duration::from_mins(10),
    }
}

/// What is wrong with a picture, whose actual and difference are then kept.
fn fault(Shot { name, found }: &Shot) -> Option<String> {
    let expected = suite().expected(name).unwrap();
    let Block { steps, at: (x, y) } = worst(name, found, &expected).unwrap();
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
    let probe = [
        "--adapter",
        "software",
        "--size",
        "64x64",
        "--view-distance",
        "1",
    ];
    let adapter = run_with(saves.path(), "new euclidean\nshot probe.png", &probe);
    if adapter.status != Some(0) && may_skip("a software adapter") {
        return;
    }
    let played = suite().play(space, saves.path()).unwrap();
    if std::env::var_os("ANTIPODE_REMAKE_PICTURES").is_some() {
        let remake = |shot: &Shot| suite().expect(&shot.name, &shot.found).unwrap();
        played.shots.iter().for_each(remake);
        return;
    }
    let faults: Vec<String> = played.shots.iter().filter_map(fault).collect();
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
    let scripts = SCENES.map(|scene| suite().script(scene).unwrap());
    let taken: Vec<&str> = scripts.iter().flat_map(|script| shots(script)).collect();
    let there: BTreeSet<String> = fs::read_dir(scenes())
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter(|name| Path::new(name).extension().is_some_and(|it| it == "png"))
        .collect();
    assert_eq!(taken.len(), there.len(), "{there:?}");
    assert!(taken.iter().all(|name| there.contains(*name)), "{taken:?}");
}
