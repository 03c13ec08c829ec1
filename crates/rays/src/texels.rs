//! Lists of four words that lie in a texture.
//!
//! Software adapters read textures many lanes at a time and buffers lane after lane: rays spend most of their time reading
//! nodes and triangles, and take a third of the time where these lie in textures.

use bytemuck::{Pod, cast_slice};
use wgpu::{
    BufferUsages, CommandEncoder, Device, Extent3d, Origin3d, Queue, TexelCopyBufferInfo,
    TexelCopyBufferLayout, TexelCopyTextureInfo, Texture, TextureView,
};

use crate::error::RaysError;

/// Texels of a row; `ROW` of scene.wgsl.
pub const ROW: usize = 2048;
/// Bytes of one.
const TEXEL: usize = 16;

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
    /// With room for so many, and with whole texels in it, of which each slice begins at a texel. The encoder is told to bring
    /// them there. They are copied without the queue: it would be locked meanwhile, and a frame that another thread draws
    /// would wait.
    ///
    /// # Errors
    /// When the adapter has no textures as large, or no memory for them.
    pub fn new(
        device: &Device,
        encoder: &mut CommandEncoder,
        label: &'static str,
        count: usize,
        contents: &[(usize, &[u8])],
    ) -> Result<Self, RaysError> {
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
        let made = Self { texture, view };
        made.fill(device, encoder, contents)?;
        Ok(made)
    }

    fn fill(
        &self,
        device: &Device,
        encoder: &mut CommandEncoder,
        contents: &[(usize, &[u8])],
    ) -> Result<(), RaysError> {
        let ends = contents.iter().map(|(first, it)| TEXEL * first + it.len());
        let rows = ends.max().unwrap_or_default().div_ceil(TEXEL * ROW);
        if rows == 0 {
            return Ok(());
        }
        let staging = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("texels"),
            size: (rows * ROW * TEXEL) as u64,
            usage: BufferUsages::MAP_WRITE | BufferUsages::COPY_SRC,
            mapped_at_creation: true,
        });
        {
            let mapped = staging.slice(..).get_mapped_range_mut();
            let mut mapped = mapped.map_err(|error| RaysError::Upload(error.to_string()))?;
            for (first, bytes) in contents {
                let at = TEXEL * first;
                mapped.slice(at..at + bytes.len()).copy_from_slice(bytes);
            }
        }
        staging.unmap();
        encoder.copy_buffer_to_texture(
            TexelCopyBufferInfo {
                buffer: &staging,
                layout: layout(ROW, rows),
            },
            self.from((0, 0)),
            extent(ROW, rows),
        );
        Ok(())
    }

    /// Writes whole texels from the one of that number on.
    pub fn write<T: Pod>(&self, queue: &Queue, first: usize, contents: &[T]) {
        let (texels, _) = cast_slice::<T, u8>(contents).as_chunks::<TEXEL>();
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
        texels: &[[u8; TEXEL]],
    ) {
        queue.write_texture(
            self.from((x, y)),
            texels.as_flattened(),
            layout(width, height),
            extent(width, height),
        );
    }

    /// From that texel of that row on.
    fn from(&self, (x, y): (usize, usize)) -> TexelCopyTextureInfo<'_> {
        TexelCopyTextureInfo {
            texture: &self.texture,
            mip_level: 0,
            origin: Origin3d {
                x: x as u32,
                y: y as u32,
                z: 0,
            },
            aspect: wgpu::TextureAspect::All,
        }
    }
}

fn layout(width: usize, height: usize) -> TexelCopyBufferLayout {
    TexelCopyBufferLayout {
        offset: 0,
        bytes_per_row: Some((TEXEL * width) as u32),
        rows_per_image: Some(height as u32),
    }
}

fn extent(width: usize, height: usize) -> Extent3d {
    Extent3d {
        width: width as u32,
        height: height as u32,
        depth_or_array_layers: 1,
    }
}
