//! Models in fbx and obj, as they rest, by `ufbx`: a reader in C that is fuzzed by its authors, bounds its memory as it is told, and
//! opens no file by itself.
//!
//! What a material has besides a colour, a picture and light of its own is left out. A picture lies in the file, or beside the
//! model under the last part of its name: where it lay on its maker's machine means nothing here.

use std::collections::HashMap;
use std::sync::Arc;

use antipode_models::{GAME_FROM_FILE, Material, Texture};
use glam::{DAffine3, DVec2, DVec3, Vec3, Vec4};
use ufbx::{AllocatorOpts, BlobOpt, CoordinateAxes, FileFormat, LoadOpts};

use crate::bounds::{MOST_MODEL_TRIANGLES, MOST_PIXELS};
use crate::mesh::Shape;
use crate::model::{ModelPart, RoomModel};
use crate::{files, folder};

/// What reading may take, bytes: a model of the most triangles takes a fifth of it.
const MOST_MEMORY_BYTES: usize = 256 << 20;
/// How many pictures a model may have; as many as one in glTF.
const MOST_TEXTURES: usize = 16;
/// The largest coordinate, metres.
const LARGEST_M: f64 = 1e6;
/// The brightest light of its own.
const MOST_GLOW: f64 = 1e6;

type Read<'a> = &'a mut dyn FnMut(&str) -> Result<Vec<u8>, String>;

/// Makes a model of the bytes of the file `name`; `read` reads other files of its room.
///
/// # Errors
/// What is wrong with it, to follow its name.
pub(crate) fn load(name: &str, bytes: &[u8], read: Read<'_>) -> Result<RoomModel, String> {
    let is_obj = name.to_ascii_lowercase().ends_with(".obj");
    let materials = if is_obj {
        library(name, bytes, read)
    } else {
        None
    };
    let scene = ufbx::load_memory(bytes, options(is_obj, materials.as_deref()))
        .map_err(|error| format!("it cannot be used ({})", &*error.description))?;
    let shown = || {
        let nodes = scene.nodes.as_ref().iter();
        nodes.filter_map(|it| Some((it, it.mesh.as_ref()?)).filter(|_| it.visible))
    };
    let triangles = shown().fold(0_usize, |sum, (_, it)| sum.saturating_add(it.num_triangles));
    if triangles == 0 {
        return Err("it has no triangles".to_owned());
    }
    if triangles > MOST_MODEL_TRIANGLES {
        return Err(format!(
            "it has {triangles} triangles, and a model of a room has at most {MOST_MODEL_TRIANGLES}"
        ));
    }
    let mut looks = Looks::new(name, read);
    let mut parts = Vec::new();
    for (node, mesh) in shown() {
        for part in mesh.material_parts.as_ref() {
            let own = node.materials.as_ref().get(part.index as usize);
            let material = looks.material(own.map(AsRef::as_ref))?;
            let shape = Arc::new(shape(node, mesh, part)?);
            if !shape.triangles.is_empty() {
                parts.push(ModelPart { shape, material });
            }
        }
    }
    Ok(RoomModel {
        materials: looks.materials,
        textures: looks.textures,
        parts,
    })
}

/// The materials of an obj, which lie beside it; it goes without them where they do not.
fn library(
    name: &str,
    bytes: &[u8],
    read: &mut dyn FnMut(&str) -> Result<Vec<u8>, String>,
) -> Option<Vec<u8>> {
    let lines = bytes.split(|it| *it == b'\n');
    let mut said = lines.filter_map(|it| it.trim_ascii().strip_prefix(b"mtllib "));
    let address = std::str::from_utf8(said.next_back()?.trim_ascii()).ok()?;
    read(&files::resolve(name, &address.replace('\\', "/")).ok()?).ok()
}

