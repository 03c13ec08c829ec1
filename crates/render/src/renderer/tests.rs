//! What is shown while pipelines are being made.
#![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

use std::sync::mpsc::{Sender, channel};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use antipode_frame::Opening;
use antipode_geometry::{Doorway, Geometry, HyperbolicMap, Leaf, LevelMap, Strategy, picture};
use glam::DVec3;
use image::RgbaImage;

use wgpu::TextureFormat;

use super::*;
use crate::offscreen::Offscreen;
use crate::plan::testing;
use crate::shadow::ShadowQuality;

mod sprint;

const SIZE: (u32, u32) = (64, 36);
const OPTIONS: Options = Options {
    samples: 1,
    scale: 1.0,
    output_format: TextureFormat::Rgba8Unorm,
    shadows: ShadowQuality::Off,
    preset: Preset::Software,
};
/// Longest wait for a thread; a deadline for a hung one, not a measure of speed.
const PATIENCE: Duration = Duration::from_mins(1);
/// So long a map is held that nobody lets go.
const HELD: Duration = Duration::from_secs(20);

/// A renderer that makes all maps, but what this one is drawn with only when it is told to.
fn holding(gpu: &Gpu, held: Option<Key>) -> (Renderer, Sender<()>) {
    let mut renderer = Renderer::new(gpu, OPTIONS).unwrap();
    renderer.resize(SIZE.0, SIZE.1);
    let (go, wait) = channel::<()>();
    let wait = Mutex::new(wait);
    let (device, layout) = (gpu.device.clone(), scene_layout(&gpu.device));
    renderer.pipelines = PipelineCache::new(Box::new(move |map| {
        if Some(map) == held {
            let _ = wait.lock().unwrap().recv_timeout(HELD);
        }
        let quality = OPTIONS.pipeline_quality();
        Pipelines::new(&device, Shaders::default(), &layout, map, quality)
    }));
    (renderer, go)
}

fn space(geometry: Geometry) -> Arc<dyn Strategy> {
    picture(geometry, 20.0, HyperbolicMap::Raised, false)
}

/// Nothing but a horizon of that colour.
fn view(space: &Arc<dyn Strategy>, horizon: [f32; 3]) -> Frame {
    let mut frame = testing::frame(space);
    frame.content_mut().sky.horizon = horizon;
    frame
}

fn draw(gpu: &Gpu, renderer: &mut Renderer, frame: &Frame) -> (Picture, RgbaImage) {
    let target = Offscreen::new(gpu, SIZE.0, SIZE.1, OPTIONS.output_format);
    let mut encoder = gpu.encoder();
    let stats = renderer.draw(frame, &mut encoder, target.view());
    gpu.queue.submit([encoder.finish()]);
    let picture = target.read(gpu).unwrap();
    assert_eq!(gpu.take_error(), None);
    (stats.picture, picture)
}

/// The first picture of the frame itself.
fn drawn_new(gpu: &Gpu, renderer: &mut Renderer, frame: &Frame) -> RgbaImage {
    let began = Instant::now();
    loop {
        let (kind, picture) = draw(gpu, renderer, frame);
        if kind == Picture::New {
            return picture;
        }
        assert!(began.elapsed() < PATIENCE, "its map is never made");
    }
}

#[test]
fn a_frame_whose_map_is_not_made_shows_the_last_picture_of_its_world_and_waits_for_nothing() {
    let Some(gpu) = Gpu::for_test() else { return };
    let (flat, sphere) = (space(Geometry::Euclidean), space(Geometry::Spherical));
    let red = view(&flat, [0.8, 0.1, 0.1]);
    let mut blue = view(&sphere, [0.1, 0.1, 0.8]);
    let held = Key::whole(blue.view.strategy.shader());
    let (mut renderer, go) = holding(&gpu, Some(held));
    let (kind, before) = draw(&gpu, &mut renderer, &red);
    assert_eq!(kind, Picture::New);
    renderer.prepare_maps();
    let (kind, still) = draw(&gpu, &mut renderer, &blue);
    assert_eq!(kind, Picture::Last);
    assert!(still == before);
    assert!(renderer.is_land_coming(), "a veil stays down for it");
    assert_eq!(draw(&gpu, &mut renderer, &red).0, Picture::New);
    assert!(!renderer.is_land_coming());

    blue.content_mut().loaded_world += 1;
    assert_eq!(draw(&gpu, &mut renderer, &blue).0, Picture::None);
    drop(go);
    let after = drawn_new(&gpu, &mut renderer, &blue);
    assert!(after != before);
    assert!(!renderer.is_land_coming());
}

#[test]
fn other_options_are_taken_when_their_pipelines_are_made_and_no_frame_is_left_out() {
    let Some(gpu) = Gpu::for_test() else { return };
    let (mut renderer, _go) = holding(&gpu, None);
    let red = view(&space(Geometry::Euclidean), [0.8, 0.1, 0.1]);
    let (_, before) = draw(&gpu, &mut renderer, &red);
    renderer.prepare_maps();
    let finer = Options {
        samples: 4,
        scale: 0.5,
        ..OPTIONS
    };
    renderer.set_options(finer).unwrap();
    assert_eq!(renderer.options, OPTIONS);
    let began = Instant::now();
    while renderer.options != finer {
        assert!(renderer.is_busy() && began.elapsed() < PATIENCE);
        let (kind, picture) = draw(&gpu, &mut renderer, &red);
        assert_eq!(kind, Picture::New);
        assert!(picture == before);
    }
    assert!(!renderer.is_busy());
    assert_eq!(renderer.picture.targets.size, (SIZE.0 / 2, SIZE.1 / 2));
}

#[test]
fn the_veil_of_a_world_with_doors_stays_down_until_they_can_be_looked_through_and_no_other_waits() {
    let Some(gpu) = Gpu::for_test() else { return };
    let bare = view(&space(Geometry::Euclidean), [0.8, 0.1, 0.1]);
    let leaf = |ahead_m| Leaf {
        foot: bare.view.eye.point.moved(DVec3::new(ahead_m, -1.0, 0.0)),
        yaw: 0.0,
        level: LevelMap::SAME,
    };
    let doors = Doorway {
        leaves: [leaf(3.0), leaf(60.0)],
    };
    let mut frame = bare.clone();
    frame.openings = Opening::all(&frame.view, &doors).to_vec();
    let cut = Key {
        is_cut: true,
        ..Key::whole(bare.view.strategy.shader())
    };
    let (mut renderer, go) = holding(&gpu, Some(cut));
    assert_eq!(draw(&gpu, &mut renderer, &bare).0, Picture::New);
    renderer.prepare_maps();
    // Doors that are put up in it are seen at once.
    assert_eq!(draw(&gpu, &mut renderer, &frame).0, Picture::New);

    frame.content_mut().loaded_world += 1;
    assert_eq!(draw(&gpu, &mut renderer, &frame).0, Picture::None);
    assert!(renderer.is_land_coming());
    drop(go);
    drawn_new(&gpu, &mut renderer, &frame);
    assert!(!renderer.is_land_coming());
}
