//! Materials, and the pictures on them.

use std::io::Cursor;

use glam::{Vec3, Vec4};
use gltf::json;
use image::{ImageFormat, ImageReader, Limits};

use crate::accessor::{Source, valid};
use crate::error::Error;

/// No picture is wider or higher than this, pixels.
const LARGEST_PX: u32 = 4096;
/// No model has more pictures than this.
const MOST_TEXTURES: usize = 16;

/// How a surface looks.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Its name in the file.
    pub name: String,
    /// Linear light and cover, 0 to 1; multiplies the vertices' colours and the texture.
    pub colour: Vec4,
    /// Index into [`crate::Model::textures`].
    pub texture: Option<usize>,
    /// Light of its own, linear, 0 or more.
    pub emission: Vec3,
    /// 0 is a mirror, 1 is chalk.
    pub roughness: f32,
    /// 0 is paint, 1 is bare metal.
    pub metallic: f32,
    /// Whether what is behind shines through by the colour's cover.
    pub clear: bool,
    /// Whether it is seen from its inside as well.
    pub double_sided: bool,
}

impl Default for Material {
    fn default() -> Self {
        Self {
            name: "default".to_owned(),
            colour: Vec4::ONE,
            texture: None,
            emission: Vec3::ZERO,
            roughness: 1.0,
            metallic: 0.0,
            clear: false,
            double_sided: false,
        }
    }
}

/// A decoded picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Texture {
    /// Pixels across, 1 to 4096.
    pub width: u32,
    /// Pixels down, 1 to 4096.
    pub height: u32,
    /// sRGB and cover, four bytes a pixel, the upper row first.
    pub rgba: Vec<u8>,
}

impl Source<'_> {
    /// All materials and one more at the end for what has none, with the pictures they use.
    pub fn materials(self) -> Result<(Vec<Material>, Vec<Texture>), Error> {
        let mut textures = Textures {
            source: self,
            known: Vec::new(),
            decoded: Vec::new(),
        };
        let mut out = Vec::with_capacity(self.root.materials.len() + 1);
        for (i, material) in self.root.materials.iter().enumerate() {
            out.push(read(i, material, &mut textures)?);
        }
        out.push(Material::default());
        Ok((out, textures.decoded))
    }

    fn picture(self, index: json::Index<json::Image>) -> Result<Texture, Error> {
        let image = self
            .root
            .images
            .get(index.value())
            .ok_or(Error::OutOfRange("pictures"))?;
        let view = image.buffer_view.ok_or(Error::External("pictures"))?;
        let (bytes, _) = self.view(view, "pictures")?;
        let format = image::guess_format(bytes).map_err(|e| Error::Picture(e.to_string()))?;
        if !matches!(format, ImageFormat::Png | ImageFormat::Jpeg) {
            return Err(Error::Picture("only PNG and JPEG are supported".to_owned()));
        }
        let mut reader = ImageReader::with_format(Cursor::new(bytes), format);
        let mut limits = Limits::default();
        limits.max_image_width = Some(LARGEST_PX);
        limits.max_image_height = Some(LARGEST_PX);
        reader.limits(limits);
        let picture = reader
            .decode()
            .map_err(|e| Error::Picture(e.to_string()))?
            .to_rgba8();
        Ok(Texture {
            width: picture.width(),
            height: picture.height(),
            rgba: picture.into_raw(),
        })
    }
}

/// Pictures that have been decoded, each once.
struct Textures<'a> {
    source: Source<'a>,
    known: Vec<usize>,
    decoded: Vec<Texture>,
}

impl Textures<'_> {
    fn find(&mut self, info: &json::texture::Info) -> Result<usize, Error> {
        if info.tex_coord != 0 {
            return Err(Error::Format("texture coordinates"));
        }
        let texture = self
            .source
            .root
            .textures
            .get(info.index.value())
            .ok_or(Error::OutOfRange("pictures"))?;
        let image = texture.source.value();
        if let Some(at) = self.known.iter().position(|&known| known == image) {
            return Ok(at);
        }
        if self.known.len() == MOST_TEXTURES {
            return Err(Error::TooMany("pictures"));
        }
        self.decoded.push(self.source.picture(texture.source)?);
        self.known.push(image);
        Ok(self.known.len() - 1)
    }
}

fn read(i: usize, json: &json::Material, textures: &mut Textures<'_>) -> Result<Material, Error> {
    let pbr = &json.pbr_metallic_roughness;
    let strength = json
        .extensions
        .as_ref()
        .and_then(|e| e.emissive_strength.as_ref());
    let strength = strength.map_or(1.0, |s| s.emissive_strength.0);
    let emission = Vec3::from(json.emissive_factor.0) * strength;
    let colour = Vec4::from(pbr.base_color_factor.0);
    if !emission.is_finite() || emission.max_element() > 1.0e6 || !colour.is_finite() {
        return Err(Error::Absurd("materials"));
    }
    Ok(Material {
        name: json.name.clone().unwrap_or_else(|| format!("material {i}")),
        colour,
        texture: pbr
            .base_color_texture
            .as_ref()
            .map(|info| textures.find(info))
            .transpose()?,
        emission: emission.max(Vec3::ZERO),
        roughness: pbr.roughness_factor.0,
        metallic: pbr.metallic_factor.0,
        clear: valid(json.alpha_mode, "materials")? == json::material::AlphaMode::Blend,
        double_sided: json.double_sided,
    })
}
