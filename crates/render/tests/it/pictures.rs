//! What a frame looks like: nothing black, the horizon's colour, targets of every kind, stores and stats.

use std::sync::Arc;

use crate::common::{
    GEOMETRIES, PLAIN, Studio, difference, frame, land, plates, seen_at, space, standing,
};
use antipode_frame::{ChunkChange, Figure, Frame, ModelId};
use antipode_geometry::{ChartId, ChartPoint, ChunkCoord, Eye, Geometry};
use antipode_render::{AdapterChoice, Gpu};
use antipode_terrain::ChunkMesh;
use glam::{DVec3, IVec3, Vec3};
use image::RgbaImage;
use wgpu::TextureFormat::{Bgra8Unorm, Bgra8UnormSrgb, Rgba8UnormSrgb};

const SIZE: (u32, u32) = (160, 90);
const ASPECT: f64 = 16.0 / 9.0;

fn view(geometry: Geometry, pitch: f64) -> Frame {
    let space = space(geometry);
    let point = standing(&space, ChartId::FIRST, 5.0, 3.0);
    let empty = frame(&space, point, ASPECT);
    empty
        .with_view(|it| it.eye = Eye { pitch, ..it.eye })
        .with_content(|it| it.land = land(&space, point, 1))
}

fn solid_chunks(frame: &Frame) -> impl Iterator<Item = (ChunkCoord, &Arc<ChunkMesh>)> {
    let meshes = frame.content.land.meshes();
    meshes.filter(|(_, mesh)| !mesh.is_empty())
}

#[test]
fn nothing_is_black_in_any_space_or_direction() {
    for geometry in GEOMETRIES {
        for pitch in [-1.2, -0.1, 1.2] {
            let Some(mut studio) = Studio::new(SIZE) else {
                return;
            };
            let picture = studio.picture(&view(geometry, pitch));
            let darkest = picture
                .pixels()
                .map(|p| p.0[..3].iter().max().copied().unwrap_or(0))
                .min();
            assert!(darkest > Some(40), "{geometry} {pitch}: {darkest:?}");
        }
    }
}

/// What the display shows for linear light: the filmic curve, then the sRGB curve, both in full.
fn shown(light: f64) -> f64 {
    let x = light * 0.86;
    let filmic = x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
    255.0
        * if filmic < 0.003_130_8 {
            12.92 * filmic
        } else {
            1.055 * filmic.powf(1.0 / 2.4) - 0.055
        }
}

#[test]
fn below_the_horizon_the_sky_has_the_horizons_colour() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let space = space(Geometry::Euclidean);
    let mut frame = frame(&space, ChartPoint::a(DVec3::ZERO), ASPECT);
    frame.view.eye.yaw = std::f64::consts::PI;
    frame.content_mut().sky.sun_direction = [1.0, 0.0, 0.0];
    let picture = studio.picture(&frame);
    for (channel, light) in frame.content.sky.horizon.into_iter().enumerate() {
        let found = f64::from(picture.get_pixel(80, 85).0[channel]);
        assert!(
            (found - shown(f64::from(light))).abs() < 2.5,
            "{channel}: {found}"
        );
    }
    let (top, low) = (picture.get_pixel(80, 2).0, picture.get_pixel(80, 60).0);
    assert!(
        top[0] + 40 < low[0],
        "the sky darkens upwards: {top:?} {low:?}"
    );
}

#[test]
fn land_at_the_fogs_distance_has_the_colour_of_the_haze_behind_it() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let mut frame = view(Geometry::Euclidean, -0.1);
    let clear = studio.picture(&frame);
    frame.view.fog_distance_m = 1.5;
    let fogged = studio.picture(&frame);
    frame.content_mut().loaded_world = 0;
    frame.content_mut().land = Arc::default();
    let empty = studio.picture(&frame);
    assert!(difference(&clear, &empty).1 > 10.0, "there is land to hide");
    assert!(
        difference(&fogged, &empty).0 <= 3,
        "{:?}",
        difference(&fogged, &empty)
    );
}

