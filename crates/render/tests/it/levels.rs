//! Levels of detail: blends, seams, and what a frame has room for.

use std::sync::Arc;

use crate::common::{Studio, difference, frame, land, plates, space, standing};
use antipode_frame::{ChunkChange, Frame, Quality};
use antipode_geometry::{ChartId, ChartPoint, ChunkCoord, Geometry};
use antipode_terrain::{ChunkMesh, Level};
use glam::{DVec3, IVec3, Vec3};
use image::RgbaImage;

const SIZE: (u32, u32) = (240, 180);
const ASPECT: f64 = 4.0 / 3.0;
const HOME: ChunkCoord = ChunkCoord {
    chart: ChartId::FIRST,
    index: IVec3::ZERO,
};

/// A wall across the view at `x` metres, in a mesh of a level.
fn wall(x: f32, level: Level) -> ChunkMesh {
    let at = |y: f32, z: f32| Vec3::new(x, y, z);
    let mesh = plates(&[[at(2.0, 2.0), at(2.0, 30.0), at(30.0, 30.0), at(30.0, 2.0)]]);
    ChunkMesh {
        level,
        ..Arc::unwrap_or_clone(mesh)
    }
}

fn put(coord: ChunkCoord, mesh: ChunkMesh) -> ChunkChange {
    ChunkChange::Put(coord, Arc::new(mesh))
}

/// An eye before the wall, and nothing else yet.
fn before_the_wall(geometry: Geometry) -> Frame {
    let space = space(geometry);
    let mut frame = frame(&space, ChartPoint::a(DVec3::new(4.0, 14.0, 15.0)), ASPECT);
    frame.content_mut().time_s = 1.0;
    frame
}

/// The same but for rounding.
fn near(a: image::Rgba<u8>, b: image::Rgba<u8>) -> bool {
    a.0.iter().zip(&b.0).all(|(a, b)| a.abs_diff(*b) <= 1)
}

fn differing(a: &RgbaImage, b: &RgbaImage) -> usize {
    a.pixels().zip(b.pixels()).filter(|(p, q)| p != q).count()
}

#[test]
fn in_a_blend_each_pixel_shows_one_of_the_two_levels_and_in_the_end_the_new_one() {
    for geometry in [Geometry::Euclidean, Geometry::Hyperbolic] {
        let Some(mut studio) = Studio::new(SIZE) else {
            return;
        };
        let mut frame = before_the_wall(geometry);
        frame.change_land([put(HOME, wall(18.0, Level::ALL[1]))]);
        let coarse = studio.picture(&frame);
        frame.change_land([put(HOME, wall(17.5, Level::FULL))]);
        frame.content_mut().time_s = 1.02;
        let (_, begun) = studio.draw_in_motion(&frame);
        assert_eq!(begun.plan.chunks_blending, 1, "{geometry}");
        frame.content_mut().time_s = 1.02 + 0.125;
        let (half, _) = studio.draw_in_motion(&frame);
        frame.content_mut().time_s = 1.4;
        let (fine, done) = studio.draw_in_motion(&frame);
        assert_eq!(done.plan.chunks_blending, 0, "{geometry}");
        let (mut old, mut new) = (0, 0);
        for ((a, b), shown) in coarse.pixels().zip(fine.pixels()).zip(half.pixels()) {
            assert!(
                near(*shown, *a) || near(*shown, *b),
                "{geometry}: {a:?} {b:?} {shown:?}"
            );
            old += usize::from(near(*shown, *a) && !near(*shown, *b));
            new += usize::from(near(*shown, *b) && !near(*shown, *a));
        }
        let share = new as f64 / (old + new) as f64;
        assert!(
            old + new > 8000 && (share - 0.5).abs() < 0.02,
            "{geometry} {share}"
        );
        assert_eq!(studio.picture(&frame), fine, "{geometry}");
    }
}

