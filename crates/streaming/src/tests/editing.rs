//! Edits: one batch in one update, nothing lost, surfaces where there was none.

use std::collections::BTreeSet;

use antipode_geometry::{ChartId, ChartPoint, ChunkCoord, Geometry};
use antipode_terrain::{ChunkMesh, Content, EDIT_STEP, UNITS_PER_M};
use glam::{DVec3, IVec3};

use super::{Game, Gate, stroke};
use crate::api::Until;
use crate::shared::Step;

/// The corner of eight chunks nearest to the ground above (0, 0).
fn corner(game: &Game) -> DVec3 {
    let y = game.ground(0.0, 0.0).y;
    DVec3::new(0.0, (y / 32.0).round() * 32.0, 0.0)
}

/// The vertices of a mesh in one plane, exactly, without that plane's own coordinate.
fn on_face(mesh: &ChunkMesh, axis: usize, plane_m: u32) -> BTreeSet<[u16; 2]> {
    let others = [[1, 2], [0, 2], [0, 1]][axis];
    let on = mesh
        .vertices
        .iter()
        .filter(|vertex| u32::from(vertex.units[axis]) == plane_m * UNITS_PER_M);
    on.map(|vertex| others.map(|other| vertex.units[other]))
        .collect()
}

#[test]
fn an_edit_at_a_corner_of_eight_chunks_is_one_batch_whose_faces_match() {
    let mut game = Game::flat(2);
    let at = corner(&game);
    game.wish(at, 1);
    game.wait(Until::Idle);
    let solid = game.field.sample(ChartPoint::a(at)) < 0.0;
    game.edit(at, if solid { 60.0 } else { -60.0 });
    let seen = game.wait(Until::Edits);
    assert_eq!(seen.batches.len(), 1);
    let batch: BTreeSet<_> = seen.batches[0].iter().copied().collect();
    assert!(batch.len() >= 8 && batch.len() == seen.batches[0].len());
    let mut compared = 0;
    for &coord in &batch {
        for axis in 0..3 {
            let next = ChunkCoord {
                index: coord.index + IVec3::AXES[axis],
                ..coord
            };
            if !batch.contains(&next) {
                continue;
            }
            let here = on_face(&game.chunks[&coord].mesh, axis, 32);
            assert_eq!(
                here,
                on_face(&game.chunks[&next].mesh, axis, 0),
                "{coord:?} axis {axis}"
            );
            compared += here.len();
        }
    }
    assert!(compared > 20, "the hole crosses the faces");
}

#[test]
fn strokes_made_while_a_batch_is_in_flight_add_up() {
    let (gate, watch) = Gate::at(|step| step == Step::Apply);
    let mut game = Game::new(Geometry::Euclidean, 1, None, Some(watch));
    let at = game.ground(12.0, 12.0).round();
    game.wish(at, 1);
    game.wait(Until::Idle);
    let before = game.sample(at.as_ivec3());
    for n in 0..40 {
        game.edit(at, 0.25);
        if n == 0 {
            gate.wait();
        }
    }
    gate.open();
    let seen = game.wait(Until::Edits);
    assert_eq!(
        seen.batches.len(),
        2,
        "the first stroke, then all the others at once"
    );
    let change = game.sample(at.as_ivec3()) - before;
    assert!((change - 10.0).abs() <= 2.0 * EDIT_STEP, "{change}");
}

#[test]
fn two_hundred_rapid_strokes_are_all_there() {
    let mut game = Game::flat(2);
    let places: Vec<_> = (0..20)
        .map(|n| game.ground(f64::from(n) * 3.0 - 30.0, 5.0))
        .collect();
    game.wish(places[10], 1);
    game.wait(Until::Idle);
    let middle = places[10].round().as_ivec3();
    let before = game.sample(middle);
    let mut batches = 0;
    for n in 0..200 {
        game.edit(places[n % 20], 0.125);
        let updates = game.streamer.poll(std::time::Duration::from_millis(1));
        batches += game.apply(updates).batches.len();
    }
    batches += game.wait(Until::Edits).batches.len();
    let inside = |place: &&DVec3| place.distance(middle.as_dvec3()) <= 5.0;
    let want: f64 = places
        .iter()
        .filter(inside)
        .map(|place| 10.0 * 0.125 * (-0.1 * place.distance_squared(middle.as_dvec3())).exp())
        .sum();
    let change = f64::from(game.sample(middle) - before);
    // Each of the strokes that reach the sample is rounded once.
    let rounding = 10.0 * places.iter().filter(inside).count() as f64 * f64::from(EDIT_STEP);
    assert!(
        want > 1.0 && (change - want).abs() <= rounding,
        "{change} instead of {want}"
    );
    assert!((1..=200).contains(&batches));
}

