//! Reads the bytes of a file into a [`Model`].

use gltf::json;

use crate::accessor::Source;
use crate::bounds::{Sphere, bounds};
use crate::clip::Clip;
use crate::container;
use crate::error::Error;
use crate::material::{Material, Texture};
use crate::mesh::Mesh;
use crate::skeleton::{Nodes, Skeleton, Skin};

/// Extensions that a file may require.
const KNOWN: [&str; 1] = ["KHR_materials_emissive_strength"];
/// No model is larger than this in any pose, metres.
const LARGEST_M: f32 = 1.0e5;

/// A whole model.
#[derive(Clone, Debug, PartialEq)]
pub struct Model {
    /// Nodes and how they rest.
    pub skeleton: Skeleton,
    /// What ties meshes to nodes.
    pub skins: Vec<Skin>,
    /// Triangles.
    pub meshes: Vec<Mesh>,
    /// Which mesh is shown where; at least one.
    pub parts: Vec<Part>,
    /// Surfaces; the last is for primitives without any.
    pub materials: Vec<Material>,
    /// Pictures on surfaces.
    pub textures: Vec<Texture>,
    /// Movements.
    pub clips: Vec<Clip>,
    /// What of the file was left out.
    pub notes: Vec<Note>,
    /// Holds the model in every pose that its clips and mixtures of them can bring about.
    pub bounds: Sphere,
}

/// A mesh at a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Part {
    /// Index into [`Skeleton::joints`]; with a skin it does not matter where it is.
    pub node: usize,
    /// Index into [`Model::meshes`].
    pub mesh: usize,
    /// Index into [`Model::skins`]; all joints of the mesh's vertices are within it.
    pub skin: Option<usize>,
}

/// Something in a file that is not shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Note {
    /// It has cameras.
    CamerasIgnored,
    /// It has lights.
    LightsIgnored,
    /// It has optional extensions that are not known here.
    ExtensionsIgnored,
}

impl Model {
    /// Reads a binary glTF file.
    ///
    /// # Errors
    /// Says in one sentence why the file cannot be read or shown faithfully; see [`Error`].
    pub fn from_glb(bytes: &[u8]) -> Result<Self, Error> {
        let (text, data) = container::split(bytes)?;
        let root = description(text)?;
        let source = Source { root: &root, data };
        let nodes = source.nodes()?;
        let (materials, textures) = source.materials()?;
        let meshes = source.meshes(root.materials.len())?;
        let skins = source.skins(&nodes)?;
        let parts = parts(&root, &nodes, &meshes, &skins)?;
        let clips = source.clips(&nodes)?;
        let bounds = Sphere {
            centre: glam::Vec3::ZERO,
            radius: 0.0,
        };
        let notes = notes(&root);
        let skeleton = nodes.skeleton;
        let mut model = Self {
            skeleton,
            skins,
            meshes,
            parts,
            materials,
            textures,
            clips,
            notes,
            bounds,
        };
        model.bounds = self::bounds(&model);
        let Sphere { centre, radius } = model.bounds;
        if !centre.is_finite() || !radius.is_finite() || centre.length() + radius > LARGEST_M {
            return Err(Error::Absurd("sizes"));
        }
        Ok(model)
    }

    /// The clip of that name.
    pub fn clip(&self, name: &str) -> Option<&Clip> {
        self.clips.iter().find(|clip| clip.name == name)
    }

    /// Number of triangles of all parts.
    pub fn triangles(&self) -> usize {
        let of = |part: &Part| {
            self.meshes[part.mesh]
                .primitives
                .iter()
                .map(|p| p.indices.len() / 3)
                .sum::<usize>()
        };
        self.parts.iter().map(of).sum()
    }
}

fn description(text: &[u8]) -> Result<json::Root, Error> {
    let damaged = |e: &dyn std::fmt::Display| Error::Description(e.to_string());
    let loose: json::Value = json::deserialize::from_slice(text).map_err(|e| damaged(&e))?;
    // Before the strict reading, which stumbles over what an unknown extension leaves out.
    let required = loose
        .get("extensionsRequired")
        .and_then(json::Value::as_array);
    for name in required
        .into_iter()
        .flatten()
        .filter_map(json::Value::as_str)
    {
        if !KNOWN.contains(&name) {
            return Err(Error::Extension(
                name.chars().filter(|c| !c.is_control()).take(60).collect(),
            ));
        }
    }
    let far = |list: &str| {
        let entries = loose.get(list).and_then(json::Value::as_array);
        entries
            .into_iter()
            .flatten()
            .any(|entry| entry.get("uri").is_some())
    };
    for (list, what) in [("buffers", "data"), ("images", "pictures")] {
        if far(list) {
            return Err(Error::External(what));
        }
    }
    let root: json::Root = json::deserialize::from_slice(text).map_err(|e| damaged(&e))?;
    // gltf-json 1.4.1 looks this one reference up unchecked while it validates, and would panic.
    let primitives = root.meshes.iter().flat_map(|mesh| &mesh.primitives);
    let mut attributes = primitives.flat_map(|primitive| primitive.attributes.values());
    if attributes.any(|accessor| accessor.value() >= root.accessors.len()) {
        return Err(Error::OutOfRange("vertex data"));
    }
    let document = gltf::Document::from_json(root).map_err(|e| match e {
        gltf::Error::Validation(list) => match list.first() {
            Some((path, error)) => damaged(&format!("{path}: {error}")),
            None => damaged(&"invalid"),
        },
        other => damaged(&other),
    })?;
    Ok(document.into_json())
}

fn parts(
    root: &json::Root,
    nodes: &Nodes,
    meshes: &[Mesh],
    skins: &[Skin],
) -> Result<Vec<Part>, Error> {
    let mut out = Vec::new();
    for (node, json) in root.nodes.iter().enumerate() {
        let (Some(mesh), Some(joint)) = (json.mesh, nodes.joint_of.get(node).copied().flatten())
        else {
            continue;
        };
        let mesh = mesh.value();
        let shape = meshes.get(mesh).ok_or(Error::OutOfRange("meshes"))?;
        let skin = json.skin.map(|s| s.value());
        if let Some(skin) = skin {
            let skin = skins.get(skin).ok_or(Error::OutOfRange("skins"))?;
            if shape.joints_needed() > skin.joints.len() {
                return Err(Error::OutOfRange("joints"));
            }
            if !shape.is_weighted() {
                return Err(Error::Format("weights"));
            }
        }
        out.push(Part {
            node: joint,
            mesh,
            skin,
        });
    }
    if out.is_empty() {
        Err(Error::Empty)
    } else {
        Ok(out)
    }
}

fn notes(root: &json::Root) -> Vec<Note> {
    let mut out = Vec::new();
    if !root.cameras.is_empty() {
        out.push(Note::CamerasIgnored);
    }
    let unknown = |name: &&String| !KNOWN.contains(&name.as_str());
    let unknown: Vec<_> = root.extensions_used.iter().filter(unknown).collect();
    if unknown.iter().any(|name| *name == "KHR_lights_punctual") {
        out.push(Note::LightsIgnored);
    }
    if unknown.iter().any(|name| *name != "KHR_lights_punctual") {
        out.push(Note::ExtensionsIgnored);
    }
    out
}
