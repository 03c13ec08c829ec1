//! A cone is loaded, dug and unloaded about the player wherever he stands: all of it that is near, by whichever side of the
//! tip.

use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::FRAC_PI_2;

use antipode_geometry::Eye;
use antipode_testing::cone::Cone;

use super::*;
use crate::api::Reach;

fn look(game: &mut Game, at: ChartPoint) {
    let images = game.space.images(at, 12.0);
    let places = images.iter().map(|image| image.point).chain([at]);
    let wish = Wish {
        bodies: places.map(|place| Reach::around(place, 6.0)).collect(),
        ..Wish::new(at, DVec3::X, 2)
    };
    game.streamer.wish(&wish);
    game.wait(Until::Idle);
}

/// The place of the ground at an angle about the tip and a distance from it.
fn ground(game: &Game, angle_rad: f64, away_m: f64) -> ChartPoint {
    let at = Cone::around(angle_rad, away_m, 0.0);
    let height_m = game.field.surface_height(at.chart, at.pos.x, at.pos.z);
    at.moved(DVec3::Y * height_m)
}

fn triangles(game: &Game) -> BTreeMap<ChunkCoord, usize> {
    let count = |(coord, chunk): (&ChunkCoord, &Chunk)| (*coord, chunk.mesh.indices.len());
    game.chunks.iter().map(count).collect()
}

#[test]
fn all_land_that_is_near_is_there_by_whichever_side_of_the_tip() {
    let mut game = Game::in_space(Arc::new(Cone), 2, None, None);
    for (angle_rad, away_m) in [
        (0.8, 2.0),
        (0.02, 20.0),
        (3.1, 40.0),
        (4.6, 5.0),
        (2.0, 300.0),
    ] {
        let at = ground(&game, angle_rad, away_m);
        look(&mut game, at);
        let mut seen = BTreeSet::new();
        for step in 0..180 {
            let way = f64::from(step) * FRAC_PI_2 / 45.0;
            for far_m in [1.0, 8.0, 24.0, 44.0] {
                let eye = Eye {
                    point: at,
                    ..Eye::default()
                };
                let direction = DVec3::new(way.cos(), 0.0, way.sin());
                let there = game.space.along(&eye, direction, far_m);
                let (x, z) = (there.pos.x, there.pos.z);
                let height_m = game.field.surface_height(there.chart, x, z);
                let point = ChartPoint::new(there.chart, there.pos.with_y(height_m));
                let coord = ChunkCoord::containing(point);
                let is_level = (coord.index.y - ChunkCoord::containing(at).index.y).abs() < 2;
                assert!(
                    !is_level || game.chunks.contains_key(&coord),
                    "{at:?} {point:?}"
                );
                seen.insert(coord.chart);
            }
        }
        assert_eq!(seen.len(), if away_m > 100.0 { 1 } else { 3 }, "{away_m}");
    }
    assert!(game.problems.is_empty(), "{:?}", game.problems);
}

#[test]
fn a_hole_is_in_every_chart_that_has_it_and_stays() {
    for (angle_rad, away_m, charts) in [(0.8, 1.0, 3), (0.0, 20.0, 2), (3.0, 9.0, 2)] {
        let backend = Arc::new(Memory::default());
        let mut game = Game::in_space(Arc::new(Cone), 2, Some(backend), None);
        let at = ground(&game, angle_rad, away_m);
        look(&mut game, at);
        let whole = triangles(&game);
        game.streamer.edit(Stroke {
            centre: at,
            radius_m: 4.0,
            amount: 3.0,
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
        assert!(changed.len() >= charts, "{angle_rad} {changed:?}");
        let own = (
            at,
            game.samples(ChunkCoord::containing(at))
                .density(at.pos - ChunkCoord::containing(at).origin()),
        );
        assert!(own.1 > 1.0, "air where it was dug: {}", own.1);
        for image in game.space.images(at, 4.0) {
            let coord = ChunkCoord::containing(image.point);
            let here = game
                .samples(coord)
                .density(image.point.pos - coord.origin());
            assert!((here - own.1).abs() < 0.1, "{here} {}", own.1);
        }
        let away = ground(&game, angle_rad, 900.0);
        look(&mut game, away);
        assert!(game.chunks.keys().all(|coord| !dug.contains_key(coord)));
        look(&mut game, at);
        assert_eq!(triangles(&game), dug);
    }
}
