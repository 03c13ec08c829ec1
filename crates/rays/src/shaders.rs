//! The texts of the shaders, which are built in.

const SPACE: &str = include_str!("../../../shaders/rays/space.wgsl");
const PORTAL: &str = include_str!("../../../shaders/rays/portal.wgsl");
const SCENE: &str = include_str!("../../../shaders/rays/scene.wgsl");
const TRACE: &str = include_str!("../../../shaders/rays/trace.wgsl");
const SHADING: &str = include_str!("../../../shaders/rays/shading.wgsl");
const FRAME: &str = include_str!("../../../shaders/rays/frame.wgsl");
const LIGHT: &str = include_str!("../../../shaders/rays/picture.wgsl");
const LAMPS: &str = include_str!("../../../shaders/rays/lamps.wgsl");

/// The files of the pass that draws a picture, in their order.
pub const PICTURE: [&str; 9] = [
    SPACE,
    PORTAL,
    SCENE,
    TRACE,
    FRAME,
    SHADING,
    LAMPS,
    LIGHT,
    include_str!("../../../shaders/rays/first_by_rays.wgsl"),
];

/// The files of the same pass behind a raster.
pub const RASTERED: [&str; 9] = [
    SPACE,
    PORTAL,
    SCENE,
    TRACE,
    FRAME,
    SHADING,
    LAMPS,
    LIGHT,
    include_str!("../../../shaders/rays/first_by_raster.wgsl"),
];

/// The raster.
pub const RASTER: &str = include_str!("../../../shaders/rays/raster.wgsl");

/// The files of the pass that traces a list of rays.
pub const PROBE: [&str; 5] = [
    SPACE,
    PORTAL,
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
