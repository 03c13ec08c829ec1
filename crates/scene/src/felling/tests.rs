//! What stands on land, after much of that was dug away.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]

use std::time::Duration;

use antipode_geometry::{ChartId, ChartPoint, Geometry};
use antipode_storage::{Record, RecordKind};
use antipode_terrain::{Generator, Part, Shape, Stroke};
use glam::DVec3;

use super::{Felled, Standing};
use crate::actions::Actions;
use crate::ground::{chunks_near, height_below};
use crate::scene::Scene;
use crate::setup::{Mode, WorldSetup};

const LIMIT: Duration = Duration::from_mins(2);
/// Digs are thrown so far about the middle, metres.
const ABOUT_M: f64 = 24.0;
/// Something stands in the air that has no ground so far below its root, metres.
const AIR_M: f64 = 1.2;

/// A share of 0 to 1 by number, by the golden ratio's multiples of several bases.
fn share(n: u32, of: u32) -> f64 {
    (f64::from(n) * [0.618_033_988_749, 0.754_877_666, 0.569_840_29][of as usize % 3]).fract()
}

fn in_the_air(scene: &Scene) -> Vec<(DVec3, &'static str)> {
    let world = &scene.sim.world;
    let feet = scene.feet();
    let mut found = Vec::new();
    for coord in chunks_near(&*world.strategy, feet, 2.0 * ABOUT_M) {
        let things = world.ground.things(coord).iter();
        for it in things.filter_map(|thing| Standing::of(coord, *thing)) {
            let root = it.root();
            let from = root.moved(DVec3::Y * 0.1);
            if height_below(from, AIR_M, |at| world.ground.is_solid(at)).is_none() {
                found.push((root.pos, it.species.name()));
            }
        }
    }
    found
}

#[test]
fn a_save_is_given_the_columns_that_have_changed_each_whole() {
    let column = |x| (ChartId::FIRST, [x, 0]);
    let given = |felled: &mut Felled| -> Vec<_> {
        let all = felled.take_changes().into_iter();
        let slots = |record: Option<Record>| match record {
            Some(Record::Felled(it)) => (it.x, it.slots),
            other => panic!("{other:?}"),
        };
        all.map(|(key, record)| (key, slots(record))).collect()
    };
    let key = |id| RecordKind::Felled.numbered(id);
    let mut felled = Felled::default();
    felled.add(column(5), 1);
    felled.add(column(7), 1 << 70);
    let both = [(key(1), (5, [1, 0])), (key(2), (7, [0, 64]))];
    assert_eq!(given(&mut felled), both);
    assert_eq!(given(&mut felled), []);
    felled.add(column(5), 2);
    assert_eq!(given(&mut felled), [(key(1), (5, [3, 0]))]);
}

#[test]
fn nothing_stands_in_the_air_after_three_hundred_digs() {
    for geometry in Geometry::ALL {
        let setup = WorldSetup {
            name: "Test".to_owned(),
            seed: 7,
            geometry,
            radius_m: 64.0,
            generator: Generator::Planted,
            mode: Mode::Creative,
            view_distance: 2,
        };
        let mut scene = Scene::open(setup, None).unwrap();
        assert!(scene.wait_for_step(LIMIT) && scene.settle(LIMIT));
        let feet = scene.feet();
        let felled = |scene: &Scene| scene.probe().plants.unwrap().felled;
        for n in 0..300 {
            let by = DVec3::new(share(n, 0) - 0.5, 0.0, share(n, 1) - 0.5) * 2.0 * ABOUT_M;
            let at = feet.pos + by;
            let height_m = scene.field().surface_height(feet.chart, at.x, at.z);
            let deep_m = 3.0 * share(n, 2);
            let stroke = Stroke {
                centre: ChartPoint::new(feet.chart, at.with_y(height_m - deep_m)),
                radius_m: 1.0 + 3.0 * share(n + 7, 2),
                amount: 6.0,
                part: Part::Whole,
                kind: None,
                shape: Shape::Ball,
                power: None,
            };
            scene.sim.world.streamer.edit(stroke);
            if n % 10 == 9 {
                scene.step(&Actions::default());
                assert!(scene.settle(LIMIT));
            }
        }
        assert!(
            felled(&scene) > 10,
            "{geometry:?}: {} felled",
            felled(&scene)
        );
        let found = in_the_air(&scene);
        assert!(found.is_empty(), "{geometry:?}: {found:?}");
    }
}
