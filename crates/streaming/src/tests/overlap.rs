//! Loads and edits of the same chunk at the same time.

use std::sync::Arc;

use antipode_geometry::{ChartPoint, ChunkCoord, Geometry};
use glam::DVec3;

use super::{Game, Gate, LIMIT, SEED};
use crate::api::{Until, Update};
use crate::shared::Step;

/// A place whose brush stays within one chunk.
fn place() -> (DVec3, ChunkCoord) {
    let at = Game::flat(1).ground(16.0, 16.0);
    (at, ChunkCoord::containing(ChartPoint::a(at)))
}

#[test]
fn a_load_from_before_an_edit_never_replaces_it() {
    let (at, under) = place();
    let (gate, watch) = Gate::at(move |step| step == Step::Load(under));
    let mut game = Game::new(Geometry::Euclidean, 2, None, Some(watch));
    game.wish(at, 1);
    gate.wait();
    game.edit(at, 30.0);
    let seen = game.wait(Until::Edits);
    assert!(seen.batches.iter().any(|batch| batch.contains(&under)));
    let edited = game.sum(under);
    gate.open();
    let loaded = game.wait(Until::Idle).loaded;
    assert!(
        !loaded.contains(&under),
        "the chunk came again, without the edit"
    );
    assert_eq!(game.sum(under), edited);
}

#[test]
fn a_stale_load_of_a_chunk_that_left_and_came_back_is_made_again() {
    let (at, under) = place();
    let (gate, watch) = Gate::at(move |step| step == Step::Load(under));
    let mut game = Game::new(Geometry::Euclidean, 2, None, Some(watch));
    game.wish(at, 1);
    gate.wait();
    let away = game.ground(16.0 + 640.0, 16.0);
    game.wish(away, 1);
    game.edit(at, 30.0);
    assert!(
        game.wait(Until::Edits)
            .batches
            .iter()
            .all(|batch| !batch.contains(&under))
    );
    game.wish(at, 1);
    gate.open();
    game.wait(Until::Idle);
    let base = game.field.sample(ChartPoint::a(at.round()));
    assert!(game.sample(at.round().as_ivec3()) > base + 10.0);
}

#[test]
fn a_load_that_knows_an_edit_waits_until_the_edit_is_shown() {
    let (at, under) = place();
    let (gate, watch) = Gate::at(|step| step == Step::Entered);
    let mut game = Game::new(Geometry::Euclidean, 2, None, Some(watch));
    game.edit(at, 30.0);
    gate.wait();
    game.wish(at, 1);
    let end = std::time::Instant::now() + LIMIT;
    let mut early = Vec::new();
    while game.streamer.held_loads() < 3 && std::time::Instant::now() < end {
        early.extend(game.streamer.poll(LIMIT));
        std::thread::yield_now();
    }
    assert!(
        early.is_empty(),
        "a chunk with half an edit around it: {early:?}"
    );
    gate.open();
    let updates = game.streamer.wait(Until::Idle, LIMIT);
    assert!(
        matches!(updates.first(), Some(Update::Edited(chunks)) if chunks.iter().any(|c| c.coord == under))
    );
    let seen = game.apply(updates);
    assert!(!seen.loaded.contains(&under) && seen.loaded.len() >= 3);
}

#[test]
fn the_same_strokes_give_the_same_world_whoever_makes_it() {
    let run = |workers: usize| {
        let mut game = Game::new(Geometry::Euclidean, workers, None, None);
        let at = game.ground(0.0, 0.0);
        game.wish(at, 1);
        for n in 0..12 {
            let here = game.ground(f64::from(n), 2.0);
            game.edit(here, if n % 3 == 0 { -7.0 } else { 5.0 });
            game.wait(Until::Edits);
        }
        game.wait(Until::Idle);
        let meshes: Vec<_> = game
            .chunks
            .into_values()
            .map(|chunk| (chunk.coord, Arc::clone(&chunk.mesh)))
            .collect();
        meshes
    };
    let (one, three) = (run(1), run(3));
    assert_eq!(one.len(), three.len(), "seed {SEED}");
    for ((coord, a), (_, b)) in one.iter().zip(&three) {
        assert!(
            a.indices == b.indices && a.vertices.len() == b.vertices.len(),
            "{coord:?}"
        );
        assert!(
            a.vertices
                .iter()
                .zip(&b.vertices)
                .all(|(a, b)| a.units == b.units),
            "{coord:?}"
        );
    }
}
