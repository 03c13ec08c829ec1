//! What strokes move is what the meshes say, and undone they leave nothing.

use std::collections::BTreeMap;
use std::sync::Arc;

use antipode_geometry::{ChartId, ChunkCoord, Geometry, strategy};
use antipode_storage::WorldStore;
use antipode_terrain::{Kind, Shape, Stroke, Vertex};
use glam::{DVec2, DVec3, Vec3Swizzles};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

use super::saving::meta;
use super::{Game, stroke};
use crate::api::{NotUndone, Until};
use crate::edit_backend::EditBackend;

const RADIUS_M: f64 = 32.0;

fn open(geometry: Geometry, backend: Option<Arc<dyn EditBackend>>) -> Game {
    let mut game = Game::in_space(strategy(geometry, RADIUS_M), 2, backend, None);
    let at = game.ground(0.0, 0.0);
    game.wish(at, 1);
    game.wait(Until::Idle);
    game
}

/// Solid ground below all triangles, in cubic metres of the space, but for what is the same before and after a stroke.
///
/// A triangle stands for the upright prism below it, signed as it faces. In a closed world of the radius R the space's
/// volume is `cos^2(y / R) sin(r / R) / (r / R)` times that of the chart, the first of which is integrated over the
/// height.
fn solid_m3(game: &Game, geometry: Geometry) -> f64 {
    let is_closed = geometry == Geometry::Spherical;
    let below = |y: f64| {
        if is_closed {
            0.5 * y + 0.25 * RADIUS_M * (2.0 * y / RADIUS_M).sin()
        } else {
            y
        }
    };
    let round = |middle: DVec2| {
        let r = middle.length() / RADIUS_M;
        if is_closed { r.sin() / r } else { 1.0 }
    };
    let mut sum = 0.0;
    for (coord, chunk) in &game.chunks {
        let positions = chunk.mesh.positions();
        for triangle in chunk.mesh.triangles() {
            let corner = |n: u32| {
                let local = positions[n as usize];
                coord.origin() + DVec3::from(local.map(f64::from))
            };
            let domain = game.space.domain(coord.chart);
            for [a, b, c] in parts(triangle.map(corner)) {
                let middle = (a + b + c).xz() / 3.0;
                if domain.outside_m(middle) > 0.0 {
                    continue;
                }
                let upward = 0.5 * (b - a).cross(c - a).y;
                let height = [a + b, b + c, c + a].map(|it| below(0.5 * it.y));
                sum += upward * round(middle) * height.iter().sum::<f64>() / 3.0;
            }
        }
    }
    sum
}

