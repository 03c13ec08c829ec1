//! Over the equator of a spherical world nothing may show: pictures just before and just after, and while walking.

use std::f64::consts::PI;
use std::fmt::Write;
use std::path::Path;

use antipode_testing::may_skip;
use antipode_tests::program::{number, run, run_with};
use antipode_tests::seam::{compare, picture};

const RADIUS_M: f64 = 32.0;
/// The line is left this far beyond the equator, so that a body standing on it does not flip.
const HYSTERESIS_M: f64 = 0.2;
const EYE_M: f64 = 1.62;
const WORLD: &str = "new spherical seed=4 radius=32 generator=1";

/// Whether there is an adapter to draw with; the first picture tells.
fn no_adapter(saves: &Path) -> bool {
    let probe = run_with(
        saves,
        &format!("{WORLD}\nshot probe.png"),
        &["--size", "64x64", "--view-distance", "1"],
    );
    probe.status != Some(0) && may_skip(&format!("a graphics adapter ({})", probe.stderr.trim()))
}

/// The point at chart distance `r` from the centre of A along the angle `phi`, and the same point told from B.
fn both_sides(r: f64, phi: f64) -> ((f64, f64), (f64, f64)) {
    let beyond = PI * RADIUS_M - r;
    (
        (r * phi.cos(), r * phi.sin()),
        (-beyond * phi.cos(), beyond * phi.sin()),
    )
}

#[test]
fn the_picture_does_not_change_over_the_equator() {
    let saves = tempfile::tempdir().unwrap();
    if no_adapter(saves.path()) {
        return;
    }
    let phi: f64 = 0.6;
    let line = PI / 2.0 * RADIUS_M + HYSTERESIS_M;
    let ((ax, az), _) = both_sides(line - 1e-4, phi);
    let (_, (bx, bz)) = both_sides(line + 1e-4, phi);
    let ground = run(
        saves.path(),
        &format!("{WORLD}\nset fly on\nteleport {ax} 30 {az}\nprobe"),
    );
    let ground = number(ground.probe(0), "terrain.ground_height");
    let mut script = format!("{WORLD}\nsettle\nset fly on\ntap F1\ntap Digit1\n");
    let mut pairs = Vec::new();
    for eye in [1.7, 5.0] {
        for pitch in [-60, 0, 60] {
            for yaw in [20.0, 200.0] {
                let feet = ground + eye - EYE_M;
                let name = format!("{eye}_{pitch}_{yaw}");
                let turned = yaw - (2.0 * phi).to_degrees();
                write!(
                    script,
                    "teleport {ax} {feet} {az} A\naim {yaw} {pitch}\nshot a_{name}.png\n"
                )
                .unwrap();
                write!(
                    script,
                    "teleport {bx} {feet} {bz} B\naim {turned} {pitch}\nshot b_{name}.png\n"
                )
                .unwrap();
                pairs.push(name);
            }
        }
    }
    let run = run_with(saves.path(), &script, &["--size", "640x360"]);
    assert_eq!(run.status, Some(0), "{}", run.stderr);
    for name in pairs {
        let a = picture(&saves.path().join(format!("a_{name}.png")));
        let b = picture(&saves.path().join(format!("b_{name}.png")));
        assert!(
            antipode_tests::seam::colours(&a) > 100,
            "{name} shows nothing"
        );
        let difference = compare(&a, &b);
        assert!(
            difference.mean <= 1.0 && difference.far_off <= 0.001,
            "{name}: {difference:?}"
        );
    }
}

#[test]
fn walking_over_the_equator_shows_no_jump() {
    let saves = tempfile::tempdir().unwrap();
    if no_adapter(saves.path()) {
        return;
    }
    let start = PI / 2.0 * RADIUS_M - 2.0;
    let mut script = format!(
        "{WORLD}\nsettle\ntap F1\ntap Digit1\nset fly on\nteleport {start} 30 0\nprobe\nset fly off\nteleport {start} 22 0\n\
         wait 3\naim 0 -10\ndown KeyW\n"
    );
    for n in 0..75 {
        writeln!(script, "wait 0.0166667\nprobe\nshot walk_{n}.png").unwrap();
    }
    let run = run_with(saves.path(), &script, &["--size", "320x180"]);
    let sides: Vec<_> = (1..=75)
        .map(|n| run.probe(n)["player"]["hemisphere"].clone())
        .collect();
    let crossing = sides
        .iter()
        .position(|side| side == "B")
        .expect("the walk crosses the equator");
    let pictures: Vec<_> = (0..75)
        .map(|n| picture(&saves.path().join(format!("walk_{n}.png"))))
        .collect();
    let changes: Vec<f64> = pictures
        .windows(2)
        .map(|w| compare(&w[0], &w[1]).mean)
        .collect();
    let from = crossing.saturating_sub(30);
    let mut around: Vec<f64> = changes[from..(crossing + 30).min(changes.len())].to_vec();
    around.sort_by(f64::total_cmp);
    let median = around[around.len() / 2];
    let at_crossing = changes[crossing - 1];
    assert!(
        at_crossing <= 1.2 * median,
        "the crossing frame changes by {at_crossing}, the median is {median}"
    );
    assert!(median > 0.0, "the walk does not move");
}
