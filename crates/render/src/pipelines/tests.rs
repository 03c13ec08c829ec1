//! What becomes of a map that cannot be drawn.
#![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

use antipode_geometry::shader::{FLAT, OPEN};

use super::*;
use crate::gpu::Gpu;

/// A map with one function of its list.
static HALF: MapShader = MapShader {
    name: "half",
    text: "fn port(space: Space, p: vec3<f32>) -> vec4<f32> { return vec4<f32>(p, 1.0); }",
    daylight: &OPEN,
    ..FLAT
};

#[test]
fn a_map_that_lacks_a_function_is_refused_in_words_and_not_drawn_flat() {
    let Some(gpu) = Gpu::for_test() else {
        return;
    };
    let layout = gpu
        .device
        .create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: None,
            entries: &[],
        });
    let made = Pipelines::new(
        &gpu.device,
        Shaders::default(),
        &layout,
        Key::whole(&HALF),
        (1, ShadowQuality::Off, false),
    );
    let words = made.err().unwrap();
    assert!(
        words.contains("\"half\"") && words.contains("no function port_normal"),
        "{words}"
    );
}
