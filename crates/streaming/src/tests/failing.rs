//! Workers that panic.

use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};

use antipode_geometry::{ChartPoint, ChunkCoord, Geometry};
use glam::DVec3;

use super::Game;
use crate::api::Until;
use crate::shared::{Step, Watch};

/// Panics the first `times` times that a worker comes to a step.
fn bomb(times: u32, at: impl Fn(Step) -> bool + Send + Sync + 'static) -> Watch {
    let left = AtomicU32::new(times);
    Arc::new(move |step| {
        let lit = at(step)
            && left
                .fetch_update(Ordering::SeqCst, Ordering::SeqCst, |n| n.checked_sub(1))
                .is_ok();
        assert!(!lit, "a bomb in the test");
    })
}

fn place() -> (DVec3, ChunkCoord) {
    let at = Game::flat(1).ground(16.0, 16.0);
    (at, ChunkCoord::containing(ChartPoint::a(at)))
}

#[test]
fn a_load_that_panics_once_is_made_again() {
    let (at, under) = place();
    let mut game = Game::new(
        Geometry::Euclidean,
        1,
        None,
        Some(bomb(1, move |step| step == Step::Load(under))),
    );
    game.wish(at, 1);
    game.wait(Until::Idle);
    assert!(game.streamer.is_resident(under));
    assert!(
        game.problems.len() == 1 && game.problems[0].contains("a bomb in the test"),
        "{:?}",
        game.problems
    );
}

#[test]
fn a_load_that_panics_twice_is_given_up_and_the_rest_comes() {
    let (at, under) = place();
    let mut game = Game::new(
        Geometry::Euclidean,
        1,
        None,
        Some(bomb(2, move |step| step == Step::Load(under))),
    );
    game.wish(at, 1);
    game.wait(Until::Idle);
    assert!(!game.streamer.is_resident(under) && game.chunks.len() >= 8);
    assert!(
        game.streamer.is_ready(under),
        "nobody waits for what will not come"
    );
    assert_eq!(game.problems.len(), 3, "{:?}", game.problems);
    game.wish(at + DVec3::X * 320.0, 1);
    game.wait(Until::Idle);
    game.wish(at, 1);
    game.wait(Until::Idle);
    assert!(
        game.streamer.is_resident(under),
        "it is tried again after coming back"
    );
}

#[test]
fn a_batch_with_a_chunk_given_up_is_not_shown_until_it_is_whole() {
    let (at, under) = place();
    let mut game = Game::new(
        Geometry::Euclidean,
        2,
        None,
        Some(bomb(2, move |step| step == Step::Remesh(under))),
    );
    game.wish(at, 1);
    game.wait(Until::Idle);
    let before = game.sum(under);
    game.edit(at, 20.0);
    assert!(game.wait(Until::Edits).batches.is_empty());
    assert_eq!(
        (game.sum(under), game.problems.len()),
        (before, 3),
        "{:?}",
        game.problems
    );
    // A stroke elsewhere brings what is overdue.
    game.edit(at + DVec3::X * 32.0, 1.0);
    let batches = game.wait(Until::Edits).batches;
    assert!(batches.len() == 1 && batches[0].contains(&under));
    assert!(game.sum(under) > before + 20.0);
}

#[test]
fn a_stroke_that_panics_twice_is_left_out_whole() {
    let (at, under) = place();
    let mut game = Game::new(
        Geometry::Euclidean,
        1,
        None,
        Some(bomb(2, |step| step == Step::Apply)),
    );
    game.wish(at, 1);
    game.wait(Until::Idle);
    let before = game.sum(under);
    game.edit(at, 20.0);
    assert!(game.wait(Until::Edits).batches.is_empty());
    assert_eq!(
        (game.streamer.edited_count(), game.problems.len()),
        (0, 3),
        "{:?}",
        game.problems
    );
    game.edit(at, 1.0);
    assert_eq!(game.wait(Until::Edits).batches.len(), 1);
    assert!(game.sum(under) > before);
}

#[test]
fn a_panic_leaves_nothing_to_hang_on() {
    let (at, _) = place();
    let mut game = Game::new(
        Geometry::Euclidean,
        2,
        None,
        Some(bomb(u32::MAX, |step| step != Step::Entered)),
    );
    game.wish(at, 1);
    game.edit(at, 1.0);
    game.wait(Until::Idle);
    assert!(game.chunks.is_empty() && !game.problems.is_empty());
    game.streamer.close().unwrap();
}
