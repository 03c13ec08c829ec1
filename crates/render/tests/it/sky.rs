//! What is seen in the sky: clouds, the band of stars, and the sun and the moon of a closed world.

use crate::common::{Studio, difference, frame, plates, seen_at, space};
use antipode_geometry::{ChartId, ChartPoint, Geometry};
use antipode_scene::day::sky;
use glam::{DVec3, Vec3};
use image::RgbaImage;

use antipode_frame::ChunkChange;
use antipode_geometry::ChunkCoord;

const SIZE: (u32, u32) = (160, 90);
const ASPECT: f64 = 16.0 / 9.0;

/// The mean difference of two pictures over some rows.
fn differing(a: &RgbaImage, b: &RgbaImage, rows: std::ops::Range<u32>) -> f64 {
    let part = |picture: &RgbaImage| {
        image::imageops::crop_imm(picture, 0, rows.start, SIZE.0, rows.end - rows.start).to_image()
    };
    difference(&part(a), &part(b)).1
}

#[test]
fn clouds_drift_over_the_horizon_and_nothing_of_them_is_under_it() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let space = space(Geometry::Euclidean);
    let mut frame = frame(&space, ChartPoint::a(DVec3::ZERO), ASPECT);
    let clear = studio.picture(&frame);
    frame.content_mut().sky.clouds = 0.8;
    let cloudy = studio.picture(&frame);
    frame.content_mut().sky.drift = 0.1;
    let later = studio.picture(&frame);
    assert!(differing(&clear, &cloudy, 0..35) > 8.0);
    assert!(differing(&cloudy, &later, 0..35) > 2.0);
    assert_eq!(differing(&clear, &cloudy, 47..90), 0.0);
}

#[test]
fn the_band_of_stars_turns_with_the_sun() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let space = space(Geometry::Hyperbolic);
    let mut frame = frame(&space, ChartPoint::a(DVec3::ZERO), ASPECT);
    frame.view.eye.pitch = 0.9;
    let mut at = |time_s: f64| {
        frame.content_mut().sky = sky(time_s, &*space, &frame.view.eye);
        frame.content_mut().sky.clouds = 0.0;
        studio.picture(&frame)
    };
    let (early, late) = (at(420.0), at(480.0));
    let light = |picture: &RgbaImage| {
        picture.pixels().map(|p| u64::from(p.0[1])).sum::<u64>() as f64 / f64::from(SIZE.0 * SIZE.1)
    };
    assert!(light(&early) > 4.0, "{}", light(&early));
    assert!(difference(&early, &late).1 > 3.0);
}

#[test]
fn stars_do_not_shine_through_clouds() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let space = space(Geometry::Hyperbolic);
    let mut frame = frame(&space, ChartPoint::a(DVec3::ZERO), ASPECT);
    frame.view.eye.pitch = 0.9;
    let mut at = |clouds: f32| {
        frame.content_mut().sky = sky(450.0, &*space, &frame.view.eye);
        frame.content_mut().sky.clouds = clouds;
        studio.picture(&frame)
    };
    let (clear, cloudy) = (at(0.0), at(1.0));
    let light = |picture: &RgbaImage, x, y| i32::from(picture.get_pixel(x, y).0[1]);
    // A star is much lighter than what is beside it, and a cloud is not.
    let stars = |picture: &RgbaImage| {
        let places = (1..SIZE.0 - 1).flat_map(|x| (0..SIZE.1).map(move |y| (x, y)));
        let stands_out = |&(x, y): &(u32, u32)| {
            let beside = light(picture, x - 1, y).max(light(picture, x + 1, y));
            light(picture, x, y) > beside + 12
        };
        places.filter(stands_out).count()
    };
    let (clear, cloudy) = (stars(&clear), stars(&cloudy));
    assert!(clear > 20 && cloudy * 5 < clear, "{clear} and {cloudy}");
}

/// A closed world whose ground is one red square below the eye.
#[test]
fn the_sun_of_a_closed_world_stands_in_it_and_lights_what_is_near_it() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let space = space(Geometry::Spherical);
    let radius_m = space.radius_m();
    let ground = 0.25 * radius_m as f32;
    let square =
        [[2.0, -4.0], [2.0, 4.0], [9.0, 4.0], [9.0, -4.0]].map(|[x, z]| Vec3::new(x, ground, z));
    let chunk = ChunkCoord {
        chart: ChartId::FIRST,
        index: glam::IVec3::ZERO,
    };
    let eye = ChartPoint::a(DVec3::new(0.0, f64::from(ground) + 1.6, 0.0));
    let mut frame = frame(&space, eye, ASPECT);
    let mut seen = |time_s: f64, pitch: f64, mesh: bool| {
        frame.view.eye.pitch = pitch;
        frame.content_mut().sky = sky(time_s, &*space, &frame.view.eye);
        if mesh {
            frame.change_land([ChunkChange::Put(chunk, plates(&[square]))]);
        }
        (studio.picture(&frame), frame.clone())
    };
    let middle = |picture: &RgbaImage| u32::from(picture.get_pixel(80, 45).0[0]);
    let (noon, _) = seen(150.0, -0.28, true);
    let (night, _) = seen(450.0, -0.28, false);
    assert!(
        middle(&noon) > middle(&night) + 80 && middle(&night) > 40,
        "{} {}",
        middle(&noon),
        middle(&night)
    );
    // In the afternoon the sun is off the zenith, where the space has it.
    let (sky, at) = seen(200.0, 1.2, false);
    let sun = at.content.sky.orbs.unwrap().sun;
    let (x, y) = seen_at(&at, sun, SIZE);
    assert!(
        (0.0..160.0).contains(&x) && (0.0..90.0).contains(&y),
        "{x} {y}"
    );
    let [r, g, b, _] = sky.get_pixel(x as u32, y as u32).0;
    assert!(r > 240 && g > 225 && b > 180, "{r} {g} {b} at {x} {y}");
}
