//! The pictures of the sky on the adapter: the band of faint stars on a cube, and clouds that repeat.
//! `assets/sky/make_sky.py` makes them.

use image::{DynamicImage, ImageError};
use wgpu::util::{DeviceExt, TextureDataOrder};
use wgpu::{
    AddressMode, BindGroupEntry, BindGroupLayoutEntry, BindingResource, BindingType, Device,
    Extent3d, FilterMode, MipmapFilterMode, Queue, Sampler, SamplerBindingType, ShaderStages,
    TextureDescriptor, TextureDimension, TextureFormat, TextureSampleType, TextureUsages,
    TextureView, TextureViewDescriptor, TextureViewDimension,
};

use crate::error::RenderError;

const STARS: &[u8] = include_bytes!("../../../assets/sky/stars.png");
const CLOUDS: &[u8] = include_bytes!("../../../assets/sky/clouds.png");

/// Faces of a cube.
const FACES: u32 = 6;
/// Bindings of the scene's group: the cube, the clouds, and how both are read.
const CUBE: u32 = 5;
const LAYER: u32 = 6;
const SAMPLER: u32 = 7;

/// The pictures, and how they are read.
#[derive(Debug)]
pub struct Heavens {
    stars: TextureView,
    clouds: TextureView,
    sampler: Sampler,
}

impl Heavens {
    /// Uploads them.
    ///
    /// # Errors
    /// When a picture that the program carries cannot be read.
    pub fn new(device: &Device, queue: &Queue) -> Result<Self, RenderError> {
        let broken = |error: ImageError| {
            RenderError::Options(format!(
                "a picture of the sky inside the program is damaged ({error})"
            ))
        };
        Ok(Self {
            stars: stars(device, queue, &read(STARS).map_err(broken)?),
            clouds: clouds(device, queue, &read(CLOUDS).map_err(broken)?),
            sampler: device.create_sampler(&wgpu::SamplerDescriptor {
                label: Some("heavens"),
                address_mode_u: AddressMode::Repeat,
                address_mode_v: AddressMode::Repeat,
                mag_filter: FilterMode::Linear,
                min_filter: FilterMode::Linear,
                mipmap_filter: MipmapFilterMode::Linear,
                ..Default::default()
            }),
        })
    }

    /// The layout of what [`Heavens::bind`] binds.
    pub fn layout() -> [BindGroupLayoutEntry; 3] {
        let entry = |binding, ty| BindGroupLayoutEntry {
            binding,
            visibility: ShaderStages::FRAGMENT,
            ty,
            count: None,
        };
        let texture = |view_dimension| BindingType::Texture {
            sample_type: TextureSampleType::Float { filterable: true },
            view_dimension,
            multisampled: false,
        };
        [
            entry(CUBE, texture(TextureViewDimension::Cube)),
            entry(LAYER, texture(TextureViewDimension::D2)),
            entry(SAMPLER, BindingType::Sampler(SamplerBindingType::Filtering)),
        ]
    }

    /// What the scene's group has of them.
    pub fn bind(&self) -> [BindGroupEntry<'_>; 3] {
        let entry = |binding, resource| BindGroupEntry { binding, resource };
        [
            entry(CUBE, BindingResource::TextureView(&self.stars)),
            entry(LAYER, BindingResource::TextureView(&self.clouds)),
            entry(SAMPLER, BindingResource::Sampler(&self.sampler)),
        ]
    }
}

fn read(png: &[u8]) -> Result<DynamicImage, ImageError> {
    image::load_from_memory_with_format(png, image::ImageFormat::Png)
}

fn stars(device: &Device, queue: &Queue, picture: &DynamicImage) -> TextureView {
    let pixels = picture.to_rgba8();
    let side = pixels.width();
    let texture = device.create_texture_with_data(
        queue,
        &TextureDescriptor {
            label: Some("band of stars"),
            size: Extent3d {
                width: side,
                height: side,
                depth_or_array_layers: FACES,
            },
            ..described(TextureFormat::Rgba8UnormSrgb)
        },
        TextureDataOrder::LayerMajor,
        &pixels,
    );
    texture.create_view(&TextureViewDescriptor {
        dimension: Some(TextureViewDimension::Cube),
        ..Default::default()
    })
}

