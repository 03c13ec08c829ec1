//! Levels of detail with real meshes: what is far is coarse, and edits show at every level.

use std::collections::BTreeSet;
use std::sync::Arc;

use antipode_geometry::{ChartId, ChartPoint, ChunkCoord, Geometry};
use antipode_terrain::{Level, Stroke};
use glam::{DVec3, IVec3};

use super::{Game, stroke};
use crate::api::{Detail, Until, Wish};
use crate::levels::faces;

/// A flat picture whose pixels are so coarse that all levels fit in a few chunks.
#[derive(Debug)]
struct Coarse(DVec3);

impl Detail for Coarse {
    fn pixels_per_metre(&self, coord: ChunkCoord) -> f64 {
        let nearest = self.0.clamp(coord.min(), coord.max());
        30.0 / nearest.distance(self.0).max(1e-6)
    }

    fn span_px(&self, coord: ChunkCoord) -> f64 {
        32.0 * self.pixels_per_metre(coord)
    }

    fn tolerance_px(&self) -> f64 {
        1.0
    }
}

impl Game {
    fn look(&mut self, at: DVec3, view_distance: u32) {
        let point = ChartPoint::a(at);
        self.streamer.wish(&Wish {
            bodies: Vec::new(),
            detail: Some(Arc::new(Coarse(at))),
            ..Wish::new(point, DVec3::X, view_distance)
        });
    }

    /// Looks from somewhere from where full land ends in a face that the ground crosses well within.
    fn look_over_full_land(&mut self) -> (DVec3, ChunkCoord, DVec3) {
        for place in 0..16 {
            let at = self.ground(16.0 + 48.0 * f64::from(place), 16.0);
            self.look(at, 8);
            self.wait(Until::Idle);
            if let Some((coarse, edge)) = self.edge_of_full_land() {
                return (at, coarse, edge);
            }
        }
        panic!("full land ends somewhere");
    }

    /// A chunk of 2 m cells beside a full one along x, and a place of the ground in their common face.
    fn edge_of_full_land(&self) -> Option<(ChunkCoord, DVec3)> {
        self.chunks.values().find_map(|chunk| {
            let coord = chunk.coord;
            let full = coord.offset(-IVec3::X);
            let level = |coord| {
                self.chunks
                    .get(&coord)
                    .map(|chunk| chunk.mesh.level.index())
            };
            let corner = coord.origin();
            let edge = self.ground(corner.x, corner.z + 16.0);
            let inside = edge.y > corner.y + 6.0 && edge.y < corner.y + 26.0;
            let fits = inside && level(coord) == Some(1) && level(full) == Some(0);
            fits.then_some((coord, edge))
        })
    }

    fn levels(&self) -> BTreeSet<Level> {
        self.chunks.values().map(|chunk| chunk.mesh.level).collect()
    }
}

#[test]
fn far_land_is_coarse_and_no_two_neighbours_are_far_apart_on_the_way() {
    let mut game = Game::flat(2);
    let at = game.ground(16.0, 16.0);
    for way in [0.0, 70.0, 200.0, 10.0] {
        game.look(at + DVec3::X * way, 8);
        while game.streamer.pending() > 0 {
            let updates = game.streamer.poll(std::time::Duration::ZERO);
            game.apply(updates);
            for chunk in game.chunks.values() {
                for next in
                    faces(&*game.space, chunk.coord).filter_map(|next| game.chunks.get(&next))
                {
                    let apart = next.mesh.level.index().abs_diff(chunk.mesh.level.index());
                    assert!(apart <= 1, "{chunk:?} {next:?}");
                }
            }
            std::thread::yield_now();
        }
        assert!(game.levels().len() >= 3, "{:?}", game.levels());
    }
}

#[test]
fn a_coarse_world_has_far_fewer_triangles_and_the_same_chunks() {
    let triangles = |game: &Game| -> usize {
        game.chunks
            .values()
            .map(|chunk| chunk.mesh.triangles().len())
            .sum()
    };
    let (mut coarse, mut full) = (Game::flat(2), Game::flat(2));
    let at = coarse.ground(16.0, 16.0);
    coarse.look(at, 7);
    coarse.wait(Until::Idle);
    full.wish(at, 7);
    full.wait(Until::Idle);
    assert!(coarse.chunks.keys().eq(full.chunks.keys()));
    assert!(triangles(&coarse) * 3 < triangles(&full));
}

