//! A world of charts without number is loaded, dug and unloaded around the player as one of one chart is.

use std::collections::{BTreeMap, BTreeSet};

use antipode_geometry::Atlas;
use antipode_testing::tiled::TiledFlat;
use glam::DVec2;

use super::*;

/// Half the edge of a square, metres.
const HALF_M: f64 = 32.0;

fn tiled() -> Game {
    Game::in_space(Arc::new(TiledFlat), 2, None, None)
}

fn look(game: &mut Game, at: ChartPoint) {
    game.streamer.wish(&Wish::new(at, DVec3::X, 2));
    game.wait(Until::Loads);
}

/// The chunks of flat space that are there, each with what its mesh covers of its chunk, once.
fn columns(game: &Game) -> BTreeSet<[i32; 3]> {
    let own = game.chunks.keys().filter(|coord| {
        let inside = TiledFlat.domain(coord.chart);
        let middle = coord.centre();
        inside.outside_m(DVec2::new(middle.x, middle.z)) < 0.0
    });
    own.map(|coord| {
        let common = TiledFlat::common(ChartPoint::new(coord.chart, coord.centre()));
        (common / 32.0).floor().as_ivec3().to_array()
    })
    .collect()
}

#[test]
fn the_same_land_is_there_wherever_one_goes_and_by_whichever_way() {
    let (mut one, mut many) = (Game::flat(2), tiled());
    for (x, z) in [
        (3.0, 5.0),
        (30.0, 31.0),
        (60.0, -40.0),
        (500.0, 470.0),
        (30.0, 31.0),
    ] {
        let place = one.ground(x, z);
        look(&mut one, ChartPoint::a(place));
        look(&mut many, TiledFlat::at(place));
        let alone: BTreeSet<_> = one.chunks.keys().map(|it| it.index.to_array()).collect();
        let beyond: Vec<_> = alone.difference(&columns(&many)).copied().collect();
        assert_eq!(beyond, Vec::<[i32; 3]>::new(), "{x} {z}");
        assert_eq!(columns(&many).len(), alone.len(), "{x} {z}");
        let charts: BTreeSet<_> = many.chunks.keys().map(|it| it.chart).collect();
        assert!((9..=25).contains(&charts.len()), "{}", charts.len());
    }
    assert!(many.problems.is_empty(), "{:?}", many.problems);
}

/// A hole at a corner is in all four squares, and still there after one has been far away.
#[test]
fn a_hole_at_a_corner_is_in_every_chart_that_meets_there_and_stays() {
    let backend = Arc::new(Memory::default());
    let mut game = Game::in_space(Arc::new(TiledFlat), 2, Some(backend), None);
    let flat = Game::flat(1);
    let place = flat.ground(HALF_M, HALF_M);
    let at = TiledFlat::at(place);
    look(&mut game, at);
    let whole = triangles(&game);
    game.streamer.edit(Stroke {
        centre: at,
        radius_m: 4.0,
        amount: 2.0,
        part: antipode_terrain::Part::Whole,
        kind: None,
        shape: antipode_terrain::Shape::Ball,
        power: None,
    });
    game.wait(Until::Idle);
    let dug = triangles(&game);
    let changed: BTreeSet<_> = dug
        .iter()
        .filter(|(coord, count)| whole.get(coord) != Some(count))
        .map(|(coord, _)| coord.chart)
        .collect();
    assert!(changed.len() >= 4, "{changed:?}");
    look(&mut game, TiledFlat::at(place + DVec3::X * 900.0));
    assert!(game.chunks.keys().all(|coord| !dug.contains_key(coord)));
    look(&mut game, at);
    assert_eq!(triangles(&game), dug);
}

fn triangles(game: &Game) -> BTreeMap<ChunkCoord, usize> {
    let count = |(coord, chunk): (&ChunkCoord, &Chunk)| (*coord, chunk.mesh.indices.len());
    game.chunks.iter().map(count).collect()
}
