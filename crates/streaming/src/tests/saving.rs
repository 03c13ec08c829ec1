//! Saves: everything comes back, and failures lose nothing.

use std::sync::Arc;
use std::sync::atomic::Ordering;

use antipode_geometry::{ChartPoint, ChunkCoord, Geometry};
use antipode_storage::{
    LampRecord, Record, RecordChanges, RecordKey, RecordKind, WorldMeta, WorldState, WorldStore,
};
use glam::DVec3;

use super::{Game, Gate, Memory, chunk};
use crate::api::{StreamingError, Until};
use crate::edit_backend::EditBackend;
use crate::shared::Step;

pub(super) fn open(memory: &Arc<Memory>) -> Game {
    let mut game = Game::new(
        Geometry::Euclidean,
        2,
        Some(Arc::clone(memory) as Arc<dyn EditBackend>),
        None,
    );
    let at = game.ground(0.0, 0.0);
    game.wish(at, 1);
    game.wait(Until::Idle);
    game
}

pub(super) fn meta() -> WorldMeta {
    WorldMeta {
        name: "Test".to_owned(),
        seed: super::SEED,
        geometry: "euclidean".to_owned(),
        radius_m: 20.0,
        biome: String::new(),
        created_unix_s: 1,
        last_played_unix_s: 2,
        played_s: 3.0,
        cheated: false,
        generator: 1,
        gathering: false,
    }
}

#[test]
fn what_was_dug_is_there_after_closing_and_opening() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("world");
    let store = Arc::new(WorldStore::create(&path, &meta()).unwrap());
    let mut game = Game::new(
        Geometry::Euclidean,
        2,
        Some(store as Arc<dyn EditBackend>),
        None,
    );
    let at = game.ground(0.0, 0.0);
    game.wish(at, 1);
    game.wait(Until::Idle);
    for n in 0..10 {
        game.edit(at + DVec3::new(f64::from(n) - 5.0, 0.0, 1.0), 3.0);
    }
    game.wait(Until::Edits);
    // A stroke that is not even waited for is drained by closing.
    game.edit(at - DVec3::Y * 3.0, 4.0);
    game.streamer.close().unwrap();
    let first = std::mem::take(&mut game.chunks);
    drop(game);

    let store = Arc::new(WorldStore::open(&path).unwrap());
    let mut again = Game::new(
        Geometry::Euclidean,
        1,
        Some(store as Arc<dyn EditBackend>),
        None,
    );
    again.wish(at, 1);
    again.wait(Until::Idle);
    assert!(again.problems.is_empty() && again.streamer.edited_count() > 0);
    let mut with_ground = first.values().filter(|chunk| !chunk.mesh.is_empty());
    assert!(with_ground.all(|chunk| again.chunks.contains_key(&chunk.coord)));
    let deep = (at - DVec3::Y * 3.0).round();
    let base = again.field.sample(ChartPoint::a(deep));
    assert!(again.sample(deep.as_ivec3()) > base + 3.0);
    let beside = (at + DVec3::new(-9.0, 0.0, 1.0)).round();
    let coord = ChunkCoord::containing(ChartPoint::a(beside));
    let local = beside - coord.origin();
    assert_eq!(
        again.samples(coord).density(local),
        first[&coord].samples.as_ref().unwrap().density(local)
    );
}

#[test]
fn a_save_takes_meta_and_every_changed_chunk_once() {
    let memory = Arc::new(Memory::default());
    let mut game = open(&memory);
    let at = game.ground(0.0, 0.0);
    game.edit(at, 5.0);
    game.wait(Until::Edits);
    game.streamer.save(Some(meta()), RecordChanges::new());
    game.wait(Until::Saved);
    game.streamer.save(None, RecordChanges::new());
    game.wait(Until::Saved);
    let commits = memory.commits();
    assert_eq!(
        (commits.len(), game.saved),
        (1, 2),
        "nothing new means no commit"
    );
    assert!(commits[0].0 && !commits[0].1);
    assert_eq!(commits[0].2.len(), game.streamer.edited_count());
    game.streamer.close().unwrap();
    assert_eq!(memory.commits().len(), 1);
}

#[test]
fn a_failed_save_is_told_and_made_up_for_by_the_next() {
    let memory = Arc::new(Memory::default());
    let mut game = open(&memory);
    let at = game.ground(0.0, 0.0);
    game.edit(at, 5.0);
    game.wait(Until::Edits);
    memory.fail(true);
    game.streamer.save(Some(meta()), RecordChanges::new());
    game.wait(Until::Saved);
    assert!(
        game.saved == 0 && game.problems[0].contains("the disk is full"),
        "{:?}",
        game.problems
    );
    memory.fail(false);
    game.streamer.save(None, RecordChanges::new());
    game.wait(Until::Saved);
    let commits = memory.commits();
    assert_eq!((commits.len(), game.saved), (1, 1));
    assert!(commits[0].0 && !commits[0].2.is_empty());
}

