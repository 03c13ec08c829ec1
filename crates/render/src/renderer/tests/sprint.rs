//! Pictures of a sprint, frame by frame as the window draws them while refinements come late, against the same moments
//! drawn exactly.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]

use std::time::Duration;

use antipode_frame::Quality;
use antipode_geometry::Geometry;
use antipode_scene::{Actions, Scene, WorldSetup};
use antipode_testing::pictures::{MOST_OFF, apart, striped_land};
use image::RgbaImage;
use wgpu::TextureFormat;

use super::super::*;
use crate::offscreen::Offscreen;
use crate::shaders::TERRAIN;
use crate::shadow::ShadowQuality;

const SIZE: (u32, u32) = (1280, 720);
const LIMIT: Duration = Duration::from_mins(5);
/// Steps of the world in a frame of the window at five frames a second: the most that one takes.
const STEPS_A_FRAME: usize = 6;
const FRAMES: usize = 20;
/// Frames of the run before those that are looked at: with the others farther than what the land is refined for to begin
/// with is of use.
const RUN_UP: usize = 6;
/// Land may lie so far from where it truly is, pixels.
const NEAR_PX: usize = 2;

/// A renderer with its picture.
struct Easel {
    gpu: Gpu,
    renderer: Renderer,
    offscreen: Offscreen,
}

impl Easel {
    fn new() -> Option<Self> {
        let gpu = Gpu::for_test()?;
        let options = Options {
            samples: 1,
            scale: 1.0,
            output_format: TextureFormat::Rgba8Unorm,
            shadows: ShadowQuality::Off,
            preset: Preset::Software,
        };
        let mut renderer = Renderer::with_shaders(&gpu, options, striped()).unwrap();
        renderer.resize(SIZE.0, SIZE.1);
        let offscreen = Offscreen::new(&gpu, SIZE.0, SIZE.1, options.output_format);
        Some(Self {
            gpu,
            renderer,
            offscreen,
        })
    }

    fn draw(&mut self, frame: &Frame) -> RgbaImage {
        let mut encoder = self.gpu.encoder();
        let target = self.offscreen.view();
        self.renderer.draw(frame, &mut encoder, target);
        self.gpu.queue.submit([encoder.finish()]);
        assert_eq!(self.renderer.fault(), None);
        self.offscreen.read(&self.gpu).unwrap()
    }

    fn draw_exactly(&mut self, frame: &mut Frame) -> RgbaImage {
        let quality = std::mem::replace(&mut frame.view.quality, Quality::Exact);
        self.renderer.complete_next();
        let picture = self.draw(frame);
        frame.view.quality = quality;
        picture
    }
}

fn striped() -> Shaders {
    let text = striped_land(TERRAIN.own);
    Shaders::with(TERRAIN.name, Box::leak(text.into_boxed_str()))
}

/// The player who begins the world that the fault was found in.
fn player() -> Scene {
    let setup = WorldSetup {
        name: String::new(),
        seed: 4,
        geometry: Geometry::Hyperbolic,
        radius_m: antipode_geometry::DEFAULT_HYPERBOLIC_RADIUS_M,
        generator: antipode_scene::Generator::OneBiome,
        mode: antipode_scene::Mode::default(),
        view_distance: 4,
    };
    let mut scene = Scene::open(setup, None).unwrap();
    scene.set_quality(Quality::Balanced);
    scene.begin_with_a_view();
    assert!(scene.set_curvature(20.0));
    scene.set_picture_height_px(SIZE.1);
    assert!(scene.wait_for_step(LIMIT) && scene.settle(LIMIT));
    scene
}

fn steps(scene: &mut Scene, actions: &Actions, count: usize) {
    for _ in 0..count {
        scene.step(actions);
        assert!(scene.wait_for_step(LIMIT));
    }
}

fn frame(scene: &mut Scene) -> Frame {
    let fov_y_rad = scene.viewing().fov_y_rad;
    let aspect = f64::from(SIZE.0) / f64::from(SIZE.1);
    scene.frame(fov_y_rad, aspect, 1)
}

#[test]
fn a_sprint_at_five_frames_a_second_is_drawn_as_it_truly_is_while_the_thread_brings_nothing() {
    let (Some(mut window), Some(mut exact)) = (Easel::new(), Easel::new()) else {
        return;
    };
    let mut scene = player();
    let mut first = frame(&mut scene);
    window.renderer.complete_next();
    window.draw(&first);
    exact.draw_exactly(&mut first);
    window.renderer.chunks.refinements.hold(true);
    let runs = Actions {
        forward: 1.0,
        sprint: true,
        ..Actions::default()
    };
    let looks_down = Actions {
        look_pitch: -0.3,
        ..runs
    };
    steps(&mut scene, &looks_down, 1);
    let mut truth = RgbaImage::new(SIZE.0, SIZE.1);
    for number in 1..=RUN_UP + FRAMES {
        steps(&mut scene, &runs, STEPS_A_FRAME);
        let mut frame = frame(&mut scene);
        let seen = window.draw(&frame);
        if number > RUN_UP {
            truth = exact.draw_exactly(&mut frame);
            let off = apart(&seen, &truth, NEAR_PX);
            assert!(off <= MOST_OFF, "frame {number}: {off} pixels");
        }
    }
    let lower = |x: u32, y: u32| *truth.get_pixel(x, (y + 3).min(SIZE.1 - 1));
    let off = apart(&RgbaImage::from_fn(SIZE.0, SIZE.1, lower), &truth, NEAR_PX);
    assert!(off > 100 * MOST_OFF, "three pixels go unnoticed: {off}");
}
