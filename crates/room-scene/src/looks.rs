//! How things in a room look, from what its file says to materials of light.

use std::collections::BTreeMap;
use std::sync::Arc;

use antipode_rays::{Material, Pattern, TextureImage};
use antipode_rooms::room::{Finish, Surface};
use antipode_rooms::{Assets, Colour};
use glam::Vec3;
use image::RgbaImage;

use crate::tuning::{DAYLIGHT, GLASS, MIRROR};

/// Linear light of a colour in sRGB.
pub fn linear(colour: Colour) -> Vec3 {
    let one = |byte: u8| {
        let share = f32::from(byte) / 255.0;
        if share <= 0.040_45 {
            share / 12.92
        } else {
            ((share + 0.055) / 1.055).powf(2.4)
        }
    };
    let [red, green, blue] = colour.0;
    Vec3::new(one(red), one(green), one(blue))
}

/// Pictures on surfaces, each once.
#[derive(Debug, Default)]
pub struct Pictures {
    /// All of them, by number.
    pub all: Vec<Arc<TextureImage>>,
    known: BTreeMap<String, usize>,
}

impl Pictures {
    /// The number of one more.
    pub fn add(&mut self, image: impl Into<Arc<RgbaImage>>) -> usize {
        let image = image.into();
        self.all.push(Arc::new(TextureImage { image }));
        self.all.len() - 1
    }

    /// The number of the one of that name, which is made when it is asked for first; none where it cannot be.
    pub fn named<P: Into<Arc<RgbaImage>>>(
        &mut self,
        name: &str,
        make: impl FnOnce() -> Option<P>,
    ) -> Option<usize> {
        if let Some(number) = self.known.get(name) {
            return Some(*number);
        }
        let number = self.add(make()?);
        self.known.insert(name.to_owned(), number);
        Some(number)
    }
}

/// The material of a surface.
pub fn of_surface(surface: &Surface, assets: &Assets, pictures: &mut Pictures) -> Material {
    let colour = linear(surface.colour);
    let picture = surface.texture.as_ref().and_then(|it| {
        let make = || assets.textures.get(&it.file).cloned();
        let number = pictures.named(&it.file, make)?;
        let repeats = (1.0 / it.size) as f32;
        Some(Pattern::Texture { number, repeats })
    });
    let checker = surface.checker.map(|it| Pattern::Checker {
        other: linear(it.colour),
        edge_m: it.size as f32,
    });
    Material {
        colour,
        pattern: picture.or(checker).unwrap_or_default(),
        glow: colour * (surface.glow as f32 * DAYLIGHT),
        mirror: if surface.finish == Finish::Mirror {
            MIRROR
        } else {
            0.0
        },
        glass: (surface.finish == Finish::Glass).then_some(GLASS),
        gloss: 0.0,
    }
}

/// The material of that number of the model in a file.
pub fn of_model(file: &str, number: usize, assets: &Assets, pictures: &mut Pictures) -> Material {
    let Some(model) = assets.models.get(file) else {
        return Material::default();
    };
    let Some(it) = model.materials.get(number) else {
        return Material::default();
    };
    let picture = it.texture.and_then(|index| {
        let make = || {
            let texture = model.textures.get(index)?;
            RgbaImage::from_raw(texture.width, texture.height, texture.rgba.clone())
        };
        pictures.named(&format!("{file}#{index}"), make)
    });
    Material {
        colour: it.colour.truncate(),
        pattern: picture.map_or(Pattern::Plain, |number| Pattern::Texture {
            number,
            repeats: 1.0,
        }),
        glow: it.emission * DAYLIGHT,
        gloss: 0.5 * (1.0 - it.roughness),
        ..Material::default()
    }
}