#[test]
fn a_store_that_panics_is_a_failed_save() {
    let memory = Arc::new(Memory::default());
    let mut game = open(&memory);
    let at = game.ground(0.0, 0.0);
    game.edit(at, 5.0);
    game.wait(Until::Edits);
    memory.broken.store(true, Ordering::SeqCst);
    game.streamer.save(None, RecordChanges::new());
    game.wait(Until::Saved);
    assert!(
        game.saved == 0 && game.problems[0].contains("a broken store"),
        "{:?}",
        game.problems
    );
    memory.broken.store(false, Ordering::SeqCst);
    game.streamer.close().unwrap();
    assert_eq!(memory.commits().len(), 1);
}

#[test]
fn closing_tells_that_the_last_commit_failed() {
    let memory = Arc::new(Memory::default());
    let mut game = open(&memory);
    let at = game.ground(0.0, 0.0);
    game.edit(at, 5.0);
    memory.fail(true);
    let end = game.streamer.close();
    assert!(
        matches!(&end, Err(StreamingError::NotSaved(why)) if why.to_string().contains("full")),
        "{end:?}"
    );
    assert!(memory.full.load(Ordering::SeqCst) && memory.commits().is_empty());
}

#[test]
fn after_a_failed_close_the_game_goes_on_and_closes_again() {
    let memory = Arc::new(Memory::default());
    let mut game = open(&memory);
    let at = game.ground(0.0, 0.0);
    let far = game.ground(320.0, 0.0);
    game.wish(far, 1);
    game.edit(at, 5.0);
    memory.fail(true);
    assert!(game.streamer.close().is_err());
    assert!(game.streamer.needs_save());
    game.wait(Until::Idle);
    let under = ChunkCoord::containing(ChartPoint::a(far));
    assert!(
        game.chunks.contains_key(&under),
        "loading goes on, and nothing that came meanwhile is lost"
    );
    assert_eq!(game.problems.len(), 1, "{:?}", game.problems);
    game.edit(at + DVec3::X, 5.0);
    memory.fail(false);
    game.streamer.close().unwrap();
    assert!(!game.streamer.needs_save());
    assert_eq!(memory.commits().len(), 1);
    assert_eq!(memory.commits()[0].2.len(), game.streamer.edited_count());
}

#[test]
fn a_save_is_needed_from_the_first_stroke_until_one_holds_it() {
    let memory = Arc::new(Memory::default());
    let mut game = open(&memory);
    assert!(!game.streamer.needs_save());
    game.edit(game.ground(0.0, 0.0), 5.0);
    assert!(game.streamer.needs_save());
    // Asked for while the batch is under way: the save waits for it.
    game.streamer.save(Some(meta()), RecordChanges::new());
    assert!(!game.streamer.needs_save());
    game.edit(game.ground(0.0, 0.0), 5.0);
    assert!(game.streamer.needs_save());
    game.wait(Until::Idle);
    assert!(game.streamer.needs_save());
    memory.fail(true);
    game.streamer.save(Some(meta()), RecordChanges::new());
    game.wait(Until::Saved);
    assert!(game.streamer.needs_save());
    memory.fail(false);
    game.streamer.save(None, RecordChanges::new());
    game.wait(Until::Saved);
    assert!(!game.streamer.needs_save());
}

#[test]
fn a_save_is_of_one_moment_however_many_strokes_are_on_their_way() {
    // What the land is after the strokes before the save.
    let expected = {
        let memory = Arc::new(Memory::default());
        let mut game = open(&memory);
        let at = game.ground(0.0, 0.0);
        game.edit(at, 5.0);
        game.edit(at + DVec3::X, 5.0);
        game.streamer.close().unwrap();
        memory.chunks.lock().unwrap().clone()
    };
    assert!(!expected.is_empty());
    for stop in [Step::Apply, Step::Entered] {
        let memory = Arc::new(Memory::default());
        let (gate, watch) = Gate::at(move |step| step == stop);
        let backend = Arc::clone(&memory) as Arc<dyn EditBackend>;
        let mut game = Game::new(Geometry::Euclidean, 2, Some(backend), Some(watch));
        let at = game.ground(0.0, 0.0);
        game.wish(at, 1);
        game.wait(Until::Idle);
        // One is with a worker, one waits, the save is asked for, and more come at the same places.
        game.edit(at, 5.0);
        gate.wait();
        game.edit(at + DVec3::X, 5.0);
        let records = (&WorldState::default()).into();
        game.streamer.save(Some(meta()), records);
        game.edit(at + DVec3::X, 5.0);
        game.edit(at - DVec3::X, 5.0);
        assert!(memory.commits().is_empty(), "the strokes are under way");
        gate.open();
        game.wait(Until::Edits);
        game.wait(Until::Saved);
        let commits = memory.commits();
        assert!(commits.len() == 1 && commits[0].0 && commits[0].1);
        assert!(*memory.chunks.lock().unwrap() == expected, "{stop:?}");
        assert!(game.streamer.needs_save());
        game.streamer.close().unwrap();
        assert!(*memory.chunks.lock().unwrap() != expected);
    }
}

