//! Worlds in squares for tests, and ways through them.

use antipode_geometry::{ChartPoint, Eye, Geometry};
use antipode_scene::{Actions, Generator, NpcMode, Scene, WorldSetup};

use super::{LIMIT, setup, steps};

/// High over the land, where nothing is in the way, metres.
pub const HIGH_M: f64 = 40.0;

/// One of such a radius, without others than the player.
pub fn world(radius_m: f64) -> Scene {
    let setup = WorldSetup {
        generator: Generator::Planted,
        radius_m,
        ..setup(Geometry::HyperbolicWorld)
    };
    let mut scene = Scene::open_with(setup, None, 2).unwrap();
    assert!(scene.wait_for_step(LIMIT));
    scene.set_npcs(NpcMode::Off);
    scene
}

/// How far two places are apart on the plane, metres.
pub fn plane_m(scene: &Scene, a: ChartPoint, b: ChartPoint) -> f64 {
    let foot = |at: ChartPoint| ChartPoint::new(at.chart, at.pos.with_y(0.0));
    scene
        .strategy()
        .distance_m(foot(a), foot(b), &Eye::default())
}

/// Flies straight on for so many metres of the plane.
pub fn fly(scene: &mut Scene, way_m: f64) {
    let from = scene.feet();
    let ahead = |forward| Actions {
        forward,
        ..Actions::default()
    };
    while plane_m(scene, from, scene.feet()) < way_m - 1.0 {
        steps(scene, 1, &ahead(1.0));
    }
    // The last metre is gone ever slower.
    for _ in 0..600 {
        let left_m = way_m - plane_m(scene, from, scene.feet());
        let share = left_m.clamp(-0.2, 0.2);
        steps(scene, 1, &ahead(share));
    }
    let off_m = plane_m(scene, from, scene.feet()) - way_m;
    assert!(off_m.abs() < 0.01, "{off_m}");
}