fn clouds(device: &Device, queue: &Queue, picture: &DynamicImage) -> TextureView {
    let mut level = with_slopes(&picture.to_luma8());
    let side = level.width();
    let mut pixels = level.to_vec();
    let mut levels = 1;
    while level.width() > 1 {
        level = halved(&level);
        pixels.extend_from_slice(&level);
        levels += 1;
    }
    let texture = device.create_texture_with_data(
        queue,
        &TextureDescriptor {
            label: Some("clouds"),
            size: Extent3d {
                width: side,
                height: side,
                depth_or_array_layers: 1,
            },
            mip_level_count: levels,
            ..described(TextureFormat::Rgba8Unorm)
        },
        TextureDataOrder::LayerMajor,
        &pixels,
    );
    texture.create_view(&TextureViewDescriptor::default())
}

fn described(format: TextureFormat) -> TextureDescriptor<'static> {
    TextureDescriptor {
        label: None,
        size: Extent3d::default(),
        mip_level_count: 1,
        sample_count: 1,
        dimension: TextureDimension::D2,
        format,
        usage: TextureUsages::TEXTURE_BINDING | TextureUsages::COPY_DST,
        view_formats: &[],
    }
}

/// A picture that repeats, and beside it in green and blue how much it falls over three pixels to the right and downwards,
/// halved and from the middle: one read of it tells what two would.
fn with_slopes(picture: &image::GrayImage) -> image::RgbaImage {
    let (width, height) = picture.dimensions();
    let at = |x: u32, y: u32| i32::from(picture.get_pixel(x % width, y % height).0[0]);
    let fall = |before: i32, after: i32| (127 + (before - after) / 4).clamp(0, 255) as u8;
    image::RgbaImage::from_fn(width, height, |x, y| {
        let (left, above) = (x + width, y + height);
        let right = fall(
            at(left - 2, y) + at(left - 1, y),
            at(x + 1, y) + at(x + 2, y),
        );
        let down = fall(
            at(x, above - 2) + at(x, above - 1),
            at(x, y + 1) + at(x, y + 2),
        );
        image::Rgba([at(x, y) as u8, right, down, u8::MAX])
    })
}

/// Half as large along each side: the mean of each four pixels.
fn halved(picture: &image::RgbaImage) -> image::RgbaImage {
    image::RgbaImage::from_fn(picture.width() / 2, picture.height() / 2, |x, y| {
        let four = [(0, 0), (1, 0), (0, 1), (1, 1)];
        let pixels = four.map(|(i, j)| picture.get_pixel(2 * x + i, 2 * y + j).0);
        image::Rgba(std::array::from_fn(|channel| {
            let sum: u16 = pixels.iter().map(|pixel| u16::from(pixel[channel])).sum();
            ((sum + 2) / 4) as u8
        }))
    })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use super::*;

    #[test]
    fn the_faces_of_the_cube_meet_at_their_edges() {
        let strip = read(STARS).unwrap().to_rgba8();
        let side = strip.width();
        assert_eq!(strip.height(), FACES * side);
        let at = |face: u32, x: u32, y: u32| i32::from(strip.get_pixel(x, face * side + y).0[1]);
        let last = side - 1;
        // The right edge of +z is the left one of +x, and its upper edge the lower one of +y. Neighbours across them
        // differ as neighbours within a face do, which is by the grain of the faintest stars.
        let sum = |step: &dyn Fn(u32) -> i32| -> i32 { (0..side).map(step).map(i32::abs).sum() };
        let across =
            sum(&|i| at(4, last, i) - at(0, 0, i)) + sum(&|i| at(4, i, 0) - at(2, i, last));
        let within =
            sum(&|i| at(4, last, i) - at(4, last - 1, i)) + sum(&|i| at(4, i, 0) - at(4, i, 1));
        assert!(across < within * 3 / 2, "{across} and {within}");
        let brightest = (0..side).map(|i| at(4, last, i)).max();
        assert!(brightest > Some(40), "{brightest:?}");
    }

    #[test]
    fn clouds_go_on_over_their_edges() {
        let clouds = read(CLOUDS).unwrap().to_luma8();
        let last = clouds.width() - 1;
        let at = |x: u32, y: u32| i32::from(clouds.get_pixel(x, y).0[0]);
        let steps =
            |a: u32, b: u32| -> i32 { (0..=last).map(|i| (at(a, i) - at(b, i)).abs()).sum() };
        assert!(steps(last, 0) < 2 * steps(100, 101), "{}", steps(last, 0));
    }
}
