//! Pictures on surfaces, as layers of one array, each with its smaller copies.

use std::sync::Arc;

use image::imageops::{FilterType, resize};
use wgpu::{Device, Extent3d, Queue, TextureView};

use crate::error::RaysError;
use crate::scene::TextureImage;

/// Side of every layer, pixels, of a few pictures and of more; pictures of another size are scaled.
const SIDES: (u32, u32) = (1024, 512);
/// How many are a few: they take up 5.6 MB each.
const FEW: usize = 24;

/// Puts the pictures into the adapter's memory. Without any there is one white layer of one pixel.
pub fn upload(
    device: &Device,
    queue: &Queue,
    textures: &[Arc<TextureImage>],
) -> Result<TextureView, RaysError> {
    let most = device.limits().max_texture_array_layers;
    if textures.len() > most as usize {
        return Err(RaysError::TooLarge {
            what: format!("{} pictures on its surfaces", textures.len()),
            most: most.into(),
        });
    }
    let side = match textures.len() {
        0 => 1,
        1..=FEW => SIDES.0,
        _ => SIDES.1,
    };
    // Copies, each half as large as the one before, down to one pixel.
    let levels = side.ilog2() + 1;
    let texture = device.create_texture(&wgpu::TextureDescriptor {
        label: Some("room textures"),
        size: Extent3d {
            width: side,
            height: side,
            depth_or_array_layers: textures.len().max(1) as u32,
        },
        mip_level_count: levels,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: wgpu::TextureFormat::Rgba8UnormSrgb,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    });
    for (layer, picture) in textures.iter().enumerate() {
        for level in 0..levels {
            let side = side >> level;
            let scaled = resize(&picture.image, side, side, FilterType::Triangle);
            write(queue, &texture, (layer as u32, level), side, &scaled);
        }
    }
    if textures.is_empty() {
        write(queue, &texture, (0, 0), 1, &[255; 4]);
    }
    Ok(texture.create_view(&wgpu::TextureViewDescriptor {
        dimension: Some(wgpu::TextureViewDimension::D2Array),
        ..Default::default()
    }))
}

fn write(
    queue: &Queue,
    texture: &wgpu::Texture,
    (layer, level): (u32, u32),
    side: u32,
    bytes: &[u8],
) {
    queue.write_texture(
        wgpu::TexelCopyTextureInfo {
            texture,
            mip_level: level,
            origin: wgpu::Origin3d {
                x: 0,
                y: 0,
                z: layer,
            },
            aspect: wgpu::TextureAspect::All,
        },
        bytes,
        wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(4 * side),
            rows_per_image: Some(side),
        },
        Extent3d {
            width: side,
            height: side,
            depth_or_array_layers: 1,
        },
    );
}
