//! The rooms of the thesis look as expected, by the exact rule and by the thesis's own: `tests/scenes/rooms` has the script and
//! its pictures. `ANTIPODE_REMAKE_PICTURES=1` makes these anew.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use antipode_lab::gpu::suite::{MOST_STEPS, shots, worst};
use antipode_lab::gpu::{Block, difference};
use antipode_testing::may_skip;
use antipode_tests::program::run_with;
use image::RgbImage;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/rooms")
}

fn script() -> String {
    fs::read_to_string(folder().join("thesis.script")).unwrap()
}

fn picture(path: &Path) -> RgbImage {
    image::open(path).unwrap().to_rgb8()
}

/// What is wrong with a picture, whose actual and difference are then kept.
fn fault(name: &str, found: &RgbImage) -> Option<String> {
    let expected = picture(&folder().join(name));
    let Block { steps, at: (x, y) } = worst(name, found, &expected).unwrap();
    if steps <= MOST_STEPS {
        return None;
    }
    let kept = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let [actual, apart] =
        ["actual", "difference"].map(|what| kept.join(format!("{what}-room-{name}")));
    found.save(&actual).unwrap();
    difference(found, &expected).save(&apart).unwrap();
    Some(format!(
        "{name} is off by {steps:.1} steps at ({x}, {y}): see {} and {}",
        actual.display(),
        apart.display()
    ))
}

#[test]
fn the_rooms_of_the_thesis_look_as_expected() {
    let saves = tempfile::tempdir().unwrap();
    let options = ["--adapter", "software", "--size", "192x108"];
    let adapter = run_with(saves.path(), "room new\nshot probe.png", &options);
    if adapter.status != Some(0) && may_skip("a software adapter") {
        return;
    }
    let script = script();
    let run = run_with(saves.path(), &script, &options);
    assert_eq!(run.status, Some(0), "{}", run.stderr);
    let found = |name: &str| picture(&saves.path().join(name));
    if std::env::var_os("ANTIPODE_REMAKE_PICTURES").is_some() {
        for name in shots(&script) {
            found(name).save(folder().join(name)).unwrap();
        }
        return;
    }
    let faults: Vec<String> = shots(&script)
        .filter_map(|name| fault(name, &found(name)))
        .collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn each_expected_picture_of_a_room_is_taken_and_the_rules_differ_in_it() {
    let script = script();
    let taken: BTreeSet<String> = shots(&script).map(str::to_owned).collect();
    let there: BTreeSet<String> = fs::read_dir(folder())
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter(|name| Path::new(name).extension().is_some_and(|it| it == "png"))
        .collect();
    assert_eq!(taken, there);
    // A picture of one rule would be noticed if it were drawn by the other.
    for name in ["shorter", "longer", "narrower", "lower", "room"] {
        let [exact, legacy] = [format!("{name}.png"), format!("{name}-legacy.png")]
            .map(|it| picture(&folder().join(it)));
        let steps = worst(name, &legacy, &exact).unwrap().steps;
        assert!(steps > 4.0 * MOST_STEPS, "{name}: {steps}");
    }
}
