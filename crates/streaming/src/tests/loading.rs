//! Which chunks come and go, and in which order.

use std::sync::{Arc, Mutex};

use antipode_geometry::{ChartId, ChartPoint, ChunkCoord, Geometry};
use antipode_terrain::Content;
use crossbeam_channel::{Sender, unbounded};
use glam::DVec3;

use super::{Game, Gate, LIMIT, chunk};
use crate::api::{Until, Wish};
use crate::range::Range;
use crate::shared::{Step, Watch};

fn middle_distance(coord: ChunkCoord, at: DVec3) -> f64 {
    (coord.origin() + DVec3::splat(16.0)).distance(at)
}

#[test]
fn chunks_come_nearest_first_and_all_that_have_a_surface() {
    let mut game = Game::flat(1);
    let at = game.ground(16.0, 16.0);
    game.streamer
        .wish(&Wish::new(ChartPoint::a(at), DVec3::ZERO, 2));
    let seen = game.wait(Until::Idle);
    let far: Vec<_> = seen
        .loaded
        .iter()
        .map(|&coord| middle_distance(coord, at))
        .collect();
    assert!(far.len() >= 25 && far.is_sorted(), "{far:?}");
    let wanted = Range::wished(&*game.space, ChartPoint::a(at), 2, 0).all();
    for coord in wanted {
        assert!(game.streamer.is_resident(coord));
        assert_eq!(
            game.chunks.contains_key(&coord),
            game.field.content(coord) == Content::Surface
        );
    }
    assert_eq!(
        (game.streamer.pending(), game.streamer.resident_count()),
        (0, game.chunks.len())
    );
    assert!(
        game.chunks
            .values()
            .all(|chunk| chunk.collider.is_none() == chunk.mesh.is_empty())
    );
    assert!(game.chunks.values().any(|chunk| chunk.collider.is_some()));
}

#[test]
fn what_is_in_view_comes_before_what_is_behind() {
    let mut game = Game::flat(1);
    let at = game.ground(16.0, 16.0);
    game.wish(at, 3);
    let loaded = game.wait(Until::Idle).loaded;
    let place = |x| {
        loaded
            .iter()
            .position(|coord| coord.index.x == x && coord.index.z == 0)
            .unwrap()
    };
    assert!(place(3) < place(-2), "the view goes along +x");
}

#[test]
fn chunks_go_one_beyond_the_range_and_come_back() {
    let mut game = Game::flat(2);
    let at = game.ground(16.0, 16.0);
    game.wish(at, 1);
    game.wait(Until::Idle);
    let first: Vec<_> = game.chunks.keys().copied().collect();
    game.wish(at + DVec3::X * 32.0, 1);
    assert!(game.wait(Until::Idle).unloaded.is_empty());
    game.wish(at + DVec3::X * 64.0, 1);
    let gone = game.wait(Until::Idle).unloaded;
    let want: Vec<_> = first
        .iter()
        .copied()
        .filter(|coord| coord.index.x < 0)
        .collect();
    assert_eq!(gone, want);
    game.wish(at, 1);
    game.wait(Until::Idle);
    assert!(first.iter().all(|coord| game.chunks.contains_key(coord)));
}

#[test]
fn loads_no_longer_wanted_are_dropped() {
    let (gate, watch) = Gate::at(|step| matches!(step, Step::Load(_)));
    let mut game = Game::new(Geometry::Euclidean, 1, None, Some(watch));
    let at = game.ground(16.0, 16.0);
    game.wish(at, 3);
    gate.wait();
    assert!(game.streamer.pending() > 20);
    let away = game.ground(16.0 + 3200.0, 16.0);
    game.wish(away, 1);
    gate.open();
    let loaded = game.wait(Until::Idle).loaded;
    assert!(
        !loaded.is_empty() && loaded.iter().all(|coord| coord.index.x >= 99),
        "{loaded:?}"
    );
}

