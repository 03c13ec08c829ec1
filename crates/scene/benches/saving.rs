//! How long the main thread takes to hand a step of walking over to be saved, and how long it takes to be on disk, in
//! a world that holds nothing else, one with as many lamps, drops and figures as a world takes in, and one with a
//! hundred thousand lamps.
#![allow(clippy::unwrap_used, reason = "a bench fails by panicking")]

use std::cell::RefCell;
use std::sync::Arc;
use std::time::Duration;

use antipode_geometry::Geometry;
use antipode_scene::{Actions, Scene, WorldSetup};
use antipode_storage::{
    Batch, BotRecord, DropRecord, LampRecord, Record, RecordChanges, RecordKind, WorldStore,
};
use divan::Bencher;
use tempfile::TempDir;

const LIMIT: Duration = Duration::from_mins(2);

fn main() {
    divan::main();
}

/// What a world holds besides the player.
#[derive(Debug, Clone, Copy)]
enum Among {
    Nothing,
    AsMuchAsItTakesIn,
    AHundredThousandLamps,
}

fn records(among: Among) -> RecordChanges {
    let lamps = match among {
        Among::Nothing => 0,
        Among::AsMuchAsItTakesIn => 512,
        Among::AHundredThousandLamps => 100_000,
    };
    let mut records = RecordChanges::new();
    for id in 0..lamps {
        let pos = [f64::from(id % 300), 0.0, f64::from(id / 300)];
        let lamp = LampRecord { chart: 0, pos };
        records.insert(RecordKind::Lamp.numbered(id), Some(Record::Lamp(lamp)));
    }
    if matches!(among, Among::AsMuchAsItTakesIn) {
        for id in 0..512 {
            let pos = [f64::from(id), 40.0, 300.0];
            let figure = BotRecord {
                pos,
                health: 100.0,
                ..BotRecord::default()
            };
            records.insert(
                RecordKind::Figure.numbered(id),
                Some(Record::Figure(figure)),
            );
            let drop = DropRecord {
                pos,
                item: "lamp".to_owned(),
                count: 1,
                ..DropRecord::default()
            };
            records.insert(RecordKind::Drop.numbered(id), Some(Record::Drop(drop)));
        }
    }
    records
}

fn opened(among: Among) -> (TempDir, Scene) {
    let setup = WorldSetup {
        name: "Bench".to_owned(),
        seed: 3,
        geometry: Geometry::Euclidean,
        radius_m: 20.0,
        generator: antipode_scene::Generator::default(),
        mode: antipode_scene::Mode::default(),
        view_distance: 2,
    };
    let dir = tempfile::tempdir().unwrap();
    let store = WorldStore::create(&dir.path().join("world"), &setup.to_meta()).unwrap();
    let batch = Batch {
        records: records(among),
        ..Batch::default()
    };
    store.commit(&batch).unwrap();
    let mut scene = Scene::open(setup, Some(Arc::new(store))).unwrap();
    assert!(scene.wait_for_step(LIMIT));
    scene.save();
    assert!(scene.wait_saved(LIMIT));
    (dir, scene)
}

fn walk(scene: &mut Scene) {
    let actions = Actions {
        forward: 1.0,
        ..Actions::default()
    };
    scene.step(&actions);
    assert!(scene.wait_for_step(LIMIT) && scene.wait_saved(LIMIT));
}

const ALL: [Among; 3] = [
    Among::Nothing,
    Among::AsMuchAsItTakesIn,
    Among::AHundredThousandLamps,
];

/// What the main thread does of a save.
#[divan::bench(args = ALL, sample_count = 100, sample_size = 1)]
fn hand_over_step(bencher: Bencher<'_, '_>, among: Among) {
    let (_dir, scene) = opened(among);
    let scene = RefCell::new(scene);
    bencher
        .with_inputs(|| walk(&mut scene.borrow_mut()))
        .bench_local_values(|()| scene.borrow_mut().save());
}

/// Until it is on disk.
#[divan::bench(args = ALL, sample_count = 100, sample_size = 1)]
fn save_step(bencher: Bencher<'_, '_>, among: Among) {
    let (_dir, scene) = opened(among);
    let scene = RefCell::new(scene);
    bencher
        .with_inputs(|| walk(&mut scene.borrow_mut()))
        .bench_local_values(|()| {
            let mut scene = scene.borrow_mut();
            scene.save();
            assert!(scene.wait_saved(LIMIT));
        });
}
