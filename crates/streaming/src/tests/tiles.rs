//! Land of the hyperbolic world is there as far as one sees, whatever lies between, and stays where one crosses an edge.

use std::collections::BTreeSet;

use antipode_geometry::{Eye, HyperbolicWorld};
use antipode_terrain::Generator;
use glam::Vec3Swizzles;

use super::*;
use crate::api::Reach;

fn game(radius_m: f64) -> Game {
    let space = Arc::new(HyperbolicWorld::new(radius_m));
    let field = Field::made_by(Generator::Planted, SEED, space.clone());
    Game::on(field, space, 2, None, None)
}

fn on_ground(game: &Game, at: ChartPoint) -> ChartPoint {
    let height_m = game.field.surface_height(at.chart, at.pos.x, at.pos.z);
    ChartPoint::new(at.chart, at.pos.with_y(height_m))
}

fn look(game: &mut Game, at: ChartPoint, view: u32) -> Seen {
    game.streamer.wish(&Wish {
        bodies: vec![Reach::around(at, 4.0)],
        ..Wish::new(at, DVec3::X, view)
    });
    game.wait(Until::Idle)
}

/// The place so far along the level in a direction of the axes, in the chart that it belongs to.
fn gone(game: &Game, from: ChartPoint, turn_rad: f64, away_m: f64) -> ChartPoint {
    let eye = Eye {
        point: ChartPoint::new(from.chart, from.pos.with_y(0.0)),
        yaw: turn_rad,
        ..Eye::default()
    };
    on_ground(game, game.space.along(&eye, DVec3::NEG_Z, away_m))
}

#[test]
fn land_is_there_however_many_tiles_lie_between() {
    for (radius_m, view) in [(60.3, 5), (30.15, 3)] {
        let mut game = game(radius_m);
        let here = on_ground(&game, ChartPoint::a(DVec3::new(3.0, 0.0, 4.0)));
        look(&mut game, here, view);
        // The range is about the middle of the chunk, which is up to 23 m away.
        let view_m = (f64::from(view) + 0.5) * 32.0;
        let reach_m = game.space.tiled().unwrap().land_reach_m(view_m) - 23.0;
        let mut charts = BTreeSet::new();
        for turn in 0..16 {
            for share in [0.2, 0.4, 0.6, 0.8, 1.0] {
                let there = gone(&game, here, f64::from(turn) * 0.4, share * reach_m);
                let coord = ChunkCoord::containing(there);
                let is_level = (coord.index.y - ChunkCoord::containing(here).index.y).abs() < 2;
                assert!(!is_level || game.chunks.contains_key(&coord), "{there:?}");
                charts.insert(there.chart);
            }
        }
        assert!(charts.len() > 20, "{}", charts.len());
        // Nothing is there twice: what lies past an edge is only where bodies reach.
        let past = game.chunks.keys().filter(|coord| {
            let domain = game.space.domain(coord.chart);
            domain.least_outside_m(coord.origin().xz(), coord.origin().xz() + 32.0) >= 0.0
        });
        assert!(past.count() <= 2 * 9, "near the feet alone");
        assert!(game.problems.is_empty(), "{:?}", game.problems);
    }
}

/// Over an edge and at a corner, what was there stays, and so it does when one comes back.
#[test]
fn who_crosses_an_edge_has_nothing_loaded_again() {
    let mut game = game(60.3);
    let at = |game: &Game, x: f64, z: f64| {
        let place = on_ground(game, ChartPoint::a(DVec3::new(x, 0.0, z)));
        game.space.cross(place).map_or(place, |it| it.point)
    };
    let inside = at(&game, 31.0, 31.0);
    look(&mut game, inside, 3);
    let before: BTreeSet<_> = game.chunks.keys().copied().collect();
    for (x, z) in [(33.0, 31.0), (33.0, 33.0), (31.0, 33.0), (31.0, 31.0)] {
        let place = at(&game, x, z);
        let news = look(&mut game, place, 3);
        // Past an edge there is only what the body may touch.
        let is_land = |coord: &&ChunkCoord| {
            let domain = game.space.domain(coord.chart);
            let low = coord.origin().xz();
            domain.least_outside_m(low, low + 32.0) < 0.0
        };
        let far = news.loaded.iter().chain(&news.unloaded).filter(is_land);
        assert_eq!(far.count(), 0, "{x} {z}");
    }
    assert_eq!(game.chunks.keys().copied().collect::<BTreeSet<_>>(), before);
    // Farther on, what is near both places is kept.
    let place = at(&game, 46.0, 20.0);
    let news = look(&mut game, place, 3);
    let kept = before
        .iter()
        .filter(|it| game.chunks.contains_key(it))
        .count();
    assert!(place.chart != ChartId::FIRST && !news.loaded.is_empty());
    assert!(2 * kept > before.len(), "{kept} of {}", before.len());
}

/// A kilometre straight on: there is never more land than at first, and most of it is kept from step to step.
#[test]
fn a_long_walk_stays_bounded() {
    let mut game = game(30.15);
    let mut place = on_ground(&game, ChartPoint::a(DVec3::new(1.0, 0.0, 2.0)));
    look(&mut game, place, 2);
    let first = game.chunks.len();
    let (mut most, mut loaded) = (first, 0);
    for step in 0..42 {
        place = gone(&game, place, f64::from(step) * 0.01, 24.0);
        let seen = look(&mut game, place, 2);
        most = most.max(game.chunks.len());
        loaded += seen.loaded.len();
        let coord = ChunkCoord::containing(place);
        assert!(game.chunks.contains_key(&coord), "{place:?}");
    }
    assert!(most < 3 * first, "{most} after {first}");
    assert!(loaded < 42 * first, "{loaded} with {first} at a time");
    assert!(game.problems.is_empty(), "{:?}", game.problems);
}