/// Lengths of an obj are metres, as nothing else is said there.
fn options(is_obj: bool, materials: Option<&[u8]>) -> LoadOpts<'_> {
    let memory = || AllocatorOpts {
        memory_limit: MOST_MEMORY_BYTES,
        ..AllocatorOpts::default()
    };
    LoadOpts {
        temp_allocator: memory(),
        result_allocator: memory(),
        ignore_animation: true,
        generate_missing_normals: true,
        target_axes: CoordinateAxes::right_handed_y_up(),
        target_unit_meters: 1.0,
        file_format: if is_obj {
            FileFormat::Obj
        } else {
            FileFormat::Fbx
        },
        obj_unit_meters: 1.0,
        obj_axes: CoordinateAxes::right_handed_y_up(),
        obj_mtl_data: materials.map_or(BlobOpt::Unset, BlobOpt::Ref),
        no_format_from_extension: true,
        ..LoadOpts::default()
    }
}

/// Where things at a node belong, in metres and in the game's axes.
fn place(node: &ufbx::Node) -> DAffine3 {
    let it = &node.geometry_to_world;
    let turn = DAffine3::from_quat(GAME_FROM_FILE.as_dquat().normalize());
    turn * DAffine3::from_cols_array(&[
        it.m00, it.m10, it.m20, it.m01, it.m11, it.m21, it.m02, it.m12, it.m22, it.m03, it.m13,
        it.m23,
    ])
}

fn three(it: ufbx::Vec3) -> DVec3 {
    DVec3::new(it.x, it.y, it.z)
}

/// The triangles of one material of a mesh.
fn shape(node: &ufbx::Node, mesh: &ufbx::Mesh, part: &ufbx::MeshPart) -> Result<Shape, String> {
    let place = place(node);
    let turned = place.matrix3;
    let is_mirrored = turned.determinant() < 0.0;
    // Normals go by the transpose of the inverse; where there is none, the shape is flat and has none to speak of.
    let of_normals = if turned.determinant().abs() < 1e-30 {
        turned
    } else {
        turned.inverse().transpose()
    };
    let mut out = Shape::default();
    let mut known = HashMap::new();
    let mut corners = vec![0; 3 * mesh.max_face_triangles];
    for face in part.face_indices.as_ref() {
        let Some(face) = mesh.faces.as_ref().get(*face as usize) else {
            continue;
        };
        if face.num_indices < 3 {
            continue;
        }
        let count = ufbx::triangulate_face(&mut corners, mesh, *face) as usize;
        for triangle in corners[..3 * count].chunks_exact(3) {
            let mut corner = |index: u32| {
                *known.entry(corner_of(mesh, index)).or_insert_with(|| {
                    let index = index as usize;
                    out.positions
                        .push(place.transform_point3(three(mesh.vertex_position[index])));
                    let normal = if mesh.vertex_normal.exists {
                        of_normals * three(mesh.vertex_normal[index])
                    } else {
                        DVec3::Y
                    };
                    out.normals.push(normal.try_normalize().unwrap_or(DVec3::Y));
                    out.uvs.push(uv(mesh, index));
                    out.positions.len() as u32 - 1
                })
            };
            let [a, b, c] = [triangle[0], triangle[1], triangle[2]].map(&mut corner);
            out.triangles
                .push(if is_mirrored { [a, c, b] } else { [a, b, c] });
        }
    }
    let is_fit = |it: &DVec3| it.is_finite() && it.abs().max_element() <= LARGEST_M;
    let uvs_fit = out.uvs.iter().all(|it| it.is_finite());
    if out.positions.iter().all(is_fit) && uvs_fit {
        Ok(out)
    } else {
        Err("it has a corner that is no place, or too far away".to_owned())
    }
}

/// What tells a corner from others: its place, normal and place on the picture.
fn corner_of(mesh: &ufbx::Mesh, index: u32) -> [u32; 3] {
    let of = |indices: &[u32]| indices.get(index as usize).copied().unwrap_or_default();
    [
        of(mesh.vertex_position.indices.as_ref()),
        of(mesh.vertex_normal.indices.as_ref()),
        of(mesh.vertex_uv.indices.as_ref()),
    ]
}

