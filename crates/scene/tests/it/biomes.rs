//! Whoever comes into another biome is told its name once, and a world remembers what makes its land.

use antipode_geometry::{ChartId, ChartPoint, Geometry};
use antipode_scene::{Actions, Generator, Hint, NpcMode, Scene, SceneError, WorldSetup};
use antipode_storage::WorldMeta;
use glam::DVec3;

use crate::common::{LIMIT, setup, steps};

fn varied() -> Scene {
    let setup = WorldSetup {
        generator: Generator::Climates,
        mode: antipode_scene::Mode::default(),
        ..setup(Geometry::Euclidean)
    };
    let mut scene = Scene::open(setup, None).unwrap();
    scene.set_npcs(NpcMode::Off);
    scene.set_flying(true);
    assert!(scene.wait_for_step(LIMIT));
    scene
}

/// The biomes that were entered while so many steps pass.
fn entered(scene: &mut Scene, count: usize) -> Vec<&'static str> {
    steps(scene, count, &Actions::default());
    let name = |hint| match hint {
        Hint::Entered(name) => Some(name),
        _ => None,
    };
    scene.take_hints().into_iter().filter_map(name).collect()
}

#[test]
fn who_enters_a_biome_reads_its_name_once() {
    let mut scene = varied();
    let begun = scene.biome();
    assert!(entered(&mut scene, 90).is_empty(), "not where one begins");
    let place = |n: u32| DVec3::new(20.0 * f64::from(n), 70.0, 0.0);
    let is_other = |n: &u32| {
        let at = ChartPoint::new(ChartId::FIRST, place(*n));
        scene.field().biome_at(at).name() != begun
    };
    let other = place((1..200).find(is_other).unwrap());
    scene.teleport(ChartPoint::a(other));
    assert!(entered(&mut scene, 30).is_empty(), "not at once");
    let name = scene.biome();
    assert_eq!(scene.probe().biome, name);
    assert_eq!(entered(&mut scene, 60), [name]);
    assert!(entered(&mut scene, 90).is_empty(), "not again");
}

#[test]
fn who_enters_a_cave_reads_so() {
    let mut scene = varied();
    assert!(entered(&mut scene, 5).is_empty() && !scene.probe().terrain.cave);
    // Columns about the middle, until one runs through a cave in which there is room.
    let at = |n: u32| {
        let (x, z) = (
            f64::from(n % 100) * 3.0 - 150.0,
            f64::from(n / 100) * 3.0 - 150.0,
        );
        let top = scene.field().surface_height(ChartId::FIRST, x, z);
        let heights = (4..30).map(|down| DVec3::new(x, top - f64::from(down), z));
        heights.map(ChartPoint::a).find(|feet| {
            let is_free = |up: f64| scene.field().is_cave(feet.moved(DVec3::Y * up));
            [0.0, 1.0, 2.0].map(is_free) == [true; 3]
        })
    };
    let cave = (0..10_000).find_map(at).unwrap();
    scene.set_time_of_day_s(150.0);
    assert!(!scene.is_dark(), "under the sky at noon");
    scene.teleport(cave);
    assert_eq!(entered(&mut scene, 90), ["cave"]);
    assert!(scene.probe().terrain.cave && scene.is_dark());
}

#[test]
fn saves_tell_the_generator_and_unknown_ones_are_refused() {
    for generator in Generator::ALL {
        let setup = WorldSetup {
            generator,
            mode: antipode_scene::Mode::default(),
            ..setup(Geometry::Spherical)
        };
        let again = WorldSetup::from_meta(&setup.to_meta(), setup.view_distance).unwrap();
        assert_eq!(again, setup);
    }
    let old = WorldMeta {
        geometry: "euclidean".to_owned(),
        ..WorldMeta::default()
    };
    let old_setup = WorldSetup::from_meta(&old, 2).unwrap();
    assert_eq!(old_setup.generator, Generator::OneBiome);
    let later = WorldMeta {
        generator: 99,
        ..old
    };
    let refused = WorldSetup::from_meta(&later, 2);
    assert!(matches!(
        refused,
        Err(SceneError::UnknownGenerator { generator: 99, .. })
    ));
}
