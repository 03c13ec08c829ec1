//! The way home round a closed world: where it leads, and that the first time is told once.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use crate::common::{LIMIT, setup, steps};
use antipode_geometry::{ChartPoint, Eye, Geometry};
use antipode_scene::{Actions, Hint, NpcMode, Scene, WorldSetup};
use antipode_storage::WorldStore;
use glam::DVec3;

const RADIUS_M: f64 = 16.0;
/// Round the world, metres.
const ROUND_M: f64 = TAU * RADIUS_M;
/// How far from the middle the walks begin, as a share of the way to the equator.
const OFF_MIDDLE: f64 = 0.4;

fn small() -> WorldSetup {
    WorldSetup {
        radius_m: RADIUS_M,
        ..setup(Geometry::Spherical)
    }
}

/// A spectator clear of the hills, off the middle of the world.
fn begin(store: Option<Arc<WorldStore>>) -> Scene {
    let mut scene = Scene::open(small(), store).unwrap();
    scene.set_npcs(NpcMode::Off);
    scene.set_flying(true);
    let off_m = OFF_MIDDLE * 0.25 * ROUND_M;
    scene.teleport(ChartPoint::a(DVec3::new(0.6 * off_m, 8.0, 0.8 * off_m)));
    assert!(scene.wait_for_step(LIMIT));
    scene
}

/// Goes straight on by the key alone, from where the compass shows the equator so far to the left, in radians, for so
/// many times round the world. Returns how near to the place of the start the last half round leads, in metres, and
/// what was told.
fn go(scene: &mut Scene, beside_rad: f64, rounds: f64) -> (f64, Vec<Hint>) {
    let home = scene.feet();
    scene.aim(
        scene.bearings().equator.unwrap().heading_rad + beside_rad,
        0.0,
    );
    let on = Actions {
        forward: 1.0,
        sprint: true,
        ..Actions::default()
    };
    let (mut gone_m, mut nearest_m) = (0.0, f64::INFINITY);
    let mut told = Vec::new();
    while gone_m < rounds * ROUND_M {
        let from_middle = |scene: &Scene| {
            let globe = scene.strategy().globe().unwrap();
            globe.from_middle_m(scene.feet())
        };
        let before = from_middle(scene);
        steps(scene, 1, &on);
        let at = scene.feet();
        gone_m += RADIUS_M * before.angle_between(from_middle(scene));
        told.extend(scene.take_hints());
        if gone_m > (rounds - 0.5) * ROUND_M {
            let away_m = scene.strategy().distance_m(at, home, &Eye::default());
            nearest_m = nearest_m.min(away_m);
        }
    }
    (nearest_m, told)
}

fn is_round(hint: &Hint) -> bool {
    matches!(hint, Hint::BeenRound(_))
}

/// As a hint says.
#[test]
fn straight_on_leads_home_whichever_way() {
    for beside_rad in [0.0, PI, 0.25 * PI, -0.5 * PI, 2.0] {
        let (nearest_m, _) = go(&mut begin(None), beside_rad, 1.1);
        assert!(nearest_m < 1.0, "{beside_rad}: {nearest_m} m from home");
    }
}

#[test]
fn the_first_time_round_is_told_once_and_after_saving_never_again() {
    let dir = tempfile::tempdir().unwrap();
    let here = dir.path().join("world");
    let store = WorldStore::create(&here, &small().to_meta()).unwrap();
    let mut scene = begin(Some(Arc::new(store)));
    let (_, told) = go(&mut scene, 0.0, 0.8);
    assert!(!told.iter().any(is_round), "not yet: {told:?}");
    // Past the far pole the way on leads from the equator.
    let (_, told) = go(&mut scene, PI, 2.4);
    let rounds: Vec<_> = told.into_iter().filter(is_round).collect();
    assert_eq!(rounds, [Hint::BeenRound(ROUND_M.round() as u32)]);
    scene.save();
    assert!(scene.wait_saved(LIMIT));
    drop(scene);
    let store = WorldStore::open(&here).unwrap();
    let (_, told) = go(&mut begin(Some(Arc::new(store))), 0.0, 1.3);
    assert!(!told.iter().any(is_round), "again after saving: {told:?}");
}