#[test]
fn every_kind_of_target_shows_the_same_picture() {
    let frame = view(Geometry::Hyperbolic, -0.1);
    let Some(mut plain) = Studio::new(SIZE) else {
        return;
    };
    let reference = plain.picture(&frame);
    for format in [Rgba8UnormSrgb, Bgra8Unorm, Bgra8UnormSrgb] {
        let picture = Studio::with(SIZE, format, 1.0, 1).unwrap().picture(&frame);
        assert!(
            difference(&picture, &reference).0 <= 2,
            "{format:?}: {:?}",
            difference(&picture, &reference)
        );
    }
    let half = Studio::with(SIZE, PLAIN, 0.5, 1).unwrap().picture(&frame);
    assert!(
        difference(&half, &reference).1 < 4.0,
        "half size: {:?}",
        difference(&half, &reference)
    );
    let smooth = Studio::with(SIZE, PLAIN, 1.0, 4).unwrap().picture(&frame);
    assert!(
        difference(&smooth, &reference).1 < 3.0,
        "four samples: {:?}",
        difference(&smooth, &reference)
    );
    assert_ne!(smooth, reference, "edges are smoothed");
}

#[test]
fn chunks_come_change_and_go_and_another_world_starts_empty() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let mut frame = view(Geometry::Euclidean, -0.5);
    let full = studio.draw(&frame).1;
    assert!(full.triangles > 2000 && full.draws > 2, "{full:?}");
    let held: Vec<_> = solid_chunks(&frame).map(|(coord, _)| coord).collect();
    frame.change_land([ChunkChange::Remove(held[0])]);
    let fewer = studio.draw(&frame).1;
    assert_eq!(fewer.draws + fewer.culled, full.draws + full.culled - 1);
    frame.change_land([ChunkChange::Put(held[1], Arc::new(ChunkMesh::default()))]);
    let emptied = studio.draw(&frame).1;
    assert_eq!(emptied.draws + emptied.culled, full.draws + full.culled - 2);
    frame.content_mut().loaded_world = 0;
    frame.content_mut().land = Arc::default();
    let empty = studio.draw(&frame).1;
    assert!(empty.triangles < 100 && empty.culled == 0, "{empty:?}");
}

#[test]
fn chunks_beyond_the_fog_or_behind_the_eye_are_left_out_unseen() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let space = space(Geometry::Euclidean);
    let mut frame = view(Geometry::Euclidean, -0.1);
    let far = ChunkCoord {
        chart: ChartId::FIRST,
        index: IVec3::new(30, 0, 0),
    };
    let mesh = solid_chunks(&frame)
        .map(|(_, mesh)| Arc::clone(mesh))
        .next()
        .unwrap();
    let near = studio.draw(&frame).1;
    assert!(near.culled > 0, "something lies behind the eye: {near:?}");
    frame.change_land([ChunkChange::Put(far, mesh)]);
    let with_far = studio.draw(&frame).1;
    assert_eq!(
        (with_far.triangles, with_far.culled),
        (near.triangles, near.culled + 1)
    );
    assert!(
        space.distance_m(
            frame.view.eye.point,
            ChartPoint::a(far.origin()),
            &frame.view.eye
        ) > 150.0
    );
}

fn astronaut(yaw: f64) -> Frame {
    let space = space(Geometry::Euclidean);
    let eye = ChartPoint::a(DVec3::new(0.0, 1.0, 0.0));
    let point = ChartPoint::a(DVec3::new(3.0, 0.0, 0.0));
    frame(&space, eye, ASPECT)
        .with_content(|it| it.figures = vec![Figure::standing(ModelId::Astronaut, point, yaw)])
}

fn count(picture: &RgbaImage, like: impl Fn([u8; 3]) -> bool) -> usize {
    picture
        .pixels()
        .filter(|p| like([p.0[0], p.0[1], p.0[2]]))
        .count()
}

