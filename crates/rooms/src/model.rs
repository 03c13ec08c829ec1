//! Models of a room, glTF, fbx or obj, as they rest.

use std::sync::Arc;

use antipode_models::{GAME_FROM_FILE, Material, Model, Pose, Texture};
use glam::{DMat4, DVec2, DVec3, Mat4};

use crate::bounds::MOST_MODEL_TRIANGLES;
use crate::fbx;
use crate::gltf_parts::gather;
use crate::mesh::Shape;

/// A model as it stands in a room.
#[derive(Debug, Clone, PartialEq)]
pub struct RoomModel {
    /// Its materials, as they stand in its file.
    pub materials: Vec<Material>,
    /// The pictures of its materials.
    pub textures: Vec<Texture>,
    /// Its triangles.
    pub parts: Vec<ModelPart>,
}

/// Triangles of one material of a model.
#[derive(Debug, Clone, PartialEq)]
pub struct ModelPart {
    /// The triangles, in metres; the file's front is +x.
    pub shape: Arc<Shape>,
    /// Index into [`RoomModel::materials`].
    pub material: usize,
}

/// Makes a model of the bytes of the file `name`; `read` reads other files of its room.
///
/// # Errors
/// What is wrong with it, to follow its name.
pub(crate) fn load(
    name: &str,
    bytes: &[u8],
    read: &mut dyn FnMut(&str) -> Result<Vec<u8>, String>,
) -> Result<RoomModel, String> {
    let ends_in = |wanted: &str| {
        name.rsplit_once('.')
            .is_some_and(|(_, ending)| ending.eq_ignore_ascii_case(wanted))
    };
    if ends_in("fbx") || ends_in("obj") {
        return fbx::load(name, bytes, read);
    }
    let whole;
    let bytes = if ends_in("gltf") {
        whole = gather(name, bytes, read)?;
        &whole
    } else {
        bytes
    };
    let model = Model::from_glb(bytes).map_err(|error| {
        let said = error.to_string();
        format!("it cannot be used ({})", said.trim_end_matches('.'))
    })?;
    let triangles = model.triangles();
    if triangles > MOST_MODEL_TRIANGLES {
        return Err(format!(
            "it has {triangles} triangles, and a model of a room has at most {MOST_MODEL_TRIANGLES}"
        ));
    }
    Ok(RoomModel {
        parts: parts(&model),
        materials: model.materials,
        textures: model.textures,
    })
}

fn parts(model: &Model) -> Vec<ModelPart> {
    let nodes = Pose::rest(&model.skeleton).model_matrices(&model.skeleton);
    let mut out = Vec::new();
    for part in &model.parts {
        // With a skin the vertices are where they belong in its first pose, whatever node they hang from.
        let node = if part.skin.is_some() {
            Mat4::IDENTITY
        } else {
            nodes[part.node]
        };
        let place = DMat4::from_quat(GAME_FROM_FILE.as_dquat().normalize()) * node.as_dmat4();
        for primitive in &model.meshes[part.mesh].primitives {
            let shape = Arc::new(shape(primitive, place));
            out.push(ModelPart {
                shape,
                material: primitive.material,
            });
        }
    }
    out
}

fn shape(primitive: &antipode_models::Primitive, place: DMat4) -> Shape {
    // Normals go by the transpose of the inverse; where there is none, the shape is flat and has none to speak of.
    let turned = glam::DMat3::from_mat4(place);
    let is_flat = turned.determinant().abs() < 1e-30;
    let of_normals = if is_flat {
        turned
    } else {
        turned.inverse().transpose()
    };
    let is_mirrored = turned.determinant() < 0.0;
    let vertices = &primitive.vertices;
    let corners = primitive.indices.chunks_exact(3).map(|it| match it {
        [a, b, c] if is_mirrored => [*a, *c, *b],
        [a, b, c] => [*a, *b, *c],
        _ => [0; 3],
    });
    Shape {
        positions: vertices
            .iter()
            .map(|it| place.transform_point3(it.position.as_dvec3()))
            .collect(),
        normals: vertices
            .iter()
            .map(|it| {
                (of_normals * it.normal.as_dvec3())
                    .try_normalize()
                    .unwrap_or(DVec3::Y)
            })
            .collect(),
        uvs: vertices
            .iter()
            .map(|it| DVec2::new(f64::from(it.uv.x), f64::from(it.uv.y)))
            .collect(),
        triangles: corners.collect(),
    }
}