#[test]
fn edits_single_pictures_and_scenes_that_stand_still_show_no_blend() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let mut frame = before_the_wall(Geometry::Euclidean);
    frame.change_land([put(HOME, wall(18.0, Level::FULL))]);
    studio.picture(&frame);
    // The same level: an edit.
    frame.content_mut().time_s = 1.1;
    frame.change_land([put(HOME, wall(17.0, Level::FULL))]);
    let (edited, stats) = studio.draw_in_motion(&frame);
    assert_eq!(stats.plan.chunks_blending, 0);
    assert_eq!(studio.picture(&frame), edited);
    // Another level, in a single picture.
    frame.content_mut().time_s = 1.2;
    frame.change_land([put(HOME, wall(18.0, Level::ALL[1]))]);
    let (single, stats) = studio.draw(&frame);
    assert_eq!(stats.plan.chunks_blending, 0);
    // And back, in a scene that then stands still.
    frame.content_mut().time_s = 1.3;
    frame.change_land([put(HOME, wall(17.0, Level::FULL))]);
    let (_, stats) = studio.draw_in_motion(&frame);
    assert_eq!(stats.plan.chunks_blending, 1);
    let mut last = studio.draw_in_motion(&frame);
    for _ in 0..16 {
        last = studio.draw_in_motion(&frame);
    }
    assert_eq!(last.1.plan.chunks_blending, 0);
    assert_eq!(last.0, edited);
    assert!(differing(&single, &edited) > 1000);
}

/// A mesh of a level with a seam in its +x face, a square that stands alone.
fn seamed() -> ChunkMesh {
    let square = |x: f32, z: f32| {
        let at = |y: f32, dz: f32| Vec3::new(x, y, z + dz);
        [at(4.0, 0.0), at(4.0, 8.0), at(12.0, 8.0), at(12.0, 0.0)]
    };
    let both = plates(&[square(20.0, 4.0), square(32.0, 20.0)]);
    let half = both.indices.len() as u32 / 2;
    ChunkMesh {
        level: Level::ALL[1],
        seams: [0..0, half..2 * half, 0..0, 0..0, 0..0, 0..0],
        ..Arc::unwrap_or_clone(both)
    }
}

#[test]
fn a_seam_is_drawn_beside_a_finer_neighbour_only() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let beside = ChunkCoord {
        index: IVec3::X,
        ..HOME
    };
    let mut frame = before_the_wall(Geometry::Euclidean);
    let mut drawn = |neighbour: Option<Level>| {
        frame.content_mut().loaded_world += 1;
        // A small thing that is drawn in each case.
        let small = neighbour.map(|level| put(beside, wall(31.0, level)));
        frame.content_mut().land =
            Arc::new([put(HOME, seamed())].into_iter().chain(small).collect());
        studio.draw(&frame).1.triangles
    };
    let alone = drawn(None);
    let wall = wall(31.0, Level::FULL).indices.len() / 3;
    let seam = seamed().seams[1].len() / 3;
    assert_eq!(drawn(Some(Level::ALL[1])), alone + wall);
    assert_eq!(drawn(Some(Level::ALL[2])), alone + wall);
    assert_eq!(drawn(Some(Level::FULL)), alone + wall + seam);
}