/// Sixteen parts of a triangle, so that little of one is on the wrong side of a chart's edge.
fn parts([a, b, c]: [DVec3; 3]) -> Vec<[DVec3; 3]> {
    let quarters = |[a, b, c]: [DVec3; 3]| {
        let [ab, bc, ca] = [a + b, b + c, c + a].map(|it| 0.5 * it);
        [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
    };
    quarters([a, b, c]).into_iter().flat_map(quarters).collect()
}

fn shapes(level_m: f64) -> [Shape; 5] {
    let height_m = level_m - 0.7;
    [
        Shape::Ball,
        Shape::Box,
        Shape::Cylinder,
        Shape::Flatten { height_m },
        Shape::Smooth,
    ]
}

#[test]
fn what_is_dug_and_built_is_what_the_meshes_lose_and_gain() {
    for geometry in [
        Geometry::Euclidean,
        Geometry::Hyperbolic,
        Geometry::Spherical,
    ] {
        let mut game = open(geometry, None);
        let mut press = 0;
        for (x, z) in [(3.0, -7.0), (-17.5, 11.25)] {
            let ground = game.ground(x, z);
            for shape in shapes(ground.y) {
                for sign in [1.0, -1.0] {
                    press += 1;
                    let before = solid_m3(&game, geometry);
                    let mut told = 0.0;
                    for n in 0..12 {
                        let aside = DVec3::X * 0.2 * f64::from(n);
                        let it = Stroke {
                            shape,
                            power: None,
                            radius_m: 3.3,
                            ..stroke(ground + aside, sign * 0.6)
                        };
                        game.streamer.edit_in(Some(press), it);
                        told += game.wait(Until::Edits).earth.gained_m3();
                    }
                    let lost = before - solid_m3(&game, geometry);
                    let off = (told - lost).abs();
                    // Vertices keep two millimetres off the ends of their edges.
                    let fits = off <= 0.01 * lost.abs().max(told.abs()).max(0.5);
                    assert!(fits, "{geometry} {shape:?} {sign}: {told} for {lost}");
                    // What is flat stays so.
                    let moves = matches!(shape, Shape::Ball | Shape::Box | Shape::Cylinder);
                    assert!(!moves || lost.abs() > 1.0, "{shape:?}");
                }
            }
        }
    }
}

#[test]
fn what_is_dug_over_the_equator_counts_once() {
    let mut game = open(Geometry::Spherical, None);
    let rim = game.space.domain(ChartId::FIRST).radius_m().unwrap();
    let ground = game.ground(rim - 0.4, 2.0);
    let before = solid_m3(&game, Geometry::Spherical);
    game.streamer.edit_in(Some(1), stroke(ground, 3.0));
    let told = game.wait(Until::Edits).earth.gained_m3();
    let lost = before - solid_m3(&game, Geometry::Spherical);
    assert!(lost > 5.0);
    assert!((told - lost).abs() < 0.03 * lost, "{told} for {lost}");
}

#[test]
fn what_was_built_of_a_kind_is_spent_of_it_and_dug_as_it() {
    let mut game = open(Geometry::Euclidean, None);
    let at = game.ground(5.0, 5.0) + DVec3::Y * 2.0;
    let snow = Stroke {
        kind: Some(Kind::Snow),
        ..stroke(at, -6.0)
    };
    game.streamer.edit_in(Some(1), snow);
    let built = game.wait(Until::Edits).earth;
    let of_snow = built.built_m3(Kind::Snow);
    assert!(
        of_snow > 5.0 && of_snow > -0.8 * built.gained_m3(),
        "{built:?}"
    );
    game.streamer.edit_in(Some(2), stroke(at, 9.0));
    let dug = game.wait(Until::Edits).earth;
    assert!(dug.dug_m3(Kind::Snow) > 0.9 * of_snow, "{dug:?}");
    let others = dug.gained_m3() - dug.dug_m3(Kind::Snow);
    assert!(others > 0.5, "below the snow was something else: {dug:?}");
}

/// A stroke of everything that a player can do, about a place of the ground.
fn any_stroke() -> impl Strategy<Value = (DVec2, usize, f32, f64, Option<Kind>)> {
    let kind = proptest::option::of(0..Kind::ALL.len());
    let amount = prop_oneof![0.2..4.0_f32, -4.0..-0.2_f32];
    let place = (-6.0..6.0, -6.0..6.0).prop_map(|(x, z)| DVec2::new(x, z));
    (place, 0..5_usize, amount, 1.0..5.0, kind)
        .prop_map(|(at, shape, amount, r, kind)| (at, shape, amount, r, kind.map(|n| Kind::ALL[n])))
}

/// Chunks with what can be told of their ground.
fn told(game: &Game) -> BTreeMap<ChunkCoord, (Vec<u32>, Vec<Vertex>)> {
    let chunks = game.chunks.iter().map(|(coord, chunk)| {
        let samples = chunk.samples.as_ref().unwrap();
        let values = samples.values().iter().map(|value| value.to_bits());
        (*coord, (values.collect(), chunk.mesh.vertices.clone()))
    });
    chunks.collect()
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 12,
        rng_seed: RngSeed::Fixed(5),
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    /// In the middle of the land, over a corner of chunks, and over the equator.
    #[test]
    fn presses_undone_leave_ground_and_records_as_they_were(
        strokes in proptest::collection::vec(any_stroke(), 1..8), place in 0..3_usize, closed: bool, before: bool,
    ) {
        let geometry = if closed { Geometry::Spherical } else { Geometry::Euclidean };
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("world");
        let world = WorldStore::create(&path, &meta()).unwrap();
        let store = Arc::new(world);
        let mut game = open(geometry, Some(Arc::clone(&store) as Arc<dyn EditBackend>));
        let rim = game.space.domain(ChartId::FIRST).radius_m().unwrap_or(40.0);
        let middle = [DVec2::new(9.0, 12.0), DVec2::ZERO, DVec2::new(rim, 0.0)][place];
        if before {
            let at = game.ground(middle.x, middle.y);
            game.streamer.edit(Stroke { kind: Some(Kind::Clay), ..stroke(at, -2.0) });
            game.wait(Until::Edits);
        }
        let first = told(&game);
        let mut earth = antipode_terrain::Earth::default();
        for (press, (at, shape, amount, radius_m, kind)) in (1..).zip(&strokes) {
            let at = game.ground(middle.x + at.x, middle.y + at.y);
            for _ in 0..3 {
                let shape = shapes(at.y)[*shape];
                game.streamer.edit_in(Some(press), Stroke { shape, radius_m: *radius_m, kind: *kind, ..stroke(at, *amount) });
                earth.add(&game.wait(Until::Edits).earth);
            }
        }
        for _ in &strokes {
            game.streamer.undo();
            for end in game.wait(Until::Edits).undone {
                earth.take_back(&end.unwrap());
            }
        }
        prop_assert!(earth.is_nothing(), "{earth:?}");
        for (coord, (values, mesh)) in told(&game) {
            match first.get(&coord) {
                Some(was) => prop_assert!(was.0 == values && was.1 == mesh, "{coord:?}"),
                None => prop_assert!(mesh.is_empty(), "{coord:?} had no surface"),
            }
        }
        let expected = if before { game.streamer.edited_count() } else { 0 };
        prop_assert_eq!(game.streamer.edited_count(), expected);
        game.streamer.close().unwrap();
        prop_assert_eq!(store.edited_chunks().unwrap().len(), expected);
    }
}

#[test]
fn what_cannot_be_undone_stays_and_is_told() {
    let mut game = open(Geometry::Euclidean, None);
    let undo = |game: &mut Game| {
        game.streamer.undo();
        let mut told = game.wait(Until::Edits).undone;
        told.extend(game.wait(Until::Idle).undone);
        told
    };
    assert_eq!(undo(&mut game), [Err(NotUndone::NoneLeft)]);

    let at = game.ground(2.0, 3.0);
    game.streamer.edit_in(Some(1), stroke(at, 2.0));
    game.wait(Until::Edits);
    game.edit(at, 1.0);
    game.wait(Until::Edits);
    let before = told(&game);
    assert_eq!(undo(&mut game), [Err(NotUndone::Changed)]);
    assert!(told(&game) == before, "nothing is changed");
    assert_eq!(undo(&mut game), [Err(NotUndone::NoneLeft)]);

    game.streamer.edit_in(Some(2), stroke(at, 2.0));
    game.wait(Until::Edits);
    game.wish(at + DVec3::X * 400.0, 1);
    game.wait(Until::Idle);
    assert_eq!(undo(&mut game), [Err(NotUndone::Away)]);
    game.wish(at, 1);
    game.wait(Until::Idle);
    assert!(matches!(undo(&mut game)[..], [Ok(_)]), "back again");
    assert!(told(&game) == before);
}

#[test]
fn the_last_twenty_presses_can_be_undone() {
    let mut game = open(Geometry::Euclidean, None);
    let at = game.ground(2.0, 3.0);
    for press in 1..=23 {
        game.streamer.edit_in(Some(press), stroke(at, 0.1));
        game.wait(Until::Edits);
    }
    let mut ends = Vec::new();
    for _ in 0..22 {
        game.streamer.undo();
        ends.extend(game.wait(Until::Edits).undone);
    }
    ends.extend(game.wait(Until::Idle).undone);
    let undone = ends.iter().filter(|end| end.is_ok()).count();
    assert_eq!((undone, ends.len()), (20, 22));
}