#[test]
fn an_edit_outside_the_limits_blocks_nothing() {
    let mut game = Game::new(Geometry::Spherical, 1, None, None);
    game.wish(DVec3::new(0.0, 8.0, 0.0), 1);
    game.wait(Until::Idle);
    let high = game.space.limits().unwrap().ceiling_m + 30.0;
    game.edit(DVec3::new(2.0, high, 2.0), -9.0);
    assert!(game.wait(Until::Edits).batches.is_empty());
    assert_eq!(
        (game.streamer.pending(), game.streamer.edited_count()),
        (0, 0)
    );
    let at = game.ground(2.0, 2.0);
    game.edit(at, 9.0);
    assert_eq!(game.wait(Until::Edits).batches.len(), 1);
}

#[test]
fn an_edit_at_the_equator_changes_both_charts_in_one_batch() {
    let mut game = Game::new(Geometry::Spherical, 2, None, None);
    game.wish(DVec3::new(0.0, 8.0, 0.0), 1);
    game.wait(Until::Idle);
    let at = game.ground(game.space.domain(ChartId::FIRST).radius_m().unwrap(), 0.0);
    game.edit(at, 20.0);
    let batches = game.wait(Until::Edits).batches;
    assert_eq!(batches.len(), 1);
    let sides: BTreeSet<_> = batches[0].iter().map(|coord| coord.chart).collect();
    assert_eq!(sides.len(), 2);
}

#[test]
fn building_in_an_air_chunk_gives_it_a_mesh_that_comes_back() {
    build_or_mine(Content::Air, 10, -200.0);
}

#[test]
fn mining_in_a_solid_chunk_gives_it_a_mesh_that_comes_back() {
    build_or_mine(Content::Solid, -10, 3000.0);
}

fn build_or_mine(content: Content, step: i32, amount: f32) {
    let mut game = Game::flat(1);
    let ground = ChunkCoord::containing(ChartPoint::a(game.ground(16.0, 16.0)));
    let find = |n: i32| ChunkCoord {
        index: ground.index + IVec3::Y * n * step.signum(),
        ..ground
    };
    let coord = (1..=step.abs())
        .map(find)
        .find(|&coord| game.field.content(coord) == content)
        .unwrap();
    let middle = coord.origin() + DVec3::splat(16.0);
    game.wish(middle, 2);
    game.wait(Until::Idle);
    assert!(game.streamer.is_resident(coord) && !game.chunks.contains_key(&coord));
    // A deep chunk may be denser than one stroke can take away.
    while game
        .chunks
        .get(&coord)
        .is_none_or(|chunk| chunk.collider.is_none())
    {
        game.edit(middle, amount);
        assert_eq!(game.wait(Until::Edits).batches, [[coord]]);
        assert!(
            game.sample(middle.as_ivec3()).abs() < 1.0e4,
            "the edits never reach the surface"
        );
    }
    let triangles = game.chunks[&coord].mesh.triangles().len();
    game.wish(middle + DVec3::X * 320.0, 1);
    assert!(game.wait(Until::Idle).unloaded.contains(&coord));
    game.wish(middle, 2);
    assert!(!game.streamer.is_resident(coord));
    game.wait(Until::Idle);
    assert_eq!(game.chunks[&coord].mesh.triangles().len(), triangles);
}

#[test]
fn an_edit_where_nothing_is_resident_is_kept_for_later() {
    let mut game = Game::flat(1);
    let at = game.ground(16.0, 16.0);
    game.streamer.edit(stroke(at, 8.0));
    assert!(game.wait(Until::Edits).batches.is_empty());
    assert!(game.streamer.edited_count() > 0);
    game.wish(at, 1);
    game.wait(Until::Idle);
    let here = at.round();
    let base = game.field.sample(ChartPoint::a(here));
    assert!(game.sample(here.as_ivec3()) > base + 4.0);
}
