//! The textures a frame is drawn in before it reaches its target.

use wgpu::{Device, Extent3d, TextureFormat, TextureUsages, TextureView};

/// Light, linear and unclamped.
pub const LIGHT_FORMAT: TextureFormat = TextureFormat::Rgba16Float;
/// Reversed depth.
pub const DEPTH_FORMAT: TextureFormat = TextureFormat::Depth32Float;

/// Light and depth of one size.
#[derive(Debug)]
pub struct Targets {
    /// Pixels drawn.
    pub size: (u32, u32),
    /// Light of one sample a pixel; what is shown.
    pub light: TextureView,
    /// Light of several samples a pixel, where there are several.
    pub samples: Option<TextureView>,
    /// Depth, with as many samples.
    pub depth: TextureView,
}

impl Targets {
    /// Targets of `size` pixels.
    pub fn new(device: &Device, size: (u32, u32), samples: u32) -> Self {
        let shown = TextureUsages::RENDER_ATTACHMENT | TextureUsages::TEXTURE_BINDING;
        let unshown = TextureUsages::RENDER_ATTACHMENT;
        Self {
            size,
            light: view(device, "light", size, 1, LIGHT_FORMAT, shown),
            samples: (samples > 1).then(|| {
                view(
                    device,
                    "light samples",
                    size,
                    samples,
                    LIGHT_FORMAT,
                    unshown,
                )
            }),
            depth: view(device, "depth", size, samples, DEPTH_FORMAT, unshown),
        }
    }
}

fn view(
    device: &Device,
    label: &str,
    size: (u32, u32),
    sample_count: u32,
    format: TextureFormat,
    usage: TextureUsages,
) -> TextureView {
    let (width, height) = size;
    let texture = device.create_texture(&wgpu::TextureDescriptor {
        label: Some(label),
        size: Extent3d {
            width,
            height,
            depth_or_array_layers: 1,
        },
        mip_level_count: 1,
        sample_count,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage,
        view_formats: &[],
    });
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}

/// Pixels drawn for a target of `width` by `height` at a share of its resolution: at least 1, at most `most`.
pub fn drawn_size(width: u32, height: u32, scale: f32, most: u32) -> (u32, u32) {
    let side = |pixels: u32| ((pixels as f32 * scale).round() as u32).clamp(1, most);
    (side(width), side(height))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_scaled_and_never_vanish_or_outgrow_the_adapter() {
        assert_eq!(drawn_size(1280, 720, 0.5, 8192), (640, 360));
        assert_eq!(drawn_size(1, 0, 0.5, 8192), (1, 1));
        assert_eq!(drawn_size(10_000, 5, 1.0, 8192), (8192, 5));
    }
}