#[test]
fn an_edit_shows_at_every_level() {
    let mut game = Game::flat(1);
    let at = game.ground(16.0, 16.0);
    game.look(at, 8);
    game.wait(Until::Idle);
    let levels = game.levels();
    for level in levels {
        let here = |chunk: &&crate::api::Chunk| chunk.mesh.level == level && !chunk.mesh.is_empty();
        let found = game.chunks.values().find(here).map(|chunk| chunk.coord);
        let coord = found.expect("a chunk of each level");
        let middle = game.chunks[&coord].mesh.vertices[0].position().as_dvec3();
        let before = Arc::clone(&game.chunks[&coord].mesh);
        game.streamer.edit(stroke(coord.origin() + middle, 60.0));
        let seen = game.wait(Until::Edits);
        assert!(
            seen.batches.iter().flatten().any(|&c| c == coord),
            "{level:?}"
        );
        let after = &game.chunks[&coord].mesh;
        assert!(after.level <= level && **after != *before, "{level:?}");
        game.wait(Until::Idle);
    }
}

#[test]
fn a_coarse_neighbour_looks_the_same_whether_it_was_there_before_the_edit_or_came_after() {
    let mut game = Game::flat(1);
    let (at, coarse, edge) = game.look_over_full_land();
    // Over the last sample but one before the face: full cells end at it, those of 2 m do not.
    let stroke = Stroke {
        centre: ChartPoint::a(edge - DVec3::X * 3.5),
        radius_m: 1.9,
        amount: 30.0,
        part: antipode_terrain::Part::Whole,
        kind: None,
        shape: antipode_terrain::Shape::Ball,
        power: None,
    };
    assert!(!stroke.remeshed(&*game.space).contains(&coarse));
    let before = Arc::clone(&game.chunks[&coarse].mesh);
    game.streamer.edit(stroke);
    let mut updates = Vec::new();
    while game.streamer.pending() > 0 && updates.is_empty() {
        // What one poll brings is shown in one frame.
        updates = game.streamer.poll(std::time::Duration::ZERO);
        std::thread::yield_now();
    }
    let seen = game.apply(updates);
    assert_eq!(seen.batches.len(), 1);
    assert!(seen.loaded.contains(&coarse), "all in one frame");
    assert!(
        !seen.batches[0].contains(&coarse),
        "its ground is as it was"
    );
    game.wait(Until::Idle);
    let after = Arc::clone(&game.chunks[&coarse].mesh);
    assert!(after.level == before.level && after.positions() == before.positions());
    assert!(after != before, "its normals at the face are others");
    let mut other = Game::flat(1);
    other.streamer.edit(stroke);
    other.wait(Until::Edits);
    other.look(at, 8);
    other.wait(Until::Idle);
    assert!(other.chunks[&coarse].mesh == after);
}

#[test]
fn edited_land_becomes_as_fine_as_what_may_be_lost_of_it() {
    let mut game = Game::flat(1);
    let at = game.ground(16.0, 16.0);
    game.look(at, 8);
    game.wait(Until::Idle);
    // A pixel is let pass, and up to 60 m two metres take more.
    let away = game.ground(16.0 + 60.0, 16.0);
    let under = ChunkCoord::containing(ChartPoint::a(away));
    assert_ne!(game.chunks[&under].mesh.level, Level::FULL);
    game.streamer.edit(stroke(away, 20.0));
    game.wait(Until::Idle);
    assert_eq!(game.chunks[&under].mesh.level, Level::FULL);
}

#[test]
fn the_whole_of_a_large_sphere_is_there_at_levels_that_suit_it() {
    let mut game = Game::of(Geometry::Spherical, 96.0, 2);
    game.look(DVec3::new(0.0, 30.0, 0.0), 1);
    game.wait(Until::Idle);
    let rim_m = game.space.domain(ChartId::FIRST).radius_m().unwrap();
    assert!(game.levels().len() >= 2);
    let rings = [0.0, 0.5, 0.95].map(|share| share * rim_m);
    for ring in rings {
        let under = ChunkCoord::containing(ChartPoint::a(game.ground(ring, 0.0)));
        assert!(
            game.streamer.is_resident(under) && game.chunks.contains_key(&under),
            "{ring}"
        );
    }
}
