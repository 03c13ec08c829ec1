//! Worlds for the tests of the scene.
#![allow(dead_code, reason = "a test with a program of its own uses a part")]

pub mod cars;
pub mod doors;
pub mod figures;
pub mod kept;
pub mod squares;
pub mod twins;

use std::time::Duration;

use antipode_geometry::Geometry;
use antipode_scene::{Actions, Scene, WorldSetup};

/// Far more than any test needs; it only ends a test that would hang.
pub const LIMIT: Duration = Duration::from_mins(2);

/// What a test world is.
pub fn setup(geometry: Geometry) -> WorldSetup {
    let radius_m = match geometry {
        Geometry::Euclidean | Geometry::Hyperbolic => 20.0,
        Geometry::Spherical => 32.0,
        Geometry::HyperbolicWorld => 60.305,
    };
    WorldSetup {
        name: "Test".to_owned(),
        seed: 3,
        geometry,
        radius_m,
        generator: antipode_scene::Generator::OneBiome,
        mode: antipode_scene::Mode::default(),
        view_distance: 2,
    }
}

/// A world that is not kept, its ground loaded.
pub fn scene(geometry: Geometry) -> Scene {
    opened(setup(geometry))
}

/// One in whose middle there is room for doors and paths, in a closed world, too: slopes are steeper there than in its charts.
pub fn roomy_scene(geometry: Geometry) -> Scene {
    let usual = setup(geometry);
    opened(WorldSetup {
        seed: if geometry == Geometry::Spherical {
            1
        } else {
            usual.seed
        },
        ..usual
    })
}

fn opened(setup: WorldSetup) -> Scene {
    let mut scene = Scene::open(setup, None).unwrap();
    assert!(scene.wait_for_step(LIMIT));
    scene
}

/// Steps as a script makes them.
pub fn steps(scene: &mut Scene, count: usize, actions: &Actions) {
    for _ in 0..count {
        scene.step(actions);
        assert!(scene.wait_for_step(LIMIT));
    }
}
