//! Ground is solid where bodies are and nowhere else, and edits build anew only what they change.

use std::time::Duration;

use antipode_geometry::{ChartPoint, ChunkCoord};
use glam::DVec3;

use super::{Game, stroke};
use crate::api::{Reach, Until, Wish};

impl Game {
    /// A wish with one body that reaches 20 m.
    fn walk(&mut self, at: DVec3, view_distance: u32) {
        let point = ChartPoint::a(at);
        self.streamer.wish(&Wish {
            bodies: vec![Reach::around(point, 20.0)],
            ..Wish::new(point, DVec3::X, view_distance)
        });
    }

    fn is_solid(&self, coord: ChunkCoord) -> bool {
        self.chunks
            .get(&coord)
            .is_some_and(|chunk| chunk.samples.is_some())
    }
}

fn touches(coord: ChunkCoord, at: DVec3, reach_m: f64) -> bool {
    let nearest = at.clamp(coord.min(), coord.max());
    (nearest - at).abs().max_element() < reach_m
}

#[test]
fn only_ground_near_a_body_has_colliders_and_samples() {
    let mut game = Game::flat(2);
    let at = game.ground(16.0, 16.0);
    game.walk(at, 3);
    game.wait(Until::Idle);
    let (near, far): (Vec<_>, Vec<_>) = game
        .chunks
        .values()
        .partition(|chunk| touches(chunk.coord, at, 20.0));
    assert!(near.len() >= 9 && far.len() >= 20);
    for chunk in near {
        assert!(chunk.is_solid(), "{chunk:?}");
        assert_eq!(chunk.collider.is_none(), chunk.mesh.is_empty());
    }
    assert!(
        far.iter()
            .all(|chunk| !chunk.is_solid() && chunk.collider.is_none())
    );
}

#[test]
fn ground_becomes_solid_ahead_of_a_body_and_lets_go_behind_without_new_meshes() {
    let mut game = Game::flat(1);
    let at = game.ground(16.0, 16.0);
    game.walk(at, 6);
    game.wait(Until::Idle);
    let there = at + DVec3::X * 100.0;
    game.walk(there, 6);
    assert!(
        !game
            .streamer
            .is_ready(ChunkCoord::containing(ChartPoint::a(there)))
    );
    let seen = game.wait(Until::Bodies);
    let made: Vec<_> = seen.solid.iter().filter(|(_, solid)| *solid).collect();
    assert!(!made.is_empty() && made.iter().all(|(coord, _)| touches(*coord, there, 20.0)));
    let mut left = seen.solid.iter().filter(|(_, solid)| !solid);
    assert!(left.all(|(coord, _)| touches(*coord, at, 20.0)));
    for coord in game.chunks.keys().copied().collect::<Vec<_>>() {
        if touches(coord, there, 20.0) {
            assert!(game.is_solid(coord) && game.streamer.is_ready(coord));
        }
    }
    let under = ChunkCoord::containing(ChartPoint::a(at));
    assert!(!game.is_solid(under) && game.chunks[&under].collider.is_none());
    let known: Vec<_> = seen
        .loaded
        .iter()
        .filter(|c| touches(**c, there, 20.0))
        .collect();
    assert!(
        known.is_empty(),
        "what is shown already is not shown again: {known:?}"
    );
}

#[test]
fn shown_ground_becomes_solid_and_ceases_to_be_one_chunk_a_frame() {
    let mut game = Game::flat(1);
    let at = game.ground(16.0, 16.0);
    game.walk(at, 6);
    game.wait(Until::Idle);
    let there = at + DVec3::X * 100.0;
    game.walk(there, 6);
    let (mut solid, mut hollow) = (0, 0);
    while game.streamer.pending() > 0 || hollow < 4 {
        let updates = game.streamer.poll(Duration::from_secs(1));
        let seen = game.apply(updates).solid;
        assert!(seen.len() <= 1, "{seen:?}");
        solid += seen.iter().filter(|(_, solid)| *solid).count();
        hollow += seen.iter().filter(|(_, solid)| !solid).count();
        std::thread::yield_now();
    }
    assert!(solid >= 4 && hollow >= 4, "{solid} {hollow}");
}

#[test]
fn the_samples_of_solid_ground_hold_its_edits() {
    let mut game = Game::flat(1);
    let at = game.ground(16.0, 16.0).round();
    game.walk(at, 6);
    game.wait(Until::Idle);
    let before = game.sample(at.as_ivec3());
    game.edit(at, 3.0);
    game.wait(Until::Edits);
    game.walk(at + DVec3::X * 150.0, 6);
    game.wait(Until::Idle);
    assert!(!game.is_solid(ChunkCoord::containing(ChartPoint::a(at))));
    game.walk(at, 6);
    game.wait(Until::Bodies);
    assert!((game.sample(at.as_ivec3()) - before - 3.0).abs() < 0.01);
}

#[test]
fn an_edit_far_from_every_body_is_shown_without_colliders() {
    let mut game = Game::flat(1);
    let at = game.ground(16.0, 16.0);
    game.walk(at, 6);
    game.wait(Until::Idle);
    let away = game.ground(140.0, 16.0);
    let under = ChunkCoord::containing(ChartPoint::a(away));
    let before = std::sync::Arc::clone(&game.chunks[&under].mesh);
    game.streamer.edit(stroke(away, 30.0));
    assert_eq!(game.wait(Until::Edits).batches.len(), 1);
    assert!(!game.is_solid(under) && game.chunks[&under].mesh != before);
}

#[test]
fn a_stroke_builds_only_the_parts_of_a_collider_that_it_changes() {
    let mut game = Game::flat(1);
    let at = game.ground(5.0, 5.0);
    game.walk(at, 1);
    game.wait(Until::Idle);
    let coord = ChunkCoord::containing(ChartPoint::a(at));
    let mut parts = Vec::new();
    for _ in 0..3 {
        let before = game.chunks[&coord].collider.clone().expect("ground");
        game.streamer.edit(stroke(at, 2.0));
        game.wait(Until::Edits);
        let after = game.chunks[&coord].collider.as_ref().expect("ground");
        parts.push(after.shared_parts(&before));
    }
    // The first edit of a chunk has nothing to go by.
    assert!(
        parts[1..]
            .iter()
            .all(|&(shared, all)| all >= 2 && shared >= all - 2),
        "{parts:?}"
    );
    assert!(
        parts[1..].iter().any(|&(shared, _)| shared >= 1),
        "{parts:?}"
    );
}
