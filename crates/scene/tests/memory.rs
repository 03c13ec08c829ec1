//! The memory of a long session at one place; alone in its program, so that nothing else is measured.
#![cfg(target_os = "linux")]
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "tests fail by panicking"
)]

#[path = "it/common/mod.rs"]
mod common;

use std::fs;

use antipode_geometry::Geometry;
use antipode_scene::{Actions, Scene};
use common::{scene, steps};

/// Resident memory of this program in MB.
fn resident_mb() -> f64 {
    let status = fs::read_to_string("/proc/self/status").unwrap();
    let line = status.lines().find(|line| line.starts_with("VmRSS:"));
    let kb = line.and_then(|line| line.split_whitespace().nth(1));
    kb.unwrap().parse::<f64>().unwrap() / 1000.0
}

fn build(scene: &mut Scene, seconds: usize) {
    let actions = Actions {
        secondary: true,
        brush_step: 9,
        ..Actions::default()
    };
    steps(scene, seconds * 60, &actions);
}

#[test]
fn building_in_one_place_for_twenty_seconds_takes_no_more_memory_than_for_five() {
    let mut scene = scene(Geometry::Euclidean);
    scene.aim(0.0, -0.5);
    build(&mut scene, 5);
    let early_mb = resident_mb();
    build(&mut scene, 15);
    let late_mb = resident_mb();
    // The brush is wide and every step makes some eight meshes anew: none of the old ones may be kept.
    assert!(
        late_mb < early_mb + 15.0,
        "from {early_mb} MB to {late_mb} MB"
    );
}