#[test]
fn a_frame_sends_a_budget_of_new_land_but_every_edit_and_a_single_picture_everything() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let space = space(Geometry::Euclidean);
    let stand = standing(&space, ChartId::FIRST, 5.0, 3.0);
    let mut frame = frame(&space, stand, ASPECT);
    let made = land(&space, stand, 4);
    let meshes = made.meshes().filter(|(_, mesh)| !mesh.is_empty());
    let put =
        |(coord, mesh): (ChunkCoord, &Arc<ChunkMesh>)| ChunkChange::Put(coord, Arc::clone(mesh));
    let all: Vec<_> = meshes.map(put).collect();
    frame.change_land(all.clone());
    let whole = studio.picture(&frame);
    let shown = |stats: antipode_render::DrawStats| stats.plan.chunks_by_level[0] + stats.culled;
    assert_eq!(shown(studio.draw(&frame).1), all.len());

    frame.content_mut().loaded_world += 1;
    let (_, first) = studio.draw_in_motion(&frame);
    assert!(shown(first) > 5 && shown(first) < all.len(), "{first:?}");
    // What comes with an edit comes at once: here, every chunk once more.
    frame.change_land(all.clone());
    assert_eq!(shown(studio.draw_in_motion(&frame).1), all.len());

    frame.content_mut().loaded_world += 1;
    let mut last = studio.draw_in_motion(&frame);
    for _ in 0..60 {
        last = studio.draw_in_motion(&frame);
    }
    assert_eq!(shown(last.1), all.len());
    assert_eq!(difference(&last.0, &whole).0, 0);
}

#[test]
fn one_call_draws_many_chunks_and_where_it_cannot_one_call_draws_one() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    for geometry in crate::common::GEOMETRIES {
        let space = space(geometry);
        let stand = standing(&space, ChartId::FIRST, 5.0, 3.0);
        let mut frame = frame(&space, stand, ASPECT);
        frame.content_mut().loaded_world = 10 + geometry as u64;
        frame.content_mut().land = land(&space, stand, 3);
        // Where nothing is hidden there is much to draw.
        frame.view.quality = Quality::Exact;
        let (together, stats) = studio.draw(&frame);
        studio.renderer().draw_singly();
        let (singly, single) = studio.draw(&frame);
        assert_eq!(difference(&together, &singly).0, 0, "{geometry}");
        assert_eq!(single.triangles, stats.triangles);
        let chunks: usize = stats.plan.chunks_by_level.iter().sum();
        assert!(single.draws >= chunks, "{geometry}: {single:?}");
        if stats.draws < single.draws {
            // A call draws what lies in one chart.
            let charts = space.all_charts().map_or(1, <[_]>::len);
            let first = stats.draws + 1 - charts;
            assert!(2 * first < chunks, "{geometry}: {stats:?}");
        }
        let Some(fresh) = Studio::new(SIZE) else {
            return;
        };
        studio = fresh;
    }
}

/// A floor of a chunk, 2 m above its lowest.
fn floor() -> ChunkMesh {
    let at = |x: f32, z: f32| Vec3::new(x, 2.0, z);
    Arc::unwrap_or_clone(plates(&[[
        at(0.0, 0.0),
        at(0.0, 32.0),
        at(32.0, 32.0),
        at(32.0, 0.0),
    ]]))
}

#[test]
fn no_crack_opens_between_two_chunks_while_one_walks() {
    for geometry in [Geometry::Hyperbolic, Geometry::Spherical] {
        let Some(mut studio) = Studio::new(SIZE) else {
            return;
        };
        let space = space(geometry);
        let beside = ChunkCoord {
            index: IVec3::NEG_Z,
            ..HOME
        };
        let mut frame = frame(&space, ChartPoint::default(), ASPECT);
        frame.change_land([put(HOME, floor()), put(beside, floor())]);
        frame.view.eye.pitch = -0.6;
        for step in 0..40u32 {
            let way_m = 0.45 * f64::from(step);
            frame.view.eye.point = ChartPoint::a(DVec3::new(3.0 + way_m, 3.7, 0.4 * way_m.sin()));
            if step == 0 {
                studio.draw(&frame);
                continue;
            }
            let (picture, stats) = studio.draw_in_motion(&frame);
            assert!(
                stats.plan.chunks_refined > 0,
                "{geometry}: nothing is refined"
            );
            let (width, height) = SIZE;
            for (x, y) in (height / 2..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
                let [r, g, ..] = picture.get_pixel(x, y).0;
                assert!(r > g, "{geometry}, step {step}: a hole at {x}, {y}");
            }
        }
    }
}