#[test]
fn a_figure_stands_in_a_shade_of_its_own() {
    let Some(mut studio) = Studio::new((320, 180)) else {
        return;
    };
    let mut frame = astronaut(0.0);
    let corners = [[0.0, -8.0], [0.0, 8.0], [16.0, 8.0], [16.0, -8.0]];
    let ground = plates(&[corners.map(|[x, z]| Vec3::new(x, 0.0, z))]);
    let corner = ChunkCoord::containing(frame.view.eye.point);
    frame.change_land([ChunkChange::Put(corner, ground)]);
    frame.view.eye.pitch = -0.3;
    let beside = seen_at(
        &frame,
        ChartPoint::a(DVec3::new(3.0, 0.0, 0.38)),
        (320, 180),
    );
    let green = |picture: &RgbaImage| picture.get_pixel(beside.0 as u32, beside.1 as u32).0[1];
    let shaded = green(&studio.picture(&frame));
    frame.content_mut().figures[0].point.pos.z = 5.0;
    let bare = green(&studio.picture(&frame));
    assert!(
        u32::from(shaded) * 5 < u32::from(bare) * 4,
        "{shaded} {bare}"
    );
}

#[test]
fn the_sun_stands_where_it_is_told_and_stars_show_by_night_only() {
    let Some(mut studio) = Studio::new((320, 180)) else {
        return;
    };
    let space = space(Geometry::Hyperbolic);
    let mut frame = frame(&space, ChartPoint::a(DVec3::ZERO), ASPECT);
    frame.view.eye.pitch = 0.6;
    let bright = |picture: &RgbaImage| count(picture, |[r, g, b]| r > 90 && g > 90 && b > 90);
    frame.content_mut().sky.top = [0.003, 0.005, 0.016];
    frame.content_mut().sky.horizon = [0.012, 0.020, 0.046];
    frame.content_mut().sky.sun_direction = [-1.0, -0.2, 0.0];
    let dark = bright(&studio.picture(&frame));
    frame.content_mut().sky.stars = 1.0;
    let starry = bright(&studio.picture(&frame));
    assert!(dark == 0 && starry > 15, "{dark} {starry}");
    frame.content_mut().sky.stars = 0.0;
    frame.content_mut().sky.sun_direction = Vec3::new(1.0, 0.5, 0.4).normalize().into();
    let (right, above) = (0.4, (0.5 - 0.6f64.tan()) / (1.0 + 0.5 * 0.6f64.tan()));
    let ahead = (1.0 + 0.5 * 0.6f64.tan()) * 0.6f64.cos();
    let x = 160.0 + 160.0 * frame.view.projection.sx * right / ahead;
    let y = 90.0 - 90.0 * frame.view.projection.sy * above;
    let picture = studio.picture(&frame);
    assert!(picture.get_pixel(x as u32, y as u32).0[1] > 240, "{x} {y}");
    assert!(picture.get_pixel(320 - x as u32, y as u32).0[1] < 200);
}

#[test]
fn the_adapter_tells_its_own_time_where_it_can() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let frame = view(Geometry::Euclidean, 0.0);
    let told: Vec<_> = (0..4).map(|_| studio.draw(&frame).1.gpu_ms).collect();
    let can = studio
        .gpu
        .device
        .features()
        .contains(wgpu::Features::TIMESTAMP_QUERY);
    assert_eq!(told[3].is_some(), can, "{told:?}");
    assert!(
        told[3].is_none_or(|ms| ms > 0.0 && ms < 60_000.0),
        "{told:?}"
    );
}

#[test]
fn a_software_adapter_says_so() {
    match Gpu::headless(AdapterChoice::Software) {
        Ok(gpu) => assert!(gpu.is_software() && !gpu.name().is_empty() && gpu.lost().is_none()),
        Err(e) => assert!(e.to_string().contains("software graphics adapter"), "{e}"),
    }
}
