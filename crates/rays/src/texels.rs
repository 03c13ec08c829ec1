//! Lists of four words that lie in a texture.
//!
//! Software adapters read textures many lanes at a time and buffers lane after lane: rays spend most of their time reading
//! nodes and triangles, and take a third of the time where these lie in textures.

use bytemuck::{Pod, cast_slice};
use wgpu::{
    Device, Extent3d, Origin3d, Queue, TexelCopyBufferLayout, TexelCopyTextureInfo, Texture,
    TextureView,
};

use crate::error::RaysError;

/// Texels of a row; `ROW` of scene.wgsl.
pub const ROW: usize = 2048;

/// At least so many rows, and never a power of two: software adapters compile a shader anew where a texture's height becomes
/// one or is one no more, which takes seconds.
fn uneven(rows: usize) -> usize {
    let rows = rows.max(3);
    rows + usize::from(rows.is_power_of_two())
}

/// A list of four words each.
#[derive(Debug)]
pub struct Texels {
    texture: Texture,
    /// What shaders are bound to.
    pub view: TextureView,
}

impl Texels {
    /// With room for so many.
    ///
    /// # Errors
    /// When the adapter has no textures as large.
    pub fn new(device: &Device, label: &'static str, count: usize) -> Result<Self, RaysError> {
        let rows = uneven(count.div_ceil(ROW));
        let most = device.limits().max_texture_dimension_2d as usize;
        if rows > most || ROW > most {
            return Err(RaysError::TooLarge {
                what: format!("{count} texels of {label}"),
                most: (most * ROW) as u64,
            });
        }
        let texture = device.create_texture(&wgpu::TextureDescriptor {
            label: Some(label),
            size: Extent3d {
                width: ROW as u32,
                height: rows as u32,
                depth_or_array_layers: 1,
            },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: wgpu::TextureFormat::Rgba32Uint,
            usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
            view_formats: &[],
        });
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        Ok(Self { texture, view })
    }

    /// Writes whole texels from the one of that number on.
    pub fn write<T: Pod>(&self, queue: &Queue, first: usize, contents: &[T]) {
        let (texels, _) = cast_slice::<T, u8>(contents).as_chunks::<16>();
        let (mut at, mut left) = (first, texels);
        while !left.is_empty() {
            let (x, y) = (at % ROW, at / ROW);
            // The rest of a row, or rows as a whole.
            let (width, height) = if x > 0 || left.len() < ROW {
                (left.len().min(ROW - x), 1)
            } else {
                (ROW, left.len() / ROW)
            };
            let (now, later) = left.split_at(width * height);
            self.write_block(queue, (x, y), (width, height), now);
            (at, left) = (at + now.len(), later);
        }
    }

    fn write_block(
        &self,
        queue: &Queue,
        (x, y): (usize, usize),
        (width, height): (usize, usize),
        texels: &[[u8; 16]],
    ) {
        queue.write_texture(
            TexelCopyTextureInfo {
                texture: &self.texture,
                mip_level: 0,
                origin: Origin3d {
                    x: x as u32,
                    y: y as u32,
                    z: 0,
                },
                aspect: wgpu::TextureAspect::All,
            },
            texels.as_flattened(),
            TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: Some(16 * width as u32),
                rows_per_image: Some(height as u32),
            },
            Extent3d {
                width: width as u32,
                height: height as u32,
                depth_or_array_layers: 1,
            },
        );
    }
}
