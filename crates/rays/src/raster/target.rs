//! Where a raster writes what is seen, level by level.

use wgpu::{
    Device, Extent3d, TextureDescriptor, TextureDimension, TextureFormat, TextureUsages,
    TextureView, TextureViewDescriptor, TextureViewDimension,
};

/// Which triangle, wall or door; and instance and view.
pub const VISIBLE_FORMAT: TextureFormat = TextureFormat::Rg32Uint;
/// Depth.
pub const DEPTH_FORMAT: TextureFormat = TextureFormat::Depth32Float;

/// What is seen at each pixel in each level; samples of a picture lie below each other.
#[derive(Debug)]
pub struct Visible {
    /// Pixels, and levels that there is room for.
    pub size: (u32, u32),
    /// Levels that there is room for.
    pub levels: usize,
    /// All levels.
    pub all: TextureView,
    /// Each level.
    pub each: Vec<TextureView>,
    /// Depth, which levels share.
    pub depth: TextureView,
}

impl Visible {
    /// Of that many pixels and levels.
    pub fn new(device: &Device, size: (u32, u32), levels: usize) -> Self {
        let make = |label, format, layers: usize, usage| {
            device.create_texture(&TextureDescriptor {
                label: Some(label),
                size: Extent3d {
                    width: size.0,
                    height: size.1,
                    depth_or_array_layers: layers as u32,
                },
                mip_level_count: 1,
                sample_count: 1,
                dimension: TextureDimension::D2,
                format,
                usage,
                view_formats: &[],
            })
        };
        let usage = TextureUsages::RENDER_ATTACHMENT | TextureUsages::TEXTURE_BINDING;
        let seen = make("what a raster sees", VISIBLE_FORMAT, levels, usage);
        let usage = TextureUsages::RENDER_ATTACHMENT;
        let depth = make("depth of a raster", DEPTH_FORMAT, 1, usage);
        let each = (0..levels as u32).map(|level| {
            seen.create_view(&TextureViewDescriptor {
                dimension: Some(TextureViewDimension::D2),
                base_array_layer: level,
                array_layer_count: Some(1),
                ..Default::default()
            })
        });
        Self {
            size,
            levels,
            each: each.collect(),
            all: seen.create_view(&TextureViewDescriptor {
                dimension: Some(TextureViewDimension::D2Array),
                ..Default::default()
            }),
            depth: depth.create_view(&TextureViewDescriptor::default()),
        }
    }
}