#[test]
fn digging_goes_on_while_a_save_waits_and_workers_read_the_edits() {
    let memory = Arc::new(Memory::default());
    let mut game = open(&memory);
    let at = game.ground(0.0, 0.0);
    game.edit(at, 5.0);
    game.wait(Until::Edits);
    {
        let shared = game.streamer.worker_pool.shared();
        let _reader = shared.edit_store.being_read();
        game.streamer.save(Some(meta()), RecordChanges::new());
        game.edit(at + DVec3::X, 5.0);
        assert!(
            game.streamer.batch_in_flight,
            "the stroke is with a worker, and the save is of the land before it"
        );
    }
    game.wait(Until::Saved);
    let first = memory.commits();
    assert!(first.len() == 1 && !first[0].2.is_empty());
    assert!(game.streamer.needs_save());
}

#[test]
fn saves_in_a_row_hold_each_their_own_moment_and_a_failed_ones_land_comes_with_the_next() {
    let memory = Arc::new(Memory::default());
    let mut game = open(&memory);
    let at = game.ground(0.0, 0.0);
    let far = game.ground(100.0, 0.0);
    memory.fail(true);
    game.edit(at, 5.0);
    game.streamer.save(Some(meta()), RecordChanges::new());
    game.edit(far, 5.0);
    let records = (&WorldState::default()).into();
    game.streamer.save(None, records);
    game.streamer.save(None, RecordChanges::new());
    game.wait(Until::Edits);
    game.wait(Until::Saved);
    assert!(memory.commits().is_empty() && game.streamer.needs_save());
    memory.fail(false);
    game.streamer.save(None, RecordChanges::new());
    game.wait(Until::Saved);
    let commits = memory.commits();
    assert!(commits.len() == 1 && commits[0].0 && commits[0].1);
    assert_eq!(commits[0].2.len(), game.streamer.edited_count());
}

#[test]
fn a_commit_holds_what_changed_and_after_a_failure_the_newest_of_everything() {
    let memory = Arc::new(Memory::default());
    let mut game = open(&memory);
    let lamp = |id: u32, x: Option<f64>| {
        let record = x.map(|x| {
            Record::Lamp(LampRecord {
                pos: [x, 0.0, 0.0],
                ..LampRecord::default()
            })
        });
        (RecordKind::Lamp.numbered(id), record)
    };
    let mut save = |records: &[(RecordKey, Option<Record>)]| {
        game.streamer.save(None, records.iter().cloned().collect());
        game.wait(Until::Saved);
    };
    save(&[lamp(1, Some(1.0)), lamp(2, Some(1.0))]);
    memory.fail(true);
    save(&[lamp(1, Some(2.0)), lamp(2, None), lamp(3, Some(2.0))]);
    save(&[lamp(3, None), lamp(4, Some(3.0))]);
    memory.fail(false);
    save(&[lamp(1, Some(4.0))]);
    save(&[]);
    let first = [lamp(1, Some(1.0)), lamp(2, Some(1.0))].into();
    let made_up = [
        lamp(1, Some(4.0)),
        lamp(2, None),
        lamp(3, None),
        lamp(4, Some(3.0)),
    ];
    assert_eq!(memory.records(), [first, made_up.into()]);
}

#[test]
fn waiting_for_what_holds_already_still_takes_what_is_finished() {
    let memory = Arc::new(Memory::default());
    let mut game = open(&memory);
    game.streamer.save(Some(meta()), RecordChanges::new());
    let mut left = 60_000;
    while game.saved == 0 && left > 0 {
        game.wait(Until::Edits);
        std::thread::sleep(std::time::Duration::from_millis(1));
        left -= 1;
    }
    assert_eq!((game.saved, game.streamer.saves_in_flight()), (1, 0));
}

#[test]
fn dropping_without_closing_ends_at_once_and_saves_the_edits() {
    let memory = Arc::new(Memory::default());
    let mut game = open(&memory);
    let at = game.ground(0.0, 0.0);
    game.edit(at, 5.0);
    game.wait(Until::Edits);
    game.wish(at, 8);
    // Until its plan is made.
    while game.streamer.pending() == 1 {
        let updates = game.streamer.poll(std::time::Duration::ZERO);
        game.apply(updates);
    }
    assert!(game.streamer.pending() > 50);
    drop(game);
    assert_eq!(memory.commits().len(), 1);
}

#[test]
fn without_a_store_saving_is_no_work() {
    let mut game = Game::flat(1);
    game.edit(chunk(0, 0, 0).origin(), 5.0);
    game.streamer.save(Some(meta()), RecordChanges::new());
    game.wait(Until::Idle);
    assert_eq!((game.saved, game.streamer.saves_in_flight()), (1, 0));
    game.streamer.close().unwrap();
}
