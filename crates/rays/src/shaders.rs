//! The texts of the shaders, which are built in.

const SPACE: &str = include_str!("../../../shaders/rays/space.wgsl");
const SCENE: &str = include_str!("../../../shaders/rays/scene.wgsl");
const TRACE: &str = include_str!("../../../shaders/rays/trace.wgsl");
const SHADING: &str = include_str!("../../../shaders/rays/shading.wgsl");
const FRAME: &str = include_str!("../../../shaders/rays/frame.wgsl");
const LAMPS: &str = include_str!("../../../shaders/rays/lamps.wgsl");

/// The files of the pass that draws a picture, in their order.
pub const PICTURE: [&str; 7] = [
    SPACE,
    SCENE,
    TRACE,
    FRAME,
    SHADING,
    LAMPS,
    include_str!("../../../shaders/rays/picture.wgsl"),
];

/// The files of the pass that traces a list of rays.
pub const PROBE: [&str; 4] = [
    SPACE,
    SCENE,
    TRACE,
    include_str!("../../../shaders/rays/probe.wgsl"),
];

/// Compiles the files as one.
pub fn compile(device: &wgpu::Device, label: &str, files: &[&str]) -> wgpu::ShaderModule {
    device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some(label),
        source: wgpu::ShaderSource::Wgsl(files.join("\n").into()),
    })
}
