//! Pictures on surfaces, as layers of one array, each with its smaller copies.

use std::sync::{Arc, Mutex, PoisonError};

use image::imageops::{FilterType, resize};
use wgpu::{Device, Extent3d, Queue, Texture, TextureView};

use crate::error::RaysError;
use crate::scene::TextureImage;

/// Side of every layer, pixels, of a few pictures and of more; pictures of another size are scaled.
const SIDES: (u32, u32) = (1024, 512);
/// How many are a few: they take up 5.6 MB each.
const FEW: usize = 24;

/// What was put into the adapter's memory last, of which the next scene may take over what it has, too: to scale a picture takes
/// longer than all else that an edit of a room makes anew.
#[derive(Debug, Default)]
pub struct Uploads {
    last: Mutex<Option<Uploaded>>,
}

#[derive(Debug)]
struct Uploaded {
    pictures: Vec<Arc<TextureImage>>,
    side: u32,
    texture: Texture,
}

impl Uploads {
    /// Puts the pictures into the adapter's memory. Without any there is one small white layer.
    pub fn put(
        &self,
        device: &Device,
        queue: &Queue,
        textures: &[Arc<TextureImage>],
    ) -> Result<TextureView, RaysError> {
        let mut last = self.last.lock().unwrap_or_else(PoisonError::into_inner);
        let uploaded = match last.take() {
            Some(kept) if kept.is_of(textures) => kept,
            before => Uploaded::new(device, queue, textures, before.as_ref())?,
        };
        let view = uploaded.texture.create_view(&wgpu::TextureViewDescriptor {
            dimension: Some(wgpu::TextureViewDimension::D2Array),
            ..Default::default()
        });
        *last = Some(uploaded);
        Ok(view)
    }
}

fn is_same(one: &Arc<TextureImage>, other: &Arc<TextureImage>) -> bool {
    Arc::ptr_eq(&one.image, &other.image) || one.image == other.image
}

impl Uploaded {
    fn is_of(&self, textures: &[Arc<TextureImage>]) -> bool {
        let pairs = self.pictures.iter().zip(textures);
        self.pictures.len() == textures.len()
            && pairs.into_iter().all(|(one, other)| is_same(one, other))
    }

    fn new(
        device: &Device,
        queue: &Queue,
        textures: &[Arc<TextureImage>],
        before: Option<&Self>,
    ) -> Result<Self, RaysError> {
        let most = device.limits().max_texture_array_layers;
        if textures.len() > most as usize {
            return Err(RaysError::TooLarge {
                what: format!("{} pictures on its surfaces", textures.len()),
                most: most.into(),
            });
        }
        let side = match textures.len() {
            // With a smaller copy, as others have: software adapters would compile a shader anew for a texture without.
            0 => 2,
            1..=FEW => SIDES.0,
            _ => SIDES.1,
        };
        let uploaded = Self {
            pictures: textures.to_vec(),
            side,
            texture: texture(device, side, textures.len().max(1) as u32),
        };
        let before = before.filter(|it| it.side == side);
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        for (layer, picture) in textures.iter().enumerate() {
            let known = before.and_then(|before| {
                let at = before.pictures.iter().position(|it| is_same(it, picture));
                Some((before, at? as u32))
            });
            match known {
                Some((before, from)) => {
                    before.copy_layer(&mut encoder, from, (&uploaded, layer as u32));
                }
                None => uploaded.scale_into(queue, layer as u32, picture),
            }
        }
        queue.submit([encoder.finish()]);
        if textures.is_empty() {
            write(queue, &uploaded.texture, (0, 0), 2, &[255; 16]);
            write(queue, &uploaded.texture, (0, 1), 1, &[255; 4]);
        }
        Ok(uploaded)
    }

    fn scale_into(&self, queue: &Queue, layer: u32, picture: &TextureImage) {
        for level in 0..self.texture.mip_level_count() {
            let side = self.side >> level;
            let scaled = resize(&*picture.image, side, side, FilterType::Triangle);
            write(queue, &self.texture, (layer, level), side, &scaled);
        }
    }

    fn copy_layer(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        from: u32,
        (into, layer): (&Self, u32),
    ) {
        for mip_level in 0..self.texture.mip_level_count() {
            let place = |texture, z| wgpu::TexelCopyTextureInfo {
                texture,
                mip_level,
                origin: wgpu::Origin3d { x: 0, y: 0, z },
                aspect: wgpu::TextureAspect::All,
            };
            let side = self.side >> mip_level;
            encoder.copy_texture_to_texture(
                place(&self.texture, from),
                place(&into.texture, layer),
                Extent3d {
                    width: side,
                    height: side,
                    depth_or_array_layers: 1,
                },
            );
        }
    }
}

/// Layers of that side, each with copies half as large as the one before, down to one pixel.
fn texture(device: &Device, side: u32, layers: u32) -> Texture {
    use wgpu::TextureUsages as Usage;
    device.create_texture(&wgpu::TextureDescriptor {
        label: Some("room textures"),
        size: Extent3d {
            width: side,
            height: side,
            depth_or_array_layers: layers,
        },
        mip_level_count: side.ilog2() + 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: wgpu::TextureFormat::Rgba8UnormSrgb,
        usage: Usage::TEXTURE_BINDING | Usage::COPY_DST | Usage::COPY_SRC,
        view_formats: &[],
    })
}

fn write(queue: &Queue, texture: &Texture, (layer, level): (u32, u32), side: u32, bytes: &[u8]) {
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