/// (0, 0) is at the lower left in fbx, and at the upper left here.
fn uv(mesh: &ufbx::Mesh, index: usize) -> DVec2 {
    if !mesh.vertex_uv.exists {
        return DVec2::ZERO;
    }
    let it = mesh.vertex_uv[index];
    DVec2::new(it.x, 1.0 - it.y)
}

/// The materials and pictures of a model that have been read.
struct Looks<'a> {
    name: &'a str,
    read: Read<'a>,
    materials: Vec<Material>,
    textures: Vec<Texture>,
    /// Numbers of materials by those of the file.
    known: HashMap<u32, usize>,
    /// Numbers of pictures by their names in the file.
    pictures: HashMap<String, usize>,
    pixels: u64,
}

impl<'a> Looks<'a> {
    fn new(name: &'a str, read: Read<'a>) -> Self {
        Self {
            name,
            read,
            // For what has none.
            materials: vec![Material::default()],
            textures: Vec::new(),
            known: HashMap::new(),
            pictures: HashMap::new(),
            pixels: MOST_PIXELS,
        }
    }

    fn material(&mut self, own: Option<&ufbx::Material>) -> Result<usize, String> {
        let Some(own) = own else { return Ok(0) };
        if let Some(number) = self.known.get(&own.element.typed_id) {
            return Ok(*number);
        }
        let pbr = &own.pbr;
        let light = |it: &ufbx::MaterialMap, factor: &ufbx::MaterialMap| {
            let times = if factor.has_value {
                factor.value_vec4.x
            } else {
                1.0
            };
            let it = it.value_vec4;
            let colour = DVec3::new(it.x, it.y, it.z) * times;
            if colour.is_finite() {
                colour.clamp(DVec3::ZERO, DVec3::splat(MOST_GLOW)).as_vec3()
            } else {
                Vec3::ZERO
            }
        };
        let picture = pbr.base_color.texture.as_ref();
        let picture = picture.filter(|_| pbr.base_color.texture_enabled);
        let texture = picture.map(|it| self.texture(it)).transpose()?;
        let colour = match texture {
            Some(_) => Vec3::ONE,
            None => light(&pbr.base_color, &pbr.base_factor).min(Vec3::ONE),
        };
        let roughness = pbr.roughness.value_vec4.x;
        self.materials.push(Material {
            name: own.element.name.to_string(),
            colour: Vec4::from((colour, 1.0)),
            texture,
            emission: light(&pbr.emission_color, &pbr.emission_factor),
            roughness: if (0.0..=1.0).contains(&roughness) {
                roughness as f32
            } else {
                1.0
            },
            ..Material::default()
        });
        let number = self.materials.len() - 1;
        self.known.insert(own.element.typed_id, number);
        Ok(number)
    }

    fn texture(&mut self, texture: &ufbx::Texture) -> Result<usize, String> {
        let said = texture.filename.to_string();
        if let Some(number) = self.pictures.get(&said) {
            return Ok(*number);
        }
        if self.textures.len() == MOST_TEXTURES {
            return Err(format!("it has more than {MOST_TEXTURES} pictures"));
        }
        let last = said.rsplit(['/', '\\']).next().unwrap_or_default();
        let shown = crate::check::shown(last);
        let beside;
        let bytes: &[u8] = if texture.content.is_empty() {
            let file = files::resolve(self.name, last)
                .map_err(|reason| format!("its picture {shown} {reason}"))?;
            beside = (self.read)(&file)?;
            &beside
        } else {
            &texture.content
        };
        let picture = folder::picture(bytes, self.pixels)
            .map_err(|reason| format!("its picture {shown}: {reason}"))?;
        self.pixels -= u64::from(picture.width()) * u64::from(picture.height());
        self.textures.push(Texture {
            width: picture.width(),
            height: picture.height(),
            rgba: picture.into_raw(),
        });
        let number = self.textures.len() - 1;
        self.pictures.insert(said, number);
        Ok(number)
    }
}
