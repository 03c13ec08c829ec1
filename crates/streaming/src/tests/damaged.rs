//! Records that cannot be read: told, kept, and never built over unasked.

use std::sync::Arc;
use std::sync::atomic::Ordering;

use antipode_geometry::{ChartPoint, ChunkCoord};
use antipode_storage::RecordChanges;

use super::saving::{meta, open};
use super::{Game, Memory};
use crate::api::Until;
use crate::edit_backend::key_of;

#[test]
fn a_damaged_record_is_told_and_kept_until_the_player_digs_there() {
    let memory = Arc::new(Memory::default());
    let at = Game::flat(1).ground(16.0, 16.0);
    let key = key_of(ChunkCoord::containing(ChartPoint::a(at)));
    memory
        .chunks
        .lock()
        .unwrap()
        .insert(key, vec![5; 32 * 32 * 32]);
    *memory.damaged.lock().unwrap() = Some(key);
    let mut game = open(&memory);
    assert!(
        game.problems.len() == 1 && game.problems[0].contains("checksum"),
        "{:?}",
        game.problems
    );
    let here = at.round();
    assert_eq!(
        game.sample(here.as_ivec3()),
        game.field.sample(ChartPoint::a(here))
    );
    game.streamer.save(Some(meta()), RecordChanges::new());
    game.wait(Until::Saved);
    assert!(
        memory.commits()[0].2.is_empty(),
        "the damaged record was overwritten"
    );
    game.edit(at, 5.0);
    game.streamer.close().unwrap();
    assert!(memory.commits()[1].2.contains(&key));
}

#[test]
fn a_record_out_of_reach_is_never_overwritten() {
    let memory = Arc::new(Memory::default());
    let at = Game::flat(1).ground(16.0, 16.0);
    let key = key_of(ChunkCoord::containing(ChartPoint::a(at)));
    memory
        .chunks
        .lock()
        .unwrap()
        .insert(key, vec![5; 32 * 32 * 32]);
    memory.absent.store(true, Ordering::SeqCst);
    let mut game = open(&memory);
    assert_eq!(game.problems.len(), 1, "told once: {:?}", game.problems);
    game.edit(at, 5.0);
    assert!(game.wait(Until::Edits).batches.is_empty());
    assert!(
        game.problems.len() == 2 && game.problems[1].contains("left out"),
        "{:?}",
        game.problems
    );
    memory.absent.store(false, Ordering::SeqCst);
    game.edit(at, 5.0);
    assert_eq!(game.wait(Until::Edits).batches.len(), 1);
    game.streamer.close().unwrap();
    let stored = memory.chunks.lock().unwrap();
    assert!(
        stored[&key].iter().all(|&delta| delta >= 5) && stored[&key].iter().any(|&delta| delta > 5)
    );
}

#[test]
fn a_record_of_the_wrong_length_or_place_is_told() {
    let memory = Arc::new(Memory::default());
    let at = Game::flat(1).ground(16.0, 16.0);
    let key = key_of(ChunkCoord::containing(ChartPoint::a(at)));
    memory.chunks.lock().unwrap().insert(key, vec![5; 7]);
    memory
        .chunks
        .lock()
        .unwrap()
        .insert(antipode_storage::ChunkKey { chart: 9, ..key }, vec![5; 7]);
    let game = open(&memory);
    assert_eq!(game.problems.len(), 2, "{:?}", game.problems);
    assert_eq!(game.streamer.edited_count(), 1);
}
