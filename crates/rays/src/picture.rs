//! Where a picture is drawn, and reading it back.

use std::sync::{Arc, Mutex, PoisonError};

use bytemuck::cast_slice;
use half::f16;
use wgpu::{Device, Queue, Texture, TextureFormat, TextureUsages, TextureView};

use crate::error::RaysError;
use crate::raster::Visible;

/// Light, linear and unclamped.
pub const LIGHT_FORMAT: TextureFormat = TextureFormat::Rgba16Float;
/// What is seen, and the bits of how far off it is, felt metres.
pub const SEEN_FORMAT: TextureFormat = TextureFormat::Rg32Uint;

/// Light and what is seen, of one size.
#[derive(Debug)]
pub struct Picture {
    /// Pixels.
    pub size: (u32, u32),
    /// Light, `Rgba16Float`; for the tone map to read.
    pub light: TextureView,
    /// What is seen.
    pub seen: TextureView,
    light_texture: Texture,
    seen_texture: Texture,
    /// What a raster sees, once one is asked.
    visible: Mutex<Option<Arc<Visible>>>,
}

/// What a pixel shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Seen {
    /// The sky, or fog.
    Nothing,
    /// An object, by what it is called.
    Object(u32),
    /// The wall of an aberration, by number.
    Wall(u32),
}

/// What a pixel shows, and how far off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pixel {
    /// What.
    pub seen: Seen,
    /// Felt metres.
    pub length_m: f32,
}

impl Picture {
    /// A picture of at least one pixel each way.
    pub fn new(device: &Device, size: (u32, u32)) -> Self {
        let most = device.limits().max_texture_dimension_2d;
        let size = (size.0.clamp(1, most), size.1.clamp(1, most));
        let make = |label, format| {
            device.create_texture(&wgpu::TextureDescriptor {
                label: Some(label),
                size: wgpu::Extent3d {
                    width: size.0,
                    height: size.1,
                    depth_or_array_layers: 1,
                },
                mip_level_count: 1,
                sample_count: 1,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage: TextureUsages::STORAGE_BINDING
                    | TextureUsages::TEXTURE_BINDING
                    | TextureUsages::COPY_SRC,
                view_formats: &[],
            })
        };
        let light_texture = make("light of rays", LIGHT_FORMAT);
        let seen_texture = make("what rays see", SEEN_FORMAT);
        let view = |texture: &Texture| texture.create_view(&wgpu::TextureViewDescriptor::default());
        Self {
            size,
            light: view(&light_texture),
            seen: view(&seen_texture),
            light_texture,
            seen_texture,
            visible: Mutex::default(),
        }
    }

    /// Where a raster writes what it sees, with room for so many samples and levels.
    pub(crate) fn visible(&self, device: &Device, samples: u32, levels: usize) -> Arc<Visible> {
        let most = device.limits().max_texture_dimension_2d;
        let size = (self.size.0, (self.size.1 * samples).min(most));
        let mut held = self.visible.lock().unwrap_or_else(PoisonError::into_inner);
        let fits = |it: &&Arc<Visible>| it.size == size && it.levels >= levels;
        if let Some(known) = held.as_ref().filter(fits) {
            return known.clone();
        }
        held.insert(Arc::new(Visible::new(device, size, levels)))
            .clone()
    }

    /// Waits for all that was submitted and reads the light, row by row from the top; red, green and blue.
    ///
    /// # Errors
    /// When the adapter is lost or its memory cannot be read.
    pub fn read_light(&self, device: &Device, queue: &Queue) -> Result<Vec<[f32; 3]>, RaysError> {
        let bytes = read(device, queue, &self.light_texture)?;
        let pixels = bytes.as_chunks::<8>().0.iter();
        Ok(pixels
            .map(|pixel| {
                [0, 1, 2].map(|i| f16::from_le_bytes([pixel[2 * i], pixel[2 * i + 1]]).to_f32())
            })
            .collect())
    }

    /// Waits for all that was submitted and reads what is seen, row by row from the top.
    ///
    /// # Errors
    /// When the adapter is lost or its memory cannot be read.
    pub fn read_seen(&self, device: &Device, queue: &Queue) -> Result<Vec<Pixel>, RaysError> {
        let bytes = read(device, queue, &self.seen_texture)?;
        let words: Vec<u32> = bytes
            .as_chunks::<4>()
            .0
            .iter()
            .map(|word| u32::from_le_bytes(*word))
            .collect();
        Ok(words
            .as_chunks::<2>()
            .0
            .iter()
            .map(|[what, length]| pixel(*what, *length))
            .collect())
    }
}

fn pixel(what: u32, length: u32) -> Pixel {
    let seen = match what {
        0 => Seen::Nothing,
        wall if wall >= 0x8000_0000 => Seen::Wall(wall - 0x8000_0000),
        object => Seen::Object(object - 1),
    };
    Pixel {
        seen,
        length_m: f32::from_bits(length),
    }
}

/// All bytes of a texture of eight bytes a pixel, rows behind each other.
fn read(device: &Device, queue: &Queue, texture: &Texture) -> Result<Vec<u8>, RaysError> {
    let (row, rows) = (texture.width() * 8, texture.height());
    let padded = row.next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
    let buffer = device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("read back"),
        size: u64::from(padded) * u64::from(rows),
        usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    encoder.copy_texture_to_buffer(
        texture.as_image_copy(),
        wgpu::TexelCopyBufferInfo {
            buffer: &buffer,
            layout: wgpu::TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: Some(padded),
                rows_per_image: Some(rows),
            },
        },
        texture.size(),
    );
    queue.submit([encoder.finish()]);
    let bytes = mapped(device, &buffer)?;
    let kept = bytes
        .chunks_exact(padded as usize)
        .flat_map(|line| &line[..row as usize]);
    Ok(kept.copied().collect())
}

/// Waits for a buffer and copies it out.
pub fn mapped(device: &Device, buffer: &wgpu::Buffer) -> Result<Vec<u8>, RaysError> {
    let (sender, receiver) = std::sync::mpsc::channel();
    buffer.map_async(wgpu::MapMode::Read, .., move |result| {
        // Nobody listens any more only where the wait has failed.
        let _ = sender.send(result);
    });
    let failed = |why: String| RaysError::Readback(why);
    device
        .poll(wgpu::PollType::wait_indefinitely())
        .map_err(|error| failed(error.to_string()))?;
    receiver
        .recv()
        .map_err(|error| failed(error.to_string()))?
        .map_err(|error| failed(error.to_string()))?;
    let range = buffer
        .get_mapped_range(..)
        .map_err(|error| failed(error.to_string()))?;
    Ok(cast_slice(&range).to_vec())
}