#[test]
fn a_sphere_is_there_whole_and_stays() {
    let mut game = Game::new(Geometry::Spherical, 2, None, None);
    game.wish(DVec3::new(0.0, 8.0, 0.0), 1);
    game.wait(Until::Idle);
    let all = Range::wished(&*game.space, ChartPoint::a(DVec3::ZERO), 1, 0).all();
    assert!(all.iter().all(|&coord| game.streamer.is_resident(coord)));
    let sides = [ChartId::FIRST, ChartId::SECOND]
        .map(|h| game.chunks.keys().filter(|c| c.chart == h).count());
    assert!(sides[0] >= 4 && sides[1] >= 4, "{sides:?}");
    let across = ChartPoint::new(ChartId::SECOND, DVec3::new(10.0, 8.0, 3.0));
    game.streamer.wish(&Wish::new(across, DVec3::X, 1));
    let seen = game.wait(Until::Idle);
    assert!(seen.loaded.is_empty() && seen.unloaded.is_empty());
}

#[test]
fn a_wait_for_chunks_ends_with_them_and_not_with_everything() {
    let mut game = Game::flat(1);
    let at = game.ground(16.0, 16.0);
    game.wish(at, 3);
    let under = ChunkCoord::containing(ChartPoint::a(at));
    let nowhere = chunk(900, 0, 0);
    game.wait(Until::Chunks(&[under, nowhere]));
    assert!(game.chunks.contains_key(&under) && game.streamer.pending() > 20);
    game.wait(Until::Idle);
    assert_eq!(game.streamer.pending(), 0);
}

#[test]
fn a_poll_without_time_takes_one_result_at_most() {
    let mut game = Game::flat(2);
    let at = game.ground(16.0, 16.0);
    game.wish(at, 1);
    let want = game.streamer.pending();
    let mut loaded = 0;
    while game.streamer.pending() > 0 {
        let updates = game.streamer.poll(std::time::Duration::ZERO);
        assert!(updates.len() <= 1);
        loaded += game.apply(updates).loaded.len();
        std::thread::yield_now();
    }
    assert_eq!(loaded, want);
}

#[test]
fn workers_carry_their_names() {
    let names = Arc::new(Mutex::new(Vec::new()));
    let list = Arc::clone(&names);
    let watch: Watch = Arc::new(move |_| {
        list.lock()
            .unwrap()
            .extend(std::thread::current().name().map(str::to_owned));
    });
    let mut game = Game::new(Geometry::Euclidean, 1, None, Some(watch));
    let at = game.ground(16.0, 16.0);
    game.wish(at, 1);
    game.wait(Until::Idle);
    let names = names.lock().unwrap();
    assert!(
        !names.is_empty() && names.iter().all(|name| name == "antipode-chunk-1"),
        "{names:?}"
    );
}

/// Tells by which thread it is dropped.
struct Heirloom(Sender<Option<String>>);

impl Drop for Heirloom {
    fn drop(&mut self) {
        let _ = self
            .0
            .send(std::thread::current().name().map(str::to_owned));
    }
}

#[test]
fn what_the_game_discards_is_dropped_by_a_worker() {
    let mut game = Game::flat(1);
    let at = game.ground(16.0, 16.0);
    let (tell, told) = unbounded();
    game.streamer.discard(Heirloom(tell));
    assert!(told.try_recv().is_err());
    game.wish(at, 1);
    game.wait(Until::Idle);
    let by = told.recv_timeout(LIMIT).unwrap();
    assert_eq!(by.as_deref(), Some("antipode-chunk-1"));
}

#[test]
fn far_from_the_origin_the_same_holds() {
    let mut game = Game::flat(1);
    let at = game.ground(1.0e6, -1.0e6);
    game.wish(at, 1);
    game.wait(Until::Idle);
    let under = ChunkCoord::containing(ChartPoint::a(at));
    assert!(game.chunks[&under].collider.is_some());
    assert_eq!((under.index.x, under.index.z), (31_250, -31_250));
}
