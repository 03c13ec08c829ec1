//! A picture in the adapter's memory that can be drawn into and read back.

use std::sync::{Arc, OnceLock};

use image::RgbaImage;
use wgpu::{Texture, TextureFormat, TextureUsages, TextureView};

use crate::error::RenderError;
use crate::gpu::Gpu;

/// Rows of a copied picture start at multiples of this many bytes.
const ROW_ALIGNMENT: u32 = wgpu::COPY_BYTES_PER_ROW_ALIGNMENT;

/// A target of fixed size, of a format with four 8-bit channels.
#[derive(Debug)]
pub struct Offscreen {
    texture: Texture,
    view: TextureView,
}

impl Offscreen {
    /// A target of `width` by `height` pixels, each at least 1, in a format of four 8-bit channels.
    pub fn new(gpu: &Gpu, width: u32, height: u32, format: TextureFormat) -> Self {
        let most = gpu.device.limits().max_texture_dimension_2d;
        let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
            label: Some("offscreen"),
            size: wgpu::Extent3d {
                width: width.clamp(1, most),
                height: height.clamp(1, most),
                depth_or_array_layers: 1,
            },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format,
            usage: TextureUsages::RENDER_ATTACHMENT
                | TextureUsages::COPY_SRC
                | TextureUsages::TEXTURE_BINDING,
            view_formats: &[],
        });
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        Self { texture, view }
    }

    /// What to draw into.
    pub fn view(&self) -> &TextureView {
        &self.view
    }

    /// Waits for everything submitted and reads the picture, as sRGB values with opaque alpha.
    ///
    /// # Errors
    /// When the adapter is lost or its memory cannot be read.
    pub fn read(&self, gpu: &Gpu) -> Result<RgbaImage, RenderError> {
        self.begin_read(gpu).finish(gpu)
    }

    /// Has the picture read once everything submitted is drawn, without waiting for it.
    pub fn begin_read(&self, gpu: &Gpu) -> PictureReading {
        let (width, height) = (self.texture.width(), self.texture.height());
        let row_bytes = (width * 4).next_multiple_of(ROW_ALIGNMENT);
        let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("read back"),
            size: u64::from(row_bytes) * u64::from(height),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let mut encoder = gpu.encoder();
        encoder.copy_texture_to_buffer(
            self.texture.as_image_copy(),
            wgpu::TexelCopyBufferInfo {
                buffer: &buffer,
                layout: wgpu::TexelCopyBufferLayout {
                    offset: 0,
                    bytes_per_row: Some(row_bytes),
                    rows_per_image: Some(height),
                },
            },
            self.texture.size(),
        );
        gpu.queue.submit([encoder.finish()]);
        let mapped = Arc::new(OnceLock::new());
        let outcome = Arc::clone(&mapped);
        buffer.map_async(wgpu::MapMode::Read, .., move |result| {
            // The only one to set it.
            let _ = outcome.set(result.map_err(|error| error.to_string()));
        });
        PictureReading {
            buffer,
            mapped,
            size: (width, height),
            row_bytes,
            swap: swapped(self.texture.format()),
        }
    }
}

/// A picture on its way out of the adapter's memory.
#[derive(Debug)]
pub struct PictureReading {
    buffer: wgpu::Buffer,
    /// How mapping the buffer has ended, when it has.
    mapped: Arc<OnceLock<Result<(), String>>>,
    size: (u32, u32),
    row_bytes: u32,
    swap: bool,
}

impl PictureReading {
    /// The picture if it is there, otherwise the reading, to ask again. Never waits.
    ///
    /// # Errors
    /// The reading itself while it is not finished; what is inside fails as [`Offscreen::read`] does.
    pub fn poll(self, gpu: &Gpu) -> Result<Result<RgbaImage, RenderError>, Self> {
        // A lost adapter never maps anything, and its loss is told elsewhere.
        let lost = gpu.device.poll(wgpu::PollType::Poll).is_err() || gpu.lost().is_some();
        if lost || self.mapped.get().is_some() {
            Ok(self.finish(gpu))
        } else {
            Err(self)
        }
    }

    /// Gives the picture up, because its adapter is lost: it comes as a failure from now on.
    pub fn give_up(&self) {
        // Unless it has just come.
        let _ = self
            .mapped
            .set(Err("the adapter was lost meanwhile".to_owned()));
    }

    /// Waits for the picture.
    ///
    /// # Errors
    /// As [`Offscreen::read`].
    pub fn finish(self, gpu: &Gpu) -> Result<RgbaImage, RenderError> {
        if self.mapped.get().is_none() {
            gpu.wait()?;
        }
        if let Some(Err(why)) = self.mapped.get() {
            return Err(RenderError::Readback(why.clone()));
        }
        let bytes = self
            .buffer
            .get_mapped_range(..)
            .map_err(|e| RenderError::Readback(e.to_string()))?;
        let (width, height) = self.size;
        let rows = unpad(&bytes, width, self.row_bytes, self.swap);
        RgbaImage::from_raw(width, height, rows)
            .ok_or_else(|| RenderError::Readback("the picture came back incomplete".to_owned()))
    }
}

fn swapped(format: TextureFormat) -> bool {
    matches!(
        format,
        TextureFormat::Bgra8Unorm | TextureFormat::Bgra8UnormSrgb
    )
}

/// Rows without their padding, red first, opaque.
fn unpad(bytes: &[u8], width: u32, row_bytes: u32, swap: bool) -> Vec<u8> {
    let mut rows = Vec::with_capacity(bytes.len());
    for row in bytes.chunks_exact(row_bytes as usize) {
        for texel in row[..width as usize * 4].chunks_exact(4) {
            let [first, green, third] = [texel[0], texel[1], texel[2]];
            let (red, blue) = if swap { (third, first) } else { (first, third) };
            rows.extend_from_slice(&[red, green, blue, u8::MAX]);
        }
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn padding_goes_and_red_comes_first() {
        let mut bytes = vec![9; 16];
        bytes[..8].copy_from_slice(&[1, 2, 3, 0, 4, 5, 6, 0]);
        assert_eq!(unpad(&bytes, 2, 16, false), [1, 2, 3, 255, 4, 5, 6, 255]);
        assert_eq!(unpad(&bytes, 2, 16, true), [3, 2, 1, 255, 6, 5, 4, 255]);
    }
}
