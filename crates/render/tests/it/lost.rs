//! An adapter that is lost, and one that refuses a shader.

use crate::common::{PLAIN, adapter, difference, frame, land, space, standing};
use std::sync::Arc;

use antipode_frame::Frame;
use antipode_geometry::{ChartId, Geometry};
use antipode_render::{Gpu, Offscreen, Options, RenderError, Renderer, Shaders};
use image::RgbaImage;

const SIZE: (u32, u32) = (160, 90);

const OPTIONS: Options = Options {
    samples: 1,
    scale: 1.0,
    output_format: PLAIN,
    shadows: antipode_render::ShadowQuality::Off,
    preset: antipode_render::Preset::Software,
};

fn view() -> Frame {
    let space = space(Geometry::Hyperbolic);
    let point = standing(&space, ChartId::FIRST, 5.0, 3.0);
    let empty = frame(&space, point, 16.0 / 9.0);
    empty.with_content(|it| it.land = land(&space, point, 1))
}

fn drawn(gpu: &Gpu, renderer: &mut Renderer, frame: &Frame) -> Result<RgbaImage, RenderError> {
    renderer.resize(SIZE.0, SIZE.1);
    renderer.complete_next();
    let target = Offscreen::new(gpu, SIZE.0, SIZE.1, OPTIONS.output_format);
    let mut encoder = gpu.encoder();
    renderer.draw(frame, &mut encoder, target.view());
    gpu.queue.submit([encoder.finish()]);
    target.read(gpu)
}

#[test]
fn what_a_lost_adapter_showed_another_one_shows_without_being_given_it_again() {
    let Some(first) = adapter() else { return };
    let mut before = Renderer::new(&first, OPTIONS).unwrap();
    let frame = view();
    let picture = drawn(&first, &mut before, &frame).unwrap();
    assert_eq!(first.lost(), None);
    first.lose();
    assert!(first.lost().is_some());
    let refused = drawn(&first, &mut before, &frame);
    assert!(refused.is_err(), "a lost adapter gives no picture");

    let second = adapter().unwrap();
    let mut after = Renderer::new(&second, OPTIONS).unwrap();
    let again = drawn(&second, &mut after, &frame).unwrap();
    assert_eq!(difference(&again, &picture).0, 0);
    let bare = frame.with_content(|it| {
        it.land = Arc::default();
        it.loaded_world = 2;
    });
    let bare = drawn(&second, &mut after, &bare).unwrap();
    assert!(difference(&bare, &picture).1 > 0.1, "there is land");
}

#[test]
fn a_refused_shader_is_told_in_one_line_and_nothing_breaks() {
    let Some(gpu) = adapter() else { return };
    for (name, text) in [
        ("terrain", "fn vertex( { nothing }"),
        ("sky", "@fragment fn fragment() {}"),
    ] {
        let shaders = Shaders::with(name, text);
        let mut renderer = Renderer::with_shaders(&gpu, OPTIONS, shaders).unwrap();
        assert_eq!(renderer.fault(), None);
        drawn(&gpu, &mut renderer, &view()).unwrap();
        let words = renderer.fault().unwrap().to_string();
        assert!(words.contains("refuses a shader"), "{words}");
        assert!(
            !words.contains(['\n', '\u{2502}', '\u{250c}']) && words.chars().count() < 320,
            "{words}"
        );
        assert_eq!(gpu.take_error(), None, "{name}");
    }
    let refused = Renderer::with_shaders(&gpu, OPTIONS, Shaders::with("tonemap", "nothing"));
    assert!(matches!(refused, Err(RenderError::Shader(_))));
}
