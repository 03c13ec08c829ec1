//! The planner: what it leaves out is not seen, what it changes is under its tolerance.

use std::sync::Arc;

use crate::common::{Studio, frame, land, standing};
use antipode_frame::{Clip, Figure, Frame, ModelId, Posture, Quality};
use antipode_geometry::{ChartId, Eye, Geometry, HyperbolicMap, Strategy, picture};
use antipode_render::{DrawStats, tolerance_px};
use image::RgbaImage;

const SIZE: (u32, u32) = (480, 270);

/// A space and the dial it is looked at with.
fn views() -> Vec<(&'static str, Arc<dyn Strategy>, f64)> {
    let raised = || picture(Geometry::Hyperbolic, 20.0, HyperbolicMap::Raised, false);
    let horizon = || picture(Geometry::Hyperbolic, 20.0, HyperbolicMap::Horizon, false);
    let bent = || picture(Geometry::Euclidean, 20.0, HyperbolicMap::Raised, true);
    let flat = picture(Geometry::Euclidean, 20.0, HyperbolicMap::Raised, false);
    let sphere = picture(Geometry::Spherical, 32.0, HyperbolicMap::Raised, false);
    vec![
        ("flat", flat, 0.0),
        ("raised 0.5", raised(), 0.5),
        ("raised 10", raised(), 10.0),
        ("raised 20", raised(), 20.0),
        ("horizon 2", horizon(), 2.0),
        ("horizon 20", horizon(), 20.0),
        ("bent 0.01", bent(), 0.01),
        ("bent -3", bent(), -3.0),
        ("sphere", sphere, 0.0),
    ]
}

/// Shares of pixels that differ by more than 8 of 255, and of those more than a pixel from any edge.
fn differing(exact: &RgbaImage, other: &RgbaImage) -> (f64, f64) {
    let far =
        |a: &image::Rgba<u8>, b: &image::Rgba<u8>| (0..3).any(|i| a.0[i].abs_diff(b.0[i]) > 8);
    let (width, height) = exact.dimensions();
    let around = |x: u32, y: u32| {
        let nine = (-1..=1).flat_map(|i: i32| (-1..=1).map(move |j: i32| (i, j)));
        nine.filter_map(move |(i, j)| Some((x.checked_add_signed(i)?, y.checked_add_signed(j)?)))
            .filter(move |(i, j)| *i < width && *j < height)
    };
    let (mut off, mut astray) = (0, 0);
    for (x, y, pixel) in exact.enumerate_pixels() {
        if !far(pixel, other.get_pixel(x, y)) {
            continue;
        }
        off += 1;
        let is_edge = |(x, y): (u32, u32)| {
            let here = exact.get_pixel(x, y);
            around(x, y).any(|(i, j)| far(here, exact.get_pixel(i, j)))
        };
        astray += u32::from(!around(x, y).any(is_edge));
    }
    let all = f64::from(width * height);
    (f64::from(off) / all, f64::from(astray) / all)
}

fn poses(frame: &Frame) -> Vec<Eye> {
    [(0.3, -0.05), (1.9, -0.3), (-2.2, -0.7), (3.9, 0.2)]
        .map(|(yaw, pitch)| Eye {
            yaw,
            pitch,
            ..frame.view.eye
        })
        .to_vec()
}

#[test]
fn what_the_planner_leaves_out_is_not_missed() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    for (name, space, dial) in views() {
        for (x, z) in [(4.0, 4.0), (-30.0, 21.0)] {
            let stand = standing(&space, ChartId::FIRST, x, z);
            let mut frame = frame(&space, stand, 16.0 / 9.0);
            frame.view.eye.dial = dial;
            frame.view.fog_distance_m = (space.sight_limit_m(&frame.view.eye) as f32).min(150.0);
            frame.content_mut().land = land(&space, stand, 5);
            for eye in poses(&frame) {
                frame.view.eye = eye;
                let mut draw = |quality: Quality| -> (RgbaImage, DrawStats) {
                    frame.view.quality = quality;
                    studio.draw(&frame)
                };
                let (exact, all) = draw(Quality::Exact);
                let (balanced, chosen) = draw(Quality::Balanced);
                let (off, astray) = differing(&exact, &balanced);
                let p = chosen.plan;
                let at = format!("{name}, {x}, {:.1}: {off} {astray} {p:?}", eye.yaw);
                assert!(off <= 1e-3 && astray <= 1e-4, "{at}");
                let bar = tolerance_px(Quality::Balanced).unwrap();
                assert!(p.error_px <= bar, "{at}");
                assert!(chosen.triangles <= all.triangles, "{at}");
                if name == "flat" || name == "bent 0.01" {
                    assert_eq!(p.chunks_by_vertex, 0, "{at}");
                }
            }
        }
    }
}

#[test]
fn the_highest_curvature_draws_less_than_half_of_the_flat_view() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let mut drawn = |name: &str| {
        let (_, space, dial) = views().into_iter().find(|(n, ..)| *n == name).unwrap();
        let stand = standing(&space, ChartId::FIRST, 4.0, 4.0);
        let mut frame = frame(&space, stand, 16.0 / 9.0);
        frame.view.eye = Eye {
            dial,
            pitch: -0.05,
            ..frame.view.eye
        };
        frame.content_mut().land = land(&space, stand, 5);
        studio.draw(&frame).1
    };
    let (flat, bent) = (drawn("flat"), drawn("raised 20"));
    assert!(2 * bent.triangles <= flat.triangles, "{bent:?} {flat:?}");
    assert!(bent.plan.triangles_hidden > flat.plan.triangles_hidden);
}

#[test]
fn what_a_figure_gains_by_distance_is_one_matrix() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    for (name, space, dial) in views() {
        let stand = standing(&space, ChartId::FIRST, 4.0, 4.0);
        let mut frame = frame(&space, stand, 16.0 / 9.0);
        frame.view.eye = Eye {
            dial,
            pitch: -0.2,
            ..frame.view.eye
        };
        frame.view.fog_distance_m = 1e4;
        let far_m = (space.sight_limit_m(&frame.view.eye) * 0.6).min(30.0);
        let mut chosen = |away_m: f64, quality| {
            let point = stand.moved(glam::DVec3::new(away_m, -1.7, 0.0));
            frame.content_mut().figures = vec![Figure {
                posture: Posture::of(Clip::Walk, 0.2),
                ..Figure::standing(ModelId::Astronaut, point, 2.0)
            }];
            frame.view.quality = quality;
            let (picture, stats) = studio.draw(&frame);
            (picture, stats.plan.figures_by_frame)
        };
        // Close by, a curved space needs every vertex; far away, one matrix shows the same figure.
        let (_, near) = chosen(1.5, Quality::Balanced);
        if ["raised 10", "raised 20", "horizon 20", "sphere"].contains(&name) {
            assert_eq!(near, 0, "{name}");
        }
        let (framed, far) = chosen(far_m, Quality::Balanced);
        let (exact, _) = chosen(far_m, Quality::Exact);
        // At the strongest bend thirty metres are seven radii, and a figure is half a radius wide.
        assert_eq!(far, usize::from(name != "horizon 20"), "{name}");
        let (off, _) = differing(&exact, &framed);
        assert!(off < 2e-4, "{name}: {off}");
    }
}
